"""Facts are composed from the model once. Here are the rules of their sentences; the snapshot of the invented
specification's output (test_targets.py) has all of them."""

from __future__ import annotations

import dataclasses
import re

import pytest
from mipgen import model as m
from mipgen.facts import describe, descriptors
from support import model, some

INVENTED, REAL = model("invented"), model("real")


def plain(text: describe.Text) -> str:
    return describe.say(text, lambda ref: f"<{ref.words}>")


def of(path: str, own: m.Model = INVENTED) -> dict[str, str]:
    """Topic -> sentence of a field, or of a parameter "set.field:parameter"."""
    name, _, parameter = path.partition(":")
    f = some(own.field(name))
    if not parameter:
        return {x.topic: plain(x.sentence) for x in describe.field(f, own)}
    p = next(p for p in f.parameters if p.name == parameter)
    return {x.topic: plain(x.sentence) for x in describe.parameter(p, f, own)}


@pytest.mark.parametrize(
    ("path", "topic", "sentence"),
    [
        ("more.accel", "sets", "Occurs in <measurements (0x80)>, <more (0x81)> and <copy (0x92)>."),
        ("tools.bias", "functions", "Functions: <write>, <read>, <save>, <load> and <default>."),
        ("tools.bias_vector", "commands", "Response to <tools.bias> and <tools.capture_bias>."),
        (
            "tools.status_old",
            "layout",
            "The size of its data distinguishes it from <tools.status_long> and <tools.status_full>.",
        ),
        ("tools.set_time_slow_response", "when", "Sent if <part> is <slow>."),
        ("3d.default", "silent", "Not acknowledged if <mode> of <tools.settings> is <fast>."),
        ("tools.bias", "may_affect", "Probably affects <more (0x81)>."),
        ("more.accel", "affected", "Settings that probably affect it: <tools.capture_bias>."),
        (
            "tools.ping",
            "devices",
            "Supported by all devices; confirmed on <Model A>, <Model B>, <Model C> and <Old 1>.",
        ),
        ("tools.choice", "refused", "Not supported by <Model C>."),
        ("tools.capture_bias", "firmware", "Requires firmware 1.0 or later and before 1.1 on the <Model C>."),
        ("measurements.gust:speed", "range", "Range: magnitude at most 40."),
        ("measurements.accel:scaled_accel", "at_rest", "At rest and level: x 0, z -1."),
        (
            "measurements.accel:scaled_accel",
            "valid",
            "Each element has its own valid flag. x: <valid_flags.ready>, y: <valid_flags.hot>, "
            "z: <valid_flags.ready>.",
        ),
        ("tools.settings:baud", "required", "Required for <write> and <apply>."),
        ("tools.settings:limit", "variant", "If <mode> is <slow>: unit m."),
        ("tools.status:selector", "variant", "On the <Model C>: always 2 (inferred: it has one layout)."),
    ],
)
def test_facts(path: str, topic: str, sentence: str) -> None:
    assert of(path)[topic] == sentence


def test_a_summary_of_a_device() -> None:
    assert describe.summary(some(INVENTED.device("model-c"))) == "model-c: 24 certain, 2 likely, 3 not supported"
    assert describe.summary(some(INVENTED.device("old-2"))) == "old-2: 2 assumed; there may be more"


def variants(path: str, own: m.Model = INVENTED) -> list[str]:
    name, _, parameter = path.partition(":")
    f = some(own.field(name))
    p = next(p for p in f.parameters if p.name == parameter)
    return [plain(x.sentence) for x in describe.parameter(p, f, own) if x.topic == "variant"]


def test_what_is_the_same_on_devices_is_told_once() -> None:
    assert variants("tools.status_short:flags") == [
        "On the <Model A> and <Model C>: values of <model_a_faults>.",
        "On the <Model B>: values of <model_b_faults>.",
    ]
    assert variants("measurements.accel:scaled_accel")[0] == (
        "On the <Model B>: unit m, m, s; frame <ned>; valid flags x: <valid_flags.hot>, "
        "y: <valid_flags.ready>, z: <valid_flags.hot>. Turned by the device."
    )
    assert variants("measurements.radio:noise") == ["On the <Model C>: valid if <connected> is true; deprecated."]


def test_valid_by_device_is_a_bit_of_its_own_type() -> None:
    *inferred, stated = variants("sensor.gps_timestamp:tow", REAL)
    assert stated == "On the <3DM-GX5-15> and <3DM-GX5-35>: valid if <valid_flags.time_initialized> is set."
    assert all("<valid_flags.time_initialized> is set (inferred: the 3DM-GX5-15 has it)" in text for text in inferred)


def test_elements_of_a_vector_in_another_frame() -> None:
    assert of("gnss_1.ned_velocity:velocity", REAL)["elements"] == "Elements: north, east, down."
    assert variants("filter.initialization_config:initial_position", REAL) == [
        "If <reference_frame_selector> is <ecef>: unit m; frame <ecef>.",
        "If <reference_frame_selector> is <llh>: elements latitude, longitude, height; unit deg, deg, m; frame <llh>.",
    ]


def test_variants_of_a_member() -> None:
    f = some(INVENTED.field("tools.readings_response"))
    *_, readings, last = f.parameters
    assert [plain(x.sentence) for x in describe.parameter(readings, f, INVENTED) if x.topic == "variant"] == [
        "If <drive> is <pulse>: <kind> has values of <pulse_use>. Seldom 2.",
        "If <drive> is <serial>: <kind> has values of <serial_use>.",
    ]
    assert [plain(x.sentence) for x in describe.parameter(last, f, INVENTED)] == [
        "If <drive> is <pulse>: <value> has unit s; range 0 to 1.",
        "If <drive> is <serial>: <value>: Nothing.",
    ]
    assert readings.readings == last.readings == ()


def test_a_field_that_a_manual_describes_too_is_not_known_from_a_kit_only() -> None:
    f = some(INVENTED.field("measurements.radio"))
    cited = dataclasses.replace(f, sources=(*f.sources, m.Source("guide", "Radio")))
    uncited = dataclasses.replace(f, sources=())
    said = [[x for x in describe.field(g, INVENTED) if x.topic == "evidence"] for g in (f, cited, uncited)]
    assert [len(x) for x in said] == [1, 0, 0]


def test_without_devices_nothing_is_said_of_them() -> None:
    f = some(INVENTED.field("measurements.gust"))
    assert "devices" not in {x.topic for x in describe.field(f, dataclasses.replace(INVENTED, devices=()))}


def test_prose_refers_to_fields_and_types() -> None:
    found = describe.prose("See `tools.ping`, `tools.shape`, `mode`, `a.b`, `x` and `vector3f`; not mode.", INVENTED)
    assert plain(found) == "See <tools.ping>, <shape>, <mode>, `a.b`, `x` and `vector3f`; not mode."
    assert plain(describe.prose("tools.ping (0x01,0x02)", INVENTED)) == "tools.ping (0x01,0x02)"


def test_a_quotation_refers_to_descriptors() -> None:
    found = describe.quotation("See `tools.ping`, (0x01,0x02), (0x01, 0x03) and (0x01,0x7F).", INVENTED)
    assert plain(found) == "See `tools.ping`, <(0x01,0x02)>, <(0x01, 0x03)> and (0x01,0x7F)."


def test_what_is_usual_where_a_variant_differs() -> None:
    """For the other side of a migration: the facts without those about one device."""

    def said(field: str, parameter: str, key: str) -> str:
        f = some(INVENTED.field(field))
        p = next(p for p in f.parameters if p.name == parameter)
        v = next(v for v in p.variants if v.key == key)
        return plain(describe.usual_text(v, p, f, INVENTED))

    assert said("tools.settings", "mode", "model-c") == "values of <mode>; deprecated"
    assert said("tools.status", "selector", "model-c") == "any value"
    assert said("tools.settings", "limit", "fast") == "unit unknown; range unknown; default unknown"
    assert said("measurements.radio", "noise", "model-c") == "valid if <connected> is true; not deprecated"
    assert said("tools.status_long", "flags", "model-c") == "any number"


@pytest.mark.parametrize("own", [INVENTED, REAL], ids=["invented", "real"])
def test_a_value_is_part_of_its_sentence(own: m.Model) -> None:
    for f in (own.protocol.acknowledge, *own.fields):
        for fact in [*describe.field(f, own), *(x for p in f.parameters for x in describe.parameter(p, f, own))]:
            assert plain(fact.value) in plain(fact.sentence)
            assert plain(fact.sentence)[-1] == "." or fact.topic == "note", fact


def test_numbers_with_units() -> None:
    real = model("real")
    units = (("3", "m"), ("2412", "week"), ("253", "byte"), ("1", "byte"), ("0, 1", "byte"), ("2", "1"), ("7", None))
    said = [describe.measured(number, unit, real) for number, unit in units]
    assert said == ["3 m", "week 2412", "253 bytes", "1 byte", "0, 1 bytes", "2", "7"]


def test_comments_in_code_leave_out_what_is_longer_than_all_else() -> None:
    def left_out(name: str) -> tuple[list[str], list[str]]:
        f = some(INVENTED.field(name))
        whole, code = ([plain(x.sentence) for x in of(f, INVENTED)] for of in (describe.field, describe.in_code))
        return [x for x in whole if x not in code], [x for x in code if x not in whole]

    assert left_out("tools.capture_bias") == (["Status flags about it: <sensor> of <model_a_faults>."], [])
    assert left_out("tools.ping") == (["Assumed on <Old 2>."], [])
    only = next(f for f in INVENTED.fields if INVENTED.devices_of(f, "likely") and not INVENTED.devices_of(f))
    assert left_out(only.full_name)[1] == ["No device is known for certain to support it."]


def test_only_descriptors_name_fields() -> None:
    real = model("real")
    item = real.type("descriptor_rate")
    assert isinstance(item, m.Struct)
    descriptor, decimation = item.parameters
    field = descriptors.named_by_value(descriptor, 0x04, 0x80, real)
    assert isinstance(field, m.Field) and field.full_name == "sensor.scaled_accel"
    assert descriptors.named_by_value(descriptor, 0x04, None, real) is None
    assert descriptors.named_by_value(decimation, 0x04, 0x80, real) is None


def test_rotations_describe_the_sense_of_their_formulas() -> None:
    """Notes with formulas are far from the parameter, and not in every form."""

    def sense(p: m.Parameter) -> tuple[str, ...]:
        found = re.match(r"Rotates vectors of the (\w+) frame into the (\w+) frame; ", p.description)
        return tuple(name.lower() for name in some(found).groups())

    senses = {}
    for f in (f for f in REAL.fields if f.role != m.RESPONSE):
        for p in (p for p in f.parameters if p.name in ("q", "m", "dcm")):
            for to, inverse, of in re.findall(rf"`[vp]_(\w+) = {p.name}(\^-1)? \* [vp]_(\w+)", " ".join(f.notes)):
                senses[f.full_name] = sense(p)
                assert senses[f.full_name] == ((to, of) if inverse else (of, to))
    assert len(senses) == 6
    for form in ("dcm", "quaternion"):
        (*_, other) = some(REAL.field(f"filter.sensor_to_vehicle_rotation_{form}")).parameters
        assert sense(other) == senses[f"3dm.sensor_to_vehicle_transform_{form}"][::-1]
