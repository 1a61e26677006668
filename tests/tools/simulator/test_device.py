"""The simulated device: what it answers, remembers and streams."""

from __future__ import annotations

import math
import random
import sys
from itertools import groupby
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import (
    DecodeError,
    Packet,
    PacketBuilder,
    Parser,
    RawField,
    aiding,
    base,
    checksum,
    devices,
    filter,
    mip_3dm,
    protocol,
    registry,
    sensor,
    system,
    system_data,
    types,
)
from mip_simulator import VirtualDevice
from mip_simulator.commands import effects
from mip_simulator.streams import formats
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.settings import command_type, instance_keys
from mip_tools.errors import Failure
from simulated import Host
from support import model, rounds

CV7, GX5 = "3dm-cv7-gnss-ins", "3dm-gx5-15"
OK, UNKNOWN, INVALID, FAILED, UNKNOWN_SET = 0, 1, 3, 4, 6


@pytest.fixture
def host() -> Host:
    return Host(VirtualDevice(CV7))


@pytest.fixture
def old() -> Host:
    return Host(VirtualDevice(GX5))


def rates(*pairs: tuple[int, int]) -> tuple[types.DescriptorRate, ...]:
    return tuple(types.DescriptorRate(*pair) for pair in pairs)


# --------------------------------------------------------------------------- the specification and the runtime


def test_every_effect_is_implemented_and_no_other() -> None:
    assert set(effects.EFFECTS) == {e.name for e in model("real").simulation.effects}


@pytest.mark.parametrize("name", sorted(COMMANDS))
def test_the_arguments_of_effects_are_those_that_are_declared(name: str) -> None:
    behavior = COMMANDS[name]
    declared = {e.name: set(e.arguments) for e in model("real").simulation.effects}
    assert not behavior.effect or set(behavior.arguments) <= declared[behavior.effect]
    kind = command_type(name)
    assert set(behavior.all) <= set(instance_keys(kind)) or not kind.REQUIRED


# --------------------------------------------------------------------------- identity


@pytest.mark.parametrize("name", sorted(devices.DEVICES))
def test_a_device_says_who_it_is(name: str) -> None:
    device = VirtualDevice(name)
    if (base.GetDeviceInfo.SET, base.GetDeviceInfo.DESCRIPTOR) not in device.field_keys:
        return
    info = Host(device).ok(base.GetDeviceInfo()).device_info
    assert info.model_name.strip() == device.profile.title[:16]
    if device.profile.model_number:
        assert devices.identify(info) is device.profile


# --------------------------------------------------------------------------- settings


def test_a_setting_is_remembered_by_function(host: Host) -> None:
    kind = filter.AutoAngularZupt
    factory = host.ok(kind.read())
    host.ok(kind.write(1, 0.5))
    assert host.ok(kind.read()).threshold == 0.5
    host.ok(kind.load())  # nothing is saved
    assert host.ok(kind.read()) == factory
    host.ok(kind.write(1, 0.25))
    host.ok(kind.save())
    host.ok(kind.write(0, 0.75))
    host.ok(kind.load())
    assert host.ok(kind.read()).threshold == 0.25
    host.ok(kind.default())
    assert host.ok(kind.read()) == factory
    host.ok(kind.load())
    assert host.ok(kind.read()).threshold == 0.25, "the default does not remove what is saved"


def test_zero_means_all_instances(host: Host) -> None:
    kind = mip_3dm.MessageFormat
    host.ok(kind.write(0x80, rates((0x04, 10))))
    host.ok(kind.write(0x82, rates((0x05, 10))))
    host.ok(kind.save(0))
    host.ok(kind.default(0))
    assert host.ok(kind.read(0x80)).descriptors == host.ok(kind.read(0x82)).descriptors == ()
    host.ok(kind.load(0))
    assert host.ok(kind.read(0x82)).descriptors == rates((0x05, 10))
    assert host.refused(kind.read(0)) == INVALID
    assert host.refused(kind.write(0, rates((0x04, 10)))) == INVALID


def test_saved_settings_survive_in_a_file(tmp_path: Path) -> None:
    """Behind a link, too, which stays one."""
    (tmp_path / "kept").mkdir()
    link, path = tmp_path / "settings.json", tmp_path / "kept/real.json"
    link.symlink_to("kept/real.json")
    for place in (path, link):
        path.unlink(missing_ok=True)
        host = Host(VirtualDevice(CV7, storage=place))
        host.ok(filter.AutoAngularZupt.write(1, 0.25))
        assert not path.exists()
        host.ok(filter.AutoAngularZupt.save())
        assert Host(VirtualDevice(CV7, storage=place)).ok(filter.AutoAngularZupt.read()).threshold == 0.25
        assert link.is_symlink() and [p.name for p in path.parent.iterdir()] == ["real.json"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "is not a file of saved settings; remove it or name another file"),
        ("[]", "is not a file of saved settings"),
        ('{"device": "3dm-cv7-gnss-ins", "settings": [{"setting": "x.y"}]}', "is not a file of saved settings"),
        (
            '{"device": "3dm-cv7-gnss-ins", "settings": [{"setting": "base.comm_speed", "instance": [1], '
            '"command": "base.comm_speed", "data": "01"}]}',
            "is not a file of saved settings",
        ),
        ('{"device": "3dm-gx5-15", "settings": []}', "has the settings of 3dm-gx5-15, not of 3dm-cv7-gnss-ins"),
    ],
)
def test_a_damaged_file_is_refused(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "settings.json"
    path.write_text(text)
    with pytest.raises(Failure, match=message):
        VirtualDevice(CV7, storage=path)
    assert path.read_text() == text


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    """At once, not when a host saves something; and later too."""
    path = tmp_path / "none" / "settings.json"
    with pytest.raises(Failure, match=r"settings\.json cannot be written: No such file"):
        VirtualDevice(CV7, storage=path)
    path.parent.mkdir()
    host = Host(VirtualDevice(CV7, storage=path))
    assert not list(path.parent.iterdir())
    path.parent.rmdir()
    host.ok(filter.AutoAngularZupt.write(1, 0.25))
    with pytest.raises(Failure, match=r"settings\.json cannot be written: No such file"):
        host.ok(filter.AutoAngularZupt.save())


def test_bits_that_only_some_devices_have(old: Host) -> None:
    """In defaults, too."""
    assert old.ok(filter.EstimationControl.read()).flags == 1
    assert old.ok(filter.EnableMeasurements.read()).control == 1
    assert old.refused(filter.EstimationControl.write(0x7F)) == INVALID
    old.ok(filter.EstimationControl.write(1))
    selector = Host(VirtualDevice("3dm-cv7-ins")).ok(filter.InitializationConfig.read()).auto_heading_alignment_selector
    assert selector == selector.KINEMATIC | selector.MAG


def test_apply_without_reply(old: Host) -> None:
    assert old.ask(mip_3dm.GyroBias.apply((0.1, 0.2, 0.3))) == []
    assert old.ok(mip_3dm.GyroBias.read()).bias == pytest.approx((0.1, 0.2, 0.3))


# --------------------------------------------------------------------------- refusals


def command(set_number: int, descriptor: int, data: bytes = b"") -> bytes:
    return bytes(PacketBuilder(set_number).add(descriptor, data).build())


def codes(packets: list[Packet]) -> list[tuple[int, int]]:
    found = [registry.decode(raw) for packet in packets for raw in packet]
    return [(int(x.command), int(x.code)) for x in found if isinstance(x, protocol.Acknowledge)]


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (command(0x01, 0x01), OK),
        (command(0x01, 0x01, b"\0\0"), OK),  # what follows the parameters is not a mistake
        (command(0x01, 0x55), UNKNOWN),
        (command(0x55, 0x01), UNKNOWN_SET),
        (command(0x0C, 0x0F, b"\x09\x80"), INVALID),  # no such function
        (command(0x0C, 0x0F, b"\x01\x80\x05\x04"), INVALID),  # the count exceeds the data
        (command(0x0C, 0x0F, b"\x01\x80"), INVALID),  # truncated
        (command(0x0C, 0x0F, b"\x01\x81\x00"), INVALID),  # no such data set
        (command(0x0C, 0x0F, b"\x01\x80\x01\x63\x00\x01"), INVALID),  # no such field
        (command(0x0C, 0x0F, b"\x01\x80\x01\x04\x00\x00"), INVALID),  # a decimation of 0
        (command(0x0C, 0x28, b"\x01\x09"), INVALID),  # no such value
        (command(0x01, 0x72, b"\x02\x01"), INVALID),  # a function that this device lacks
        (command(0x01, 0x09, b"\x01\x11\x00\x00\x00\x01"), INVALID),  # no such baud rate
        (command(0x01, 0x09, b"\x02\x99"), INVALID),  # no such port
        (command(0x0C, 0x2E, b"\x02\x0d"), INVALID),  # more triggers than there are
        (command(0x0C, 0x0D, b"\x80\x00\x00"), FAILED),  # no stored format to poll
        (command(0x0C, 0x41, b"\x01\x01\x01\x01\x06"), INVALID),  # a pull-up and a pull-down
        # Values that mean all, with functions for which they do not.
        (command(0x0D, 0x50, b"\x01\xff\xff\x01"), INVALID),
        (command(0x0D, 0x50, b"\x02\xff\xff"), INVALID),
        (command(0x0C, 0x52, b"\x01\x00\x01"), INVALID),
        (command(0x0C, 0x52, b"\x02\x00"), INVALID),
        (command(0x0C, 0x53, b"\x00"), INVALID),
        (command(0x0C, 0x2B, b"\x02\x00"), INVALID),
        (command(0x0C, 0x54, b"\x02\x80\x00"), INVALID),
        # A field without a filter.
        *((command(0x0C, 0x54, bytes((function, *place))), INVALID)
          for function in (2, 3, 4, 5) for place in ((0x80, 0x11), (0, 4))),
        # What does not fit into a packet with the ACK, now or when it is read.
        *((command(0x0C, descriptor, b"\x82" + b"\x01" * 130), INVALID) for descriptor in (0x2C, 0x2D)),
        (command(0x0C, 0x0F, b"\x01\x80\x53" + b"\x04\x00\x0a" * 83), INVALID),
        (command(0x0C, 0x0C, b"\x01\x32" + b"\x01\x01\x82\x01\xf4" * 50), INVALID),
        (command(0x0C, 0x22, b"\x01\x01\x00\x00\x7b" + b"\x00\x78" * 123), INVALID),
    ],
)  # fmt: skip
def test_refusals(host: Host, data: bytes, code: int) -> None:
    assert codes(host.raw(data)) == [(data[5], code)]


def test_what_is_not_for_a_device(host: Host, old: Host) -> None:
    """One without a code for unknown sets does not know the command; replies and data are not answered."""
    assert UNKNOWN_SET not in old.device.profile.ack_codes
    assert codes(old.raw(command(0x55, 0x01))) == [(0x01, UNKNOWN)]
    assert host.raw(command(0x01, 0xF1, b"\x01\x00") + command(0x80, 0x04, bytes(12))) == []


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_refused(host: Host, number: float) -> None:
    for command in (
        mip_3dm.GyroBias.write((0.0, number, 0.0)),
        mip_3dm.SensorToVehicleTransformEuler.write(0.0, 0.0, number),
        aiding.FrameConfig.write(1, aiding.AidingFrameFormat.EULER, True, (0.0, 0.0, 0.0), (number, 0.0, 0.0)),
    ):
        assert host.refused(command) == INVALID


def test_settings_that_lead_beyond_what_data_hold() -> None:
    """The data show the largest number; the device goes on."""
    host = Host(VirtualDevice(GX5))
    host.ok(mip_3dm.GyroBias.write((3.4e38, -3.4e38, 0.0)))
    host.ok(mip_3dm.AccelBias.write((-3.4e38, 0.0, 0.0)))
    for set_number, descriptor in sorted(x for x in host.device.field_keys if 0x80 <= x[0] < 0xFF):
        host.device.send_data(set_number, [descriptor])
    (gyro,) = [f for p in Parser().feed(host.link.read()) for f in p if f[:2] == (0x80, 0x05)]
    assert sensor.ScaledGyro.decode(gyro.data).scaled_gyro[:2] == pytest.approx((-3.4e38, 3.4e38), rel=0.01)


def test_times_that_no_data_can_show_are_refused() -> None:
    host, field = Host(VirtualDevice("3dm-gx5-45")), base.GpsTimeUpdate
    week, tow = base.GpsTimeField.WEEK_NUMBER, base.GpsTimeField.TOW
    for name, last in ((week, 0xFFFF), (tow, 604_799)):
        host.ok(field.write(name, last))
        assert [host.refused(field.write(name, n)) for n in (last + 1, 2**32 - 1)] == [INVALID] * 2
    assert host.device.world.clock // (604_800 * 10**9) == 0xFFFF
    host.device.send_data(0x81, [0x08])  # its UTC


def test_a_command_without_reply_is_refused_without_one(host: Host, old: Host) -> None:
    assert host.refused(mip_3dm.PollData(0x80, False, ())) == FAILED
    assert host.raw(bytes(mip_3dm.PollData(0x80, True, ()).packet())) == []
    assert old.raw(bytes(mip_3dm.GyroBias.apply((math.nan, 0.0, 0.0)).packet())) == []


def test_a_refused_setting_changes_nothing(host: Host) -> None:
    host.stream(0x80, (0x04, 10))
    assert host.refused(mip_3dm.MessageFormat.write(0x80, rates((0x04, 20), (0x63, 20)))) == INVALID
    assert host.ok(mip_3dm.MessageFormat.read(0x80)).descriptors == rates((0x04, 10))


# --------------------------------------------------------------------------- packets


def test_several_commands_in_a_packet_are_answered_in_order(host: Host) -> None:
    packet = PacketBuilder(0x01).add(0x01).add(0x55).add(0x03).add(0x02).build()
    (answer,) = host.raw(bytes(packet))
    assert [raw.descriptor for raw in answer] == [0xF1, 0xF1, 0xF1, 0x81, 0xF1]
    assert codes([answer]) == [(0x01, OK), (0x55, UNKNOWN), (0x03, OK), (0x02, OK)]


def test_answers_that_do_not_fit_come_in_several_packets(host: Host) -> None:
    builder = PacketBuilder(0x01)
    for _ in range(7):
        builder.add(0x03)
    packets = host.raw(bytes(builder.build()))
    assert len(packets) == 4
    fields = [raw.descriptor for packet in packets for raw in packet]
    assert fields == [0xF1, 0x81] * 7
    assert all(next(iter(packet)).descriptor == 0xF1 for packet in packets)


def test_a_false_start_hides_a_command_for_a_tenth_of_a_second_only(host: Host) -> None:
    assert host.raw(bytes.fromhex("7565 01 FF") + command(0x01, 0x01)) == []
    assert host.received(0.099) == []
    assert codes(host.received(0.001)) == [(0x01, OK)]
    half = command(0x01, 0x01)
    assert host.raw(half[:5]) == host.received(0.05) == []
    assert codes(host.raw(half[5:])) == [(0x01, OK)]


def test_a_malformed_field_ends_the_packet(host: Host) -> None:
    packet = bytearray(bytes(PacketBuilder(0x01).add(0x01).add(0x02).build()))
    packet[6] = 9
    packet[-2:] = checksum(bytes(packet[:-2]))
    assert codes(host.raw(bytes(packet))) == [(0x01, OK)]
    assert not host.device.idle


def test_data_that_do_not_fit_come_in_continuation_packets(host: Host) -> None:
    wanted = [0xD3, *sorted(x for s, x in host.device.profile.fields if s == 0x82)]
    host.stream(0x82, *((x, 1000) for x in wanted))
    packets = host.received(1.0)
    assert len(packets) > 2 and {p.set for p in packets} == {0x82}
    front = [next(iter(p)) for p in packets]
    assert len(set(front)) == 1 and front[0].descriptor == 0xD3, "the shared time is repeated"
    sent = [raw.descriptor for p in packets for raw in list(p)[1:]]
    assert [x for x, _ in groupby(sent)] == wanted[1:], "a field may be sent once for each of several items"


# --------------------------------------------------------------------------- streams


def test_a_stream_has_the_base_rate_over_the_decimation(host: Host) -> None:
    host.stream(0x80, (0x04, 10), (0x05, 25))
    packets = host.received(1.0)
    fields = [raw.descriptor for p in packets for raw in p]
    assert (fields.count(0x04), fields.count(0x05)) == (100, 40)
    assert len(packets) == 120, "both in one packet where they are due together"
    host.ok(mip_3dm.DataStreamControl.write(0x80, False))
    assert host.received(1.0) == []
    host.ok(mip_3dm.DataStreamControl.write(0x80, True))
    assert len(host.received(1.0)) == 120


def test_the_old_commands_set_the_same_formats(old: Host) -> None:
    old.ok(mip_3dm.ImuMessageFormat.write(rates((0x04, 100))))
    old.ok(mip_3dm.FilterMessageFormat.write(rates((0x05, 100))))
    assert formats.of_set(old.device, 0x80) == [(0x04, 100)] and formats.of_set(old.device, 0x82) == [(0x05, 100)]
    assert {(p.set, len(list(p))) for p in old.received(1.0)} == {(0x80, 1), (0x82, 1)}
    old.ok(mip_3dm.DataStreamControl.write(1, False))
    assert {p.set for p in old.received(1.0)} == {0x82}
    assert old.ok(mip_3dm.DataStreamControl.read(1)).enabled is False
    assert (old.ok(mip_3dm.GetImuBaseRate()).rate, old.ok(mip_3dm.GetFilterBaseRate()).rate) == (1000, 500)


def test_idle_stops_streams_and_resume_goes_on(host: Host) -> None:
    host.stream(0x80, (0x04, 10))
    host.ok(base.SetIdle())
    assert host.received(1.0) == []
    host.ok(base.Resume())
    assert len(host.received(1.0)) == 100


def test_the_self_test_interrupts_the_data(host: Host) -> None:
    host.stream(0x80, (0x04, 10))
    before = host.now
    assert host.ok(base.BuiltInTest()).result == 0
    assert host.now - before >= 2.0 and len(host.data) < 10
    assert len(host.received(1.0)) == 100


def test_commands_wait_for_one_that_takes_its_time(host: Host) -> None:
    test = PacketBuilder(0x01).add(base.BuiltInTest.DESCRIPTOR).add(base.SoftReset.DESCRIPTOR).build()
    assert host.raw(bytes(test)) == host.raw(bytes(base.Ping().packet())) == []
    assert host.received(1.9) == []
    (answer,) = host.received(0.1)
    assert codes([answer]) == [(0x05, OK), (0x7E, OK)]
    assert host.raw(bytes(base.Ping().packet())) == [], "it restarts behind the answer; what waited is lost"
    host.device.advance(1.0)
    host.link.write(bytes(base.BuiltInTest().packet()) + bytes(base.Ping().packet()))
    assert codes(host.received(2.0)) == [(0x05, OK), (0x01, OK)]


def test_a_poll_sends_one_packet_behind_the_reply(host: Host) -> None:
    host.link.write(bytes(mip_3dm.PollData(0x80, False, (0xD3, 0x04, 0x63)).packet()))
    answer, data = Parser().feed(host.link.read())
    assert codes([answer]) == [(0x0D, OK)]
    assert [raw.descriptor for raw in data] == [0xD3, 0x04], "what it does not know is left out"
    host.link.write(bytes(mip_3dm.PollData(0x80, True, (0x05,)).packet()))
    (data,) = Parser().feed(host.link.read())
    assert data.set == 0x80
    host.stream(0x80, (0x04, 1000), (0x05, 500))
    host.ok(base.SetIdle())
    host.ok(mip_3dm.PollData(0x80, False, ()))
    assert [raw.descriptor for raw in host.data[-1]] == [0x04, 0x05], "of the stored format"


def test_a_poll_answers_the_host_that_asks_and_a_stream_all(host: Host) -> None:
    other = Host(host.device)
    host.ask(mip_3dm.PollData(0x80, True, (0x04,)))
    assert other.link.read() == b""
    host.stream(0x80, (0x04, 10))
    host.device.advance(1.0)
    first, second = host.link.read(), other.link.read()
    assert len(Parser().feed(second)) == 100 and first.endswith(second[-100:])


def test_factory_streaming(host: Host) -> None:
    host.stream(0x80, (0x17, 500))
    host.ok(mip_3dm.FactoryStreaming(mip_3dm.FactoryStreamingAction(2), 0))
    assert formats.of_set(host.device, 0x80)[0] == (0x17, 500) and len(formats.of_set(host.device, 0x80)) == 5
    for _ in range(19):
        host.ok(mip_3dm.FactoryStreaming(mip_3dm.FactoryStreamingAction(2), 0))
        host.ok(mip_3dm.FactoryStreaming(mip_3dm.FactoryStreamingAction(1), 0))  # all are there
    assert host.refused(mip_3dm.FactoryStreaming(mip_3dm.FactoryStreamingAction(2), 0)) == FAILED
    assert len(host.ok(mip_3dm.MessageFormat.read(0x80)).descriptors) == 81, "no packet can report more"
    host.ok(mip_3dm.FactoryStreaming(mip_3dm.FactoryStreamingAction(0), 0))
    assert len(formats.of_set(host.device, 0x80)) == 4
    assert {p.set for p in host.received(2.0)} == {s for s, _ in host.device.profile.fields if 0x80 <= s < 0xFF}


def test_a_stream_that_nobody_reads_is_dropped_whole() -> None:
    device = VirtualDevice(CV7)
    link = device.connect(capacity=1000)
    link.write(bytes(mip_3dm.MessageFormat.write(0x80, rates((0x04, 1))).packet()))
    device.advance(10.0)
    assert link.waiting <= 1000 and link.dropped > 9000
    parser = Parser()
    parser.feed(link.read())
    assert parser.skipped == parser.pending == 0


# --------------------------------------------------------------------------- particular commands


def test_a_filter_of_one_field_or_of_all(host: Host, old: Host) -> None:
    kind = mip_3dm.LowPassFilter
    at = ((0x80, 0x04), (0x80, 0x05), (0x82, 0x0D))

    def frequencies() -> list[float]:
        return [host.ok(kind.read(*place)).frequency for place in at]

    host.ok(kind.write(0, 0, True, True, 40.0))
    assert frequencies() == [40, 40, 40]
    host.ok(kind.save(0, 0))
    host.ok(kind.write(0x80, 0, True, True, 20.0))
    host.ok(kind.write(0x80, 0x05, True, True, 10.0))
    assert frequencies() == [20, 10, 40]
    host.ok(kind.load(0x80, 0))
    host.ok(kind.default(0x82, 0))
    assert frequencies() == [40, 40, 0]
    host.ok(kind.load(0, 0))
    assert frequencies() == [40, 40, 40]
    old.ok(mip_3dm.ImuLowPassFilter.write(0, True, True, 30))
    assert old.ok(mip_3dm.ImuLowPassFilter.read(0x17)).frequency == 30


def test_a_mode_is_of_one_trigger_or_of_all(host: Host) -> None:
    kind, mode = mip_3dm.EventControl, types.EventTriggerMode
    for pin in (1, 2):
        gpio = types.EventTriggerGpio(pin, types.EventTriggerGpioMode(1))
        host.ok(mip_3dm.EventTriggerConfig.write(pin + 1, types.EventTriggerType.GPIO, gpio))
    host.ok(kind.write(0, mode.ENABLED))
    assert [host.ok(kind.read(n)).mode for n in (1, 2, 3)] == [mode.DISABLED, mode.ENABLED, mode.ENABLED]
    host.ok(kind.write(2, mode.TEST_PULSE))
    assert host.ok(kind.read(2)).mode == mode.ENABLED, "after one cycle, as before"


def test_the_mounting_is_one_setting_in_three_forms(host: Host) -> None:
    host.ok(mip_3dm.SensorToVehicleTransformEuler.write(0.0, 0.0, 1.5707963705062866))
    dcm = host.ok(mip_3dm.SensorToVehicleTransformDcm.read()).dcm
    assert dcm == pytest.approx((0, -1, 0, 1, 0, 0, 0, 0, 1), abs=1e-6)
    q = host.ok(mip_3dm.SensorToVehicleTransformQuaternion.read()).q
    assert q == pytest.approx((0.7071068, 0, 0, -0.7071068), abs=1e-6), "the inverse, as the command defines it"
    host.ok(mip_3dm.SensorToVehicleTransformQuaternion.write((1.0, 0.0, 0.0, 0.0)))
    angles = host.ok(mip_3dm.SensorToVehicleTransformEuler.read())
    assert (angles.roll, angles.pitch, angles.yaw) == pytest.approx((0, 0, 0), abs=1e-6)
    assert host.refused(mip_3dm.SensorToVehicleTransformDcm.write((0.0,) * 9)) == INVALID


def test_a_frame_is_read_in_the_form_that_is_asked_for(host: Host) -> None:
    kind, form = aiding.FrameConfig, aiding.AidingFrameFormat
    host.ok(kind.write(1, form.EULER, False, (1.0, 2.0, 3.0), (0.0, 0.0, 0.5)))
    assert host.ok(kind.read(1, form.EULER)).rotation == (0.0, 0.0, 0.5)
    answer = host.ok(kind.read(1, form.QUATERNION))
    assert answer.format == form.QUATERNION
    assert answer.rotation == pytest.approx((0.9689124, 0, 0, 0.247404), abs=1e-6)
    assert answer.translation == (1.0, 2.0, 3.0)


def test_echo_control_silences_aiding(host: Host) -> None:
    now = aiding.MeasurementTime(aiding.Timebase.TIME_OF_ARRIVAL, nanoseconds=0)
    measured = aiding.TrueHeading(now, 1, 0.5, 0.1, 1)
    assert codes(host.raw(bytes(measured.packet()))) == [(measured.DESCRIPTOR, OK)]
    host.ok(aiding.EchoControl.write(aiding.AidingEchoMode.SUPPRESS_ACK))
    assert host.raw(bytes(measured.packet())) == []
    host.ok(aiding.EchoControl.default())
    assert codes(host.raw(bytes(measured.packet()))) == [(measured.DESCRIPTOR, OK)]


def test_a_baud_rate_is_of_one_port() -> None:
    device = VirtualDevice(CV7)
    host, other = Host(device, "UART 1"), Host(device, "UART 2")
    usb = device.connect("USB 1")
    assert (host.link.baud, other.link.baud, usb.baud) == (115200, 115200, None)
    host.ok(base.CommSpeed.write(0x11, 921600))
    assert (host.link.baud, other.link.baud) == (921600, 115200)
    assert host.ok(base.CommSpeed.read(0x11)).baud == 921600
    host.ok(base.CommSpeed.save(0))
    host.ok(base.CommSpeed.default(0))
    assert host.link.baud == 115200
    host.ok(base.CommSpeed.load(0x11))
    assert host.link.baud == 921600


def test_a_port_takes_and_gives_the_protocols_that_are_set() -> None:
    kind, ports = system.InterfaceControl, types.CommInterface
    mip, nmea = system.CommProtocols.MIP, system.CommProtocols.NMEA
    device = VirtualDevice(CV7)
    host, aux = Host(device), Host(device, "UART 2")
    assert aux.raw(bytes(base.Ping().packet())) == [], "an auxiliary port is closed at first"
    assert host.ok(kind.read(ports.UART_2)).protocols_incoming == 0
    host.ok(kind.write(ports.UART_2, mip, mip | nmea))
    aux.ok(base.Ping())
    assert aux.refused(kind.write(ports.UART_3, mip, mip)) == FAILED, "only the main port takes it"
    host.stream(0x80, (0x04, 10))
    assert len(aux.received(1.0)) == 100
    host.ok(kind.write(ports.UART_2, mip, system.CommProtocols(0)))
    assert aux.received(1.0) == []
    aux.ok(base.Ping())
    assert host.refused(kind.write(ports.UART_1, nmea, nmea)) == FAILED, "the main port keeps MIP"
    host.ok(kind.write(ports.UART_3, mip, mip))
    assert host.refused(kind.write(ports.USB_2, mip, mip)) == FAILED, "no more than two parsers"
    assert host.refused(kind.write(ports.UART_3, system.CommProtocols(1 << 30), mip)) == INVALID


def test_an_output_keeps_its_level(host: Host) -> None:
    host.ok(mip_3dm.GpioState.write(1, True))
    assert host.ok(mip_3dm.GpioState.read(1)).state is False, "it is not an output"
    host.ok(mip_3dm.GpioConfig.write(1, types.GpioFeature.GPIO, 3, types.GpioPinMode(0)))
    assert host.ok(mip_3dm.GpioState.read(1)).state is True
    host.ok(mip_3dm.GpioState.write(1, False))
    assert host.ok(mip_3dm.GpioState.read(1)).state is False
    assert host.refused(mip_3dm.GpioState.read(9)) == INVALID
    host.ok(mip_3dm.GpioState.write(1, True))
    host.ok(mip_3dm.PollData(0xA0, False, (system_data.GpioState.DESCRIPTOR,)))
    shown = system_data.GpioState.find(host.data[-1])
    assert shown is not None and shown.states == 1


def test_in_a_direct_mode_the_device_answers_little(old: Host) -> None:
    old.ok(mip_3dm.ImuMessageFormat.write(rates((0x04, 10))))
    old.ok(system.CommMode.write(system.ProtocolMode.SENSOR_DIRECT))
    assert old.raw(bytes(base.Ping().packet())) == old.received(1.0) == []
    assert old.ok(mip_3dm.DeviceStatus(6254, mip_3dm.DeviceStatusSelector.BASIC)).model_number == 6254
    old.ok(system.CommMode.write(system.ProtocolMode.STANDARD))
    old.ok(base.Ping())
    assert len(old.received(1.0)) == 100


@pytest.mark.parametrize(("name", "layout"), [(GX5, "diagnostic"), ("3dm-gx5-45", "diagnostic_gnss")])
def test_the_device_status_has_the_layout_of_the_device(name: str, layout: str) -> None:
    host = Host(VirtualDevice(name))
    host.device.advance(3.0)
    host.device.booted -= 10**6 << 32  # the timer counts milliseconds in 32 bits
    status = host.ok(mip_3dm.DeviceStatus(host.device.profile.model_number, mip_3dm.DeviceStatusSelector.DIAGNOSTIC))
    assert f"3dm.device_status_{layout}_response" == status.NAME and status.system_timer == 3000


# --------------------------------------------------------------------------- time, seeds, any input


def test_time_does_not_drift() -> None:
    device = VirtualDevice(CV7)
    times: list[int] = []
    device.trace = lambda what, data: times.append(device.now) if what == "data" else None
    link = device.connect(capacity=100)
    link.write(bytes(mip_3dm.MessageFormat.write(0x80, rates((0x04, 50000))).packet()))
    days = 4
    device.run_until(days * 86400 * 10**9)
    assert times == [50 * 10**9 * k for k in range(1, days * 1728 + 1)]


def test_memory_does_not_grow() -> None:
    device = VirtualDevice(CV7)
    link = device.connect(capacity=0)  # all is dropped, as if a host had read it
    streams = {0x80: (0xD5, 0xD6, 4, 5, 7, 8, 10, 12), 0x82: (0xD3, 1, 2, 5, 0x10), 0x91: (3, 7, 11, 0x20)}
    for set_number, fields in streams.items():  # the last one is of several items
        link.write(bytes(mip_3dm.MessageFormat.write(set_number, rates(*((x, 1) for x in fields))).packet()))
    device.advance(2.0)
    before = sys.getallocatedblocks()
    device.advance(4.0)
    assert sys.getallocatedblocks() - before < 500, "6,000 packets and more"


def test_any_bytes_are_taken() -> None:
    chance = random.Random(1)
    for name in (CV7, GX5, "3dm-gx5-45", "3dm-gq7"):
        host = Host(VirtualDevice(name))
        known = sorted(host.device.field_keys)
        for _ in range(rounds(300, 1500)):
            set_number, descriptor = chance.choice(known) if chance.random() < 0.9 else (chance.randrange(1, 128), 1)
            data = bytes(chance.choice((0, 1, 2, 3, 4, 5, 0x80, 0xFF)) for _ in range(chance.randrange(24)))
            if set_number < 0x80 and (set_number, descriptor) != (0x01, 0x7E):
                host.raw(bytes(PacketBuilder(set_number).add(descriptor, data).build()))
            else:
                host.raw(chance.randbytes(30))
            host.device.advance(0.01)
            for packet in Parser().feed(host.link.read()):
                for raw in packet:
                    assert decoded(raw) is not None
        host.device.advance(20.0)


def decoded(raw: RawField) -> Any:
    try:
        return registry.decode(raw)
    except DecodeError as error:
        raise AssertionError(f"{raw}: {error}") from None


def test_closed_links_say_so(host: Host) -> None:
    host.device.disconnect(host.link)
    with pytest.raises(ConnectionError, match="connect again"):
        host.link.write(b"x")
    with pytest.raises(Failure, match="has no port 'UART 9'; its ports: Main, UART 1"):
        host.device.connect("UART 9")


def test_commands_of_other_firmware_are_unknown() -> None:
    """It reports 7.0.00, and the 3DM-CV7-AHRS has the older command only up to 1.0.07."""
    host = Host(VirtualDevice("3dm-cv7-ahrs"))
    assert host.ok(base.GetDeviceInfo()).device_info.firmware_version == 7000
    assert host.refused(mip_3dm.ImuLowPassFilter.read(0x04)) == types.AckCode.UNKNOWN_COMMAND
    listed = {*host.ok(base.GetDeviceDescriptors()).descriptors, *host.ok(base.GetExtendedDescriptors()).descriptors}
    assert 0x0C54 in listed and 0x0C50 not in listed
