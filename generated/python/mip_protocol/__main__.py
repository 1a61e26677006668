"""The program `mip`, also `python -m mip_protocol`: one module for each of its commands."""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from typing import Any

from .errors import Failure
from .protocol import VERSION

#: Command -> its module, with `add_arguments(parser)` and `run(options)`, and what it does.
COMMANDS = {"simulate": ("simulator.command", "run a virtual device, on a pseudo-terminal or TCP")}


def main(arguments: list[str] | None = None) -> int:
    try:
        return _run(sys.argv[1:] if arguments is None else arguments)
    except KeyboardInterrupt:
        return 130  # as shells say it
    except BrokenPipeError:  # the reader has stopped, as `head` does
        sys.stderr.close()
        return 1


def _run(given: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="mip", description="Tools for devices that speak MIP.")
    parser.add_argument("--version", action="version", version=f"mip {VERSION}")
    commands = parser.add_subparsers(metavar="COMMAND", title="commands", dest="command")
    chosen: Any = None
    for name, (module, text) in COMMANDS.items():
        added = commands.add_parser(
            name,
            help=text,
            description=f"{text[0].upper()}{text[1:]}.",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        if given[:1] == [name]:  # only the one that is wanted is imported
            chosen = import_module(f".{module}", __package__)
            chosen.add_arguments(added)
    options = parser.parse_args(given)
    if options.command is None:
        parser.print_help()
        return 0
    try:
        return int(chosen.run(options))
    except Failure as failure:
        print(f"mip {options.command}: {failure}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
