"""Replays a log of MIP packets, as a motion and as recorded data."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from ...binding import DecodeError, Packet, PacketError, Parser, reflection, registry
from ...devices.facts import value_sources
from ...devices.names import value_named
from ...geometry import earth
from ...geometry.attitude import Quaternion, attitude_matrix, between, euler_rotation, quaternion, rotation_vector
from ...geometry.earth import SECOND, WEEK, Vector
from .state import MotionError, State

#: A clock that jumps by more than this, or backwards, was set: the replay continues without a gap.
GAP = 60 * SECOND
GPS, REFERENCE = "gps.tow", "reference.time"

_ATTITUDE = (("attitude.quaternion",), ("attitude.dcm",), ("attitude.roll", "attitude.pitch", "attitude.yaw"))
_POSITION = (
    ("position.latitude", "position.longitude", "position.height"), ("position.ecef",),
    ("gnss_1.latitude", "gnss_1.longitude", "gnss_1.height"), ("gnss_1.ecef",),
)  # fmt: skip
_VELOCITY = (("velocity.north", "velocity.east", "velocity.down"), ("gnss_1.velocity",))


@dataclass
class _Series:
    times: list[float]
    values: list[Any]

    def around(self, t: float) -> tuple[Any, Any, float, float]:
        """Returns the values before and after a time, its fraction between them (0 to 1), and their distance in s.

        Before the first and after the last time, the distance is 0.
        """
        i = bisect_right(self.times, t)
        if i == 0 or i == len(self.times):
            value = self.values[min(i, len(self.times) - 1)]
            return value, value, 0.0, 0.0
        a, b = self.times[i - 1], self.times[i]
        return self.values[i - 1], self.values[i], (t - a) / (b - a), b - a


class Replay:
    """Replays a log. Data fields in the log are sent as recorded: the latest one at each time, at the requested rate.

    Other fields agree with a motion through the attitudes, positions and velocities of the log; without any of these,
    the device is at rest. Times are always those of the simulation, which begins at the GPS time of the log (`start`),
    if it has one. At its end, the log is repeated (`loop`), or the last values remain and the device is at rest.
    """

    def __init__(self, path: str | Path, *, loop: bool = False, rate: float | None = None) -> None:
        """`rate`: the rate in Hz of the most frequent set, for a log without times."""
        try:
            data = Path(path).read_bytes()
        except OSError as error:
            raise MotionError(f"replay: cannot read {path}: {error.strerror}") from None
        parser = Parser()
        packets = [p for p in [*parser.feed(data), *parser.flush()] if p.set >= 0x80]
        if not packets:
            raise MotionError(f"replay: {path} has no data packets")
        if rate is not None and not rate > 0:
            raise MotionError(f"replay: rate={rate:g} must be above 0")
        self._loop = loop
        self.start: int | None = None
        times = self._times(packets, rate, str(path))
        self.duration = (times[-1] - times[0]) / SECOND
        self._recorded: dict[tuple[int, int], tuple[list[float], list[list[bytes]]]] = {}
        for packet, time in zip(packets, times):
            at = (time - times[0]) / SECOND
            for raw in _fields(packet):
                packet_times, groups = self._recorded.setdefault((raw.set, raw.descriptor), ([], []))
                if packet_times and packet_times[-1] == at:
                    groups[-1].append(raw.data)
                else:
                    packet_times.append(at)
                    groups.append([raw.data])
        self._attitude = self._series(_ATTITUDE)
        self._position = self._series(_POSITION)
        self._velocity = self._series(_VELOCITY)

    def recorded(self, set_number: int, descriptor: int, t: float) -> list[bytes]:
        """Returns the data of a field at a time; several if the log has several at once, empty if it has none."""
        recorded = self._recorded.get((set_number, descriptor))
        if recorded is None:
            return []
        times, groups = recorded
        return groups[max(0, bisect_right(times, self._when(t)) - 1)]

    def at(self, t: float) -> State:
        t = self._when(t)
        latitude, longitude, height = _middle(self._position.around(t))
        before, after, part, distance = self._attitude.around(t)
        q = between(before, after, part)
        rate = (0.0, 0.0, 0.0)
        if distance:
            x, y, z = rotation_vector(before, after)
            rate = (x / distance, y / distance, z / distance)
        around = self._velocity.around(t)
        velocity, acceleration = _middle(around), (0.0, 0.0, 0.0)
        if around[3]:
            (a, b, c), (d, e, f) = around[:2]
            acceleration = ((d - a) / around[3], (e - b) / around[3], (f - c) / around[3])
        elif t >= self.duration:
            velocity = (0.0, 0.0, 0.0)
        return State(latitude, longitude, height, velocity, acceleration, q, attitude_matrix(q), rate)

    def _when(self, t: float) -> float:
        if self._loop and self.duration > 0:
            return t % self.duration
        return min(max(t, 0.0), self.duration)

    # ------------------------------------------------------------------ times

    def _times(self, packets: Sequence[Packet], rate: float | None, path: str) -> list[int]:
        """Returns when each packet was sent, in ns, by the clock that most have; others are evenly spaced between."""
        clocks_of_packets = [_clocks(p) for p in packets]
        counts = Counter(name for clocks in clocks_of_packets for name in clocks)
        if not counts:
            if rate is None:
                raise MotionError(f"replay: {path} has no times; add the rate of its packets: rate=HZ")
            return _even(packets, rate)
        clock = max((GPS, REFERENCE), key=lambda name: counts[name])
        numbered: list[tuple[int, int]] = []  # number of the packet, time
        shift = last = 0
        for i, clocks in enumerate(clocks_of_packets):
            if clock not in clocks:
                continue
            time = clocks[clock]
            if clock == GPS and self.start is None and time >= WEEK:
                self.start = time
            if numbered and not 0 <= time + shift - last <= GAP:
                shift = last - time
            last = time + shift
            numbered.append((i, last))
        times = [numbered[0][1]] * numbered[0][0]
        for (i, a), (j, b) in pairwise(numbered):
            times += [a + (b - a) * k // (j - i) for k in range(j - i)]
        return times + [numbered[-1][1]] * (len(packets) - len(times))

    # ------------------------------------------------------------------ the motion

    def _series(self, alternatives: Sequence[Sequence[str]]) -> _Series:
        """Reads one part of the motion, such as the attitude, from the best fields in the log."""
        for names in alternatives:
            for set_number, descriptor in sorted(self._recorded, reverse=True):
                times, groups = self._recorded[set_number, descriptor]
                series = _Series([], [])
                for time, group in zip(times, groups):
                    value = _shown(set_number, descriptor, group[0], names)
                    if value is not None:
                        series.times.append(time)
                        series.values.append(_standard(names[0], value))
                if series.times:
                    return series
        return _Series([0.0], [_REST[alternatives[0][0]]])


_REST: dict[str, Any] = {
    "attitude.quaternion": (1.0, 0.0, 0.0, 0.0),
    "position.latitude": (0.8203047484373349, 0.13962634015954636, 500.0),
    "velocity.north": (0.0, 0.0, 0.0),
}


def _middle(around: tuple[Any, Any, float, float]) -> Vector:
    before, after, part, _ = around
    x, y, z = (a + (b - a) * part for a, b in zip(before, after))
    return x, y, z


def _fields(packet: Packet) -> Iterator[Any]:
    try:
        yield from packet
    except PacketError:
        return


def _even(packets: Sequence[Packet], rate: float) -> list[int]:
    most = Counter(p.set for p in packets).most_common(1)[0][0]
    times, count = [], -1
    for p in packets:
        count += p.set == most
        times.append(round(max(0, count) * SECOND / rate))
    return times


def _clocks(packet: Packet) -> dict[str, int]:
    """Returns the clocks of a packet in ns, with GPS time since its epoch, even if they are not valid."""
    clocks: dict[str, int] = {}
    for raw in _fields(packet):
        reference = _shown(raw.set, raw.descriptor, raw.data, (REFERENCE,), valid=False)
        if reference is not None:
            clocks.setdefault(REFERENCE, int(reference[0]))
        for names in ((GPS, "gps.week"), ("clock.tow", "clock.week")):
            tow = _shown(raw.set, raw.descriptor, raw.data, names, valid=False)
            if tow is not None:
                clocks.setdefault(GPS, int(tow[1]) * WEEK + round(tow[0] * SECOND))
    return clocks


@cache
def _places(set_number: int, kind: Any, names: Sequence[str]) -> tuple[tuple[Any, float], ...]:
    """Finds the parameters that contain these quantities, with their factors; empty if one is missing."""
    sources = {v.quantity: (path, v.factor) for path, v in value_sources(kind, set_number).parameters.items()}
    if not all(name in sources for name in names):
        return ()
    parameters = {p.name: p for p in reflection.info(kind).parameters}
    return tuple((parameters[sources[name][0]], sources[name][1]) for name in names)


def _shown(set_number: int, descriptor: int, data: bytes, names: Sequence[str], valid: bool = True) -> list[Any] | None:
    """Returns the values of these quantities in a field; None if it lacks one or, with `valid`, if one is not valid."""
    types = registry.types(set_number, descriptor)
    kind: Any = types[0] if len(types) == 1 else None
    places = _places(set_number, kind, tuple(names)) if kind else ()
    if not places:
        return None
    try:
        field = kind.decode(data)
    except DecodeError:
        return None
    values = []
    for p, factor in places:
        for flag in p.valid if valid else ():
            flags, _, bit = flag.partition(".")
            value = getattr(field, flags, 0)
            if bit and not value & value_named(type(value), (bit,)):
                return None
        value = getattr(field, p.attribute)
        scaled = tuple(x / factor for x in value) if p.elements else value if factor == 1 else value / factor
        if any(x != x for x in (scaled if p.elements else (scaled,))):
            return None
        values.append(scaled)
    return values


def _standard(name: str, value: list[Any]) -> Quaternion | Vector:
    """Converts an attitude to a quaternion, and a position to latitude, longitude, height."""
    if name == "attitude.quaternion":
        length = sum(x * x for x in value[0]) ** 0.5 or 1.0
        w, x, y, z = (c / length for c in value[0])
        return w, x, y, z
    if name == "attitude.dcm":
        return quaternion(value[0])
    if name == "attitude.roll":
        return euler_rotation(value[0], value[1], value[2])[0]
    if name.endswith(".ecef"):
        return earth.llh(*value[0])
    x, y, z = value if len(value) == 3 else value[0]
    return x, y, z
