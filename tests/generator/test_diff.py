"""`mipgen diff`: folders and revisions, text and JSON, exit statuses, and the version number of a release."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from mipgen import cli
from support import ROOT

BASE = ROOT / "tests/bad_specs/base"


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository with one release of a specification."""
    shutil.copytree(BASE, tmp_path / "spec")
    monkeypatch.chdir(tmp_path)
    git("init", "--quiet")
    release("v0.1.0")
    return tmp_path


def git(*arguments: str) -> None:
    subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=n@example.org", *arguments], check=True)


def release(tag: str) -> None:
    git("add", "--all")
    git("commit", "--quiet", "--message", tag)
    git("tag", tag)


def change(file: str, old: str, new: str) -> None:
    path = Path("spec", file)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


CHANGES = {
    "same": ("sets/tools.yaml", "# yaml", "# YAML", 0),
    "compatible": ("sets/tools.yaml", "title: Ping", "title: Ping it", 3),
    "source": ("sets/tools.yaml", "name: identify", "name: who", 4),
    "wire": ("sets/measurements.yaml", "unit: m,", "unit: s,", 5),
}


@pytest.mark.parametrize("verdict", CHANGES)
def test_exit_status_tells_the_verdict(repository: Path, capsys: pytest.CaptureFixture[str], verdict: str) -> None:
    file, old, new, status = CHANGES[verdict]
    change(file, old, new)
    assert cli.main(["diff", "v0.1.0"]) == status
    assert capsys.readouterr().out.splitlines()[-1] == f"v0.1.0 (version 0.1.0) -> version 0.1.0: {verdict}"
    assert cli.main(["diff", str(BASE), "spec"]) == status
    assert cli.main(["diff", "v0.1.0", "HEAD"]) == 0


def test_json(repository: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(*CHANGES["source"][:3])
    assert cli.main(["diff", "v0.1.0", "--json"]) == 4
    assert json.loads(capsys.readouterr().out) == {
        "old": "0.1.0",
        "new": "0.1.0",
        "verdict": "source",
        "changes": [{"verdict": "source", "subject": "tools.who", "what": "was called tools.identify"}],
    }


@pytest.mark.parametrize(
    ("verdict", "version", "status"),
    [("same", "0.1.0", 0), ("compatible", "0.1.0", 1), ("compatible", "0.1.1", 0), ("source", "0.1.1", 1),
     ("source", "0.2.0", 0), ("wire", "0.1.9", 1), ("wire", "1.0.0", 0)],
)  # fmt: skip
def test_a_release_needs_a_version_number_that_says_enough(
    repository: Path, capsys: pytest.CaptureFixture[str], verdict: str, version: str, status: int
) -> None:
    change(*CHANGES[verdict][:3])
    change("protocol.yaml", "version: 0.1.0", f"version: {version}")
    assert cli.main(["diff", "--release"]) == status
    assert ("raise it in protocol.yaml" in capsys.readouterr().err) == bool(status)


@pytest.mark.parametrize(("version", "status"), [("0.1.1", 1), ("0.2.0", 0)])
def test_a_release_in_an_older_language_counts_as_the_worst(
    repository: Path, capsys: pytest.CaptureFixture[str], version: str, status: int
) -> None:
    change("sets/tools.yaml", "title: Ping", "heading: Ping")
    release("v0.1.1")
    change("sets/tools.yaml", "heading: Ping", "title: Ping")
    change("protocol.yaml", "version: 0.1.0", f"version: {version}")
    assert cli.main(["diff", "--release"]) == status
    assert "a language that this mipgen cannot read" in capsys.readouterr().out


def test_before_the_first_release(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(BASE, tmp_path / "spec")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["diff", "--release"]) == 0
    assert "nothing is released yet" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["diff"], "mipgen: error: name what to compare with: a folder, a revision, or --release"),
        (["diff", "v9"], "mipgen: error: 'v9' is neither a folder nor a revision"),
        (["diff", "empty"], "the revision 'empty' has no folder spec"),
        (["diff", "v0.1.0", "broken"], "broken: error: this mipgen cannot read it: unknown key 'colour'"),
    ],
)
def test_messages(repository: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str) -> None:
    git("checkout", "--quiet", "--orphan", "empty")
    git("rm", "--quiet", "-r", "--cached", ".")
    git("commit", "--quiet", "--allow-empty", "--message", "Empty")
    git("checkout", "--quiet", "--force", "v0.1.0")
    shutil.copytree(BASE, "broken")
    (repository / "broken/sets/tools.yaml").write_text((BASE / "sets/tools.yaml").read_text() + "colour: red\n")
    assert cli.main(arguments) == 1
    assert message in capsys.readouterr().err


def test_outside_of_a_repository(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(BASE, tmp_path / "spec")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    assert cli.main(["diff", "HEAD"]) == 1
    assert capsys.readouterr().err == (
        "mipgen: error: there is no folder 'HEAD', and no revision, because spec is not in a Git repository; "
        "name a folder\n"
    )
