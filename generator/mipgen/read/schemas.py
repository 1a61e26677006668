"""Checks files against their JSON Schemas, and states mistakes and their remedies in words."""

from __future__ import annotations

import functools
import json
import re
from typing import Any

from jsonschema_rs import Draft7, Draft7Validator, Registry, ValidationError
from jsonschema_rs import ValidationErrorKind as Kind

from mipgen.base import resources

from .nodes import Node
from .problems import Problems, close, nearest
from .spelling import strange

#: Words that other YAML parsers read as true and false.
_BOOLEANS = {**dict.fromkeys(("true", "yes", "on", "y"), "true"), **dict.fromkeys(("false", "no", "off", "n"), "false")}

_IN_WORDS = {
    "object": "a mapping",
    "array": "a list",
    "string": "text",
    "integer": "a whole number",
    "number": "a number",
    "boolean": "true or false",
    "null": "empty",
}


def check_schema(kind: str, root: Node, problems: Problems) -> bool:
    """Adds the mistakes of a file to `problems`; True if there are none."""
    errors = list(_validator(kind).iter_errors(root.plain()))
    for error in errors:
        _report(error, root, problems)
    return not errors


# --------------------------------------------------------------------------- schemas


@functools.cache
def _schemas() -> dict[str, Any]:
    """Reads the schemas, by their identifiers."""
    files = resources.files_in(resources.root() / "spec/schema")
    schemas = (json.loads(file.read_text("utf-8"), object_hook=_marked) for _, file in files)
    return {schema["$id"]: schema for schema in schemas}


def _marked(schema: dict[str, Any]) -> dict[str, Any]:
    return {**schema, "whole": True} if "integer" in schema.get("type", ()) else schema


class _Whole:
    """Rejects 1.0 as an integer, which JSON Schema permits: it is meant as a float."""

    def __init__(self, *_: object) -> None:
        pass

    def validate(self, value: Any) -> None:
        if isinstance(value, float) and value.is_integer():
            raise ValueError


@functools.cache
def _validator(kind: str) -> Draft7Validator:
    registry = Registry(_schemas().items(), draft=Draft7)
    schema = next(schema for name, schema in _schemas().items() if name.endswith(f"/{kind}.schema.json"))
    return Draft7Validator(schema, registry=registry, keywords={"whole": _Whole})


def _schema_of(error: ValidationError) -> Any:
    """Returns the schema with the rule that is broken."""
    schema, _, pointer = str(error.absolute_keyword_location).partition("#/")
    steps = pointer.split("/")[:-1]
    return functools.reduce(
        lambda part, step: part[int(step) if isinstance(part, list) else step], steps, _schemas()[schema]
    )


# --------------------------------------------------------------------------- mistakes in words


def _path(error: ValidationError, root: Node) -> list[str | int]:
    """Returns the path of a value. The library's has a number for a key of digits, too."""
    path: list[str | int] = []
    for step in error.instance_path:
        path.append(str(step) if isinstance(root.value, dict) else step)
        root = root.value[path[-1]]
    return path


def _report(error: ValidationError, root: Node, problems: Problems) -> None:
    path, schema = _path(error, root), _schema_of(error)
    value: Any = error.instance
    match error.kind:
        case Kind.AdditionalProperties(keys):
            for key in keys:
                problems.add(root.at([*path, key]), f"unknown key '{key}'{_known(value[key], key, schema)}")
        case Kind.PropertyNames(of_name):
            name, form = str(of_name.instance), _form(_schema_of(of_name))
            problems.add(root.at([*path, name]), f"the name '{name}' must be {form}{strange(name)}")
        case Kind.Required(key):
            short = key == "description" and "integer" in schema.get("type", ())
            remedy = "; write only the number if the name needs no description" if short else ""
            problems.add(root.value_at(path), f"'{key}' is missing in {_inside(path)}{remedy}")
        case _:
            problems.add(root.value_at(path), f"{_inside(path)} must {_wanted(error, schema)}")


def _known(value: Any, key: str, schema: dict[str, Any]) -> str:
    """Returns the remedy for an unknown key."""
    if value is None:
        return "; if it ends the text before it, put the whole text in quotes"
    return nearest(key, schema.get("properties", ()))


def _inside(path: list[str | int]) -> str:
    """Names a key, or an item of a list."""
    key = next((f"'{p}'" for p in reversed(path) if isinstance(p, str)), "the file")
    return f"item {path[-1] + 1} of {key}" if path and isinstance(path[-1], int) else key


def _wanted(error: ValidationError, schema: dict[str, Any]) -> str:
    """Returns what a value must be, what it is, and the remedy."""
    value = error.instance
    found, form = f", not {_shown(value)}", _form(schema)
    match error.kind:
        case Kind.Type() | Kind.Custom():
            kinds = [kind] if isinstance(kind := schema["type"], str) else kind
            return f"be {form or ' or '.join(_IN_WORDS[kind] for kind in kinds)}{found}{_instead(value, kinds)}"
        case Kind.Enum(options):
            choices = [str(x) for x in options]
            return f"be {' or '.join(choices)}{found}{close(str(value), choices)}"
        case Kind.Constant(only):
            return f"be {_shown(only)}, or be omitted{found}"
        case Kind.Pattern(pattern):
            return f"be {form or pattern}{found}{strange(str(value))}"
        case Kind.Minimum(limit):
            return f"be at least {limit}{found}"
        case Kind.ExclusiveMinimum(limit):
            return f"be more than {limit}{found}"
        case Kind.Maximum(limit):
            return f"be at most {limit}{found}"
        case Kind.MinItems(1) | Kind.MinLength(1) | Kind.MinProperties(1):
            return "not be empty"
        case Kind.MinItems(limit):
            return f"have at least {limit} items"
        case Kind.MaxItems(limit) | Kind.MaxProperties(limit):
            return f"have at most {limit} item{'s' if limit != 1 else ''}"
    raise TypeError(error.kind)


def _form(schema: dict[str, Any]) -> str | None:
    """Returns the form of a value: the description of its definition. A description that ends with a full stop belongs
    to a property, and states its purpose instead."""
    words = str(schema.get("description", "."))
    return None if words.endswith(".") else words


def _instead(value: Any, kinds: list[str]) -> str:
    """Returns the remedy for a value of the wrong kind, if it is obvious.

    >>> _instead("yes", ["boolean"]), _instead(7, ["string"]), _instead("8C", ["integer"]), _instead("−3", ["integer"])
    ('; write true', '; put it in quotes', '; write 0x8C', "; '−' is a minus sign (U+2212), write '-'")
    >>> _instead({}, ["array"]), _instead([], ["object"]), _instead("fast", ["integer"])
    ("; begin each item with '- '", "; write 'key: value', without '- '", '')
    """
    match value:
        case bool() | int() | float() if "string" in kinds:
            return "; put it in quotes"
        case dict() if "array" in kinds:
            return "; begin each item with '- '"
        case list() if "object" in kinds:
            return "; write 'key: value', without '- '"
        case str() if "boolean" in kinds and value.casefold() in _BOOLEANS:
            return f"; write {_BOOLEANS[value.casefold()]}"
        case str() if {"integer", "number"}.intersection(kinds):
            return f"; write 0x{value}" if re.fullmatch("[0-9A-Fa-f]{2}", value) else strange(value)
        case _:
            return ""


def _shown(value: Any) -> str:
    match value:
        case None:
            return "nothing"
        case bool():
            return str(value).lower()
        case dict():
            return "a mapping"
        case list():
            return "a list"
        case str() if len(value) > 60:
            return repr(value[:60] + "…")
        case _:
            return repr(value)
