"""The files that a repository host reads: workflows, forms, citation; and what the pages name exists."""

from __future__ import annotations

import json
import re
from fnmatch import fnmatch
from pathlib import Path

import pytest
import yaml
from support import ROOT

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


def test_forms_have_a_title_and_questions() -> None:
    for path in (ROOT / ".github/ISSUE_TEMPLATE").glob("*.yml"):
        form = yaml.safe_load(path.read_text("utf-8"))
        if path.name != "config.yml":
            assert form["name"] and form["description"] and all(b["type"] and b["attributes"] for b in form["body"])


def test_citation_has_the_version() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
    assert citation["version"] == yaml.safe_load((ROOT / "spec/protocol.yaml").read_text("utf-8"))["version"]


def test_development_container() -> None:
    container = json.loads((ROOT / ".devcontainer/devcontainer.json").read_text("utf-8"))
    assert container["postCreateCommand"].startswith("make ")


#: Folders with pages for readers, and those whose files and folders are named from the top of the project.
PAGES = (".github", "docs", "examples", "runtime", "spec", "templates", "tools")
TOP = (*PAGES, "generated", "generator", "tests")
#: Files of the reader, or of what is built or installed: they are not in the project.
ELSEWHERE = re.compile(
    r"(my[-_]\w+|build|external)[/.].*|spec/devices/MODEL\.yaml|assets/tools\.css|(std\w+|time)\.h|(models|witness)\.yaml"
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
