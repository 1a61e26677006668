"""How much was fuzzed, kept in counts.txt: a line for each target and revision. docs/proofs.md has a table of it."""

from __future__ import annotations

import datetime
import subprocess
from pathlib import Path

from support import BUILD, locked

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
    with locked(BUILD / "fuzz/counts"):  # of runs at the same time
        known = {line[:2]: line for line in lines()}
        before = known.get((target, revision), ("", "", "", 0))[3]
        known[target, revision] = (target, revision, datetime.date.today().isoformat(), before + count)
        rows = sorted(known.values(), key=lambda line: (line[0], line[2], line[1]))
        head = COUNTS.read_text("ascii").splitlines()[0]
        COUNTS.write_text("\n".join([head, *(" ".join(map(str, row)) for row in rows), ""]), "ascii")
        PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8")


def language(target: str) -> str:
    names = {"rust": "Rust", "python": "Python", "javascript": "JavaScript", "differential": "all compared"}
    return names.get(target.partition("-")[0], "C")


def page(text: str) -> str:
    """The page with the table."""
    rows = ["| Language | Target | Executions | Last run | Revision |", "|---|---|---:|---|---|"]
    last = {target: (date, revision) for target, revision, date, _ in lines()}
    totals = dict.fromkeys(map(language, sorted(last, key=language)), 0)
    for target, (date, revision) in sorted(last.items(), key=lambda item: (language(item[0]), item[0])):
        total = sum(count for name, _, _, count in lines() if name == target)
        totals[language(target)] += total
        rows.append(f"| {language(target)} | `{target}` | {total:,} | {date} | {revision} |")
    rows += [f"| **{name}** | | **{total:,}** | | |" for name, total in totals.items()]
    before, _, rest = text.partition(BEGIN)
    return before + BEGIN + "\n\n" + "\n".join(rows) + "\n\n" + END + rest.partition(END)[2]
