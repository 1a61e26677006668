"""Documentation, which is read from this package's source on first use.

Texts exist once, in docstrings, where editors show them. Python itself keeps only the docstrings of
classes, and none with `-OO`. A package without its source has no texts.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec

_WIRE = re.compile(r"^    # On the wire only: (\w+)\. ?(.*(?:\n    # (?!On the wire).*)*)", re.M)


def text(kind: type, member: str = "") -> str:
    """Returns the text about a class or one of its members: its docstring on one line, without a
    field's title and without sources."""
    if member:
        blocks = next((b for base in kind.__mro__ if (b := _blocks(base, member))), [])
    else:
        blocks = _blocks(kind)[hasattr(kind, "DESCRIPTOR") :]
        blocks = [b for b in blocks if not b.startswith("- ")]
    return " ".join(re.sub(r"^- ", "", line) for block in blocks for line in block.split("\n"))


def sources(kind: type) -> tuple[str, ...]:
    """Returns the manuals and sections that describe a class."""
    blocks = _blocks(kind)
    return tuple(line[2:] for block in blocks for line in block.split("\n") if line[:2] == "- ")


def of_set(module: str, name: str) -> str:
    """Returns a module docstring's text about a descriptor set: its list item if the module has
    several sets, otherwise the paragraphs."""
    blocks = _documented(module).get("", [])[1:]
    for line in (line for block in blocks for line in block.split("\n")):
        if line.startswith(f"- {name} (0x"):
            return line.partition("): ")[2]
    return " ".join(b for b in blocks if not b.startswith("- "))


def _blocks(kind: type, member: str = "") -> list[str]:
    """Returns the paragraphs of a docstring."""
    known = _documented(kind.__module__)
    return known.get(f"{kind.__name__}.{member}" if member else kind.__name__, [])


@cache
def _documented(module: str) -> dict[str, list[str]]:
    """Returns the docstrings of a module (key ""), its classes and their members ("Ping.port")."""
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
    """Splits a docstring into paragraphs, each on one line; each list item is on its own line."""
    items = (re.split(r"\n\s*(?=- )", block.strip()) for block in re.split(r"\n\s*\n", doc))
    return ["\n".join(" ".join(item.split()) for item in block) for block in items if block != [""]]
