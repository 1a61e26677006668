"""The files that a repository host reads, pictures, docs/architecture.md; and what the pages name exists."""

from __future__ import annotations

import re
import subprocess
import sys
from fnmatch import fnmatch
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest
import wording
import yaml
from support import ROOT, heavy

HOSTED = sorted((ROOT / ".github").rglob("*.yml"))


@pytest.mark.parametrize("path", HOSTED, ids=lambda p: p.name)
def test_files_of_the_host(path: Path) -> None:
    """They can be read, and name files and targets of make that exist."""
    text = path.read_text("utf-8")
    assert isinstance(yaml.safe_load(text), dict)
    makefile = (ROOT / "Makefile").read_text("utf-8")
    for name in re.findall(r"\bmake ([a-z-]+)", text):
        assert re.search(rf"^{name}:", makefile, re.M), name
    for name in re.findall(r"(?<![\w/])((?:generated|docs|tools|\.ci)/[\w./-]*\w)", text):
        assert (ROOT / name).exists(), name


@pytest.mark.parametrize(
    ("path", "pattern"),
    [
        ("CITATION.cff", "^version: (.*)"),
        ("tools/mip_tools/__init__.py", '^__version__ = "(.*)"'),
        ("tools/mip_simulator/__init__.py", '^__version__ = "(.*)"'),
        ("tools/mip_simulator/pyproject.toml", '"mip-tools==(.*?)"'),
        ("generator/mipgen/__init__.py", '^__version__ = "(.*)"'),
        ("CHANGELOG.md", r"\A# Changelog\n[^#]*## (\S+) "),
        ("runtime/rust/CHANGELOG.md", r"\A# Changelog\n[^#]*## (\S+) "),
    ],
)
def test_what_has_the_version_of_the_specification(path: str, pattern: str) -> None:
    version = yaml.safe_load((ROOT / "spec/protocol.yaml").read_text("utf-8"))["version"]
    assert re.findall(pattern, (ROOT / path).read_text("utf-8"), re.M) == [version]


#: Folders with pages for readers, and those whose files and folders are named from the top of the project.
PAGES = (".github", "docs", "examples", "runtime", "spec", "templates", "tools")
TOP = (*PAGES, "generated", "generator", "tests")
#: Files of the reader, or of what is built or installed: they are not in the project.
ELSEWHERE = re.compile(
    r"(my[-_]\w+|build|external)[/.].*|types/common\.yaml|(spec/devices/MODEL|MODEL-FIRMWARE)\.yaml|assets/tools\.css|(std\w+|time)\.h|(models|witness)\.yaml|\./mip-protocol/.*"
)


@pytest.fixture(scope="module")
def files() -> list[str]:
    """Everything in the project, with a / before it."""
    folders = [ROOT / name for name in (*TOP, ".ci")]
    every = [*ROOT.iterdir(), *folders, *(path for folder in folders for path in folder.rglob("*"))]
    return [f"/{path.relative_to(ROOT).as_posix()}" for path in every]


@pytest.fixture(scope="module")
def tests() -> str:
    return "\n".join(path.read_text("utf-8") for path in (ROOT / "tests").rglob("test_*.py"))


def pages() -> list[Path]:
    inside = [path for folder in PAGES for path in (ROOT / folder).rglob("*.md*") if path.suffix in (".md", ".j2")]
    return sorted([*ROOT.glob("*.md"), *inside])


def named(text: str) -> set[str]:
    """The files, folders and tests that a page names in backquotes."""
    words = re.findall(r"`([\w.*<>/-]+)`", text)
    kinds = r"py|rs|c|h|hpp|mjs|mts|css|j2|lua|ya?ml|json|toml|txt|sh|md"
    paths = {word for word in words if re.fullmatch(rf"(?:({'|'.join(TOP)})/.*|[\w.*/<>-]+\.({kinds}))", word)}
    return paths | {word for word in words if word.startswith("test_")}


@pytest.mark.parametrize("page", pages(), ids=lambda p: p.relative_to(ROOT).as_posix())
def test_pages_name_what_exists(page: Path, files: list[str], tests: str) -> None:
    for name in named(page.read_text("utf-8")):
        wanted = re.sub(r"<\w+>", "*", name).rstrip("/")
        there = any(fnmatch(path, f"*/{wanted}") for path in files) or f"def {name}(" in tests
        assert there or ELSEWHERE.fullmatch(name), name


# --------------------------------------------------------------------------- the architecture

ARCHITECTURE = (ROOT / "docs/architecture.md").read_text("utf-8")
GENERATOR = ROOT / "generator/mipgen"


def test_packages_of_the_architecture() -> None:
    """The tree and the order of imports name every package."""
    packages = {p.parent.name for p in GENERATOR.glob("*/__init__.py")}
    layers = ARCHITECTURE.partition("\n## Who knows what\n")[2].partition(". A target")[0].partition("): ")[2]
    assert set(re.findall(r"`(\w+)`", layers)) == packages
    assert set(re.findall(r"^      (\w+)/", ARCHITECTURE, re.M)) == packages


# --------------------------------------------------------------------------- the pictures of the README

COMMITTED = ROOT / "docs/pictures/session.svg"


def commands(picture: Path) -> list[str]:
    return [unescape(x) for x in re.findall(r'class="command"[^>]*>\$ (.*?)</text>', picture.read_text("utf-8"))]


@heavy("a session in a terminal")
def test_the_session_is_up_to_date(tmp_path: Path) -> None:
    made = tmp_path / "session.svg"
    subprocess.run([sys.executable, ROOT / "docs/pictures/session.py", made], check=True)
    ElementTree.parse(made)
    assert commands(made) == commands(COMMITTED), "`make pictures` makes it anew"
    assert len(commands(made)) > 5 and made.stat().st_size < 300_000


def test_the_committed_session_is_small_and_well_formed() -> None:
    ElementTree.parse(COMMITTED)
    assert COMMITTED.stat().st_size < 300_000 and len(commands(COMMITTED)) > 5


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("- description: Where the data comes from.\n", "is a question"),
        ("- {data: 1, description: A level; it may be 0.}\n", "divide it into sentences"),
        ("- {command: 1, description: The level of the tank.}\n", "begins with a verb"),
        ("- notes:\n    - fine\n    - The manual\n      gives it.\n", "“gives”"),
        ("- {command: 1, description: Sets it., notes: [It takes effect.], section: What it says}\n", ""),
    ],
)
def test_what_it_sees(text: str, found: str, tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(text, "utf-8")
    findings = list(wording.findings(tmp_path / "a.yaml"))
    assert len(findings) == bool(found) and all(found in x for x in findings)
    assert wording.main([str(tmp_path)]) == bool(found)
