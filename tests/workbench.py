"""The workbench of a specification, built as `make workbench` does, from its committed package, and its pages."""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import browser
from support import ROOT, SPECS, need, node_modules

BUNDLE = ROOT / "tools/workbench/bundle.mjs"

#: What tests do on pages: functions that are there on each page of a tab.
HELP = (ROOT / "tests/javascript/page.js").read_text("utf-8")

#: Where it is built; it goes when the tests end.
FOLDER = tempfile.TemporaryDirectory(prefix="mip-workbench-")


@cache
def workbench(spec: str) -> Path:
    folder = Path(FOLDER.name) / spec
    done = bundled(SPECS[spec][1] / "javascript", folder)
    assert done.returncode == 0, done.stderr
    return folder


def bundled(package: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    command = [need("node"), BUNDLE, package, folder]
    environment = {**os.environ, "NODE_PATH": str(node_modules())}
    return subprocess.run(command, capture_output=True, text=True, env=environment, check=False)


@contextmanager
def tab() -> Iterator[browser.Page]:
    with browser.page() as opened:
        opened.call("Page.addScriptToEvaluateOnNewDocument", source=f"(() => {{{HELP}}})()")
        yield opened


def visit(page: browser.Page, tool: str, fragment: str = "", spec: str = "real") -> None:
    page.open("about:blank")  # another fragment alone loads nothing
    page.open((workbench(spec) / f"{tool}.html").as_uri() + fragment)
