"""What the site adds to the Markdown; MkDocs calls the functions whose names begin with `on_`.

Without it the pages have the same content: anchors stand before headings, programs are folded, and the search of the
site finds nothing.
"""

from __future__ import annotations

import html
import json
import os
import re
import shutil
import textwrap
from pathlib import Path
from typing import Any

_ANCHORED = re.compile(r'^<a id="([^"]+)"></a>\n\n(#+ .*)$', re.M)
_PROGRAM = re.compile(r'<details class="program" markdown="1">\n<summary>(.*?)</summary>\n(.*?)</details>\n', re.S)
_TITLE = re.compile(r"^# (.*?)(?: \{ #[^ ]+ \})?$", re.M)
_HEADING = re.compile(r'<h[1-3] id="([^"]+)">(.*?)(?:<a class="headerlink".*?)?</h[1-3]>', re.S)
_HIDDEN = re.compile(r"<(script|style)\b.*?</\1>|<!--.*?-->", re.S)

#: The folder that `make workbench` has built. Without it the site has no tools, and its search finds text only.
WORKBENCH = os.environ.get("MIP_WORKBENCH", "")

#: How much of each part of a page the search has, if it has the workbench, whose index of fields has what is in
#: parameters, values and bits.
_BEGINNINGS = {
    "fields/": 120,
    "types/": 0,
    "types.md": 0,
    "compare/": 0,
    "examples.md": 0,
    "errata.md": 40,
    "sets/": 120,
    "devices/": 120,
}
_TABLES = re.compile(r"(?:packets|units)\.md$")  # pages with tables that can be found
_LEFT_OUT = re.compile(r"<(pre|table)\b.*?</\1>", re.S)

_texts: dict[str, Any] = {}  # the address of a page -> its title and sections


def on_config(config: Any) -> Any:
    """Adds the style of the tools. `mkdocs serve` builds more than once."""
    _texts.clear()
    if WORKBENCH:
        config["extra_css"].insert(0, "assets/tools.css")
    return config


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Gives headings their anchors and programs their tabs, and a page its description."""
    text = _ANCHORED.sub(r"\2 { #\1 }", markdown)
    page.meta.setdefault("description", description(text))
    if '<div class="filter devices">' in text:  # their tables need the room
        page.meta.setdefault("hide", ["toc"])
    return _PROGRAM.sub(_tab, text)


def on_page_content(content: str, page: Any, **_: Any) -> str:
    """Keeps the text of a page for the search, which finds what indexes lead to and not these."""
    path = page.file.src_uri
    if path.startswith("indexes/"):
        return content
    whole = not WORKBENCH or _TABLES.match(path)
    title, *parts = sections(content if whole else _LEFT_OUT.sub(" ", content))
    if WORKBENCH and path.startswith(("fields/", "devices/", "sets/")):
        parts = [part for part in parts if "." in part[0]]  # responses, which have a name; the rest is alike on all
    cut = next((length for begins, length in _BEGINNINGS.items() if WORKBENCH and path.startswith(begins)), None)
    kept = [[anchor, heading, text[:cut]] for anchor, heading, text in [["", "", title[2]], *parts]]
    _texts[page.url] = [page.url, title[1] or page.title, kept]
    return content


def on_post_build(config: Any) -> None:
    """Writes the texts of all pages as a script, which pages from disk may load too, and adds the workbench."""
    assets = Path(config["site_dir"], "assets")
    text = json.dumps([_texts[url] for url in sorted(_texts)], ensure_ascii=False, separators=(",", ":"))
    (assets / "text.js").write_text(f"globalThis.mipText = {text};\n", "utf-8")
    if WORKBENCH:
        for name in ("workbench.js", "fields.js", "tools.css"):
            shutil.copy(Path(WORKBENCH, name), assets)


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


def sections(content: str) -> list[list[str]]:
    """The anchor, the heading and the text of each part of a page. The first has the title of the page.

    >>> sections('<h1 id="t">T<a class="headerlink" href="#t">¶</a></h1><p>a<em>b</em></p><h2 id="u">U &amp; V</h2>c')
    [['t', 'T', 'ab'], ['u', 'U & V', 'c']]
    """
    before, *parts = _HEADING.split(_HIDDEN.sub(" ", content))
    found = [[anchor, _plain(heading), _plain(text)] for anchor, heading, text in zip(*[iter(parts)] * 3, strict=True)]
    return found if found and not _plain(before) else [["", "", _plain(before)], *found]


def _plain(markup: str) -> str:
    """The text of HTML. Inline elements do not part words."""
    apart = re.sub(r"</?(?:code|em|strong|a|span|sub|sup)\b[^>]*>", "", markup)
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", apart)).split())


def _tab(match: re.Match[str]) -> str:
    return f'=== "{match[1]}"\n\n{textwrap.indent(match[2].strip(), "    ")}\n'
