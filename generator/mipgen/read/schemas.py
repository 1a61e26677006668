"""The schemas of the files of a specification, and which of their rules a value breaks.

They are JSON Schema (draft-07), so that editors understand them. Of its rules, this module knows those that they use;
a library for all of them takes longer to import than most changes take to generate.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from mipgen.base import resources

Schema = dict[str, Any]
Path = tuple[str | int, ...]

_SUFFIX = ".schema.json"


class Breach(NamedTuple):
    """A rule that a value breaks."""

    rule: str
    asks: Any  # what the schema says of the rule
    schema: Schema
    value: Any
    path: Path  # to the value
    name: bool  # the value is the name of a property


@functools.cache
def schemas() -> dict[str, Schema]:
    """The schema of each kind of file, each reference replaced by what it refers to."""
    files = resources.files(resources.root() / "spec/schema")
    return linked({name.removesuffix(_SUFFIX): file.read_text("utf-8") for name, file in files})


def linked(texts: Mapping[str, str]) -> dict[str, Schema]:
    own = {name: text.replace('"$ref": "#', f'"$ref": "{name}{_SUFFIX}#') for name, text in texts.items()}
    read: dict[str, Schema] = {name: json.loads(text) for name, text in own.items()}

    def link(value: Any) -> None:
        for key, inner in list(value.items() if isinstance(value, dict) else enumerate(value)):
            if isinstance(inner, (dict, list)):
                value[key] = target = follow(inner)
                if target is inner:  # else it is linked where it is
                    link(inner)

    def follow(value: Any) -> Any:
        while "$ref" in value:
            file, _, place = value["$ref"].partition("#")
            value = functools.reduce(
                lambda found, key: found[key], place.split("/")[1:], read[file.removesuffix(_SUFFIX)]
            )
        return value

    link(read)
    return read


def breaches(schema: Schema, value: Any, path: Path = (), name: bool = False) -> Iterator[Breach]:
    """What is wrong with a value."""
    for rule, asks in schema.items():
        holds = _OF_ONE.get(rule)
        if holds is not None:
            if not holds(value, asks):
                yield Breach(rule, asks, schema, value, path, name)
        elif rule not in _NO_RULES:
            yield from _OF_SEVERAL[rule](schema, value, path)


# --------------------------------------------------------------------------- rules for one value

_TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}


def _has_type(value: Any, kinds: str | list[str]) -> bool:
    """JSON Schema accepts 1.0 as an integer; an author who writes 1.0 means a float."""
    for kind in (kinds,) if isinstance(kinds, str) else kinds:
        if kind == "integer" or kind == "number":
            if isinstance(value, int if kind == "integer" else (int, float)) and not isinstance(value, bool):
                return True
        elif isinstance(value, _TYPES[kind]):
            return True
    return False


def _among(value: Any, known: Iterable[Any]) -> bool:
    return any(type(value) is type(one) and value == one for one in known)


def _matches(value: Any, pattern: str) -> bool:
    """JSON Schema's `$` is the end of the text; Python's is also before a line break at its end."""
    return not isinstance(value, str) or bool(re.search(pattern.replace("$", r"\Z"), value))


def _number(holds: Callable[[Any, Any], bool]) -> Callable[[Any, Any], bool]:
    return lambda value, limit: not _has_type(value, "number") or holds(value, limit)


_OF_ONE: dict[str, Callable[[Any, Any], bool]] = {
    "type": _has_type,
    "enum": _among,
    "const": lambda value, only: _among(value, (only,)),
    "pattern": _matches,
    "minimum": _number(lambda value, limit: value >= limit),
    "maximum": _number(lambda value, limit: value <= limit),
    "exclusiveMinimum": _number(lambda value, limit: value > limit),
    "minLength": lambda value, limit: not isinstance(value, str) or len(value) >= limit,
    "minItems": lambda value, limit: not isinstance(value, list) or len(value) >= limit,
    "maxItems": lambda value, limit: not isinstance(value, list) or len(value) <= limit,
    "minProperties": lambda value, limit: not isinstance(value, dict) or len(value) >= limit,
    "maxProperties": lambda value, limit: not isinstance(value, dict) or len(value) <= limit,
    "required": lambda value, keys: not isinstance(value, dict) or all(key in value for key in keys),
}

# --------------------------------------------------------------------------- rules for what a value holds


def _properties(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    for key, inner in schema["properties"].items() if isinstance(value, dict) else ():
        if key in value:
            yield from breaches(inner, value[key], (*path, key))


def _other_properties(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    inner, known = schema["additionalProperties"], schema.get("properties", ())
    others = [key for key in value if key not in known] if isinstance(value, dict) else []
    if inner is False and others:
        yield Breach("additionalProperties", inner, schema, value, path, False)
    for key in others if isinstance(inner, dict) else ():
        yield from breaches(inner, value[key], (*path, key))


def _names(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    for key in value if isinstance(value, dict) else ():
        yield from breaches(schema["propertyNames"], key, path, name=True)


def _items(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    for i, item in enumerate(value if isinstance(value, list) else ()):
        yield from breaches(schema["items"], item, (*path, i))


def _all(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    for one in schema["allOf"]:
        yield from breaches(one, value, path)


def _either(schema: Schema, value: Any, path: Path) -> Iterator[Breach]:
    holds = next(breaches(schema["if"], value), None) is None
    yield from breaches(schema.get("then" if holds else "else", {}), value, path)


_OF_SEVERAL: dict[str, Callable[[Schema, Any, Path], Iterator[Breach]]] = {
    "properties": _properties,
    "additionalProperties": _other_properties,
    "propertyNames": _names,
    "items": _items,
    "allOf": _all,
    "if": _either,
}

#: What else a schema may say, which is no rule.
_NO_RULES = {"$schema", "$id", "title", "description", "definitions", "examples", "then", "else"}
