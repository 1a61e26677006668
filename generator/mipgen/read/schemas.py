"""Tells whether a file fits its JSON Schema, quickly: each schema becomes a function.

Most files do. Only for others does `loader` call the jsonschema library, which finds the mistakes, but is slow.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable, Mapping
from typing import Any

from mipgen.base import resources

from .nodes import Node

SUFFIX = ".schema.json"

#: Tells whether the value of a node fits a schema.
Check = Callable[[Any], bool]

#: Keywords without a rule. `$ref` replaces all other keywords, and `then` and `else` belong to `if`.
_SILENT = {
    "$schema", "$id", "title", "description", "default", "examples", "format", "definitions", "then", "else"
}  # fmt: skip

_TYPES: dict[str, Check] = {
    "object": lambda value: isinstance(value, dict),
    "array": lambda value: isinstance(value, list),
    "string": lambda value: isinstance(value, str),
    "boolean": lambda value: isinstance(value, bool),
    "null": lambda value: value is None,
    "number": lambda value: isinstance(value, (int, float)) and not isinstance(value, bool),
    "integer": lambda value: is_integer(value),
}


def is_integer(value: Any) -> bool:
    """Rejects 1.0 as an integer, which JSON Schema accepts: an author who writes 1.0 means a float."""
    return isinstance(value, int) and not isinstance(value, bool)


def pattern(text: str) -> re.Pattern[str]:
    r"""Compiles a pattern whose `$` matches only at the end of a text, as in JSON Schema. Python's also matches before
    a final line break.

    >>> [bool(pattern("^a$").search(text)) for text in ("a", "a\n")]
    [True, False]
    """
    return re.compile(text.replace("$", r"\Z"))


def fits_schema(kind: str, root: Node) -> bool:
    """True if a file fits the schema of its kind."""
    return _referenced(kind + SUFFIX, "")(root.value)


@functools.cache
def schema_files() -> dict[str, Any]:
    """Reads the schemas, by file name."""
    folder = resources.root() / "spec/schema"
    return {name: json.loads(file.read_text("utf-8")) for name, file in resources.files_in(folder)}


@functools.cache
def _referenced(file: str, pointer: str) -> Check:
    """Compiles the schema at a pointer such as `/definitions/name`."""
    schema = schema_files()[file]
    for step in pointer.split("/")[1:]:
        schema = schema[step]
    return _compiled(schema, file)


def _compiled(schema: Any, file: str) -> Check:
    if isinstance(schema, bool):
        return lambda _: schema
    if "$ref" in schema:
        other, _, pointer = schema["$ref"].partition("#")
        return lambda value: _referenced(other or file, pointer)(value)  # later, because schemas refer to themselves
    checks = [_RULES[key](rule, schema, file) for key, rule in schema.items() if key not in _SILENT]
    return checks[0] if len(checks) == 1 else _all(checks)


def _all(checks: list[Check]) -> Check:
    return lambda value: all(check(value) for check in checks)


def _type(rule: Any, _: Any, __: str) -> Check:
    if isinstance(rule, str):
        return _TYPES[rule]
    kinds = [_TYPES[kind] for kind in rule]
    return lambda value: any(kind(value) for kind in kinds)


def _enum(rule: Any, _: Any, __: str) -> Check:
    """Distinguishes true from 1, unlike Python; lists and mappings are not supported."""
    values = {(isinstance(value, bool), value) for value in rule}
    return lambda value: not isinstance(value, (dict, list)) and (isinstance(value, bool), value) in values


def _properties(rule: Any, _: Any, file: str) -> Check:
    compiled = {key: _compiled(schema, file) for key, schema in rule.items()}

    def check(value: Any) -> bool:
        if isinstance(value, dict):
            for key, node in value.items():
                if key in compiled and not compiled[key](node.value):
                    return False
        return True

    return check


def _other_properties(rule: Any, schema: Mapping[str, Any], file: str) -> Check:
    named, other = frozenset(schema.get("properties", ())), _compiled(rule, file)
    return lambda value: not isinstance(value, dict) or all(other(value[key].value) for key in value.keys() - named)


def _names(rule: Any, _: Any, file: str) -> Check:
    name = _compiled(rule, file)
    return lambda value: not isinstance(value, dict) or all(map(name, value))


def _items(rule: Any, _: Any, file: str) -> Check:
    item = _compiled(rule, file)
    return lambda value: not isinstance(value, list) or all(item(node.value) for node in value)


def _required(rule: Any, _: Any, __: str) -> Check:
    keys = frozenset(rule)
    return lambda value: not isinstance(value, dict) or keys <= value.keys()


def _pattern(rule: Any, _: Any, __: str) -> Check:
    search = pattern(rule).search
    return lambda value: not isinstance(value, str) or search(value) is not None


def _if(rule: Any, schema: Mapping[str, Any], file: str) -> Check:
    condition = _compiled(rule, file)
    then, otherwise = (_compiled(schema.get(key, True), file) for key in ("then", "else"))
    return lambda value: (then if condition(value) else otherwise)(value)


def _all_of(rule: Any, _: Any, file: str) -> Check:
    return _all([_compiled(schema, file) for schema in rule])


def _bound(kinds: type | tuple[type, ...], holds: Callable[[Any, Any], bool]) -> Callable[[Any, Any, str], Check]:
    """Returns the rule for a bound, which concerns only these types."""
    return lambda rule, _, __: (
        lambda value: not isinstance(value, kinds) or isinstance(value, bool) or holds(value, rule)
    )


_NUMBER = (int, float)

#: Keyword -> function that compiles its rule. A schema may use no others.
_RULES: dict[str, Callable[[Any, Any, str], Check]] = {
    "type": _type,
    "enum": _enum,
    "const": lambda rule, schema, file: _enum([rule], schema, file),
    "required": _required,
    "properties": _properties,
    "additionalProperties": _other_properties,
    "propertyNames": _names,
    "items": _items,
    "pattern": _pattern,
    "if": _if,
    "allOf": _all_of,
    "minimum": _bound(_NUMBER, lambda value, rule: value >= rule),
    "maximum": _bound(_NUMBER, lambda value, rule: value <= rule),
    "exclusiveMinimum": _bound(_NUMBER, lambda value, rule: value > rule),
    "minLength": _bound(str, lambda value, rule: len(value) >= rule),
    "minItems": _bound(list, lambda value, rule: len(value) >= rule),
    "maxItems": _bound(list, lambda value, rule: len(value) <= rule),
    "minProperties": _bound(dict, lambda value, rule: len(value) >= rule),
    "maxProperties": _bound(dict, lambda value, rule: len(value) <= rule),
}
