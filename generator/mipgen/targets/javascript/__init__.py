"""JavaScript: a codec that interprets the model, and tools for the browser."""

from __future__ import annotations

import posixpath
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
    yield from scripts(model)
    yield File("package.json", "package.json.j2")
    taste = model.taste("taste.mjs")
    if taste:
        yield File("taste.mjs", "verbatim.j2", {"text": taste})
    yield File("README.md", "README.md.j2", {"taste": taste.rstrip()})


def scripts(model: m.Model, folder: str = "", target: str | None = None) -> Iterator[File]:
    """What pages with tools need: the model, and the modules as one script. Another target names this one."""
    yield File(f"{folder}model.js", "model.js.j2", {"text": document.text(model)}, target)
    yield File(f"{folder}mip.js", "mip.js.j2", language("javascript"), target)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {"classic": classic}


_IMPORT = re.compile(r"^(import|export) \{([^}]*)\} from \"([^\"]*)\";\n", re.M)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:const|class|function\*?) (\w+))", re.M)


def classic(text: str, name: str) -> str:
    """A module as a function with names of its own, which puts what it exports into `modules`.

    >>> print(classic('import { a } from "./a.mjs";\\n\\nexport const b = a + 1;\\n', "mip/b"))
    modules["mip/b"] = (() => {
    const { a } = modules["mip/a"];
    <BLANKLINE>
    const b = a + 1;
    <BLANKLINE>
    return { b };
    })();
    """
    exported = [match[1] for match in _EXPORT.finditer(text)]

    def held(match: re.Match[str]) -> str:
        names = " ".join(match[2].split()).rstrip(",")
        if match[1] == "export":
            exported.extend(names.split(", "))
        other = posixpath.normpath(posixpath.join(posixpath.dirname(name), match[3])).removesuffix(".mjs")
        return f'const {{ {names} }} = modules["{other}"];\n'

    inner = _EXPORT.sub("", _IMPORT.sub(held, text))
    return f'modules["{name}"] = (() => {{\n{inner}\nreturn {{ {", ".join(exported)} }};\n}})();'
