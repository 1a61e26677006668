"""A part of a specification has what was selected and what that needs, and nothing else."""

from __future__ import annotations

import dataclasses
import random

import pytest
from mipgen import model as m
from mipgen.base.errors import Failure
from mipgen.emit import render
from mipgen.lower.session import session
from mipgen.resolve.subset import Selection, left_out, select
from support import SEED, model, rounds, some

REAL, INVENTED = model("real"), model("invented")


def names(part: m.Model) -> set[str]:
    return {f.full_name for f in part.fields}


def whole(part: m.Model) -> None:
    """Everything that a part refers to is in it."""
    types = {(getattr(t, "owner", None), t.name) for t in part.all_types}
    for f in (part.protocol.acknowledge, *part.fields):
        part.responses(f), part.commands(f), part.supports(f)
        assert all(part.set(o.set) for o in f.occurrences if not f.everywhere), f.full_name
        assert all(part.field(c.command) for c in f.silenced_by if c.command), f.full_name
        for p in f.parameters:
            for t in (p.element, *(v.type for v in p.variants)):
                if isinstance(t, (m.Enum, m.Bitfield, m.Struct)) and t != part.protocol.function_selector:
                    assert (t.owner, t.name) in types, (f.full_name, t.name)
            assert all(part.device(v.key) for v in p.variants if v.by_device)
    for d in part.devices:
        assert all(part.field(s.field.full_name) is s.field for s in d.supports)
        assert all(part.set(r.set.number) is r.set for r in d.base_rates)
    for e in part.examples:
        assert all(x.field is None or part.field(x.field) for x in e.fields)
    for b in part.simulation.behaviors:
        assert part.field(b.command.full_name) is b.command
        layouts = {r.name: r.devices for r in part.responses(b.command)}
        assert all(layouts[name] == devices for name, devices in b.answers), b.command.full_name
    assert all(part.field(s.field.full_name) is s.field for s in part.simulation.sources)
    for g in part.guides:
        assert g.sequences or g.migration or g.questions
        assert all(part.field(name) or any(name == other.name for other in part.guides) for name in g.see)
        for s in g.sequences:
            assert s.devices and all(part.device(d.id) is d for d in s.devices)
            used = [step.command for step in s.steps] + [x.field for t in s.streams for x in t.fields]
            used += [step.response.field for step in s.steps if step.response]
            assert all(part.field(f.full_name) is f for f in used)
        if g.migration:
            assert part.device(g.migration.before.id) is g.migration.before
            assert all(part.field(f.full_name) is f for c in g.migration.changes for f in (*c.fields, *c.by))


@pytest.mark.parametrize("device", REAL.devices, ids=lambda d: d.id)
def test_of_a_device(device: m.Device) -> None:
    part = select(REAL, Selection(devices=(device.id,)))
    whole(part)
    supported = {s.field.full_name for s in device.supports}
    needed = {c.full_name for s in device.supports for r in REAL.responses(s.field) for c in REAL.commands(r)}
    asked = {n for n in names(part) if part.field(n).role != m.RESPONSE}  # type: ignore[union-attr]
    assert asked - supported == needed - supported
    assert [d.id for d in part.devices] == [device.id]
    places = {(f.full_name, n) for f in part.fields if f.role == m.DATA and not f.everywhere for n in f.sets}
    assert places == {(s.field.full_name, s.set) for s in device.supports if s.set in m.DATA_SETS}


@pytest.mark.parametrize("s", [s for s in REAL.sets if REAL.fields_in(s)], ids=lambda s: s.name)
def test_of_a_set(s: m.Set) -> None:
    part = select(REAL, Selection(sets=(s.name,)))
    whole(part)
    shared = {f.full_name for f in REAL.fields if f.everywhere} if s.kind != "command" else set()
    assert names(part) == {f.full_name for f in REAL.fields_in(s)} | shared
    assert [x.name for x in part.sets if x.name != "shared"] == [s.name] * (s.name != "shared")


def test_a_set_may_be_given_by_its_number() -> None:
    for number in ("0x80", "0X80"):
        assert names(select(REAL, Selection(sets=(number,)))) == names(select(REAL, Selection(sets=("sensor",))))
    part = select(REAL, Selection(sets=("0x1",), devices=("3dm-gx5-15",)))
    assert [s.name for s in part.sets] == ["base"]


def test_a_session_without_its_data_sets() -> None:
    """The commands of older devices are for one set each, which a part may lack."""
    whole_session, without = session(model("real")), session(select(model("real"), Selection(sets=("base", "3dm"))))
    assert whole_session is not None and without is not None
    assert [x.set for x in whole_session.older] == [0x80, 0x81, 0x82] and without.older == ()
    assert whole_session.format.full_name == without.format.full_name == "3dm.message_format"
    one = some(session(select(model("real"), Selection(sets=("base", "3dm", "filter_data")))))
    assert [x.set for x in one.older] == [0x82]
    assert session(select(model("real"), Selection(sets=("3dm",)))) is None


def test_of_a_field_in_one_of_its_sets() -> None:
    """The name in a set selects that set alone; the name of the layout selects all."""
    for name, sets in (("copy.accel", (0x92,)), ("measurements.accel", (0x80, 0x81, 0x92))):
        part = select(INVENTED, Selection(fields=(name,)))
        accel = some(part.field("measurements.accel"))
        assert accel.sets == sets
        assert {s.number for s in part.sets if s.name != "shared"} == {*sets}
        assert all(s.set in sets for d in part.devices for s in d.supports if s.field is accel)


@pytest.mark.parametrize("f", INVENTED.fields, ids=lambda f: f.full_name)
def test_of_a_field(f: m.Field) -> None:
    part = select(INVENTED, Selection(fields=(f.full_name,)))
    whole(part)
    assert f.full_name in names(part) and len(names(part)) < 7


def test_a_response_comes_with_its_commands() -> None:
    part = select(INVENTED, Selection(fields=("tools.bias_vector",)))
    assert names(part) == {"tools.bias_vector", "tools.bias", "tools.capture_bias"}


@pytest.mark.parametrize(
    ("spec", "name", "setting"),
    [("real", "aiding.ned_velocity", "aiding.echo_control"), ("invented", "3d.default", "tools.settings")],
)
def test_a_command_comes_with_what_silences_it(spec: str, name: str, setting: str) -> None:
    """Python's simulator reads that setting."""
    part = select(model(spec), Selection(fields=(name,)))
    assert {name, setting} <= names(part)
    whole(part)
    assert render.render("python", part)


@pytest.mark.parametrize("device", REAL.devices, ids=lambda d: d.id)
def test_a_field_of_a_device(device: m.Device) -> None:
    """Each field that a device has can be selected for it, and no other; some of each device are tried."""
    responses = {r.full_name for s in device.supports if s.responds for r in REAL.answers(s.field, device.id)}
    has = {s.field.full_name for s in device.supports} | responses
    for f in random.Random(f"{SEED} {device.id}").sample(REAL.fields, rounds(8, len(REAL.fields))):
        selection = Selection(devices=(device.id,), fields=(f.full_name,))
        if f.full_name in has:
            select(REAL, selection)
            continue
        with pytest.raises(Failure, match=f"^mipgen: error: no selected device has the field '{f.full_name}'; "):
            select(REAL, selection)


def test_devices_narrow_sets() -> None:
    part = select(INVENTED, Selection(devices=("model-b",), sets=("tools",)))
    assert names(part) == {
        "tools.ping", "tools.settings", "tools.settings_response", "tools.status", "tools.status_short",
        "tools.status_long",
    }  # fmt: skip


def test_a_device_has_its_own_layouts_of_a_response() -> None:
    for devices, wanted in (
        (("3dm-gq4-45",), ["basic", "diagnostic_gq4_45"]),
        (("3dm-cx5-10", "3dm-gx5-15"), ["basic", "basic_without_state", "diagnostic", "diagnostic_imu"]),
    ):
        part = select(REAL, Selection(devices=devices))
        whole(part)
        found = [n.removeprefix("3dm.device_status_").removesuffix("_response") for n in names(part)
                 if n.startswith("3dm.device_status_")]  # fmt: skip
        assert sorted(found) == wanted
        for r in part.responses(part.field("3dm.device_status")):  # type: ignore[arg-type]
            assert set(r.devices) <= set(devices)


def test_guides_of_a_device() -> None:
    """They keep the sequences of the device, and no migration to another one."""
    part = select(REAL, Selection(devices=("3dm-gx5-15",)))
    assert [g.name for g in part.guides] == [
        g.name for g in REAL.guides if g.questions or any(d.id == "3dm-gx5-15" for s in g.sequences for d in s.devices)
    ]
    assert all(g.migration is None for g in part.guides) and len(part.guides) > 3


def test_what_is_certain() -> None:
    """Without what is only likely or assumed, but with the responses to what it certainly has."""
    d = some(REAL.device("3dm-gq7"))
    assert d.likely or d.assumed
    both, sure = select(REAL, Selection((d.id,))), select(REAL, Selection((d.id,), certain=True))
    assert {s.name for s in both.devices[0].supports} == {s.name for s in d.supports}
    assert {s.name for s in sure.devices[0].supports} == {s.name for s in d.certain}
    own = {f.full_name for f in sure.fields if f.role != m.RESPONSE}
    assert own <= {f.full_name for f in both.fields}
    assert own - {s.field.full_name for s in d.certain} == {"3dm.gyro_bias"}  # shares the response of capture_gyro_bias


def test_sets_that_a_device_has_whole_are_narrowed() -> None:
    for s in REAL.sets:
        part = select(REAL, Selection(sets=(s.name,)))
        assert {x.name for d in part.devices for x in d.complete} <= {x.name for x in part.sets}


def test_what_was_left_out() -> None:
    part = select(REAL, Selection(sets=("base",)))
    line = left_out(REAL, part)
    assert f"{len(REAL.fields) - len(part.fields)} fields" in line and f"{len(REAL.sets) - 1} sets" in line
    assert left_out(REAL, REAL).endswith("left out: nothing")


NUMBERS = ", ".join(f"0x{number:02X}" for number in sorted(s.number for s in REAL.sets))


@pytest.mark.parametrize(
    ("selection", "message"),
    [
        (Selection(devices=("3dm-gx5_15",)), "unknown device '3dm-gx5_15', did you mean '3dm-gx5-15'?"),
        (Selection(devices=("GX5-15",)), "unknown device 'GX5-15', did you mean '3dm-gx5-15'?"),
        (Selection(devices=("3DM-GX5-AR",)), "unknown device '3DM-GX5-AR', did you mean '3dm-gx5-15'?"),
        (Selection(devices=("6254",)), "unknown device '6254', did you mean '3dm-gx5-15'?"),
        (
            Selection(devices=("RQ1",)),
            "unknown device 'RQ1', did you mean '3dm-rq1-45-lt' or '3dm-rq1-45-st' or '3dm-rq1-imu'?",
        ),
        (Selection(devices=("3DM-GXX-15",)), "unknown device '3DM-GXX-15', did you mean '3dm-gx5-15'?"),
        (Selection(certain=True), "--certain requires a device; add --device"),
        (
            Selection(devices=("3dm-mv5-ar",), certain=True),
            "no command or data field of 3DM-MV5-AR is certain: leave out --certain, or add another --device",
        ),
        (Selection(sets=("0x7E",)), f"no set has the number 0x7E; known: {NUMBERS}"),
        *(
            (
                Selection(devices=(name,)),
                "only the name of the 3DM-GX5-10 is known; choose 3dm-cx5-10, the device most like it",
            )
            for name in ("3dm-gx5-10", "3DM-GX5-10", "gx5-10", "3dm_gx5_imu", "6255")
        ),
        (Selection(sets=("sensr",)), "unknown set 'sensr', did you mean 'sensor'?"),
        (Selection(fields=("base.pin",)), "unknown field 'base.pin', did you mean 'base.ping'?"),
        (
            Selection(devices=("3dm-gx5-15",), fields=("3dm.device_status_diagnostic_gq4_45_response",)),
            "no selected device has the field '3dm.device_status_diagnostic_gq4_45_response'; remove it, or select "
            "a device that has it: 3dm-gq4-45",
        ),
        (
            Selection(devices=("3dm-gx5-15", "3dm-cx5-10"), sets=("sensor", "displacement")),
            "no selected device has the set 'displacement'; remove it, or select a device that has it: demod-dc",
        ),
    ],
)
def test_unknown_names(selection: Selection, message: str) -> None:
    with pytest.raises(Failure) as caught:
        select(REAL, selection)
    assert str(caught.value) == f"mipgen: error: {message}"


def test_the_values_of_a_range_of_bits_come_with_it() -> None:
    """An enumeration that only bits of a bitfield refer to."""
    f = some(INVENTED.field("measurements.accel"))
    assert isinstance(f.parameters[1].element, m.Bitfield)
    assert {b.enum.name for b in f.parameters[1].element.bits if b.enum} == {"mode"}
    assert all(p.element is not None and getattr(p.element, "name", "") != "mode" for p in f.parameters)
    part = select(INVENTED, Selection(fields=(f.full_name,)))
    assert "mode" in {t.name for t in part.all_types}


def test_layouts_keep_their_senders_where_none_is_selected() -> None:
    """Otherwise any device would send them."""

    def bound(f: m.Field) -> m.Field:
        return dataclasses.replace(f, devices=("model-a",)) if f.name == "status_long" else f

    families = tuple(dataclasses.replace(x, fields=tuple(map(bound, x.fields))) for x in INVENTED.families)
    of = dataclasses.replace(INVENTED, families=families)
    part = select(of, Selection(devices=("model-b",), fields=("tools.status",)))
    layouts = {f.name: f.devices for f in part.fields if f.name.startswith("status_")}
    assert layouts.items() >= {"status_short": (), "status_long": ("model-a",)}.items()
