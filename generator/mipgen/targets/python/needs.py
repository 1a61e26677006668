"""Omits the parts of a package that need a fact which its specification lacks.

`needs` in language.yaml lists the modules that need a fact. If it is missing, they are omitted, with the statements
that import from them and each statement of the runtime below a comment such as `# needs: session`.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Container, Iterator, Mapping

from mipgen import model as m
from mipgen.lower.session import session

from .names import NEEDS

#: Fact -> predicate: True if the specification contains it.
FACTS: dict[str, Callable[[m.Model], bool]] = {
    "baud rates": lambda model: _names_rates(model) or _changes_rate(model),
    "session": lambda model: session(model) is not None,
    "shared fields": lambda model: any(x.kind == "shared" for x in model.families),
}

_NEEDED = re.compile(r"^ *# needs: (.+)$", re.MULTILINE)


def _names_rates(model: m.Model) -> bool:
    return any(port.baud_rates for device in model.devices for port in device.ports)


def _changes_rate(model: m.Model) -> bool:
    """True if a command has the parameter that `Device.change_baud` reads."""
    return any(p.name == "baud" for f in model.fields if f.role == m.COMMAND for p in f.parameters)


def omitted(model: m.Model) -> frozenset[str]:
    """Returns the modules that the package of a specification omits."""
    facts = _present(model)
    return frozenset(module for module, fact in NEEDS.items() if fact not in facts)


def runtime(files: Mapping[str, bytes], model: m.Model) -> dict[str, bytes]:
    """Returns the runtime's files without what needs facts that the specification lacks."""
    modules, facts = omitted(model), _present(model)
    if not modules:
        return dict(files)
    return {
        path: _reduced(data, modules, facts) if path.endswith(".py") else data
        for path, data in files.items()
        if path.rpartition("/")[2].removesuffix(".py") not in modules
    }


def _present(model: m.Model) -> frozenset[str]:
    return frozenset(fact for fact, has in FACTS.items() if has(model))


def _reduced(source: bytes, modules: Container[str], facts: Container[str]) -> bytes:
    lines = source.decode("utf-8").splitlines(keepends=True)
    for first, behind in reversed(list(_useless(ast.parse(source).body, lines, modules, facts))):
        del lines[first:behind]
    return "".join(lines).encode("utf-8")


def _useless(
    body: list[ast.stmt], lines: list[str], modules: Container[str], facts: Container[str]
) -> Iterator[tuple[int, int]]:
    """Yields the line ranges of omitted statements, in order, including the comments above them."""
    for node in body:
        first = min([node.lineno, *(d.lineno for d in getattr(node, "decorator_list", ()))]) - 1
        while first and lines[first - 1].lstrip().startswith("#"):
            first -= 1
        needed = _NEEDED.search("".join(lines[first : node.lineno]))
        imports = isinstance(node, ast.ImportFrom) and node.level > 0 and node.module in modules
        if imports or (needed and not any(fact in facts for fact in needed[1].split(" or "))):
            yield first, node.end_lineno or 0
        else:
            for inner in (getattr(node, name, []) for name in ("body", "orelse", "finalbody")):
                yield from _useless(inner, lines, modules, facts)
