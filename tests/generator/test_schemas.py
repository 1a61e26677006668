"""The schemas, which editors use: each is valid and says what its keys are for, and each YAML file names its own.

Editors complete units, frames and types from lists in the schema, which follow the specification:
`PYTHONPATH=generator:tests:tests/generator python tests/generator/test_schemas.py accept` writes them.
"""

from __future__ import annotations

import functools
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from bad_spec_files import BASE
from mipgen.model import SCALARS
from mipgen.read import loader
from mipgen.read.loader import BESIDE, LAYOUT, PARTS, SEVERAL, WITNESSES
from support import model

ROOT = Path(__file__).parents[2]
SCHEMAS = ROOT / "spec/schema"
FILES = [
    (kind, path)
    for spec in (ROOT / "spec", ROOT / "tests/invented/spec", BASE)
    for kind, pattern in {**LAYOUT, **WITNESSES}.items()
    for path in sorted(spec.glob(pattern))
]

#: Rules that the loader turns into words of its own.
WORDED = {
    "type", "enum", "const", "pattern", "required", "additionalProperties", "propertyNames", "minimum", "maximum",
    "exclusiveMinimum", "minItems", "maxItems", "minLength", "minProperties", "maxProperties",
}  # fmt: skip
SILENT = {
    "$schema", "$id", "$ref", "title", "description", "examples", "definitions", "properties", "items", "allOf", "if",
    "then", "else",
}  # fmt: skip


def schemas() -> list[Path]:
    return sorted(SCHEMAS.glob("*.json"))


@pytest.mark.parametrize("path", schemas(), ids=lambda p: p.name)
def test_draft_07(path: Path) -> None:
    schema = json.loads(path.read_text("utf-8"))
    assert schema["$schema"] == "http://json-schema.org/draft-07/schema#"
    assert schema["$id"] == f"https://mipgen.invalid/format/{loader.FORMAT}/{path.name}"
    jsonschema_rs.meta.validate(schema)


@pytest.mark.parametrize("path", schemas(), ids=lambda p: p.name)
def test_references_lead_somewhere(path: Path) -> None:
    for reference in re.findall(r'"\$ref": "([^"]*)"', path.read_text("utf-8")):
        file, _, pointer = reference.partition("#")
        node = json.loads((SCHEMAS / (file or path.name)).read_text("utf-8"))
        for step in pointer.split("/")[1:]:
            node = node[step]


def rules(schema: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every rule of a schema with the schema that contains it."""
    if not isinstance(schema, dict):
        return
    for key, value in schema.items():
        yield key, schema
        below = (
            value.values() if key in ("properties", "definitions") else value if isinstance(value, list) else [value]
        )
        for inner in below:
            yield from rules(inner)


def described(rule: dict[str, Any], path: Path) -> str:
    """A rule's description, or that of the rule to which it refers."""
    while "description" not in rule:
        name, _, pointer = rule["$ref"].partition("#/")
        path = path.parent / (name or path.name)
        rule = functools.reduce(dict.__getitem__, pointer.split("/"), json.loads(path.read_text("utf-8")))
    return str(rule["description"])


@pytest.mark.parametrize("path", schemas(), ids=lambda p: p.name)
def test_every_rule_has_words(path: Path) -> None:
    """Mappings with known keys permit no others, and state what each is for, or refer to a key that does. A pattern is
    a definition, whose description states the form; that of a property states its purpose."""
    whole = json.loads(path.read_text("utf-8"))
    for key, schema in rules(whole):
        assert key in WORDED | SILENT
        if key == "properties":
            assert schema.get("additionalProperties") is False, list(schema["properties"])
            for name, below in schema["properties"].items():
                assert re.fullmatch(r"\S.*\.", described(below, path), re.S), f"{path.name}: {name}"
        if key == "pattern":
            assert schema in whole.get("definitions", {}).values() and schema["description"][-1] != "."


def lists() -> dict[str, list[str]]:
    """The words that an editor can complete, by definition of common.schema.json, from the main specification."""
    found = model("real")
    units = [u.symbol for u in found.protocol.units]
    types = [t.name for t in sorted(found.types, key=lambda t: (t.kind != "vector", t.name))]
    frames = [f.symbol for f in found.protocol.frames]
    return {"symbol": units, "unit": units, "frame": frames, "type_name": [*SCALARS, *types]}


def test_editors_complete_what_there_is() -> None:
    common = json.loads((SCHEMAS / "common.schema.json").read_text("utf-8"))
    listed = {name: common["definitions"][name]["examples"] for name in lists()}
    assert listed == lists(), __doc__


@pytest.mark.parametrize(("kind", "path"), FILES, ids=lambda x: x.name if isinstance(x, Path) else x)
def test_a_file_names_its_schema(kind: str, path: Path) -> None:
    first = path.read_text("utf-8").split("\n", 1)[0]
    found = re.fullmatch(r"# yaml-language-server: \$schema=(\S+)", first)
    assert found, f"{path}: the first line must name the schema"
    text = path.read_text("utf-8")
    of = SEVERAL[kind] if kind in SEVERAL and any(f"\n{many}:\n" in text for many in PARTS.values()) else kind
    if kind == "witness" and "\nlayouts:\n" not in text:
        of = next(other for key, other in BESIDE.items() if f"\n{key}:\n" in text)
    assert (path.parent / found[1]).resolve() == SCHEMAS / f"{of}.schema.json"


def test_every_kind_has_files() -> None:
    assert {kind for kind, _ in FILES} == {*LAYOUT, *WITNESSES}


def accept() -> None:
    path = SCHEMAS / "common.schema.json"
    common = json.loads(path.read_text("utf-8"))
    for name, words in lists().items():
        common["definitions"][name]["examples"] = words
    path.write_text(json.dumps(common, indent=2, ensure_ascii=False) + "\n", "utf-8")


if __name__ == "__main__" and sys.argv[1:] == ["accept"]:
    accept()
