"""`mip fleet`: many logs as one data set."""

from __future__ import annotations

import argparse
import sys

from ..files import outputs, signals
from ..fleet import build_dataset
from ..names.selection import Selection
from ..options import add_device, positive
from ..text.numbers import count_text

EPILOG = """\
examples:
  mip fleet logs -o data                                 all *.bin in a folder and its subfolders
  mip fleet logs -o data                                 again: adds new logs
  mip fleet logs -o data --only sensor,filter_data
  mip fleet s3://bucket/logs -o s3://bucket/data         needs s3fs

The data set has a folder for each clock and each field, data/clock=gps/field=NAME, with the rows
and columns of `mip export` for that field, plus `log` and `device`. data/_manifest.json lists the
files that belong to the data set; data/_catalogue.parquet has devices, times and gaps. Run an
interrupted command again to continue; no row is duplicated. A log is recognized by its content,
under any name. A log that cannot be read is reported, and tried again by the next run.

exit status: 1 if a log could not be added
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("logs", nargs="+", metavar="LOGS", help="folders, logs, or URLs of either")
    add(
        "-o",
        "--output",
        required=True,
        metavar="FOLDER",
        help="the data set, a folder or a URL, which is created or extended",
    )
    add("--pattern", default="*.bin", help="names of the logs in a folder (default: %(default)s)")
    add("--only", action="append", default=[], metavar="NAME,...", help="only these fields or sets")
    add(
        "--invalid",
        choices=("keep", "mask", "drop"),
        default="keep",
        help="values whose flags mark them as invalid: keep them (default), leave them empty, or drop their rows",
    )
    add_device(parser)
    add("--workers", type=positive, metavar="N", help="number of local processes (default: one for each core)")


def run(options: argparse.Namespace) -> int:
    Selection(options.only)  # a wrong name is an error of the command line, not of each log

    def progress(done: int, of: int, what: str) -> None:
        outputs.progress(f"{done} of {of} {what}")

    with signals.handled(signals.interrupt):
        try:
            built = build_dataset(
                options.logs,
                options.output,
                only=options.only,
                pattern=options.pattern,
                invalid=options.invalid,
                device=options.device,
                workers=options.workers,
                progress=progress,
            )
        finally:
            outputs.progress("")
    for name, why in sorted(built.failed.items()):
        print(f"mip fleet: {name}: {why}", file=sys.stderr)
    added, unchanged, failed = len(built.added), len(built.unchanged), len(built.failed)
    rows, logs, files = built.manifest.rows, len(built.manifest.logs), len(built.manifest.files)
    print(
        f"{options.output}: {count_text(added, 'log')} added, {unchanged} known, {failed} failed; "
        f"{count_text(rows, 'row')} of {count_text(logs, 'log')} in {count_text(files, 'file')}"
    )
    return 1 if built.failed else 0
