"""What the tests of all languages share: models, drivers, and an oracle for streams."""

from __future__ import annotations

import argparse
import ast
import contextlib
import fcntl
import importlib
import io
import json
import os
import pickle
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import pytest
from mipgen import cli
from mipgen import model as m
from mipgen.base import cache as kept
from mipgen.base.resources import MANIFEST
from mipgen.emit import discovery, stamp
from mipgen.emit.target import OPERATIONS
from mipgen.lower import codec
from mipgen.resolve.load import load_model

T = TypeVar("T")
ROOT = Path(__file__).parents[1]
BUILD = ROOT / "build"

#: What programs need that use the tools on top of the real package.
PYTHONPATH = os.pathsep.join((str(ROOT / "tools"), str(ROOT / "generated/python")))

#: All targets, with those of the folders that MIPGEN_TARGETS names, as `--target-path` does.
SOURCES = discovery.targets([Path(p).resolve() for p in os.environ.get("MIPGEN_TARGETS", "").split(os.pathsep) if p])

#: Target -> the operations that its conformance driver offers, of those that have a driver.
OFFERS: dict[str, tuple[str, ...]] = {
    name: operations for name, s in SOURCES.items() if (operations := s.load().conformance)
}

#: What has a driver and is not a target: it is part of the output of another one.
WITHIN = {"cpp": "c"}
OFFERS["cpp"] = ("parse", "decode", "encode")
assert {x for offered in OFFERS.values() for x in offered} <= {*OPERATIONS}, f"a driver offers {', '.join(OPERATIONS)}"

#: Specification -> where it is and where its output is: the committed one, or what `generate_invented` has made.
SPECS = {
    "real": (ROOT / "spec", ROOT / "generated"),
    "invented": (ROOT / "tests/invented/spec", BUILD / "invented"),
}


def generate_invented() -> str:
    """Brings the output of the invented specification up to date, once before all tests; returns what prevents it.

    It runs in a process of its own: otherwise, the process of the tests would keep what it imports.
    """
    spec, out = SPECS["invented"]
    command = [sys.executable, "-m", "mipgen", "generate", "--spec", str(spec), "--out", str(out)]
    with locked(out):
        done = subprocess.run(
            command, env={**os.environ, "PYTHONPATH": str(ROOT / "generator")}, capture_output=True, text=True
        )
    return done.stdout + done.stderr if done.returncode != 0 else ""


#: Seconds until a test gives up on what hangs. On a busy machine, anything else may take much longer than usual.
PATIENCE = 120.0

#: What random tests begin with, and whether they try much more than usual: `make nightly` does, with another seed.
SEED = int(os.environ.get("SEED") or 1)
NIGHTLY = bool(os.environ.get("NIGHTLY"))


def rounds(usual: int, nightly: int) -> int:
    """How often something is tried with random values."""
    return nightly if NIGHTLY else usual


def offering(*operations: str) -> list[Any]:
    """The targets whose drivers offer all of these, as parameters of a test."""
    return [
        pytest.param(name, marks=needed(name)) for name, offered in OFFERS.items() if set(operations) <= set(offered)
    ]


def needed(target: str) -> list[pytest.MarkDecorator]:
    """What marks tests of a target's driver: it is heavy, or uses a program."""
    if target == "cpp":
        return [uses("g++")]
    of = SOURCES[target].load()
    return [heavy(of.needs)] if of.needs else [uses(of.program)] if of.program else []


def at_hand(target: str) -> bool:
    """Whether `make test` runs the driver of a target on this machine."""
    marks = needed(target)
    return not any(mark.name == "heavy" or shutil.which(mark.args[0], path=EVERYTHING) is None for mark in marks)


def each(*operations: str) -> Any:
    """For every language whose driver offers these operations, and both specifications."""

    def mark(test: Any) -> Any:
        test = pytest.mark.parametrize("language", offering(*operations))(test)
        return pytest.mark.parametrize("spec", sorted(SPECS))(test)

    return mark


@cache
def model(spec: str) -> m.Model:
    """The model of a specification. It is kept between runs: resolving it takes longer than most tests."""
    folder = SPECS[spec][0]
    key = stamp.run_key([folder], "model")
    assert key is not None
    known = kept.get("model", key)
    if known is None:
        known = pickle.dumps(load_model(folder))
        kept.put("model", {key: known})
    found: m.Model = pickle.loads(known)
    return found


def generated(target: str, spec: str) -> dict[str, bytes]:
    """The output of a target as it is in its folder, which `make check` compares with what would be made now."""
    folder = SPECS[spec][1] / target
    _, *paths = (folder / MANIFEST).read_text("utf-8").splitlines()
    return {path: (folder / path).read_bytes() for path in (*paths, MANIFEST)}


def some(found: T | None) -> T:
    """What was looked up, which must be there."""
    assert found is not None
    return found


@dataclass(frozen=True)
class Done:
    returncode: int
    stdout: str
    stderr: str


def mipgen(*arguments: str | Path, cwd: Path = ROOT, **environment: str) -> Done:
    """Runs a command in a folder, with variables of the environment."""
    here, before = Path.cwd(), dict(os.environ)
    out, err = io.StringIO(), io.StringIO()
    os.chdir(cwd)
    os.environ.update(environment)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = cli.main([str(argument) for argument in arguments])
    finally:
        os.chdir(here)
        for name in environment:
            os.environ.pop(name)
        os.environ.update({name: value for name, value in before.items() if name in environment})
    return Done(status, out.getvalue(), err.getvalue())


class later:
    """A module that is imported when it is used for the first time: `np = later("numpy")`.

    Collecting tests imports all of their modules, in every process.
    """

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, name: str) -> Any:
        if name.startswith(("__", "pytest")):  # what pytest asks of all that it finds in a module
            raise AttributeError(name)
        return getattr(importlib.import_module(self._name), name)


def need(tool: str) -> str:
    """The path of a tool, of this environment before others; a missing one is an error, never a skip."""
    path = shutil.which(tool, path=str(Path(sys.executable).parent)) or shutil.which(tool)
    assert path is not None, f"{tool} is missing, or the test does not say that it `uses` it"
    return path


def heavy(what: str) -> pytest.MarkDecorator:
    """Marks a test that needs more than Python, a C compiler and PROGRAMS, or takes long; `what` it is, in few words.

    `make test` leaves it out and names it in its last line, `make test-all` runs it.
    """
    return pytest.mark.heavy(what)


#: What `make test` uses beside Python and a C compiler, and a command that installs it.
PROGRAMS = {
    "cargo": "curl -sSf https://sh.rustup.rs | sh -s -- -y",
    "g++": "apt-get install g++",
    "node": "apt-get install nodejs",
    "npm": "apt-get install npm",
}


#: Where these are, also for the workers of xdist: tests that use none have less on their PATH.
EVERYTHING = os.environ.setdefault("TEST_PATH", os.environ["PATH"])


def uses(*programs: str) -> pytest.MarkDecorator:
    """Marks a test that is left out where a program is missing; the last line says so, and STRICT=1 makes it fail.

    Without a program, it is for a test that uses those that are `at_hand`.
    """
    return pytest.mark.uses(*programs)


def nightly(what: str) -> pytest.MarkDecorator:
    """Marks a test that takes minutes and that hardly any change can break; only `make nightly` runs it."""
    return pytest.mark.nightly(what)


#: Marks a test that builds or installs packages, or configures a build system; only `make test-packaging` runs it.
packaging = pytest.mark.packaging


def small(what: str) -> pytest.MarkDecorator:
    """Both specifications, for a test that would rarely find more in the real one: it is ten times as large, of the
    same kinds of parts. `make test-all` runs it; all bytes of the real one are in the conformance suite."""
    return pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=heavy(what))])


def each_of_the_small_one(*operations: str) -> Any:
    """For every language, with the small specification, which has all kinds of layouts; `make test-all`: both."""

    def mark(test: Any) -> Any:
        test = pytest.mark.parametrize("language", offering(*operations))(test)
        return small("every layout of the real specification")(test)

    return mark


def another_python(version: str) -> str:
    """A Python of this version; a missing one is an error."""
    home = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = [shutil.which(f"python{version}"), *sorted(str(p) for p in home.glob(f"{version}.*/bin/python"))]
    works = [p for p in found if p and subprocess.run([p, "-c", "pass"], capture_output=True).returncode == 0]
    assert works, f"python{version} is missing; install it (pyenv install {version})"
    return works[0]


def parse_as(version: str, folder: Path) -> None:
    """Parses all files of a folder as that version of the language; a SyntaxError says where one is not."""
    minor = int(version.partition(".")[2])
    paths = sorted(folder.rglob("*.py"))
    assert paths
    for path in paths:
        ast.parse(path.read_text("utf-8"), feature_version=(3, minor))


def sent(p: m.Parameter) -> Any:
    """The value that is sent for a reserved parameter, in the form of the conformance protocol."""
    value = p.reserved if p.length is None else [p.reserved] * int(p.length)
    return codec.canonical(p, value, p.name)


@dataclass(frozen=True)
class Driver:
    """A conformance driver, run once for each batch of requests."""

    language: str
    command: list[str]
    environment: dict[str, str]

    def ask(self, requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
        lines = "".join(json.dumps(r) + "\n" for r in requests)
        done = subprocess.run(
            self.command, input=lines, capture_output=True, text=True, env={**os.environ, **self.environment}
        )
        assert done.returncode == 0, f"{self.language}: exit {done.returncode}: {done.stderr[-4000:]}"
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        assert len(answers) == len(requests), f"{self.language}: {len(answers)} answers to {len(requests)} requests"
        return answers


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Keeps other test processes out of a build folder."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{folder}.lock", "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


@cache
def node_modules() -> Path:
    """The packages of `requirements/npm`, installed as make does."""
    with locked(BUILD / "npm"):
        subprocess.run(["make", "-s", "build/npm/stamp"], cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
    return BUILD / "npm/node_modules"


def build_script(language: str) -> Path:
    """What builds the driver of a target: in tests/ for ours, beside its target.py for another."""
    module = None if language in WITHIN else SOURCES[language].module
    return (module.parent if module else ROOT / "tests" / language) / "build_driver.sh"


def output(language: str, spec: str) -> Path:
    """What a target makes of a specification: committed for ours, made now for another."""
    language = WITHIN.get(language, language)
    module = SOURCES[language].module
    if module is None:
        return SPECS[spec][1] / language
    out = BUILD / f"output-{spec}"
    arguments = ("--spec", str(SPECS[spec][0]), "--out", str(out), "--target-path", str(module.parents[1]))
    with locked(out):
        assert cli.main(["generate", *arguments, "--target", language]) == 0
    return out / language


@cache
def driver(language: str, spec: str) -> Driver:
    """The driver of a language for a specification's output; C and C++ run under the sanitizers."""
    environment = {"PYTHON": os.environ.get("PYTHON", "") or need("python3")}
    if language in ("c", "cpp"):
        import c_build  # it needs this module itself

        environment |= {"MIP_SANITIZE": "1", "ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "halt_on_error=1"}
        if SOURCES["c"].ours:
            library = str(c_build.archive(spec, "cc", *c_build.SANITIZED))
            if language == "cpp":  # with the other parser
                library = f"{c_build.small_parser(spec, 'cc', *c_build.SANITIZED)} {library}"
            environment["MIP_LIBRARY"] = library
    if (language, spec) == ("cpp", "real") and not NIGHTLY:  # comparing them for all takes as long as all of C
        environment |= {"MIP_EVERY": "16", "MIP_SEED": str(SEED)}
    if language == "rust":  # optimizing takes longer than all tests
        environment |= {"CARGO_PROFILE_RELEASE_OPT_LEVEL": "0"}
    script, build = build_script(language), BUILD / f"conformance-{spec}-{language}"
    with locked(build):
        done = subprocess.run(
            [str(script), str(output(language, spec)), str(build)],
            capture_output=True, text=True, env={**os.environ, **environment},
        )  # fmt: skip
    assert done.returncode == 0, f"{script}: {done.stdout}{done.stderr}"
    return Driver(language, done.stdout.splitlines()[-1].split(), environment)


def mypy(package: Path, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Checks with a Python package on the path, strictly, but for the types of pyserial, which has none; the tools are
    checked elsewhere. What is known of the standard library is kept for the next check, which has the same options."""
    known = BUILD / "mypy"
    options = ("--strict", "--disable-error-code=import-untyped", "--follow-imports=silent", "--cache-dir", known)
    with locked(known):
        return subprocess.run(
            [sys.executable, "-m", "mypy", *options, *arguments],
            cwd=package, capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(ROOT / "tools")},
        )  # fmt: skip


# --------------------------------------------------------------------------- the reference's answers


def expected(of: m.Model, request: dict[str, Any]) -> dict[str, Any]:
    """What a driver must answer, by the generator's own interpreter of the model."""
    if request["op"] == "parse":
        return expected_parse(bytes.fromhex(request["stream"]))
    if request["op"] == "decode":
        return expected_decode(of, bytes.fromhex(request["packet"]))
    if request["op"] == "client":
        from conformance.client_model import expected_client  # it needs this module itself

        return expected_client(of, request)
    return expected_encode(of, request)


def expected_parse(stream: bytes) -> dict[str, Any]:
    """Every place is tried in order; a packet is taken whole."""
    packets, at = [], 0
    while at < len(stream):
        size = stream[at + 3] + 6 if at + 3 < len(stream) else len(stream) + 1
        whole = stream[at : at + size]
        good = len(whole) == size and whole[:2] == b"ue" and whole[2] not in m.NO_SETS
        if good and codec.checksum(whole[:-2]) == whole[-2:]:
            packets.append(whole.hex())
            at += size
        else:
            at += 1
    return {"packets": packets, "skipped": len(stream) - sum(len(p) // 2 for p in packets)}


def expected_decode(of: m.Model, packet: bytes) -> dict[str, Any]:
    try:
        codec.split(of, packet)
    except codec.CodecError as error:
        if error.kind != "field_length":
            return {"error": error.kind}
    fields: list[dict[str, Any]] = []
    payload = packet[4:-2]
    while payload:
        length = payload[0]
        if length < 2 or length > len(payload):
            fields.append({"error": "field_length"})
            break
        fields.append(expected_field(of, packet[2], payload[1], payload[2:length]))
        payload = payload[length:]
    return {"set": packet[2], "fields": fields}


def expected_field(of: m.Model, number: int, descriptor: int, data: bytes) -> dict[str, Any]:
    field = codec.choose(of.candidates(number, descriptor), data)
    if field is None:
        return {"descriptor": descriptor, "raw": data.hex()}
    try:
        values, trailing = codec.decode(field, data)
    except codec.CodecError as error:
        return {"descriptor": descriptor, "error": error.kind, "raw": data.hex()}
    return {
        "descriptor": descriptor, "name": field.name_in(number), "role": field.role, "values": values,
        "trailing": trailing,
    }  # fmt: skip


def expected_encode(of: m.Model, request: dict[str, Any]) -> dict[str, Any]:
    if request["set"] in m.NO_SETS:
        return {"error": "set"}
    try:
        parts = []
        for f in request["fields"]:
            if "raw" in f:
                parts.append((f["descriptor"], bytes.fromhex(f["raw"])))
                continue
            candidates = of.candidates(request["set"], f["descriptor"])
            field = next((c for c in candidates if c.name_in(request["set"]) == f["name"]), None)
            if field is None:
                raise codec.CodecError("unknown", f["name"])
            parts.append((field.descriptor, codec.encode(field, f["values"])))
            codec.build(of, request["set"], parts)  # of several mistakes, the first one is reported
        return {"packet": codec.build(of, request["set"], parts).hex()}
    except codec.CodecError as error:
        return {"error": error.kind}


def differences(requests: list[Any], wanted: list[Any], answers: list[Any]) -> str:
    """A text with the first few wrong answers; empty if there is none."""
    wrong = [(r, w, a) for r, w, a in zip(requests, wanted, answers, strict=True) if w != a]
    shown = "".join(
        f"\nrequest  {json.dumps(r)}\nexpected {json.dumps(w)}\nanswered {json.dumps(a)}" for r, w, a in wrong[:3]
    )
    return f"{len(wrong)} of {len(requests)} answers are wrong{shown}" if wrong else ""


def set_of(field: m.Field, of: m.Model) -> int:
    """A descriptor set in whose packets the field can occur."""
    if field.set == 0:
        return next(s.number for s in of.sets if s.kind == "command")
    if field.set == 0xFF:
        return next(s.number for s in of.sets if s.kind == "data")
    return field.set


def all_fields(of: m.Model) -> list[m.Field]:
    return [*of.fields, of.protocol.acknowledge]


def decode_request(packet: bytes) -> dict[str, Any]:
    return {"op": "decode", "packet": packet.hex()}


def encode_request(number: int, field: m.Field, values: dict[str, Any]) -> dict[str, Any]:
    entry = {"descriptor": field.descriptor, "name": field.name_in(number), "values": values}
    return {"op": "encode", "set": number, "fields": [entry]}


def tree(folder: Path) -> dict[str, bytes]:
    """All files below a folder, except what Python leaves beside modules that a test has imported."""
    files = [p for p in sorted(folder.rglob("*")) if p.is_file() and p.parent.name != "__pycache__"]
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in files}


# --------------------------------------------------------------------------- the virtual device


@contextmanager
def simulated(*arguments: str, device: str = "3dm-cv7-gnss-ins") -> Iterator[str]:
    """Runs a virtual device as `mip simulate` does, in a thread: starting a process takes longer than most tests.
    Yields its address."""
    simulate = importlib.import_module("mip_simulator.command")
    parser = argparse.ArgumentParser()
    simulate.add_arguments(parser)
    options = parser.parse_args([device, *arguments])
    places: list[str] = []
    with contextlib.ExitStack() as stack:
        _, server = simulate.served(options, stack, places.append, lambda text: None)
        stack.enter_context(server)

        def serve() -> None:
            server.run()
            server.close()  # at the end of its duration, too

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        try:
            yield places[0]
        finally:
            server.stop()
            thread.join(PATIENCE)
