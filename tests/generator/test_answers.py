"""What a specification says of answers: silence, and the devices that send a response."""

from __future__ import annotations

import dataclasses

from mipgen import describe
from mipgen import model as m
from support import model

INVENTED, REAL = model("invented"), model("real")


def field(of: m.Model, name: str) -> m.Field:
    found = of.field(name)
    assert found is not None
    return found


def said(of: m.Model, name: str, topic: str) -> list[str]:
    facts = describe.topics(describe.field(field(of, name), of), topic)
    return [describe.say(f.sentence, lambda r: f"<{r.words}>") for f in facts]


def test_silence_by_parameters_and_by_settings() -> None:
    formats, default = field(INVENTED, "tools.formats"), field(INVENTED, "3d.default")
    assert [(c.command, c.parameter, c.value) for c in formats.silent_when] == [(None, "suppress_ack", 1)]
    assert not formats.silenced_by and not default.silent_when  # a client knows the parameters, not the settings
    assert [(c.command, c.parameter, c.value) for c in default.silenced_by] == [("tools.settings", "mode", 1)]
    assert said(INVENTED, "tools.formats", "silent") == ["Not acknowledged if <suppress_ack> is true."]
    assert said(INVENTED, "3d.default", "silent") == ["Not acknowledged if <mode> of <tools.settings> is <fast>."]


def test_echo_control() -> None:
    """All aiding measurements are silent by the same setting, and nothing else is."""
    silent = {f.full_name for f in REAL.fields if f.silenced_by}
    settings = {"aiding.frame_config", "aiding.echo_control"}
    commands = {f.full_name for f in REAL.fields if f.set_name == "aiding" and f.role == m.COMMAND}
    assert silent == commands - settings and len(silent) == 9
    wanted = ["Not acknowledged if <mode> of <aiding.echo_control> is <suppress_ack>."]
    assert all(said(REAL, name, "silent") == wanted for name in silent)


def test_a_response_says_once_what_it_answers() -> None:
    assert said(INVENTED, "tools.bias_vector", "commands") == ["Answers <tools.bias> and <tools.capture_bias>."]
    assert field(INVENTED, "tools.bias_vector").description == ""


def test_devices_that_send_a_response() -> None:
    """A device that takes no function that is answered by a response does not send it."""
    names = {"write", "apply"}
    settings, response = field(INVENTED, "tools.settings"), field(INVENTED, "tools.settings_response")
    writes = m.Support(settings, tuple(f for f in settings.functions if f.name in names))
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
    assert [d.id for d in INVENTED.devices_of(field(INVENTED, "tools.inventory_response"))] == ["model-a", "model-c"]
