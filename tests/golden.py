"""The snapshot of the invented specification, tests/invented/golden, whose diff shows the effect of a change.

    make golden     writes it
    make check      compares it with what the generator makes, everything rendered anew

It contains the files that templates make. Of the files that come from runtime/, whole or without what the
specification does not need, and the licence, `copied.sha256` of each target lists the digests, as `sha256sum -c` reads
them.
"""

from __future__ import annotations

import argparse
import hashlib
import sys
from pathlib import Path

from mipgen.base.resources import MANIFEST
from mipgen.emit import build, discovery
from mipgen.resolve.load import load_model

ROOT = Path(__file__).parents[1]
SPEC = ROOT / "tests/invented/spec"
GOLDEN = ROOT / "tests/invented/golden"
COPIED = "copied.sha256"


def snapshot() -> dict[str, bytes]:
    """The files of the snapshot, by path."""
    made: dict[str, bytes] = {}
    for output in build.make(load_model(SPEC), list(discovery.sources().values())):
        digests = []
        for path, data in sorted(output.files.items()):
            origin = ROOT / ("LICENSE" if path == "LICENSE" else f"runtime/{output.name}/{path}")
            if origin.is_file():
                digests.append(f"{hashlib.sha256(data).hexdigest()}  {path}\n")
            elif path != MANIFEST:
                made[f"{output.name}/{path}"] = data
        made[f"{output.name}/{COPIED}"] = "".join(digests).encode()
    return made


def differences(made: dict[str, bytes], folder: Path = GOLDEN) -> list[str]:
    """How a folder differs from the snapshot that it should hold."""
    there = {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    states = {p: "missing" for p in made.keys() - there.keys()} | {p: "stale" for p in there.keys() - made.keys()}
    states |= {p: "changed" for p in made.keys() & there.keys() if made[p] != there[p]}
    return [f"{folder / p}: error: {state}" for p, state in sorted(states.items())]


def write(made: dict[str, bytes], folder: Path = GOLDEN) -> None:
    for path in [p for p in folder.rglob("*") if p.is_file() and p.relative_to(folder).as_posix() not in made]:
        path.unlink()
    for path, data in made.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    made = snapshot()
    if not parser.parse_args().check:
        write(made)
        print(f"{GOLDEN.relative_to(ROOT)}: {len(made)} files")
        return 0
    found = differences(made)
    print("\n".join([*found, "run: make golden"]) if found else f"{GOLDEN.relative_to(ROOT)} is up to date")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
