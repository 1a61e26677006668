"""Options that several commands have."""

from __future__ import annotations

import argparse
import math
import re
from typing import Any

from .binding import Data
from .devices.profiles import device_named
from .errors import Misuse
from .names.occurrence import Occurrence
from .names.selection import matching_fields
from .ports.silence import Line

#: Fields with rates.
Rates = dict[Occurrence, float]
_RATE = re.compile(r"(.+)@([^@]*)")


def add_selection(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--only",
        action="append",
        default=[],
        metavar="NAME,...",
        help="only these fields or sets: sensor.scaled_accel, sensor, 0x80, 0x80:0x04",
    )
    parser.add_argument("--without", action="append", default=[], metavar="NAME,...", help="all except these")


def add_device(
    parser: argparse.ArgumentParser,
    use: str = "the model, instead of the one that the device reports; `mip fields --devices` lists them",
) -> None:
    """Adds the option that names a device; its value is the id."""
    parser.add_argument("--device", type=lambda name: device_named(name).id, metavar="DEVICE", help=use)


def positive(text: str) -> int:
    """Parses a whole number above 0."""
    if not text.isascii() or not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number above 0")
    return int(text)


def seconds(text: str) -> float:
    """Parses a time in seconds above 0."""
    return _above_zero(text, "a time in seconds; use a number above 0")


def hertz(text: str) -> float:
    """Parses a rate in Hz above 0."""
    return _above_zero(text, "a rate in Hz; use a number above 0")


def _above_zero(text: str, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"'{text.strip()}' is not {what}")
    return value


def add_baud(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--baud",
        type=_baud,
        default=115200,
        metavar="BD",
        help="baud rate of a serial port; `auto` finds it (default: 115200)",
    )


def _baud(text: str) -> int | None:
    return None if text == "auto" else bits_per_second(text, " or `auto`")


def bits_per_second(text: str, more: str = "") -> int:
    """Parses a baud rate."""
    if not text.isascii() or not text.isdigit() or not 0 < int(text) < 10**8:
        raise argparse.ArgumentTypeError(f"'{text.strip()}' is not a baud rate; use a number{more}")
    return int(text)


def line_of(options: argparse.Namespace, name: str) -> Line:
    """Returns a port and how the command uses it."""
    timeout, reopen = getattr(options, "timeout", None), getattr(options, "reopen", False)
    return Line(name, options.baud, options.command, timeout, reopen)


def add_reopen(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--reopen", action="store_true", help="open a lost port again, and report the gap")


def add_timeout(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--timeout", type=seconds, metavar="S", help="fail after S seconds without data (default: keep waiting)"
    )


def add_rows(parser: argparse.ArgumentParser) -> None:
    """Adds the options for the rows of a table, for logs and for live data."""
    add: Any = parser.add_argument
    add("--by", choices=("time", "packet"), default="time", help="a row for each instant (default) or each packet")
    add(
        "--time",
        choices=("utc", "unix", "start", "clock", "none"),
        help="time of each row (default: utc if there is a date, else clock)",
    )
    add(
        "--invalid",
        choices=("keep", "mask", "drop"),
        default="keep",
        help="values whose flags mark them as invalid: keep them (default), leave them empty, or drop their rows",
    )
    add("--names", action="store_true", dest="named", help="names of values and flags instead of numbers")


def parse_rates(words: list[str], rate: float | None) -> tuple[list[str], Rates]:
    """Parses the names, and the rates of fields. Raises Misuse."""
    if rate is not None and not words:
        raise Misuse("--rate needs fields; name them, as in sensor.scaled_accel")
    names: list[str] = []
    rates: Rates = {}
    for word in words:
        match = _RATE.fullmatch(word)
        name, wanted = (match[1], _hertz(match[2])) if match else (word, rate)
        names.append(name)
        if wanted is not None:
            rates |= {occurrence: wanted for occurrence in _of_one_set(name)}
    return names, rates


def _hertz(text: str) -> float:
    try:
        return hertz(text)
    except argparse.ArgumentTypeError as error:
        raise Misuse(str(error)) from None


def _of_one_set(name: str) -> list[Occurrence]:
    occurrences = [occurrence for occurrence in matching_fields(name) if issubclass(occurrence.kind, Data)]
    if not occurrences:
        raise Misuse(f"{name} is not a data field, and only these have a rate; `mip fields` lists them")
    if len(occurrences) > 1:
        raise Misuse(f"'{name}' is in several sets; write {' or '.join(occurrence.name for occurrence in occurrences)}")
    return occurrences
