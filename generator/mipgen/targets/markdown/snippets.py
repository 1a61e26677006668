"""Programs that use a field, in each language."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from mipgen import model as m
from mipgen.emit.symbols import Symbols
from mipgen.facts.sample_values import GivenValues, SampleValues
from mipgen.targets.c import api as c
from mipgen.targets.javascript import api as javascript
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust

from .places import Page


class Programs(Protocol):
    """The programs of a language."""

    def command(self, f: m.Field) -> str: ...
    def data(self, f: m.Field) -> str: ...
    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str: ...


@dataclass(frozen=True, slots=True)
class Language:
    title: str
    name: str  # in paths, and of fenced blocks
    suffix: str  # of files
    programs: Callable[[SampleValues], Programs]
    symbols: Callable[[m.Model], Iterator[Symbols]] | None = None  # what its index lists, if it has one


LANGUAGES = (
    Language("C", "c", "c", c.Programs, c.symbols),
    Language("C++", "cpp", "cpp", c.CppPrograms, c.cpp_symbols),
    Language("Python", "python", "py", python.Programs, python.symbols),
    Language("Rust", "rust", "rs", rust.Programs, rust.symbols),
    Language("JavaScript", "javascript", "mjs", javascript.Programs, javascript.symbols),
)


@dataclass(frozen=True, slots=True)
class Program:
    title: str
    language: str  # of the fenced block
    lines: str


def programs(page: Page, f: m.Field) -> list[Program]:
    return _each(page, lambda of: of.command(f) if f.role == m.COMMAND else of.data(f))


def sequences(page: Page, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> list[Program]:
    """Writes programs that send several commands."""
    return _each(page, lambda of: of.sequence(name, steps))


def _each(page: Page, write: Callable[[Programs], str]) -> list[Program]:
    return [Program(x.title, x.name, write(x.programs(page.index.samples))) for x in LANGUAGES]
