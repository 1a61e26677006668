"""The program `mip`, also `python -m mip_tools`: one module for each of its commands."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Generator
from difflib import get_close_matches
from typing import Any

from . import __version__, binding
from .commands import COMMANDS, PACKAGE, loaded, without_package
from .errors import Failure, Misuse, NoBinding

EPILOG = """\
`mip COMMAND --help` shows more.

exit status: 0 done, 1 failed (one line states why), 2 the command line is wrong, 3 the device
rejected a command, 4 it did not reply, 130 interrupted, 141 the reader of the output has ended
"""


def main(arguments: list[str] | None = None) -> int:
    _usable_streams()
    words = sys.argv[1:] if arguments is None else arguments
    try:
        package, words = without_package(words)
        if package is not None:
            binding.use(package)
        code = _run(words)
        sys.stdout.flush()
        return code
    except Failure as failure:
        print(f"{_program(words)}: {failure}", file=sys.stderr)
        return failure.status
    except KeyboardInterrupt:
        return 130  # as shells do
    except BrokenPipeError:  # the reader has ended, as `head` does
        # Otherwise the rest of the buffer would be flushed at exit, with an error message.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except OSError as error:  # of the output: commands report errors of their files and ports
        message = error.strerror or error
        print(f"{_program(words)}: standard output cannot be written: {message}", file=sys.stderr)
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1


def _program(words: list[str]) -> str:
    return f"mip {words[0]}" if words and words[0] in COMMANDS else "mip"


def _usable_streams() -> None:
    """Replaces closed standard streams with null devices, and escapes characters that the output's encoding lacks."""
    if sys.stdin is None:
        sys.stdin = open(os.devnull)
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w")
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w")
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")


class _Layout(argparse.RawDescriptionHelpFormatter):
    """Keeps the line breaks of examples; lists the commands in one column, without a heading line."""

    def _iter_indented_subactions(self, action: argparse.Action) -> Generator[argparse.Action, None, None]:
        yield from getattr(action, "_get_subactions", list)()

    def _format_action(self, action: argparse.Action) -> str:
        text = super()._format_action(action)
        return text.partition("\n")[2] if action.nargs == argparse.PARSER else text


def _version() -> str:
    return f"mip {__version__}, {_package()}; logs are read with {_engine()}"


def _package() -> str:
    try:
        return f"{binding.name()} {binding.VERSION}"
    except NoBinding:
        return "without a generated package"


def _engine() -> str:
    """Describes the code that reads logs as columns."""
    try:
        from .columns.native import compiled
    except NoBinding:
        return "nothing: a generated package is missing"
    except ImportError:
        return "nothing: NumPy is missing"
    return "NumPy and compiled code" if compiled() else "NumPy alone"


def _run(words: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="mip", description="Tools for devices that use MIP.", epilog=EPILOG, formatter_class=_Layout
    )
    parser.add_argument("--version", action="version", version=_version() if "--version" in words else "")
    parser.add_argument(
        PACKAGE,
        metavar="NAME",
        help=f"the generated package to work on, or its folder (default: ${binding.VARIABLE}, else {binding.USUAL})",
    )
    if words and not words[0].startswith("-") and words[0] not in COMMANDS:
        near = get_close_matches(words[0], COMMANDS, n=2)
        hint = f"did you mean {' or '.join(map(repr, near))}? " if near else ""
        raise Misuse(f"'{words[0]}' is not a command; {hint}`mip --help` lists them")
    used = parser
    commands = parser.add_subparsers(metavar="COMMAND", title="commands", dest="command")
    chosen: Any = None
    for name, text in COMMANDS.items():
        added = commands.add_parser(
            name, help=text, description=f"{text[0].upper()}{text[1:]}.", formatter_class=_Layout
        )
        if words[:1] == [name]:  # imports only the requested command
            chosen = loaded(name)
            chosen.add_arguments(added)
            used = added
            words = getattr(chosen, "shielded", list)(words)
    options, unknown = parser.parse_known_args(words)
    if unknown and chosen is not None:  # words after an option, which argparse does not expect
        options, unknown = used.parse_known_intermixed_args(words[1:], argparse.Namespace(command=words[0]))
    if unknown:
        used.error(f"{' '.join(unknown)} is not recognized; see --help")
    if chosen is None:
        parser.print_help()
        return 0
    return int(chosen.run(options))


if __name__ == "__main__":
    sys.exit(main())
