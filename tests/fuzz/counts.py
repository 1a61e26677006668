"""How much was fuzzed, kept in counts.txt: a line for each target and revision. docs/proofs.md has a table of it."""

from __future__ import annotations

import datetime
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
COUNTS = HERE / "counts.txt"
PAGE = HERE.parents[1] / "docs/proofs.md"
BEGIN, END = "<!-- written by make fuzz -->", "<!-- end of fuzzing -->"

Line = tuple[str, str, str, int]  # target, revision, date, executions


def lines() -> list[Line]:
    split = (line.split() for line in COUNTS.read_text("ascii").splitlines() if not line.startswith("#"))
    return [(target, revision, date, int(count)) for target, revision, date, count in split]


def add(target: str, count: int) -> None:
    git = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], cwd=HERE, capture_output=True, text=True)
    revision = git.stdout.strip() or "unknown"
    known = {line[:2]: line for line in lines()}
    before = known.get((target, revision), ("", "", "", 0))[3]
    known[target, revision] = (target, revision, datetime.date.today().isoformat(), before + count)
    rows = sorted(known.values(), key=lambda line: (line[0], line[2], line[1]))
    head = COUNTS.read_text("ascii").splitlines()[0]
    COUNTS.write_text("\n".join([head, *(" ".join(map(str, row)) for row in rows), ""]), "ascii")
    PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8")


def page(text: str) -> str:
    """The page with the table."""
    rows = ["| Target | Executions | Last run | Revision |", "|---|---:|---|---|"]
    last = {target: (date, revision) for target, revision, date, _ in lines()}
    for target, (date, revision) in last.items():
        total = sum(count for name, _, _, count in lines() if name == target)
        rows.append(f"| `{target}` | {total:,} | {date} | {revision} |")
    before, _, rest = text.partition(BEGIN)
    return before + BEGIN + "\n\n" + "\n".join(rows) + "\n\n" + END + rest.partition(END)[2]
