"""The time of a device: with a pulse per second and a source of time, and without."""

from __future__ import annotations

import pytest
from mip_protocol import base, devices, mip_3dm
from mip_protocol.base import GpsTimeField
from mip_simulator import ScriptedEvent, VirtualDevice
from mip_simulator.surroundings.surroundings import START
from simulated import Host, show

WEEK = START // (604_800 * 10**9)
#: Pulse, time initialized, time of week and week valid: bit 1 toggles.
FIVE_BITS, THREE_BITS, TOGGLES = 0x1D, 0x05, 0x02


def flags(device: VirtualDevice, name: str = "shared.gps_timestamp") -> int:
    return int(show(device, name).valid_flags)


def update(host: Host, *fields: GpsTimeField) -> None:
    for field in fields:
        host.ok(base.GpsTimeUpdate.write(field, 2400 if field == GpsTimeField.WEEK_NUMBER else 345_600))


@pytest.mark.parametrize(
    "name, sync, field, expected",
    [
        ("3dm-gx5-25", None, "sensor.gps_timestamp", 0),
        ("3dm-gx5-25", True, "sensor.gps_timestamp", THREE_BITS),
        ("3dm-gx5-25", None, "filter_data.timestamp", 0),
        ("3dm-gx5-25", True, "filter_data.timestamp", 1),
        ("3dm-gx5-45", None, "sensor.gps_timestamp", THREE_BITS),
        ("3dm-gx5-45", False, "sensor.gps_timestamp", 0),
        ("3dm-gx5-45", False, "gnss_data.gps_time", 0),
        ("3dm-cv7-ahrs", None, "shared.gps_timestamp", 0),
        ("3dm-cv7-ahrs", True, "shared.gps_timestamp", 3),
        ("3dm-cv7-ahrs", None, "shared.external_timestamp", 0),
        ("3dm-cv7-gnss-ins", None, "sensor.gps_timestamp", FIVE_BITS),
        ("3dm-cv7-gnss-ins", None, "shared.external_time_delta", 1),
        ("3dm-cv7-gnss-ins", False, "sensor.gps_timestamp", 0),
    ],
)
def test_flags_and_times_follow_the_source(name: str, sync: bool | None, field: str, expected: int) -> None:
    device = VirtualDevice(name, sync=sync)
    device.advance(1.25)
    stamp = show(device, field)
    assert int(stamp.valid_flags) & ~(TOGGLES if field == "sensor.gps_timestamp" else 0) == expected
    if hasattr(stamp, "tow"):
        nothing = 0.0 if field.startswith("gnss") else 1.25
        assert (stamp.week_number, stamp.tow) == ((WEEK, 1.25) if expected else (0, nothing))


def test_the_host_sets_the_time() -> None:
    """A device that selects its pulse needs one; those of generation 5 show a time that was set once."""
    old, new = Host(VirtualDevice("3dm-gx5-25")), Host(VirtualDevice("3dm-cv7-ahrs"))
    both = GpsTimeField.WEEK_NUMBER, GpsTimeField.TOW
    update(old, both[0])
    assert not flags(old.device, "sensor.gps_timestamp") & THREE_BITS, "only the week"
    update(old, both[1])
    assert flags(old.device, "sensor.gps_timestamp") & THREE_BITS == 4, "there is no pulse"
    assert show(old.device, "sensor.gps_timestamp").week_number == 2400
    update(new, *both)
    assert flags(new.device) == 0
    new.ok(mip_3dm.PpsSourceControl.write(4))
    assert show(new.device, "system_data.time_sync_status").time_sync and flags(new.device) == 0, "a new source"
    update(new, both[1])
    assert flags(new.device) == 1, "only the time of week"
    update(new, both[0])
    assert flags(new.device) == 3 and flags(new.device, "shared.external_timestamp") == 1
    assert show(new.device, "shared.gps_timestamp").week_number == 2400
    new.ok(base.SoftReset())
    new.device.advance(1)
    assert flags(new.device) == 0 and show(new.device, "shared.gps_timestamp").week_number == 0


@pytest.mark.parametrize("name, sync", [("3dm-cv7-gnss-ins", None), ("3dm-cv7-ahrs", True)])
def test_without_a_pulse_there_is_no_valid_time(name: str, sync: bool | None) -> None:
    host = Host(VirtualDevice(name, sync=sync))
    host.ok(mip_3dm.PpsSourceControl.write(0))
    assert flags(host.device) == flags(host.device, "shared.external_timestamp") == 0
    assert not show(host.device, "system_data.time_sync_status").time_sync
    host.ok(mip_3dm.PpsSourceControl.default())
    assert flags(host.device) == 3


def test_a_receiver_sets_the_time_at_its_first_fix() -> None:
    device = VirtualDevice(
        "3dm-gx5-45", events=[ScriptedEvent("gnss_outage", 0, 5), ScriptedEvent("gnss_outage", 8, 2)]
    )
    times = []
    for _ in range(10):
        device.advance(1)
        stamp = show(device, "sensor.gps_timestamp")
        times.append((stamp.week_number, stamp.tow, int(stamp.valid_flags) & ~TOGGLES))
    assert times[3:5] == [(0, 4.0, 0), (WEEK, 5.0, THREE_BITS)]
    assert times[8] == (WEEK, 9.0, 4), "the clock runs on without the pulse"


@pytest.mark.parametrize("name", sorted(devices.DEVICES))
def test_every_device_has_baud_rates(name: str) -> None:
    device = VirtualDevice(name)
    host, port = Host(device), device.ports[0].id or 0x11
    if device.knows("base.comm_speed") and name != "3dm-cv7-gnss-ins":  # its first port has no number of its own
        host.ok(base.CommSpeed.write(port, 115_200))
    if device.knows("3dm.uart_baud_rate"):
        host.ok(mip_3dm.UartBaudRate.write(115_200))
        assert host.refused(mip_3dm.UartBaudRate.write(12_345)) == 3
