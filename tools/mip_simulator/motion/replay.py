"""Replays the data of a log of MIP packets."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import datetime, timedelta
from itertools import accumulate
from pathlib import Path
from typing import Any

from mip_tools.binding import Packet, PacketError, Parser
from mip_tools.geometry.earth import SECOND, from_utc

from .state import REST, MotionError, State

#: A clock that jumps by more than this, or backwards, was set: the replay continues without a gap.
GAP = 60 * SECOND


class Replay:
    """Replays a log. Data fields in the log are sent as recorded: the latest one at each time, at the requested rate.

    Other fields are those of a device at rest. Times are always those of the simulation, which begins at the GPS time
    of the log (`start`), if it has one. At its end, the log is repeated (`loop`), or the last values remain.
    """

    def __init__(self, path: str | Path, *, loop: bool = False, rate: float | None = None) -> None:
        """`rate`: the rate in Hz of the most frequent set, for a log without times."""
        try:
            data = Path(path).read_bytes()
        except OSError as error:
            raise MotionError(f"replay: cannot read {path}: {error.strerror}") from None
        parser = Parser()
        every = [*parser.feed(data), *parser.flush()]
        packets = [p for p in every if p.set >= 0x80]
        if not packets:
            raise MotionError(f"replay: {path} has no data packets")
        if rate is not None and not rate > 0:
            raise MotionError(f"replay: rate={rate:g} must be above 0")
        self._loop = loop
        self.start: int | None = None
        times = [time for time, p in zip(self._times(data, every, rate, str(path)), every) if p.set >= 0x80]
        self.duration = times[-1] - times[0]
        self._recorded: dict[tuple[int, int], tuple[list[float], list[list[bytes]]]] = {}
        for packet, time in zip(packets, times):
            at = time - times[0]
            for raw in _fields(packet):
                packet_times, groups = self._recorded.setdefault((raw.set, raw.descriptor), ([], []))
                if packet_times and packet_times[-1] == at:
                    groups[-1].append(raw.data)
                else:
                    packet_times.append(at)
                    groups.append([raw.data])

    def recorded(self, set_number: int, descriptor: int, t: float) -> list[bytes]:
        """Returns the data of a field at a time; several if the log has several at once, empty if it has none."""
        recorded = self._recorded.get((set_number, descriptor))
        if recorded is None:
            return []
        times, groups = recorded
        return groups[max(0, bisect_right(times, self._when(t)) - 1)]

    def at(self, t: float) -> State:
        return REST

    def _when(self, t: float) -> float:
        if self._loop and self.duration > 0:
            return t % self.duration
        return min(max(t, 0.0), self.duration)

    # ------------------------------------------------------------------ times

    def _times(self, data: bytes, packets: Sequence[Packet], rate: float | None, path: str) -> list[float]:
        """Returns when each packet was sent, in s, by the clock of the log; others are evenly spaced between."""
        import numpy as np  # this motion alone needs it; all others start in half the time

        from mip_tools.columns import read_log, timeline
        from mip_tools.columns.stamps import NONE
        from mip_tools.columns.times import of_packets

        with read_log(data) as log:
            line = timeline.of_log(log)
            clocks = line.clocks(line.sets)
            if not clocks.best:
                if rate is None:
                    raise MotionError(f"replay: {path} has no times; add the rate of its packets: rate=HZ")
                most = Counter(p.set for p in packets if p.set >= 0x80).most_common(1)[0][0]
                return [max(0, count - 1) / rate for count in accumulate(p.set == most for p in packets)]
            if clocks.dated:
                dates = of_packets(log, clocks.dated)
                first = int(dates[dates != NONE][0])
                self.start = from_utc(datetime(1970, 1, 1) + timedelta(microseconds=first // 1000)) + first % 1000
            own = of_packets(log, clocks.steady)
        there = np.flatnonzero(own != NONE)
        steps = np.diff(own[there])
        steps[(steps < 0) | (steps > GAP)] = 0
        seconds: list[float] = np.interp(
            np.arange(len(packets)), there, np.append(0, np.cumsum(steps)) / SECOND
        ).tolist()
        return seconds


def _fields(packet: Packet) -> Iterator[Any]:
    try:
        yield from packet
    except PacketError:
        return
