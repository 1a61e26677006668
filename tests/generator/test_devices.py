"""Devices: the evidence for what they have, what they inherit and send; a further device needs one file only."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest
from mip_protocol._index import MODELS
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import ROOT, SPECS, model, some

INVENTED, REAL = model("invented"), model("real")


def device(device_id: str, of: m.Model = INVENTED) -> m.Device:
    return some(of.device(device_id))


def names(d: m.Device) -> set[str]:
    return {s.name for s in d.supports}


# --------------------------------------------------------------------------- inheritance


def test_what_is_added_and_lacked() -> None:
    a, c = device("model-a"), device("model-c")
    assert names(a) - names(c) == {"tools.choice", "more.strings", "3d.default"}
    assert names(c) - names(a) == {"measurements.radio", "tools.hello", "tools.poll", "copy.accel"}
    assert {s.name: s.evidence.kind for s in c.supports if s.evidence.kind != "documented"} == {
        "tools.hello": "transcribed", "copy.accel": "transcribed", "tools.poll": "listed"
    }  # fmt: skip
    assert (
        {s.name for s in (*c.likely, *c.assumed)}
        == names(c) - {s.name for s in c.certain}
        == {"tools.hello", "copy.accel"}
    )
    order = [(s.set, s.field.descriptor) for s in c.supports]
    assert order == sorted(order)


def test_evidence() -> None:
    """Strongest first; what a device rejects is kept apart from what it has."""
    c = device("model-c")
    assert [(e.kind, e.answer) for e in c.evidence] == [
        ("documented", "yes"), ("listed", "yes"), ("transcribed", "likely"), ("refused", "no"), ("hardware", "no")
    ]  # fmt: skip
    listed, refused = c.evidence[1], c.evidence[3]
    assert (listed.firmware, listed.date, listed.undefined) == ("1.0.07", "2026-11-23", ((1, 0x6E), (1, 0x6F)))
    assert refused.firmware == "1.2" and c.refuses[0].evidence == refused
    assert "tools.choice" not in names(c) and INVENTED.refusing(c.refuses[0].field) == (c,)
    assert [s.name for s in c.refuses] == ["tools.choice", "measurements.gust", "copy.gust"]
    assert c.refuses[1].evidence.needs == "anemometer"
    assert c.absent == "no" and device("old-1").absent == "unknown"


def test_hardware() -> None:
    """A device has neither fields, values nor flags that need what it lacks; what comes from outside needs nothing."""
    only = {v.path: [x.name for x in v.variant.only] for v in device("model-c").variants if v.variant.only}
    assert only["tools.pin.drive"] == ["off", "pulse"]
    for name in ("3dm-cv7-ar", "3dm-gv7-ar", "3dm-cx7-ar"):
        ar, ahrs = device(name, REAL), device(name.replace("-ar", "-ahrs"), REAL)
        assert ar.hardware.sensors == ("accelerometer", "gyroscope", "pressure_sensor")
        assert names(ahrs) - names(ar) == {
            "3dm.mag_hard_iron_offset", "3dm.mag_soft_iron_matrix", "filter.magnetic_declination_source",
            "sensor.scaled_mag",
        }  # fmt: skip
        assert "aiding.magnetic_field" in names(ar)
        assert {s.evidence.needs for s in ar.refuses if s.name == "sensor.scaled_mag"} == {"magnetometer"}
        flags = next(v for v in ar.variants if v.path == "sensor.overrange_status.status").variant.only
        assert "pressure" in {x.name for x in flags} and "mag_x" not in {x.name for x in flags}


def test_complete_sets() -> None:
    """What a complete list of the manual lacks is not supported, whatever others of the family have."""
    old = device("old-1")
    assert [s.name for s in old.complete] == ["more"] and {s.evidence.kind for s in old.refuses} == {"unlisted"}
    assert {s.set for s in old.refuses} == {0x81} and device("old-2").refuses == ()
    for name in ("3dm-cx5-10", "3dm-cv5-10"):
        unlisted = {s.name for s in device(name, REAL).refuses if s.evidence.kind == "unlisted"}
        assert "base.get_extended_descriptors" in unlisted and all(x.startswith("base.") for x in unlisted)


def test_frames_belong_to_the_family() -> None:
    for name in ("3dm-gx5-45", "3dm-cx5-45"):
        frames = {v.path: v.variant.frame for v in device(name, REAL).variants if v.variant.frame}
        assert frames["filter.antenna_offset.offset"] == "sensor"


def test_what_a_family_states_holds_for_fields_that_a_device_may_have() -> None:
    """No source states that a 3DM-GX3-25 sends its GPS timestamp; if it does, the flags are those of its generation."""
    for name in ("3dm-gx3-25", "3dm-gq4-45", "3dm-mv5-ar"):
        d = device(name, REAL)
        assert "sensor.gps_timestamp" not in names(d)
        assert {"sensor.gps_timestamp.tow", "sensor.gps_timestamp.valid_flags"} <= {v.path for v in d.variants}
    flags = some(REAL.field("filter.mag_magnitude_error_adaptive_measurement")).parameters[0]
    without = [d.id for d in REAL.devices if d.hardware.lacking(("magnetometer",))]
    assert without and not {v.key for v in flags.variants} & {*without}


# --------------------------------------------------------------------------- one file


FURTHER = """\
device: 3dm-made-up
name: made_up
title: 3DM-MADE-UP
like: 3dm-gx5-15
sensors: [accelerometer, gyroscope, magnetometer]
description: A device that does not exist.
model_number: 6999
supports: {sensor: [scaled_mag]}
lacks: {sensor: [scaled_pressure], filter_data: [pressure_altitude, status], system: [comm_mode]}
base_rates: {filter_data: 1000}
"""


def test_a_further_device_is_one_file(tmp_path: Path) -> None:
    (tmp_path / "devices").mkdir()
    (tmp_path / "devices/made_up.yaml").write_text(FURTHER)
    of = load_model(SPECS["real"][0], tmp_path)
    made, like = device("3dm-made-up", of), device("3dm-gx5-15", of)
    assert names(made) - names(like) == {"sensor.scaled_mag"}
    assert names(like) - names(made) == {
        "sensor.scaled_pressure", "filter_data.pressure_altitude", "filter_data.status", "system.comm_mode"
    }  # fmt: skip
    assert {r.set.name: r.hertz for r in made.base_rates} == {"sensor": 1000, "filter_data": 1000}
    paths = {v.path for v in made.variants}
    assert paths == {v.path for v in like.variants if not v.path.startswith(("filter_data.status.", "system."))}
    assert made.manual is None and made.ack_codes == like.ack_codes


def test_an_overlay_extends_what_others_inherit(tmp_path: Path) -> None:
    (tmp_path / "devices").mkdir()
    (tmp_path / "devices/a.yaml").write_text("extend: model-a\nsupports: {tools: [hello]}\n")
    (tmp_path / "devices/c.yaml").write_text("extend: model-c\nsupports: {copy: [health]}\nalso: [See]\n")
    with pytest.raises(SpecError, match=r"'model-a' already has 'tools\.hello' \(documented\); remove it"):
        load_model(SPECS["invented"][0], tmp_path)
    (tmp_path / "devices/a.yaml").write_text("extend: model-a\nsupports: {copy: [arrays]}\nbase_rates: {copy: ~}\n")
    c = device("model-c", load_model(SPECS["invented"][0], tmp_path))
    assert {"copy.arrays", "copy.health"} <= names(c) and c.also[-1] == "See"


# --------------------------------------------------------------------------- what there is


def test_device_status() -> None:
    """The command of the manual of the 3DM-GX5-45, and answers of all families."""
    packet = bytes.fromhex("75650c050564186d01da83")
    ((descriptor, data),) = codec.split(REAL, packet)
    command = some(codec.choose(REAL.candidates(0x0C, descriptor), data))
    assert codec.decode(command, data) == ({"model_number": 6253, "status_selector": 1}, 0)
    found = {}
    for length in (13, 15, 17, 53, 62, 75, 79, 82, 88, 107):
        head = bytes.fromhex("186d01" if length < 20 else "186d02")
        layout = some(codec.choose(REAL.candidates(0x0C, 0x90), head.ljust(length - 2, b"\0")))
        assert layout.min_size == layout.max_size == length - 2
        found[length] = layout.name.removeprefix("device_status_").removesuffix("_response")
    assert found == {
        13: "basic_without_state", 15: "basic", 17: "basic_gx3", 53: "diagnostic", 62: "diagnostic_imu",
        75: "diagnostic_gx4",
        79: "diagnostic_gnss", 82: "diagnostic_gq4_45", 88: "diagnostic_rq1_45",
        107: "diagnostic_gx3",
    }  # fmt: skip


def test_ports_have_the_names_of_their_device() -> None:
    """Where a device states the meaning of the port in a command, these are its ports."""
    found = 0
    for d in REAL.devices:
        for v in d.variants:
            if not v.path.startswith("base.comm_speed") or not isinstance(v.variant.type, m.Enum):
                continue
            values = v.variant.only or v.variant.type.values
            named = {x.value: x.name for x in values if isinstance(x, m.EnumValue) and x.name != "all"}
            assert named == {p.id: p.name.lower().replace(" ", "_") for p in d.ports}, d.id
            found += 1
    assert found > 2, "the command and its response, of several devices"


def test_every_type_is_used() -> None:
    """By a parameter or a bit, or on a device; another form of a word, only in texts. The built-in test of the 3DM-GQ7
    had a type that no device used."""
    records = (REAL.protocol.acknowledge, *REAL.records)
    every = [q for r in records for p in r.parameters for q in (p, *p.alternatives)]
    used = {t.full_name for q in every for t in (q.element, *(v.type for v in q.variants)) if hasattr(t, "full_name")}
    bitfields = [t for t in REAL.all_types if isinstance(t, m.Bitfield)]
    used |= {b.enum.full_name for t in bitfields for b in t.bits if b.enum}
    named = {t.full_name for t in REAL.all_types if isinstance(t, (m.Enum, m.Bitfield))}
    assert named - used == {"rtk_status_flags_legacy"}


def test_devices_are_read_as_what_they_are() -> None:
    read = {d.id: {v.path: v.variant.type for v in d.variants} for d in REAL.devices}
    for path in ("system_data.built_in_test.result", "base.continuous_built_in_test_response.result"):
        assert some(read["3dm-gq7"][path]).name == "gq7_continuous_built_in_test"
    for inner in ("3dm-gx4-imu", "3dm-rq1-imu"):
        old = {path: t for path, t in read["3dm-gx4-25"].items() if path.startswith(("sensor.", "3dm.data_stream"))}
        assert old and old.items() <= read[inner].items()


def test_a_device_known_by_its_name_is_read_as_the_one_most_like_it() -> None:
    assert dict(REAL.read_as) == MODELS and MODELS[6255] == "3dm-cx5-10" and MODELS[6254] == "3dm-gx5-15"
    in_rust = 'Some({}) => Profile::by_id("{}")'
    for file, arm in (("javascript/session.mjs", '{}: "{}"'), ("rust/src/sets/session.rs", in_rust)):
        text = (ROOT / "generated" / file).read_text("utf-8")
        assert len(REAL.named) == 6 and all(arm.format(d.model_number, d.like) in text for d in REAL.named)


# --------------------------------------------------------------------------- answers


def said(name: str) -> list[str]:
    facts = describe.topics(describe.field(some(REAL.field(name)), REAL), "silent")
    return [describe.say(f.sentence, lambda r: f"<{r.words}>") for f in facts]


def test_echo_control() -> None:
    """The same setting silences all aiding measurements, and nothing else."""
    silent = {f.full_name for f in REAL.fields if f.silenced_by}
    settings = {"aiding.frame_config", "aiding.sensor_frame_map", "aiding.echo_control"}
    commands = {f.full_name for f in REAL.fields if f.family == "aiding" and f.role == m.COMMAND}
    assert silent == commands - settings and len(silent) == 10
    wanted = ["Not acknowledged if <mode> of <aiding.echo_control> is <suppress_ack>."]
    assert all(said(name) == wanted for name in silent)


def test_devices_that_send_a_response() -> None:
    """A device that supports no function with a response does not send the response."""
    names = {"write", "apply"}
    settings, response = some(INVENTED.field("tools.settings")), some(INVENTED.field("tools.settings_response"))
    functions = tuple(f for f in settings.functions if f.name in names)
    writes = m.Support(settings, settings.set, functions, m.Evidence("documented"))
    devices = tuple(
        dataclasses.replace(d, supports=tuple(writes if s.field is settings else s for s in d.supports))
        if d.id == "model-b"
        else d
        for d in INVENTED.devices
    )
    changed = dataclasses.replace(INVENTED, devices=devices)
    assert [d.id for d in INVENTED.devices_of(response)] == ["model-a", "model-b", "model-c"]
    assert [d.id for d in changed.devices_of(settings)] == ["model-a", "model-b", "model-c"]
    assert [d.id for d in changed.devices_of(response)] == ["model-a", "model-c"]
    assert [d.id for d in INVENTED.devices_of(some(INVENTED.field("tools.inventory_response")))] == [
        "model-a",
        "model-c",
    ]


def test_devices_that_send_a_layout() -> None:
    """Each device sends the layouts that name it, else those that name none."""
    status = some(REAL.field("3dm.device_status"))
    start, end = "device_status_", "_response"
    sent = {
        d.id: [r.name.removeprefix(start).removesuffix(end) for r in REAL.answers(status, d.id)]
        for d, _ in REAL.supports(status)
    }
    assert sent["3dm-gx5-15"] == sent["3dm-cv5-25"] == ["basic", "diagnostic"]
    assert sent["3dm-gq4-45"] == ["basic", "diagnostic_gq4_45"]
    assert sent["3dm-gx5-45"] == sent["3dm-gx4-45"] == ["basic", "diagnostic_gnss"]
    assert sent["3dm-gx4-15"] == ["basic_without_state", "diagnostic_gx4"]
    assert sent["3dm-cx5-10"] == ["basic_without_state", "diagnostic_imu"]
    gq4 = some(REAL.field("3dm.device_status_diagnostic_gq4_45_response"))
    sending = [[d.id for d in REAL.devices_of(gq4, answer)] for answer in m.SUPPORTED]
    assert sending == [["3dm-gq4-45"], [], []]
    names = {r.full_name for r in REAL.responses(status)}
    for d, _ in REAL.supports(status):  # the notes of the devices, which cite the source
        note = next((n.description for n in d.notes if n.name == "device_status"), "")
        told = {name for name in names if f"`{name}`" in note}
        assert not told or told == {r.full_name for r in REAL.answers(status, d.id)}, d.id


def test_layouts_that_name_a_device_are_no_longer_those_of_all() -> None:
    def bound(f: m.Field) -> m.Field:
        return dataclasses.replace(f, devices=("model-a",)) if f.name == "status_long" else f

    families = tuple(dataclasses.replace(x, fields=tuple(map(bound, x.fields))) for x in INVENTED.families)
    of = dataclasses.replace(INVENTED, families=families)
    assert [f.name for f in of.answers(some(of.field("tools.status")), "model-b")] == [
        "status_short", "status_long", "status_old", "status_full"
    ]  # fmt: skip
