"""Checks files against their JSON Schemas. Each schema becomes a function that returns the mistakes of a value, with
their remedies in words."""

from __future__ import annotations

import functools
import json
import operator
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

from mipgen.base import resources

from .nodes import Node
from .problems import Problems, close, nearest
from .spelling import strange

SUFFIX = ".schema.json"

#: Keywords without a rule. `$ref` replaces all other keywords, and `then` and `else` belong to `if`.
_SILENT = {
    "$schema", "$id", "title", "description", "default", "examples", "format", "definitions", "then", "else"
}  # fmt: skip

#: Words that other YAML parsers read as true and false.
_BOOLEANS = {**dict.fromkeys(("true", "yes", "on", "y"), "true"), **dict.fromkeys(("false", "no", "off", "n"), "false")}


class Mistake(NamedTuple):
    """A mistake at a path. The message names what is there, between both parts; with one part, it is about a key."""

    path: tuple[str | int, ...]
    message: str
    rest: str | None = None


#: Returns the mistakes of the value of a node.
Check = Callable[[Any], list[Mistake]]

Schema = Mapping[str, Any]


def check_schema(kind: str, root: Node, problems: Problems) -> bool:
    """Adds the mistakes of a file to `problems`; True if there are none."""
    mistakes = _referenced(kind + SUFFIX, "")(root.value)
    for path, message, rest in mistakes:
        if rest is None:
            problems.add(root.at([*path]), message)
        else:
            problems.add(root.value_at([*path]), f"{message}{_inside(path)}{rest}")
    return not mistakes


def _inside(path: tuple[str | int, ...]) -> str:
    """Names a key, or an item of a list."""
    key = next((f"'{p}'" for p in reversed(path) if isinstance(p, str)), "the file")
    return f"item {path[-1] + 1} of {key}" if path and isinstance(path[-1], int) else key


# --------------------------------------------------------------------------- schemas as functions


@functools.cache
def schema_files() -> dict[str, Any]:
    """Reads the schemas, by file name."""
    folder = resources.root() / "spec/schema"
    return {name: json.loads(file.read_text("utf-8")) for name, file in resources.files_in(folder)}


@functools.cache
def _referenced(file: str, pointer: str) -> Check:
    return _compiled(_schema_at(file, pointer), file)


def _schema_at(file: str, pointer: str) -> Any:
    """Returns the schema at a pointer such as `/definitions/name`."""
    return functools.reduce(dict.__getitem__, pointer.split("/")[1:], schema_files()[file])


def _reference(schema: Schema, file: str) -> tuple[str, str]:
    other, _, pointer = schema["$ref"].partition("#")
    return other or file, pointer


def _compiled(schema: Schema, file: str) -> Check:
    if "$ref" in schema:
        place = _reference(schema, file)
        return lambda value: _referenced(*place)(value)  # later, because schemas refer to themselves
    checks = [
        functools.partial(_VALUES[key], rule, schema) if key in _VALUES else _PARTS[key](rule, schema, file)
        for key, rule in schema.items()
        if key not in _SILENT
    ]
    return checks[0] if len(checks) == 1 else _all(checks)


def _all(checks: list[Check]) -> Check:
    return lambda value: [mistake for check in checks for mistake in check(value)]


def _within(step: str | int, mistakes: list[Mistake]) -> Iterable[Mistake]:
    return (mistake._replace(path=(step, *mistake.path)) for mistake in mistakes)


def _properties(rule: Any, _: Schema, file: str) -> Check:
    compiled = {key: _compiled(schema, file) for key, schema in rule.items()}

    def check(value: Any) -> list[Mistake]:
        known = value.keys() & compiled.keys() if isinstance(value, dict) else ()
        return [x for key in known if (found := compiled[key](value[key].value)) for x in _within(key, found)]

    return check


def _other_properties(rule: Any, schema: Schema, file: str) -> Check:
    named = dict(schema.get("properties", {}))
    other = None if rule is False else _compiled(rule, file)

    def check(value: Any) -> list[Mistake]:
        others = value.keys() - named if isinstance(value, dict) else ()
        if other is None:
            return [x for key in others for x in _unknown_key(key, value[key].value, named)]
        return [x for key in others if (found := other(value[key].value)) for x in _within(key, found)]

    return check


def _names(rule: Any, _: Schema, file: str) -> Check:
    name, form = _compiled(rule, file), _form(_schema_at(*_reference(rule, file)))

    def check(value: Any) -> list[Mistake]:
        keys = value if isinstance(value, dict) else ()
        return [x for key in keys if name(key) for x in _wrong_name(key, form)]

    return check


def _items(rule: Any, _: Schema, file: str) -> Check:
    item = _compiled(rule, file)

    def check(value: Any) -> list[Mistake]:
        several = enumerate(value) if isinstance(value, list) else ()
        return [x for i, node in several if (found := item(node.value)) for x in _within(i, found)]

    return check


def _if(rule: Any, schema: Schema, file: str) -> Check:
    condition = _compiled(rule, file)
    then, otherwise = (_compiled(schema.get(key, {}), file) for key in ("then", "else"))
    return lambda value: (otherwise if condition(value) else then)(value)


def _all_of(rule: Any, _: Schema, file: str) -> Check:
    return _all([_compiled(schema, file) for schema in rule])


#: Keyword -> function that compiles its rule about parts of a value. A schema may use no others.
_PARTS: dict[str, Callable[[Any, Schema, str], Check]] = {
    "properties": _properties,
    "additionalProperties": _other_properties,
    "propertyNames": _names,
    "items": _items,
    "if": _if,
    "allOf": _all_of,
}


# --------------------------------------------------------------------------- rules about a value, and their messages


def _fault(rest: str, message: str = "") -> list[Mistake]:
    return [Mistake((), message, rest)]


def _fault_of_key(key: str, message: str) -> list[Mistake]:
    return [Mistake((key,), message)]


def _wrong_name(name: str, form: str | None) -> list[Mistake]:
    return _fault_of_key(name, f"the name '{name}' must be {form}{strange(name)}")


def _unknown_key(key: str, value: Any, known: Iterable[str]) -> list[Mistake]:
    rest = "; if it ends the text before it, put the whole text in quotes"
    return _fault_of_key(key, f"unknown key '{key}'{rest if value is None else nearest(key, known)}")


def _missing(key: str, schema: Schema) -> list[Mistake]:
    alone = "; write only the number if the name needs no description" if key == "description" else ""
    return _fault(alone if "integer" in schema.get("type", ()) else "", f"'{key}' is missing in ")


def _required(rule: list[str], schema: Schema, value: Any) -> list[Mistake]:
    return [x for key in rule if key not in value for x in _missing(key, schema)] if isinstance(value, dict) else []


_TYPES: dict[str, Callable[[Any], bool]] = {
    "object": lambda value: isinstance(value, dict),
    "array": lambda value: isinstance(value, list),
    "string": lambda value: isinstance(value, str),
    "boolean": lambda value: isinstance(value, bool),
    "null": lambda value: value is None,
    "number": lambda value: isinstance(value, (int, float)) and not isinstance(value, bool),
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),  # not 1.0: it is meant as a float
}

_IN_WORDS = {
    "object": "a mapping",
    "array": "a list",
    "string": "text",
    "integer": "a whole number",
    "number": "a number",
    "boolean": "true or false",
    "null": "empty",
}


def _type(rule: str | list[str], schema: Schema, value: Any) -> list[Mistake]:
    kinds = [rule] if isinstance(rule, str) else rule
    if any(_TYPES[kind](value) for kind in kinds):
        return []
    wanted = _form(schema) or " or ".join(_IN_WORDS[kind] for kind in kinds)
    return _fault(f" must be {wanted}, not {_shown(value)}{_instead(value, kinds)}")


def _enum(rule: list[Any], _: Schema, value: Any) -> list[Mistake]:
    if _is_one_of(rule, value):
        return []
    choices = [str(x) for x in rule]
    return _fault(f" must be {' or '.join(choices)}, not {_shown(value)}{close(str(value), choices)}")


def _const(rule: Any, _: Schema, value: Any) -> list[Mistake]:
    if _is_one_of([rule], value):
        return []
    return _fault(f" must be {_shown(rule)}, or be omitted, not {_shown(value)}")


def _is_one_of(rule: list[Any], value: Any) -> bool:
    """Distinguishes true from 1, unlike Python; lists and mappings are not supported."""
    return any(value == x and isinstance(value, bool) == isinstance(x, bool) for x in rule)


def _pattern(rule: str, schema: Schema, value: Any) -> list[Mistake]:
    if not isinstance(value, str) or pattern(rule).search(value):
        return []
    return _fault(f" must be {_form(schema) or rule}, not {_shown(value)}{strange(value)}")


@functools.cache
def pattern(text: str) -> re.Pattern[str]:
    r"""Compiles a pattern whose `$` matches only at the end of a text, as in JSON Schema. Python's also matches before
    a final line break.

    >>> [bool(pattern("^a$").search(text)) for text in ("a", "a\n")]
    [True, False]
    """
    return re.compile(text.replace("$", r"\Z"))


def _bound(words: str, holds: Callable[[Any, Any], bool], rule: Any, _: Schema, value: Any) -> list[Mistake]:
    if not _TYPES["number"](value) or holds(value, rule):
        return []
    return _fault(f" must be {words} {rule}, not {_shown(value)}")


def _least(kind: type, rule: int, _: Schema, value: Any) -> list[Mistake]:
    if not isinstance(value, kind) or len(value) >= rule:  # type: ignore[arg-type]
        return []
    return _fault(" must not be empty" if rule == 1 else f" must have at least {rule} items")


def _most(kind: type, rule: int, _: Schema, value: Any) -> list[Mistake]:
    if not isinstance(value, kind) or len(value) <= rule:  # type: ignore[arg-type]
        return []
    return _fault(f" must have at most {rule} item{'s' if rule != 1 else ''}")


#: Keyword -> the function that applies its rule to a value. A schema may use no others.
_VALUES: dict[str, Callable[[Any, Schema, Any], list[Mistake]]] = {
    "type": _type,
    "enum": _enum,
    "const": _const,
    "required": _required,
    "pattern": _pattern,
    "minimum": functools.partial(_bound, "at least", operator.ge),
    "exclusiveMinimum": functools.partial(_bound, "more than", operator.gt),
    "maximum": functools.partial(_bound, "at most", operator.le),
    "minLength": functools.partial(_least, str),
    "minItems": functools.partial(_least, list),
    "minProperties": functools.partial(_least, dict),
    "maxItems": functools.partial(_most, list),
    "maxProperties": functools.partial(_most, dict),
}


def _form(schema: Schema) -> str | None:
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
