"""The commands of `mip`, and the options that all of them have."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .errors import Misuse

#: Command -> its module, with `add_arguments(parser)` and `run(options)`, and its summary.
COMMANDS = {
    "dump": ("cli.dump", "show packets with names, values and units"),
    "info": ("cli.info", "show what is in a log: types, rates, gaps, damage"),
    "doctor": ("cli.doctor", "find out what is wrong with a device or a log, and why"),
    "export": ("cli.export", "write csv, jsonl, npz, parquet, arrow, mcap or ros2"),
    "fleet": ("cli.fleet", "write many logs as one Parquet data set, in parallel"),
    "plot": ("cli.plot", "plot values of a log over time"),
    "cut": ("cli.cut", "copy a part of a log"),
    "record": ("cli.record", "write what a device sends to a file"),
    "monitor": ("cli.monitor", "show the latest values of a device, live"),
    "stream": ("cli.stream", "write live data as JSON lines, CSV, MCAP, or to Foxglove"),
    "send": ("cli.send", "send a command and show the reply"),
    "config": ("cli.config", "copy, compare and restore the settings of a device"),
    "profile": ("cli.profile", "read what a device supports, for a specification"),
    "fields": ("cli.fields", "look up fields: bytes, values, units, devices"),
    "bandwidth": ("cli.bandwidth", "compute the baud rate that streams need"),
    "simulate": ("simulator.command", "run a virtual device, on a pseudo-terminal or TCP"),
    "serve": ("web.command", "let pages in a browser use a device, or a virtual one"),
    "completion": ("cli.completion", "print a script for completion in a shell"),
}

PACKAGE, DEFINITIONS = "--package", "--definitions"

#: Option that chooses the package -> what it needs.
WHICH = {PACKAGE: "the name or the folder of a generated package", DEFINITIONS: "a mip.json"}


def loaded(command: str) -> Any:
    """Imports the module of a command, which imports what it uses from the generated package."""
    return import_module(f".{COMMANDS[command][0]}", __package__)


def without_package(words: list[str]) -> tuple[str | None, list[str]]:
    """Finds `--package` or `--definitions`, before or after the command. Returns the value, and the other words.

    Raises Misuse."""
    end = words.index("--") if "--" in words else len(words)
    for i, word in enumerate(words[:end]):
        option, equals, value = word.partition("=")
        if option in WHICH:
            if not equals:
                value = next(iter(words[i + 1 : end]), "")
            if not value:
                raise Misuse(f"{option} needs {WHICH[option]}")
            rest = words[:i] + words[i + (1 if equals else 2) :]
            if without_package(rest)[0] is not None:
                raise Misuse(f"{PACKAGE} and {DEFINITIONS} can be given only once, and not both")
            return value, rest
    return None, words


__all__ = ["COMMANDS", "DEFINITIONS", "PACKAGE", "loaded", "without_package"]
