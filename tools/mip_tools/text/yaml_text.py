"""Writes YAML texts."""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Iterable

WIDTH = 115


def scalar_text(text: str) -> str:
    """Formats a string as a YAML scalar: plain if possible, otherwise quoted.

    >>> [scalar_text(text) for text in ("3DM-GQ7-GNSS/INS", "12", "a: b", "1.0.07", "-x", "no")]
    ['3DM-GQ7-GNSS/INS', '"12"', '"a: b"', '1.0.07', '"-x"', '"no"']
    """
    usual = re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 ./()+_'-]*(, [A-Za-z0-9 ./()+_'-]+)*[.)]?", text)
    number = re.fullmatch(r"[-+.0-9][0-9_.eExXA-Fa-f+-]*", text) and not re.fullmatch(r"\d+\.\d+\.\d+", text)
    bare = text.lower() in ("true", "false", "null", "yes", "no", "on", "off", "y", "n", "~")
    return text if usual and not number and not bare and text == text.strip() else quoted(text)


def quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def flow_list(name: str, words: Iterable[str]) -> list[str]:
    """Writes a key with a list in brackets, on as many lines as needed."""
    whole = f"{name}: [{', '.join(words)}]"
    if len(whole) <= WIDTH - 10:
        return [whole]
    lines = textwrap.wrap(whole.partition(" ")[2], WIDTH - 12, subsequent_indent=" ", break_on_hyphens=False)
    return [f"{name}:", *(f"  {line}" for line in lines)]
