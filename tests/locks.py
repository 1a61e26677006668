"""Writes each lock with a line per package, and leaves in it only what the smaller one lacks, which it includes:
`make lock`. With `--cargo`, it writes one that `cargo update` has made in `build/rust/real/workspace` for Rust's tests.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path


def pins(name: str) -> dict[str, str]:
    """A lock's packages, each with its version and hashes on one line."""
    text = re.sub(r" *\\\n *", " ", Path(name).read_text("utf-8"))
    return {line.partition("==")[0]: line for line in text.splitlines() if re.match(r"[\w.-]+==", line)}


def main(names: list[str]) -> None:
    smaller: dict[str, str] = {}
    include = ""
    for name, lock in [(name, pins(name)) for name in names]:
        for package in smaller.keys() & lock.keys():
            if smaller[package].split()[0] != lock[package].split()[0]:
                sys.exit(f"{package} in {name} differs from the smaller lock")
        lines = [f"{line}\n" for package, line in lock.items() if package not in smaller]
        Path(name).write_text(include + "".join(lines), "utf-8")
        smaller, include = lock, f"-r {Path(name).name}\n"


def cargo(text: str) -> str:
    """A lock of cargo, which reads this form, too."""
    one_line = re.sub(r"\n ?(?=[\]\"])", " ", text).replace(", ]", "]").replace("[ ", "[")
    version, *packages = one_line.strip().split("\n\n[[package]]\n")
    lines = [f" {{ {package.replace(chr(10), ', ')} }},\n" for package in packages]
    return f"{version}\npackage = [\n{''.join(lines)}]\n"


if __name__ == "__main__":
    if sys.argv[1] == "--cargo":
        made = Path("build/rust/real/workspace/Cargo.lock").read_text("utf-8")
        Path("tests/rust/Cargo.lock").write_text(cargo(made), "utf-8")
    else:
        main(sys.argv[1:])
