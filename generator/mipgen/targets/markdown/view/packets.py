"""The page about packets: what all commands and data have in common."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.lower import codec

from ..places import Page
from ..text import code, spaced, table
from .base import View
from .fields import Field


@dataclass(frozen=True)
class Packets:
    page: Page

    @cached_property
    def example(self) -> bytes:
        """The packet of the first command without selectable values, if there is one."""
        calls = ((f, c) for f in self.page.model.fields if f.role == m.COMMAND for c in f.calls)
        fixed = ((f, c) for f, c in calls if all(p.constant is not None for p in c.required))
        return next((self.page.index.samples.packet(f, c) for f, c in fixed), b"")

    @property
    def checksum(self) -> str:
        """The checksum of the example, byte by byte."""
        packet = self.example
        rows = [[packet[i], *codec.checksum(packet[: i + 1])] for i in range(len(packet[:-2]))]
        return table([[code(spaced([byte])) for byte in row] for row in rows], ["Byte", "`a`", "`b`"])

    @property
    def acknowledge(self) -> Field:
        return Field(self.page, self.page.model.protocol.acknowledge)

    @property
    def functions(self) -> str:
        rows = []
        for f in self.page.model.protocol.functions:
            reply = "none" if not f.reply else "acknowledge and response" if f.responds else "acknowledge"
            rows.append([str(f.value), f"`{f.letter}`", f"`{f.name}`", self.page.prose(f.description), reply])
        return table(rows, ["Value", "Letter", "Name", "Description", "Reply"])

    @property
    def notes(self) -> list[View[m.Chapter]]:
        return [View(self.page, chapter) for chapter in self.page.model.protocol.notes]
