"""`mip export`: a log as a table."""

from __future__ import annotations

import argparse
import os
import re
from contextlib import ExitStack
from typing import Any

from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from . import inputs, outputs
from .arguments import add_selection
from .selection import Selection, field

#: Format -> the module that writes it.
FORMATS = {
    "csv": "export_text",
    "jsonl": "export_text",
    "npz": "export_columns",
    "parquet": "export_columns",
    "arrow": "export_columns",
}

TIMES = ("utc", "unix", "start", "clock", "none")

EPILOG = """\
examples:
  mip export log.bin -o log.csv                             all data, a row for each packet
  mip export log.bin sensor.scaled_accel -o accel.csv       one field
  mip export log.bin --split -o tables.csv                  tables.sensor.scaled_accel.csv, …
  mip export log.bin sensor filter_data -o log.parquet --align sensor.scaled_accel
  mip export log.bin --format jsonl -o - | jq .
  mip export log.bin acknowledge base 3dm -o answers.csv    also commands and answers, if named

csv: units are in the names of the columns; lists are JSON. jsonl: a line for each field; with
--align, a line has all fields. npz needs NumPy, parquet and arrow (the file format of Feather) need
pyarrow.

time: `utc` is that of GPS as UTC, `unix` the same in seconds since 1970, `start` in seconds since
the first packet, `clock` in seconds of the first clock that the log has: gps, external, reference.
It is that of the packet, or the last one of its set: `time_own` says which. --align gives each row
of one field the last values of the others.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="these fields or sets only")
    add("-o", "--output", required=True, metavar="FILE", help="where to write; - for standard output")
    add("--format", choices=FORMATS, help="default: by the ending of the output, else csv")
    add("--split", action="store_true", help="a file for each field, named after it")
    add("--time", choices=TIMES, help="time of each row (default: utc if the log has it, else clock)")
    add(
        "--invalid",
        choices=("keep", "mask", "drop"),
        default="keep",
        help="values that their flags say are not valid: keep them (default), leave them empty, or drop their rows",
    )
    add("--align", metavar="NAME", help="a row for each of this field, with the last of the others")
    add("--names", action="store_true", dest="named", help="names of values and flags, not numbers")
    add_selection(parser)


def run(options: argparse.Namespace) -> int:
    form = options.format or _by_ending(options.output)
    if options.split and options.output == "-":
        raise Misuse("--split writes several files; name one with -o, and fields are added to it")
    if options.split and options.align:
        raise Misuse("--split and --align cannot be combined; leave one out")
    selection = Selection([*options.names, *options.only], options.without, data=True)
    aligned = field(options.align) if options.align else None
    module: Any = __import__(f"{__package__}.{FORMATS[form]}", fromlist=["write"])
    module.require(form)
    with ExitStack() as stack:
        name = stack.enter_context(inputs.seekable(options.file))
        job = module.Job(name, form, options, selection, aligned)
        if not job.types:
            what = "none of these fields" if selection.named else "no data (commands and answers must be named)"
            raise Failure(f"{options.file} has {what}; `mip info` lists the fields that it has")
        if aligned is not None and aligned not in job.types:
            if not selection.has(aligned.set, aligned.kind.DESCRIPTOR):
                raise Misuse(f"{aligned.name} is not exported; name it, too, to align with it")
            raise Failure(f"{options.file} has no {aligned.name} to align with")
        files = _files(options, job.types)
        for path, _ in files:
            outputs.refuse_input(path, options.file)
        for path, types in files:
            job.write(path, types)
            outputs.note(f"{path}: {', '.join(t.name for t in types)}")
    return 0


def _by_ending(output: str) -> str:
    ending = os.path.splitext(output)[1].lstrip(".").lower()
    other = {"json": "jsonl", "ndjson": "jsonl", "pq": "parquet", "feather": "arrow", "": "csv"}
    form = other.get(ending, ending)
    if form not in FORMATS:
        raise Misuse(f"what format is '{ending}'? use --format {', '.join(FORMATS)}")
    return form


def _files(options: argparse.Namespace, types: list[Occurrence]) -> list[tuple[str, list[Occurrence]]]:
    if not options.split:
        return [(options.output, types)]
    base, ending = os.path.splitext(options.output)
    return [(f"{base}.{re.sub(r'[^A-Za-z0-9_.-]', '_', t.name)}{ending}", [t]) for t in types]
