"""Event triggers and actions of the simulated device, as the manual of the 3DM-CV7 describes them."""

from __future__ import annotations

import math

import pytest
from mip_protocol import base, filter_data, mip_3dm, shared, types
from mip_protocol.field import Command
from mip_tools.simulator import VirtualDevice
from simulator_host import Host

CV7 = "3dm-cv7-gnss-ins"
INVALID, FAILED = 3, 4
EDGE, HIGH = types.EventTriggerGpioMode.EDGE, types.EventTriggerGpioMode.WHILE_HIGH
MODES = types.EventTriggerMode
PINS = types.EventActionGpioMode


@pytest.fixture
def host() -> Host:
    return Host(VirtualDevice(CV7))


def gpio(pin: int, behavior: int, pull_up: bool = False) -> Command:
    return mip_3dm.GpioConfig.write(pin, types.GpioFeature.GPIO, behavior, types.GpioPinMode(4 * pull_up))


def on_pin(instance: int, pin: int, mode: types.EventTriggerGpioMode) -> Command:
    condition = types.EventTriggerGpio(pin, mode)
    return mip_3dm.EventTriggerConfig.write(instance, types.EventTriggerType.GPIO, condition)


def inside(instance: int, field: tuple[int, int, int], low: float, high: float) -> Command:
    window = types.EventThresholdWindow(low, high)
    condition = types.EventTriggerThreshold(*field, types.EventThresholdType.WINDOW, window)
    return mip_3dm.EventTriggerConfig.write(instance, types.EventTriggerType.THRESHOLD, condition)


def every(instance: int, field: tuple[int, int, int], threshold: float, interval: float) -> Command:
    repeated = types.EventThresholdInterval(threshold, interval)
    condition = types.EventTriggerThreshold(*field, types.EventThresholdType.INTERVAL, repeated)
    return mip_3dm.EventTriggerConfig.write(instance, types.EventTriggerType.THRESHOLD, condition)


def combined(instance: int, table: int, *inputs: int) -> Command:
    condition = types.EventTriggerCombination(table, inputs)
    return mip_3dm.EventTriggerConfig.write(instance, types.EventTriggerType.COMBINATION, condition)


def switching(instance: int, trigger: int, pin: int, mode: types.EventActionGpioMode) -> Command:
    effect = types.EventActionGpio(pin, mode)
    return mip_3dm.EventActionConfig.write(instance, trigger, types.EventActionType.GPIO, effect)


def sending(instance: int, trigger: int, decimation: int, *fields: int, set_number: int = 0x80) -> Command:
    message = types.EventActionMessage(set_number, decimation, fields)
    return mip_3dm.EventActionConfig.write(instance, trigger, types.EventActionType.MESSAGE, message)


def enable(instance: int, mode: types.EventTriggerMode = MODES.ENABLED) -> Command:
    return mip_3dm.EventControl.write(instance, mode)


def setup(host: Host, *commands: Command) -> None:
    for command in commands:
        host.ok(command)
    host.data.clear()


def levels(host: Host, pin: int, milliseconds: int) -> list[bool]:
    """The level after each event cycle."""
    found = []
    for _ in range(milliseconds):
        host.device.advance(0.001)
        found.append(host.device.world.level(pin))
    return found


def level(host: Host, pin: int) -> bool:
    host.device.advance(0.002)
    return bool(host.ok(mip_3dm.GpioState.read(pin)).state)


def sent(host: Host, seconds: float) -> int:
    """The number of packets of data."""
    host.device.advance(seconds)
    before = len(host.data)
    host.ok(base.Ping())
    return len(host.data) - before


def active(host: Host, instance: int) -> bool:
    host.device.advance(0.002)
    (status,) = host.ok(mip_3dm.GetEventTriggerStatus((instance,))).triggers
    return bool(status.status & types.EventTriggerStatus.ACTIVE)


def test_a_pin_enables_a_stream_at_a_rate(host: Host) -> None:
    setup(host, gpio(1, 1), on_pin(1, 1, HIGH), sending(1, 1, 10, 0x04), enable(1))
    assert sent(host, 1.0) == 0
    host.device.drive(1, True)
    assert sent(host, 1.0) == pytest.approx(100, abs=1) and active(host, 1)
    host.device.drive(1, False)
    host.device.advance(0.002)
    sent(host, 0)
    assert sent(host, 1.0) == 0 and not active(host, 1)


def test_a_trigger_in_use_must_be_enabled_and_idle_devices_send_nothing(host: Host) -> None:
    setup(host, gpio(1, 1, pull_up=True), on_pin(1, 1, HIGH), sending(1, 1, 10, 0x04))
    assert sent(host, 0.1) == 0
    host.ok(enable(1))
    assert sent(host, 0.1) > 0, "the pull-up makes the pin high"
    host.ok(base.SetIdle())
    sent(host, 0)
    assert sent(host, 0.1) == 0
    host.ok(base.Resume())
    assert sent(host, 0.1) > 0
    host.ok(enable(1, MODES.DISABLED))
    sent(host, 0)
    assert sent(host, 0.1) == 0


def test_a_packet_shows_the_time_of_its_edge(host: Host) -> None:
    stamp = mip_3dm.GpioConfig.write(1, types.GpioFeature.TIMESTAMP, 2, types.GpioPinMode.PULLUP)
    setup(host, stamp, on_pin(2, 1, EDGE), sending(3, 2, 0, 0xD0, 0xD5, 0xD6, 0x04), enable(2))
    for seconds in (0.0105, 0.0203):
        host.device.run_until(round(seconds * 1e9))
        host.device.drive(1, False)
        host.device.advance(0.0003)
        host.device.drive(1, True)
        host.device.advance(0.005)
    host.ok(base.Ping())
    times = [shared.ReferenceTimestamp.find(p) for p in host.data]
    assert [t.nanoseconds for t in times if t] == [10_500_000, 20_300_000], "of falling edges, not of cycles"
    sources = [shared.EventSource.find(p) for p in host.data]
    assert [s.trigger_id for s in sources if s] == [2, 2]
    deltas = [shared.ReferenceTimeDelta.find(p) for p in host.data]
    assert deltas[1] is not None and deltas[1].dt_nanos == 9_800_000


def test_actions_and_streams_count_time_on_their_own(host: Host) -> None:
    rates = (types.DescriptorRate(0xD6, 5),)
    setup(host, mip_3dm.MessageFormat.write(0x80, rates), every(1, (0x80, 0xD5, 1), 0, 7e6))
    setup(host, sending(1, 1, 0, 0xD0, 0xD6), enable(1))
    host.device.advance(0.1)
    host.ok(base.Ping())
    spans = {"stream": set[int](), "event": set[int]()}
    for packet in host.data[10:]:
        delta = shared.ReferenceTimeDelta.find(packet)
        assert delta is not None
        spans["event" if shared.EventSource.find(packet) else "stream"].add(delta.dt_nanos)
    assert spans == {"stream": {5_000_000}, "event": {7_000_000}}


def test_a_window_and_its_reverse(host: Host) -> None:
    euler = (0x82, filter_data.EulerAngles.DESCRIPTOR, 1)
    setup(host, inside(1, euler, -0.5, 0.5), inside(2, euler, 0.5, -0.5), enable(1), enable(2))
    assert (active(host, 1), active(host, 2)) == (True, False)
    turned = mip_3dm.SensorToVehicleTransformEuler.write(math.pi / 2, 0.0, 0.0)
    host.ok(turned)
    assert (active(host, 1), active(host, 2)) == (False, True)


def test_an_interval_is_a_square_wave_at_a_pin(host: Host) -> None:
    time = (0x80, 0xD5, 1)
    setup(host, gpio(1, 2), switching(1, 1, 1, PINS.ACTIVE_HIGH), every(1, time, 2_999_999.0, 1e7), enable(1))
    host.device.run_until(1_000_000_000 - 1)
    assert levels(host, 1, 20) == [True] * 3 + [False] * 7 + [True] * 3 + [False] * 7
    setup(host, every(1, time, 1e7, 2_999_999.0), enable(1))  # reversed
    host.device.run_until(2_000_000_000 - 1)
    assert levels(host, 1, 10) == [False] * 3 + [True] * 7


def test_pins_follow_triggers_in_each_mode(host: Host) -> None:
    setup(host, gpio(1, 1), on_pin(1, 1, HIGH), enable(1))
    wanted = {
        PINS.ACTIVE_HIGH: [False, True, False, True],
        PINS.ACTIVE_LOW: [True, False, True, False],
        PINS.ONESHOT_HIGH: [False, True, True, True],
        PINS.ONESHOT_LOW: [False, False, False, False],
        PINS.TOGGLE: [False, True, True, False],
        PINS.DISABLED: [False, False, False, False],
    }
    for mode, expected in wanted.items():
        setup(host, gpio(2, 2), switching(1, 1, 2, mode))
        found = []
        for high in (False, True, False, True):
            host.device.drive(1, high)
            found.append(level(host, 2))
        host.device.drive(1, False)
        assert found == expected, mode.name
    setup(host, gpio(2, 3), switching(1, 1, 2, PINS.ONESHOT_LOW))
    assert level(host, 2)
    host.device.drive(1, True)
    assert not level(host, 2)


def test_inputs_of_a_combination_are_bits_of_a_row(host: Host) -> None:
    setup(host, gpio(1, 1), gpio(2, 1), on_pin(1, 1, HIGH), on_pin(2, 2, HIGH), enable(1), enable(2))
    for table in (0x0001, 0x0002, 0x0004, 0x0008, 0x6666):
        setup(host, combined(3, table, 1, 2, 0, 0), enable(3))
        for row in range(4):
            host.device.drive(1, bool(row & 1))
            host.device.drive(2, bool(row & 2))
            assert active(host, 3) == bool(table >> row & 1), (table, row)


def test_a_test_pulse_lasts_one_cycle_and_the_mode_returns(host: Host) -> None:
    setup(host, gpio(1, 1), gpio(2, 2), on_pin(1, 1, HIGH), switching(1, 1, 2, PINS.ACTIVE_HIGH), enable(1))
    host.ok(enable(1, MODES.TEST_PULSE))
    assert levels(host, 2, 10).count(True) == 1
    assert host.ok(mip_3dm.EventControl.read(1)).mode == MODES.ENABLED
    setup(host, enable(1, MODES.DISABLED), enable(1, MODES.TEST_PULSE))
    host.device.advance(0.01)
    assert host.ok(mip_3dm.EventControl.read(1)).mode == MODES.DISABLED
    setup(host, sending(2, 1, 0, 0x04), enable(1, MODES.TEST))
    assert sent(host, 0.1) == 1 and level(host, 2)


def test_what_the_device_does_not_send_is_refused(host: Host) -> None:
    assert host.refused(inside(1, (0x80, 0x04, 4), 0, 1)) == INVALID, "three numbers"
    assert host.refused(inside(1, (0x80, 0x7F, 1), 0, 1)) == INVALID
    assert host.refused(sending(1, 1, 0, 0x7F)) == INVALID
    assert host.refused(sending(1, 1, 0, 0x04, set_number=0x99)) == INVALID


def test_saved_events_work_after_a_restart(host: Host) -> None:
    setup(host, gpio(1, 1), on_pin(1, 1, HIGH), sending(1, 1, 10, 0x04), enable(1))
    host.ok(mip_3dm.DeviceSettings.save())
    host.device.drive(1, True)
    host.device.reset()
    host.link.read()
    host.device.advance(0.45)
    assert host.link.read() == b"", "it boots"
    host.device.advance(0.15)
    assert sent(host, 1.0) > 90
    host.ok(mip_3dm.DeviceSettings.default())
    sent(host, 0)
    assert sent(host, 0.5) == 0


def test_only_so_many_triggers_and_actions_of_each_type(host: Host) -> None:
    """As many as the device lists in its reply about supported events."""

    def most(query: mip_3dm.EventSupportQuery) -> dict[int, int]:
        return {entry.type: entry.count for entry in host.ok(mip_3dm.GetEventSupport(query)).entries}

    triggers = (
        lambda i: on_pin(i, 1, HIGH),
        lambda i: inside(i, (0x80, 4, 1), 0, 1),
        lambda i: combined(i, 2, 1, 0, 0, 0),
    )
    actions = (lambda i: switching(i, 1, 1, PINS.TOGGLE), lambda i: sending(i, 1, 0, 4))
    for query, kinds, none in (
        (
            mip_3dm.EventSupportQuery.TRIGGER_TYPES,
            triggers,
            mip_3dm.EventTriggerConfig.write(1, types.EventTriggerType.NONE, None),
        ),
        (
            mip_3dm.EventSupportQuery.ACTION_TYPES,
            actions,
            mip_3dm.EventActionConfig.write(1, 0, types.EventActionType.NONE, None),
        ),
    ):
        supported = most(query)
        assert list(supported) == list(range(1, len(kinds) + 1))
        for number, make in enumerate(kinds, 1):
            host.ok(mip_3dm.DeviceSettings.default())
            count = supported[number]
            for instance in range(1, count + 1):
                host.ok(make(instance))
            assert host.refused(make(count + 1)) == FAILED
            host.ok(make(count))  # again
            host.ok(kinds[number % len(kinds)](count + 1))  # of another type
            assert host.refused(make(count + 1)) == FAILED
            host.ok(none)
            host.ok(make(count + 1))  # which is free now


def test_only_so_many_fields_in_the_packet_of_an_action(host: Host) -> None:
    host.ok(sending(1, 1, 0, *[4] * 12))
    assert host.refused(sending(1, 1, 0, *[4] * 13)) == INVALID
