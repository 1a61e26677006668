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
LANGUAGES = ["C", "Rust", "Python", "JavaScript"]

Line = tuple[str, str, str, int]  # target, revision, date, executions


def lines() -> list[Line]:
    split = (line.split() for line in COUNTS.read_text("ascii").splitlines() if not line.startswith("#"))
    return [(target, revision, date, int(count)) for target, revision, date, count in split]


def add(target: str, count: int) -> None:
    git = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], cwd=HERE, capture_output=True, text=True)
    revision = git.stdout.strip() or "unknown"
    with locked(BUILD / "fuzz/counts"):  # of runs at the same time
        known = {line[:2]: line for line in lines()}
        before = known.pop((target, revision), ("", "", "", 0))[3]
        known[target, revision] = (target, revision, datetime.date.today().isoformat(), before + count)
        rows = sorted(known.values(), key=lambda line: line[0])  # the lines of a target stay in the order of its runs
        head = COUNTS.read_text("ascii").splitlines()[0]
        COUNTS.write_text("\n".join([head, *(" ".join(map(str, row)) for row in rows), ""]), "ascii")
        PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8")


def languages(target: str) -> list[str]:
    """Those that run an input of a target."""
    first = target.partition("-")[0]
    return {"differential": LANGUAGES, "rust": ["Rust"], "python": ["Python"]}.get(first, ["C"])


def page(text: str) -> str:
    """The page with the tables."""
    totals, rows = dict.fromkeys(LANGUAGES, 0), {}
    for target, revision, date, count in lines():  # the last line of a target is that of its last run
        before = rows.get(target, (0,))[0]
        rows[target] = (before + count, date, revision)
        for name in languages(target):
            totals[name] += count
    shown = ["| Target | Executions | Last run | Revision |", "|---|---:|---|---|"]
    shown += [f"| `{name}` | {count:,} | {date} | {revision} |" for name, (count, date, revision) in rows.items()]
    shown += ["", "| Language | Executions, each with those of `differential` |", "|---|---:|"]
    shown += [f"| {name} | {count:,} |" for name, count in totals.items()]
    head, _, rest = text.partition(BEGIN)
    return head + BEGIN + "\n\n" + "\n".join(shown) + "\n\n" + END + rest.partition(END)[2]
