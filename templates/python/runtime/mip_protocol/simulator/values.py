from __future__ import annotations
from typing import Any
def encoder(kind: Any, profile: Any, world: Any, set: int) -> Any:
    from .settings import _filled
    from .. import reflection
    g: dict[str, Any]={}
    for p in reflection.PARAMETERS[kind]:
        if p.kind not in ("constant","counter"): g[p.attribute]=_filled(p,g,p.default)
    b=kind(**g).encode()
    return lambda: [b]
