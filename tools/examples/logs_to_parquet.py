"""Decodes a folder of MIP logs into a partitioned Parquet data set, on several cores, with Dask.

    pip install generated/python './tools[dask]'
    python logs_to_parquet.py LOGS OUT --part 64

Each log is cut into parts of so many MiB, and each part is decoded by itself: by processes of this
machine, or by a cluster whose workers see the same folders (`--scheduler tcp://host:8786`). The
rows are the same for every way of cutting. OUT has a folder for each type of field and each log:

    OUT/field=sensor.scaled_accel/log=drive1.bin/000000000000.parquet

Read it with anything that reads Parquet:

    pyarrow.dataset.dataset("OUT", partitioning="hive").to_table(filter=...)
    dask.dataframe.read_parquet("OUT/field=sensor.scaled_accel")

Column names are those of the parameters; their units are in the metadata of the files. `offset` is
where the packet of a row begins in its log, `time` is by the clock that `--time` names.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from urllib.parse import quote

import dask
import mip_tools
import pyarrow.parquet as parquet


def decode(log: Path, name: str, begin: int, end: int, out: Path, clock: str) -> int:
    """Writes a file for each type in a part of a log; returns the number of rows."""
    rows = 0
    with mip_tools.read_log(log, begin, end) as part:
        for column in part.columns():
            table = part.frame(column.name, library="pyarrow", time=clock, position=True)
            table = table.drop_columns(["packet"])  # it counts from the beginning of the part
            folder = out / f"field={column.name}" / f"log={quote(name, safe='')}"
            folder.mkdir(parents=True, exist_ok=True)
            parquet.write_table(table, folder / f"{begin:012}.parquet")
            rows += len(table)
    return rows


def tasks(logs: Path, pattern: str, size: int) -> list[tuple[Path, str, int, int]]:
    """File, name, begin and end of all parts."""
    found = []
    for path in sorted(p for p in logs.rglob(pattern) if p.is_file()):
        total = path.stat().st_size
        for begin in range(0, total, size):
            name = path.relative_to(logs).as_posix()
            found.append((path, name, begin, min(begin + size, total)))
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description="Decodes MIP logs into a Parquet data set.")
    parser.add_argument("logs", type=Path, help="the folder with the logs")
    parser.add_argument("out", type=Path, help="the folder to make")
    parser.add_argument("--pattern", default="*.bin", help="names of the logs (%(default)s)")
    parser.add_argument("--part", type=float, default=64, help="size of a part in MiB (%(default)s)")
    parser.add_argument("--time", default="reference", help="clock of the times (%(default)s)")
    parser.add_argument("--workers", type=int, help="processes of this machine (one for each core)")
    parser.add_argument("--scheduler", help="address of a cluster")
    options = parser.parse_args()
    size = int(options.part * (1 << 20))
    if size < 1:
        parser.error("--part: a part has at least one byte")
    parts = tasks(options.logs, options.pattern, size)
    if not parts:
        parser.error(f"no file {options.pattern} in {options.logs}; see --pattern")
    if options.out.exists():
        parser.error(f"{options.out} exists; remove it or name another folder")

    unfinished = options.out.with_name(options.out.name + ".unfinished")
    jobs = [dask.delayed(decode)(*part, unfinished, options.time) for part in parts]
    if options.scheduler:
        from dask.distributed import Client

        with Client(options.scheduler) as client:
            rows = client.gather(client.compute(jobs))
    else:
        rows = dask.compute(*jobs, scheduler="processes", num_workers=options.workers)
    unfinished.rename(options.out)
    print(f"{sum(rows)} rows of {len(parts)} parts")
    return 0


if __name__ == "__main__":
    sys.exit(main())
