"""`make check` sees what breaks the interface of a release, in each binding and on the wire."""

from __future__ import annotations

import importlib.util
import shutil
from pathlib import Path
from types import ModuleType

import pytest
from support import ROOT


@pytest.fixture(scope="module")
def interface() -> ModuleType:
    spec = importlib.util.spec_from_file_location("interface", ROOT / "tools/release/interface.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


#: File, old text, new text, and the message.
BREAKS = [
    ("json/mip.json", '"name":"scaled_accel","type":"vector3f"', '"name":"scaled_accel","type":"vector3d"',
     'wire: - sensor.scaled_accel[0] scaled_accel type="vector3f"'),
    ("c/src/mip/sensor.h", "float scaled_accel[3];", "double scaled_accel[3];",
     "c: - struct mip_sensor_scaled_accel: float scaled_accel[3]"),
    ("c/src/mip/constants.h", "#define MIP_MAX_PAYLOAD 255", "#define MIP_MAX_PAYLOAD 254",
     "c: - #define MIP_MAX_PAYLOAD 255"),
    ("c/src/mip/cpp/core.hpp", "namespace mip {", "namespace mip {\nvoid more(int);\n",
     "cpp: + namespace mip: void more(int)"),
    ("rust/src/sets/sensor.rs", "pub scaled_accel:", "pub accel:",
     "rust: - sets/sensor record!: pub struct ScaledAccel: pub scaled_accel: types::Vector3f"),
    ("rust/src/parser.rs", "pub fn flush", "fn flush", "rust: - parser impl Parser"),
    ("rust/src/sets/session.rs", "fn stream_only(", "fn stream_all(",
     "rust: - sets/session impl functions: pub $($async)* fn stream_only("),
    ("python/mip_protocol/sensor.py", "    scaled_accel: types.Vector3f", "    scaled_accel: types.Vector3d",
     "python: - mip_protocol.sensor.ScaledAccel.scaled_accel: types.Vector3f"),
    ("javascript/sensor.d.mts", "    scaledAccel: types.Vector3f;", "    scaledAccel?: types.Vector3f;",
     "javascript: - sensor export declare class ScaledAccel extends Data: scaledAccel: types.Vector3f"),
    ("json/mip.json", '"family":"base"', '"family":"basis"', "wire: - set base 0x01 base"),
    ("json/mip.json", '{"function":"load",', '{"function":"apply",', "wire: - base.comm_speed has the function load"),
    ("json/mip.json", '"when":[{"parameter":"field_id","value":1', '"when":[{"parameter":"field_id","value":3',
     "wire: - response base.gps_time_update_week_number_response (0x01, 0x84) when=["),
    ("json/mip.json", '"key":"3dm-cv7-ahrs","type":"comm_interface"', '"key":"3dm-cv7-ahrs","type":"u8"',
     'wire: - base.comm_speed[1] port type="comm_interface" if device is 3dm-cv7-ahrs'),
    ("json/mip.json", '"enum":"filter_data.filter_condition"', '"enum":"filter_data.filter_state"',
     "wire: - filter_data.cv7_status_flags.filter_condition = 0..1 enum="),
    ("json/mip.json", '"when":{"parameter":"filter_state"', '"when":{"parameter":"dynamics_mode"',
     "wire: - filter_data.gx5_status_flags."),
    ("json/mip.json", '"id":"3dm-gq7","name"', '"id":"3dm-gq8","name"', "wire: - device 3dm-gq7 6284"),
    ("json/mip.json", '{"field":"system.comm_mode","evidence"', '{"field":"base.ping","evidence"',
     "wire: - 3dm-cv5-15 has the set system"),
]  # fmt: skip


@pytest.fixture(scope="module")
def lines(interface: ModuleType) -> dict[str, list[str]]:
    found: dict[str, list[str]] = interface.interfaces(ROOT / "generated")
    return found


def test_what_breaks_is_named(
    interface: ModuleType,
    lines: dict[str, list[str]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out, kept = tmp_path / "generated", tmp_path / "interface"
    for part in ("c/src", "c/ports", "javascript", "json", "python/mip_protocol", "rust/src"):
        shutil.copytree(ROOT / "generated" / part, out / part)
    assert interface.check(out, kept, "0.1.0") == 0, "nothing is released"
    with monkeypatch.context() as patch:
        patch.setattr(interface, "interfaces", lambda _: lines)
        interface.write(out, kept / "0.1.0")
        assert interface.check(out, kept, "0.1.0") == 0
        assert interface.check(out, kept, "0.0.9") == 1, "lower than a release"
    assert "version 0.0.9 is lower than one in interface/" in capsys.readouterr().err
    shutil.copytree(kept / "0.1.0", kept / "0.0.9")
    for path in kept.glob("0.0.9/*"):
        path.write_text("of an earlier release\n", "utf-8")
    assert not capsys.readouterr().out
    for file, old, new, _ in BREAKS:
        text = (out / file).read_text("utf-8")
        assert old in text, (file, old)
        (out / file).write_text(text.replace(old, new, 1), "utf-8")
    assert interface.check(out, kept, "0.1.1") == 1
    said = capsys.readouterr()
    for *_, line in BREAKS:
        assert f"\n{line}" in f"\n{said.out}", line
    assert "version 0.1.1 is too low for that, raise it in spec/protocol.yaml" in said.err
    assert "cpp" not in said.err, "an addition is minor, which is the last number before 1.0.0"
    shutil.rmtree(kept / "0.0.9")
    assert interface.check(out, kept, "0.1.0") == 1
    assert "cpp: since 0.1.0" in capsys.readouterr().err, "a version that is released does not change"


def test_each_binding_has_each_sample(interface: ModuleType, lines: dict[str, list[str]]) -> None:
    """The rest of what is generated follows from these and the wire; not every binding has profiles of devices."""
    for name, own in lines.items():
        text = "\n".join(own).lower().replace("_", "")
        missing = [sample for sample in interface.SAMPLES if sample.replace("_", "") not in text]
        assert not set(missing) - {"gx5_15"}, (name, missing)


@pytest.mark.parametrize(
    ("line", "lasting"),
    [
        ("known pub static ALL: &[&Profile] = &[ &CV5_10, &CV5_15, ]", "known pub static ALL: &[&Profile]"),
        ("session pub const BAUD_RATES: &[u32] = &[ 115200 ]", "session pub const BAUD_RATES: &[u32]"),
        ('protocol pub const VERSION: &str = "0.1.0"', "protocol pub const VERSION: &str"),
        ("#define MIP_VERSION_NUMBER 100", "#define MIP_VERSION_NUMBER"),
        ("packet pub const MAX_PAYLOAD: usize = 255", "packet pub const MAX_PAYLOAD: usize = 255"),
    ],
)
def test_a_version_or_a_device_more_breaks_nothing(interface: ModuleType, line: str, lasting: str) -> None:
    assert interface.lasting(line) == lasting


@pytest.mark.parametrize(
    ("old", "new", "step"),
    [("0.1.0", "0.1.0", 0), ("0.1.0", "0.1.1", 1), ("0.1.9", "0.2.0", 2), ("0.1.0", "1.0.0", 2),
     ("1.0.0", "1.0.1", 0), ("1.0.0", "1.1.0", 1), ("1.2.0", "2.0.0", 2)],
)  # fmt: skip
def test_steps_of_versions(interface: ModuleType, old: str, new: str, step: int) -> None:
    assert interface.raised(old, new) == step
