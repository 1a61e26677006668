"""Converts words to identifiers, escapes keywords, and finds names that a language does not allow."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache

from mipgen import model as m
from mipgen.read.problems import Position, Problems


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


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.ASCII)


@dataclass(frozen=True, slots=True)
class Grammar:
    """The identifiers that a language accepts.

    >>> g = Grammar(r"[a-z]\\w*", frozenset({"if"}))
    >>> g.fault("x1"), g.fault("1x"), g.fault("if")
    ('', 'is not an identifier', 'is a keyword')
    """

    pattern: str  # a regular expression for a whole name
    keywords: frozenset[str] = frozenset()
    longest: int | None = None  # the number of significant characters, if that is limited; longer names are allowed

    def fault(self, name: str) -> str:
        """Explains why a name is not allowed; empty if it is."""
        if not _compiled(self.pattern).fullmatch(name):
            return "is not an identifier"
        return "is a keyword" if name in self.keywords else ""


@dataclass(frozen=True, slots=True)
class Identifier:
    """A name that a target defines in a scope of its language."""

    scope: str
    name: str
    what: str  # in the words of the specification
    position: Position | None
    word: bool = True  # True: an identifier of the language; False: the name of a file, a feature or the like


def judge(target: str, identifiers: Iterable[Identifier], grammar: Grammar | None, problems: Problems) -> None:
    """Reports the names that a language does not allow."""
    names = list(identifiers)
    collisions(target, names, problems)
    if grammar is not None:
        words = [i for i in names if i.word]
        invalid(target, words, grammar, problems)
        if grammar.longest is not None:
            check_lengths(target, words, grammar.longest, problems)


def invalid(target: str, identifiers: Iterable[Identifier], grammar: Grammar, problems: Problems) -> None:
    """Reports names that are not identifiers of the language, or that are its keywords."""
    for i in identifiers:
        fault = grammar.fault(i.name)
        if fault:
            problems.add(
                i.position,
                f"'{i.what}' becomes '{i.name}' in {i.scope}; this {fault} in the target {target}: rename it, "
                "or let the target escape it",
            )


def check_lengths(target: str, identifiers: Iterable[Identifier], longest: int, problems: Problems) -> None:
    """Reports names with the same first `longest` characters; of the names of one thing, only the first."""
    seen: dict[tuple[str, str], Identifier] = {}
    reported: set[tuple[str, Position | None]] = set()
    for i in identifiers:
        other = seen.setdefault((i.scope, i.name[:longest]), i)
        if other.name != i.name and (i.what, i.position) not in reported:
            reported.add((i.what, i.position))
            problems.add(
                i.position,
                f"'{i.what}' becomes {i.name}, and the target {target} distinguishes only the first {longest} "
                f"characters, which are also those of {other.name}; use 'short' to define a shorter name "
                "for it or its parent",
            )


#: The names that Windows reserves for devices, whatever their case and what follows a point.
_DEVICES = {"aux", "con", "nul", "prn", *(f"{port}{n}" for port in ("com", "lpt") for n in range(10))}


def judge_paths(target: str, paths: Iterable[Identifier], problems: Problems) -> None:
    """Reports files that get the same path, on any system, and paths that Windows does not allow."""
    seen: dict[str, Identifier] = {}
    reserved: set[str] = set()  # the parts that have been reported: a folder can have many files
    for i in paths:
        other = seen.setdefault(i.name.casefold(), i)
        if other is not i:
            same = f"both become {i.name} in the files of the target {target}"
            differ = f"become {i.name} and {other.name} in the files of the target {target}, which are the same file "
            how = same if i.name == other.name else f"{differ}where case makes no difference"
            problems.add(i.position, f"'{i.what}' and '{other.what}' {how}; rename one")
        for part in i.name.split("/"):
            if part.partition(".")[0].casefold() in _DEVICES and part not in reserved:
                reserved.add(part)
                problems.add(
                    i.position,
                    f"'{i.what}' becomes {i.name} in the files of the target {target}, but Windows reserves {part}; "
                    "rename it",
                )


def collisions(target: str, identifiers: Iterable[Identifier], problems: Problems) -> None:
    """Reports things in the specification that get the same name in a language."""
    seen: dict[tuple[str, str], Identifier] = {}
    for i in identifiers:
        other = seen.setdefault((i.scope, i.name), i)
        if other is not i:
            problems.add(
                i.position or other.position,
                f"'{i.what}' and '{other.what}' both become {i.name} in {i.scope} of the target {target}; rename one",
            )


#: The names inside a class: in the language, and in the specification with its position there.
Attributes = Callable[[m.Type | m.Field], Iterable[tuple[str, str, m.Position | None]]]


@dataclass(frozen=True, slots=True)
class Classes:
    module: Callable[[str], str]  # the module of a family
    legal: Callable[[str], str]  # makes a name legal for a class

    def name(self, thing: m.Type | m.Field) -> str:
        name = pascal(thing.name)
        return name if self.home(thing) == "protocol" else self.legal(name)

    def home(self, thing: m.Type | m.Field) -> str:
        """Returns the module that defines a thing."""
        if isinstance(thing, m.Field):
            return self.module(thing.family) if thing.set else "protocol"
        if thing.name == "function_selector":  # a specification cannot define this type
            return "protocol"
        return self.module(thing.owner) if thing.owner else "types"

    def qualified(self, thing: m.Type | m.Field) -> str:
        """Returns the name of a thing in a module that imports its module: `types.AckCode`."""
        return f"{self.home(thing)}.{self.name(thing)}"

    def reference(self, thing: m.Type | m.Field, where: str) -> str:
        """Returns the name of a thing in the module `where`. All modules import the names of `protocol`."""
        return self.name(thing) if self.home(thing) in (where, "protocol") else self.qualified(thing)

    def identifiers(self, model: m.Model, attributes: Attributes) -> Iterator[Identifier]:
        """Yields the classes of all modules, and the names inside them."""
        modules = [("types", model.types), *((x.name, (*x.types, *x.fields)) for x in model.families)]
        for scope, things in modules:
            for t in things:
                yield Identifier(f"module {scope}", self.name(t), f"{scope}.{t.name}", t.position)
                for name, words, position in attributes(t):
                    yield Identifier(f"class {scope}.{t.name}", name, words, position or t.position)
