"""Additions of the site to the Markdown; MkDocs calls the functions whose names begin with `on_`.

Without these functions, the pages have the same content: anchors stand before headings, programs are folded, and the
search of the site finds nothing.
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

from mkdocs.structure.files import File

_ANCHORED = re.compile(r'^<a id="([^"]+)"></a>\n\n(#+ .*)$', re.M)
#: Programs one after the other, one in each language.
_PROGRAMS = re.compile(r"^(?:```(?:c|cpp|python|rust|javascript)\n(?:(?!```).*\n)*```\n){2,}", re.M)
#: A program in one language, and the page with the others.
_SAME = re.compile(
    r"^(```python\n(?:(?!```).*\n)*```\n)\n`([\w.]+)` is also in the listings for \[C\]\(([^)#]+)#.*\n", re.M
)
#: The name of a program in a listing of several.
_NAME = re.compile(r"^(?://|/\*) ([\w.]+)(?: \*/)?\n", re.M)
_FENCE = re.compile(r"```(\w+)\n(.*?)```\n", re.S)
_LANGUAGES = {"c": "C", "cpp": "C++", "python": "Python", "rust": "Rust", "javascript": "JavaScript"}
#: A packet byte by byte, and a row of a table to which its parts link.
_RULER = re.compile(r"<code>75 65</code>(?: (?:<a [^>]*>)?<code>[0-9A-F ]+</code>(?:</a>)?){4,}")
_PART = re.compile(r'(?:<a href="([^"]*)"(?: title="([^"]*)")?>)?<code>([0-9A-F ]+)</code>')
_ROW = re.compile(r'<td([^>]*)>(?=<a id="([^"]+)"></a>)')
_TABLE = re.compile(r"<table>\n?(<thead>.*?</thead>)(.*?)</table>", re.S)
_COLOURS = 6
_TITLE = re.compile(r"^# (.*?)(?: \{ #[^ ]+ \})?$", re.M)
_HEADING = re.compile(r'<h[1-3] id="([^"]+)">(.*?)(?:<a class="headerlink".*?)?</h[1-3]>', re.S)
_HIDDEN = re.compile(r"<(script|style)\b.*?</\1>|<!--.*?-->", re.S)

#: The folder that `make workbench` has built. Without it the site has no tools, and its search finds text only.
WORKBENCH = os.environ.get("MIP_WORKBENCH", "")

#: A folder of further pages, which `pages.json` lists by section: name of the file -> title.
PAGES = os.environ.get("MIP_PAGES", "")

#: The length of text that the search has of each part of a page, if it has the workbench, whose index of fields has the
#: parameters, values and bits.
_BEGINNINGS = {
    "fields/": 100,
    "types/": 0,
    "types.md": 0,
    "compare/": 0,
    "examples": 0,
    "errata": 40,
    "sets/": 120,
    "devices/": 120,
    "project/": 1500,
}
_TABLES = re.compile(r"(?:packets|units)\.md$")  # pages with tables that can be found
_LEFT_OUT = re.compile(r"<(pre|table)\b.*?</\1>", re.S)

_frames: dict[str, dict[str, str]] = {}  # "command" or "data" -> a complete program in each language
_texts: dict[str, Any] = {}  # the address of a page -> its title and sections


def on_config(config: Any) -> Any:
    """Adds the style of the tools. `mkdocs serve` builds more than once."""
    _texts.clear()
    _frames.clear()
    if WORKBENCH:
        config["extra_css"].insert(0, "assets/tools.css")
    for section, pages in _further().items():
        config["nav"].append({section: [{title: f"project/{name}"} for name, title in pages.items()]})
    return config


def on_files(files: Any, config: Any) -> Any:
    """Adds the further pages."""
    for pages in _further().values():
        for name in pages:
            text = Path(PAGES, name).read_text("utf-8")
            files.append(File.generated(config, f"project/{name}", content=text))
    return files


def _further() -> dict[str, dict[str, str]]:
    return json.loads(Path(PAGES, "pages.json").read_text("utf-8")) if PAGES else {}  # type: ignore[no-any-return]


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Adds anchors to headings, tabs to programs, and a description to a page."""
    if page.file.src_uri == "programs.md":
        _frames.update(frames(markdown))
    text = _ANCHORED.sub(r"\2 { #\1 }", markdown)
    page.meta.setdefault("description", description(text))
    if '<div class="filter devices">' in text:  # their tables need the room
        page.meta.setdefault("hide", ["toc"])
    text = _SAME.sub(lambda match: _languages(match, Path(page.file.abs_src_path).parent), text)
    return _PROGRAMS.sub(_tabs, text)


def on_page_content(content: str, page: Any, **_: Any) -> str:
    """Keeps the text of a page for the search, which leaves out indexes. Colours packets."""
    path = page.file.src_uri
    if path.startswith(("indexes/", "programs/")):
        return content
    if path.startswith(("fields/", "guides/")):
        content = rulers(labelled(content))
        content = re.sub(r"<p>(?=<img [^>]*assets/guides/)", '<p tabindex="0">', content)  # may scroll, by keys, too
    whole = not WORKBENCH or _TABLES.match(path)
    title, *parts = sections(content if whole else _LEFT_OUT.sub(" ", content))
    if WORKBENCH and path.startswith(("fields/", "devices/", "sets/")):
        parts = [part for part in parts if "." in part[0]]  # responses; other sections are alike on all pages
    parts = [part for part in parts if part[1] != "See also"]
    cut = next((length for begins, length in _BEGINNINGS.items() if WORKBENCH and path.startswith(begins)), None)
    kept = [[anchor, heading, text[:cut]] for anchor, heading, text in [["", "", title[2]], *parts]]
    _texts[page.url] = [page.url, title[1] or page.title, kept]
    return content


def on_post_page(output: str, **_: Any) -> str:
    """Adds the classes to a page that scripts of the theme would add later, so that all styles were computed again."""
    classes = '<script>document.documentElement.className = "js js-focus-visible"</script>'
    return output.replace("<head>", f"<head>{classes}", 1)


def on_post_build(config: Any) -> None:
    """Writes the texts of all pages and the complete programs as scripts, which pages from disk may load too, and adds
    the workbench."""
    assets = Path(config["site_dir"], "assets")
    text = json.dumps([_texts[url] for url in sorted(_texts)], ensure_ascii=False, separators=(",", ":"))
    (assets / "text.js").write_text(f"globalThis.mipText = {text};\n", "utf-8")
    if _frames:
        (assets / "frames.js").write_text(f"globalThis.mipFrames = {json.dumps(_frames)};\n", "utf-8")
    if WORKBENCH:
        for name in ("workbench.js", "fields.js", "tools.css"):
            shutil.copy(Path(WORKBENCH, name), assets)


def frames(markdown: str) -> dict[str, dict[str, str]]:
    """The programs of each section, by language.

    >>> frames('<a id="programs.data"></a>\\n\\n## D\\n\\n```c\\nx\\n```\\n')
    {'data': {'c': 'x\\n'}}
    """
    _, *parts = re.split(r'^<a id="programs\.(\w+)"></a>$', markdown, flags=re.M)
    return {name: dict(_FENCE.findall(text)) for name, text in zip(parts[::2], parts[1::2], strict=True)}


def labelled(content: str) -> str:
    """Adds the heading of its column to each cell, which narrow windows show instead of the headings.

    >>> labelled("<table><thead><th>A</th></thead><tr><td>1</td></tr></table>")
    '<table><thead><th>A</th></thead><tr><td data-label="A">1</td></tr></table>'
    """

    def table(match: re.Match[str]) -> str:
        headings = [_plain(x) for x in re.findall(r"<th>(.*?)</th>", match[1], re.S)]
        cells = iter(headings * match[2].count("<tr>"))
        body = re.sub(r"<td>", lambda _: f'<td data-label="{html.escape(next(cells))}">', match[2])
        return f"<table>{match[1]}{body}</table>"

    return _TABLE.sub(table, content)


def rulers(content: str) -> str:
    """Adds names to the parts of packets, and to those of parameters the colour of their rows."""
    found = dict.fromkeys(x for ruler in _RULER.findall(content) for x, *_ in _PART.findall(ruler) if x[:1] == "#")
    colours = {place[1:]: f"mip-colour-{i % _COLOURS}" for i, place in enumerate(found)}
    content = _RULER.sub(lambda ruler: _ruler(ruler[0], colours), content)
    return _ROW.sub(lambda row: f'<td{row[1]} class="{colours[row[2]]}">' if row[2] in colours else row[0], content)


def _ruler(ruler: str, colours: dict[str, str]) -> str:
    """
    >>> print(_ruler('<code>75 65</code> <a href="#a.b.c"><code>01</code></a>', {"a.b.c": "x"}).replace("> <", ">\\n<"))
    <span class="mip-ruler"><span data-name="sync"><code>75 65</code></span>
    <span data-name="c" class="x"><a href="#a.b.c"><code>01</code></a></span></span>
    """
    parts = re.findall(r"<a [^>]*>.*?</a>|<code>.*?</code>", ruler)
    heads = {0: "sync", 1: "set", 2: "length", len(parts) - 1: "checksum"}
    named = []
    titled = 0
    for i, part in enumerate(parts):
        place, title, _ = _PART.match(part).groups(default="")  # type: ignore[union-attr]
        other = "acknowledge" if "packets." in place else "length, field"
        name = place.split(".")[-1] if place[:1] == "#" else title or heads.get(i, other)
        colour = colours.get(place[1:]) or (f"mip-colour-{titled % _COLOURS}" if title else "")
        titled += bool(title)
        kind = f' class="{colour}"' if colour else ""
        named.append(f'<span data-name="{name}"{kind}>{part}</span>')
    return f'<span class="mip-ruler">{" ".join(named)}</span>'


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
    """The text of HTML. Inline elements do not separate words."""
    apart = re.sub(r"</?(?:code|em|strong|a|span|sub|sup)\b[^>]*>", "", markup)
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", apart)).split())


def _languages(match: re.Match[str], folder: Path) -> str:
    """A program in all languages, those but Python from their page."""
    shown, name, page = match.groups()
    fences = {"python": shown}
    for language, text in _FENCE.findall((folder / page).read_text("utf-8")):
        before, *parts = _NAME.split(text)
        own = dict(zip(parts[::2], parts[1::2], strict=True))[name]
        fences[language] = f"```{language}\n{(before.strip() + chr(10)).lstrip()}{own.strip()}\n```\n"
    return "".join(fences[language] for language in _LANGUAGES)


def _tabs(match: re.Match[str]) -> str:
    return "\n".join(
        f'=== "{_LANGUAGES[fence[1]]}"\n\n{textwrap.indent(fence[0], "    ")}' for fence in _FENCE.finditer(match[0])
    )
