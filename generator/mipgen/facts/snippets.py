"""Short programs of documentation, in languages in which each command is a statement of its own."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Protocol

from mipgen import model as m

from .sample_values import GivenValues, SampleValues, title_of


class Program(Protocol):
    """One program while it is composed, with the items that it needs of the binding."""

    def sent(self, f: m.Field, samples: SampleValues, /) -> list[str]:
        """The lines that send a command, and show a response."""
        ...

    def text(self, lines: Sequence[str], /) -> str:
        """The whole program, with its imports and declarations first."""
        ...


@dataclass(frozen=True)
class Statements(ABC):
    samples: SampleValues

    #: The beginning of a comment.
    remark: ClassVar[str] = "//"

    @abstractmethod
    def program(self) -> Program:
        """A new one."""

    def command(self, f: m.Field) -> str:
        """Sends it to a device."""
        program = self.program()
        return program.text(program.sent(f, self.samples))

    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str:
        """Sends several commands; one that is not acknowledged is an error of the language."""
        program, lines = self.program(), []
        for number, (f, given) in enumerate(steps, 1):
            lines += [f"{self.remark} {number}: {title_of(f, given)}", *program.sent(f, given)]
            lines += [f"{self.remark} {given.host}"] if given.host else []
        return program.text(lines)
