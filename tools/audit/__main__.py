"""Lists where a specification differs from manuals and other sources: `make audit`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from mipgen.base.errors import Failure
from mipgen.model import Model
from mipgen.read.problems import nearest
from mipgen.resolve.load import load_model

from . import manuals, sdk, tables, witnesses

#: Facts of an SDK's layouts that another program has extracted.
WITNESS = "witness.yaml"


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="audit", description="Lists where the specification differs from manuals and other sources."
    )
    add = parser.add_argument
    add("--spec", type=Path, default=Path("spec"), metavar="FOLDER", help="the specification (default: ./spec)")
    add("--manual", action="append", default=[], metavar="ID=FILE", help="a manual as plain text; may be repeated")
    add(
        "--sdk",
        type=Path,
        metavar="FOLDER",
        help=f"working copy of the vendor's SDK, or folder with {WITNESS}",
    )
    add("--witness", type=Path, metavar="FOLDER", help="compare with facts extracted from other sources: spec/witness")
    add(
        "--extract",
        action="store_true",
        help="write the facts of each --manual and of --sdk to witness/ of the specification: ID.yaml, sdk.yaml",
    )
    try:
        return audit(parser.parse_args(arguments))
    except Failure as failure:
        print(failure, file=sys.stderr)
        return 1


def audit(options: argparse.Namespace) -> int:
    """Prints all findings. Raises Failure."""
    if not options.manual and options.sdk is None and options.witness is None:
        raise Failure("nothing to compare with; specify --witness FOLDER, --manual ID=FILE or --sdk FOLDER")
    model = load_model(options.spec)
    lines = _audit_manuals(options, model)
    compared = _audit_sdk(options, model) if options.sdk is not None else None
    if options.witness is not None and compared is None:
        if not options.witness.is_dir():
            raise Failure(f"'{options.witness}': no such folder; write --witness FOLDER")
        compared = witnesses.audit_all(model, options.witness)
        print(compared.summary())
    lines += compared.lines() if compared else []
    print("".join(f"{line}\n" for line in lines), end="")
    if lines and options.witness is not None:
        print("correct the specification, or list an intended difference, with its reason, in accepted.yaml")
    print(f"{len(lines)} findings")
    return 1 if lines else 0


def _audit_manuals(options: argparse.Namespace, model: Model) -> list[str]:
    ids = [x.id for x in model.protocol.manuals]
    lines: list[str] = []
    for argument in options.manual:
        manual, _, file = argument.partition("=")
        if manual not in ids:
            raise Failure(f"unknown manual '{manual}'{nearest(manual, ids)}")
        if not Path(file).is_file():
            raise Failure(f"'{argument}': no such file; write --manual {manual}=FILE")
        if options.extract:
            _extract(options, manual, tables.extract_manual(manual, Path(file)), f"MANUALS={manual}=FILE")
        else:
            lines += map(str, manuals.audit_manuals(model, manual, Path(file)))
    return lines


def _audit_sdk(options: argparse.Namespace, model: Model) -> witnesses.Report | None:
    """Compares the layouts of an SDK, unless they are to be written."""
    if not options.sdk.is_dir():
        raise Failure(f"'{options.sdk}': no such folder; write --sdk FOLDER")
    copy = sdk.is_working_copy(options.sdk)
    if not copy and not (options.sdk / WITNESS).is_file():
        raise Failure(f"'{options.sdk}' is neither a working copy of the SDK nor a folder with {WITNESS}")
    revision = sdk.extract_sdk(options.sdk) if copy else witnesses.read_witness(options.sdk / WITNESS)
    if copy and options.extract:
        _extract(options, sdk.NAME, revision, "SDK=FOLDER")
        return None
    return witnesses.audit_all(model, options.witness or options.spec / "witness", revision, sdk.NAME)


def _extract(options: argparse.Namespace, name: str, facts: dict[str, Any], arguments: str) -> None:
    """Writes extracted facts as a witness of the specification."""
    made = options.spec / "witness" / f"{name}.yaml"
    try:
        made.parent.mkdir(exist_ok=True)
        made.write_text(tables.dump(facts, f"make audit {arguments} EXTRACT=1"), "utf-8", newline="\n")
    except OSError as error:
        raise Failure(f"cannot be written: {error.strerror}", str(made)) from None
    print(f"{made}: {len(facts['layouts'])} layouts")


if __name__ == "__main__":
    sys.exit(main())
