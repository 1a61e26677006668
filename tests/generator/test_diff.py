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
        "changes": [
            {
                "verdict": "source",
                "class": "name",
                "subject": "tools.who",
                "what": "was called tools.identify",
                "file": "spec/sets/tools.yaml",
                "line": 20,
            }
        ],
        "ignored": [],
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
    assert "a language version that this mipgen cannot read" in capsys.readouterr().out


def test_before_the_first_release(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(BASE, tmp_path / "spec")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["diff", "--release"]) == 0
    assert "there is no release to compare with yet" in capsys.readouterr().out


LINES = len((BASE / "sets/tools.yaml").read_text("utf-8").splitlines())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["diff"], "mipgen: error: specify what to compare with: a folder, a revision, or --release"),
        (["diff", "v9"], "mipgen: error: 'v9' is neither a folder nor a revision"),
        (["diff", "empty"], "the revision 'empty' has no folder spec"),
        (["diff", "v0.1.0", "broken"], f"broken/sets/tools.yaml:{LINES + 1}:1: error: unknown key 'colour'"),
        (["diff", "v0.1.0", "broken"], "broken: error: this mipgen cannot read it\n"),
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
        "mipgen: error: there is no folder 'HEAD', and spec is not in a Git repository with revisions; "
        "specify a folder\n"
    )


def test_two_folders_need_no_specification_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("old", "new"):
        shutil.copytree(BASE, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    assert cli.main(["diff", "old", "new"]) == 0
    assert cli.main(["diff", "old"]) == 1
    assert "there is no specification here" in capsys.readouterr().err


def test_an_unreadable_revision_gives_file_and_line(repository: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change("sets/tools.yaml", "title: Ping", "heading: Ping")
    release("wrong")
    assert cli.main(["diff", "v0.1.0", "wrong"]) == cli.main(["diff", "wrong", "v0.1.0"]) == 1
    lines = capsys.readouterr().err.splitlines()
    assert lines[: len(lines) // 2] == lines[len(lines) // 2 :] and len(lines) == 4
    assert lines[0].startswith("wrong:spec/sets/tools.yaml:9:5: error: unknown key 'heading'")
    assert lines[1] == "wrong: error: this mipgen cannot read it"


def test_annotations(repository: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Of files as they are in the repository, even if the new side is a revision."""
    change(*CHANGES["wire"][:3])
    annotation = (
        "::error file=spec/sets/measurements.yaml,line=13,col=9,title=mipgen diff%3A wire%2C unit"
        "::measurements.accel.accel: unit s, was m"
    )
    assert cli.main(["diff", "v0.1.0", "--format", "github"]) == 5
    assert capsys.readouterr().out.splitlines()[0] == annotation
    release("v0.2.0")
    assert cli.main(["diff", "v0.1.0", "v0.2.0", "--format", "github"]) == 5
    assert capsys.readouterr().out.splitlines()[0] == annotation
    assert cli.main(["diff", "v0.2.0", "--format", "github"]) == 0


def test_ignored_changes_do_not_count(repository: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(*CHANGES["wire"][:3])
    change(*CHANGES["compatible"][:3])
    Path("ignore.yaml").write_text(
        "ignore:\n  - {subject: measurements.*, class: unit, reason: A slip of ours.}\n", "utf-8"
    )
    assert cli.main(["diff", "v0.1.0", "--ignore", "ignore.yaml"]) == 3
    assert capsys.readouterr().out.splitlines() == [
        "compatible description   tools.ping: another description",
        "ignored    unit          measurements.accel.accel: unit s, was m (A slip of ours.)",
        "v0.1.0 (version 0.1.0) -> version 0.1.0: compatible",
    ]
    assert cli.main(["diff", "v0.1.0", "--ignore", "ignore.yaml", "--json"]) == 3
    assert json.loads(capsys.readouterr().out)["ignored"][0]["reason"] == "A slip of ours."
    change("protocol.yaml", "version: 0.1.0", "version: 0.1.1")
    assert cli.main(["diff", "--release", "--ignore", "ignore.yaml"]) == 0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("ignore: [{subject: tools.ping}]\n", "ignore.yaml:1:10: error: 'reason' is missing in the entry"),
        ("ignore: [{subject: tools.ping, reason: ''}]\n", "ignore.yaml:1:40: error: 'reason' must be text"),
        ("ignore: [{subject: a, reason: B., clas: unit}]\n", "unknown key 'clas', did you mean 'class'?"),
        ("ignore: [{subject: a, reason: B., class: units}]\n", "unknown class 'units', did you mean 'unit'?"),
        ("ignore: [a]\n", "ignore.yaml:1:10: error: an entry has the keys 'subject' and 'reason'"),
        ("tools.ping: A.\n", "ignore.yaml:1:1: error: a list of changes to ignore is a mapping with the one key"),
        ("ignore: [\n", "ignore.yaml:"),
        (
            "ignore:\n  - {subject: tools.ping, class: unit, reason: B.}\n",
            "ignore.yaml:2:5: error: there is no change of the class 'unit' of 'tools.ping'; remove the entry",
        ),
        ("ignore: [{subject: tools.x, reason: B.}]\n", "there is no change of 'tools.x'; remove the entry"),
    ],
)
def test_mistakes_in_a_list_of_ignored_changes(
    repository: Path, capsys: pytest.CaptureFixture[str], text: str, message: str
) -> None:
    change(*CHANGES["compatible"][:3])
    Path("ignore.yaml").write_text(text, "utf-8")
    assert cli.main(["diff", "v0.1.0", "--ignore", "ignore.yaml"]) == 1
    assert message in capsys.readouterr().err
