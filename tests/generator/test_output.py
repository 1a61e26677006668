"""A folder of output: what is written, what is left alone, and runs that are interrupted."""

from __future__ import annotations

import os
import re
import shutil
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from mipgen import cli
from mipgen.base.resources import MANIFEST
from mipgen.emit import output
from support import SPECS, tree

INVENTED, GOLDEN = SPECS["invented"]


def files(**contents: str) -> dict[str, bytes]:
    made = {name.replace("__", "/").replace("_", "."): text.encode() for name, text in contents.items()}
    return {**made, MANIFEST: output.manifest(made)}


#: What two versions of a target make: files that stay, change, come and go, and folders that come and go.
OLD = files(LICENSE="x", a_c="old", both__b_c="old", gone__g_c="g", gone__deeper__g_c="g", a_h="h")
NEW = files(LICENSE="x", a_c="new", both__b_c="new", come__c_c="c", come__deeper__c_c="c", b_h="h")
MINE = {"mine.txt": b"mine", "both/mine.txt": b"mine"}


def lay(folder: Path, contents: dict[str, bytes]) -> None:
    for name, data in contents.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


def folders(folder: Path) -> set[str]:
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_dir()}


def what(made: dict[str, bytes], folder: Path) -> dict[str, str]:
    return {d.path: d.what for d in output.compare(made, folder)}


# --------------------------------------------------------------------------- interruptions


class Killed(BaseException):
    pass


def killed(monkeypatch: pytest.MonkeyPatch, made: dict[str, bytes], folder: Path) -> Iterator[int]:
    """Writing the files is killed one step later each time, until it succeeds; a file may be written in part."""
    for last in range(1000):
        step = 0

        def count(call: Any, path: Path, *arguments: Any, last: int = last, **named: Any) -> Any:
            nonlocal step
            step += 1
            if step > last:
                if call.__name__ == "write_bytes":
                    call(path, arguments[0][: len(arguments[0]) // 2])
                raise Killed
            return call(path, *arguments, **named)

        with monkeypatch.context() as patch:
            for name in ("mkdir", "write_bytes", "replace", "unlink", "rmdir"):
                call = getattr(Path, name)
                patch.setattr(Path, name, lambda path, *a, call=call, count=count, **n: count(call, path, *a, **n))
            try:
                output.write(made, folder)
            except Killed:
                pass
            else:
                return
        yield last


@pytest.mark.parametrize("then", [OLD, NEW], ids=["the old files", "the new files"])
@pytest.mark.parametrize("before", [{}, OLD, OLD | MINE], ids=["nothing", "old files", "old files and mine"])
def test_whatever_interrupts_a_run_the_next_one_finishes_it(
    before: dict[str, bytes], then: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "c"
    mine = {name: data for name, data in before.items() if name in MINE}
    lay(folder, before)
    steps = 0
    for step in killed(monkeypatch, NEW, folder):
        steps += 1
        found = what(then, folder)
        assert {name for name, of in found.items() if of in output.OTHERS} == mine.keys(), step
        output.write(then, folder)
        assert tree(folder) == {**then, **mine}, step
        assert folders(folder) == output._parents(then | mine) - {""}, step
        shutil.rmtree(folder)
        lay(folder, before)
    assert steps > 15
    assert tree(folder) == {**NEW, **mine}


def test_a_file_that_was_left_half_written_goes_although_nothing_else_is_to_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--spec", str(INVENTED), "--target", "kaitai", "--out", str(tmp_path)]
    assert cli.main(["generate", *options]) == 0
    part = tmp_path / "kaitai/mip.ksy.4711.part"
    part.write_text("half")
    capsys.readouterr()
    assert cli.main(["check", *options]) == 1
    shown = capsys.readouterr().err
    assert shown.startswith(f"{part}: error: stale\nmipgen: 1 file to update; run: mipgen generate --spec")
    assert cli.main(["generate", *options]) == 0 and cli.main(["check", *options]) == 0
    assert tree(tmp_path / "kaitai") == tree(GOLDEN / "kaitai")


# --------------------------------------------------------------------------- what others put there


def link(path: Path, to: str | Path) -> None:
    path.unlink(missing_ok=True)
    path.symlink_to(to)


#: What is in the way of ros2/ or of its files after a run -> what is done to put it there.
IN_THE_WAY: dict[str, tuple[str, Any]] = {
    "a manifest of somebody else": ("ros2/.manifest", lambda p: p.write_text("LICENSE\nREADME.md\nsrc/mip.h\n")),
    "an empty manifest": ("ros2/.manifest", lambda p: p.write_text("")),
    "a manifest that is a folder": ("ros2/.manifest", lambda p: (p.unlink(), p.mkdir())),
    "a link that leads nowhere": ("ros2/README.md", lambda p: link(p, "nowhere")),
    "a link to itself": ("ros2/README.md", lambda p: link(p, p)),
    "a link to another file": ("ros2/README.md", lambda p: link(p, "LICENSE")),
    "a folder in place of a file": ("ros2/README.md", lambda p: (p.unlink(), p.mkdir())),
    "a file in place of a folder": ("ros2/msg", lambda p: (shutil.rmtree(p), p.write_text("mine"))),
    "a link in place of a folder": ("ros2/msg", lambda p: (shutil.rmtree(p), p.symlink_to("nowhere"))),
    "a file in place of the target": ("ros2", lambda p: (shutil.rmtree(p), p.write_text("mine"))),
    "a link in place of the target": ("ros2", lambda p: (shutil.rmtree(p), p.symlink_to("nowhere"))),
    "a pipe": ("ros2/README.md", lambda p: (p.unlink(), os.mkfifo(p))),
}


@pytest.mark.parametrize("of", IN_THE_WAY)
def test_what_is_in_the_way_is_named_and_nothing_is_written(
    of: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name, put = IN_THE_WAY[of]
    out = tmp_path / "out"
    options = ["--spec", str(INVENTED), "--target", "ros2", "--target", "json", "--out", str(out)]
    shutil.copytree(GOLDEN / "ros2", out / "ros2")
    put(out / name)
    before = state(out)
    assert cli.main(["check", *options]) == 1
    shown = capsys.readouterr().err
    assert f"{out / name}: error: foreign\n" in shown
    assert re.search(r"^mipgen: \d+ files? that mipgen did not write; move or delete (it|them)$", shown, re.M)
    assert cli.main(["generate", *options]) == 1
    shown = capsys.readouterr().err
    assert shown.startswith(
        f"{out}: error: mipgen would replace these files, but no .manifest lists them as its own; "
        "move or delete them, or choose another --out:\n"
    )
    assert f"\n  {out / name}\n" in shown
    assert state(out) == before
    shutil.rmtree(out / name) if (out / name).is_dir() else (out / name).unlink()
    assert cli.main(["generate", *options]) == 0 and tree(out / "ros2") == tree(GOLDEN / "ros2")


def state(folder: Path) -> dict[str, Any]:
    """The content of a folder: files, the targets of links, and the kind of anything else."""
    return {
        str(p): os.readlink(p) if p.is_symlink() else p.read_bytes() if p.is_file() else stat.S_IFMT(p.stat().st_mode)
        for p in folder.rglob("*")
    }


def test_a_link_to_what_would_be_written_is_no_harm(tmp_path: Path) -> None:
    """As in a folder of links; there is nothing to write."""
    lay(tmp_path / "there", NEW)
    lay(tmp_path / "c", NEW)
    link(tmp_path / "c/a.c", tmp_path / "there/a.c")
    assert output.compare(NEW, tmp_path / "c") == []


def test_a_manifest_of_others_does_not_make_files_stale(tmp_path: Path) -> None:
    lay(tmp_path, {MANIFEST: b"LICENSE\nmine.txt\n", "mine.txt": b"mine"})
    assert what(NEW, tmp_path)["mine.txt"] == "untracked" and what(NEW, tmp_path)[MANIFEST] == "foreign"


def test_folders_of_build_tools(tmp_path: Path) -> None:
    """What is built in the output is not looked at, but the output may have folders of these names."""
    made = files(LICENSE="x", docs__build__page_md="page", target__lib_rs="lib")
    lay(tmp_path, made)
    lay(tmp_path, {"build/object.o": b"", "a/dist/b.whl": b"", "it.egg-info/PKG-INFO": b"", "docs/mine.md": b""})
    assert what(made, tmp_path) == {"docs/mine.md": "untracked"}


def test_the_remedy_is_that_of_each_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`generate` does not remove what mipgen did not write."""
    out = tmp_path / "out"
    shutil.copytree(GOLDEN / "json", out / "json")
    options = ["check", "--spec", str(INVENTED), "--target", "json", "--out", str(out)]
    (out / "json/mine.txt").write_text("mine")
    assert cli.main(options) == 1
    assert capsys.readouterr().err == (
        f"{out}/json/mine.txt: error: untracked\nmipgen: 1 file that mipgen did not write; move or delete it\n"
    )
    (out / "json/yours.txt").write_text("yours")
    (out / "json/LICENSE").write_text("changed")
    (out / "json/README.md").unlink()
    assert cli.main(options) == 1
    assert capsys.readouterr().err.splitlines() == [
        *(f"{out}/json/{name}: error: {what}" for name, what in (("LICENSE", "changed"), ("README.md", "missing"))),
        *(f"{out}/json/{name}: error: untracked" for name in ("mine.txt", "yours.txt")),
        "mipgen: 2 files that mipgen did not write; move or delete them",
        f"mipgen: 2 files to update; run: mipgen generate --spec {INVENTED} --out {out} --target json",
    ]
