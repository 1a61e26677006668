"""YAML as nodes with their positions: file, line and column. Independent of MIP.

YAML is read by the rules of version 1.2, except that numbers have the form of JSON; duplicate keys, anchors, aliases
and tags are rejected.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from . import syntax
from .problems import Position, Problems

MAX_DEPTH = 50
MAX_DIGITS = 40

#: Plain scalars that are not text; and the characters with which numbers begin.
_WORDS = {"": None, "~": None, "null": None, "true": True, "false": False}
_NUMERIC = frozenset("+-.0123456789")

_DECIMAL = re.compile(r"-?(0|[1-9][0-9]*)")
_HEXADECIMAL = re.compile(r"0x[0-9A-Fa-f]+")
_FLOAT = re.compile(r"-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?")

#: Categories of invisible characters: controls, formats, surrogates, separators of lines and paragraphs.
_CONTROLS = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})

_SEPARATOR = re.compile(r"(?<=[0-9A-Fa-fxX])_(?=[0-9A-Fa-f])")
_BARE = re.compile(r"(-?)0*((?=\.?[0-9])[0-9]*)(\.[0-9]*)?([eE][-+]?[0-9]+)?")


@dataclass(slots=True)  # never changed, but not frozen: reading would take a fifth longer
class Node:
    """A YAML value and its position. `value` is a dict or list of nodes, or a plain scalar."""

    value: Any
    position: Position
    keys: dict[str, Position] = field(default_factory=dict)  # of a mapping: the position of each key

    def __contains__(self, key: str) -> bool:
        return isinstance(self.value, dict) and key in self.value

    def __getitem__(self, key: str) -> Node:
        node: Node = self.value[key]
        return node

    def get(self, key: str) -> Node | None:
        return self.value.get(key) if isinstance(self.value, dict) else None

    def scalar(self, key: str, default: Any = None) -> Any:
        """Returns the plain value of `key`, or `default` if there is none."""
        node = self.get(key)
        return default if node is None or node.value is None else node.value

    def items(self) -> Iterator[tuple[str, Node]]:
        yield from self.value.items()

    def __iter__(self) -> Iterator[Node]:
        yield from self.value

    def plain(self) -> Any:
        """Returns the value without positions, as in JSON."""
        if isinstance(self.value, dict):
            return {k: v.plain() for k, v in self.value.items()}
        if isinstance(self.value, list):
            return [v.plain() for v in self.value]
        return self.value

    def at(self, path: list[str | int]) -> Position:
        """Returns the position at `path`: that of the key, if there is one."""
        return self._follow(path)[0]

    def value_at(self, path: list[str | int]) -> Position:
        """Returns the position of the plain value at `path`; of its key, if the value is not plain."""
        position, node = self._follow(path)
        return position if node.value is None or isinstance(node.value, (dict, list)) else node.position

    def _follow(self, path: list[str | int]) -> tuple[Position, Node]:
        node, position = self, self.position
        for step in path:
            if isinstance(node.value, dict) and step in node.value:
                position = node.keys[str(step)]
                node = node.value[step]
            elif isinstance(node.value, list) and isinstance(step, int):
                node = node.value[step]
                position = node.position
            else:
                break
        return position, node


def read(path: Path, name: str, problems: Problems) -> Node | None:
    """Reads one YAML file; None if it cannot be read."""
    try:
        data = path.read_bytes()
        text = data.decode("utf-8")
        return _Reader(text, name, problems).document()
    except OSError as error:
        problems.add(Position(name, 1, 1), f"cannot be read: {error.strerror}")
    except UnicodeDecodeError as error:
        before = data[: error.start].decode("utf-8")
        problems.add(_place(name, before), f"not UTF-8: {error.reason}; save the file as UTF-8")
    except yaml.MarkedYAMLError as error:
        fault = syntax.explain(text, error)
        problems.add(Position(name, fault.line + 1, fault.column + 1), f"not YAML: {fault.message}")
    except yaml.reader.ReaderError as error:
        if "\0" in text:
            problems.add(_place(name, text.partition("\0")[0]), "not UTF-8: zero bytes; save the file as UTF-8")
            return None
        problems.add(_place(name, text[: error.position]), f"not YAML: {error.reason}; remove the character")
    return None


def _position(name: str, mark: Any) -> Position:
    return Position(name, mark.line + 1, mark.column + 1)


def _place(name: str, before: str) -> Position:
    """Returns the position after this text."""
    return Position(name, before.count("\n") + 1, len(before) - before.rfind("\n"))


class _TooDeep(Exception):
    pass


class _Reader:
    """Builds nodes from the events of the YAML parser, which contain the positions of anchors and aliases."""

    def __init__(self, text: str, file: str, problems: Problems) -> None:
        self.get = syntax.LOADER(text).get_event
        self.file = file
        self.problems = problems
        self.anchors: dict[str, Node] = {}
        self.event: Any = None

    def next(self) -> Any:
        self.event = self.get()
        return self.event

    def document(self) -> Node | None:
        self.next()
        if isinstance(self.next(), yaml.StreamEndEvent):
            self.problem(1, 1, "the file is empty; write its content, or remove it")
            return None
        try:
            root = self.node(self.next(), 0)
        except _TooDeep:
            self.complain(f"nested more than {MAX_DEPTH} deep; is a bracket missing?")
            return None
        self.next()
        if not isinstance(self.next(), yaml.StreamEndEvent):
            self.complain("a second document begins here; write one document per file")
            return None
        return root

    def problem(self, line: int, column: int, message: str) -> None:
        self.problems.add(Position(self.file, line, column), message)

    def complain(self, message: str) -> None:
        """Reports a problem at the current event."""
        self.problems.add(_position(self.file, self.event.start_mark), message)

    def node(self, event: Any, depth: int, item: bool = False) -> Node:
        position = _position(self.file, event.start_mark)
        if isinstance(event, yaml.AliasEvent):
            self.complain(f"aliases (*{event.anchor}) are not supported; write the value out, or put text in quotes")
            return Node(self.anchors[event.anchor].value if event.anchor in self.anchors else None, position)
        if event.anchor is not None:
            self.complain(f"anchors (&{event.anchor}) are not supported; remove it, or put text in quotes")
        if event.tag is not None:
            self.complain(f"tags (!{event.tag.removeprefix('!')}) are not supported; remove it, or put text in quotes")
        if depth > MAX_DEPTH:
            raise _TooDeep
        if isinstance(event, yaml.ScalarEvent):
            self.check(event.value)
            node = Node(event.value if event.style else self.scalar(event.value), position)
        elif isinstance(event, yaml.SequenceStartEvent):
            node = Node(list(self.sequence(depth)), position)
        else:
            node = self.mapping(position, depth, item)
        if event.anchor is not None:
            self.anchors[event.anchor] = node
        return node

    def check(self, text: str) -> None:
        """Reports control characters except line breaks, which some languages reject even in comments."""
        if not text.isprintable():
            for sign in sorted({c for c in text if c != "\n" and unicodedata.category(c) in _CONTROLS}):
                name = unicodedata.name(sign, "a control character").lower()
                self.complain(f"the text contains U+{ord(sign):04X}, {name}; remove it")

    def scalar(self, text: str) -> Any:
        plain = _rewritten(text)
        if plain is None:
            return _scalar(text)
        self.complain(f"{text} is not a plain number; write {plain}, or put it in quotes if it is text")
        return _scalar(plain.split()[0])

    def sequence(self, depth: int) -> Iterator[Node]:
        while not isinstance(event := self.next(), yaml.SequenceEndEvent):
            yield self.node(event, depth + 1, item=True)

    def mapping(self, position: Position, depth: int, item: bool) -> Node:
        mapping: dict[str, Node] = {}
        keys: dict[str, Position] = {}
        merged = False  # with the next item, whose '- ' is missing: its other keys are also duplicates
        while not isinstance(event := self.next(), yaml.MappingEndEvent):
            place = _position(self.file, event.start_mark)
            if not isinstance(event, yaml.ScalarEvent) or event.anchor is not None or event.tag is not None:
                self.complain("a key must be a plain word")
                self.node(event, depth + 1)
                self.node(self.next(), depth + 1)
                continue
            self.check(key := event.value)
            plain = not event.style
            value = self.node(self.next(), depth + 1)
            if key == "<<" and plain:
                self.problems.add(place, "merge keys (<<) are not supported; write the keys out")
                continue
            if key in mapping:
                again = item and key == next(iter(mapping))
                remedy = "put '- ' before it to begin another item" if again else "remove one"
                if not merged:
                    self.problems.add(place, f"duplicate key '{key}', first on line {keys[key].line}; {remedy}")
                merged = merged or again
                continue
            keys[key] = place
            mapping[key] = value
        return Node(mapping, position, keys)


def parse_number(text: str) -> int | float:
    """Converts a number as it is written in a specification."""
    value: int | float = _scalar(text)
    return value


def _scalar(text: str) -> Any:
    """Converts a plain scalar: null, true and false as in YAML 1.2, numbers as in JSON or hexadecimal.

    >>> [_scalar(t) for t in ("true", "True", "yes", "~", "null", "", "0x1F", "12:30", "-3", "1e3", "0.5")]
    [True, 'True', 'yes', None, None, None, 31, '12:30', -3, 1000.0, 0.5]
    """
    if text[:1] not in _NUMERIC or len(text) > MAX_DIGITS:
        return _WORDS.get(text, text)
    if _DECIMAL.fullmatch(text):
        return int(text)
    if _HEXADECIMAL.fullmatch(text):
        return int(text, 16)
    if _FLOAT.fullmatch(text) and math.isfinite(number := float(text)):
        return number
    return text


def _rewritten(text: str) -> str | None:
    """Returns an unambiguous form of a number that programs read in different ways; None if it already has one.

    >>> [_rewritten(t) for t in ("0211", "0o17", "1_000", ".5", "1.", "+7", "-007.50", "0X1F", "0b11")]
    ['211 or 0x211', '15', '1000', '0.5', '1', '7', '-7.50', '0x1F', '3']
    >>> [t for t in ("7", "-0.5e-3", "0x1F", "12:30", "1.2.3", "_1", "0b2", ".", "e5") if _rewritten(t)]
    []
    """
    if text[:1] not in _NUMERIC or len(text) > MAX_DIGITS:
        return None
    plain = _SEPARATOR.sub("", text).removeprefix("+")
    if _FLOAT.fullmatch(plain) or _HEXADECIMAL.fullmatch(plain):
        return plain if plain != text else None
    if octal := re.fullmatch(r"0+([0-9]+)", plain):
        return f"{octal[1]} or 0x{octal[1]}"
    if re.fullmatch(r"0X[0-9A-Fa-f]+", plain):
        return f"0x{plain[2:]}"
    if re.fullmatch(r"0[oO][0-7]+|0[bB][01]+", plain):
        return str(int(plain, 0))
    if number := _BARE.fullmatch(plain):
        sign, whole, fraction, exponent = number.groups(default="")
        return sign + (whole or "0") + fraction.rstrip(".") + exponent
    return None


@dataclass(frozen=True, slots=True)
class Document:
    kind: str  # the schema that validates it
    path: str  # relative to the folder of its specification
    root: Node
