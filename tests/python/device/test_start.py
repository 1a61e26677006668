"""`Device.stream`: data at rates in Hz, in one call, on devices of all generations."""

from __future__ import annotations

import asyncio
import math
from itertools import islice, pairwise

import pytest
from both import Kind, Peer, acknowledge, packet
from mip_protocol import (
    EncodeError,
    NoSuchRate,
    Refused,
    aio,
    base,
    filter_data,
    gnss_data,
    mip_3dm,
    open_port,
    sensor,
    shared,
)
from mip_protocol.devices import DEVICES
from mip_protocol.streaming import decimation, set_of, steps
from support import PATIENCE, simulated, some
from timed_packets import Case, cases_of_devices

CV7, GX5 = "3dm-cv7-gnss-ins", "3dm-gx5-15"


@pytest.mark.parametrize("model", [CV7, GX5])
def test_data_at_a_rate(model: str) -> None:
    with simulated("--tcp", "0", device=model) as place, open_port(place, timeout=PATIENCE) as device:
        rates = device.stream({sensor.ScaledAccel: 100, sensor.ScaledGyro: 50})
        stamp = shared.ReferenceTimestamp if model == CV7 else sensor.GpsTimestamp
        assert rates == {sensor.ScaledAccel: 100, sensor.ScaledGyro: 50, stamp: 100}
        device.clear()
        packets = [device.next(PATIENCE) for _ in range(40)]
        assert all(packet and packet.find(stamp) for packet in packets)
        assert 20 <= sum(bool(p and p.find(sensor.ScaledGyro)) for p in packets) <= 21
        rates = device.stream({filter_data.EulerAngles: 0})
        assert rates[filter_data.EulerAngles] in (500, 1000)


def test_what_a_rate_changes() -> None:
    """Shared fields come first; a rate that the device does not have changes nothing."""
    with simulated("--tcp", "0") as place, open_port(place, timeout=PATIENCE) as device:
        device.stream({sensor.ScaledAccel: 10, shared.GpsTimestamp: 10})
        device.clear()
        arrival = next(a for a in device if a.packet.set == 0x80)
        assert [f.descriptor for f in arrival.packet] == [shared.GpsTimestamp.DESCRIPTOR, sensor.ScaledAccel.DESCRIPTOR]
        with pytest.raises(NoSuchRate) as caught:
            device.stream({sensor.ScaledGyro: 70, sensor.ScaledMag: 10})
        nearest = caught.value.nearest
        assert nearest[sensor.ScaledMag] == 10 and 71 < nearest[sensor.ScaledGyro] < 72
        assert "sensor.scaled_gyro at 70 Hz (nearest: 71.429" in str(caught.value)
        assert "scaled_mag" not in str(caught.value)
        device.clear()
        assert next(a for a in device if a.packet.set == 0x80).find(sensor.ScaledAccel)  # nothing has changed
        assert device.stream({sensor.ScaledGyro: nearest[sensor.ScaledGyro]})  # the rate in the error
        assert device.stream({sensor.ScaledGyro: 71.43})  # as it is read there


def test_with_asyncio() -> None:
    async def run(place: str) -> None:
        async with aio.open_port(place, timeout=PATIENCE) as device:
            rates = {sensor.ScaledAccel: 100}
            assert await device.stream(rates) == {**rates, sensor.GpsTimestamp: 100}
            assert await device.stream(rates, timestamp=None) == rates
            with pytest.raises(NoSuchRate):
                await device.stream({sensor.ScaledAccel: 70})
            with pytest.raises(Refused):  # it has no such receiver
                await device.stream({gnss_data.LlhPosition: 1}, set=0x95)

    with simulated("--tcp", "0", device=GX5) as place:
        asyncio.run(run(place))


@pytest.mark.parametrize("model, clocks", [(CV7, ("reference", "gps")), (GX5, ("device", "device"))])
def test_the_time_of_fields(model: str, clocks: tuple[str, str]) -> None:
    """The first timestamp that the device accepts is one that is always valid, if it has one."""
    with simulated("--tcp", "0", device=model) as place, open_port(place, timeout=PATIENCE) as device:
        for timestamp, clock in zip(("auto", "gps"), clocks):
            device.stream({sensor.ScaledAccel: 100, sensor.ScaledGyro: 10}, timestamp=timestamp)
            stamps = [stamp for stamp, _ in islice(device.fields(sensor.ScaledAccel), 12)]
            assert {stamp.clock for stamp in stamps} == {clock}
            assert [b.device - a.device for a, b in pairwise(stamps)] == pytest.approx([0.01] * 11, abs=1e-6)
            assert all(a.arrived <= b.arrived for a, b in pairwise(stamps))
        device.stream({sensor.ScaledAccel: 100}, timestamp=None)
        stamp, _ = next(device.fields(sensor.ScaledAccel))
        assert math.isnan(stamp.device) and stamp.clock == "" and stamp.arrived > 0
        with pytest.raises(ValueError, match="'utc' is not a clock; use one of gps, external"):
            device.stream({sensor.ScaledAccel: 100}, timestamp="utc")
        device.stream({sensor.ScaledAccel: 100, sensor.ScaledGyro: 10})
        stored = mip_3dm.MessageFormat.read(0x80) if model == CV7 else mip_3dm.ImuMessageFormat.read()
        first = shared.ReferenceTimestamp if model == CV7 else sensor.GpsTimestamp  # of what follows it
        assert device.request(stored).descriptors[0].descriptor == first.DESCRIPTOR
        assert device.stream({}, set=0x80) == {}  # clears the message format
        assert device.request(stored).descriptors == ()


@pytest.mark.parametrize("name", ["threads", "asyncio"])
def test_times_are_read_as_those_of_the_model(name: str) -> None:
    """Each model, after it has said what it is; before, and after the program has named another one."""
    other = {"3dm-cv7-ahrs": "3dm-gx5-15"}
    by_model: dict[str, list[Case]] = {}
    for case in cases_of_devices():
        by_model.setdefault(case[0] or "", []).append(case)
    for model_id, cases in by_model.items():
        wanted = [("", None) if d is None and o is None else ("gps", d) if d else ("device", o) for *_, d, o in cases]
        peer = Peer()
        with Kind(name).at(peer.near) as device:
            assert device.model is None
            if model_id:
                title = DEVICES[model_id].title.encode().ljust(16)
                number = str(DEVICES[model_id].model_number).encode().ljust(16)
                reply = packet(0x01, "f1 03 00", f"810000{(title + number).hex()}{'20' * 48}")
                peer.answering(*[reply] * (1 + (model_id in other)))
                device.request(base.GetDeviceInfo())
                assert device.model == model_id
            peer.send(*(data for _, data, *_ in cases))
            arrivals = [device.next(PATIENCE) for _ in cases]
            for arrival, (clock, time) in zip(arrivals, wanted, strict=True):
                stamp = arrival.stamp()
                assert (stamp.clock, stamp.device) == (
                    clock,
                    pytest.approx(time / 1e9) if time else pytest.approx(math.nan, nan_ok=True),
                )
                assert clock not in ("gps", "device") or arrival.device_time(clock) == time
            if model_id in other:
                (device.device if name == "asyncio" else device).model = "GX5-15"
                device.request(base.GetDeviceInfo())
                assert device.model == other[model_id]  # the program's word counts
                peer.send(cases[4][1])
                assert device.next(PATIENCE).model == other[model_id]
        peer.close()


@pytest.mark.parametrize("model", [CV7, GX5])
def test_a_stream_asks_for_the_model(model: str) -> None:
    with simulated("--tcp", "0", device=model) as place, open_port(place, timeout=PATIENCE) as device:
        device.stream({sensor.ScaledAccel: 100})
        device.clear()
        assert some(device.next(PATIENCE)).model == device.model == model


def test_packets_in_the_old_format_are_discarded(kind: Kind, peer: Peer) -> None:
    """Those of the set that waited, of which nothing is lost in a recording; others are kept."""
    old, other, new = packet(0x80, "06 00000000"), packet(0x82, "10 0002 0000 0000"), packet(0x80, "04" + "00" * 12)
    replies = packet(0x01, "f1 03 01"), packet(0x0C, "f1 0e 00", "8e 80 01f4"), acknowledge(0x0C, 0x0F)
    read = bytearray()
    with kind.at(peer.near, on_bytes=read.extend) as device:
        started = [*replies[:2], old + other + replies[2], acknowledge(0x0C, 0x11) + new, acknowledge(0x01, 0x06)]
        peer.answering(*started)
        device.stream({sensor.ScaledAccel: 100}, timestamp=None)
        assert [bytes(device.next(PATIENCE).packet) for _ in range(2)] == [other, new] and not device.waiting
    assert read == b"".join(started)


def test_a_clock_that_the_device_lacks(kind: Kind) -> None:
    with simulated("--tcp", "0", device="3dm-gx5-45") as place, kind.open(place, timeout=PATIENCE) as device:
        lacks = r"send shared.reference_timestamp \(clock: reference\); it has the clocks: gps, device$"
        with pytest.raises(Refused, match=lacks):
            device.stream({sensor.ScaledAccel: 100}, timestamp="reference")


def test_a_device_that_does_not_say_its_model_streams() -> None:
    peer = Peer()
    with Kind("threads").at(peer.near) as device:
        rejected, done = acknowledge(0x01, 0x03, 1), [acknowledge(0x0C, 0x0F), acknowledge(0x0C, 0x11)]
        rate = packet(0x0C, "f1 0e 00", "8e 80 01f4")
        peer.answering(rejected, rate, *done, acknowledge(0x01, 0x06))
        assert device.stream({sensor.ScaledAccel: 100}, timestamp=None) == {sensor.ScaledAccel: 100}
        assert device.model is None
    peer.close()


def test_the_set() -> None:
    assert set_of({sensor.ScaledAccel: 1, shared.GpsTimestamp: 1}, None) == 0x80
    assert set_of({gnss_data.LlhPosition: 1}, 0x91) == 0x91
    assert set_of({shared.GpsTimestamp: 1}, 0x82) == 0x82
    for rates in ({gnss_data.LlhPosition: 1}, {shared.GpsTimestamp: 1}, {}):
        with pytest.raises(ValueError, match="`set` is needed"):
            set_of(rates, None)
    with pytest.raises(ValueError, match="are in no common set; call stream once for each set"):
        set_of({sensor.ScaledAccel: 1, filter_data.EulerAngles: 1}, None)
    with pytest.raises(TypeError, match="is not a type of field"):
        set_of({"sensor.scaled_accel": 1}, None)  # type: ignore[dict-item]
    with pytest.raises(EncodeError, match="does not occur in the set 0x82"):
        set_of({sensor.ScaledAccel: 1}, 0x82)
    for wrong in (-1.0, float("nan")):
        with pytest.raises(ValueError, match="a rate must be 0"):
            set_of({sensor.ScaledAccel: wrong}, None)


def test_decimations_are_the_nearest() -> None:
    for rate in (1, 10, 500, 1000):
        for wanted in (0.02, 3, 99.5, 900, 5000):
            best = (
                min(range(1, 0x10000), key=lambda by: (abs(rate / by - wanted), by))
                if wanted * 70000 > rate
                else 0xFFFF
            )
            assert decimation(rate, wanted) == best, (rate, wanted)
    assert decimation(0, 5) == decimation(1000, 0) == 1


def test_without_these_commands() -> None:
    with pytest.raises(NotImplementedError):
        next(steps(None, {sensor.ScaledAccel: 1}, None, None))
