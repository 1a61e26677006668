"""Times by clock and the validity of values in JavaScript, compared with those of Python."""

from __future__ import annotations

import random
from collections.abc import Iterable
from typing import Any

import random_values
from javascript.test_javascript import answers as of_script
from mipgen.lower import codec
from packages import mip, real
from support import SEED, model, small, uses
from timed_packets import cases_of_devices, leap_seconds, packet, random_packet

pytestmark = uses("node")
PACKAGES = {"real": real, "invented": mip}


def answers(spec: str, packets: Iterable[tuple[bytes | str, str | None]]) -> list[dict[str, Any]]:
    words = ((x if isinstance(x, str) else x.hex(), device or "") for x, device in packets)
    return of_script("times", spec, (" ".join(line).rstrip() for line in words))


@small("the real modules of JavaScript")
def test_times_are_those_of_python(spec: str) -> None:
    of, package, chance = model(spec), PACKAGES[spec], random.Random(SEED)
    names = {name for clock in of.protocol.clocks for name in clock.timestamps}
    timestamps = list(filter(None, map(of.field, sorted(names))))
    devices = [None, None, "no-such-device", *(d.id for d in of.devices)]
    packets = [(random_packet(chance, of, timestamps), chance.choice(devices)) for _ in range(1500)]
    seen: dict[str, int] = {}
    for (data, device), found in zip(packets, answers(spec, packets), strict=True):
        moments = package.timestamps.moments(package.packet.Packet(data), device)
        wanted = {clock: None if time is None else str(time) for clock, time in moments.items()}
        assert found["classes"] == found["model"] == wanted, (data.hex(), device)
        for clock, time in moments.items():
            seen[clock] = seen.get(clock, 0) + (time is not None)
    assert seen.keys() == {c.name for c in of.protocol.clocks} and min(seen.values()) > 0, seen


def test_a_log_is_read_in_one_way() -> None:
    """Flags 5 are those of older devices, until a later packet has more bits."""
    packets = [
        (bytes(real.sensor.GpsTimestamp(345600.0, 2300, flags).packet()), None) for flags in (0, 5, 7, 0x1D, 5, 0x1D)
    ]
    alone, log = [False, True, True, True, True, True], [False, True, True, True, False, True]
    for how, wanted in (("classes", alone), ("model", alone), ("log", log), ("modelLog", log)):
        assert [x[how]["gps"] is not None for x in answers("real", packets)] == wanted, how


def test_times_of_devices() -> None:
    cases = cases_of_devices()
    for (_, data, date, device), found in zip(cases, answers("real", [(c[1], c[0]) for c in cases]), strict=True):
        for how in ("classes", "model"):
            read = [found[how].get(clock) for clock in ("gps", "device")]
            assert [None if time is None else int(time) for time in read] == [date, device], (data.hex(), how)


def test_gps_time_to_utc_across_every_leap_second() -> None:
    leaps = leap_seconds()
    found = answers("real", [(f"utc {time}", None) for time, _ in leaps])
    assert [(x["classes"], x["model"]) for x in found] == [(str(utc), str(utc)) for _, utc in leaps]


@small("the real modules of JavaScript")
def test_validity_is_that_of_python(spec: str) -> None:
    of, package, chance = model(spec), PACKAGES[spec], random.Random(SEED)
    flagged = [f for f in of.fields if any(p.valid for p in f.parameters)]
    devices = [None, None, *(d.id for d in of.devices)]
    packets = []
    for f in flagged:
        for _ in range(12 if len(flagged) > 10 else 200):
            data = codec.encode(f, random_values.record(chance, f.parameters, 120))
            number = f.sets[0] if f.sets[0] < 0xFF else 0x80
            packets.append((packet(number, (f.descriptor, data)), chance.choice(devices)))
    seen = [0, 0]
    for (data, device), found in zip(packets, answers(spec, packets), strict=True):
        for name, answer in found["valid"].items():
            full, parameter = name.split()
            (raw,) = package.packet.Packet(data).fields
            value = package.registry.by_name(full).decode(raw.data)
            assert answer[0] == answer[1] == value.is_valid(parameter, device), (name, data.hex(), device)
            p = value.INFO[parameter]
            for i, element in enumerate(p.elements):
                of_one = value.is_valid(f"{parameter}.{element}", device)
                assert answer[2 * i + 2 : 2 * i + 4] == [of_one, of_one], (name, element, data.hex(), device)
            seen[answer[0]] += 1
    assert min(seen) > 50, seen
