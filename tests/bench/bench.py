"""`make bench`: speed and size of each language, beside peers and hand-written loops. Figures to read, never a test."""

from __future__ import annotations

import argparse
from pathlib import Path

import bench_c
import bench_c_board
import bench_c_peer
import bench_columns
import bench_generate
import bench_javascript
import bench_rust

ROOT = Path(__file__).parents[2]

#: The table of C beside the vendor's SDK, and of microcontrollers.
PEER = ROOT / "docs/parts/bench_c_peer.md"


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--readme", action="store_true")
    arguments.add_argument("--part", choices=("generate", "c", "columns", "javascript", "rust"), help="this part only")
    arguments.add_argument("--peer", type=Path, help="a folder of the vendor's SDK: C beside it only")
    given = arguments.parse_args()
    if given.part == "generate":
        bench_generate.report()
        return
    if given.part in ("columns", "javascript"):
        print(bench_columns.report() if given.part == "columns" else bench_javascript.report())
        return
    if given.part == "rust":
        if given.readme:
            bench_rust.write_readme()
        else:
            print(bench_rust.report())
        return
    if given.peer:
        text = bench_c_peer.report(given.peer) + bench_c_board.report(given.peer, bench_c_peer.name(given.peer))
        print(text)
        if given.readme:
            PEER.write_text(text, "utf-8")
    if given.readme:
        bench_c.write_readme()
        if given.part is None and given.peer is None:
            bench_rust.write_readme()
    if given.readme or given.peer:
        return
    print(bench_c.report() + bench_c_board.report())
    if given.part:
        return
    print(bench_rust.report())
    print(bench_columns.report())
    print(bench_javascript.report())


if __name__ == "__main__":
    main()
