"""The command line. The commands are in `commands`, which imports what they need when they run."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Generator
from pathlib import Path
from typing import Any

from mipgen import __version__
from mipgen.base.errors import Failure

EXAMPLES = """\
examples:
  mipgen new spec                           write a small specification to start from
  mipgen validate                           check it
  mipgen generate                           ./spec -> ./generated, all targets
  mipgen generate --target c --target rust  only these two
  mipgen generate --device 3dm-gx5-15       what one device supports
  mipgen generate --target c --without extra,cpp
                                            C without the folders that a program can do without
  mipgen generate --spec spec --spec mine   with your own fields as an overlay
  mipgen check                              is ./generated up to date?

'mipgen COMMAND --help' describes a command. Results that are slow to compute are cached in
~/.cache/mipgen. Set MIPGEN_CACHE to use another folder, or to an empty value to turn the cache off.
"""


def main(arguments: list[str] | None = None) -> int:
    program = parser()
    options = program.parse_args(arguments)
    try:
        try:
            return _run(program, options)
        finally:
            sys.stdout.flush()
    except Failure as failure:
        print(failure, file=sys.stderr)
        count = len(getattr(failure, "problems", ()))
        if count:
            print(f"mipgen: {count} problem{'s' if count > 1 else ''}; nothing was written", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("mipgen: interrupted; run it again", file=sys.stderr)
        return 130
    except BrokenPipeError:  # the reader has stopped, as `head` does
        sys.stderr.close()
        return 1
    except OSError as error:
        print(f"{error.filename or 'mipgen'}: error: {error.strerror or error}", file=sys.stderr)
        return 1


def _run(program: argparse.ArgumentParser, options: argparse.Namespace) -> int:
    if options.run is None:
        program.print_help()
        return 0
    from . import commands

    return int(getattr(commands, options.run)(options))


class _Layout(argparse.RawDescriptionHelpFormatter):
    """Preserves the line breaks of examples, and lists the commands in one column, without a heading line."""

    def _iter_indented_subactions(self, action: argparse.Action) -> Generator[argparse.Action, None, None]:
        yield from getattr(action, "_get_subactions", list)()

    def _format_action(self, action: argparse.Action) -> str:
        text = super()._format_action(action)
        return text.partition("\n")[2] if action.nargs == argparse.PARSER else text


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="mipgen",
        description="Bindings in several languages and a reference manual from one specification of the MIP protocol.",
        epilog=EXAMPLES,
        formatter_class=_Layout,
    )
    made.add_argument("--version", action="version", version=f"mipgen {__version__}")
    made.set_defaults(run=None)
    commands = made.add_subparsers(metavar="COMMAND", title="commands")

    def command(name: str, text: str) -> argparse.ArgumentParser:
        added = commands.add_parser(
            name,
            help=text,
            description=f"{text[0].upper()}{text[1:]}.",
            formatter_class=_Layout,
        )
        added.set_defaults(run=name)
        return added

    new = command("new", "write a small specification to start from")
    new.add_argument("folder", type=folder_argument, metavar="FOLDER", help="a new or empty folder")

    validate = command("validate", "check a specification and write nothing")
    _spec(validate)
    _targets(validate)

    generate = command("generate", "check a specification and write the files of all targets")
    _spec(generate)
    _part(generate)
    _out(generate)
    _output(_targets(generate))

    check = command("check", "fail if generated files differ from the specification")
    _spec(check)
    _part(check)
    _out(check)
    _output(_targets(check))

    targets = command("targets", "list the targets")
    _target_path(targets)
    return made


def folder_argument(text: str) -> Path:
    """Parses a path. Rejects an empty text, which comes from an unset shell variable and does not mean this folder."""
    if not text:
        raise argparse.ArgumentTypeError("the path is empty; specify a folder ('.' is the current one)")
    return Path(text)


def _spec(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--spec",
        type=folder_argument,
        action="append",
        metavar="FOLDER",
        help="folder of the specification (default: ./spec); further ones are overlays of the first",
    )


def _part(command: argparse.ArgumentParser) -> None:
    group = command.add_argument_group("a part of the specification, with everything that it needs")
    for name, metavar, text in (
        ("device", "ID", "only what this device supports, or is believed to support"),
        ("set", "SET", "only this descriptor set, by name or number: sensor, 0x80"),
        ("field", "NAME", "only this field, for example 3dm.message_format"),
    ):
        group.add_argument(f"--{name}", action="append", dest=f"{name}s", default=[], metavar=metavar, help=text)
    group.add_argument("--certain", action="store_true", help="only what the devices support for certain")


def _out(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--out",
        type=folder_argument,
        default=Path("generated"),
        metavar="FOLDER",
        help="folder of the output (default: ./generated)",
    )


def _targets(command: argparse.ArgumentParser) -> Any:
    group = command.add_argument_group("targets")
    group.add_argument(
        "--target",
        action="append",
        dest="targets",
        metavar="NAME",
        help="only this target; may be repeated ('mipgen targets' lists them)",
    )
    _target_path(group)
    return group


def _output(group: Any) -> None:
    group.add_argument(
        "--without",
        action="extend",
        type=lambda text: text.split(","),
        default=[],
        metavar="PART[,PART]",
        help="leave out these parts of a target, such as extra,cpp of c",
    )


def _target_path(group: Any) -> None:
    group.add_argument(
        "--target-path",
        action="append",
        type=folder_argument,
        default=[],
        metavar="FOLDER",
        help="folder with your own targets, or with templates that replace built-in ones; may be repeated",
    )
