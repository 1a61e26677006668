"""`mip config`: what its users see; and whatever settings a virtual device has, a file carries over to another one."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import (
    AckCode,
    Device,
    MissingResponse,
    Packet,
    Refused,
    base,
    devices,
    mip_3dm,
    registry,
    system,
    types,
)
from mip_protocol.errors import Cause
from mip_simulator import LivePort, VirtualDevice
from mip_tools.configuration import parsed
from mip_tools.configuration.talk import Pushed, Talk, nack_text
from mip_tools.configuration.written import file_text
from mip_tools.ports import connection
from mipgen import model as m
from mipgen.lower import codec
from program import mip, streaming
from support import PATIENCE, heavy, model
from virtual.commands import commands, trials

MODEL = "3dm-cv7-gnss-ins"


class Wire(LivePort):
    """A serial line: nothing passes while its ends have different rates, and nothing is heard at those in `unheard`."""

    def __init__(self, device: VirtualDevice, unheard: tuple[int, ...] = ()) -> None:
        super().__init__(device, "UART 1", speed=50)
        self.unheard, self._rate = unheard, 115200

    @property
    def baudrate(self) -> int:
        return self._rate

    @baudrate.setter
    def baudrate(self, rate: int) -> None:
        self._rate = rate

    def read(self, size: int) -> bytes:
        data = super().read(size)
        return data if self._rate == self._link.baud and self._rate not in self.unheard else b""

    def write(self, data: bytes) -> int:
        return super().write(data) if self._rate == self._link.baud else len(data)


class At:
    """A virtual device at the port that `mip config` opens, and the commands that it gets."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.commands: list[str] = []
        self.device = VirtualDevice(MODEL, trace=self._trace)
        self.wire: LivePort | None = None
        monkeypatch.setattr(connection, "opened", self._opened)

    def _trace(self, what: str, data: bytes) -> None:
        if what == "command":
            for raw in Packet(data):
                kind = registry.types(raw.set, raw.descriptor)[0]
                function = getattr(kind.decode(raw.data), "function", None)
                self.commands.append(kind.NAME if function is None else f"{kind.NAME} {function.name.lower()}")

    @contextmanager
    def _opened(self, line: connection.Line, **more: Any) -> Iterator[Device]:
        timeout = {"timeout": 1.0} if isinstance(self.wire, Wire) else {}  # it carries no reply at some rates
        with Device(self.wire or LivePort(self.device, speed=50), **timeout, **more) as link:
            request: Any = link.request

            def soon(command: Any, timeout: float | None = None) -> Any:
                """Waits only for a reply that comes: on a busy machine, that may take long."""
                wire = self.wire
                lost = isinstance(wire, Deaf) and (wire.deaf or getattr(command, "protocols_incoming", ()))
                return request(command, 0.5 if lost else timeout)

            link.request = soon  # type: ignore[method-assign]
            yield link

    @property
    def changes(self) -> list[str]:
        return [c for c in self.commands if not c.endswith(" read")]

    def written(self, command: Any) -> Any:
        """The setting that a command would read."""
        return self.device.settings.current(command)


@pytest.fixture
def at(monkeypatch: pytest.MonkeyPatch) -> At:
    return At(monkeypatch)


def pulled(path: Path) -> Path:
    code, out, error = mip("config", "pull", "PORT")
    assert (code, error) == (0, "")
    path.write_text(out, "utf-8")
    return path


@cache
def fresh() -> str:
    """The file of a device as it comes."""
    with pytest.MonkeyPatch.context() as patch:
        At(patch)
        return mip("config", "pull", "PORT")[1]


def edited(tmp_path: Path, *changes: tuple[str, str]) -> Path:
    """The settings of the device, changed in the file."""
    text = fresh()
    for old, new in changes:
        assert text.count(old) >= 1, old
        text = text.replace(old, new, 1)
    path = tmp_path / "settings.yaml"
    path.write_text(text, "utf-8")
    return path


# --------------------------------------------------------------------------- pull


def test_the_file(at: At, tmp_path: Path) -> None:
    lines = pulled(tmp_path / "s.yaml").read_text().splitlines()
    assert "model: 3dm-cv7-gnss-ins  # 3DM-CV7-GNSS/INS, model number 6292" in lines
    assert lines[3] == "firmware: 7.0.00" and lines[4].startswith("date: 20")
    for line in (
        "    comm_speed:  # baud in Bd",
        "      uart_1: {baud: 115200}",
        "      1: {feature: unused, behavior: unused, pin_mode: []}",
        "        scaled_accel: {enable: true, manual: false, frequency: 0.0}",
        "      initial_heading: 0.0  # deg",
        "    speed_lever_arm: {lever_arm_offset: {x: 0.0, y: 0.0, z: 0.0}}  # lever_arm_offset in m",
        "      uart_2: {protocols_incoming: [], protocols_outgoing: []}",
    ):
        assert line in lines
    assert not any("serial" in line for line in lines)
    assert at.changes == ["base.ping", "base.get_device_info", "base.get_device_descriptors",
                          "base.get_extended_descriptors"]  # fmt: skip


def test_a_model_that_the_package_does_not_know(at: At, tmp_path: Path) -> None:
    at.device.profile = replace(at.device.profile, title="3DM-XY9", model_number=6999)
    path = pulled(tmp_path / "s.yaml")
    assert "model: 3DM-XY9\n" in path.read_text()
    code, out, _ = mip("config", "push", "PORT", path)
    assert code == 0 and " 0 settings changed, " in out


def test_an_output_file(at: At, tmp_path: Path) -> None:
    path = tmp_path / "s.yaml"
    assert mip("config", "pull", "PORT", "-o", path)[0] == 0
    assert path.read_text() == pulled(tmp_path / "t.yaml").read_text()


def test_an_answer_without_the_setting_is_left_out_and_named(at: At, monkeypatch: pytest.MonkeyPatch) -> None:
    usual = Talk.request

    def without(talk: Talk, command: Any) -> Any:
        if isinstance(command, mip_3dm.PpsSourceControl):
            raise MissingResponse(command.NAME)
        return usual(talk, command)

    monkeypatch.setattr(Talk, "request", without)
    code, out, error = mip("config", "pull", "PORT")
    assert code == 0 and "mip config: 3dm.pps_source_control is left out: " in error
    assert "pps_source_control" not in out and "odometer_config" in out


# --------------------------------------------------------------------------- push


def test_only_what_differs_is_written(at: At, tmp_path: Path) -> None:
    path = edited(
        tmp_path,
        ("sensor: {descriptors: []}", "sensor: {descriptors: [{descriptor: scaled_accel, decimation: 10}]}"),
        ("1: {type: none}", "1: {type: gpio, parameters: {pin: 1, mode: edge}}"),
        ("1: {mode: disabled}", "1: {mode: enabled}"),
        ("uart_2: {protocols_incoming: []", "uart_2: {protocols_incoming: [rtcm]"),
    )
    at.commands.clear()
    code, out, error = mip("config", "push", "PORT", path)
    assert (code, error) == (0, "")
    same = 122 - 4
    remedy = "`mip config save PORT` keeps them at power-off"
    assert out == f"PORT: 4 settings changed, {same} as before, 0 refused; {remedy}\n"
    writes = [c for c in at.commands if c.endswith(" write")]
    # The trigger must be configured before it can be enabled, and the ports come last.
    assert writes == ["3dm.event_control write", "3dm.event_trigger_config write", "3dm.message_format write",
                      "3dm.event_control write", "system.interface_control write"]  # fmt: skip
    (rate,) = at.written(mip_3dm.MessageFormat.read(0x80)).descriptors
    assert (rate.descriptor, rate.decimation) == (0x04, 10)
    assert at.written(mip_3dm.EventControl.read(1)).mode == types.EventTriggerMode.ENABLED
    assert not any(c.endswith((" save", " load", " default")) or "device_settings" in c for c in at.commands)
    at.commands.clear()
    assert mip("config", "push", "PORT", path)[1].startswith("PORT: 0 settings changed")
    assert not any(c.endswith(" write") for c in at.commands)


def test_the_reason_for_a_rejection_has_its_code() -> None:
    command, code = mip_3dm.SensorRange.read(mip_3dm.SensorRangeType.ACCEL), AckCode.INVALID_PARAMETER
    cause = Cause(0, 0x80, 4, "absent", "a field")
    assert nack_text(Refused(command, code, cause=cause)) == "invalid_parameter (3): a field"
    assert nack_text(Refused(command, code)).startswith("invalid_parameter (3): ")
    assert nack_text(Refused(command, AckCode(99))) == "code 99"


def test_refused_settings_are_named_with_why(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, ("1: {mode: disabled}", "1: {mode: enabled}"), ("setting: 3", "setting: 2"))
    code, out, error = mip("config", "push", "PORT", path)
    line = next(i for i, text in enumerate(path.read_text().splitlines(), 1) if "1: {mode: enabled}" in text)
    reason = "command_failed (4): The device could not carry out the command."
    assert error == f"mip config: {path}:{line}:7: 3dm.event_control 1 was refused: {reason}\n"
    assert code == 3 and out.startswith("PORT: 1 setting changed, ") and ", 1 refused; " in out
    assert at.written(mip_3dm.SensorRange.read(mip_3dm.SensorRangeType.ACCEL)).setting == 2


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("    comm_speed:", "    com_speed:", "'base' has no 'com_speed'; did you mean 'comm_speed'?"),
        ("  base:", "  bass:", "'settings' has no 'bass'; did you mean 'base'?"),
        ("{source: receiver_1}", "{sorce: receiver_1}",
         "'3dm.pps_source_control' has no 'sorce'; did you mean 'source'?"),
        ("{source: receiver_1}", "{}", "'3dm.pps_source_control' needs source too"),
        ("{source: receiver_1}", "{source: receiver_9}",
         "'source' cannot be 'receiver_9'; did you mean 'receiver_2' or 'receiver_1'?"),
        ("{source: receiver_1}", "{source: 77}",
         "'source' has no value 77; known: disabled, receiver_1, receiver_2, gpio, generated"),
        ("{source: receiver_1}", "{source: }", "'source' cannot be ''"),
        ("{source: receiver_1}", "{source: [a]}", "'source' needs one value"),
        ("{baud: 115200}", "{baud: fast}", "baud: 'fast' is not a whole number"),
        ("{baud: 115200}", "{baud: 115200, baud: 9600}", "'baud' is already on line 9; remove one"),
        ("time_limit: 0}", "time_limit: 70000}", "time_limit"),
        ("max_offset: 0.1", "max_offset: -1.0", "'max_offset' must be "),
        ("pin_mode: []", "pin_mode: [pullup2]", "'pullup2' is not one of"),
        ("{x: 0.0, y: 0.0, z: 0.0}", "{x: 0.0, y: 0.0}", "'bias' needs z too"),
        ("1: {type: none}", "1: {type: none, parameters: {pin: 1}}",
         "'parameters' is not used with this 'type'; remove it"),
        ("1: {type: none}", "1: {type: gpio}", "'3dm.event_trigger_config' needs parameters too"),
        ("sensor: {descriptors: []}", "sensor: {descriptors: [{descriptor: scaled_acel, decimation: 10}]}",
         "'descriptor' cannot be 'scaled_acel'; did you mean 'scaled_accel'"),
        ("sensor: {descriptors: []}", "sensor: {descriptors: [{descriptor: scaled_accel, decimation: 99999}]}",
         "decimation is 99999, needs 0 to 65535"),
        ("      sensor:", "      sensors:", "did you mean 'sensor'"),
        ("model: 3dm-cv7-gnss-ins", "model: 3dm-cv7-gnss-inz", "'3dm-cv7-gnss-inz' is not a device; did you mean"),
        ("settings:", "settngs:", "a settings file has no 'settngs'; did you mean 'settings'?"),
        # Valid in the specification, but not on this device.
        ("1: {type: none}", "99: {type: none}", "this device has no 3dm.event_trigger_config 99; remove it"),
        ("sensor: {descriptors: []}", "sensor: {descriptors: [{descriptor: raw_accel, decimation: 10}]}",
         "this device does not have the field 'raw_accel'; remove it"),
        ("    nmea_message_format:", "    imu_message_format: {descriptors: []}\n    nmea_message_format:",
         "this device has no setting '3dm.imu_message_format'; use 3dm.message_format instead"),
        ("    nmea_message_format:", "    coning_sculling_enable: {enable: true}\n    nmea_message_format:",
         "this device has no setting '3dm.coning_sculling_enable'; remove it"),
    ],
)  # fmt: skip
def test_nothing_is_written_if_anything_is_wrong(at: At, tmp_path: Path, old: str, new: str, said: str) -> None:
    path = edited(tmp_path, ("accel: {setting: 3}", "accel: {setting: 2}"), (old, new))
    at.commands.clear()
    code, out, error = mip("config", "push", "PORT", path)
    assert code == 1 and not out and said in error
    changed = new.splitlines()[0].strip().partition(" [")[0]
    place = error.removeprefix("mip: ").removeprefix("mip config: ")
    assert place.startswith(f"{path}:")
    number = int(place.removeprefix(f"{path}:").partition(":")[0])
    assert changed.split()[0] in path.read_text().splitlines()[number - 1] or "missing" in error
    assert not any(c.endswith(" write") for c in at.commands)


def test_all_mistakes_at_once(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, ("{source: receiver_1}", "{source: 77}"), ("{baud: 115200}", "{baud: fast}"))
    at.commands.clear()
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 1 and "77" in error and "fast" in error and at.commands == []


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "1:1: this is not a settings file; `mip config pull` writes one"),
        ("[]", "1:1: this is not a settings file; `mip config pull` writes one"),
        ("model: 3dm-gq7", "1:1: 'settings' is missing; `mip config pull` writes a complete file"),
        ("settings: {}", "1:1: 'model' is missing; add the name of the device, as `mip config pull` does"),
        ("model: [", "not YAML: "),
    ],
)
def test_no_file_of_settings(at: At, tmp_path: Path, text: str, said: str) -> None:
    path = tmp_path / "s.yaml"
    path.write_text(text)
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 1 and str(path) in error and said in error and at.commands == []


def test_what_is_no_text(at: At, tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    path.write_bytes(b"\xff")
    master, slave = os.openpty()
    try:  # port and file in the wrong order: a port would be read without end
        port = os.ttyname(slave)
        assert mip("config", "push", path, port) == (1, "", f"mip config: {port} is a port, not a file\n")
    finally:
        os.close(master)
        os.close(slave)
    assert mip("config", "push", "PORT", path) == (1, "", f"mip config: {path} is not a text file in UTF-8\n")
    assert at.commands == []


def test_flags_that_a_device_lacks(at: At, tmp_path: Path) -> None:
    at.device = VirtualDevice("3dm-gx5-15")
    path = tmp_path / "s.yaml"
    text = "model: 3dm-gx5-15\nsettings: {filter: {estimation_control: {flags: [gyro_bias%s]}}}\n"
    path.write_text(text % ", antenna_offset, auto_hard_iron")
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 1 and "'flags' cannot have antenna_offset|auto_hard_iron on this device; known: gyro_bias" in error
    path.write_text(text % "")
    assert mip("config", "push", "PORT", path)[0] == 0


def test_ports_whose_rates_are_not_known_have_one() -> None:
    text = file_of(VirtualDevice("3dm-gq7"))
    assert "      1: {baud: 115200}\n      2: {baud: 115200}\n" in text


def test_another_model(at: At, tmp_path: Path) -> None:
    path = tmp_path / "s.yaml"
    path.write_text("model: 3dm-gq7\nsettings: {3dm: {sensor_range: {accel: {setting: 2}}}}\n")
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 1 and "has the settings of a 3dm-gq7, but PORT is a 3dm-cv7-gnss-ins" in error
    assert not any(c.endswith(" write") for c in at.commands)
    code, out, error = mip("config", "push", "PORT", path, "--device", "3dm-gq7")  # the user knows better
    assert (code, out.partition(";")[0]) == (0, "PORT: 1 setting changed, 0 as before, 0 refused")
    assert error == "mip config: device 3DM-GQ7-GNSS/INS (named), although it is a 3DM-CV7-GNSS/INS at the port\n"


# --------------------------------------------------------------------------- streams


def at_work(at: At) -> None:
    at.device.disconnect(streaming(at.device, {0x80: ((0x04, 1),)}))
    at.commands.clear()


def test_a_device_that_streams_is_idle_meanwhile(at: At) -> None:
    at_work(at)
    assert mip("config", "pull", "PORT")[0] == 0
    assert "base.set_idle" in at.commands[:2] and at.commands[-1] == "base.resume" and not at.device.idle


def test_a_device_that_is_idle_stays_so(at: At) -> None:
    at_work(at)
    at.device.idle = True
    at.device.arrange()
    assert mip("config", "pull", "PORT")[0] == 0
    assert at.device.idle and not {"base.set_idle", "base.resume"} & {*at.commands}


def test_an_interrupt_resumes_the_streams(at: At, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    at_work(at)
    path = edited(tmp_path, ("setting: 3", "setting: 2"))
    usual = Talk.request

    def interrupted(talk: Talk, command: Any) -> Any:
        if isinstance(command, mip_3dm.SensorRange) and command.function.name == "WRITE":
            raise KeyboardInterrupt
        return usual(talk, command)

    monkeypatch.setattr(Talk, "request", interrupted)
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 130 and "none were saved" in error
    assert at.commands[-1] == "base.resume" and not at.device.idle


# --------------------------------------------------------------------------- the line

OPENED = ("uart_3: {protocols_incoming: []", "uart_3: {protocols_incoming: [nmea]")
FASTER = ("uart_1: {baud: 115200}", "uart_1: {baud: 921600}")


def test_the_baud_rate_is_changed_last(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, FASTER, ("setting: 3", "setting: 2"), OPENED)
    at.wire = Wire(at.device)
    at.commands.clear()
    code, out, error = mip("config", "push", "PORT", path)
    assert (code, error) == (0, "") and out.endswith("PORT: the baud rate is now 921600; use --baud 921600\n")
    writes = [c for c in at.commands if c.endswith(" write")]
    assert writes == ["3dm.sensor_range write", "system.interface_control write", "base.comm_speed write"]
    assert at.written(base.CommSpeed.read(0x11)).baud == 921600


def test_a_rate_at_which_the_device_is_not_heard_is_taken_back(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, FASTER)
    at.wire = Wire(at.device, unheard=(921600,))
    code, out, error = mip("config", "push", "PORT", path)
    assert code == 3 and "the device stopped answering; the former value was restored" in error
    assert at.written(base.CommSpeed.read(0x11)).baud == 115200
    assert " 0 settings changed, " in out


class Deaf(LivePort):
    """Nothing is heard from the device once a certain port has other protocols."""

    @property
    def deaf(self) -> bool:
        kept = self._device.settings.current(system.InterfaceControl.read(types.CommInterface.UART_3))
        return bool(kept.protocols_incoming)

    def read(self, size: int) -> bytes:
        data = super().read(size)
        return b"" if self.deaf else data


def test_protocols_are_taken_back(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, OPENED)
    at.wire = Deaf(at.device, speed=50)
    code, _, error = mip("config", "push", "PORT", path)
    assert code == 3 and "system.interface_control uart_3 was refused: the device stopped answering" in error
    assert not at.written(system.InterfaceControl.read(types.CommInterface.UART_3)).protocols_incoming


# --------------------------------------------------------------------------- diff and save


def test_differences_in_words(at: At, tmp_path: Path) -> None:
    old = edited(tmp_path).rename(tmp_path / "old.yaml")
    pin = ("feature: unused, behavior: unused", "feature: gpio, behavior: input")
    new = edited(tmp_path, ("setting: 3", "setting: 2"), pin)
    text = (
        "3dm.gpio_config 1: feature unused -> gpio; behavior unused -> input\n3dm.sensor_range accel: setting 3 -> 2\n"
    )
    assert mip("config", "diff", old, new) == (1, text, "")
    assert mip("config", "diff", "PORT", new) == (1, text, "")
    assert mip("config", "diff", old, "PORT") == (0, "", "")
    lines = old.read_text().replace("    pps_source_control: {source: receiver_1}\n", "")
    new.write_text(lines)
    assert mip("config", "diff", old, new) == (1, f"3dm.pps_source_control: only in {old}\n", "")


def test_nothing_is_saved_unless_asked(at: At, tmp_path: Path) -> None:
    path = edited(tmp_path, ("setting: 3", "setting: 2"))
    assert mip("config", "push", "PORT", path)[0] == 0
    asked = mip_3dm.SensorRange.read(mip_3dm.SensorRangeType.ACCEL)
    at.device.reset()
    at.device.advance(10)
    assert at.written(asked).setting == 3
    assert mip("config", "push", "PORT", path)[0] == 0
    code, out, error = mip("config", "save", "PORT")
    assert (code, out, error) == (0, "PORT: 3DM-CV7-GNSS/INS: all settings saved\n", "")
    at.device.reset()
    at.device.advance(10)
    assert at.written(asked).setting == 2


def test_settings_are_saved_one_by_one_if_there_is_no_other_way(at: At, tmp_path: Path) -> None:
    at.device.field_keys -= {(0x0C, 0x30)}
    path = edited(tmp_path, ("setting: 3", "setting: 2"))
    assert mip("config", "push", "PORT", path)[0] == 0
    at.commands.clear()
    code, out, error = mip("config", "save", "PORT")
    saved = [c for c in at.commands if c.endswith(" save")]
    assert (code, out, error) == (0, f"PORT: 3DM-CV7-GNSS/INS: {len(saved)} settings saved\n", "") and len(saved) > 100
    at.device.reset()
    at.device.advance(10)
    assert at.written(mip_3dm.SensorRange.read(mip_3dm.SensorRangeType.ACCEL)).setting == 2


# --------------------------------------------------------------------------- whatever settings a device has

#: Settings that no file has: actions, values that all select an instance, and what ends the conversation.
LEFT_OUT = {"filter.tare_orientation", "3dm.data_stream_format"}
ENDS = {"system.comm_mode", "system.interface_control"}


def settable(device: m.Device) -> list[m.Support]:
    """The commands that can be written, read and saved; a demodulator has none."""

    def letters(functions: Iterable[m.Function]) -> set[str]:
        return {f.letter for f in functions}

    return [
        support
        for support in commands(device)
        if {"W", "R"} <= letters(support.functions)
        and "S" in letters(support.field.functions)
        and support.field.full_name not in LEFT_OUT | ENDS
    ]


def written_to(device: m.Device, virtual: VirtualDevice, only: int) -> set[str]:
    """Writes values of every command that can be written, read and saved; of each, every `only`-th good one."""
    link = virtual.connect()
    virtual.idle = True
    names = set()
    for support in settable(device):
        f = support.field
        every = next((dict(b.all) for b in model("real").simulation.behaviors if b.command is f), {})
        written = [t for t in trials(support, device) if t.good and t.function and t.function.letter == "W"]
        good = [t for t in written if not any(t.values[name] == number for name, number in every.items())]
        for trial in good[only::3]:
            data = codec.encode(f, trial.values)
            link.write(codec.build(model("real"), support.set, [(f.descriptor, data)]))
            virtual.advance(0.02)
            names.add(f.full_name)
    virtual.disconnect(link)
    virtual.idle = False
    return names


def file_of(virtual: VirtualDevice) -> str:
    with Device(LivePort(virtual, speed=20), timeout=PATIENCE) as link:
        it = Talk(link, "PORT", pytest.fail)
        return file_text(it.pull(), it.profile, it.model.id, it.listing.firmware, "2026-01-31")


def carried_to(virtual: VirtualDevice, path: Path) -> Pushed:
    with Device(LivePort(virtual, speed=20), timeout=PATIENCE) as link:
        it = Talk(link, "PORT", pytest.fail)
        return it.push(parsed.parsed_settings(path, it.profile).commands)


#: Settings that a device has in a form of its own: a rotation that was written as a matrix is read as a quaternion.
ROUNDED = ("transform", "rotation")


def kept(virtual: VirtualDevice) -> dict[Any, Any]:
    return {place: value for place, value in virtual.settings.items() if place[0] not in LEFT_OUT}


#: The devices that `make test` samples: of each generation, with few settings and with many.
SAMPLE = ("3dm-cv7-gnss-ins", "3dm-gx5-45", "3dm-gq7", "3dm-gx3-35", "3dm-mv5-ar")
#: A device, and which third of the values it has; one of the sample has all.
CASES = [*((SAMPLE[0], only) for only in range(3)), *((device_id, i % 3) for i, device_id in enumerate(SAMPLE[1:]))]
ALL = [(device_id, only) for device_id in sorted(devices.DEVICES) for only in range(3)]


@pytest.mark.parametrize(
    ("device_id", "only"), [*CASES, *(pytest.param(*x, marks=heavy("all models")) for x in ALL if x not in CASES)]
)
def test_all_settings_of_a_device(tmp_path: Path, device_id: str, only: int) -> None:
    found = model("real").device(device_id)
    assert found is not None
    first, second = VirtualDevice(device_id), VirtualDevice(device_id)
    names = written_to(found, first, only)
    assert names or only or not settable(found)
    path = tmp_path / "settings.yaml"
    path.write_text(file_of(first))
    done = carried_to(second, path)
    assert not done.refused and not done.read_differently
    assert file_of(second) == path.read_text()
    for place, value in kept(first).items():
        if not any(word in place[0] for word in ROUNDED):
            assert second.settings.current(value) == value, place


def test_what_acts_only_once_is_no_setting() -> None:
    virtual = VirtualDevice("3dm-gx5-25")
    assert virtual.knows("filter.tare_orientation") and "tare_orientation" not in file_of(virtual)
