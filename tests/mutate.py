"""Changes the project at random places, one at a time, and reports the changes that no test sees.

    make mutate COUNT=60 SEED=7
    make mutate COUNT=20 SEED=7 PART=c

Each change (a mutant) is made in a copy of the project below build/mutate: an operator, a constant, a condition
turned around, a line dropped, two arguments swapped; in the part `docs`, a fact in the generated documentation. What
is generated is generated again. Then run all tests that `make test` has in the folders of that part, and those of its
language in the conformance suite, up to the first that fails; the quickest come first. For the workbench, those in
Chromium follow. What survives is either a gap in the tests or a change without effect; a person has to look.
"""

from __future__ import annotations

import argparse
import difflib
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
COPY = ROOT / "build/mutate/copy"


@dataclass(frozen=True)
class Part:
    """Files to change, targets to generate again, and tests to run, the quickest first."""

    files: tuple[str, ...]
    targets: tuple[str, ...]
    tests: tuple[tuple[str, ...], ...]


MAKEFILE = (ROOT / "Makefile").read_text("utf-8")
#: What `make test` runs, and the files of the generator's tests that `make quick` leaves out.
MARKED = re.findall(r"^test:.*\n.* -m \"(.*?)\"", MAKEFILE, re.MULTILINE)[0]
SLOW = [f"--ignore=tests/generator/test_{name}.py" for name in re.findall(r"^SLOW := (.+)", MAKEFILE, re.M)[0].split()]


def conformance(languages: str) -> tuple[str, ...]:
    return ("tests/conformance", "-k", languages)


PARTS = {
    "generator": Part(
        tuple(f"generator/mipgen/{room}/*.py" for room in ("read", "model", "resolve", "facts", "lower", "emit")),
        ("c", "kaitai", "python", "rust", "markdown"),
        (("tests/generator", *SLOW), ("tests/generator",), conformance("python or c-invented")),
    ),
    "c": Part(
        ("templates/c/**/*.j2", "runtime/c/**/*.[ch]", "runtime/c/**/*.hpp", "generator/mipgen/targets/c/*.py"),
        ("c",),
        (("tests/c", "-k", "unit or every_"), ("tests/c", "tests/cpp"), conformance("c- or c] or cpp")),
    ),
    "tools": Part(("tools/mip_tools/**/*.py",), (), (("tests/tools",),)),
    "python": Part(
        ("templates/python/**/*.j2", "runtime/python/**/*.py", "generator/mipgen/targets/python/*.py"),
        ("python",),
        (("tests/python",), conformance("python")),
    ),
    "rust": Part(
        ("templates/rust/**/*.j2", "runtime/rust/**/*.rs", "generator/mipgen/targets/rust/*.py"),
        ("rust",),
        (("tests/rust", "-k", "test_cases or test_replay or every_fact"), ("tests/rust",), conformance("rust")),
    ),
    "markdown": Part(
        ("templates/markdown/*.j2", "generator/mipgen/targets/markdown/*.py"), ("markdown",), (("tests/docs",),)
    ),
    "kaitai": Part(
        ("templates/kaitai/*.j2", "generator/mipgen/targets/kaitai/*.py"),
        ("kaitai",),
        (("tests/kaitai",),),
    ),
    "json": Part(
        ("templates/json/*.j2", "generator/mipgen/targets/json/*.py"),
        ("json",),
        (("tests/json",), conformance("json")),
    ),
    "javascript": Part(
        ("runtime/javascript/*/*.mjs", "generator/mipgen/targets/javascript/*.py"),
        ("javascript",),
        (("tests/javascript",), conformance("javascript")),
    ),
    "workbench": Part(
        ("tools/workbench/**/*.mjs", "tools/workbench/build.py"),
        (),
        (("tests/javascript",), ("tests/javascript", "-m", "heavy")),  # most of it runs in a browser only
    ),
    "docs": Part(
        ("generated/c/src/mip/*.h", "generated/python/mip_protocol/*.py", "generated/rust/src/**/*.rs",
         "generated/markdown/docs/**/*.md"),
        (),
        (("tests/docs", "tests/c/test_c_docs.py", "tests/python/test_python_docs.py", "tests/rust/test_rust_docs.py"),),
    ),
}  # fmt: skip


# --------------------------------------------------------------------------- mutants


@dataclass(frozen=True)
class Mutant:
    path: str
    line: int  # from 1
    text: str  # the new line; empty if it is dropped


def next_number(match: re.Match[str]) -> str:
    digits = match[0].removeprefix("0x")
    wide = f"0{len(digits)}"
    return f"{int(digits) + 1:{wide}}" if digits == match[0] else f"0x{int(digits, 16) + 1:{wide}X}"


#: Patterns in code, and their replacements.
CODE: list[tuple[str, object]] = [
    (r"(?<= )<(?= )", "<="), (r"(?<= )>(?= )", ">="), (r"<=", "<"), (r">=", ">"), (r"==", "!="), (r"!=", "=="),
    (r" and ", " or "), (r" or ", " and "), (r"&&", "||"), (r"\|\|", "&&"),
    (r"\bnot (?!in\b)", ""), (r"!(?=[\w(])", ""), (r" \+ ", " - "), (r" - ", " + "), (r" & ", " | "),
    (r"<<", ">>"), (r">>", "<<"), (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"\bTrue\b", "False"), (r"\bFalse\b", "True"),
    (r"\bcontinue\b", "break"), (r"\bmin\b", "max"), (r"\bmax\b", "min"), (r"\bany\(", "all("), (r"\ball\(", "any("),
    (r"(?<![\w.])(0x[0-9A-Fa-f]+|\d+)(?![\w.])", next_number),
    (r"\(([a-z_.]+), ([a-z_.]+)\)", r"(\2, \1)"),
]  # fmt: skip
#: The same for facts in documentation.
FACTS: list[tuple[str, object]] = [
    (r"(?<![\w.,:])\d+(?![\w,:])", next_number), (r"\bm/s\b", "km/h"), (r"\brad\b", "deg"), (r"\bdeg\b", "rad"),
    (r"\bned\b", "sensor"), (r"≤", "<"), (r"≥", ">"),
    (r"(?i)\bat least\b", "at most"), (r"(?i)\bat most\b", "at least"),
    (r"GX5-15", "GX5-25"), (r"CV7-GNSS/INS", "CV7-AHRS"), (r"\b(tow|week_number)\b", "reserved"),
]  # fmt: skip
FACT_LINE = re.compile(r"(?i)range|unit|frame|valid|default|support|at least|at most|≤|≥|\[[\w/%°²,. ]+\]")
#: Lines that are left alone: comments, imports, and `@dataclass`, whose options only forbid what no code does.
NO_CODE = re.compile(r"\s*(//|/\*|\*|#|\{#|import |from |use |@dataclass|$)")


def hidden(line: str) -> str:
    """The line with its strings and comments blotted out, of the same length."""
    line = re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: '"' + "\x00" * (len(m[0]) - 2) + '"', line)
    return re.sub(r"(//|/\*|  # ).*", lambda m: "\x00" * len(m[0]), line)


def mutants(path: Path, docs: bool) -> Iterator[Mutant]:
    name, quoted = path.relative_to(ROOT).as_posix(), False
    for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
        marks = line.count('"""')
        was, quoted = quoted, quoted ^ (marks % 2 == 1)
        text = was or marks or bool(re.match(r"\s*(//|/\*|\*)", line)) or path.suffix == ".md"
        if docs != bool(text) or (docs and not FACT_LINE.search(line)) or (not docs and NO_CODE.match(line)):
            continue
        shown = line if docs else hidden(line)
        for pattern, becomes in FACTS if docs else CODE:
            for match in re.finditer(pattern, shown):
                new = becomes(match) if callable(becomes) else match.expand(str(becomes))
                changed = line[: match.start()] + new + line[match.end() :]
                if changed != line:
                    yield Mutant(name, number, changed)
        if not docs and (dropped := without(line, path.suffix)) is not None:
            yield Mutant(name, number, dropped)


def without(line: str, suffix: str) -> str | None:
    """Drops a line that is one statement."""
    indent = line[: len(line) - len(line.lstrip())]
    if suffix == ".py":
        statement = re.match(r"\s+[a-z_][\w.\[\]]*( [+|-]?= |\().*[^,({\[\\:]$", line) and line.count(
            "("
        ) == line.count(")")
        return f"{indent}pass" if statement else None
    return (
        "" if indent and re.match(r"\s+[a-z_*(].*;$", line) and not re.match(r"\s+(return|let|const)\b", line) else None
    )


# --------------------------------------------------------------------------- the copy


def listed() -> list[str]:
    done = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True)
    return [name for name in done.stdout.splitlines() if (ROOT / name).is_file()]


def restore(places: tuple[str, ...] = ("",)) -> None:
    """Makes the copy equal again; files that are equal keep their times, so that little is built anew."""
    names = [n for n in listed() if n.startswith(places)]
    for folder in (COPY / place for place in places if place.endswith("/")):
        for path in folder.rglob("*"):
            if path.is_file() and path.relative_to(COPY).as_posix() not in names:
                path.unlink()
    for name in names:
        source, target = ROOT / name, COPY / name
        if not target.is_file() or target.read_bytes() != source.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)


def run(limit: float, *command: str) -> tuple[bool, str]:
    """Runs a command in the copy for at most `limit` seconds; returns whether it succeeded, and its output."""
    own = {"PYTHONPATH": COPY / "generator", "MIPGEN_CACHE": COPY / "build/cache", "PYTHONDONTWRITEBYTECODE": "1"}
    environment = os.environ | {name: str(value) for name, value in own.items()}
    environment.pop("SEED", None)  # of `make mutate SEED=2`, which chooses mutants; the tests keep theirs
    process = subprocess.Popen(
        command, cwd=COPY, env=environment, text=True, start_new_session=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    try:
        printed, _ = process.communicate(timeout=limit)
    except BaseException as error:
        os.killpg(process.pid, signal.SIGKILL)  # with everything that it has started
        process.communicate()
        if not isinstance(error, subprocess.TimeoutExpired):
            raise
        return False, f"E   no end after {limit:.0f} s"
    return process.returncode == 0, printed


def generate(part: Part) -> tuple[bool, str]:
    """Generates the real specification again; tests do so for the invented one."""
    if not part.targets:
        return True, ""
    targets = [word for target in part.targets for word in ("--target", target)]
    well, printed = run(120, sys.executable, "-m", "mipgen", "generate", *targets)
    return well, "" if well else "generation fails: " + (printed.strip().splitlines() or [""])[-1]


def passes(tests: tuple[str, ...], limit: float) -> tuple[bool, str]:
    """Do all these tests pass? If not, the first that fails."""
    well, printed = run(
        limit, sys.executable, "-m", "pytest", "-x", "-n", "2", "--dist", "loadgroup", "--no-loadscope-reorder",
        "-p", "no:cacheprovider", "-m", MARKED, *tests,
    )  # fmt: skip
    found = re.search(r"^(FAILED|ERROR) (\S+)", printed, re.M) or re.search(r"^(E) +(.*)", printed, re.M)
    return well, "" if well else (found[2] if found else printed.strip())[-150:]


def outcome(part: Part, mutant: Mutant, usual: list[float]) -> str:
    """What kills the mutant; empty if nothing does. `usual`: how long the tests take; a mutant may never end."""
    path = COPY / mutant.path
    lines = path.read_text("utf-8").splitlines(keepends=True)
    lines[mutant.line - 1] = f"{mutant.text}\n" if mutant.text else ""
    path.write_text("".join(lines), "utf-8")
    try:
        well, why = generate(part)
        for tests, seconds in zip(part.tests, usual, strict=True):
            if well:
                well, why = passes(tests, 30 + 3 * seconds)
    finally:
        restore((mutant.path, *(f"generated/{target}/" for target in part.targets)))
    return "" if well else why


def difference(mutant: Mutant) -> str:
    old = (ROOT / mutant.path).read_text("utf-8").splitlines()
    new = old[: mutant.line - 1] + ([mutant.text] if mutant.text else []) + old[mutant.line :]
    return "\n".join(list(difflib.unified_diff(old, new, lineterm="", n=1))[2:])


# --------------------------------------------------------------------------- the run


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--count", type=int, default=100, help="mutants in all, as many of each part (100)")
    parser.add_argument("--seed", type=int, default=1, help="another seed selects other mutants (1)")
    parser.add_argument(
        "--part", action="append", choices=sorted(PARTS), help="all parts without it; may be given again"
    )
    parser.add_argument("--path", default="", help="only files whose path contains this")
    given = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # no test outlives it
    restore()
    survivors = []
    chosen = given.part or list(PARTS)
    for i, name in enumerate(chosen):
        count = given.count * (i + 1) // len(chosen) - given.count * i // len(chosen)
        part = PARTS[name]
        paths = sorted({p for pattern in part.files for p in ROOT.glob(pattern) if "README" not in p.name})
        paths = [p for p in paths if given.path in p.as_posix()]
        everything = [mutant for path in paths for mutant in mutants(path, name == "docs")]
        usual = []
        for tests in part.tests:
            began = time.monotonic()
            well, why = passes(tests, 3600)
            if not well:  # a busy machine fails tests that wait
                well, why = passes(tests, 3600)
            usual.append(time.monotonic() - began)
            if not well:
                print(f"{name}: the tests fail without any change: {why}", file=sys.stderr)
                return 2
        for mutant in random.Random(given.seed).sample(everything, min(count, len(everything))):
            began = time.monotonic()
            why = outcome(part, mutant, usual)
            said = f"killed by {why}" if why else "SURVIVED"
            print(f"{name}: {mutant.path}:{mutant.line}: {said} ({time.monotonic() - began:.0f} s)", flush=True)
            if not why:
                survivors.append(mutant)
                print(difference(mutant), flush=True)
    print(f"seed {given.seed}: {len(survivors)} survived" + "".join(f"\n  {s.path}:{s.line}" for s in survivors))
    return 0


if __name__ == "__main__":
    sys.exit(main())
