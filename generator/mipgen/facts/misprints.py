"""Differences between the bytes that a manual prints and the correct ones."""

from __future__ import annotations

from mipgen import model as m


def misprint_text(e: m.Example) -> list[str]:
    """Words the differences between the bytes of an example in the manual and the correct ones."""
    correct = e.packet[4:-2] if e.role == "field" else e.packet
    sentences = []
    if e.string is not None:
        digits = "".join(e.string.split())
        if len(digits) % 2:
            sentences.append(f"string has an odd number of digits, {len(digits)}")
        elif bytes.fromhex(digits) != correct:
            sentences.append(f"string {_where(tuple(bytes.fromhex(digits)), correct)}")
    if e.table is not None and (
        len(e.table) != len(correct) or any(a is not None and a != b for a, b in zip(e.table, correct, strict=False))
    ):
        sentences.append(f"table {_where(e.table, correct)}")
    return sentences


def _where(printed: tuple[int | None, ...], correct: bytes) -> str:
    for i, (a, b) in enumerate(zip(printed, correct, strict=False)):
        if a is not None and a != b:
            return f"byte at offset {i} is {a:02X}, should be {b:02X}"
    return f"has {len(printed)} bytes, should have {len(correct)}"
