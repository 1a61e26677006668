"""What the compiler makes of mip.ksy in Python, against the reference, and that it compiles in other languages."""

from __future__ import annotations

import importlib.util
import json
import os
import random
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from conformance.test_conformance import mutated, samples
from difficult_sets import COMMANDS
from kaitaistruct import BytesIO, KaitaiStream
from ksy_driver import COMPILED, built, compiled, file, ksy
from mipgen import cli
from mipgen import model as m
from mipgen.lower import codec
from mipgen.resolve.load import load_model
from mipgen.targets import kaitai
from mipgen.targets.kaitai.names import camel_case, member, type_name
from spec_defaults import filled
from support import (
    ROOT,
    SPECS,
    decode_request,
    differences,
    expected,
    expected_parse,
    heavy,
    model,
    nightly,
)

pytestmark = heavy(kaitai.TARGET.needs)

HERE = Path(__file__).parent

specs = pytest.mark.parametrize("spec", sorted(SPECS))
languages = pytest.mark.parametrize("language", COMPILED)


def test_awkward_names_and_layouts(tmp_path: Path) -> None:
    """Keywords of many languages as names, interleaved counters, unions in structures in unions."""
    spec, out = tmp_path / "spec", tmp_path / "out"
    shutil.copytree(SPECS["invented"][0], spec)
    (spec / "sets/awkward.yaml").write_text(filled(COMMANDS), "utf-8")
    assert cli.main(["generate", "--spec", str(spec), "--out", str(out), "--target", "kaitai"]) == 0
    of, chance = load_model(spec), random.Random(6)
    fields = [f for f in of.fields if f.family == "macros_and_more"]
    assert fields
    requests = []
    for f in fields:
        for data in (d for _ in range(40) for d in samples(f, chance)):
            cuts = [data[:n] for n in range(min(len(data), 12))] + [mutated(chance, data, f) for _ in range(6)]
            requests += [decode_request(codec.build(of, f.set, [(f.descriptor, d)])) for d in (data, *cuts)]
    answers = built(out / "kaitai", "awkward").ask(requests)
    wrong = differences(requests, [expected(of, r) for r in requests], answers)
    assert not wrong, wrong


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=nightly("all languages of Kaitai"))])
def test_every_language_of_the_compiler(spec: str, tmp_path: Path) -> None:
    """All but one accept the file; the README names it."""
    modules = compiled(file(spec).parent, spec, "python").parent / "modules"
    refused = []
    for language in ("cpp_stl", "csharp", "go", "java", "lua", "nim", "perl", "php", "ruby", "rust"):
        done = subprocess.run(
            ["node", str(ROOT / "tests/kaitai/compile.cjs"), str(file(spec)), language, str(tmp_path / language)],
            capture_output=True, text=True, env={**os.environ, "KAITAI_MODULES": str(modules)},
        )  # fmt: skip
        if done.returncode:
            refused.append(language)
    assert refused == ["nim"]
    assert "checks of counts in Nim" in " ".join((file(spec).parent / "README.md").read_text("utf-8").split())


@specs
def test_all_readers_of_yaml_agree(spec: str) -> None:
    """YAML 1.2, as the compiler in Node reads it, and 1.1, as PyYAML and the compiler in Java do."""
    text = (compiled(file(spec).parent, spec, "python") / "mip.json").read_text("utf-8")
    assert json.loads(text) == json.loads(json.dumps(ksy(file(spec))))


# --------------------------------------------------------------------------- streams and bits, in Python


@cache
def compiled_python(spec: str) -> Any:
    path = compiled(file(spec).parent, spec, "python") / "mip.py"
    found = importlib.util.spec_from_file_location(f"mip_{spec}", path)
    assert found is not None and found.loader is not None
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module.Mip


NOISE = [b"", b"$GPGGA,123519*47\r\n", b"\x75", b"ue\x00\x01", b"noise", b"\xff" * 9]


@specs
def test_streams(spec: str) -> None:
    """Every intact packet is found, whatever is between them and wherever the end is cut off."""
    packets = sorted({e.packet for e in model(spec).examples})
    between = [NOISE[i % len(NOISE)] for i in range(len(packets))]
    stream = b"".join(n + p for n, p in zip(between, packets, strict=True)) + packets[0][:-1]
    wanted = expected_parse(stream)["packets"]
    assert wanted == [p.hex() for p in packets]
    parts = compiled_python(spec).from_bytes(stream).parts
    assert [p.packet.length + 6 for p in parts if p.is_packet] == [len(p) for p in packets]
    assert [p.packet.checksum for p in parts if p.is_packet] == [int.from_bytes(p[-2:], "big") for p in packets]
    skipped = b"".join(bytes([p.skipped.first]) + p.skipped.rest for p in parts if not p.is_packet)
    assert skipped == b"".join(between) + packets[0][:-1]
    for end in range(len(packets[0])):
        assert not any(p.is_packet for p in compiled_python(spec).from_bytes(packets[0][:end]).parts)


@specs
def test_what_looks_like_a_packet_hides_what_follows(spec: str) -> None:
    """Checksums are not verified, as the README says."""
    packet = model(spec).examples[0].packet
    parts = compiled_python(spec).from_bytes(b"ue\x80" + bytes([len(packet) - 1]) + packet + b"..").parts
    assert parts[0].is_packet and not any(p.is_packet for p in parts[1:])


@specs
def test_every_bit_is_in_its_place(spec: str) -> None:
    mip = compiled_python(spec)
    asked = 0
    for t in (t for t in model(spec).all_types if isinstance(t, m.Bitfield)):
        kind = camel_case(type_name(t))
        cls = getattr(mip, kind[0].upper() + kind[1:])
        for b in t.bits:
            for number in {1 << b.first, 1 << b.last, b.mask, ((1 << 8 * t.size) - 1) ^ b.mask}:
                data = number.to_bytes(t.size, "big" if t.scalar else "little")
                got = getattr(cls(KaitaiStream(BytesIO(data))), member(b.name))
                assert int(got) == (number & b.mask) >> b.first, (t.name, b.name, number)
                assert t.scalar is None or cls(KaitaiStream(BytesIO(data))).number == number, (t.name, number)
                asked += 1
    assert asked


# --------------------------------------------------------------------------- the programs of the README


def program(spec: str, language: str) -> str:
    text = (file(spec).parent / "README.md").read_text("utf-8")
    found = re.search(rf"```{language}\n(.*?)```", text, re.S)
    assert found is not None
    return found[1]


@languages
@specs
def test_the_programs_of_the_readme(language: str, spec: str, tmp_path: Path) -> None:
    of = model(spec)
    folder = compiled(file(spec).parent, spec, language)
    (tmp_path / "log.bin").write_bytes(b"noise" + b"".join(e.packet for e in of.examples))
    fields = [f for e in of.examples for f in e.fields]
    shutil.copytree(folder, tmp_path, dirs_exist_ok=True)
    script = tmp_path / ("program.py" if language == "python" else "program.cjs")
    script.write_text(program(spec, language), "utf-8")
    if language == "javascript":
        (tmp_path / "node_modules").symlink_to(folder.parent / "modules/node_modules")
    done = subprocess.run(
        [sys.executable if language == "python" else "node", str(script)], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    names = {f.field for f in fields if f.field}
    shown = re.sub(r"[^a-z0-9]", "", done.stdout.lower())
    assert names and [n for n in names if re.sub(r"[^a-z0-9]", "", n.removeprefix("protocol.")) not in shown] == []
