"""Edits hand-written YAML files: everything else in them stays as it is, byte by byte."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Any

from ..binding import MissingExtra
from ..errors import Failure

WIDTH = 115


class YamlFile:
    """A file with a mapping: its nodes with their positions in the text, and the changes to it."""

    def __init__(self, path: Path) -> None:
        """Reads a file. Raises Failure if it cannot be read."""
        self.path = path
        self.text = contents(path)
        self.root = composed(self.text, path, "; `mipgen validate` explains it")
        if kind_of(self.root) != "mapping" or not self.root.value:
            raise Failure(f"{path}:1:1: this is not a device file; write `extend: DEVICE`, or remove it")
        #: The beginning and end of each edit, its order among edits at the same position, and the new text.
        self._edits: list[tuple[int, int, int, str]] = []

    def place(self, node: Any) -> str:
        return f"{self.path}:{node.start_mark.line + 1}:{node.start_mark.column + 1}"

    def get(self, key: str, kind: str) -> Any:
        """Returns the value of a key of the file; None if there is none. Raises Failure if it is of another kind."""
        node = child(self.root, key)
        if node is not None and kind_of(node) != kind:
            what = {"mapping": "a mapping", "sequence": "a list", "scalar": "one word"}[kind]
            raise Failure(f"{self.place(node)}: '{key}' must be {what}; `mipgen validate` explains it")
        return node

    # ----------------------------------------------------------------- changes

    def replace(self, node: Any, text: str) -> None:
        start, end = node.start_mark.index, self.end(node)
        if end <= start:  # the value is empty
            start, text = end, f" {text}"
        self._edit(start, end, text)

    def add_item(self, sequence: Any, block: list[str], flow: str) -> None:
        """Adds an item at the end of a list: its lines, or the same in one line if the list is in brackets."""
        if sequence.flow_style:
            self._add_to_flow(sequence, flow)
            return
        indent = " " * sequence.start_mark.column
        self._add_lines(sequence, [f"{indent}- {block[0]}", *(f"{indent}  {line}" for line in block[1:])])

    def add_key(self, mapping: Any, block: list[str], flow: str) -> None:
        """Adds a key at the end of a mapping."""
        if mapping.flow_style:
            self._add_to_flow(mapping, flow)
        else:
            indent = " " * mapping.start_mark.column
            self._add_lines(mapping, [f"{indent}{line}" for line in block])

    def replace_item(self, node: Any, block: list[str], flow: str) -> None:
        """Replaces an item of a list with another mapping. Comments in the old one are moved before it."""
        start, end = node.start_mark.index, self.end(node)
        if node.flow_style:
            self._edit(start, end, flow)
        else:
            self._edit(start, end, f"{self.newline}{' ' * node.start_mark.column}".join(block))
        comments = self._comments(node)
        if comments:
            line = self.text.rfind("\n", 0, start) + 1
            before = re.match(r"[ \t]*", self.text[line:])
            indent = before[0] if before else ""
            self._edit(line, line, "".join(f"{indent}{c}{self.newline}" for c in comments))

    def source(self, first: Any, last: Any) -> str:
        """Returns the original text from one node to another."""
        return self.text[first.start_mark.index : self.end(last)]

    def changed(self) -> str:
        """Returns the text with all changes."""
        text = self.text
        for start, end, _, new in sorted(self._edits, reverse=True):
            text = text[:start] + new + text[end:]
        return text

    def _edit(self, start: int, end: int, text: str, outer: bool = False) -> None:
        """Records an edit. `outer`: an addition to the file itself, which follows additions to its last item."""
        self._edits.append((start, end, len(self._edits) + 1000 * outer, text))

    @property
    def newline(self) -> str:
        return "\r\n" if "\r\n" in self.text else "\n"

    def _add_to_flow(self, node: Any, text: str) -> None:
        """Adds an item after the last one, before whatever follows it up to the bracket."""
        items = _children(node)
        at = self.end(items[-1]) if items else node.start_mark.index + 1
        self._edit(at, at, f", {text}" if items else text, node is self.root)

    def _add_lines(self, node: Any, lines: Iterable[str]) -> None:
        """Adds lines after the last line of a node, and after the comment on that line."""
        at = self.text.find("\n", self.end(node))
        at = len(self.text) if at < 0 else at - (self.text[at - 1] == "\r")
        self._edit(at, at, "".join(f"{self.newline}{line}" for line in lines), node is self.root)

    def end(self, node: Any) -> int:
        """Returns the end of a node, without the comments after it, which PyYAML counts as part of a block."""
        items = _children(node)
        if items and not node.flow_style:
            return self.end(items[-1])
        return len(self.text[: node.end_mark.index].rstrip()) if kind_of(node) == "scalar" else int(node.end_mark.index)

    def _comments(self, node: Any) -> list[str]:
        """Returns the comments within a node, also the one on its last line if PyYAML counts it as part of the node."""
        spans = [(leaf.start_mark.index, self.end(leaf)) for leaf in _leaves(node)]
        rest = "".join(self.text[before:start] for (_, before), (start, _) in pairwise(spans))
        return [c.rstrip() for c in re.findall(r"(?<!\S)#.*", rest)]


# --------------------------------------------------------------------------- nodes


def contents(path: Path) -> str:
    """Reads the text of a file. Raises Failure."""
    if path.is_char_device():  # reading it would wait
        raise Failure(f"{path} is a port, not a file")
    try:
        return path.read_bytes().decode("utf-8")
    except OSError as error:
        raise Failure(f"{path} cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise Failure(f"{path} is not a text file in UTF-8") from None


def composed(text: str, path: Path, more: str = "") -> Any:
    """Parses a YAML text into nodes with positions. Raises Failure."""
    try:
        import yaml
    except ImportError:
        raise Failure(f"{path} exists; to read it, {MissingExtra('pyyaml', 'yaml')}") from None
    try:
        return yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        place = f"{path}:{mark.line + 1}:{mark.column + 1}" if mark else str(path)
        raise Failure(f"{place}: not YAML: {error.problem}{more}") from None
    except yaml.YAMLError as error:
        raise Failure(f"{path}: not YAML: {error}") from None


def kind_of(node: Any) -> str:
    """Returns the kind of a node: mapping, sequence or scalar."""
    return getattr(node, "id", "nothing")


def _children(node: Any) -> list[Any]:
    if kind_of(node) == "mapping":
        return [part for pair in node.value for part in pair]
    return list(node.value) if kind_of(node) == "sequence" else []


def _leaves(node: Any) -> list[Any]:
    items = _children(node)
    return [leaf for item in items for leaf in _leaves(item)] if items else [node]


def child(node: Any, key: str) -> Any:
    """Returns the value of a key of a mapping; None if there is none."""
    return (
        next((value for name, value in node.value if name.value == key), None) if kind_of(node) == "mapping" else None
    )


def node_value(node: Any) -> Any:
    """Converts a node to mappings, lists and texts; numbers remain as they are written."""
    if kind_of(node) == "mapping":
        return {str(key.value): node_value(value) for key, value in node.value}
    return [node_value(item) for item in node.value] if kind_of(node) == "sequence" else node.value


def parsed_yaml(text: str, path: Path) -> Any:
    """Parses a YAML text into values."""
    return node_value(composed(text, path))


# --------------------------------------------------------------------------- writing


def scalar_text(text: str) -> str:
    """Formats a string as a YAML scalar: plain if possible, otherwise quoted.

    >>> [scalar_text(text) for text in ("3DM-GQ7-GNSS/INS", "12", "a: b", "1.0.07", "-x", "no")]
    ['3DM-GQ7-GNSS/INS', '"12"', '"a: b"', '1.0.07', '"-x"', '"no"']
    """
    usual = re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 ./()+_'-]*(, [A-Za-z0-9 ./()+_'-]+)*[.)]?", text)
    number = re.fullmatch(r"[-+.0-9][0-9_.eExXA-Fa-f+-]*", text) and not re.fullmatch(r"\d+\.\d+\.\d+", text)
    bare = text.lower() in ("true", "false", "null", "yes", "no", "on", "off", "y", "n", "~")
    return text if usual and not number and not bare and text == text.strip() else quoted(text)


def quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def flow_list(name: str, words: Iterable[str]) -> list[str]:
    """Writes a key with a list in brackets, on as many lines as needed."""
    texts = list(words)
    whole = f"{name}: [{', '.join(texts)}]"
    if len(whole) <= WIDTH - 10:
        return [whole]
    lines = [f"{name}:", "  ["]
    for i, text in enumerate(texts):
        part = text + ("]" if i == len(texts) - 1 else ",")
        if len(lines[-1]) + 1 + len(part) > WIDTH - 10:
            lines.append("  ")
        gap = "" if lines[-1] == "  [" else " "
        lines[-1] += gap + part
    return lines
