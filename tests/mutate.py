"""Changes the project at random places, one at a time, and reports the changes that no test sees.

    make mutate COUNT=60 SEED=7
    make mutate COUNT=20 SEED=7 PART=c

Each change (a mutant) is made in a copy of the project below build/mutate: an operator, a constant, a condition
turned around, a line dropped, two arguments swapped; in the part `docs`, a fact in the generated documentation. Then
run the tests that `make test` has in the folders of that part, and those of its language in the conformance suite, up
to the first that fails, in the order of likelihood: those that have seen other changes, first of the same file; the
test modules that share most words with the changed line, its function and its file; all others. What is generated is
generated again before the first test that reads it. For the workbench, tests in Chromium are among them.

What survives is either a gap in the tests or a change without effect; a person has to look. So it is with a change
whose tests have no end within the limit: they hang, or they are many. A run that was stopped continues with the next
mutant; after any change of the project, it begins anew.
"""

from __future__ import annotations

import argparse
import difflib
import hashlib
import json
import math
import os
import random
import re
import shutil
import signal
import statistics
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
BUILD = ROOT / "build/mutate"
#: The project as it was when the run began, because people go on changing theirs; and the copy that is changed.
SOURCE, COPY = BUILD / "source", BUILD / "copy"
#: What the last tests that failed have printed.
PRINTED = BUILD / "failed.txt"
#: What earlier runs have found: file -> the tests that killed mutants of it, and how many; test module -> seconds.
KNOWN = BUILD / "known.json"
Known = dict[str, dict[str, float]]
#: What a command has printed that was stopped.
NO_END = "no end"


@dataclass(frozen=True)
class Part:
    """Files to change, targets to generate again, folders of tests, and languages of conformance tests for `-k`."""

    files: tuple[str, ...]
    targets: tuple[str, ...]
    tests: tuple[str, ...]
    languages: str = ""


#: What `make test` runs.
MARKED = re.findall(r"^test:.*\n.* -m \"(.*?)\"", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)[0]

PARTS = {
    "generator": Part(
        tuple(f"generator/mipgen/{room}/*.py" for room in ("read", "model", "resolve", "facts", "lower", "emit")),
        ("c", "kaitai", "python", "rust", "markdown"), ("tests/generator",), "python or c-invented",
    ),
    "c": Part(
        ("templates/c/**/*.j2", "runtime/c/**/*.[ch]", "runtime/c/**/*.hpp", "generator/mipgen/targets/c/*.py"),
        ("c",), ("tests/c", "tests/cpp"), "c- or c] or cpp",
    ),
    "tools": Part(("tools/mip_*/**/*.py",), (), ("tests/tools",)),
    "python": Part(
        ("templates/python/**/*.j2", "runtime/python/**/*.py", "generator/mipgen/targets/python/*.py"),
        ("python",), ("tests/python",), "python",
    ),
    "rust": Part(
        ("templates/rust/**/*.j2", "runtime/rust/**/*.rs", "generator/mipgen/targets/rust/**/*.py"),
        ("rust",), ("tests/rust",), "rust",
    ),
    "markdown": Part(
        ("templates/markdown/*.j2", "generator/mipgen/targets/markdown/**/*.py"), ("markdown",), ("tests/docs",)
    ),
    "kaitai": Part(("templates/kaitai/*.j2", "generator/mipgen/targets/kaitai/*.py"), ("kaitai",), ("tests/kaitai",)),
    "json": Part(("templates/json/*.j2", "generator/mipgen/targets/json/*.py"), ("json",), ("tests/json",), "json"),
    "javascript": Part(
        ("runtime/javascript/*/*.mjs", "generator/mipgen/targets/javascript/*.py"),
        ("javascript",), ("tests/javascript",), "javascript",
    ),
    "workbench": Part(("tools/workbench/**/*.mjs",), (), ("tests/javascript",)),
    "docs": Part(
        ("generated/c/src/mip/*.h", "generated/python/mip_protocol/*.py", "generated/rust/src/**/*.rs",
         "generated/markdown/docs/**/*.md"),
        (),
        ("tests/docs", "tests/c/test_c_docs.py", "tests/python/test_python_docs.py", "tests/rust/test_rust_docs.py"),
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
    name, quoted = path.relative_to(SOURCE).as_posix(), False
    for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
        marks = line.count('"""')
        was, quoted = quoted, quoted ^ (marks % 2 == 1)
        text = was or marks or bool(re.match(r"\s*(//|/\*|\*)", line)) or path.suffix == ".md"
        if docs != bool(text) or (docs and not FACT_LINE.search(line)) or (not docs and NO_CODE.match(line)):
            continue
        if path.name.endswith(".md.j2") and not re.search(r"\{[{%]", line):
            continue  # prose
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


def bring(names: list[str], source: Path, target: Path) -> None:
    """Makes these files of a folder equal to those of another; equal ones keep their times, so that little is built."""
    for name in names:
        if not (target / name).is_file() or (target / name).read_bytes() != (source / name).read_bytes():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / name, target / name)
            shutil.copymode(source / name, target / name)


def restore(names: list[str], places: tuple[str, ...] = ("",)) -> None:
    """Makes the copy equal again, below these places: of a folder, files that were added go."""
    names = [name for name in names if name.startswith(places)]
    for folder in (COPY / place for place in places if place.endswith("/")):
        for path in folder.rglob("*"):
            if path.is_file() and path.relative_to(COPY).as_posix() not in names:
                path.unlink()
    bring(names, SOURCE, COPY)


def run(limit: float, *command: str) -> tuple[int, str]:
    """Runs a command in the copy for at most `limit` seconds; returns its status and its output."""
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
        return -1, NO_END
    return process.returncode, printed


def generate(part: Part) -> str:
    """Generates the real specification again; tests do so for the invented one. Returns what prevents it."""
    targets = [word for target in part.targets for word in ("--target", target)]
    status, printed = run(300, sys.executable, "-m", "mipgen", "generate", *targets)
    return "" if status == 0 else "generation fails: " + (printed.strip().splitlines() or [""])[-1]


def fails(part: str, limit: float, tests: list[str], known: Known, *options: str) -> str:
    """The first of these tests that fails; empty if none does. Remembers how long modules take."""
    marked = f"({MARKED}) or heavy" if part == "workbench" else MARKED  # most of it runs in a browser only
    languages = ("-k", f"not conformance or {PARTS[part].languages}") if PARTS[part].languages else ()
    status, printed = run(
        limit, sys.executable, "-m", "pytest", "-x", "-p", "no:cacheprovider", "--durations=0", "-m", marked,
        *languages, *options, *tests,
    )  # fmt: skip
    seconds: dict[str, float] = {}
    for took, module in re.findall(r"^([\d.]+)s \w+ +([^:\s]+)::", printed, re.M):
        seconds[module] = seconds.get(module, 0) + float(took)
    before = known.setdefault("seconds", {})
    before.update({module: max(took, before.get(module, 0)) for module, took in seconds.items()})
    if status not in (0, 5):
        PRINTED.write_text(printed, "utf-8")
    found = re.search(r"^(?:FAILED|ERROR) ([^\[@\s]+)", printed, re.M)  # parameters may be any text
    return "" if status in (0, 5) else found[1] if found else printed.strip()[-150:]


@cache
def words_of(path: Path) -> frozenset[str]:
    """The words of a test module, and of the programs beside it that it names."""
    text = path.read_text("utf-8")
    beside = {p for p in path.parent.rglob("*.[cmr]*") if f'"{p.stem}' in text or p.name in text}
    return frozenset(re.findall(r"[a-z0-9]+", " ".join([text, *(p.read_text("utf-8") for p in beside)]).lower()))


def likeliest(mutant: Mutant, modules: list[Path], seconds: dict[str, float]) -> list[Path]:
    """The test modules; first those with most, and the rarest, words of the changed line, and the quicker ones."""
    lines = (SOURCE / mutant.path).read_text("utf-8").splitlines()[: mutant.line]
    function = next((line for line in reversed(lines) if re.match(r"\w.*\(|\s*(async )?(def|fn|class) ", line)), "")
    near = " ".join((mutant.path, function, lines[-1])).lower()
    common = {w: sum(w in words_of(path) for path in modules) for w in re.findall(r"[a-z0-9]{3,}", near)}

    def score(path: Path) -> float:
        rare = sum(math.log(len(modules) / number) for w, number in common.items() if w in words_of(path))
        return -rare / math.sqrt(2 + seconds.get(path.relative_to(SOURCE).as_posix(), 0))

    return sorted(modules, key=score)


def proven(mutant: Mutant, known: Known) -> Iterator[str]:
    """The tests that have killed mutants, first those of the same file."""
    kills: Counter[str] = Counter()
    for path, tests in known.items():
        for test, number in tests.items() if path != "seconds" else ():
            kills[test] += int(number) * (1000 if path == mutant.path else 1)
    for test, _ in kills.most_common():
        path, _, name = test.partition("::")
        if (SOURCE / path).is_file() and f"def {name}(" in (SOURCE / path).read_text("utf-8"):
            yield test


def outcome(name: str, mutant: Mutant, limit: float, known: Known, names: list[str]) -> str:
    """What kills the mutant; empty if nothing does."""
    part, end = PARTS[name], time.monotonic() + limit
    folders = [*part.tests, *(["tests/conformance"] if part.languages else [])]
    modules = [
        p for f in folders for p in ([SOURCE / f] if f.endswith(".py") else sorted((SOURCE / f).rglob("test_*.py")))
    ]
    ranked = [p.relative_to(SOURCE).as_posix() for p in likeliest(mutant, modules, known.get("seconds", {}))]
    killers = [test for test in proven(mutant, known) if test.partition("::")[0] in ranked][:5]
    path = COPY / mutant.path
    lines = path.read_text("utf-8").splitlines(keepends=True)
    lines[mutant.line - 1] = f"{mutant.text}\n" if mutant.text else ""
    path.write_text("".join(lines), "utf-8")
    why, stale = "", bool(part.targets)
    try:
        for tests, options in ((killers, ()), (ranked[:4], ()), (ranked[4:], ("-n", "2", "--dist", "loadgroup"))):
            if not why and stale and any("tests/generator" not in test for test in tests):  # which makes its own output
                why, stale = generate(part), False
            if not why and tests:
                why = fails(name, end - time.monotonic(), tests, known, *options)
    finally:
        restore(names, (mutant.path, *(f"generated/{target}/" for target in part.targets)))
    return why


def difference(mutant: Mutant) -> str:
    old = (SOURCE / mutant.path).read_text("utf-8").splitlines()
    new = old[: mutant.line - 1] + ([mutant.text] if mutant.text else []) + old[mutant.line :]
    return "\n".join(list(difflib.unified_diff(old, new, lineterm="", n=1))[2:])


# --------------------------------------------------------------------------- the run


def chosen(name: str, number: int, seed: int, within: str) -> list[Mutant]:
    """As many mutants of a part, of those files whose path contains a text; more of them begin with the same ones."""
    paths = sorted({p for pattern in PARTS[name].files for p in SOURCE.glob(pattern) if "README" not in p.name})
    found = [mutant for path in paths if within in path.as_posix() for mutant in mutants(path, name == "docs")]
    random.Random(seed).shuffle(found)
    return found[:number]


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--count", type=int, default=100, help="mutants in all, as many of each part (100)")
    parser.add_argument("--seed", type=int, default=1, help="another seed selects other mutants (1)")
    parser.add_argument("--limit", type=float, default=900, help="seconds for all tests of a mutant (900)")
    parser.add_argument(
        "--part", action="append", choices=sorted(PARTS), help="all parts without it; may be given again"
    )
    parser.add_argument("--path", default="", help="only files whose path contains this")
    given = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # no test outlives it
    names = listed()
    for old in SOURCE.rglob("*"):
        if old.is_file() and old.relative_to(SOURCE).as_posix() not in names:
            old.unlink()
    bring(names, ROOT, SOURCE)
    restore(names, ("", *(f"{name}/" for name in sorted({name.partition("/")[0] for name in names if "/" in name}))))
    state = hashlib.sha256(b"".join((SOURCE / name).read_bytes() for name in names)).hexdigest()
    kept = BUILD / f"{given.seed}-{state[:12]}.json"
    results: dict[str, dict[str, Any]] = read(kept)
    known = read(KNOWN)
    sound = {result["why"] for result in results.values()}  # tests that pass without any change, and other reasons
    parts = given.part or list(PARTS)
    counts = [given.count * (i + 1) // len(parts) - given.count * i // len(parts) for i in range(len(parts))]
    todo = [(name, mutant) for name, n in zip(parts, counts) for mutant in chosen(name, n, given.seed, given.path)]
    for name, mutant in todo:
        if str(mutant) in results:
            continue
        began, used = time.monotonic(), sum(os.times()[2:4])  # of processes that have ended
        why = outcome(name, mutant, given.limit, known, names)
        took = {"seconds": time.monotonic() - began, "cpu": sum(os.times()[2:4]) - used}
        if "::" in why and why not in sound:
            if fails(name, given.limit, [why], known):
                print(f"{name}: fails without any change: {why}; {PRINTED} has what it printed", file=sys.stderr)
                return 2
            sound.add(why)
        if "::" in why:
            killers = known.setdefault(mutant.path, {})
            killers[why] = killers.get(why, 0) + 1
        results[str(mutant)] = {"why": why, **took}
        kept.write_text(json.dumps(results, indent=1), "utf-8")
        KNOWN.write_text(json.dumps(known, indent=1), "utf-8")
        said = f"killed by {why}" if why else "SURVIVED"
        print(
            f"{name}: {mutant.path}:{mutant.line}: {said} ({took['seconds']:.0f} s, CPU {took['cpu']:.0f} s)",
            flush=True,
        )
        if not why:
            print(difference(mutant), flush=True)
    done = [(mutant, results[str(mutant)]) for _, mutant in todo]
    median = statistics.median(result["cpu"] for _, result in done) if done else 0
    endless = [mutant for mutant, result in done if result["why"].startswith(NO_END)]
    survived = [mutant for mutant, result in done if not result["why"]]
    print(
        f"seed {given.seed}: {len(done)} mutants, the median {median:.0f} s of CPU; results in {kept.relative_to(ROOT)}"
    )
    for what, which in ((f"had no end within {given.limit:.0f} s", endless), ("survived", survived)):
        print(f"{len(which)} {what}" + "".join(f"\n  {mutant.path}:{mutant.line}" for mutant in which))
    return 0


def read(file: Path) -> dict[str, Any]:
    return dict(json.loads(file.read_text("utf-8"))) if file.is_file() else {}


if __name__ == "__main__":
    sys.exit(main())
