"""Answers in a specification: silence, and the devices that send a response."""

from __future__ import annotations

import dataclasses

from mipgen import model as m
from mipgen.facts import describe
from support import model, some


def field(of: m.Model, name: str) -> m.Field:
    return some(of.field(name))


def said(of: m.Model, name: str, topic: str) -> list[str]:
    facts = describe.topics(describe.field(field(of, name), of), topic)
    return [describe.say(f.sentence, lambda r: f"<{r.words}>") for f in facts]


def test_echo_control() -> None:
    """The same setting silences all aiding measurements, and nothing else."""
    silent = {f.full_name for f in model("real").fields if f.silenced_by}
    settings = {"aiding.frame_config", "aiding.sensor_frame_map", "aiding.echo_control"}
    commands = {f.full_name for f in model("real").fields if f.family == "aiding" and f.role == m.COMMAND}
    assert silent == commands - settings and len(silent) == 10
    wanted = ["Not acknowledged if <mode> of <aiding.echo_control> is <suppress_ack>."]
    assert all(said(model("real"), name, "silent") == wanted for name in silent)


def test_devices_that_send_a_response() -> None:
    """A device that supports no function with a response does not send the response."""
    names = {"write", "apply"}
    settings, response = field(model("invented"), "tools.settings"), field(model("invented"), "tools.settings_response")
    functions = tuple(f for f in settings.functions if f.name in names)
    writes = m.Support(settings, settings.set, functions, m.Evidence("documented"))
    devices = tuple(
        dataclasses.replace(d, supports=tuple(writes if s.field is settings else s for s in d.supports))
        if d.id == "model-b"
        else d
        for d in model("invented").devices
    )
    changed = dataclasses.replace(model("invented"), devices=devices)
    assert [d.id for d in model("invented").devices_of(response)] == ["model-a", "model-b", "model-c"]
    assert [d.id for d in changed.devices_of(settings)] == ["model-a", "model-b", "model-c"]
    assert [d.id for d in changed.devices_of(response)] == ["model-a", "model-c"]
    assert [d.id for d in model("invented").devices_of(field(model("invented"), "tools.inventory_response"))] == [
        "model-a",
        "model-c",
    ]


def test_devices_that_send_a_layout() -> None:
    """Each device sends the layouts that name it, else those that name none."""
    status = field(model("real"), "3dm.device_status")
    start, end = "device_status_", "_response"
    sent = {
        d.id: [r.name.removeprefix(start).removesuffix(end) for r in model("real").answers(status, d.id)]
        for d, _ in model("real").supports(status)
    }
    assert sent["3dm-gx5-15"] == sent["3dm-cv5-25"] == ["basic", "diagnostic"]
    assert sent["3dm-gq4-45"] == ["basic", "diagnostic_gq4_45"]
    assert sent["3dm-gx5-45"] == sent["3dm-gx4-45"] == ["basic", "diagnostic_gnss"]
    assert sent["3dm-gx4-15"] == ["basic_without_state", "diagnostic_gx4"]
    assert sent["3dm-cx5-10"] == ["basic_without_state", "diagnostic_imu"]
    gq4 = field(model("real"), "3dm.device_status_diagnostic_gq4_45_response")
    sending = [[d.id for d in model("real").devices_of(gq4, answer)] for answer in m.SUPPORTED]
    assert sending == [["3dm-gq4-45"], [], []]
    names = {r.full_name for r in model("real").responses(status)}
    for d, _ in model("real").supports(status):  # the notes of the devices, which cite the source
        note = next((n.description for n in d.notes if n.name == "device_status"), "")
        told = {name for name in names if f"`{name}`" in note}
        assert not told or told == {r.full_name for r in model("real").answers(status, d.id)}, d.id


def test_layouts_that_name_a_device_are_no_longer_those_of_all() -> None:
    def bound(f: m.Field) -> m.Field:
        return dataclasses.replace(f, devices=("model-a",)) if f.name == "status_long" else f

    families = tuple(dataclasses.replace(x, fields=tuple(map(bound, x.fields))) for x in model("invented").families)
    of = dataclasses.replace(model("invented"), families=families)
    assert [f.name for f in of.answers(field(of, "tools.status"), "model-b")] == [
        "status_short", "status_long", "status_old", "status_full"
    ]  # fmt: skip
