"""A package made from a `mip.json` when the tools start: the same as the one that is generated."""

from __future__ import annotations

import dataclasses
import inspect
import json
import os
import random
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from mipgen import cli
from packages import Package, mip, real
from support import PYTHONPATH, ROOT, SPECS, rounds

GENERATED = {"invented": mip, "real": real}


def made(spec: str) -> Package:
    """The package that is made from the definitions of a specification."""
    name = f"{spec}_definitions"
    if name not in sys.modules:
        generated = GENERATED[spec]
        generated.mip_tools.definitions.load(SPECS[spec][1] / "json/mip.json", generated.top, name)
    found = object.__new__(Package)
    found.name, found.top = name, sys.modules[name]
    return found


def plain(x: Any) -> Any:
    """A value without the package that its classes are from."""
    if isinstance(x, type):
        return f"{x.__module__.partition('.')[2]}.{x.__qualname__}"
    if dataclasses.is_dataclass(x):
        return type(x).__name__, {f.name: plain(getattr(x, f.name)) for f in dataclasses.fields(x) if f.compare}
    if isinstance(x, dict):
        return {k: plain(v) for k, v in x.items()}
    if isinstance(x, (tuple, list)):
        return type(x).__name__, [plain(v) for v in x]
    return x.name if type(x).__name__ == "Support" else x.__name__ if inspect.isfunction(x) else x


ATTRIBUTES = """SET SETS DESCRIPTOR NAME ROLE RESPONSES REQUIRED TIMEOUT SILENCED_BY COMMANDS _LAYOUT _ALWAYS _VECTORS
    _MEMBERS __slots__ __match_args__""".split()  # noqa: SIM905


def signatures(kind: Any) -> dict[str, Any]:
    """The signatures of the constructor, and of that for each function."""
    ways = {"": kind, **{f: getattr(kind, f) for f in ("write", "read", "save", "load", "default") if hasattr(kind, f)}}
    return {
        name: [(p.name, p.kind, plain(p.default)) for p in inspect.signature(way).parameters.values()]
        for name, way in ways.items()
    }


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_every_class_is_that_of_the_generated_package(spec: str) -> None:
    ours, theirs = made(spec), GENERATED[spec]
    own, generated = ours.registry.all_types(), theirs.registry.all_types()
    assert plain(own) == plain(generated)
    for (_, a), (_, b) in zip(own, generated):
        assert {x: plain(getattr(a, x, None)) for x in ATTRIBUTES} == {
            x: plain(getattr(b, x, None)) for x in ATTRIBUTES
        }
        assert signatures(a) == signatures(b), b
        assert plain(ours.reflection.info(a)) == plain(theirs.reflection.info(b))
        assert ours.reflection.info(a).sources == theirs.reflection.info(b).sources
    for home in {*theirs._sets.MODULES.values(), "types", "protocol"}:
        rows = [
            {name: plain(info) for name, info in getattr(x, f"_meaning.{home}").TYPES.items()} for x in (ours, theirs)
        ]
        assert rows[0] == rows[1], home
        for name in rows[0]:
            members = [
                list(getattr(getattr(getattr(x, home), name), "__members__", {}).items()) for x in (ours, theirs)
            ]
            assert members[0] == members[1]


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_tables_and_devices_are_those_of_the_generated_package(spec: str) -> None:
    ours, theirs = made(spec), GENERATED[spec]
    for module in ("_index", "_clocks", "_sets"):
        for name, value in vars(getattr(theirs, module)).items():
            if name.isupper():
                assert plain(getattr(getattr(ours, module), name)) == plain(value), name
    assert plain(ours.devices.DEVICES) == plain(theirs.devices.DEVICES)
    file = SPECS[spec][1] / "python/mip_protocol/simulation.json"
    assert theirs.mip_tools.definitions.simulation(ours.name) == json.loads(file.read_text("utf-8"))
    sessions = [x._session.session() for x in (ours, theirs)]
    assert (sessions[0] is None) == (sessions[1] is None)
    if sessions[0]:
        for name in ("base_rate", "item", "resume"):
            assert plain(getattr(sessions[0], name)) == plain(getattr(sessions[1], name))
        assert [x.format.__self__.NAME for x in sessions] == ["3dm.message_format"] * 2
        assert sessions[0].older.keys() == sessions[1].older.keys()


@pytest.mark.parametrize(("spec", "examples"), [("real", 1), ("invented", 4)])
def test_random_data_have_the_same_values(spec: str, examples: int) -> None:
    ours, theirs, chance, decoded = made(spec), GENERATED[spec], random.Random(3), 0
    for (set, a), (_, b) in zip(ours.registry.all_types(), theirs.registry.all_types()):
        for _ in range(rounds(examples, 4)):
            data = chance.choice((chance.randbytes, bytes))(chance.choice((0, 1, 4, 12, 13, 24, 60, 200)))
            assert a.matches(data) == b.matches(data)
            results = []
            for package, kind in ((ours, a), (theirs, b)):
                try:
                    value = kind.decode(data)
                    said = repr(value), value.to_text(), value.encode(), getattr(value, "answered", None)
                    results.append((*said, plain(getattr(value, "expected", None))))
                    decoded += 1
                except package.errors.MipError as error:
                    results.append((type(error).__name__, str(error)))
            assert results[0] == results[1], (set, b, data)
    assert decoded > 100


# --------------------------------------------------------------------------- an overlay, in the tools


@pytest.fixture(scope="module")
def definitions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The `mip.json` of the specification with an overlay."""
    folder = tmp_path_factory.mktemp("overlay")
    words = ["--spec", str(SPECS["real"][0]), "--spec", str(ROOT / "tests/overlay"), "--target", "json"]
    assert cli.main(["generate", *words, "--out", str(folder)]) == 0
    return folder / "json/mip.json"


ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "MIP_PACKAGE"} | {"PYTHONPATH": PYTHONPATH}


def tool(*words: object, data: bytes = b"", **environment: str) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-m", "mip_tools", *map(str, words)], input=data, capture_output=True,
        env=ENVIRONMENT | environment,
    )  # fmt: skip
    return done.returncode, done.stdout.decode(), done.stderr.decode()


LIGHT = struct.pack(">4fB", 250.0, 0.5, 0.25, 0.125, 1)


def log(packets: int = 3) -> bytes:
    """Packets with a field of the overlay, and one of the specification."""
    builder = real.packet.PacketBuilder(0x80).add(0x7A, LIGHT).add(0x04, struct.pack(">3f", 1, 2, 3))
    return bytes(builder.build()) * packets


def test_an_own_field_in_dump_export_and_columns(definitions: Path, tmp_path: Path) -> None:
    code, out, error = tool("dump", "--definitions", definitions, "-", data=log(1))
    assert (code, error) == (0, "") and "illuminance=250.0 lx" in out and "lamp=on" in out
    file = tmp_path / "log.bin"
    file.write_bytes(log())
    words = ("export", file, "ambient_light", "scaled_accel", "-o", "-")
    code, out, error = tool(*words, MIP_PACKAGE=str(definitions))
    assert (code, error) == (0, ""), error
    heading, *rows = out.splitlines()
    assert "sensor.ambient_light.bend.x [rad]" in heading and len(rows) == 3 and "250.0,0.5,0.25,0.125" in rows[0]
    code = f"import mip_tools; mip_tools.use({str(definitions)!r}); log = mip_tools.read_log({str(file)!r})\n"
    code += "print(log['sensor.ambient_light']['illuminance'].tolist(), log['sensor.scaled_accel']['scaled_accel'][0])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=ENVIRONMENT)
    assert (done.stdout, done.stderr) == ("[250.0, 250.0, 250.0] [1. 2. 3.]\n", "")


def test_an_own_command_is_sent_to_a_virtual_device(definitions: Path) -> None:
    words = ["simulate", "3dm-cv7-gnss-ins", "--tcp", "0", "--definitions", definitions]
    with subprocess.Popen(
        [sys.executable, "-m", "mip_tools", *map(str, words)], stdout=subprocess.PIPE, env=ENVIRONMENT
    ) as process:
        assert process.stdout is not None
        place = process.stdout.readline().decode().strip()
        for words, said in (["write", "state=on"], ""), (["read"], "state = on"):
            code, out, error = tool("send", place, "payload.lamp", *words, "--definitions", definitions)
            assert (code, error) == (0, "") and said in out
        process.kill()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "No such file or directory"),
        ("{}", "is not a mip.json, which `mipgen generate --target json` writes"),
        ('{"format": "2.0"}', "has format 2.0, but these tools read 1"),
    ],
)
def test_files_that_are_no_definitions(text: str | None, said: str, tmp_path: Path) -> None:
    file = tmp_path / "mine.json"
    if text is not None:
        file.write_text(text, "utf-8")
    code, out, error = tool("fields", "--definitions", file)
    assert (code, out) == (1, "") and said in error and str(file) in error
    assert tool("fields", "--definitions", file, "--package", "x")[0] == 2


def test_a_name_cannot_be_a_program(tmp_path: Path) -> None:
    """Text from the file becomes part of functions only if it is a name."""
    text = (SPECS["invented"][1] / "json/mip.json").read_text("utf-8")
    evil = text.replace('"name":"temperature","type":', '"name":"x=print(1)","type":')
    document = json.loads(evil if evil != text else text)
    f = next(f for f in document["fields"] if f["parameters"])
    f["parameters"][0]["name"] = f["operations"][0]["member"] = "x=print(1)"
    file = tmp_path / "mip.json"
    file.write_text(json.dumps(document), "utf-8")
    code, out, error = tool("fields", f["name"], "--definitions", file)
    assert code == 1 and "'x=print(1)' is not a name" in error and "\n1\n" not in f"\n{out}"


def test_reserved_names_are_those_of_the_generator() -> None:
    document = real.mip_tools.definitions.document
    language = yaml.safe_load((ROOT / "templates/python/language.yaml").read_text("utf-8"))
    assert {*language["members"]} == document.MEMBERS
    assert ({*language["bits"]}, {*language["elements"]}) == (document.BITS, document.ELEMENTS)
