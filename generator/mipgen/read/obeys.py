"""Whether a value obeys its schema, which most do.

Only yes or no: what is wrong with a value, the library for JSON Schema finds. To import that takes longer than most
changes take to generate, and to ask it is slow.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable
from typing import Any

from mipgen.base import resources

Schema = dict[str, Any]


def obeys(file: str, value: Any) -> bool:
    """Does a value obey the schema in this file of `spec/schema`?"""
    return _obeys(_schema(f"{file}#"), value)


@functools.cache
def _schema(reference: str) -> Schema:
    """What a reference refers to: "common.schema.json#/definitions/unit"."""
    file, _, pointer = reference.partition("#")
    found = _file(file)
    for step in pointer.split("/")[1:]:
        found = found[step]
    return found


@functools.cache
def _file(name: str) -> Schema:
    text = (resources.root() / "spec/schema" / name).read_text("utf-8")
    schema: Schema = json.loads(text.replace('"$ref": "#', f'"$ref": "{name}#'))
    return schema


def _obeys(schema: Schema, value: Any) -> bool:
    if "$ref" in schema:  # what is beside it does not count
        return _obeys(_schema(schema["$ref"]), value)
    return all(rule in _SILENT or _RULES[rule](value, asks, schema) for rule, asks in schema.items())


# --------------------------------------------------------------------------- rules

#: What a schema may hold besides rules.
_SILENT = {"$schema", "$id", "title", "description", "definitions", "examples", "then", "else"}

_TYPES: dict[str, tuple[type, ...]] = {
    "object": (dict,), "array": (list,), "string": (str,), "boolean": (bool,), "null": (type(None),),
    "integer": (int,), "number": (int, float),
}  # fmt: skip


def _type(value: Any, names: str | list[str], _: Schema) -> bool:
    return any(type(value) in _TYPES[name] for name in ([names] if isinstance(names, str) else names))


def _among(value: Any, known: list[Any], _: Schema) -> bool:
    return any(type(value) is type(one) and value == one for one in known)


def _pattern(value: Any, pattern: str, _: Schema) -> bool:
    return not isinstance(value, str) or re.search(pattern.replace("$", r"\Z"), value) is not None


def _of(kind: type | tuple[type, ...], holds: Callable[[Any, Any], bool]) -> Callable[[Any, Any, Schema], bool]:
    """A rule for values of a kind, which says nothing of others."""
    return lambda value, asks, _: not isinstance(value, kind) or holds(value, asks)


def _properties(value: Any, inner: dict[str, Schema], _: Schema) -> bool:
    return not isinstance(value, dict) or all(_obeys(inner[key], x) for key, x in value.items() if key in inner)


def _others(value: Any, inner: Any, schema: Schema) -> bool:
    others = value.keys() - schema.get("properties", {}).keys() if isinstance(value, dict) else ()
    return all(inner is not False and _obeys(inner, value[key]) for key in others)


def _if(value: Any, condition: Schema, schema: Schema) -> bool:
    return _obeys(schema.get("then" if _obeys(condition, value) else "else", {}), value)


_RULES: dict[str, Callable[[Any, Any, Schema], bool]] = {
    "type": _type,
    "enum": _among,
    "const": lambda value, only, schema: _among(value, [only], schema),
    "pattern": _pattern,
    "minimum": _of((int, float), lambda value, limit: value >= limit),
    "maximum": _of((int, float), lambda value, limit: value <= limit),
    "exclusiveMinimum": _of((int, float), lambda value, limit: value > limit),
    "minLength": _of(str, lambda value, limit: len(value) >= limit),
    "minItems": _of(list, lambda value, limit: len(value) >= limit),
    "maxItems": _of(list, lambda value, limit: len(value) <= limit),
    "minProperties": _of(dict, lambda value, limit: len(value) >= limit),
    "maxProperties": _of(dict, lambda value, limit: len(value) <= limit),
    "required": _of(dict, lambda value, keys: all(key in value for key in keys)),
    "properties": _properties,
    "additionalProperties": _others,
    "propertyNames": _of(dict, lambda value, inner: all(_obeys(inner, key) for key in value)),
    "items": _of(list, lambda value, inner: all(_obeys(inner, item) for item in value)),
    "allOf": lambda value, several, _: all(_obeys(one, value) for one in several),
    "if": _if,
}
