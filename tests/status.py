"""Writes docs/status.md and the figures of README.md from committed results; with --check, only compares them.

Nothing is measured: specification and tables were written by the commands that the page names.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
PAGE, README = ROOT / "docs/status.md", ROOT / "README.md"
C, RUST, PROOFS = "generated/c/docs/measurements.md", "generated/rust/src/guide.md", "docs/proofs.md"
BOARD = "Cortex-M4, `-Os`, "
BENCH = "`make bench README=1`"

#: Rows of tables that the page repeats: file, the row, a column, what the page calls it.
SHOWN = [
    (C, "size: parser and three fields", f"{BOARD}small parser", "C, Cortex-M4 `-Os`: parser and three fields"),
    (C, "size: application, waiting for replies", f"{BOARD}small parser", "C, Cortex-M4 `-Os`: application"),
    (C, "parse, in pieces of 64 bytes", f"{BOARD}small parser", "C, Cortex-M4 `-Os`: parse, instructions per byte"),
    (C, "the same, handlers of `device.h`", f"{BOARD}small parser",
     "C, Cortex-M4 `-Os`: the same, with handlers of three fields"),
    (C, "parse, in pieces of 4 KiB", "Instructions per byte", "C, x86-64 `-O2`: parse, instructions per byte"),
    (RUST, "parser, three fields", "Code and constants", "Rust, thumbv7em: parser and three fields"),
    (RUST, "parse, in chunks of 4 KiB: `Parser::feed`", "instructions",
     "Rust, x86-64: parse, instructions relative to a plain loop"),
]  # fmt: skip


def cell(file: str, row: str, column: str) -> str:
    """Returns what a table says: the first that has this column, and this text at the beginning of a row."""
    for table in re.findall(r"(?:^\|.*\|\n)+", (ROOT / file).read_text("utf-8"), re.M):
        head, _, *rows = [[x.strip() for x in line.strip("|").split("|")] for line in table.splitlines()]
        for cells in rows:
            if cells[0] == row and column in head:
                return str(cells[head.index(column)])
    sys.exit(f"{file} has no row '{row}' with a column '{column}'; mend tests/status.py")


def specification(model: dict[str, Any]) -> list[str]:
    of = {role: sum(f["role"] == role for f in model["fields"]) for role in ("command", "data", "response")}
    complete = sum("incomplete" not in d for d in model["devices"])
    certain = sum(any(d["evidence"][s["evidence"]]["answer"] == "yes" for s in d["supports"]) for d in model["devices"])
    return [
        f"{of['command']} commands, {of['response']} responses and {of['data']} data fields",
        f"{len(model['devices'])} devices: {complete} complete, {certain - complete} partly documented, others with "
        f"likely and assumed fields only; the names of {len(model['named_devices'])} more",
        f"{len(model['examples'])} printed packets, which every language decodes and encodes byte for byte",
        f"{len(model['errata'])} mistakes in manuals",
    ]


def written_by(command: str) -> list[list[str]]:
    """The rows of the table in docs/proofs.md that this command writes, and before them the sentence above it."""
    text = (ROOT / PROOFS).read_text("utf-8")
    _, begin, rest = text.partition(f"<!-- written by {command} -->\n")
    lines = rest.partition("\n<!-- end ")[0].strip().splitlines() if begin else []
    rows = [[x.strip() for x in line.strip("|").split("|")] for line in lines if line.startswith("|")]
    return [[lines[0]], *rows[2:]] if lines else []


def page(model: dict[str, Any]) -> str:
    (sources,), *proofs = written_by("make prove: the core")
    recorded, *fuzzed = written_by("make fuzz RECORD=1") or [[]]
    proved = [row[3] for row in proofs if row[3].startswith("proved")]
    properties = sum(int(re.findall(r"\d+", result)[0]) for result in proved)
    executions = sum(int(row[1].replace(",", "")) for row in fuzzed)
    rows = [
        *(("Specification", fact, "`make validate`") for fact in specification(model)),
        *((title, cell(file, row, column), BENCH) for file, row, column, title in SHOWN),
        ("Proofs of the C library", f"{len(proved)} of {len(proofs)} proved, {properties:,} properties. {sources}",
         "`make prove`"),
        *(("Fuzzing", f"{executions:,} executions of {len(fuzzed)} programs, no failure. {x}", "`make fuzz RECORD=1`")
          for x in recorded),
        ("Real hardware", "no run is recorded: [send one](contribute-a-device.md)", "`mip record`"),
    ]  # fmt: skip
    return (
        f"# Status of version {model['version']}\n\n<!-- written by make status -->\n\n"
        "What is measured, proved and tested, and the command that shows it. All tables:\n"
        f"[C](../{C}), [Rust](../generated/rust/README.md), [proofs and fuzzing](proofs.md).\n\n"
        "| | Result | Command |\n|---|---|---|\n"
        + "".join(f"| {' | '.join(row)} |\n" for row in rows)
        + "\n`make test` prints how many tests it runs of each part, and what it leaves out; `make nightly` runs all.\n"
    )


def readme(model: dict[str, Any]) -> str:
    """The README with the present figures in its comparison."""
    text = README.read_text("utf-8")
    size = [cell(C, "size: application, waiting for replies", f"{BOARD}{which}")
            for which in ("small parser", "MIP SDK 4.0.0")]  # fmt: skip
    speed = [cell(C, "parse, in pieces of 4 KiB", column) for column in ("Instructions per byte", "MIP SDK 4.0.0")]
    other = re.findall(r"^\| parse, in chunks of 4 KiB: .*\| (\S+) \|$", (ROOT / RUST).read_text("utf-8"), re.M)
    size = [f"{int(x.split()[0]):,} B" for x in size]
    speed = [f"{float(x):.1f}" for x in speed]
    rows = {
        "firmware with three fields and three commands¹": [*size, "not measured", "not measured"],
        "parser, instructions per byte¹": [*speed, "not measured", f"{other[0]} × as many as our crate²"],
    }
    for title, cells in rows.items():
        row = f"| {title} | {' | '.join(cells)} |"
        text, found = re.subn(rf"^{re.escape(f'| {title} |')}.*$", row, text, flags=re.M)
        if not found:
            sys.exit(f"README.md has no row '{title}'; mend tests/status.py")
    return re.sub(
        r"^\| (\w+ \d+) \| mipgen [\d.]+", lambda m: f"| {m[1]} | mipgen {model['version']}", text, flags=re.M
    )


def main() -> None:
    model = json.loads((ROOT / "generated/json/mip.json").read_text("utf-8"))
    for path, text in ((PAGE, page(model)), (README, readme(model))):
        if "--check" not in sys.argv:
            path.write_text(text, "utf-8")
        elif not path.exists() or path.read_text("utf-8") != text:
            sys.exit(f"{path.name} has other figures than the results that it repeats; run: make status")


if __name__ == "__main__":
    main()
