"""What the site adds to the Markdown: MkDocs calls `on_page_markdown` for each page.

Without it the pages have the same content: anchors stand before headings, and programs are folded.
"""

from __future__ import annotations

import html
import re
import textwrap
from typing import Any

_ANCHORED = re.compile(r'^<a id="([^"]+)"></a>\n\n(#+ .*)$', re.M)
_PROGRAM = re.compile(r'<details class="program" markdown="1">\n<summary>(.*?)</summary>\n(.*?)</details>\n', re.S)
_TITLE = re.compile(r"^# (.*?)(?: \{ #[^ ]+ \})?$", re.M)
_DESCRIPTOR = re.compile(r"\(0x([0-9A-F]{2}),0x([0-9A-F]{2})\)")


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Gives headings their anchors and programs their tabs, and a page its description and words to search for."""
    text = _ANCHORED.sub(r"\2 { #\1 }", markdown)
    page.meta.setdefault("description", description(text))
    title = _TITLE.search(text)
    found = _DESCRIPTOR.search(title[1]) if title else None
    if found:
        page.meta.setdefault("tags", spellings(*found.groups()))
    if page.file.src_uri.startswith("indexes/"):  # a search finds what they lead to
        page.meta.setdefault("search", {"exclude": True})
    if '<div class="filter devices">' in text:  # their tables need the room
        page.meta.setdefault("hide", ["toc"])
    return _PROGRAM.sub(_tab, text)


def description(markdown: str) -> str:
    """The title and the first paragraph, without markup, cut at a word.

    >>> description("# T\\n\\n`a.b`, data. See [*x*](y.md).\\n\\nMore")
    'T: a.b, data. See x.'
    """
    paragraphs = markdown.split("\n\n")
    first = next((p for p in paragraphs if p.strip() and not p.startswith(("#", "|", "- ", "<"))), "")
    title = _TITLE.search(markdown)
    whole = f"{title[1]}: {first}" if title else first
    plain = re.sub(r"[`*]|\\(?=\W)", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", whole))
    return textwrap.shorten(html.unescape(plain), 160, placeholder=" …")


def spellings(set_: str, descriptor: str) -> list[str]:
    """The ways in which people write the descriptors of a field.

    >>> spellings("0D", "13")
    ['0x0D,0x13', '0x0D13', '0D13', '0D 13']
    """
    return [f"0x{set_},0x{descriptor}", f"0x{set_}{descriptor}", f"{set_}{descriptor}", f"{set_} {descriptor}"]


def _tab(match: re.Match[str]) -> str:
    return f'=== "{match[1]}"\n\n{textwrap.indent(match[2].strip(), "    ")}\n'
