"""The command line: validate, generate, check."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import __version__, audit, naming, render
from .formatting import FormatError
from .model import RESPONSE, Model
from .problems import Problems, SpecError, nearest
from .resolve import load_model

ROOT = Path(__file__).parents[2]


def main(arguments: list[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    try:
        return int(options.run(options))
    except SpecError as error:
        print(error, file=sys.stderr)
        count = len(error.problems)
        print(f"mipgen: {count} problem{'s' if count > 1 else ''}; nothing was written", file=sys.stderr)
        return 1
    except FormatError as error:
        print(f"mipgen: {error}\nmipgen: nothing was written", file=sys.stderr)
        return 1


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="mipgen", description="Bindings and a reference manual from one specification of the MIP protocol."
    )
    parser.add_argument("--version", action="version", version=f"mipgen {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for run, text in (
        (validate, "check a specification and write nothing"),
        (generate, "write the files of all targets, or of those named"),
        (check, "fail if generated files differ from what the specification gives"),
    ):
        command = commands.add_parser(run.__name__, help=text, description=text)
        command.add_argument("--spec", type=Path, default=ROOT / "spec", help="folder of the specification")
        command.set_defaults(run=run)
        if run is not validate:
            command.add_argument("--out", type=Path, default=ROOT / "generated", help="folder of the output")
            command.add_argument(
                "--target", action="append", choices=render.names(), dest="targets", help="may be given more than once"
            )
    compare = commands.add_parser("audit", help="list what manuals contain and the specification does not")
    compare.add_argument("--spec", type=Path, default=ROOT / "spec", help="folder of the specification")
    compare.add_argument(
        "--manual", action="append", required=True, metavar="ID=FILE", help="a manual as plain text; may be repeated"
    )
    compare.set_defaults(run=audit_manuals)
    return parser


def audit_manuals(options: argparse.Namespace) -> int:
    model = load_model(options.spec)
    known = [x.id for x in model.protocol.manuals]
    findings = []
    for argument in options.manual:
        manual, _, file = argument.partition("=")
        if manual not in known:
            print(f"mipgen: unknown manual '{manual}'{nearest(manual, known)}", file=sys.stderr)
            return 2
        if not Path(file).is_file():
            print(f"mipgen: '{argument}': no such file; write --manual {manual}=FILE", file=sys.stderr)
            return 2
        findings += audit.audit(model, manual, Path(file))
    print("".join(f"{f}\n" for f in findings), end="")
    print(f"{len(findings)} findings")
    return 1 if findings else 0


def validate(options: argparse.Namespace) -> int:
    model = load_model(options.spec)
    _check_names(model, render.names())
    print(summary(model))
    return 0


def generate(options: argparse.Namespace) -> int:
    made = _make(options)
    for name, files in made.items():
        done = render.write(files, options.out / name)
        print(f"{name:10} {len(files):4} files, {len(done)} changed  ({render.target(name).TITLE})")
    return 0


def check(options: argparse.Namespace) -> int:
    found = 0
    for name, files in _make(options).items():
        for difference in render.compare(files, options.out / name):
            print(
                f"{options.out / name / difference.path}: error: {difference.what}; run 'make generate golden'",
                file=sys.stderr,
            )
            found += 1
    if not found:
        print(f"{options.out} is what the specification gives")
    return 1 if found else 0


def _make(options: argparse.Namespace) -> dict[str, dict[str, bytes]]:
    targets = options.targets or render.names()
    model = load_model(options.spec)
    _check_names(model, targets)
    print(summary(model))
    return {name: render.render(name, model) for name in targets}


def _check_names(model: Model, targets: list[str]) -> None:
    problems = Problems()
    for name in targets:
        naming.collisions(name, render.target(name).identifiers(model), problems)
    problems.raise_if_any()


def summary(model: Model) -> str:
    responses = sum(f.role == RESPONSE for f in model.fields)
    return (
        f"{len(model.sets)} sets: {len(model.fields) - responses} commands and data fields, {responses} responses; "
        f"{len(model.devices)} devices, {len(model.examples)} examples, {len(model.errata)} errata"
    )
