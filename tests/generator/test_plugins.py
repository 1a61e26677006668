"""Programs as targets: what they read, what they may write, and how their mistakes are reported."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import bad_spec_files
import pytest
from mipgen import cli
from mipgen.emit import output
from support import PATIENCE, ROOT

SPEC = bad_spec_files.BASE


def program(folder: Path, text: str, name: str = "list") -> Path:
    """A plugin in Python; `answer` of `text` is what it writes."""
    path = folder / name
    lines = ("import json, sys", "data = sys.stdin.buffer.read()", text, "sys.stdout.write(json.dumps(answer))")
    path.write_text("\n".join((f"#!{sys.executable}", *lines, "")))
    path.chmod(0o755)
    return path


def run(folder: Path, *more: str, command: str = "generate") -> int:
    return cli.main([command, "--spec", str(SPEC), "--out", str(folder / "out"), *more])


def test_a_program_reads_the_model_and_its_files_are_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = program(
        tmp_path,
        "answer = {'title': 'the model', 'files': {'a/model.json': data.decode(), 'b.bin': {'base64': 'AP8='}}}\n"
        "print('as an aside', file=sys.stderr)",
    )
    assert run(tmp_path, "--target", "json", "--plugin", str(path)) == 0
    said = capsys.readouterr()
    assert "list          4 files, 4 changed  (the model)\n" in said.out and said.err == "as an aside\n"
    out = tmp_path / "out/list"
    assert (out / "a/model.json").read_bytes() == (tmp_path / "out/json/mip.json").read_bytes()
    assert (out / "b.bin").read_bytes() == b"\x00\xff"
    assert (out / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
    assert (out / ".manifest").read_text() == f"{output.HEADER}\nLICENSE\na/model.json\nb.bin\n"


def test_the_output_is_checked_and_follows_the_program(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = program(tmp_path, "answer = {'files': {'one.txt': '1\\n', 'two.txt': '2\\n'}}")
    options = ("--target", "list", "--plugin", str(path))
    assert run(tmp_path, *options) == 0 and run(tmp_path, *options, command="check") == 0
    program(tmp_path, "answer = {'files': {'one.txt': '3\\n'}}")
    capsys.readouterr()
    assert run(tmp_path, *options, command="check") == 1
    out = tmp_path / "out"
    assert capsys.readouterr().err.splitlines() == [
        f"{out}/list/.manifest: error: changed",
        f"{out}/list/one.txt: error: changed",
        f"{out}/list/two.txt: error: stale",
        f"mipgen: 3 files to update; run: mipgen generate --spec {SPEC} --out {out} --target list --plugin {path}",
    ]
    assert run(tmp_path, *options) == 0 and run(tmp_path, *options, command="check") == 0
    assert (out / "list/one.txt").read_text() == "3\n" and not (out / "list/two.txt").exists()


def test_several_programs_with_names_beside_a_target(tmp_path: Path) -> None:
    path = program(tmp_path, "answer = {'files': {'a.txt': 'a'}}", "a=b.sh")
    assert run(tmp_path, "--target", "json", "--plugin", f"first={path}", "--plugin", f"second.1={path}") == 0
    assert {p.name for p in (tmp_path / "out").iterdir()} == {"first", "json", "second.1"}
    assert run(tmp_path, "--plugin", str(path)) == 1  # its name is not a name of a folder


FILES = "answer = {{'files': {}}}"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("sys.exit('no sensor\\nin the model')", "{p} ended with status 1:\nno sensor\nin the model"),
        ("sys.exit(3)", "{p} ended with status 3"),
        ("print('{{'), sys.exit()", "its output is not JSON (Expecting property name enclosed in double quotes: "
         'line 2 column 1 (char 2)); write {{"files": {{"PATH": "TEXT", ...}}}}'),
        ("answer = []", 'its output has no object "files"; write {{"files": {{"PATH": "TEXT", ...}}}}'),
        ("answer = {'files': {}, 'file': {}}", "its output has 'file'; only \"files\" and \"title\" are known"),
        ("answer = {'files': {}, 'title': 1}", '"title" must be text'),
        (FILES.format("{'/tmp/a': ''}"), "/tmp/a is outside of its folder"),
        (FILES.format("{'a/../../b': ''}"), "a/../../b is outside of its folder"),
        (FILES.format("{'': ''}"), "'' is not a file path; separate names with /"),
        (FILES.format("{'.': ''}"), "'.' is not a file path; separate names with /"),
        (FILES.format("{'a//b': ''}"), "'a//b' is not a file path; separate names with /"),
        (FILES.format("{'a\\\\b': ''}"), "'a\\\\b' is not a file path; separate names with /"),
        (FILES.format("{'a\\nb': ''}"), "'a\\nb' is not a file path; separate names with /"),
        (FILES.format("{'.manifest': ''}"), ".manifest is made twice"),
        (FILES.format("{'LICENSE': ''}"), "LICENSE is made twice"),
        (FILES.format("{'a': '', 'a/b': ''}"), "a is both a file and a folder"),
    ],
)  # fmt: skip
def test_a_mistake_is_named_and_nothing_is_written(
    text: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good = program(tmp_path, "answer = {'files': {'a.txt': 'a'}}", "good")
    path = program(tmp_path, text.replace("{{", "{"))
    assert run(tmp_path, "--target", "json", "--plugin", str(good), "--plugin", str(path)) == 1
    assert capsys.readouterr().err == f"plugin list: error: {message.format(p=path)}\n"
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("1", 'its content must be text, or {"base64": "..."}'),
        ("{'base32': ''}", 'its content must be text, or {"base64": "..."}'),
        ("{'base64': 1}", "its content cannot be read: argument should be a bytes-like object or ASCII string"),
        ("{'base64': 'A'}", "its content cannot be read: Invalid base64-encoded string"),
        ("'\\ud800'", "its content cannot be read: 'utf-8' codec can't encode character"),
    ],
)
def test_content_that_cannot_be_written(
    content: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = program(tmp_path, f"answer = {{'files': {{'a': {content}}}}}")
    assert run(tmp_path, "--target", "json", "--plugin", str(path)) == 1
    assert capsys.readouterr().err.startswith(f"plugin list: a: error: {message}")


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("{f}/none", "plugin none: error: there is no program {f}/none"),
        ("no-such-program", "plugin no-such-program: error: there is no program no-such-program"),
        ("{f}/plain", "plugin plain: error: {f}/plain is a file that cannot be run as a program; chmod +x {f}/plain"),
        ("plain", "plugin plain: error: plain is a file that cannot be run as a program; write ./plain"),
        ("{f}/broken", "plugin broken: error: {f}/broken cannot be run: Exec format error"),
        (
            "c={f}/broken",
            "plugin c={f}/broken: error: a target 'c' already exists; choose another name: --plugin NAME=PROGRAM",
        ),
        ("{f}/.hidden", "plugin {f}/.hidden: error: give its target a name: --plugin NAME=PROGRAM"),
    ],
)
def test_a_program_that_cannot_be_run(
    given: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, mode in (("plain", 0o644), ("broken", 0o755)):
        (tmp_path / name).write_bytes(b"\x00\x01")
        (tmp_path / name).chmod(mode)
    assert run(tmp_path, "--target", "json", "--plugin", given.format(f=tmp_path)) == 1
    assert capsys.readouterr().err == message.format(f=tmp_path) + "\n"


def test_names_of_the_specification_are_judged_before_a_program_runs(tmp_path: Path) -> None:
    path = program(tmp_path, f"open({str(tmp_path / 'ran')!r}, 'w')\nanswer = {{'files': {{}}}}")
    spec = bad_spec_files.named("name_collision").lay(tmp_path)
    options = ["--spec", str(spec), "--out", str(tmp_path / "out"), "--target", "python", "--plugin", str(path)]
    assert cli.main(["generate", *options]) == 1
    assert not (tmp_path / "ran").exists()


def test_a_program_that_hangs_is_interrupted(tmp_path: Path) -> None:
    """Only mipgen gets the signal; what the program has started ends with it, and nothing is written."""
    path = program(
        tmp_path,
        "import os, subprocess\n"
        "child = subprocess.Popen(['sleep', '1000'])\n"
        f"with open({str(tmp_path / 'part')!r}, 'w') as file: json.dump([os.getpid(), child.pid], file)\n"
        f"os.rename({str(tmp_path / 'part')!r}, {str(tmp_path / 'running')!r})\n"
        "child.wait()",
    )
    mipgen = subprocess.Popen(
        [sys.executable, "-m", "mipgen", "generate", "--spec", SPEC, "--out", tmp_path / "out", "--target", "json",
         "--plugin", path],
        stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT / "generator")},
    )  # fmt: skip
    wait(lambda: (tmp_path / "running").exists())
    mipgen.send_signal(signal.SIGINT)
    assert mipgen.communicate(timeout=PATIENCE)[1] == "mipgen: interrupted; run it again\n"
    assert mipgen.returncode == 130 and not (tmp_path / "out").exists()
    wait(lambda: not any(map(running, json.loads((tmp_path / "running").read_text()))))


def wait(done: object, seconds: float = PATIENCE) -> None:
    assert callable(done)
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end
        time.sleep(0.05)


def running(process: int) -> bool:
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    return False
