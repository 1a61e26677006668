"""The interface for authors of targets: a `Target`, the files that it makes, and the names that it defines.

docs/new-language.md describes it, and `tests/readme/test_docs_pages.py` follows that page. `conformance` states
what the target's driver in `tests/conformance` can do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields
from typing import TYPE_CHECKING, Any, TypeAlias

from .formatting import Formatter
from .naming import Grammar, Identifier

if TYPE_CHECKING:
    from mipgen.model import Device, Family, Field, Model, Set, Struct
    from mipgen.model.guides import Guide

__all__ = ["OPERATIONS", "File", "Grammar", "Identifier", "Target", "WrongTarget"]

#: Operations that the driver of a target may offer.
OPERATIONS = ("parse", "decode", "encode", "client", "live")


Filters: TypeAlias = "Mapping[str, Callable[..., Any]]"


class WrongTarget(ValueError):
    """A Target with an unknown or wrong attribute, or without a required one."""


@dataclass(frozen=True, slots=True)
class File:
    """A file to make: its path, its template, and the template's variables, or a function that makes them from the
    paths of all files before it; and the part of the specification after which it is named, if there is one."""

    path: str
    template: str
    context: Mapping[str, Any] | Callable[[Sequence[str]], Mapping[str, Any]] = field(default_factory=dict)
    of: Family | Set | Field | Struct | Device | Guide | None = None


def _all(files: Mapping[str, bytes], _: Model) -> Mapping[str, bytes]:
    return files


def _no_identifiers(_: Model) -> Iterable[Identifier]:
    return ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """A language, a format or a document that is made from a specification; `TARGET` of a target's module."""

    #: A short description, such as "C99", which `mipgen generate` shows.
    title: str
    #: Yields the files to make.
    files: Callable[[Model], Iterable[File]]
    #: The filters of its templates, by name: functions that write literals and comments.
    filters: Filters = field(default_factory=dict)
    #: Selects the files to copy, by path; by default all.
    runtime: Callable[[Mapping[str, bytes], Model], Mapping[str, bytes]] = _all
    #: What users can leave out with `--without`: by name, a pattern of the paths.
    parts: Mapping[str, str] = field(default_factory=dict)
    #: Yields every name that the output defines, with its scope, so that impossible names are found before anything
    #: is written.
    identifiers: Callable[[Model], Iterable[Identifier]] = _no_identifiers
    #: The names that the language accepts; by default all.
    grammar: Grammar | None = None
    #: Formats the output, so that templates need not care about line breaks.
    formatter: Formatter | None = None
    #: Replaces the names of the package `mip` in a text by those of another package; see `package`.
    rename: Callable[[str, str], str] | None = None
    #: True for a target that takes longer than most and is therefore started first.
    slow: bool = False
    #: Another target to make in the same process, because both derive the same from the model.
    beside: str = ""
    #: The operations that its conformance driver offers; empty if it has no driver.
    conformance: tuple[str, ...] = ()
    #: Short description of the driver's needs besides Python, a C compiler and `program`; it is then tested by
    #: `make test-all`.
    needs: str = ""
    #: The program that runs or builds the driver, if it needs one: "node". It is tested where that is installed.
    program: str = ""

    def __new__(cls, *positional: object, **named: object) -> Target:
        """Reports unknown attributes in words, before Python raises its own error."""
        needed = {f.name: f.default is MISSING and f.default_factory is MISSING for f in fields(cls)}
        for name in named:
            if name not in needed:
                raise WrongTarget(f"a Target has no attribute '{name}'; it may have {', '.join(needed)}")
        missing = [name for name, is_needed in needed.items() if is_needed and name not in named]
        if missing or positional:
            raise WrongTarget("a Target needs title and files, by name: Target(title=..., files=..., ...)")
        return object.__new__(cls)

    def __post_init__(self) -> None:
        for name, (is_valid, requirement) in _REQUIREMENTS.items():
            value = getattr(self, name)
            if not is_valid(value):
                raise WrongTarget(f"{name} must be {requirement}, not {value!r}")

    def renaming(self, package: str) -> Callable[[str], str] | None:
        """Returns a function that puts the names of a package into a text; None if nothing is to be renamed."""
        from mipgen.model import OWN_PACKAGE

        rename = self.rename
        return None if rename is None or package == OWN_PACKAGE else lambda text: rename(text, package)


def _optional(kind: type) -> Callable[[object], bool]:
    return lambda value: value is None or isinstance(value, kind)


def _text(value: object) -> bool:
    return isinstance(value, str)


def _operations(value: object) -> bool:
    return isinstance(value, tuple) and all(operation in OPERATIONS for operation in value)


_FUNCTION = "a function that takes the model"

#: The requirement of each attribute: as a test, and in words.
_REQUIREMENTS: dict[str, tuple[Callable[[object], bool], str]] = {
    "title": (lambda value: isinstance(value, str) and bool(re.fullmatch(r"\S.*", value)), "a line of text"),
    "files": (callable, _FUNCTION),
    "filters": (lambda value: isinstance(value, Mapping), "a mapping of functions by name"),
    "runtime": (callable, "a function that takes the files and the model"),
    "parts": (lambda value: isinstance(value, Mapping), "a mapping of patterns by name"),
    "identifiers": (callable, _FUNCTION),
    "grammar": (_optional(Grammar), "a Grammar"),
    "formatter": (_optional(Formatter), "a Formatter, such as mipgen.emit.formatting.RUFF"),
    "rename": (lambda value: value is None or callable(value), "a function such as mipgen.emit.package.in_source"),
    "slow": (lambda value: isinstance(value, bool), "True or False"),
    "beside": (_text, "text: the name of another target"),
    "conformance": (_operations, f"a tuple of {', '.join(map(repr, OPERATIONS))}"),
    "needs": (_text, "text: the tools of the driver, in a few words"),
    "program": (_text, "text: the name of a program that runs or builds the driver"),
}
