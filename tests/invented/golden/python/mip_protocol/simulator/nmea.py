from __future__ import annotations

from typing import Any


def known(e: Any) -> bool:
    return True


def sentences(es: Any, world: Any) -> bytes:
    return b"$x\r\n"
