"""`make bench`: speed and size of each language, beside peers and hand-written loops. Figures to read, never a test."""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
from pathlib import Path

import bench_c
import bench_c_peer
import bench_generate
import bench_rust

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
ROUNDS = 7


#: Parts with a table of their own: name -> the function that prints it.
PARTS = {"generate": bench_generate.report}


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--readme", action="store_true")
    arguments.add_argument("--part", choices=PARTS, help="this part only")
    arguments.add_argument("--peer", type=Path, help="a folder of the vendor's SDK: this comparison only")
    given = arguments.parse_args()
    if given.part:
        PARTS[given.part]()
        return
    if given.peer:
        text = bench_c_peer.report(given.peer)
        print(text)
        if given.readme:
            (ROOT / "docs/parts/bench_c_peer.md").write_text(text, "utf-8")
        return
    if given.readme:
        bench_c.write_readme()
        bench_rust.write_readme()
        return
    print(bench_c.report())
    print(bench_rust.report())
    subprocess.run([sys.executable, str(HERE / "bench_columns.py")], check=True)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT / "tools"), str(ROOT / "generated/python")))}
    print("\nPython: " + subprocess.check_output([sys.executable, str(HERE / "bench_python_objects.py")], text=True,
                                                   env=environment))  # fmt: skip
    live = [sys.executable, str(HERE / "bench_live.py")]
    print(subprocess.check_output(live, text=True, env=environment), end="")
    device = [sys.executable, str(HERE / "bench_device.py")]
    shares = [subprocess.check_output(device, text=True, env=environment) for _ in range(ROUNDS)]
    share = statistics.median(map(float, shares))
    print(f"\nthe virtual device, six fields at 1 kHz: {share:.1f} % of a core")


if __name__ == "__main__":
    main()
