"""The files that a repository host reads: workflows, forms, citation."""

from __future__ import annotations

import json
import re
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
