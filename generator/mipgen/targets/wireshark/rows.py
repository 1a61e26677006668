"""Rows of the tables that the dissector interprets: units, types, and the positions of bits."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m

Named = m.Enum | m.Bitfield


def units(p: m.Parameter) -> tuple[str, ...]:
    """Returns the units that are shown after values; none for plain numbers."""
    return tuple("" if unit == "1" else unit.symbol for unit in p.units) if set(p.units) - {"1"} else ()


# --------------------------------------------------------------------------- bits


@dataclass(frozen=True, slots=True)
class Place:
    """The position of bits: offset and size of some bytes of the bitfield, and a mask in the number that they form."""

    at: int
    size: int
    mask: int
    little: bool = False  # the bytes of the number are in reverse order

    @property
    def shift(self) -> int:
        return (self.mask & -self.mask).bit_length() - 1


def place(b: m.Bits, t: m.Bitfield) -> Place:
    """Returns the bytes that Wireshark shows for bits: all of a short bitfield, as few as possible of a long one.

    >>> health = m.Bitfield("h", None, 16, (), "", None)
    >>> place(m.Bits("a", 20, 23, "", False), health), place(m.Bits("b", 30, 33, "", False), health)
    (Place(at=2, size=1, mask=240, little=False), Place(at=3, size=2, mask=960, little=True))
    >>> place(m.Bits("c", 9, 9, "", False), m.Bitfield("i", m.SCALARS["u16"], 2, (), "", None))
    Place(at=0, size=2, mask=512, little=False)
    """
    if t.scalar is not None and t.size <= 4:
        return Place(0, t.size, b.mask)
    first, last = b.first // 8, b.last // 8
    size = last - first + 1
    mask = b.mask >> (8 * first)
    if t.scalar is None:
        return Place(first, size, mask, size > 1)
    return Place(t.size - 1 - last, size, mask)


def types(model: m.Model) -> list[Named]:
    """Returns every enumeration and bitfield once."""
    known = [model.protocol.function_selector, model.protocol.ack_code, *model.all_types]
    return list({t.full_name: t for t in known if isinstance(t, (m.Enum, m.Bitfield))}.values())


def structs(model: m.Model) -> list[m.Struct]:
    """Returns every structure, each after those that it contains."""
    return m.structs(model.all_types)
