"""The examples of the crate microstrain-inertial at a virtual device: a client that this project has not written."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from itertools import islice
from pathlib import Path

import pytest
from support import BUILD, locked, need, nightly
from virtual.test_live import simulated

pytestmark = nightly("the crate microstrain-inertial, from crates.io")

VERSION = "0.0.2"
MANIFEST = f"""\
[package]
name = "asks-for-it"
version = "0.0.0"
edition = "2024"

[lib]
path = "lib.rs"

[dependencies]
microstrain-inertial = "={VERSION}"
"""
#: The examples never list ports with it, and its default features need the header files of udev.
SERIALPORT = '[dev-dependencies.serialport]\nversion = "4.8.1"\n'


def cargo(folder: Path, *arguments: str) -> str:
    environment = {**os.environ, "CARGO_TARGET_DIR": str(folder / "target")}
    command = [need("cargo"), *arguments]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def examples() -> Path:
    """The folder of the built examples, unchanged but for the features of one dependency."""
    folder = BUILD / "crate"
    with locked(folder):
        if not (folder / "built").exists():
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            (folder / "lib.rs").touch()
            (folder / "Cargo.toml").write_text(MANIFEST, "utf-8")
            packages = json.loads(cargo(folder, "metadata", "--format-version=1"))["packages"]
            (found,) = [p["manifest_path"] for p in packages if p["name"] == "microstrain-inertial"]
            shutil.copytree(Path(found).parent, folder / "crate")
            manifest = folder / "crate/Cargo.toml"
            text = manifest.read_text("utf-8")
            assert SERIALPORT in text
            manifest.write_text(text.replace(SERIALPORT, f"{SERIALPORT}default-features = false\n"), "utf-8")
            manifest.write_text(f"{manifest.read_text('utf-8')}\n[workspace]\n", "utf-8")
            cargo(folder / "crate", "build", "--quiet", "--examples")
            (folder / "built").touch()
    return folder / "crate/target/debug/examples"


def lines(example: str, port: str, count: int) -> list[str]:
    """What it prints first; it may run forever."""
    with subprocess.Popen([str(examples() / example), port], stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        found = list(islice(running.stdout, count))
        running.kill()
    return found


@pytest.mark.parametrize("model", ["3dm-cv7-ahrs", "3dm-cv7-gnss-ins"])
def test_the_examples_of_the_crate(model: str, tmp_path: Path) -> None:
    """They get an answer, and show gravity, and an attitude."""
    examples()  # built before the device runs
    port = str(tmp_path / "port")
    with simulated("--pty", port, device=model):
        assert lines("ping", port, 1) == ["Ping resp: Ack\n"]
        for example, gravity in (("read_sensors", -1.0), ("filter_mode", 0.0)):
            heading, first, _, second = lines(example, port, 4)
            assert heading.split()[-1] in ("Mag", "Accel")
            for line in (first, second):
                part = next(x for x in line.split(" | ") if x.startswith("x:"))
                x, y, z = (float(value.partition(":")[2]) for value in part.split(","))
                assert abs(x) < 0.3 and abs(y) < 0.3 and abs(z - gravity) < 0.3, line
