"""`mip export`: a log as a table."""

from __future__ import annotations

import argparse
import os
import re
from contextlib import ExitStack
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

from ..errors import Failure, Misuse
from ..files import outputs
from ..formats import live
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..names.occurrence import Occurrence
from ..names.selection import Selection, one_field
from ..options import add_device, add_rows, add_selection, hertz

TABLES = ("csv", "jsonl", "npz", "parquet", "arrow")
#: Formats of messages, and the modules that write them.
MESSAGES = ("mcap", "ros2")
FORMATS = (*TABLES, *MESSAGES)
#: The name, in place of a field, for the NMEA sentences between packets.
NMEA = "nmea"

EPILOG = """\
examples:
  mip export log.bin -o log.csv                             all data, a row for each instant
  mip export log.bin sensor.scaled_accel -o accel.csv       one field
  mip export log.bin sensor filter_data -o log.parquet --rate 100
  mip export log.bin --split -o tables.csv                  tables.sensor.scaled_accel.csv, …
  mip export log.bin sensor filter_data -o log.parquet --align sensor.scaled_accel
  mip record /dev/ttyACM0 -o - | mip export - --format jsonl -o - | jq .
  mip export log.bin --format ros2 -o drive --messages generated/ros2
  mip export log.bin nmea -o nmea.csv                       NMEA sentences, with times
  mip export log.bin acknowledge base 3dm -o replies.csv    commands and replies, if named

All formats have the same rows and columns. Packets with the same timestamp are one row; with --by
packet, each packet is one. csv has units in the names of the columns, and lists as JSON; jsonl has
an object for each row, without missing values. parquet and arrow (the file format of Feather) need
pyarrow and have units in the metadata; npz has an array for each column. mcap has a
channel for each field, with JSON; ros2 is a bag, a folder with standard messages in the axes of
REP 103. From standard input, jsonl and mcap are written as the data arrives.

time: `utc` is GPS time as UTC, `unix` the same in seconds since 1970, `clock` in seconds by the
clock of the device, `start` in seconds since the first row. By default, the column `time` has
dates, and `time_device` seconds by the clock of the device if rows have no date. A row has the time
in its packet, or the last one of its set: `time_own` states which.

--align adds the last values of the other fields to each row of one field. --rate makes rows at
equal steps, with values by --method: linear, nearest, or last, the value before.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="only these fields or sets")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--format", choices=FORMATS, help="default: from the extension of the output, else csv")
    add("--split", action="store_true", help="a file for each field, named after it")
    add_rows(parser)
    add_device(parser)
    add("--align", metavar="NAME", help="a row for each value of this field, with the last values of the others")
    add("--rate", type=hertz, metavar="HZ", help="rows at equal steps; invalid values are ignored")
    add("--method", choices=("linear", "nearest", "last"), help="values between two samples (default: linear)")
    add("--messages", type=Path, metavar="FOLDER", help="ros2: the package mip_msgs, to add messages of all fields")
    add("--position", action="store_true", help="add the packet's number, set and file offset")
    add_selection(parser)


def run(options: argparse.Namespace) -> int:
    form = options.format or _by_ending(options.output)
    _check(options)
    names = [name for name in options.names if name != NMEA]
    selection = Selection([*names, *options.only], options.without, data=True)
    aligned = one_field(options.align) if options.align else None
    if form in MESSAGES or (form == "jsonl" and options.file == "-"):
        whole = (aligned, options.split, options.rate, options.position, NMEA in options.names)
        if options.file == "-" and form != "ros2" and not any(whole):
            with outputs.whole(options.output) as out:  # a pipe: as data arrives
                live.write_stream(out, form, inputs.arriving("-"), options, selection, device=options.device)
            return 0
        if form in MESSAGES:
            return _messages(options, form, selection)
    inputs.need_numpy()
    from ..formats import tables, writers

    writers.require(form)
    with ExitStack() as stack:
        log = stack.enter_context(inputs.open_columns(options.file, options.device))
        if NMEA in options.names:
            outputs.refuse_input(options.output, options.file)
            with outputs.whole(options.output) as out, writers.FORMS[form](out) as write:
                write(tables.nmea_table(options, log))
            return 0
        job = tables.table_export(options, selection, log)
        if not job.kinds:
            _nothing(options, selection)
        print_assumptions("export", log, options.time != "none")
        if aligned is not None and aligned not in job.kinds:
            if not selection.has(aligned.set, aligned.kind.DESCRIPTOR):
                raise Misuse(f"{aligned.name} is not exported; to align with it, add it to the names")
            raise Failure(f"{options.file} has no {aligned.name} to align with")
        files = _files(options, job.kinds)
        for path, _ in files:
            outputs.refuse_input(path, options.file)
        for path, kinds in files:
            with outputs.whole(path) as out, writers.FORMS[form](out) as write:
                for columns in job._replace(kinds=kinds).tables(options, aligned):
                    write(columns)
            outputs.note(f"{path}: {', '.join(k.name for k in kinds)}")
    return 0


def _messages(options: argparse.Namespace, form: str, selection: Selection) -> int:
    """Writes a message for each field, with times."""
    for name in ("align", "rate", "position"):
        if getattr(options, name):
            raise Misuse(f"--{name} is for tables; {form} has messages for each field")
    if NMEA in options.names:
        raise Misuse(f"{NMEA} is a table; use csv, jsonl or another table format")
    module: Any = import_module(f"..formats.{form}", __package__)
    module.require(form)
    with inputs.seekable(options.file) as name:
        job = module.Job(name, options, selection)
        if not job.types:
            _nothing(options, selection)
        files = _files(options, job.types)
        for path, _ in files:
            outputs.refuse_input(path, options.file)
        for path, types in files:
            job.write(path, types)
            outputs.note(f"{path}: {', '.join(t.name for t in types)}")
    return 0


def _nothing(options: argparse.Namespace, selection: Selection) -> NoReturn:
    what = "none of these fields" if selection.has_names else "no data (commands and replies must be named)"
    raise Failure(f"{options.file} has {what}; `mip info` lists its fields")


def _check(options: argparse.Namespace) -> None:
    """Raises Misuse if options contradict each other."""
    if options.split and options.output == "-":
        raise Misuse("--split writes several files; name one with -o, to which the names of fields are added")
    for option, other in (("split", "align"), ("rate", "align"), ("rate", "position")):
        if getattr(options, option) and getattr(options, other):
            raise Misuse(f"--{option} and --{other} cannot be combined; leave one out")
    others = (options.only, options.without, options.split, options.rate, options.align)
    if NMEA in options.names and (len(options.names) > 1 or any(others)):
        raise Misuse(f"{NMEA} is a separate table; leave out other names, --split, --rate and --align")
    if options.method and not options.rate:
        raise Misuse("--method is only for --rate; add --rate HZ")
    if options.rate and (options.by == "packet" or options.time == "none"):
        raise Misuse("--rate makes rows by time; leave out --by packet and --time none")


def _by_ending(output: str) -> str:
    ending = os.path.splitext(output)[1].lstrip(".").lower()
    other = {"json": "jsonl", "ndjson": "jsonl", "pq": "parquet", "feather": "arrow", "": "csv"}
    form = other.get(ending, ending)
    if form not in FORMATS:
        raise Misuse(f"'.{ending}' is not a known format; use --format {', '.join(FORMATS)}")
    return form


def _files(options: argparse.Namespace, kinds: list[Occurrence]) -> list[tuple[str, list[Occurrence]]]:
    if not options.split:
        return [(options.output, kinds)]
    base, ending = os.path.splitext(options.output)
    return [(f"{base}.{re.sub(r'[^A-Za-z0-9_.-]', '_', k.name)}{ending}", [k]) for k in kinds]
