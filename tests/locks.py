"""Leaves in each lock only what the smaller one lacks, which it includes: `make lock`."""

from __future__ import annotations

import re
import sys
from itertools import pairwise
from pathlib import Path


def entries(text: str) -> dict[str, str]:
    """A lock's pins, with the lines of each."""
    return {block.partition("==")[0]: block for block in re.split(r"^(?=[\w.-]+==)", text, flags=re.M)[1:]}


def main(names: list[str]) -> None:
    whole = {name: entries(Path(name).read_text("utf-8")) for name in names}
    for small, large in pairwise(names):
        rest = []
        for package, block in whole[large].items():
            if package not in whole[small]:
                rest.append(block)
            elif block.partition(" ")[0] != whole[small][package].partition(" ")[0]:
                sys.exit(f"{package} differs: {small}, {large}")
        Path(large).write_text(f"-r {small}\n{''.join(rest)}", "utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
