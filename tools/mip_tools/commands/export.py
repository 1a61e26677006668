"""`mip export`: a log as a table."""

from __future__ import annotations

import argparse
import os
from contextlib import ExitStack
from importlib import import_module
from typing import Any, NoReturn

from ..errors import Failure, Misuse
from ..files import outputs
from ..formats import live
from ..formats.json_messages import refuse_options_of_tables
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..names.selection import Selection
from ..options import add_device, add_rows, add_selection

TABLES = ("csv", "jsonl", "parquet")
#: Formats of messages, and the modules that write them.
MESSAGES = ("mcap", "ros2")
FORMATS = (*TABLES, *MESSAGES)

EPILOG = """\
examples:
  mip export log.bin -o log.csv                             all data, a row for each instant
  mip export log.bin sensor.scaled_accel -o accel.csv       one field
  mip export log.bin sensor filter_data -o log.parquet
  mip record /dev/ttyACM0 -o - | mip export - --format jsonl -o - | jq .
  mip export log.bin --format ros2 -o drive
  mip export log.bin acknowledge base 3dm -o replies.csv    commands and replies, if named

All formats have the same rows and columns. Packets with the same timestamp are one row; with --by
packet, each packet is one. csv has units in the names of the columns, and lists as JSON; jsonl has
an object for each row, without missing values. parquet needs pyarrow and has units in the
metadata. mcap has a channel for each field, with JSON; ros2 is a bag, a folder with standard
messages in the axes of REP 103. From standard input, jsonl and mcap are written as data arrives.

time: `utc` is GPS time as UTC, `unix` the same in seconds since 1970, `clock` in seconds by the
clock of the device, `start` in seconds since the first row. By default, the column `time` has
dates, and `time_device` seconds by the clock of the device if rows have no date. A row has the time
in its packet, or the last one of its set: `time_own` states which.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="only these fields or sets")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--format", choices=FORMATS, help="default: from the extension of the output, else csv")
    add_rows(parser)
    add_device(parser)
    add("--position", action="store_true", help="add the packet's number, set and file offset")
    add_selection(parser)


def run(options: argparse.Namespace) -> int:
    form = options.format or _by_ending(options.output)
    selection = Selection([*options.names, *options.only], options.without, data=True)
    if form in MESSAGES:
        refuse_options_of_tables(options, form)
    if form in MESSAGES or (form == "jsonl" and options.file == "-"):
        if options.file == "-" and form != "ros2" and not options.position:
            with outputs.whole(options.output) as out:  # a pipe: as data arrives
                arriving = inputs.arriving("-")
                if not live.write_stream(out, form, arriving, options, selection, device=options.device):
                    _nothing(options, selection)
            return 0
        if form in MESSAGES:
            return _messages(options, form, selection)
    inputs.need_numpy()
    from ..formats import tables, writers

    writers.require(form)
    with ExitStack() as stack:
        log = stack.enter_context(inputs.open_columns(options.file, options.device))
        job = tables.table_export(options, selection, log)
        if not job.kinds:
            _nothing(options, selection)
        print_assumptions("export", log, times=options.time != "none", names=options.named)
        outputs.refuse_input(options.output, options.file)
        with outputs.whole(options.output) as out, writers.FORMS[form](out) as write:
            for columns in job.tables(options):
                write(columns)
        outputs.note(f"{options.output}: {', '.join(kind.name for kind in job.kinds)}")
    return 0


def _messages(options: argparse.Namespace, form: str, selection: Selection) -> int:
    """Writes a message for each field, with times."""
    if options.position:
        raise Misuse(f"--position is for tables; {form} has messages for each field")
    module: Any = import_module(f"..formats.{form}", __package__)
    module.require(form)
    with inputs.seekable(options.file) as name:
        job = module.Job(name, options, selection)
        if not job.types:
            _nothing(options, selection)
        outputs.refuse_input(options.output, options.file)
        job.write(options.output, job.types)
        outputs.note(f"{options.output}: {', '.join(kind.name for kind in job.types)}")
    return 0


def _nothing(options: argparse.Namespace, selection: Selection) -> NoReturn:
    what = "none of these fields" if selection.has_names else "no data (commands and replies must be named)"
    raise Failure(f"{options.file} has {what}; `mip info` lists its fields")


def _by_ending(output: str) -> str:
    ending = os.path.splitext(output)[1].lstrip(".").lower()
    other = {"json": "jsonl", "ndjson": "jsonl", "pq": "parquet", "": "csv"}
    form = other.get(ending, ending)
    if form not in FORMATS:
        raise Misuse(f"'.{ending}' is not a known format; use --format {', '.join(FORMATS)}")
    return form
