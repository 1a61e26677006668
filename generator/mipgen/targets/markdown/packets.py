"""Whole packets: what their bytes are, and packets that are ready to be sent."""

from __future__ import annotations

from mipgen import model as m
from mipgen.lower import codec

from . import examples
from .fields import length
from .offsets import layout
from .places import Page
from .text import code, spaced, table

#: More parameters are one cell of the row of bytes.
SHOWN = 8


def packet_row(page: Page, f: m.Field) -> str:
    """A packet with nothing but this field, part by part."""
    rows = [row for row in layout(f) if row.parameter in f.parameters]
    whole = length(f.parameters)
    size = f"{int(whole):02X}" if whole.isdigit() else "LL"
    parts = [
        ("Sync", code(spaced(page.model.protocol.sync))),
        ("Set", "any data set" if f.everywhere else " or ".join(code(f"{number:02X}") for number in f.sets)),
        ("Payload length", code(size)),
        ("Field length", code(size)),
        ("Descriptor", code(f"{f.descriptor:02X}")),
    ]
    if len(rows) <= SHOWN:
        for row in rows:
            bytes_ = str(row.size) if row.size is not None else ""
            parts.append((code(row.name), _bytes(bytes_)))
    else:
        parts.append((f"{len(rows)} parameters", f"{int(whole) - 2} bytes" if whole.isdigit() else "n bytes"))
    parts.append(("Checksum", "2 bytes"))
    return table([[cell for _, cell in parts]], [name for name, _ in parts])


def _bytes(size: str) -> str:
    if not size:
        return "the rest"
    return f"{size} byte{'' if size == '1' else 's'}" if size.isdigit() else f"{code(size)} bytes"


def ready_packets(page: Page, f: m.Field) -> str:
    """For each function that a device takes a packet that can be sent as it is."""
    rows = []
    for c in page.index.samples.sent(f):
        pieces = examples.said(page, f, page.index.samples.values(f, c))
        function = f"{code(c.function.name)} (0x{c.function.value:02X})" if c.function else ""
        given = ", ".join(f"{piece.name} = {piece.value}" for piece in pieces if piece.value)
        if len(pieces) > SHOWN:
            given = f"{len(pieces)} values"
        rows.append([code(spaced(page.index.samples.packet(f, c))), function, given])
    return table(rows, ["Packet", "Function", "Values"])


def acknowledge(model: m.Model, f: m.Field, value: int, *responses: tuple[int, bytes]) -> bytes:
    """A packet that acknowledges a command, or refuses it, and what follows in it."""
    ack = model.protocol.acknowledge
    return codec.build(model, f.set, [(ack.descriptor, bytes([f.descriptor, value])), *responses])
