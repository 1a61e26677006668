"""The interface for authors of targets: a `Target`, the files that it makes, and the names that it defines.

docs/new-language.md describes it, and `tests/readme/test_docs_pages.py` follows that page. `conformance` states
what the target's driver in `tests/conformance` can do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from .formatting import Formatter
from .naming import Grammar, Identifier

if TYPE_CHECKING:
    from mipgen.model import Device, Family, Field, Model, Set, Struct
    from mipgen.model.guides import Guide

__all__ = ["OPERATIONS", "File", "Grammar", "Identifier", "Target"]

#: Operations that the driver of a target may offer.
OPERATIONS = ("parse", "decode", "encode", "client")


Filters: TypeAlias = "Mapping[str, Callable[..., Any]]"


@dataclass(frozen=True, slots=True)
class File:
    """A file to make: its path, its template, and the template's variables, or a function that makes them from the
    paths of all files before it; and the part of the specification after which it is named, if there is one.

    Without a template, the variable `text` is the file."""

    path: str
    template: str
    context: Mapping[str, Any] | Callable[[Sequence[str]], Mapping[str, Any]] = field(default_factory=dict)
    of: Family | Set | Field | Struct | Device | Guide | None = None


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
    runtime: Callable[[Mapping[str, bytes], Model], Mapping[str, bytes]] = lambda files, _: files
    #: What users can leave out with `--without`: by name, a pattern of the paths.
    parts: Mapping[str, str] = field(default_factory=dict)
    #: Yields every name that the output defines, with its scope, so that impossible names are found before anything
    #: is written.
    identifiers: Callable[[Model], Iterable[Identifier]] = lambda _: ()
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

    def renaming(self, package: str) -> Callable[[str], str] | None:
        """Returns a function that puts the names of a package into a text; None if nothing is to be renamed."""
        from mipgen.model import OWN_PACKAGE

        rename = self.rename
        return None if rename is None or package == OWN_PACKAGE else lambda text: rename(text, package)
