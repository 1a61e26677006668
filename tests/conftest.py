"""For all tests: the generator's cache, the programs that they find, and the last line: what was run and left out."""

from __future__ import annotations

import gc
import os
import shutil
import signal
from collections import Counter
from collections.abc import Generator, Iterable, Iterator
from itertools import chain
from typing import Any

import bare
import pytest
from mipgen import model as m
from support import BUILD, EVERYTHING, NIGHTLY, PROGRAMS, SEED, generate_invented, uses

# The generator's cache is here: tests neither see nor change that of the user.
os.environ["MIPGEN_CACHE"] = str(BUILD / "cache")
# A shell without job control makes background programs ignore Ctrl-C, and so do the programs that they start.
signal.signal(signal.SIGINT, signal.default_int_handler)

# The collected tests stay until the end: looking for garbage among them would take a sixth of the time.
gc.disable()

# A test that fails shows its values; printing a whole model would take half a minute.
m.Model.__repr__ = m.Device.__repr__ = lambda self: f"<{type(self).__name__}>"  # type: ignore[method-assign]

# What a test needs, it declares: all others find only the programs of any machine.
os.environ["PATH"] = BARE = bare.path(BUILD / "path", EVERYTHING)

#: Whether it is an error if a test was left out because a program is missing: CI has them all.
STRICT = bool(os.environ.get("STRICT"))

#: The targets of make that run the tests that were left out, and what those need, as `support.heavy` names it. No
#: target runs those that use a missing program.
left_out: set[tuple[str, str]] = set()


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput") and (problem := generate_invented()):
        pytest.exit(f"the invented specification cannot be generated:\n{problem}", 1)


def needs(items: Iterable[pytest.Item]) -> Iterator[tuple[str, str]]:
    for item in items:
        for name, target in (("nightly", "nightly"), ("packaging", "test-packaging"), ("heavy", "test-all")):
            mark = item.get_closest_marker(name)
            if mark is not None:
                yield target, mark.args[0] if mark.args else "packages and build systems"
                break
        if item.get_closest_marker("cross") is not None:
            yield "test-cross", "other machines"


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> Generator[None, None, None]:
    group(items)  # which xdist reads in this hook, too
    yield  # by the expression of `-m`, some are left out
    kept = []
    for item in items:
        programs = {program for mark in item.iter_markers("uses") for program in mark.args}
        missing = {program for program in programs if shutil.which(program, path=EVERYTHING) is None}
        left_out.update(("", program) for program in missing)
        if not missing:
            kept.append(item)
    items[:] = kept


def group(items: list[pytest.Item]) -> None:
    """Tests that use cargo, which has one target folder, wait for it in one process and not in all. Tests that need
    random values of all fields run in the process where these have been drawn."""
    for item in items:
        spec = getattr(item, "callspec", None) and item.callspec.params.get("spec")
        if item.path.name == "test_c_print.py":
            spec = spec or "invented"
        if item.path.parent.name == "rust":
            item.add_marker(pytest.mark.xdist_group("cargo"))
        elif spec and (item.path.parent.name == "conformance" or item.path.name == "test_c_print.py"):
            item.add_marker(pytest.mark.xdist_group(f"values-{spec}"))
        elif item.path.name == "test_columns.py":
            item.add_marker(pytest.mark.xdist_group("columns"))
        if any(mark.args == ("cargo",) for mark in item.iter_markers("xdist_group")):
            item.add_marker(uses("cargo"))
    items[:] = balanced(items, int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", 1)))


#: Groups of tests that run in one process, those that take longest first.
LONGEST = ("cargo", "values-real", "columns", "values-invented", "site")


def balanced(items: list[pytest.Item], workers: int) -> list[pytest.Item]:
    """Puts long groups first: a worker takes two things at once, so each takes a group and a single test."""
    groups: dict[str, list[pytest.Item]] = {name: [] for name in LONGEST}
    single = []
    for item in items:
        mark = item.get_closest_marker("xdist_group")
        (groups.setdefault(mark.args[0], []) if mark else single).append(item)
    longest = [group for group in groups.values() if group]
    return [*chain(*longest[:workers]), *single[:workers], *chain(*longest[workers:]), *single[workers:]]


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> None:
    more = any(item.get_closest_marker(name) for name in ("uses", "heavy", "packaging", "cross", "nightly"))
    os.environ["PATH"] = os.pathsep.join((BARE, EVERYTHING)) if more else BARE


def pytest_collection_finish() -> None:
    gc.enable()


def pytest_deselected(items: list[pytest.Item]) -> None:
    left_out.update(needs(items))


@pytest.hookimpl(tryfirst=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    if hasattr(session.config, "workeroutput"):  # in a worker of xdist, which alone knows what was left out
        session.config.workeroutput["left_out"] = sorted(left_out)
    elif STRICT and any(target == "" for target, _ in left_out):
        session.exitstatus = 1


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    left_out.update((target, what) for target, what in getattr(node, "workeroutput", {}).get("left_out", ()))


def pytest_unconfigure(config: pytest.Config) -> None:
    """The last line: how many tests of each subject were run, and what was left out."""
    reporter: Any = config.pluginmanager.get_plugin("terminalreporter")
    if reporter is None or hasattr(config, "workeroutput"):
        return
    run: Counter[str] = Counter()
    for outcome in ("passed", "failed", "error", "skipped"):
        run.update(report.nodeid.split("/")[1] for report in reporter.stats.get(outcome, ()))
    counts = ", ".join(f"{name} {count}" for name, count in sorted(run.items()))
    if not NIGHTLY:
        left_out.add(("nightly", "more rounds of random tests, and other seeds"))
    rest = [
        f"left out, for `make {target}`: {', '.join(sorted(what for of, what in left_out if of == target))}"
        for target in sorted({target for target, _ in left_out} - {""})
    ]
    if missing := [f"{p} ({PROGRAMS.get(p, 'see its page')})" for target, p in sorted(left_out) if target == ""]:
        error = ", an error with STRICT=1" if STRICT else ""
        rest.insert(0, f"left out, because it is missing{error}: what uses {', '.join(missing)}")
    reporter.write_line(f"tests run: {counts or 'none'}; seed {SEED}; {'; '.join(rest) or 'nothing was left out'}")
