"""Options that several commands have."""

from __future__ import annotations

import argparse
import math

from ..binding import UnknownName, lookup
from ..errors import Misuse


def add_selection(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--only",
        action="append",
        default=[],
        metavar="NAME,...",
        help="only these fields or sets: sensor.scaled_accel, sensor, 0x80, 0x80:0x04",
    )
    parser.add_argument("--without", action="append", default=[], metavar="NAME,...", help="all except these")


def add_device(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--device", metavar="DEVICE", help="interpret flags for this device; `mip simulate --list` lists them"
    )


def device_id(name: str | None) -> str | None:
    """Returns the id of a device, found by any of its names. Raises Failure if it is unknown."""
    if name is None:
        return None
    try:
        return lookup.device_id(name)
    except UnknownName as error:
        known = "" if lookup.only_named(name) else "; `mip simulate --list` lists them all"
        raise Misuse(f"{error}{known}") from None


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


__all__ = ["add_device", "add_selection", "device_id", "hertz", "positive", "seconds"]
