"""Turns words into identifiers, escapes keywords, and finds collisions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

from .model import Position
from .problems import Problems


def upper(words: str) -> str:
    """
    >>> upper("gps_time_update")
    'GPS_TIME_UPDATE'
    """
    return words.upper()


@cache
def pascal(words: str) -> str:
    """
    >>> pascal("gps_time_update"), pascal("3dm"), pascal("matrix3f")
    ('GpsTimeUpdate', '3dm', 'Matrix3f')
    >>> pascal("gnss_1"), pascal("port_2_3")
    ('Gnss1', 'Port2_3')
    """
    out = ""
    for word in words.split("_"):
        joint = "_" if out and out[-1].isdigit() and word[:1].isdigit() else ""
        out += joint + word[:1].upper() + word[1:]
    return out


@dataclass(frozen=True, slots=True)
class Escape:
    """Makes a name legal in a language.

    >>> e = Escape(frozenset({"default"}), suffix="_", digit_prefix="mip_")
    >>> e("default"), e("3dm"), e("ping")
    ('default_', 'mip_3dm', 'ping')
    """

    keywords: frozenset[str]
    suffix: str = "_"
    digit_prefix: str = "_"

    def __call__(self, name: str) -> str:
        if name[:1].isdigit():
            name = self.digit_prefix + name
        return name + self.suffix if name in self.keywords else name


@dataclass(frozen=True, slots=True)
class Identifier:
    """A name that a target puts into a scope of its language."""

    scope: str
    name: str
    what: str  # in the words of the specification
    position: Position | None


def judge(target: str, identifiers: Iterable[Identifier], longest: int | None, problems: Problems) -> None:
    """Reports the names that a language cannot have; `longest`: how many characters of a name count, if limited."""
    found = list(identifiers)
    collisions(target, found, problems)
    if longest is not None:
        lengths(target, found, longest, problems)


def lengths(target: str, identifiers: Iterable[Identifier], longest: int, problems: Problems) -> None:
    """No name may be longer; of the names that one thing gives rise to, the longest is reported."""
    worst: dict[tuple[str, Position | None], Identifier] = {}
    for i in identifiers:
        other = worst.setdefault((i.what, i.position), i)
        if len(i.name) > len(other.name):
            worst[i.what, i.position] = i
    for i in worst.values():
        if len(i.name) > longest:
            problems.add(
                i.position,
                f"'{i.what}' becomes {i.name}, and the target {target} looks at {longest} of its {len(i.name)} "
                "characters; give it, or what it belongs to, a shorter name with 'short'",
            )


def collisions(target: str, identifiers: Iterable[Identifier], problems: Problems) -> None:
    """Two things of the specification must not get the same name in a language."""
    seen: dict[tuple[str, str], Identifier] = {}
    for i in identifiers:
        other = seen.setdefault((i.scope, i.name), i)
        if other is not i:
            problems.add(
                i.position,
                f"'{i.what}' and '{other.what}' both become {i.name} in {i.scope} of the target {target}; rename one",
            )
