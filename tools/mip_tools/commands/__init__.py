"""The commands of `mip`, and the options that all of them have.

A further command is an entry of `COMMANDS` and a module of that name; that of `simulate` is in the distribution
mip-simulator. Tests: `tests/tools/cli`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from ..errors import Failure, Misuse

#: Command -> its summary. Its module has the same name, with `add_arguments(parser)` and `run(options)`.
COMMANDS = {
    "dump": "show packets with names, values and units",
    "info": "show what is in a log: types, rates, gaps, damage",
    "ports": "list the serial ports and the devices at them",
    "doctor": "find out what is wrong with a device or a log, and why",
    "export": "write csv, jsonl, parquet, mcap or ros2",
    "fleet": "write many logs as one Parquet data set, in parallel",
    "plot": "plot values of a log over time",
    "cut": "copy a part of a log",
    "record": "write what a device sends to a file",
    "monitor": "show the latest values of a device, live",
    "stream": "write live data as JSON lines, CSV, MCAP, or to Foxglove",
    "send": "send a command and show the reply",
    "corrections": "pass RTCM corrections from an NTRIP caster to a device",
    "calibrate-mag": "compute hard and soft iron of a magnetometer",
    "noise": "measure white noise and bias instability of a log at rest",
    "config": "copy, compare and restore the settings of a device",
    "profile": "read what a device supports, for a specification",
    "fields": "look up fields: bytes, values, units, devices",
    "simulate": "run a virtual device, on a pseudo-terminal or TCP",
    "serve": "let pages in a browser use a device",
}

PACKAGE = "--package"


def loaded(command: str) -> Any:
    """Imports the module of a command, which imports what it uses from the generated package."""
    if command != "simulate":
        return import_module(f".{command.replace('-', '_')}", __name__)
    try:
        return import_module("mip_simulator.command")
    except ModuleNotFoundError as error:
        if error.name != "mip_simulator":
            raise
        where = "mip-simulator, or from a checkout ./tools/mip_simulator"
        raise Failure(f"mip-simulator is missing; pip install {where}") from None


def without_package(words: list[str]) -> tuple[str | None, list[str]]:
    """Finds `--package`, before or after the command. Returns its value, and the other words. Raises Misuse."""
    end = words.index("--") if "--" in words else len(words)
    for i, word in enumerate(words[:end]):
        option, equals, value = word.partition("=")
        if option == PACKAGE:
            if not equals:
                value = next(iter(words[i + 1 : end]), "")
            if not value:
                raise Misuse(f"{PACKAGE} needs the name or the folder of a generated package")
            rest = words[:i] + words[i + (1 if equals else 2) :]
            if without_package(rest)[0] is not None:
                raise Misuse(f"{PACKAGE} can be given only once")
            return value, rest
    return None, words


__all__ = ["COMMANDS", "PACKAGE", "loaded", "without_package"]
