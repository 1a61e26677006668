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
    symbols: Callable[[m.Model], Iterator[Symbols]]
    listed: str  # what its index of symbols lists


LANGUAGES = (
    Language(
        "C", "c", "c", c.Programs, c.symbols,
        "structures, types, functions and constants of the library `mip` for each field and type",
    ),
    Language(
        "C++", "cpp", "cpp", c.CppPrograms, c.cpp_symbols,
        "structures, enumerations and commands of the library `mip` in C++17 for each field and type",
    ),
    Language(
        "Python", "python", "py", python.Programs, python.symbols,
        "classes, constructors and constants of the package `mip_protocol` for each field and type",
    ),
    Language(
        "Rust", "rust", "rs", rust.Programs, rust.symbols,
        "types, constructors, methods and constants of the crate `mip-protocol` for each field and type",
    ),
    Language(
        "JavaScript", "javascript", "mjs", javascript.Programs, javascript.symbols,
        "classes, constructors and constants of the package `mip-protocol` for each field, enumeration and bitfield, "
        "preceded\nby the module that exports them",
    ),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Program:
    title: str
    language: str  # of the fenced block
    lines: str


def programs(samples: SampleValues, f: m.Field) -> list[Program]:
    return _each(samples, lambda of: of.command(f) if f.role == m.COMMAND else of.data(f))


def sequences(samples: SampleValues, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> list[Program]:
    """Writes programs that send several commands."""
    return _each(samples, lambda of: of.sequence(name, steps))


def _each(samples: SampleValues, write: Callable[[Programs], str]) -> list[Program]:
    return [Program(x.title, x.name, write(x.programs(samples))) for x in LANGUAGES]
