"""Facts in the author's words: notes, uncertainties, and sections of manuals."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m

from .texts import Fact, fact, prose


def remarks(of: m.Field | m.Parameter, model: m.Model) -> Iterator[Fact]:
    """Yields facts in the author's words: notes and uncertainties."""
    yield from needed(of.needs if isinstance(of, m.Field) else ())
    yield from (fact("note", prose(note, model), "{}") for note in of.notes)
    yield from uncertain(of, model)


def needed(needs: tuple[str, ...]) -> Iterator[Fact]:
    """States the hardware that a field, a value or a bit requires."""
    if needs:
        yield fact("needs", (" and ".join(map(m.worded, needs)),), "Requires {}.")


Doubtful = m.Field | m.Family | m.Set | m.Parameter | m.Type | m.EnumValue | m.Bits | m.Device


def uncertain(of: Doubtful, model: m.Model) -> list[Fact]:
    """Returns the uncertainties, each with the known and the inferred facts."""
    return [fact("uncertain", prose(text.rstrip("."), model), "Uncertain: {}.") for text in of.uncertain]


def sources(thing: m.Field | m.Occurrence | m.Family | m.Set | m.Type | m.Device) -> list[str]:
    """Returns the manuals and sections that describe it: "3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)"."""
    return [f"{s.manual}: {s.section}" for s in thing.sources]
