"""`make bench PART=generate`: the time and memory of `mipgen generate`, after different changes and for each target.

A *loop* is the time of a pure-Python sum of 6 million squares on the same machine, measured right before and after each
run, so that figures compare between machines. The processor time is that of all processes; the memory is that of the
largest one.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
GENERATOR = ROOT / "generator"
TARGETS = sorted(p.name for p in (GENERATOR / "mipgen/targets").iterdir() if (p / "__init__.py").is_file())

#: The numbers of fields of own specifications, and those of one data set.
OWN, IN_ONE_SET = (1_000, 5_000, 20_000), 200

#: A description, and an enum with its values, that edits change.
DESCRIPTION = ("sets/base.yaml", "Ends idle mode and returns", "Ends the idle mode and returns")
ENUM = (
    "sets/filter_data.yaml",
    "    values:\n",
    "    values:\n      another: {value: 77, description: Another one.}\n",
)


class Run(NamedTuple):
    processor: float  # loops
    wall: float  # loops
    memory: float  # MB

    def row(self, name: str) -> str:
        return f"| {name} | {self.processor:.1f} | {self.wall:.1f} | {self.memory:.0f} |"


def loop() -> float:
    begin = time.process_time()
    sum(i * i for i in range(6_000_000))
    return time.process_time() - begin


class Bench:
    """A specification, with a cache and an output folder of its own."""

    def __init__(self, spec: Path, folder: Path, *options: str) -> None:
        self.spec, self.folder, self.options = folder / "spec", folder, options
        if spec != self.spec:
            shutil.copytree(spec, self.spec)
        self.program = folder

    def run(self) -> Run:
        command = [sys.executable, "-m", "mipgen", "generate", "--spec", "spec", "--out", "out", *self.options]
        path = [str(GENERATOR), str(self.program)]
        environment = {**os.environ, "MIPGEN_CACHE": str(self.folder / "cache"), "PYTHONPATH": os.pathsep.join(path)}
        before, begin = loop(), time.perf_counter()
        process = subprocess.Popen(command, cwd=self.folder, env=environment, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        wall, one = time.perf_counter() - begin, (before + loop()) / 2
        assert status == 0, command
        return Run((used.ru_utime + used.ru_stime) / one, wall / one, used.ru_maxrss / 1000)

    def edit(self, file: str, old: str, new: str) -> None:
        path = self.spec / file
        text = path.read_text("utf-8")
        assert old in text, (file, old)
        path.write_text(text.replace(old, new, 1), "utf-8")

    def another_program(self) -> None:
        """The next run is that of another version of the generator: of another library, for all that it can tell."""
        self.program = Path(tempfile.mkdtemp(prefix="program-", dir=self.folder))
        (self.program / f"{self.program.name}.dist-info").mkdir()


def real(folder: Path) -> Iterator[tuple[str, Run]]:
    bench = Bench(ROOT / "spec", folder / "real")
    yield "all targets, no caches", bench.run()
    yield "all targets, nothing changed", bench.run()
    bench.edit(*DESCRIPTION)
    yield "all targets, one description edited", bench.run()
    bench.edit(*ENUM)
    yield "all targets, a new enum value", bench.run()
    bench.another_program()
    yield "all targets, the generator edited", bench.run()
    for target in TARGETS:
        one = Bench(bench.spec, bench.folder, "--target", target)
        one.another_program()
        one.run()  # fills the caches of this version
        one.another_program()
        yield f"{target}, the generator edited", one.run()


def own(folder: Path) -> Iterator[tuple[str, Run]]:
    for count in OWN:
        place = folder / f"own-{count}"
        write_own(place / "spec", count)
        yield (
            f"c, own specification of {count:,} fields, no caches",
            Bench(place / "spec", place, "--target", "c").run(),
        )


def write_own(folder: Path, count: int) -> None:
    """Writes a specification with this number of data fields besides those of `mipgen new`."""
    command = [sys.executable, "-m", "mipgen", "new", folder]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env={**os.environ, "PYTHONPATH": str(GENERATOR)})
    for number in range(count // IN_ONE_SET):
        lines = [
            f"set: {0x81 + number}",
            f"name: quantities_{number}",
            f"title: Quantities {number}",
            "description: What many sensors measure.",
            "types:",
            "  state: {enum: u8, description: How it is., values: {good: 0, poor: 1, none: 2}}",
            "fields:",
        ]
        for descriptor in range(1, IN_ONE_SET + 1):
            lines += [
                f"  - data: {descriptor}",
                f"    name: quantity_{descriptor}",
                f"    title: Quantity {descriptor}",
                f"    description: Measured by the sensor with number {descriptor}.",
                "    parameters:",
                "      - {name: value, type: float, unit: degC, description: Temperature.}",
                "      - {name: samples, type: u16, count: 3, description: Number of samples of each axis.}",
                "      - {name: state, type: state, description: How it is.}",
            ]
        (folder / f"sets/quantities_{number}.yaml").write_text("\n".join([*lines, ""]), "utf-8")


def report(parts: tuple[Callable[[Path], Iterator[tuple[str, Run]]], ...] = (real, own)) -> None:
    """Prints a table, row by row, because the last ones take minutes."""
    print("| `mipgen generate` | CPU, loops | wall, loops | memory, MB |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory(prefix="mipgen-bench-") as name:
        for part in parts:
            for row, run in part(Path(name)):
                print(run.row(row), flush=True)


if __name__ == "__main__":
    report()
