"""Reads hand-written YAML files; reports each mistake with its position and the remedy."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from ..binding import MissingExtra
from ..errors import Failure


class Wrong(Exception):
    """A mistake at a node of the file."""

    def __init__(self, node: Any, text: str) -> None:
        super().__init__(text)
        self.node = node


class YamlReader:
    """Collects the mistakes of a file."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.mistakes: list[str] = []

    def root(self, otherwise: str) -> Any:
        """Parses the file into nodes with positions. Raises Failure if it is no mapping, with the words `otherwise`."""
        try:
            import yaml
        except ImportError:
            raise Failure(f"{self.path} exists; to read it, {MissingExtra('pyyaml', 'yaml')}") from None
        if self.path.is_char_device():  # reading it would wait
            raise Failure(f"{self.path} is a port, not a file")
        try:
            root = yaml.compose(self.path.read_bytes().decode("utf-8"), Loader=yaml.SafeLoader)
        except OSError as error:
            raise Failure(f"{self.path} cannot be read: {error.strerror}") from None
        except UnicodeDecodeError:
            raise Failure(f"{self.path} is not a text file in UTF-8") from None
        except yaml.MarkedYAMLError as error:
            mark = error.problem_mark
            place = f"{self.path}:{mark.line + 1}:{mark.column + 1}" if mark else str(self.path)
            raise Failure(f"{place}: not YAML: {error.problem}") from None
        except yaml.YAMLError as error:
            raise Failure(f"{self.path}: not YAML: {error}") from None
        if kind_of(root) != "mapping":
            raise Failure(f"{self.path}:1:1: this is not {otherwise}")
        return root

    def end(self) -> None:
        """Raises Failure with all mistakes, if there are any."""
        if self.mistakes:
            raise Failure("\n".join(self.mistakes))

    def wrong(self, mistake: Wrong) -> None:
        self.mistakes.append(f"{self.place(mistake.node)}: {mistake}")

    def place(self, node: Any) -> str:
        return f"{self.path}:{node.start_mark.line + 1}:{node.start_mark.column + 1}"

    def keys(self, node: Any, allowed: Iterable[str], what: str) -> dict[str, Any]:
        """Returns the values of a mapping by key. Unknown keys are mistakes."""
        nodes: dict[str, Any] = {}
        names = list(allowed)
        for key, value in self.pairs(node, what):
            if key.value in names:
                nodes[key.value] = value
            else:
                self.wrong(Wrong(key, f"{what} has no '{key.value}'{hint(key.value, names)}"))
        return nodes

    def pairs(self, node: Any, what: str) -> list[tuple[Any, Any]]:
        """Returns the keys and values of a mapping. Repeated keys are mistakes."""
        if kind_of(node) != "mapping":
            if kind_of(node) == "scalar" and node.value in ("", "~", "null"):
                return []
            self.wrong(Wrong(node, f"{what} needs keys with values, {{name: value}}"))
            return []
        seen: dict[str, Any] = {}
        for key, _ in node.value:
            if kind_of(key) != "scalar":
                self.wrong(Wrong(key, "a key must be one word"))
            elif key.value in seen:
                line = seen[key.value].start_mark.line + 1
                self.wrong(Wrong(key, f"'{key.value}' is already on line {line}; remove one"))
            else:
                seen[key.value] = key
        return [(key, value) for key, value in node.value if seen.get(key.value) is key]


def hint(word: str, candidates: Iterable[str], otherwise: str = "") -> str:
    near = get_close_matches(word, list(candidates), n=3)
    return f"; did you mean {' or '.join(map(repr, near))}?" if near else otherwise or "; remove it"


def kind_of(node: Any) -> str:
    """Returns the kind of a node: mapping, sequence or scalar."""
    return getattr(node, "id", "nothing")
