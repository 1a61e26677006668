"""Complete packets: the forms of a command, each as a packet ready to be sent, and the meaning of each byte."""

from __future__ import annotations

import re
from collections.abc import Iterable

from mipgen import model as m
from mipgen.lower import codec

from . import examples
from .fields import length
from .places import Page
from .text import code, spaced, table


def forms(page: Page, f: m.Field) -> str:
    """Lists the forms of a command, one for each function or just one: packets with typical values, and the replies. A
    function that no device is known to accept has no packet."""
    samples = page.index.samples
    headings = ["Packet", "Required parameters", "Optional parameters", "Field length", "Reply"]
    rows = []
    for c in f.calls:
        sent = any(x is c for x in samples.sent(f))
        function = [f"{code(c.function.name)} ({c.function.letter}, 0x{c.function.value:02X})"] if c.function else []
        rows.append([
            *function,
            code(spaced(samples.packet(f, c))) if sent else "no device is known to accept it",
            ", ".join(code(p.name) for p in c.required),
            ", ".join(code(p.name) for p in c.optional),
            length(c.required, 3 if c.function else 2),
            _reply(page, f, c.function),
        ])  # fmt: skip
    return table(rows, ["Function", *headings] if f.functions else headings)


def _reply(page: Page, f: m.Field, function: m.Function | None) -> str:
    if function is not None and not function.reply:
        return "none"
    acknowledge = "acknowledge or none" if f.silent_when or f.silenced_by else "acknowledge"
    responses = page.model.responses(f) if function is None or function.responds else ()
    return ", ".join([acknowledge, *([" or ".join(map(page.link, responses))] if responses else [])])


# --------------------------------------------------------------------------- byte by byte


def ruler(page: Page, f: m.Field) -> str:
    """Shows the parts of a packet with typical values; the bytes of parameters link to the descriptions."""
    samples, model = page.index.samples, page.model
    data = samples.data(f, examples.typical(page, f))
    head = b""
    if f.role == m.RESPONSE:
        command = model.commands(f)[0]
        packet = acknowledge(model, command, model.protocol.ack_code.values[0].value, (f.descriptor, data))
        head = packet[4:8]
    else:
        packet = samples.packet(f, examples.typical(page, f))
    s = model.set(packet[2])
    number = code(f"{packet[2]:02X}")
    parts = [code(spaced(packet[:2])), page.link(s, number) if s else number, code(spaced(packet[3:4]))]
    if head:
        parts.append(page.link(model.protocol.acknowledge, code(spaced(head))))
    parts.append(code(spaced(packet[4 + len(head) :][:2])))
    parts += [f"[{code(spaced(piece.data))}](#{anchor})" for piece, anchor in _anchored(page, f)]
    return " ".join([*parts, code(spaced(packet[-2:]))])


def _anchored(page: Page, f: m.Field) -> Iterable[tuple[examples.Piece, str]]:
    for piece in examples.pieces(page, f):
        if piece.data:
            yield piece, f"{f.full_name}.{path(piece)}"


def path(piece: examples.Piece) -> str:
    """Returns the path of the parameter whose value or element a piece shows.

    >>> path(examples.Piece(b"", "`list[2].rate`", ""))
    'list.rate'
    """
    return re.sub(r"\[\d+\]", "", piece.name.strip("`"))


# --------------------------------------------------------------------------- replies


def replies(page: Page, f: m.Field) -> str:
    """Shows the packets that acknowledge and reject a command; empty if the device never replies. Packets with a
    response that the command defines are shown with that response."""
    if f.functions and not any(x.reply for x in f.functions):
        return ""
    first, second, *_ = page.model.protocol.ack_code.values
    asks = page.model.replies(f)
    said = []
    if not asks or f.silent_when or (f.functions and any(not x.responds for x in f.functions if x.reply)):
        said.append(f"Acknowledged: {code(spaced(acknowledge(page.model, f, first.value)))}.")
    for r in (r for reply in asks for r in reply.layouts if r.command != f.name):
        packet = acknowledge(page.model, f, first.value, (r.descriptor, page.index.samples.data(r)))
        said.append(f"Acknowledged, with {page.link(r)}: {code(spaced(packet))}.")
    which = page.link(page.model.protocol.acknowledge, "code")
    rejected = code(spaced(acknowledge(page.model, f, second.value)))
    said.append(f"Rejected, with a {which} such as {code(second.name)} (0x{second.value:02X}): {rejected}.")
    return " ".join(said)


def acknowledge(model: m.Model, f: m.Field, value: int, *responses: tuple[int, bytes]) -> bytes:
    """Builds a packet that acknowledges or rejects a command, with further fields."""
    ack = model.protocol.acknowledge
    return codec.build(model, f.set, [(ack.descriptor, bytes([f.descriptor, value])), *responses])
