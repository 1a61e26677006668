"""Programs that use a field, in each language."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

from mipgen import model as m
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
    remark: str = "// {}"


LANGUAGES = (
    Language("C", "c", "c", c.Programs, "/* {} */"),
    Language("C++", "cpp", "cpp", c.CppPrograms),
    Language("Python", "python", "py", python.Programs),
    Language("Rust", "rust", "rs", rust.Programs),
    Language("JavaScript", "javascript", "mjs", javascript.Programs),
)


@dataclass(frozen=True, slots=True)
class Program:
    title: str
    language: str  # of the fenced block
    lines: str


#: The language whose programs are on the pages of fields and guides. Those of the others have pages of their own, where
#: lines that all of them need stand once.
(SHOWN,) = (x for x in LANGUAGES if x.name == "python")
OTHERS = tuple(x for x in LANGUAGES if x is not SHOWN)

#: How lines begin that make a library known.
_NEEDS = ("#include", "from", "use", "import")

#: The name of a program, and how a language writes it.
Named = tuple[str, Callable[[Programs], str]]


def of_field(f: m.Field) -> Named:
    return f.full_name, lambda of: of.command(f) if f.role == m.COMMAND else of.data(f)


def of_sequence(name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> Named:
    """A program that sends several commands."""
    return name, lambda of: of.sequence(name, steps)


def shown(samples: SampleValues, named: Named) -> Program:
    """Writes the program of a page."""
    return Program(SHOWN.title, SHOWN.name, named[1](SHOWN.programs(samples)))


def listings(samples: SampleValues, named: Iterable[Named]) -> list[Program]:
    """Joins programs to one listing for each other language, each program below a comment with its name."""
    named, found = list(named), []
    for x in OTHERS:
        lines = [write(x.programs(samples)).split("\n") for _, write in named]
        same = [line for line in lines[0] if line.startswith(_NEEDS) and all(line in of for of in lines)]
        own = [[line for line in of if line not in same] for of in lines]
        parts = ["\n".join([x.remark.format(name), *of]) for (name, _), of in zip(named, own, strict=True)]
        found.append(Program(x.title, x.name, "\n\n".join(["\n".join(same), *parts] if same else parts)))
    return found
