"""JavaScript: a codec that interprets the model, and tools for the browser."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from ... import model as m
from ...render import File, language
from ..json import document
from ..json import identifiers as identifiers  # fields and types are found by the names that they have in JSON

TITLE = "JavaScript modules without dependencies, tools for the browser"
CONFORMANCE = ("parse", "decode", "encode")
PROGRAM = "node"


def files(model: m.Model) -> Iterator[File]:
    yield File("model.js", "model.js.j2", {"text": document.text(model)})
    yield File("mip.js", "mip.js.j2", language("javascript"))
    yield File("package.json", "package.json.j2")
    taste = model.taste("taste.mjs")
    if taste:
        yield File("taste.mjs", "verbatim.j2", {"text": taste})
    yield File("README.md", "README.md.j2", {"taste": taste.rstrip()})


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {"classic": classic, "exported": exported}


def classic(module: str) -> str:
    """The text of a module as a part of one script: what it imports is there already, and what it exports stays.

    >>> classic('import { a } from "./a.mjs";\\n\\nexport const b = a + 1;\\n')
    'const b = a + 1;\\n'
    """
    without = re.sub(r"^import [^;]*;\n+", "", module, flags=re.M)
    return re.sub(r"^export (?=(?:const|function|class|async) )", "", without, flags=re.M)


def exported(index: str) -> str:
    """What a module exports from others.

    >>> exported('export { a, B } from "./a.mjs";\\n')
    ' a, B,'
    """
    names = (
        name.strip()
        for inner in re.findall(r"^export \{([^}]*)\} from", index, flags=re.M)
        for name in inner.split(",")
    )
    return "".join(f" {name}," for name in names if name)
