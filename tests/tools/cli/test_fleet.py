"""Many logs as one data set: its rows are those of the logs, whenever a run was interrupted."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from mip_tools import fleet, read_log
from mip_tools.errors import Failure, Misuse
from mip_tools.fleet import dataset, sources, store
from program import ENVIRONMENT, log, mip, until
from support import NIGHTLY, SEED, heavy, later

arrow = later("pyarrow")
parquet = later("pyarrow.parquet")


def logs(folder: Path, count: int = 5) -> Path:
    """Logs of different length, and two files that are not logs."""
    for i in range(count):
        path = folder / f"car {i % 2}" / f"drive{i}.bin"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(log(1.0 + i))
    (folder / "text.bin").write_bytes(b"no packets\n" * 100)
    (folder / "empty.bin").write_bytes(b"")
    return folder


def rows(out: Path) -> dict[tuple[str, str, str], Any]:
    """(clock, field, log) -> its rows, only from files in the manifest. Each file is read as it is."""
    found: dict[tuple[str, str, str], list[Any]] = {}
    for one in fleet.open(out).manifest.files:
        table = parquet.read_table(out / one.path, partitioning=None)
        assert len(table) == one.rows
        for name in sorted(set(table["log"].to_pylist())):
            own = table.filter(arrow.compute.equal(table["log"].cast("string"), name))
            found.setdefault((one.clock, one.field, name), []).append(own)
    return {key: arrow.concat_tables(t).sort_by("offset") for key, t in found.items()}


def expected(folder: Path) -> dict[tuple[str, str, str], Any]:
    """The same from `Log.frame`."""
    found = {}
    for path in sorted(folder.rglob("drive*.bin")):
        with read_log(path) as source:
            for one in source.types():
                if one.type is not None and one.set >= 0x80:
                    kind = one.type.name_in(one.set)
                    table = source.frame(kind, library="pyarrow", position=True).drop_columns(["packet"])
                    clock = source.times(source[kind]).clock or "none"
                    found[clock, kind, path.relative_to(folder).as_posix()] = table.sort_by("offset")
    return found


def assert_complete(out: Path, folder: Path) -> None:
    """The rows, the columns and their metadata are those of the logs, and nothing else is in the folder."""
    have, want = rows(out), expected(folder)
    assert have.keys() == want.keys()
    for key, table in want.items():
        same = have[key].drop_columns(["log", "device"])
        assert same.schema.equals(table.schema, check_metadata=True), key
        assert same.equals(table), key
    manifest = fleet.open(out).manifest
    every = {p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()}
    assert every == {one.path for one in manifest.files} | {"_manifest.json", "_catalogue.parquet", "_lock"}
    assert manifest.rows == sum(map(len, want.values())) == sum(one.rows for one in manifest.logs)


@heavy("workers")
def test_a_data_set_has_the_rows_of_its_logs(tmp_path: Path) -> None:
    folder, out = logs(tmp_path / "logs"), tmp_path / "out"
    code, said, errors = mip("fleet", folder, "-o", out, "--workers", "2")
    assert code == 1 and "5 logs added, 0 known, 2 failed" in said
    assert errors == "".join(f"mip fleet: {name}.bin: the file has no MIP packets\n" for name in ("empty", "text"))
    assert_complete(out, folder)
    catalogue = fleet.open(out).catalogue().to_pylist()
    assert {row["log"] for row in catalogue} == {one.name for one in fleet.open(out).manifest.logs}
    sensor = next(row for row in catalogue if row["log"] == "car 1/drive3.bin" and row["set"] == "sensor")
    assert sensor["device"] is None and sensor["rate"] == pytest.approx(100) and sensor["gaps"] == 0
    assert (sensor["last_utc"] - sensor["first_utc"]).total_seconds() == pytest.approx(4, abs=0.1)
    table = fleet.open(out).dataset("sensor.scaled_accel").to_table()
    assert set(table["log"].to_pylist()) == {row["log"] for row in catalogue}
    with pytest.raises(LookupError, match="no such rows"):
        fleet.open(out).files("sensor.scaled_gyrox")
    # A second run adds nothing: a log under another name is known, and another log under a known name is rejected.
    before = rows(out)
    shutil.copy(folder / "car 0/drive0.bin", folder / "copy.bin")
    (folder / "car 0/drive2.bin").write_bytes(log(0.5))
    built = fleet.build_dataset(folder, out, workers=1)
    assert built.added == [] and "copy.bin" in built.unchanged and "has changed" in built.failed["car 0/drive2.bin"]
    assert rows(out).keys() == before.keys()
    with pytest.raises(Failure, match=r"only .*; use the same options, or another folder"):
        fleet.build_dataset(folder, out, only=["sensor"])


@heavy("workers")
def test_a_run_that_fails_anywhere_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, out = logs(tmp_path / "logs", 2), tmp_path / "out"
    fleet.build_dataset(folder, out)
    logs(folder, 4)
    whole = tmp_path / "whole"
    fleet.build_dataset(folder, whole)
    replace, places = os.replace, 0

    def counted(*paths: Any) -> None:
        nonlocal places
        if places == 0:
            raise OSError("no more")
        places -= 1
        replace(*paths)

    before = rows(out)
    for stop in (0, 1, 6, 13, 20, 26):
        trial = tmp_path / f"trial{stop}"
        shutil.copytree(out, trial)
        monkeypatch.setattr(dataset.os, "replace", counted)
        places = stop
        try:
            fleet.build_dataset(folder, trial)
        except Failure:
            assert rows(trial).keys() == before.keys()  # the manifest still has what was there
        monkeypatch.setattr(dataset.os, "replace", replace)
        if places == 0:
            fleet.build_dataset(folder, trial)
        assert_complete(trial, folder)
        shutil.rmtree(trial)


PROGRAM = """
import sys
from mip_tools import fleet
if __name__ == "__main__":
    fleet.build_dataset(*sys.argv[1:3], workers=2)
"""


@heavy("workers")
def test_workers_and_the_parent_are_killed(tmp_path: Path) -> None:
    import psutil

    random_ = random.Random(SEED)
    folder, out = logs(tmp_path / "logs", 8), tmp_path / "out"
    for turn in range(30 if NIGHTLY else 4):
        started = subprocess.Popen(
            [sys.executable, "-c", PROGRAM, folder, out], env=ENVIRONMENT, stderr=subprocess.DEVNULL
        )
        process = psutil.Process(started.pid)
        at_work = "_work/*.*/*" if turn % 2 else "_work/*.*"
        until(lambda run=started, place=at_work: any(out.glob(place)) or run.poll() is not None)  # it may have ended
        time.sleep(random_.random() * 0.5)
        family = process.children(recursive=True) if started.poll() is None else []
        victims = [one for one in family if "spawn_main" in " ".join(cmdline(one))]
        if turn % 2 and victims:  # a worker: the run goes on without it
            random_.choice(victims).kill()
            assert started.wait(120) == 0
            assert_complete(out, folder)
            shutil.rmtree(out)
        else:  # the parent: its workers end by themselves
            started.kill()
            started.wait(10)
            psutil.wait_procs(family, 20)
            assert not [one for one in family if one.is_running() and one.status() != "zombie"]
    assert subprocess.run([sys.executable, "-c", PROGRAM, folder, out], env=ENVIRONMENT).returncode == 0
    assert_complete(out, folder)


def cmdline(process: Any) -> list[str]:
    import psutil

    try:
        return list(process.cmdline())
    except psutil.Error:
        return []


@heavy("workers")
def test_urls_and_what_is_wrong(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "logs/a").mkdir(parents=True)
    (tmp_path / "logs/a/drive0.bin").write_bytes(log(1.0))
    place = f"file://{tmp_path}/logs"
    fleet.build_dataset(place, f"file://{tmp_path}/out", workers=1)
    assert_complete(tmp_path / "out", tmp_path / "logs")
    with pytest.raises(Misuse, match=r"both called drive0\.bin"):
        fleet.build_dataset([tmp_path / "logs/a", f"{place}/a"], tmp_path / "out")
    with pytest.raises(Misuse, match=r"s3://bucket/out: Install s3fs"):
        fleet.build_dataset(place, "s3://bucket/out")

    def unreachable(*_: Any) -> bool:
        raise ConnectionError("no route to host\nwhile reading")

    monkeypatch.setattr("fsspec.implementations.local.LocalFileSystem.isdir", unreachable)
    with pytest.raises(Failure, match=r"^file://.* cannot be read: no route to host$"):
        fleet.build_dataset(place, tmp_path / "out")
    with dataset.alone(tmp_path / "out"), pytest.raises(Failure, match="another run is active"):
        fleet.build_dataset(tmp_path / "logs", tmp_path / "out")


@heavy("workers")
def test_a_data_set_in_a_store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is extended as one in a folder. If not all files of a run can be sent, the manifest is the earlier one."""
    memory = later("fsspec").filesystem("memory")
    top = f"/{tmp_path.name}/data"
    url, folder = f"memory:/{top}", logs(tmp_path / "logs", 2)
    assert len(fleet.build_dataset(folder / "car 0", url, workers=1).added) == 1
    before = memory.cat_file(f"{top}/{dataset.MANIFEST}")
    put = type(memory).put_file

    def full(self: Any, source: str, place: str) -> None:
        if place.endswith(dataset.CATALOGUE):
            raise OSError("no space")
        put(self, source, place)

    with monkeypatch.context() as broken:
        broken.setattr(type(memory), "put_file", full)
        with pytest.raises(Failure, match=f"^{url} cannot be written: no space$"):
            fleet.build_dataset(folder / "car 1", url, workers=1)
    assert memory.cat_file(f"{top}/{dataset.MANIFEST}") == before
    with pytest.raises(Failure, match=f"^{url} was made with only .*; use the same options, or another folder$"):
        fleet.build_dataset(folder / "car 1", url, only=["sensor"], workers=1)
    with pytest.raises(Failure, match=f"^another run has changed {url} meanwhile; run again$"), store.staged(url):
        memory.pipe_file(f"{top}/{dataset.MANIFEST}", before + b"\n")
    status, text, _ = mip("fleet", folder / "car 1", "-o", url, "--workers", "1")
    assert status == 0 and text.startswith(f"{url}: 1 log added, 0 known, 0 failed; ") and " of 2 logs in " in text
    assert not fleet.build_dataset([folder / "car 0", folder / "car 1"], url, workers=1).added
    memory.get(f"{top}/", f"{tmp_path}/out/", recursive=True)
    wanted = {(*key[:2], Path(key[2]).name): len(table) for key, table in expected(folder).items()}
    assert {key: len(table) for key, table in rows(tmp_path / "out").items()} == wanted
    catalogue = fleet.open(tmp_path / "out").catalogue()
    assert set(catalogue["log"].to_pylist()) == {key[2] for key in wanted}


def test_names_of_logs(tmp_path: Path) -> None:
    for name in ("a/1.bin", "b/1.bin", "b/2.mip"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(name.encode())
    both = sources.find_logs([str(tmp_path)], "*.bin")
    assert [one.name for one in both] == ["a/1.bin", "b/1.bin"]
    assert sources.find_logs([str(tmp_path / "a"), str(tmp_path / "a/1.bin")], "*.bin")[0].name == "1.bin"
    with pytest.raises(Misuse, match=r"are both called 1\.bin"):
        sources.find_logs([str(tmp_path / "a"), str(tmp_path / "b")], "*.bin")
    for given, said in ((tmp_path / "c", "does not exist"), (tmp_path / "b", r"has no files that match \*.log")):
        with pytest.raises(Misuse, match=said):
            sources.find_logs([str(given)], "*.log")
    code, _, error = mip("fleet", tmp_path, "-o", tmp_path / "out", "--only", "sensor.acel")
    assert code == 2 and "did you mean" in error
