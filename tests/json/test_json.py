"""mip.json: it has the form of its schema, nothing of the model is missing, and every name leads somewhere."""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import jsonschema_rs
import pytest
from mipgen import model as m
from mipgen.model import guides, simulation
from mipgen.targets.json import document
from support import ROOT, SPECS, model, some

specs = pytest.mark.parametrize("spec", sorted(SPECS))

#: The definition of the schema that describes the objects of a class.
DEFINITIONS: dict[type, str] = {
    m.Function: "function", m.Word: "word", m.Manual: "manual", m.Chapter: "chapter", m.Usage: "usage", m.Enum: "enum",
    m.Bitfield: "bitfield", m.Vector: "vector", m.Struct: "struct", m.Parameter: "parameter", m.Variant: "variant",
    m.Condition: "condition", m.Field: "field", m.Set: "set", m.Device: "device", m.Example: "example",
    m.Erratum: "erratum", simulation.Simulation: "simulation", m.Source: "source",
    guides.Guide: "guide", guides.Sequence: "guide_sequence", guides.Step: "guide_step", guides.Stream: "guide_data",
    guides.Shown: "guide_field", guides.Migration: "guide_migration", guides.Change: "guide_change",
}  # fmt: skip

#: Keys that are no attributes of the model, or have another form there.
ADDED = {
    "parameter": {"readings", "type", "cases"}, "enum": {"symbols"},
    "field": {"set", "occurrences", "symbols", "calls", "typical", "constants", "operations"},
    "bitfield": {"symbols"}, "struct": {"symbols", "operations"}, "variant": {"only"},
    "set": {"types", "fields", "named"}, "device": {"evidence", "supports", "refuses"},
}  # fmt: skip


@cache
def schema() -> Any:
    return json.loads((ROOT / "generated/json/mip.schema.json").read_text("utf-8"))


@cache
def whole(spec: str) -> Any:
    return json.loads((SPECS[spec][1] / "json/mip.json").read_text("utf-8"))


# --------------------------------------------------------------------------- form


@specs
def test_it_has_the_form_of_its_schema(spec: str) -> None:
    jsonschema_rs.meta.validate(schema())
    checked = jsonschema_rs.Draft7Validator(schema()).iter_errors(whole(spec))
    wrong = [f"{error.instance_path}: {error.message[:200]}" for error in checked]
    assert not wrong, wrong[:5]


def test_the_schema_has_what_the_model_has_and_no_more() -> None:
    for kind, name in DEFINITIONS.items():
        properties = set(schema()["definitions"][name]["properties"])
        names = {f.name for f in dataclasses.fields(kind)} - {"position", *document.LEFT_OUT.get(kind, ())}
        attributes = {document.RENAMED.get(name, name) for name in names}
        assert properties == attributes | ADDED.get(name, set()), name


def test_the_schema_states_the_format() -> None:
    assert schema()["properties"]["format"]["const"] == document.FORMAT == whole("real")["format"]
    assert f"now `{document.FORMAT}`" in (ROOT / "generated/json/README.md").read_text("utf-8")


def test_everything_that_the_schema_has_is_described() -> None:
    """Every operation has a title and a row in the README."""
    readme = (ROOT / "generated/json/README.md").read_text("utf-8")
    for kind in schema()["definitions"]["operation"]["oneOf"]:
        name = kind["properties"]["kind"]["const"]
        assert kind["title"].startswith(f"{name}: ") and f"\n| `{name}` | " in readme
    for key in schema()["required"]:
        assert f"`{key}`" in readme or key in ("$schema", "name", "version"), key


def test_the_readme_says_what_a_case_without_an_operation_is() -> None:
    readme = (ROOT / "generated/json/README.md").read_text("utf-8")
    (row,) = re.findall(r"^\| `switch` \|.*$", readme, re.M)
    operations = [op for f in whole("real")["fields"] for o in f["operations"] for op in o.get("body", [o])]
    assert any("operation" not in case for op in operations for case in op.get("cases", ()))
    assert "no data and no member if that case has no `operation`" in row


@specs
def test_the_readme_shows_a_command_with_a_selector_and_an_enumeration(spec: str) -> None:
    readme = (SPECS[spec][1] / "json/README.md").read_text("utf-8")
    shown = json.loads(readme.partition("## A field\n\n```json\n")[2].partition("\n```")[0])
    f = some(model(spec).field(shown["name"]))
    assert f.functions and any(isinstance(p.element, m.Enum) for p in f.counted)


# --------------------------------------------------------------------------- references


@specs
def test_everything_is_there(spec: str) -> None:
    of, d = model(spec), whole(spec)
    assert [f["name"] for f in d["fields"]] == [f.full_name for f in (of.protocol.acknowledge, *of.fields)]
    assert len(d["types"]) == len({t["name"] for t in d["types"]}) >= len(of.all_types)
    assert [s["name"] for s in d["sets"]] == [s.name for s in of.sets]
    assert [x["id"] for x in d["devices"]] == [x.id for x in of.devices]
    assert [x["id"] for x in d["examples"]] == [x.id for x in of.examples]
    assert [x["id"] for x in d["errata"]] == [x.id for x in of.errata]
    assert [x["name"] for x in d["guides"]] == [x.name for x in of.guides]


def objects(value: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    if isinstance(value, dict):
        yield path, value
        for key, inner in value.items():
            yield from objects(inner, (*path, key))
    elif isinstance(value, list):
        for inner in value:
            yield from objects(inner, path)


@specs
def test_every_name_leads_somewhere(spec: str) -> None:
    d = whole(spec)
    places = {o["name"] for f in d["fields"] for o in f.get("occurrences", ())}
    fields, types = {f["name"] for f in d["fields"]} | places, {t["name"] for t in d["types"]}
    scalars, functions = set(d["scalars"]), {f["name"] for f in d["functions"]}
    known = {
        "type": types | scalars, "scalar": scalars, "struct": types, "tag_type": types, "enum": types, "vector": types,
        "field": fields, "acknowledge": fields, "ack_code": types, "function_selector": types,
        "manual": {x["id"] for x in d["manuals"]}, "device": {x["id"] for x in d["devices"]},
        "like": {x["id"] for x in d["devices"]}, "set": {s["name"] for s in d["sets"]}, "function": functions,
        "frame": {x["symbol"] for x in d["frames"]},
    }  # fmt: skip
    lists = {
        "responses": fields,
        "required_for": functions,
        "units": {x["symbol"] for x in d["units"]} | {"1"},
    }
    seen: set[str] = set()
    for path, thing in objects(d):
        if {"values", "stated", "functions", "oneOf", "typical"} & set(path):
            continue
        for key, value in thing.items():
            if isinstance(value, str) and key in known and not (key == "set" and "fields" in path):
                assert value in known[key], (path, key, value)
                seen.add(key)
            if isinstance(value, list) and key in lists and path:
                assert set(value) <= lists[key], (path, key, value)
                seen.add(key)
    for s in d["sets"]:
        assert set(s["fields"]) <= fields and set(s["types"]) <= types
    assert seen >= (set(known) | set(lists)) - {"like"} or spec == "invented"


# --------------------------------------------------------------------------- symbols


@specs
def test_symbols_are_names_in_the_bindings(spec: str) -> None:
    """A search for a name in source code finds the field."""
    folders = {"c": "c/src", "cpp": "c/src", "python": "python", "rust": "rust/src", "javascript": "javascript"}
    words = {}
    for folder in {*folders.values()}:
        files = (p for p in (SPECS[spec][1] / folder).rglob("*.*") if p.is_file())
        words[folder] = set(re.findall(r"\w+", "".join(p.read_text("utf-8", "ignore") for p in files)))
    wanted = [
        (language, s)
        for x in (*whole(spec)["fields"], *whole(spec)["types"])
        for language, s in x.get("symbols", {}).items()
    ]
    assert len(wanted) > 100
    assert not [(language, s) for language, s in wanted if re.findall(r"\w+", s)[-1] not in words[folders[language]]]
