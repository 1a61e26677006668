"""The command line: folders, help, a specification to start from; and runs with nothing to do."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import Any

import pytest
from bad_spec_files import BASE
from mipgen import __version__, cli
from mipgen.base import parallel
from mipgen.base.errors import Failure
from mipgen.cli import arguments
from mipgen.emit import build, discovery, stamp
from mipgen.resolve.load import load_model
from support import ROOT, SPECS, mipgen, tree

INVENTED, GOLDEN = SPECS["invented"]
#: The quickest targets: what is shown here holds for all.
TARGETS = ("--target", "json", "--target", "kaitai")


# --------------------------------------------------------------------------- a specification to start from


def test_a_new_specification_is_valid_and_generates(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec, out = tmp_path / "device", tmp_path / "out"
    assert cli.main(["new", str(spec)]) == 0
    assert f"mipgen generate --spec {spec}" in capsys.readouterr().out
    assert cli.main(["generate", "--spec", str(spec), "--out", str(out)]) == 0
    assert capsys.readouterr().out.endswith("nothing was left out\n")
    assert {p.name for p in out.iterdir()} == set(discovery.target_names())
    assert cli.main(["new", str(tmp_path / "my device")]) == 0
    assert f"mipgen generate --spec '{tmp_path}/my device'\n" in capsys.readouterr().out
    assert cli.main(["validate", "--spec", str(spec)]) == 0
    assert capsys.readouterr().out == "2 sets: 1 command, 1 data field, 1 response; 1 device, 2 examples, 0 errata\n"
    of = load_model(spec)
    assert [f.full_name for f in of.fields] == ["tools.light", "tools.light_response", "measurements.temperature"]
    assert len(of.devices) == 1 and len(of.examples) == 2
    for path in spec.rglob("*.yaml"):
        assert (path.parent / path.read_text("utf-8").partition("$schema=")[2].partition("\n")[0]).is_file(), path


def test_a_folder_with_something_in_it_is_left_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "mine.txt").write_text("mine\n")
    for folder in (tmp_path, tmp_path / "mine.txt"):
        assert cli.main(["new", str(folder)]) == 1
        assert capsys.readouterr().err == (
            f"{folder}: error: this folder is not empty; specify a new or empty folder\n"
        )
    assert [p.name for p in tmp_path.iterdir()] == ["mine.txt"]


# --------------------------------------------------------------------------- what is never overwritten


@pytest.mark.parametrize(
    ("out", "why"),
    [
        ("spec", "spec/c lies in spec, which --spec names"),
        ("spec/types/made", "spec/types/made/c lies in spec/types, which --spec names"),
        ("link", "link/c lies in spec, which --spec names"),
        ("elsewhere", "elsewhere/c lies in spec/sets, which --spec names"),
        ("into", "into/c lies in spec, which --spec names"),
        ("over", "over/c/mine, which --spec names, lies in over/c"),
        ("targets", "targets/c lies in targets, which --target-path names"),
    ],
)
def test_output_never_mixes_with_what_is_read(out: str, why: str, tmp_path: Path) -> None:
    shutil.copytree(INVENTED, tmp_path / "spec")
    (tmp_path / "spec/sets").rename(tmp_path / "elsewhere")
    (tmp_path / "spec/sets").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "link").symlink_to("spec")
    (tmp_path / "into").mkdir()
    (tmp_path / "into/c").symlink_to(tmp_path / "spec")
    (tmp_path / "over/c/mine").mkdir(parents=True)
    (tmp_path / "targets/c").mkdir(parents=True)
    before = tree(tmp_path)
    read = ["--spec", "spec", "--spec", "over/c/mine", "--target-path", "targets"]
    done = mipgen("generate", "--target", "c", *read, "--out", out, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"mipgen: error: {why}; choose another --out\n"
    assert tree(tmp_path) == before


def test_a_specification_that_is_a_whole_project(tmp_path: Path) -> None:
    """The command that `mipgen new .` prints works, even twice: the output is not part of the specification."""
    command = mipgen("new", ".", cwd=tmp_path).stdout.rpartition("then run: mipgen ")[2].split()
    for _ in range(2):
        done = mipgen(*command, "--target", "markdown", cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    assert mipgen("validate", "--spec", ".", cwd=tmp_path).returncode == 0
    assert (tmp_path / "generated/markdown/mkdocs.yml").is_file()


def test_a_lost_manifest_is_written_again(tmp_path: Path) -> None:
    """If the files there are those that would be written; one that differs may be the user's."""
    out = tmp_path / "out"
    shutil.copytree(GOLDEN / "json", out / "json")
    options = ("--spec", INVENTED, "--target", "json", "--out", out)
    (out / "json/.manifest").unlink()
    assert mipgen("generate", *options, cwd=tmp_path).returncode == 0 and tree(out / "json") == tree(GOLDEN / "json")
    (out / "json/.manifest").unlink()
    (out / "json/README.md").write_text("changed\n")
    done = mipgen("generate", *options, cwd=tmp_path)
    assert done.returncode == 1 and done.stderr.endswith(f"--out:\n  {out}/json/README.md\n")
    assert not (out / "json/.manifest").exists()


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "f").write_text("x\n")
    for out, why in (("f", "Not a directory (f/c"), ("/proc/x", "No such file or directory (/proc/x")):
        done = mipgen("generate", "--spec", INVENTED, "--target", "c", "--out", out, cwd=tmp_path)
        assert (done.returncode, done.stdout) == (1, "")
        assert done.stderr.startswith(f"{out}: error: cannot be written: {why}"), done.stderr
        assert done.stderr.endswith("; choose another --out\n") and done.stderr.count("\n") == 1
    for folder in ("f/x", "/proc/x"):
        done = mipgen("new", folder, cwd=tmp_path)
        assert done.returncode == 1 and done.stderr.startswith(f"{folder}: error: cannot be written: ")
        assert done.stderr.endswith("; choose another folder\n") and done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("error", "status", "said"),
    [
        (PermissionError(13, "Permission denied", "sets/a.yaml"), 1, "sets/a.yaml: error: Permission denied\n"),
        (KeyboardInterrupt(), 130, "mipgen: interrupted; run it again\n"),
    ],
)
def test_any_other_file_that_fails_and_a_run_that_the_user_interrupts(
    error: BaseException, status: int, said: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(options: object) -> int:
        raise error

    monkeypatch.setattr("mipgen.cli.commands.validate", fail)
    assert cli.main(["validate"]) == status
    assert capsys.readouterr().err == said


# --------------------------------------------------------------------------- folders, help, versions


@pytest.mark.parametrize("option", ["--out", "--spec", "--target-path"])
def test_an_empty_name_is_not_the_current_folder(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        cli.main(["generate", option, ""])
    assert capsys.readouterr().err.endswith(
        f"argument {option}: the path is empty; specify a folder ('.' is the current one)\n"
    )


def test_names_that_a_terminal_cannot_show(tmp_path: Path) -> None:
    """Names of files need not be text."""
    spec = Path(shutil.copytree(INVENTED, tmp_path / "spec"))
    odd = os.fsdecode(b"\xff\xc3\xa9")
    (spec / f"{odd}.txt").write_text("")
    command = [sys.executable, "-m", "mipgen", "generate", "--target", "json", "--out", odd]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "generator"), "PYTHONIOENCODING": "ascii"}
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert done.returncode == 0 and done.stderr == "" and f"{odd!r}"[1:5] in done.stdout
    assert tree(tmp_path / odd / "json") == tree(GOLDEN / "json")


def test_the_folders_of_the_current_folder(tmp_path: Path) -> None:
    done = mipgen("generate", cwd=tmp_path)
    assert done.returncode == 1 and done.stdout == ""
    assert done.stderr == (
        "spec: error: there is no specification here: protocol.yaml is missing; specify its folder with --spec, "
        "or create one with 'mipgen new FOLDER'\n"
    )
    shutil.copytree(INVENTED, tmp_path / "spec")
    assert mipgen("generate", "--target", "json", cwd=tmp_path).returncode == 0
    assert tree(tmp_path / "generated/json") == tree(GOLDEN / "json")
    assert mipgen("check", "--target", "json", cwd=tmp_path).returncode == 0
    assert sorted(p.name for p in tmp_path.iterdir()) == ["generated", "spec"]


def test_all_that_is_printed_arrives_or_is_missed() -> None:
    """A run skips the rest of Python's own shutdown."""
    command = [sys.executable, "-m", "mipgen"]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "generator"), "PYTHONUNBUFFERED": ""}
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, arguments.parser().format_help(), "")
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, env=environment, stdout=full, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (1, "mipgen: error: No space left on device\n")


def test_help(capsys: pytest.CaptureFixture[str]) -> None:
    """Without a command, it lists the commands; every command and every option says what it is for."""
    assert cli.main([]) == 0
    shown = capsys.readouterr().out
    for command, parser in commands().items():
        assert re.search(rf"^  {command}  +\w+", shown, re.M), command
        assert all(action.help for action in parser._actions), command
        with pytest.raises(SystemExit):
            cli.main([command, "--help"])
    for line in re.findall(r"^  mipgen (.*?)   ", arguments.EXAMPLES, re.M):
        cli.parser().parse_args(line.split())
    capsys.readouterr()
    with pytest.raises(SystemExit, match="0"):
        cli.main(["--version"])
    assert capsys.readouterr().out == f"mipgen {__version__}\n"


def commands() -> dict[str, Any]:
    (of,) = (action.choices for action in cli.parser()._actions if isinstance(action.choices, dict))
    return of


def test_targets(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["targets"]) == 0
    assert "c          C99, library mip\n" in capsys.readouterr().out


# --------------------------------------------------------------------------- nothing to do


def few() -> dict[str, bytes]:
    return {f"{name}/{path}": data for name in ("json", "kaitai") for path, data in tree(GOLDEN / name).items()}


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prepared")
    shutil.copytree(INVENTED, folder / "spec")
    assert generated(folder, made=True) == few()
    return folder


@pytest.fixture
def work(prepared: Path, tmp_path: Path) -> Path:
    """A folder with a specification, its output, and what was kept of that run."""
    return Path(shutil.copytree(prepared, tmp_path / "work"))


def generated(folder: Path, made: bool, *options: str, targets: tuple[str, ...] = TARGETS) -> dict[str, bytes]:
    """The output after a run; `made`: whether it had to be made."""
    calls, make = 0, build.make

    def count(*arguments: Any) -> Any:
        nonlocal calls
        calls += 1
        return make(*arguments)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "make", count)
        done = mipgen("generate", *targets, *options, cwd=folder, MIPGEN_CACHE=str(folder / "cache"))
    assert done.returncode == 0, done.stderr
    assert calls == made
    return tree(folder / "generated")


def test_nothing_changed(work: Path) -> None:
    before = {p: p.stat().st_mtime_ns for p in (work / "generated").rglob("*")}
    assert generated(work, made=False) == few()
    assert {p: p.stat().st_mtime_ns for p in (work / "generated").rglob("*")} == before
    first = mipgen("generate", *TARGETS, cwd=work, MIPGEN_CACHE="")
    command = [sys.executable, "-X", "importtime", "-m", "mipgen", "generate", *TARGETS]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "generator"), "MIPGEN_CACHE": str(work / "cache")}
    second = subprocess.run(command, capture_output=True, text=True, cwd=work, env=environment)
    assert first.stdout == second.stdout and " 0 changed" in first.stdout
    assert not re.search(r"\| +yaml$", second.stderr, re.M), "a run with nothing to do loads the parser"


@pytest.mark.parametrize("path", ["kaitai/mip.ksy", "kaitai/.manifest", "json/README.md"])
def test_an_output_that_was_changed_or_is_gone_is_written_again(work: Path, path: str) -> None:
    file = work / "generated" / path
    status = file.stat()
    file.write_bytes(file.read_bytes()[:-2] + b"!\n")
    os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))
    assert generated(work, made=True) == few()
    file.unlink()
    assert generated(work, made=True) == few()
    assert generated(work, made=False) == few()


def test_a_change_of_the_specification_is_seen(work: Path) -> None:
    file = work / "spec/devices" / sorted(os.listdir(work / "spec/devices"))[0]
    status, text = file.stat(), file.read_text("utf-8")
    title = re.search(r"^title: (.*)$", text, re.M)
    assert title is not None
    file.write_text(text.replace(title[1], title[1][::-1]), "utf-8")
    os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))  # as if it had not been touched
    assert generated(work, made=True) != few()
    file.write_text(text, "utf-8")
    assert generated(work, made=True) == few()  # the output is another one
    assert generated(work, made=False) == few()


def test_other_targets_are_other_work(work: Path) -> None:
    shutil.rmtree(work / "generated")
    for made in (True, False):
        found = generated(work, made, targets=("--target", "json"))
        assert set(found) == {f"json/{p}" for p in tree(GOLDEN / "json")}
    assert generated(work, made=True) == few()


def test_a_change_of_a_template_is_seen(work: Path) -> None:
    template = work / "targets/kaitai/README.md.j2"
    template.parent.mkdir(parents=True)
    for text, made in (("one", True), ("one", False), ("two", True)):
        template.write_text(f"{text}\n")
        assert generated(work, made, "--target-path", "targets")["kaitai/README.md"] == f"{text}\n".encode()


def test_a_target_of_the_user_is_always_asked(work: Path) -> None:
    """What its module reads is unknown."""
    (work / "targets/note").mkdir(parents=True)
    (work / "targets/note/target.py").write_text(
        "from mipgen.emit.target import File, Target\n"
        "def files(model): yield File('note.txt', 'note.j2', {'text': open('note.txt').read()})\n"
        "TARGET = Target(title='a note', files=files)\n"
    )
    (work / "targets/note/note.j2").write_text("{{ text }}")
    for text in ("one", "two"):
        (work / "note.txt").write_text(text)
        assert (
            generated(work, True, "--target-path", "targets", targets=("--target", "note"))["note/note.txt"]
            == text.encode()
        )


def test_the_program_is_part_of_the_input(tmp_path: Path) -> None:
    keys = []
    copy = tmp_path / "copy"
    for part in ("generator", "templates", "runtime", "spec/schema", "examples", "docs/parts"):
        shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", copy)
    for path in (None, "generator/mipgen/emit/naming.py", "templates/c/README.md.j2", "spec/schema/common.schema.json"):
        if path:
            (copy / path).write_bytes((copy / path).read_bytes() + b"\n")
        code = "from mipgen.emit import stamp; print(stamp.program())"
        keys.append(subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True,
            env={**os.environ, "PYTHONPATH": str(copy / "generator")},
        ).stdout)  # fmt: skip
    assert len(set(keys)) == 4


def test_so_is_each_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    before = stamp.program.__wrapped__()
    assert stamp.program.__wrapped__() == before
    (tmp_path / "ruff-99.0.dist-info").mkdir()
    assert stamp.program.__wrapped__() != before


def test_a_folder_that_is_too_large_is_not_remembered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a").write_bytes(bytes(100))
    assert stamp.run_key([tmp_path]) is not None
    monkeypatch.setattr(stamp, "TOO_MUCH", 99)
    assert stamp.run_key([tmp_path]) is None


def test_the_same_files_in_other_folders_are_another_input(tmp_path: Path) -> None:
    """A file moves from a specification to the overlay behind it."""
    first, second = tmp_path / "first", tmp_path / "second"
    for name in ("first/a", "first/b", "second/c"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(name)
    before = stamp.run_key([first, second])
    (first / "b").rename(second / "b")
    assert stamp.run_key([first, second]) != before


def test_files_behind_links_are_an_input_too(tmp_path: Path) -> None:
    """A folder may be a link, even to what contains it; a pipe is not read, as it would never end."""
    spec, real = tmp_path / "spec", tmp_path / "real"
    for folder in (spec, real):
        folder.mkdir()
    (spec / "sets").symlink_to(real)
    (real / "again").symlink_to(spec)
    os.mkfifo(spec / "pipe")
    keys = []
    for name in ("sets/a.yaml", "sets/.hidden"):
        keys.append(stamp.run_key([spec]))
        (spec / name).write_text(name)
    assert len({*keys, stamp.run_key([spec])}) == 3


# --------------------------------------------------------------------------- processes


def test_processes_are_no_more_than_processors(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each takes the next item when it is done with one; the results are in the order of the items."""
    monkeypatch.setattr(parallel, "_processors", lambda: 2)
    found = parallel.each(lambda n: (n, os.getpid(), bytes(400 * n)), range(500))
    assert [(n, len(large)) for n, _, large in found] == [(n, 400 * n) for n in range(500)]
    assert os.getpid() not in {process for _, process, _ in found} and len({process for _, process, _ in found}) <= 2


def test_what_fails_in_a_process_is_raised_here() -> None:
    def fail(n: int) -> int:
        if n == 2:
            raise Failure("two is not liked", "here")
        return n

    with pytest.raises(Failure, match=r"^here: error: two is not liked$"):
        parallel.each(fail, [1, 2, 3])
    with pytest.raises(ZeroDivisionError):
        parallel.each(lambda n: 1 // n, [1, 0])
    with pytest.raises(BrokenProcessPool):
        parallel.each(lambda n: os._exit(n), [0, 3])


def test_names_that_collide_are_reported_for_all_targets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copytree(BASE, tmp_path / "spec")
    (tmp_path / "spec/types/bad.yaml").write_text(
        "types:\n"
        "  gnss_1: {enum: u8, description: A., values: {x: 1}}\n"
        "  gnss1: {enum: u8, description: A., values: {x: 1}}\n"
    )
    for command in (["validate"], ["generate", "--out", str(tmp_path / "out")]):
        assert cli.main([*command, "--spec", str(tmp_path / "spec")]) == 1
        shown = capsys.readouterr()
        assert {"python", "rust"} <= set(re.findall(r"of the target (\w+)", shown.err)) and shown.out == ""
        assert "problems; nothing was written" in shown.err
    assert not (tmp_path / "out").exists()
