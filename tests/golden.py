"""The snapshot of the small ("invented") specification's output, tests/invented/golden: it shows what a change affects.

    make golden         writes it
    make check          compares it with what the generator makes
    make golden-diff    shows the whole difference from the output of a commit

`generated/` shows how the output for the real specification changes. The snapshot has what that one lacks: data with
all types, arrays and strings, and names that are keywords or begin with a digit. One file of each target with such
data or names is kept whole; of all others, a digest for each folder.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import io
import sys
from pathlib import Path

from mipgen import cli
from mipgen.base.resources import MANIFEST

ROOT = Path(__file__).parents[1]
SPEC = ROOT / "tests/invented/spec"
OUTPUT = ROOT / "build/invented"
GOLDEN = ROOT / "tests/invented/golden"
KEPT_WHOLE = {
    "c/src/mip/sets/measurements.c",
    "javascript/measurements.mjs",
    "markdown/docs/fields/measurements/arrays.md",
    "python/mip_protocol/mip_3d.py",
    "ros2/msg/MeasurementsArrays.msg",
    "rust/src/sets/mip_3d.rs",
}
DIGESTS = "digests.sha256"


def snapshot(output: Path = OUTPUT) -> dict[str, bytes]:
    """Returns the files of the snapshot of an output folder, by path."""
    made: dict[str, bytes] = {}
    folders: dict[str, hashlib._Hash] = {}
    for manifest in sorted(output.glob(f"*/{MANIFEST}")):
        for path in manifest.read_text("utf-8").splitlines()[1:]:
            name = f"{manifest.parent.name}/{path}"
            data = (output / name).read_bytes()
            if name in KEPT_WHOLE:
                made[name] = data
            else:
                whole = hashlib.sha256(data).hexdigest()
                folders.setdefault(name.rpartition("/")[0], hashlib.sha256()).update(f"{whole}  {name}\n".encode())
    made[DIGESTS] = "".join(f"{digest.hexdigest()}  {name}\n" for name, digest in sorted(folders.items())).encode()
    return made


def differences(made: dict[str, bytes], folder: Path = GOLDEN) -> list[str]:
    """Returns how a folder differs from the snapshot that it should contain."""
    files = [p for p in folder.rglob("*") if p.is_file() and p.suffix != ".pyc"]
    there = {p.relative_to(folder).as_posix(): p.read_bytes() for p in files}
    before, after = digests_by_path(there.pop(DIGESTS, b"")), digests_by_path(made[DIGESTS])
    before |= there
    after |= {path: data for path, data in made.items() if path != DIGESTS}
    states = {p: "missing" for p in after.keys() - before.keys()} | {p: "stale" for p in before.keys() - after.keys()}
    states |= {p: "changed" for p in after.keys() & before.keys() if after[p] != before[p]}
    return [f"{folder / p}: error: {state}" for p, state in sorted(states.items())]


def digests_by_path(listed: bytes) -> dict[str, bytes]:
    return {path.decode(): digest for digest, path in (line.split(b"  ", 1) for line in listed.splitlines())}


def write(made: dict[str, bytes], folder: Path = GOLDEN) -> None:
    for path in [p for p in folder.rglob("*") if p.is_file() and p.relative_to(folder).as_posix() not in made]:
        path.unlink()
    for path, data in made.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    check = parser.parse_args().check
    with contextlib.redirect_stdout(io.StringIO()):
        failed = cli.main(["generate", "--spec", str(SPEC), "--out", str(OUTPUT)])
    if failed:
        return failed
    made = snapshot()
    found = differences(made)
    print("\n".join(found) or f"{GOLDEN.relative_to(ROOT)} is up to date")
    if found:
        print(f"the whole output is in {OUTPUT.relative_to(ROOT)}; to see what changed in it: make golden-diff")
    if found and check:
        print("run: make golden")
        return 1
    write(made)
    return 0


if __name__ == "__main__":
    sys.exit(main())
