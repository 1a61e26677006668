"""How a device answers a command: acknowledged, with a response, or refused."""

from __future__ import annotations

from mipgen import model as m

from .packets import acknowledge
from .places import Page
from .text import code, spaced, table


def answers(page: Page, f: m.Field) -> str:
    """The packets with which a command may be answered, their responses with typical values."""
    codes = page.model.protocol.ack_code.values
    rows = []
    if f.functions and not any(x.reply for x in f.functions):
        return ""
    asks = page.model.replies(f)
    plain = not asks or (f.functions and any(not x.responds for x in f.functions if x.reply))
    if plain or f.silent_when:
        rows.append(["Acknowledge", _packet(page, f, codes[0].value)])
    for reply in asks:
        for r in reply.layouts:
            data = page.index.samples.data(r)
            with_data = code(spaced(acknowledge(page.model, f, codes[0].value, (r.descriptor, data))))
            rows.append([f"Acknowledge and {page.link(r)}", with_data])
    return table(rows, ["Reply", "Packet"])


def rejected(page: Page, f: m.Field) -> str:
    """A packet with which a device rejects a command, and the name of its code."""
    first = page.model.protocol.ack_code.values[1]
    return f"{code(first.name)} (0x{first.value:02X}): {_packet(page, f, first.value)}"


def _packet(page: Page, f: m.Field, value: int) -> str:
    return code(spaced(acknowledge(page.model, f, value)))
