"""`make interop`: the vendor's example programs, unchanged, on virtual devices of the models that they name.

Nothing of the SDK is here: PEER names a folder of it. Its programs open a fixed port; port.c, loaded before them, opens
that of the virtual device. A program completes if it ends with 0 or not at all, and has printed data if it streams.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
BUILD = ROOT / "build/interop"
PYTHONPATH = os.pathsep.join((str(ROOT / "tools"), str(ROOT / "generated/python")))
#: Seconds for a run: the programs print for 30 seconds, and capture the gyroscope bias before.
LIMIT = 120
#: Runs at once: the programs mostly wait.
TOGETHER = 12
#: Programs that print what they get once, and end.
BRIEF = ("device_info",)
#: Programs of packets, without a device.
OFFLINE = ("mip_packet",)
MODEL = re.compile(r"3DM-[A-Z]+\d-[A-Z]+(?:/[A-Z]+)?")

#: A line of data: the numbers of a vector, or the packet that arrived.
DATA = re.compile(r"\[ *-?\d+\.\d+, .*|Received a packet .*")
#: How many devices may start at the same time, so that they answer in time.
STARTING = threading.Semaphore(2)


@dataclass(frozen=True)
class Program:
    name: str  # as its folder: "7_series/ahrs"
    language: str
    path: Path
    models: tuple[str, ...]


@dataclass(frozen=True)
class Run:
    program: Program
    model: str
    connection: str  # "pty" or "tcp"


@dataclass(frozen=True)
class Outcome:
    run: Run
    complete: bool
    text: str  # what it printed, or the line where it gave up


def build(sdk: Path) -> Path:
    """The folder of the programs, built if they are not yet."""
    if not (sdk / "examples").is_dir():
        raise SystemExit(f"interop: {sdk} is not a folder of the vendor's MIP SDK; name one: make interop PEER=FOLDER")
    if shutil.which("cmake") is None:
        raise SystemExit("interop: cmake is missing; install it (Debian: apt-get install cmake)")
    folder = BUILD / "sdk"
    folder.mkdir(parents=True, exist_ok=True)
    for command in (
        ["cmake", "-S", sdk, "-B", folder, "-G", "Unix Makefiles", "-DMICROSTRAIN_BUILD_EXAMPLES=ON"],
        ["cmake", "--build", folder, "-j2", "--", "--keep-going"],
        ["cc", "-shared", "-fPIC", "-O1", "-Wall", "-Wextra", HERE / "port.c", "-o", BUILD / "port.so", "-ldl"],
    ):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if not done.returncode:
            continue
        if "--build" not in command:
            raise SystemExit(f"interop: {command[0]} failed\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
        errors = [line for line in done.stderr.splitlines() if " error: " in line]  # of some of the programs
        print("interop: not all programs compile", *errors, sep="\n", file=sys.stderr)
    return folder


def programs(sdk: Path, built: Path) -> list[Program]:
    """The programs that need a device."""
    found = []
    for source in sorted(sdk.glob("examples/c*/**/*_example.c*")):
        language, *folders = source.parent.relative_to(sdk / "examples").parts
        name = "/".join(folders)
        path = built / "examples" / source.parent.relative_to(sdk / "examples") / f"{source.stem}_{language}"
        if name not in OFFLINE:
            found.append(Program(name, language, path, models(sdk, name, source.read_text("utf-8"))))
    return found


def models(sdk: Path, name: str, source: str) -> tuple[str, ...]:
    """The models that a program names; else those that the README lists for its series; else all that it lists."""
    if named := MODEL.findall(source):
        return tuple(sorted(set(named)))
    parts = re.split(r"^#+ *(\d)-Series Devices$", (sdk / "examples/README.md").read_text("utf-8"), flags=re.M)
    series = {number: MODEL.findall(text.split("\n#", 1)[0]) for number, text in zip(parts[1::2], parts[2::2])}
    wanted = [name[0]] if name[0] in series else sorted(series)
    return tuple(dict.fromkeys(model for number in wanted for model in series[number]))


def runs(found: list[Program]) -> list[Run]:
    """All at pseudo-terminals, and each program once more at TCP."""
    return [Run(p, model, "pty") for p in found for model in p.models] + [Run(p, p.models[0], "tcp") for p in found]


@contextmanager
def device(model: str, connection: str, notes: Path) -> Iterator[str]:
    """A virtual device, and the name of its port; its output goes to a file."""
    with tempfile.TemporaryDirectory() as folder, notes.open("w") as said:
        where = ["--pty", f"{folder}/port"] if connection == "pty" else ["--tcp", "0"]
        command = [sys.executable, "-m", "mip_tools", "simulate", model, *where]
        with STARTING:
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said, text=True,
                                       env={**os.environ, "PYTHONPATH": PYTHONPATH})  # fmt: skip
            assert process.stdout is not None
            port = process.stdout.readline().strip()
        try:
            if not port:
                raise RuntimeError(notes.read_text().strip())
            yield port
        finally:
            process.terminate()
            process.wait()


def play(run: Run) -> Outcome:
    """Runs one program on one device. The output of both is in the folder of logs."""
    if not run.program.path.is_file():
        return Outcome(run, False, "does not compile")
    name = f"{run.program.name}-{run.program.language}-{run.model}-{run.connection}".replace("/", "_")
    logs = BUILD / "logs"
    logs.mkdir(exist_ok=True)
    try:
        with device(run.model, run.connection, logs / f"{name}.device.txt") as port:
            environment = {**os.environ, "LD_PRELOAD": str(BUILD / "port.so"), "INTEROP_PORT": port}
            done = subprocess.run(["timeout", str(LIMIT), run.program.path], capture_output=True, text=True,
                                  stdin=subprocess.DEVNULL, env=environment)  # fmt: skip
    except RuntimeError as error:
        return Outcome(run, False, str(error))
    (logs / f"{name}.txt").write_text(done.stdout + done.stderr)
    return Outcome(run, *judge(run.program, done.returncode, done.stdout, done.stderr))


def again(outcome: Outcome) -> Outcome:
    """A time-out of two seconds may be due to the load of the machine: such a run is repeated alone."""
    if outcome.complete or "Timed out" not in outcome.text:
        return outcome
    second = play(outcome.run)
    return replace(second, text=f"{second.text}; before: {outcome.text}".removeprefix("; "))


def judge(program: Program, status: int, out: str, errors: str) -> tuple[bool, str]:
    """Returns whether a program completed, and a remark."""
    data = len(DATA.findall(out.partition("will now output data")[2]))
    if status == 0 and program.name in BRIEF:
        return True, ""
    if status == 0:
        return data > 0, f"{data} lines of data" if data else "it printed no data"
    if status == 124:
        return data > 0, f"stopped after {data} lines of data" if data else f"waits: {last(out)}"
    return False, last(errors or out)


def last(text: str) -> str:
    """The last lines that are not empty: the programs print a result, and what it is the result of."""
    lines = [line.split(": ", 1)[-1].strip() for line in text.splitlines() if line.strip()]
    return " ".join(lines[-2:])


def table(outcomes: list[Outcome]) -> str:
    """Program, model and connection; each language has a column."""
    rows: dict[tuple[str, str, str], dict[str, Outcome]] = {}
    for outcome in outcomes:
        run = outcome.run
        rows.setdefault((run.program.name, run.model, run.connection), {})[run.program.language] = outcome
    languages = sorted({o.run.program.language for o in outcomes})
    out = f"| Program | Model | Port | {' | '.join(languages)} |\n|{'---|' * (3 + len(languages))}\n"
    for key, cells in sorted(rows.items(), key=lambda row: (row[0][2], row[0])):
        texts = [cell(cells[language]) if language in cells else "" for language in languages]
        out += f"| {' | '.join((*key, *texts))} |\n"
    return out


def cell(outcome: Outcome) -> str:
    if outcome.complete:
        return f"completed ({outcome.text})" if outcome.text else "completed"
    return f"**{outcome.text}**"


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--peer", type=Path, default=Path(), help="a folder of the vendor's SDK")
    arguments.add_argument("--only", default="", help="programs whose name contains this")
    given = arguments.parse_args()
    sdk = given.peer.resolve()
    chosen = [p for p in programs(sdk, build(sdk)) if given.only in f"{p.language}/{p.name}"]
    with ThreadPoolExecutor(TOGETHER) as pool:
        outcomes = list(pool.map(play, runs(chosen)))
    outcomes = [again(outcome) for outcome in outcomes]
    print(table(outcomes))
    complete = sum(o.complete for o in outcomes)
    print(f"{complete} of {len(outcomes)} runs completed")
    sys.exit(complete < len(outcomes))


if __name__ == "__main__":
    main()
