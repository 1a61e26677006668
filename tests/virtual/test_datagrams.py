"""Replies over UDP that arrive twice, late or out of order: none is lost, and no later one stays behind."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from c_build import SANITIZE, SANITIZED, archive, compiled
from support import PATIENCE, PYTHONPATH, ROOT, at_hand, heavy, need, uses

pytestmark = uses()  # the languages at hand

HERE = Path(__file__).parent / "datagrams"
FAULTS = "double_packet=0.1,repeat_packet=0.1:0.02,reorder_packet=0.1:0.02"

#: Pairs in a row that may be wrong: a copy can arrive while a command waits, and on a busy machine the reply to that
#: after the next one was sent.
LONGEST = 10


def programs(path: Path) -> dict[str, list[str]]:
    """In the languages at hand, except Rust: its crate is built for heavy tests."""
    library = archive("real", "cc", *SANITIZED)
    found = {
        "c": [str(compiled(path / "c", "real", "cc", HERE / "pairs.c", *SANITIZED, library=library))],
        "python": [sys.executable, str(HERE / "pairs.py")],
    }
    if at_hand("cpp"):
        flags = ["-std=c++17", "-DMIP_WHOLE_ARRAYS", *SANITIZE]
        found["cpp"] = [str(compiled(path / "cpp", "real", "g++", HERE / "pairs.cpp", *flags, library=library))]
    if at_hand("javascript"):
        (path / "node_modules").mkdir()
        (path / "node_modules/mip-protocol").symlink_to(ROOT / "generated/javascript")
        script = path / "pairs.mjs"
        script.write_text((HERE / "pairs.mjs").read_text())
        found["javascript"] = [need("node"), str(script)]
    return found


def asked(path: Path, command: Sequence[str], pairs: int) -> dict[str, int]:
    """Runs a program at a UDP port of a virtual device; returns what it counts, and `sent`: the fields of replies."""
    log, environment = path / "faults.jsonl", {**os.environ, "PYTHONPATH": PYTHONPATH}
    options = ["--udp", "0", "--fault", FAULTS, "--fault-log", str(log), "--log-packets"]
    simulator = [sys.executable, "-m", "mip_tools", "simulate", "3dm-cv7-gnss-ins", *options]
    with subprocess.Popen(simulator, env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        place = process.stdout.readline().strip().rpartition(":")[2]
        done = subprocess.run(
            [*command, place, str(pairs)], env=environment, stdout=subprocess.PIPE, text=True, timeout=PATIENCE
        )
        process.terminate()
    entries = map(json.loads, log.read_text("utf-8").splitlines())
    replies = sum(entry["kind"] in ("sent", "double_packet", "repeat_packet") for entry in entries)
    return json.loads(done.stdout) | {"sent": 2 * replies}  # acknowledge and base rate


def check(path: Path, commands: dict[str, list[str]], pairs: int) -> None:
    with ThreadPoolExecutor() as pool:
        folders = [path / f"device-{language}" for language in commands]
        for folder in folders:
            folder.mkdir()
        counts = list(pool.map(asked, folders, commands.values(), [pairs] * len(commands)))
    for language, count in zip(commands, counts, strict=True):
        assert count["right"] + count["stale"] == pairs and count["other"] == 0, (language, count)
        assert count["longest"] <= LONGEST, (language, count)
        assert 2 * pairs + count["kept"] == count["sent"] > 2 * pairs, (language, count)


def test_replies_stay_those_of_their_commands(tmp_path: Path) -> None:
    check(tmp_path, programs(tmp_path), 50)


@heavy("500 commands over UDP in each language")
def test_a_long_conversation(tmp_path: Path) -> None:
    check(tmp_path, programs(tmp_path), 500)
