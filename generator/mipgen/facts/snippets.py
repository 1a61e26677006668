"""Short programs for documentation, in languages in which each command is a separate statement.

The programs of C++ are in `targets/c/cpp_snippets`. `tests/docs/test_reference_programs.py` compiles and runs each
program.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Protocol

from mipgen import model as m

from .sample_values import GivenValues, SampleValues, title_of


class Program(Protocol):
    """A program while it is composed, with the items of the binding that it needs."""

    def sent(self, f: m.Field, samples: SampleValues, /) -> list[str]:
        """Returns the lines that send a command and show its response."""
        ...

    def text(self, lines: Sequence[str], /) -> str:
        """Returns the complete program, with its imports and declarations first."""
        ...


@dataclass(frozen=True)
class Statements(ABC):
    samples: SampleValues

    #: The characters that begin a comment.
    remark: ClassVar[str] = "//"

    @abstractmethod
    def program(self) -> Program:
        """Begins a new program."""

    def command(self, f: m.Field) -> str:
        """Composes a program that sends a command to a device."""
        program = self.program()
        return program.text(program.sent(f, self.samples))

    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str:
        """Composes a program that sends several commands; a NACK is an error of the language."""
        program, lines = self.program(), []
        for number, (f, values) in enumerate(steps, 1):
            lines += [f"{self.remark} {number}: {title_of(f, values)}", *program.sent(f, values)]
            lines += [f"{self.remark} {values.host}"] if values.host else []
        return program.text(lines)
