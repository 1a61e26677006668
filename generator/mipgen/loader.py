"""Reads YAML files into nodes that know their place. Knows files and lines, and nothing of MIP.

YAML is read by the rules of version 1.2 (only true and false are booleans), duplicate keys,
anchors and tags are refused, and every file is judged by the JSON Schema that belongs to it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import jsonschema
import referencing
import yaml

from .model import Position
from .problems import Problems, nearest

SCHEMA_DIR = "schema"

#: Which files a specification has: kind of schema -> pattern below its folder.
LAYOUT = {
    "protocol": "protocol.yaml",
    "types": "types/*.yaml",
    "set": "sets/*.yaml",
    "device": "devices/*.yaml",
    "examples": "examples/*.yaml",
    "errata": "errata/*.yaml",
}

_INT = re.compile(r"[-+]?(0|[1-9][0-9]*)|0x[0-9A-Fa-f]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")

_Loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass(frozen=True, slots=True)
class Node:
    """A YAML value and its place. `value` is a dict or list of nodes, or a plain scalar."""

    value: Any
    position: Position
    keys: dict[str, Position] = field(default_factory=dict)  # of a mapping: where each key stands

    def __contains__(self, key: str) -> bool:
        return isinstance(self.value, dict) and key in self.value

    def __getitem__(self, key: str) -> Node:
        node: Node = self.value[key]
        return node

    def get(self, key: str) -> Node | None:
        return self.value.get(key) if isinstance(self.value, dict) else None

    def scalar(self, key: str, default: Any = None) -> Any:
        """The plain value below `key`, or `default` where there is none."""
        node = self.get(key)
        return default if node is None or node.value is None else node.value

    def items(self) -> Iterator[tuple[str, Node]]:
        yield from self.value.items()

    def __iter__(self) -> Iterator[Node]:
        yield from self.value

    def plain(self) -> Any:
        """The value without places, as JSON has it."""
        if isinstance(self.value, dict):
            return {k: v.plain() for k, v in self.value.items()}
        if isinstance(self.value, list):
            return [v.plain() for v in self.value]
        return self.value

    def at(self, path: list[str | int]) -> Position:
        """The place of what stands at `path` below this node (of the key, where it is a key)."""
        node, position = self, self.position
        for step in path:
            if isinstance(node.value, dict) and step in node.value:
                position = node.keys[str(step)]
                node = node.value[step]
            elif isinstance(node.value, list) and isinstance(step, int) and step < len(node.value):
                node = node.value[step]
                position = node.position
            else:
                break
        return position


@dataclass(frozen=True, slots=True)
class Document:
    kind: str
    path: str
    root: Node


def load(spec: Path, problems: Problems) -> list[Document]:
    """Reads all files of a specification; what is wrong with them goes to `problems`."""
    if not (spec / "protocol.yaml").is_file():
        problems.add(Position(shown(spec), 1, 1), "this is no specification: protocol.yaml is missing")
        return []
    validators = _validators(_schema_dir(spec))
    documents = []
    for kind, pattern in LAYOUT.items():
        for path in sorted(spec.glob(pattern)):
            name = path.relative_to(spec).as_posix()
            root = read(path, shown(path), problems)
            if root is not None and _valid(validators[kind], root, problems):
                documents.append(Document(kind, name, root))
    return documents


def shown(path: Path) -> str:
    """A path as a person at the command line would write it."""
    here = Path.cwd()
    absolute = path.absolute()
    return absolute.relative_to(here).as_posix() if absolute.is_relative_to(here) else str(path)


def _schema_dir(spec: Path) -> Path:
    """A specification may bring its own schemas; else those of the main specification serve."""
    own = spec / SCHEMA_DIR
    return own if own.is_dir() else Path(__file__).parents[2] / "spec" / SCHEMA_DIR


def _validators(folder: Path) -> dict[str, jsonschema.Draft7Validator]:
    schemas = {p.name: json.loads(p.read_text("utf-8")) for p in sorted(folder.glob("*.schema.json"))}
    registry: referencing.Registry[Any] = referencing.Registry().with_resources(
        (name, referencing.Resource.from_contents(schema)) for name, schema in schemas.items()
    )
    return {
        kind: jsonschema.Draft7Validator(schemas[f"{kind}.schema.json"], registry=registry)
        for kind in LAYOUT
    }


# --------------------------------------------------------------------------- YAML


def read(path: Path, name: str, problems: Problems) -> Node | None:
    """Reads one YAML file; None if it cannot be read."""
    try:
        text = path.read_text("utf-8")
        composed = yaml.compose(text, Loader=_Loader)
    except UnicodeDecodeError as error:
        problems.add(Position(name, 1, 1), f"not UTF-8: {error.reason} at byte {error.start}; save the file as UTF-8")
        return None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        place = Position(name, mark.line + 1, mark.column + 1) if mark else Position(name, 1, 1)
        problems.add(place, f"not YAML: {error.problem or error.context}")
        return None
    except yaml.YAMLError as error:
        problems.add(Position(name, 1, 1), f"not YAML: {str(error).splitlines()[0]}")
        return None
    if composed is None:
        problems.add(Position(name, 1, 1), "the file is empty")
        return None
    return _node(composed, name, problems, set())


def _node(raw: yaml.Node, file: str, problems: Problems, seen: set[int]) -> Node:
    position = Position(file, raw.start_mark.line + 1, raw.start_mark.column + 1)
    if id(raw) in seen:
        problems.add(position, "aliases (*name) are not used here; write the value out")
        return Node(None, position)
    if isinstance(raw, yaml.ScalarNode):
        return Node(_scalar(raw, position, problems), position)
    seen = seen | {id(raw)}
    if isinstance(raw, yaml.SequenceNode):
        return Node([_node(item, file, problems, seen) for item in raw.value], position)
    mapping: dict[str, Node] = {}
    keys: dict[str, Position] = {}
    for raw_key, raw_value in raw.value:
        place = Position(file, raw_key.start_mark.line + 1, raw_key.start_mark.column + 1)
        if not isinstance(raw_key, yaml.ScalarNode):
            problems.add(place, "a key must be a plain word")
            continue
        key = raw_key.value
        if key in mapping:
            problems.add(place, f"duplicate key '{key}', first in line {keys[key].line}; remove one")
            continue
        keys[key] = place
        mapping[key] = _node(raw_value, file, problems, seen)
    return Node(mapping, position, keys)


def _scalar(raw: yaml.ScalarNode, position: Position, problems: Problems) -> Any:
    text: str = raw.value
    if raw.style in ("'", '"', "|", ">"):
        return text
    if raw.tag.startswith("!") and raw.tag != "!":
        problems.add(position, f"the tag {raw.tag} is not used here; remove it")
    if text in ("", "~", "null"):
        return None
    if text in ("true", "false"):
        return text == "true"
    if _INT.fullmatch(text):
        return int(text, 0)
    if _FLOAT.fullmatch(text):
        return float(text)
    return text


# --------------------------------------------------------------------------- schema


def _valid(validator: jsonschema.Draft7Validator, root: Node, problems: Problems) -> bool:
    errors = list(validator.iter_errors(root.plain()))
    for error in errors:
        path = list(error.absolute_path)
        for extra, message in _messages(error):
            problems.add(root.at([*path, *extra]), message)
    return not errors


def _messages(error: jsonschema.ValidationError) -> Iterator[tuple[list[str | int], str]]:
    """What is wrong and what would be right, in words; with the key that it is about, if it is one."""
    instance, schema, rule = error.instance, error.schema, error.validator_value
    inside = next((str(p) for p in reversed(error.absolute_path) if isinstance(p, str)), "the file")
    match error.validator:
        case "additionalProperties" if isinstance(rule, bool):
            known = schema.get("properties", {})
            for key in sorted(set(instance) - set(known)):
                yield [key], f"unknown key '{key}'{nearest(key, known)}"
        case "required":
            for key in rule:
                if key not in instance:
                    yield [], f"'{key}' is missing in {inside}"
        case "type":
            kinds = [rule] if isinstance(rule, str) else rule
            hint = "; put it in quotes" if "string" in kinds and isinstance(instance, (int, float)) else ""
            yield [], f"{inside} must be {_kinds(kinds)}, not {_shown(instance)}{hint}"
        case "enum":
            near = nearest(str(instance), map(str, rule))
            yield [], f"{inside}: {_shown(instance)} is not known here{near}"
        case "const":
            yield [], f"{inside} must be {_shown(rule)}, or be left out"
        case "pattern":
            what = schema.get("description", f"text like {rule}")
            yield [], f"{inside}: {_shown(instance)} must be {what}"
        case "minimum" | "exclusiveMinimum" | "maximum":
            yield [], f"{inside}: {_shown(instance)} is out of range ({error.validator} {rule})"
        case "minItems" | "minProperties" | "minLength":
            yield [], f"{inside} must not be empty" if rule == 1 else f"{inside} needs at least {rule} items"
        case "maxItems" | "maxProperties":
            yield [], f"{inside} has more than {rule} items"
        case _:
            yield [], f"{inside}: {error.message}"


def _kinds(kinds: list[str]) -> str:
    words = {"object": "a mapping", "array": "a list", "string": "text", "integer": "a whole number",
             "number": "a number", "boolean": "true or false", "null": "empty"}  # fmt: skip
    return " or ".join(words[k] for k in kinds)


def _shown(value: Any) -> str:
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list):
        return "a list"
    return {None: "nothing", True: "true", False: "false"}.get(value, repr(value)) if not isinstance(
        value, (int, float)
    ) or isinstance(value, bool) else repr(value)
