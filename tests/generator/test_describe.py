"""Facts are composed from the model once; here they are compared with what the invented specification says."""

from __future__ import annotations

import dataclasses

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


A, BOTH = "Supported by <Model A> and <Model C>.", "Supported by <Model A>, <Model B> and <Model C>."


@pytest.mark.parametrize(
    ("path", "facts"),
    [
        (
            "tools.ping",
            {
                "devices": "Supported by all devices; confirmed on <Model A>, <Model B>, <Model C> and <Old 1>.",
                "assumed": "Assumed on <Old 2>.",
            },
        ),
        (
            "tools.capture_bias",
            {
                "responses": "Response: <tools.bias_vector>.",
                "may_affect": "Probably affects <measurements.accel>.",
                "flags": "Status flags about it: <sensor> of <model_a_faults>.",
                "devices": A,
                "deprecation": "Deprecated on the <Model C>: use <tools.bias> instead.",
                "firmware": "Requires firmware 1.0 or later and before 1.1 on the <Model C>.",
            },
        ),
        (
            "tools.bias",
            {
                "functions": "Functions: <write>, <read>, <save>, <load> and <default>.",
                "responses": "Response: <tools.bias_vector>.",
                "affects": "Affects <measurements.accel> and <measurements.gust>.",
                "may_affect": "Probably affects <more (0x81)>.",
                "devices": A,
            },
        ),
        (
            "tools.status",
            {
                "advanced": "For advanced use.",
                "responses": "Response: <tools.status_paged>, <tools.status_short>, <tools.status_long>, "
                "<tools.status_old> or <tools.status_full>.",
                "timeout": "The device may take 2.5 s to reply.",
                "devices": BOTH,
            },
        ),
        (
            "tools.status_old",
            {
                "commands": "Response to <tools.status>.",
                "layout": "Distinguished from <tools.status_long> and <tools.status_full> by the size of its data.",
                "when": "Sent if <selector> is 2.",
                "devices": "Supported by <Model A>.",
            },
        ),
        ("tools.formats", {"silent": "Not acknowledged if <suppress_ack> is true.", "devices": A}),
        (
            "tools.set_time_slow_response",
            {"commands": "Response to <tools.set_time>.", "when": "Sent if <part> is <slow>.", "devices": A},
        ),
        ("tools.bias_vector", {"commands": "Response to <tools.bias> and <tools.capture_bias>.", "devices": A}),
        (
            "more.accel",
            {
                "sets": "Occurs in <measurements (0x80)>, <more (0x81)> and <copy (0x92)>.",
                "affected": "Settings that probably affect it: <tools.capture_bias>.",
                "flags": "Status flags about it: <sensor> of <model_a_faults>.",
                "devices": "Supported by <Model A>, <Model B> and <Model C>.",
                "refused": "Not supported by <Old 1>.",
                "firmware": "Requires firmware later than 1.0.07 on the <Model C>.",
            },
        ),
        (
            "tools.choice",
            {
                "functions": "Functions: <write> and <read>.",
                "responses": "Response: <tools.choice_response>.",
                "devices": "Supported by <Model A>.",
                "refused": "Not supported by <Model C>.",
            },
        ),
        (
            "measurements.gust",
            {
                "sets": "Occurs in <measurements (0x80)> and <copy (0x92)>.",
                "affected": "Settings that affect it: <tools.bias>.",
                "refused": "Not supported by <Model C>.",
                "devices": "Not listed in any device profile.",
                "needs": "Requires an anemometer.",
                "note": "`speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see <mode> and "
                "<shape>.",
            },
        ),
        ("measurements.gust:height", {"unit": "Unit: m.", "valid": "Valid if <valid_flags.ready> is set."}),
        ("measurements.gust:gap", {"constant": "Always 7."}),
        ("measurements.gust:valid_flags", {}),
        (
            "measurements.gust:speed",
            {
                "elements": "Elements: x, y, z.",
                "unit": "Unit: m.",
                "range": "Range: magnitude at most 40.",
                "valid": "Valid if <valid_flags.ready> is set.",
            },
        ),
        (
            "measurements.breeze:turn",
            {
                "elements": "Elements: w, x, y, z.",
                "unit": "Unit: 1.",
                "range": "Range: magnitude 0.5 to 1.5.",
                "default": "Default: 1, 0, 0, 0.",
            },
        ),
        (
            "tools.hello_response",
            {
                "also": "Also called `keep_alive_response` and `welcome`.",
                "commands": "Response to <tools.hello>.",
                "likely": "Likely on <Model C>.",
                "evidence": "Known only from the <Kit of names>.",
                "uncertain": "Uncertain: When it comes.",
            },
        ),
        (
            "tools.hello",
            {
                "also": "Also called `keep_alive`.",
                "responses": "Response: <tools.hello_response>.",
                "sent_by": "Sent by the device; the host replies.",
                "likely": "Likely on <Model C>.",
                "evidence": "Known only from the <Kit of names>.",
            },
        ),
        (
            "measurements.health",
            {
                "deprecated": "Deprecated: use <measurements.numbers> instead.",
                "sets": "Occurs in <measurements (0x80)> and <copy (0x92)>.",
                "devices": A,
            },
        ),
        (
            "measurements.radio:strength",
            {
                "range": "Range: less than 1.",
                "valid": "Valid if <connected> is true.",
                "uncertain": "Uncertain: Its unit.",
            },
        ),
        ("tools.formats:checkpoint", {"deprecated": "Deprecated."}),
        ("tools.settings:port", {"range": "Range: 0 to 8."}),
        (
            "tools.settings:mode",
            {
                "default": "Default: <fast>.",
                "required": "Required for <write>, <read> and <apply>.",
                "variant": "On the <Model C>: only <default> and <fast>; not deprecated.",
            },
        ),
        (
            "tools.settings:baud",
            {"unit": "Unit: Bd.", "default": "Default: 115200.", "required": "Required for <write> and <apply>."},
        ),
        ("tools.settings:limit", {"optional": "Optional.", "variant": "If <mode> is <slow>: unit m."}),
        ("tools.settings:reserved", {"reserved": "Reserved: send 1.", "optional": "Optional."}),
        ("tools.settings_response:reserved", {"reserved": "Reserved."}),
        ("tools.status:model", {"constant": "Always 4711."}),
        ("tools.choice:parameters", {"tag": "Selected by <shape>.", "required": "Required for <write>."}),
        ("tools.list:count", {"counts": "Counts the elements of <items>.", "required": "Required for <write>."}),
        (
            "measurements.accel:scaled_accel",
            {
                "at_rest": "At rest and level: x 0, z -1.",
                "positive": "Positive: along <point>.",
                "elements": "Elements: x, y, z.",
                "unit": "Unit: g.",
                "frame": "Frame: <sensor>.",
                "valid": "Each element has its own valid flag. x: <valid_flags.ready>, y: <valid_flags.hot>, "
                "z: <valid_flags.ready>.",
                "variant": "On the <Model C>: no flag marks it as valid.",
            },
        ),
        ("measurements.accel:valid_flags", {"variant": "On the <Model C>: only <ready> and <level>."}),
        (
            "tools.status:selector",
            {"range": "Range: 1 to 2.", "variant": "On the <Model C>: always 2 (inferred: it has one layout)."},
        ),
        ("tools.status_short:flags", {"variant": "On the <Model B>: values of <model_b_faults>."}),
        ("tools.status_long:flags", {"variant": "On the <Model C>: the values are unknown."}),
    ],
)
def test_facts(path: str, facts: dict[str, str]) -> None:
    assert of(path) == facts


@pytest.mark.parametrize(
    ("number", "why"),
    [
        (0, "Documented."),
        (1, "Listed by the device (firmware 1.0.07; 2026-11-23)."),
        (2, "Transcribed from the manual by others (Kit of names: Names). It names tools.hello."),
        (3, "Rejected by the device (firmware 1.2)."),
        (4, "Requires an anemometer, which the device lacks."),
    ],
)
def test_why_a_device_has_a_field(number: int, why: str) -> None:
    c, old = INVENTED.device("model-c"), INVENTED.device("old-2")
    assert c is not None and old is not None
    assert describe.why(c.evidence[number], INVENTED) == why
    assert plain(describe.evidence(old.evidence[0], INVENTED)) == (
        "Supported by devices of the same generation, <Model A> and <Model B>."
    )
    assert describe.summary(c) == "model-c: 24 certain, 2 likely, 3 not supported"
    assert describe.summary(old) == "old-2: 2 assumed; there may be more"


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


@pytest.mark.parametrize(
    ("device", "facts"),
    [
        (
            "model-a",
            [
                "Model number 4711.",
                "Sensors: accelerometer, anemometer.",
                "GNSS receivers: 1.",
                "GNSS antennas: 2.",
                "Manual: A guide to devices that do not exist, 1.",
            ],
        ),
        (
            "model-c",
            [
                "Also called Model See and c.",
                "Generation 3.",
                "Model number 4713.",
                "Same as the <Model A>, except as stated here.",
                "Sensors: accelerometer.",
                "GNSS receivers: none.",
                "GNSS antennas: 2.",
                "No manual is known.",
                "Uncertain: Whether it has a model number of its own.",
            ],
        ),
        (
            "old-1",
            [
                "Also called First.",
                "Generation 1.",
                "Model number 4001.",
                "Sets known completely from the manual: <more (0x81)>.",
                "No manual is known.",
                "This profile is incomplete: No manual is known; see <tools.ping>.",
            ],
        ),
    ],
)
def test_devices(device: str, facts: list[str]) -> None:
    d = some(INVENTED.device(device))
    assert [plain(x.sentence) for x in describe.device(d, INVENTED)] == facts


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


def test_variants_by_value_are_told_one_by_one() -> None:
    f = some(INVENTED.field("tools.pin"))
    said = [plain(x.sentence) for x in describe.parameter(f.parameters[2], f, INVENTED) if x.topic == "variant"]
    assert said == ["If <drive> is <pulse>: values of <pulse_use>.", "If <drive> is <serial>: values of <serial_use>."]


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


@pytest.mark.parametrize(
    ("manual", "counts"),
    [
        ("guide", "count every byte"),
        ("leaflet", "count only numbers and arrays of numbers; 3 omit vectors, structures or unions"),
        ("sheet", "not given"),
    ],
)
def test_how_a_manual_counts_lengths(manual: str, counts: str) -> None:
    found = next(x for x in INVENTED.protocol.manuals if x.id == manual)
    assert plain(describe.length_facts(found, INVENTED)) == counts


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
