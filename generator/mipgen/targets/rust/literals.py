"""Literals of Rust."""

from __future__ import annotations


def quoted(text: str) -> str:
    """Writes a string literal.

    >>> print(quoted('say "µ"'))
    "say \\"µ\\""
    """
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def decimal(value: float | int) -> str:
    """Writes a floating-point literal.

    >>> decimal(250), decimal(0.5)
    ('250.0', '0.5')
    """
    return repr(float(value))


def option(value: int | str | None, form: str = "{}") -> str:
    """Writes an optional number, or a text that may be missing.

    >>> option(17, "0x{:02X}"), option("a"), option(None)
    ('Some(0x11)', 'Some("a")', 'None')
    """
    if value is None or value == "":
        return "None"
    return f"Some({quoted(value) if isinstance(value, str) else form.format(value)})"
