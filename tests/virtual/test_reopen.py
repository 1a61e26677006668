"""A port that is pulled away under a stream is opened again, a hundred times, in each language: what was pending is
reported as lost, and no answer is taken for that of another command."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from c_build import archive, compiled, folder
from support import PATIENCE, PYTHONPATH, ROOT, heavy, need

HERE = Path(__file__).parent / "reopen"
PULLS = 100
DEVICE = "3dm-cv7-gnss-ins"
#: Simulated seconds until the first pull: until then, all have started their streams.
START = 4


@contextmanager
def pulled(path: Path, ports: list[str]) -> Iterator[list[str]]:
    """Runs devices at these ports, whose cables are pulled again and again; yields their addresses."""
    events = [{"at": START, "event": "disconnect", "for": 0.02, "every": 0.16}]
    (path / "scenario.yaml").write_text(json.dumps({"events": events}))
    simulate = [sys.executable, "-m", "mip_tools", "simulate", DEVICE, "--scenario", str(path / "scenario.yaml")]
    environment = {**os.environ, "PYTHONPATH": PYTHONPATH}
    processes, places = [], []
    try:
        for kind, _, place in (port.partition(":") for port in ports):
            command = [*simulate, f"--{kind}", place]
            processes.append(subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True))
        for process in processes:
            assert process.stdout is not None
            places.append(process.stdout.readline().strip())
        yield places
    finally:
        for process in processes:
            process.kill()
            process.communicate()


def checked(count: Mapping[str, Any]) -> None:
    """Each pull was reported once, and nothing else failed. The stream went on, except where the next pull came first
    on a busy machine."""
    assert count["reopened"] == PULLS and count["wrong"] == count["other"] == 0
    assert 0.5 * PULLS <= count["streamed"] <= PULLS and 0 < count["lost"] <= PULLS < count["answered"], count


@heavy("ports that are pulled away a hundred times")
def test_ports_are_opened_again(tmp_path: Path) -> None:
    flags = ["-O1", f"-I{folder('real') / 'ports'}"]
    library = archive("real", "cc", "-std=c99", "-O1")
    lines = sorted((folder("real") / "ports").glob("*.c"))
    c = compiled(tmp_path / "c", "real", "cc", HERE / "pulled.c", "-std=c99", *flags, also=lines, library=library)
    objects = []
    for line in lines:
        objects.append(tmp_path / f"{line.stem}.o")
        include = f"-I{folder('real') / 'src'}"
        subprocess.run([need("cc"), "-std=c99", *flags, include, "-c", line, "-o", objects[-1]], check=True)
    cpp = compiled(
        tmp_path / "cpp", "real", "c++", HERE / "pulled.cpp", "-std=c++17", *flags, also=objects, library=library
    )
    (tmp_path / "node_modules").mkdir()
    (tmp_path / "node_modules/mip-protocol").symlink_to(ROOT / "generated/javascript")
    script = tmp_path / "pulled.mjs"
    script.write_text((HERE / "pulled.mjs").read_text())
    programs: list[tuple[list[Any], str]] = [
        ([c], f"pty:{tmp_path}/c-port"),
        ([cpp], "tcp:0"),
        ([sys.executable, HERE / "pulled.py"], f"pty:{tmp_path}/python-port"),
        ([need("node"), script], "tcp:0"),
    ]
    with pulled(tmp_path, [port for _, port in programs]) as places:
        running = [
            subprocess.Popen(
                [*map(str, program), place.replace("localhost", "127.0.0.1"), str(PULLS)],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT,
                env={**os.environ, "PYTHONPATH": PYTHONPATH},
            )
            for (program, _), place in zip(programs, places, strict=True)
        ]  # fmt: skip
        for process in running:
            out, error = process.communicate(timeout=PATIENCE)
            assert process.returncode == 0, error
            checked(json.loads(out))
