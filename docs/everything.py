"""Puts the reference on one page, for the search of the browser, and makes a PDF of it.

    python docs/everything.py SITE        writes everything.html into the site
    python docs/everything.py SITE PDF    prints it, too, with Chromium

Pages follow in the order of the navigation. Those that repeat others are left out: comparison, indexes, examples,
programs, documents of the project. Anchors of fields are the same as on their pages.
"""

from __future__ import annotations

import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LEFT_OUT = re.compile(r"(compare|indexes|examples|programs|project|tools)/|(examples|programs|start|404)\.html")
_ARTICLE = re.compile(r'<article class="md-content__inner md-typeset">(.*?)</article>', re.S)
_NEXT = re.compile(r'<a href="([^"]+)" class="md-nav__link', re.S)
_ID = re.compile(r'\b(id|for|name)="([^"]+)"')
#: After these, a name may continue on the next line, so that no column is as wide as a symbol, and none breaks a word.
_BREAK = re.compile(r"(?<=\w)([_.,:])(?=\w)(?=[^<>]*</code>)")
_LINK = re.compile(r'\b(href|src)="(?!https?:|data:|mailto:)([^"]*)"')
#: Links of headings to themselves, and the programs of fields.
_CUT = re.compile(r'<a class="headerlink".*?</a>|<h2 id="programs">.*?(?=<h2|\Z)', re.S)

HEAD = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>MIP reference: everything on one page</title>
<style>
body { max-width: 70rem; margin: auto; padding: 0 1rem; font: 15px/1.5 system-ui, sans-serif; color: #222; }
h1 { margin-top: 3rem; border-top: 3px solid #e8a33d; break-after: avoid; }
a { color: #0a6470; }
img { max-width: 100%; }
table { border-collapse: collapse; font-size: 12px; }
th, td { padding: 3px 6px; border: 1px solid #ccc; text-align: left; vertical-align: top; }
code { font-size: 12px; }
pre { padding: 8px; overflow: auto; background: #f4f6f8; }
.tabbed-set > input, .tabbed-labels { display: none; }
@media print {
  body { font-size: 9px; }
  table, code, pre { font-size: 7px; }
  pre { white-space: pre-wrap; }
  td { overflow-wrap: break-word; }
}
</style>
</head>
<body>
"""


def pages(site: Path) -> list[str]:
    """The pages, in the order of the navigation, which is on the pages of each section."""
    order, waiting = ["index.html"], ["index.html"]
    while waiting:
        page = waiting.pop(0)
        links = _NEXT.findall((site / page).read_text("utf-8"))
        folder = posixpath.dirname(page)
        for other in (posixpath.normpath(posixpath.join(folder, x.partition("#")[0])) for x in links):
            if other not in order and (site / other).is_file() and not LEFT_OUT.match(other):
                order.append(other)
                waiting.append(other)
    return order


def whole(site: Path) -> str:
    """The page: links between its parts lead to anchors, others to the pages of the site."""
    shown = pages(site)
    parts = []
    for page in shown:
        text = _ARTICLE.search((site / page).read_text("utf-8"))
        if text is None:
            continue
        own = posixpath.dirname(page)

        def link(match: re.Match[str], page: str = page, own: str = own) -> str:
            path, _, anchor = match[2].partition("#")
            to = posixpath.normpath(posixpath.join(own, path)) if path else page
            if match[1] == "href" and to in shown:
                return f'href="#{_place(to, anchor)}"'
            return f'{match[1]}="{to}{"#" + anchor if anchor else ""}"'

        def place(match: re.Match[str], page: str = page) -> str:
            return f'{match[1]}="{_place(page, match[2])}"'

        body = _ID.sub(place, _CUT.sub("", text[1]))
        body = _BREAK.sub(r"\1<wbr>", _LINK.sub(link, body))
        parts.append(f'<section id="{_place(page, "")}">{body}</section>\n')
    return f"{HEAD}{''.join(parts)}</body>\n</html>\n".replace("<details>", "<details open>")


def _place(page: str, anchor: str) -> str:
    """The anchor on the page of everything; only those of fields, which have a dot, are unique in the site.

    >>> _place("fields/base/ping.html", "base.ping"), _place("fields/base/ping.html", "evidence")
    ('base.ping', 'fields-base-ping-evidence')
    """
    return anchor if "." in anchor else "-".join(filter(None, [*page.removesuffix(".html").split("/"), anchor]))


def print_pdf(page: Path, pdf: Path) -> None:
    """Prints a page with Chromium, which takes minutes; the file has no date of its making."""
    with tempfile.TemporaryDirectory() as profile:
        options = [
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--no-pdf-header-footer",
            f"--user-data-dir={profile}",
        ]
        options += ["--generate-pdf-document-outline", f"--print-to-pdf={pdf.resolve()}"]
        program = next(filter(None, map(shutil.which, ("chromium", "google-chrome"))), None)
        if program is None:
            sys.exit("Chromium is missing (Debian: apt-get install chromium)")
        subprocess.run([program, *options, page.resolve().as_uri()], capture_output=True, check=True)
    made = re.sub(rb"(?<=Date \(D:)\d{14}", b"19800101000000", pdf.read_bytes())
    pdf.write_bytes(made)


if __name__ == "__main__":
    site = Path(sys.argv[1])
    (site / "everything.html").write_text(whole(site), "utf-8")
    if sys.argv[2:]:
        print_pdf(site / "everything.html", Path(sys.argv[2]))
