"""Complaints about a specification, each with its place."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass

from .errors import Failure
from .model import Position


@dataclass(frozen=True, slots=True, order=True)
class Problem:
    file: str
    line: int
    column: int
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: error: {self.message}"


class Problems:
    """Collects what is wrong, so that an author sees all of it in one run."""

    def __init__(self) -> None:
        self._found: set[Problem] = set()

    def add(self, position: Position | None, message: str) -> None:
        at = position or Position("<spec>", 1, 1)
        self._found.add(Problem(at.file, at.line, at.column, message))

    def __bool__(self) -> bool:
        return bool(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def sorted(self) -> list[Problem]:
        return sorted(self._found)

    def raise_if_any(self) -> None:
        if self._found:
            raise SpecError(self.sorted())


class SpecError(Failure):
    """The specification cannot be used; `problems` says why."""

    def __init__(self, problems: list[Problem]) -> None:
        super().__init__("")
        self.problems = problems

    def __str__(self) -> str:
        return "\n".join(map(str, self.problems))


def nearest(word: str, choices: Iterable[str]) -> str:
    """A remedy for a misspelt word.

    >>> nearest("discription", ["description", "title"])
    ", did you mean 'description'?"
    >>> nearest("zzz", ["b", "a"])
    '; known: a, b'
    >>> nearest("zzz", [])
    ''
    """
    known = sorted(set(choices))
    close = difflib.get_close_matches(word, known, n=1)
    if close:
        return f", did you mean '{close[0]}'?"
    if not known:
        return ""
    return "; known: " + ", ".join(known[:12]) + (", …" if len(known) > 12 else "")
