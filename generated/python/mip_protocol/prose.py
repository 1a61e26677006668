"""Documentation, read from the source of this package when it is first needed.

Texts exist once, in docstrings, where editors show them. Python keeps only those of classes, and
with `-OO` none. A package without its sources has no texts.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec

_WIRE = re.compile(r"^    # On the wire only: (\w+)\. ?(.*(?:\n    # (?!On the wire).*)*)", re.M)


def text(kind: type, member: str = "") -> str:
    """The text about a member of a class, or of the class itself: its docstring on one line, without
    the title of a field and without sources."""
    if member:
        blocks = next((b for base in kind.__mro__ if (b := _blocks(base, member))), [])
    else:
        blocks = _blocks(kind)[hasattr(kind, "DESCRIPTOR") :]
        blocks = [b for b in blocks if not b.startswith("- ")]
    return " ".join(re.sub(r"^- ", "", line) for block in blocks for line in block.split("\n"))


def sources(kind: type) -> tuple[str, ...]:
    """Manuals and sections that describe a class."""
    blocks = _blocks(kind)
    return tuple(line[2:] for block in blocks for line in block.split("\n") if line[:2] == "- ")


def of_set(module: str, name: str) -> str:
    """The text of a module's docstring about a descriptor set: about one of several in an item of a list, else in its
    paragraphs."""
    blocks = _documented(module).get("", [])[1:]
    for line in (line for block in blocks for line in block.split("\n")):
        if line.startswith(f"- {name} (0x"):
            return line.partition("): ")[2]
    return " ".join(b for b in blocks if not b.startswith("- "))


def _blocks(kind: type, member: str = "") -> list[str]:
    """The paragraphs of a docstring."""
    known = _documented(kind.__module__)
    return known.get(f"{kind.__name__}.{member}" if member else kind.__name__, [])


@cache
def _documented(module: str) -> dict[str, list[str]]:
    """The docstrings of a module, which is "", of its classes and of what these hold: "Ping.port"."""
    spec = find_spec(module)
    source = getattr(spec and spec.loader, "get_source", lambda _: None)(module)
    return {name: _lines(doc) for name, doc in _docstrings(source)} if source else {}


def _docstrings(source: str) -> Iterator[tuple[str, str]]:
    tree = ast.parse(source)
    yield "", ast.get_docstring(tree) or ""
    lines = source.splitlines()
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield node.name, ast.get_docstring(node) or ""
            for held, behind in zip(node.body, node.body[1:]):
                target = getattr(held, "target", None) or getattr(held, "targets", [None])[0]
                if isinstance(target, ast.Name) and isinstance(behind, ast.Expr):
                    yield f"{node.name}.{target.id}", str(getattr(behind.value, "value", ""))
            for name, said in _WIRE.findall("\n".join(lines[node.lineno : node.end_lineno])):
                yield f"{node.name}.{name}", said.replace("\n    # ", " ")


def _lines(doc: str) -> list[str]:
    """The paragraphs of a docstring, each on one line, and each item of a list on a line."""
    items = (re.split(r"\n\s*(?=- )", block.strip()) for block in re.split(r"\n\s*\n", doc))
    return ["\n".join(" ".join(item.split()) for item in block) for block in items if block != [""]]
