"""The clocks of timestamps in Rust, and where fields contain their time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import validity

from .. import names
from ..docs import Block, prose

_DAY = 86_400


@dataclass(frozen=True, slots=True)
class Clock:
    of: m.Clock

    @property
    def variant(self) -> str:
        return names.variant(self.of.name)

    @property
    def conversion(self) -> str:
        """The function that converts its time to UTC."""
        return f"from_{self.of.name}"

    @property
    def doc(self) -> list[Block]:
        return [prose(self.of.description or f"{self.of.title.capitalize()}.")]

    @property
    def epoch(self) -> int | None:
        return None if self.of.epoch_days is None else self.of.epoch_days * _DAY


@dataclass(frozen=True, slots=True)
class Source:
    """A field that contains the time of its packet."""

    of: validity.Timestamp

    @property
    def clock(self) -> str:
        return names.variant(self.of.clocks[0].name)

    @property
    def undated(self) -> str:
        return f"Some(Clock::{names.variant(self.of.clocks[1].name)})" if self.of.clocks[1:] else "None"

    @property
    def parts(self) -> Iterator[str]:
        for p, scale in self.of.parts:
            undated = (p, scale) in self.of.undated_parts
            kind = p.scalar.kind
            flags = {"is_float": kind == "float", "is_signed": kind == "signed", "undated": undated}
            written = ", ".join(f"{name}: {str(value).lower()}" for name, value in flags.items())
            yield f"place: {self._place(p.name)}, scale: {scale:_}, {written}"

    @property
    def readings(self) -> Iterator[tuple[tuple[str, ...], list[str], int]]:
        for r in self.of.readings:
            flags = [f"place: {self._place(f.parameter)}, mask: 0x{f.mask:02X}" for f in r.flags]
            yield r.devices, flags, r.fewer

    def _place(self, name: str) -> str:
        size, before = self.of.place(name)
        counters = [(*self.of.place(t.counter), t.size) for t in before.terms]
        arrays = [f"({place.fixed}, {length}, {element})" for length, place, element in counters]
        return f"Place {{ at: {before.fixed}, size: {size}, after: &[{', '.join(arrays)}] }}"


@dataclass(frozen=True, slots=True)
class Clocks:
    clocks: list[Clock]
    leap_seconds: list[tuple[int, int]]
    sources: list[Source]


def clocks(model: m.Model) -> Clocks:
    return Clocks(
        [Clock(c) for c in model.protocol.clocks],
        [(day * _DAY, ahead) for day, ahead in model.protocol.leaps],
        [Source(t) for t in sorted(validity.timestamps(model), key=lambda t: t.field.descriptor)],
    )
