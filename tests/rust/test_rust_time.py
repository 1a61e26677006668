"""Times and validity in Rust, compared with the Python package on random packets and values; rejected fields."""

from __future__ import annotations

import json
import struct
import subprocess
from collections.abc import Iterable
from datetime import datetime, timedelta
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import random_values
from crates import WORK, passes, project, specification
from mipgen import model as m
from mipgen.emit.naming import pascal
from mipgen.lower import codec
from mipgen.targets.python import names as python
from mipgen.targets.rust import names
from mipgen.targets.rust.view import Crate, Record
from packages import mip, real
from random_values import chance
from support import PATIENCE, ROOT, heavy, rounds
from timed_packets import SECOND, cases_of_devices, leap_seconds, packet, random_packets

HERE = Path(__file__).parent
PACKAGES: dict[str, Any] = {"real": real, "invented": mip}
EPOCH = datetime(1970, 1, 1)
#: In place of validity: nothing, or the names of the bits of a status in its state.
NONE = "pub fn valid(_: &str, _: Option<&mip_protocol::devices::Profile>, _: &[u8]) -> Vec<String> { vec![] }\n"
NAMES = """use mip_protocol::{devices::Profile, filter_data::Status, Field};
pub fn valid(_: &str, _: Option<&Profile>, data: &[u8]) -> Vec<String> {
    let status = Status::decode(data).unwrap();
    let state = status.filter_state_as_gx5_filter_state();
    status.status_flags_as_gx5_status_flags().iter_names_in(state).map(|(name, _)| name.into()).collect()
}
"""


@cache
def program(spec: str, families: tuple[str, ...] = (), source: str = "") -> Path:
    """A program that needs no sets for times, and some for the names of rejected fields and commands."""
    name = f"times_{spec}{'_and_validity' * bool(families)}"
    families = families or ("base", "filter_data", "mip_3dm", "sensor") * (spec == "real")
    source = source or (NAMES if spec == "real" else NONE)
    features = ", ".join(f'"{f}"' for f in ("std", "devices", "registry", *families))
    files = {"times.rs": (HERE / "times.rs").read_bytes(), "valid.rs": source.encode()}
    binary = f'[[bin]]\nname = "{name}"\npath = "times.rs"\n'
    folder = project(spec, name, binary, features, files, default=False)
    passes(folder, "build", "--offline", "--quiet")
    return WORK / "target/debug" / name


def answers(path: Path, lines: Iterable[str]) -> list[str]:
    done = subprocess.run([path], input="\n".join(lines), capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def written(package: Any, times: dict[str, int | None]) -> str:
    """As the program writes the times: those of clocks with a date in UTC."""
    texts = []
    for clock, epoch in package._clocks.CLOCKS.items():
        time = times.get(clock)
        text = "none" if time is None else str(time)
        if time is not None and epoch:
            text = f"{EPOCH + timedelta(seconds=time // 10**9):%Y-%m-%dT%H:%M:%S}.{time % 10**9:09}Z"
        texts.append(f"{clock}={text}")
    return " ".join(texts)


# --------------------------------------------------------------------------- times


@pytest.mark.parametrize("spec", ["invented", "real"])
def test_times_are_those_of_python(spec: str) -> None:
    """For all clocks, kinds of timestamps, flags and devices."""
    of, package, luck = specification(spec), PACKAGES[spec], chance("times", spec)
    lines, wanted = [], []
    for device, data in random_packets(luck, of, rounds(2000, 100000)):
        times = package.timestamps.moments(package.packet.Packet(data), None if device == "-" else device)
        lines.append(f"time {device} {data.hex()}")
        wanted.append(written(package, times))
    assert {"none"} < {word.partition("=")[2] for line in wanted for word in line.split()}
    assert answers(program(spec), lines) == wanted, "times differ"


def test_times_of_devices() -> None:
    cases = cases_of_devices()
    lines = [f"time {device or '-'} {data.hex()}" for device, data, *_ in cases]
    names = [c.name for c in specification("real").protocol.clocks]
    wanted = [written(real, {"gps": date, "device": other}) for *_, date, other in cases]
    assert names[0] == "gps" and names[3] == "device"
    assert list(zip(lines, answers(program("real"), lines))) == list(zip(lines, wanted))


def test_times_of_a_log() -> None:
    """Five bits were seen before, so that the third alone does not mark the time as valid."""
    cases = [
        ("-", [(0.5, 0, 0), (5.0, 0, 0)], "gps=none", 5 * SECOND),
        ("-", [(1.0, 2300, 0x1D), (2.0, 2300, 5)], "gps=none", 2 * SECOND),
        ("3dm-gx5-25", [(1.0, 2300, 0x18), (2.0, 2300, 3)], "gps=none", 2 * SECOND),
        ("-", [(604799.99, 2300, 0x1F), (0.0, 2301, 0x1F)], "gps=2024-02-10T23:59:42.000000000Z", "none"),
    ]
    logs = [(device, [packet(0x80, (0x12, struct.pack(">dHH", *s))).hex() for s in log]) for device, log, *_ in cases]
    found = [line.split() for line in answers(program("real"), (f"time {d} {' '.join(log)}" for d, log in logs))]
    assert [(line[0], line[3]) for line in found] == [(date, f"device={other}") for *_, date, other in cases]


def test_gps_time_to_utc_across_every_leap_second() -> None:
    leaps = leap_seconds()
    assert answers(program("real"), (f"utc gps {time}" for time, _ in leaps)) == [str(utc) for _, utc in leaps]


def test_bits_are_named_by_the_state() -> None:
    """Bit 12 is about the bias of the magnetometer only while the solution is valid."""
    wanted = {1: "init_no_attitude", 2: "run_matrix_singularity run_mag_bias_est_high_warning", 0: ""}
    lines = [f"valid - status {state:04x}00011008" for state in wanted]
    assert answers(program("real"), lines) == list(wanted.values())


# --------------------------------------------------------------------------- rejected fields


def test_the_rejected_field() -> None:
    """By the cases that all languages share."""
    cases = json.loads((ROOT / "tests/rejected.json").read_text("utf-8"))
    lines, wanted = [], []
    for case in cases:
        parts = (case.get(key, "").replace(" ", "") for key in ("command", "data", "descriptors"))
        lines.append(" ".join(["rejected", case.get("device", "-"), *parts]))
        index, number, descriptor, reason, text = case["cause"] or [""] * 5
        wanted.append(f"{index} {number} {descriptor} {pascal(reason)} {text}" * bool(text))
    assert list(zip(lines, answers(program("real"), lines))) == list(zip(lines, wanted))


# --------------------------------------------------------------------------- validity


def flagged(crate: Crate) -> list[Record]:
    return [r for r in crate.records.values() if isinstance(r.of, m.Field) and any(r.validity)]


def source(records: list[Record]) -> str:
    """Calls the methods of each field, in the order of their names."""
    arms = []
    for r in records:
        same, by_device = r.validity
        alone = {x.name: "" for x in same} | {
            x.name: f"device.map_or(here, |d| value.{x.name}_on(d))" for x in by_device
        }
        texts = [f"{{ let here = value.{name}(); word(here, {on or 'here'}) }}" for name, on in sorted(alone.items())]
        arms.append(f'"{r.of.full_name}" => {{\n let value = {names.path(r.of, "")}::decode(data).unwrap();\n'
                    f" vec![{', '.join(texts)}]\n}}\n")  # fmt: skip
    return f"""use mip_protocol::{{devices::Profile, Field}};
fn word(alone: bool, device: bool) -> String {{ format!("{{}}{{}}", u8::from(alone), u8::from(device)) }}
#[allow(deprecated)]
pub fn valid(name: &str, device: Option<&Profile>, data: &[u8]) -> Vec<String> {{
match name {{\n{"".join(arms)}_ => panic!("{{name}}"),\n}}
}}
""".replace("crate::", "mip_protocol::")


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=heavy("Rust, all data sets"))])
def test_validity_is_that_of_python(spec: str) -> None:
    of, package, luck = specification(spec), PACKAGES[spec], chance("validity", spec)
    crate = of.derived(Crate)
    records = flagged(crate)
    families = tuple(sorted({names.module(str(r.of.owner)) for r in records}))
    lines, wanted = [], []
    for r in records * rounds(20, 500):
        assert isinstance(r.of, m.Field)
        device = luck.choice(["-", *(d.id for d in of.devices)])
        data = codec.encode(r.of, random_values.record(luck, r.of.parameters, 120))
        kind = getattr(getattr(package, python.home(r.of)), python.class_name(r.of))
        value = kind.decode(data)
        members = sorted((x.name, x.member.parameter.name) for part in r.validity for x in part)
        found = [
            "".join(str(int(value.is_valid(name, on))) for on in (None, None if device == "-" else device))
            for _, name in members
        ]
        lines.append(f"valid {device} {r.of.full_name} {data.hex()}")
        wanted.append(" ".join(found))
    assert {"00", "11"} < {word for line in wanted for word in line.split()}
    found = answers(program(spec, families, source(records)), lines)
    assert list(zip(lines, found, strict=True)) == list(zip(lines, wanted, strict=True))
