"""Defaults for specifications in tests: descriptions and units, which an author must write for every value."""

from __future__ import annotations

from typing import Any

import yaml
from mipgen.read import nodes
from mipgen.read.problems import Problems

FLOATS = ("float", "double", "vector3f", "quatf")


def filled(text: str) -> str:
    """The same file with a description wherever one is missing, and with a unit for every float."""
    root = nodes._Reader(text, "filled.yaml", Problems()).document()
    assert root is not None
    tree = root.plain()
    for kind in tree.get("types", {}).values():
        kind.setdefault("description", "D.")
        for value in (*kind.get("values", {}).values(), *kind.get("bits", {}).values()):
            if isinstance(value, dict):
                value.setdefault("description", "D.")
        fill(kind.get("struct", ()))
    for part in tree.get("parts", {}).values():
        fill(part)
    for field in tree.get("fields", ()):
        for owner in (field, *field.get("responses", ())):
            if isinstance(owner.get("parameters"), list):
                fill(owner["parameters"])
    return yaml.safe_dump(tree, allow_unicode=True, sort_keys=False)


def fill(parameters: Any) -> None:
    for parameter in (p for p in parameters if "include" not in p):
        for value in (parameter, *(case for case in parameter.get("cases", {}).values() if case)):
            value.setdefault("description", "D.")
            if value.get("type") in FLOATS:
                value.setdefault("unit", "1")
