"""Positions in a specification, problems there, and remedies for unknown words."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple

from mipgen.base.errors import Failure

from . import spelling

#: The maximum number of words in a list.
MANY = 60


class Position(NamedTuple):
    """A position in a specification file; lines and columns count from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True, slots=True, order=True)
class Problem:
    file: str
    line: int
    column: int
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: error: {self.message}"


class Problems:
    """Collects problems, so that an author sees all of them in one run."""

    def __init__(self) -> None:
        self._problems: set[Problem] = set()

    def add(self, position: Position | None, message: str) -> None:
        at = position or Position("<spec>", 1, 1)
        self._problems.add(Problem(at.file, at.line, at.column, message))

    def __bool__(self) -> bool:
        return bool(self._problems)

    def __len__(self) -> int:
        return len(self._problems)

    def sorted(self) -> list[Problem]:
        return sorted(self._problems)

    def raise_if_any(self) -> None:
        if self._problems:
            raise SpecError(self.sorted())


def elsewhere(thing: Any) -> str:
    """States where the other one of two equal things is."""
    return f"the other at {thing.position}"


class SpecError(Failure):
    """The specification cannot be used; `problems` states the reasons."""

    def __init__(self, problems: list[Problem]) -> None:
        super().__init__("")
        self.problems = problems

    def __str__(self) -> str:
        return "\n".join(map(str, self.problems))


def nearest(word: str, choices: Iterable[str], guess: bool = True) -> str:
    """Writes the remedy for an unknown word: the word that was probably meant, else all known words.

    With `guess`, a similar word is suggested.

    >>> nearest("discription", ["description", "title"])
    ", did you mean 'description'?"
    >>> nearest("int16_t", ["u8", "s16"])
    ", did you mean 's16'?"
    >>> nearest("mm", ["m", "s"], guess=False)
    '; known: m, s'
    >>> nearest("zzz", [])
    ''
    """
    words = _ordered(choices)
    return close(word, words, guess) or spelling.strange(word, "".join(words)) + _listed(word, words)


def close(word: str, choices: Iterable[str], guess: bool = True) -> str:
    """Returns the word that was probably meant; empty if there is none."""
    words = _ordered(choices)
    if usual := spelling.usual_word(word, words):
        return f", did you mean '{usual}'?"
    straight = spelling.straight(word)
    similar = [straight] if straight in words else difflib.get_close_matches(straight, words, n=1) if guess else []
    return f"{spelling.strange(word, ''.join(words))}, did you mean '{similar[0]}'?" if similar else ""


def _ordered(choices: Iterable[str]) -> list[str]:
    """Returns the words without duplicates, in their order; sets are sorted."""
    return sorted(choices) if isinstance(choices, (set, frozenset)) else list(dict.fromkeys(choices))


def _listed(word: str, words: list[str]) -> str:
    """
    >>> many = [f"{s}.field_{i}" for s in ("base", "filter") for i in range(MANY)]
    >>> _listed("fliter.x", many)
    '; known sets: base, filter'
    >>> _listed("base.x", ["base.one", *many[-MANY:]])
    "; known in the set 'base': base.one"
    """
    if not words:
        return ""
    if len(words) <= MANY:
        return f"; known: {', '.join(words)}"
    owners = list(dict.fromkeys(k.partition(".")[0] for k in words))
    owner = word.partition(".")[0]
    if owner in owners and len(owners) > 1:
        return f"; known in the set '{owner}': {', '.join(k for k in words if k.partition('.')[0] == owner)}"
    if len(owners) < len(words):
        return f"; known sets: {', '.join(owners)}"
    return f"; known: {', '.join(words[:MANY])}, … ({len(words)} in all)"
