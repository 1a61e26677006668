"""Lua literals, and the texts about a field in Wireshark."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.facts import describe

#: Topics that the tree shows itself, or that do not help to read a packet.
_LEFT_OUT = ("elements", "tag", "counts", "constant", "required", "optional", "note", "uncertain")


def string(text: str) -> str:
    r"""
    >>> string('a "b" \\ c')
    '"a \\"b\\" \\\\ c"'
    """
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def octets(values: Iterable[int]) -> str:
    """Writes bytes as a Lua string.

    >>> octets(b"\\x18n")
    '"\\\\24\\\\110"'
    """
    return '"' + "".join(f"\\{byte}" for byte in values) + '"'


def field_doc(f: m.Field, model: m.Model) -> str:
    return _plain(describe.prose(f.description, model))


def parameter_doc(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    facts = [fact for fact in describe.parameter(p, record, model) if fact.topic not in _LEFT_OUT]
    return " ".join(filter(None, (_plain(describe.prose(p.description, model)), *(_plain(f.sentence) for f in facts))))


def bits_doc(b: m.Bits, model: m.Model) -> str:
    return _plain(describe.prose(b.description, model))


def _plain(text: describe.Text) -> str:
    return describe.say(text, lambda ref: ref.words)
