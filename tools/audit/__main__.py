"""Lists where a specification differs from facts of other sources: `make audit`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from mipgen.base.errors import Failure
from mipgen.resolve.load import load_model

from . import sdk, witnesses


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="audit", description="Lists where the specification differs from facts of other sources."
    )
    add = parser.add_argument
    add("--spec", type=Path, default=Path("spec"), metavar="FOLDER", help="the specification (default: ./spec)")
    add("--witness", type=Path, metavar="FOLDER", help="these facts (default: witness/ of the specification)")
    add("--sdk", type=Path, metavar="FOLDER", help="compare with a working copy of the vendor's SDK instead")
    add("--extract", action="store_true", help="write the facts of --sdk to witness/sdk.yaml of the specification")
    try:
        return audit(parser.parse_args(arguments))
    except Failure as failure:
        print(failure, file=sys.stderr)
        return 1


def audit(options: argparse.Namespace) -> int:
    """Prints all findings. Raises Failure."""
    witness = options.witness or options.spec / "witness"
    if not witness.is_dir():
        raise Failure(f"'{witness}': no such folder; write --witness FOLDER")
    revision = sdk.extract_sdk(options.sdk) if options.sdk else None
    if options.extract and revision is not None:
        made = witness / f"{sdk.NAME}.yaml"
        made.write_text(sdk.dump(revision, "make audit SDK=FOLDER EXTRACT=1"), "utf-8", newline="\n")
        print(f"{made}: {len(revision['layouts'])} layouts")
        return 0
    compared = witnesses.audit_all(load_model(options.spec), witness, revision, sdk.NAME)
    print(compared.summary())
    lines = compared.lines()
    print("".join(f"{line}\n" for line in lines), end="")
    if lines:
        print("correct the specification, or list an intended difference, with its reason, in accepted.yaml")
    print(f"{len(lines)} findings")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
