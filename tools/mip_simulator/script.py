"""Scripted events, which affect a device and its surroundings at given times."""

from __future__ import annotations

import heapq
from collections.abc import Iterable
from dataclasses import dataclass

from mip_tools.geometry.earth import SECOND, Vector

from .faults.kinds import parse_faults
from .state import DeviceState

#: Events, as a scenario file names them.
KINDS = ("gnss_outage", "magnetic_disturbance", "faults", "disconnect", "unplug", "restart")


@dataclass(frozen=True)
class ScriptedEvent:
    """An event, which may recur. Times are in simulated seconds."""

    event: str
    at: float
    """The time since the start of the simulation."""
    duration: float | None = None
    """None: until the end of the simulation. A restart has no duration."""
    every: float | None = None
    """The interval at which the event recurs; None: it happens once."""
    field: Vector = (0.0, 0.0, 0.0)
    """The field of a magnetic disturbance, in gauss, along the axes of the sensor."""
    faults: str = ""
    """The faults, as for `mip simulate --fault`."""

    def check(self) -> None:
        """Raises ValueError or Failure if the event is impossible."""
        if self.event not in KINDS:
            raise ValueError(f"'{self.event}' is not a scripted event; there are {', '.join(KINDS)}")
        parse_faults(self.faults)
        if self.every is not None and not (self.duration or 0.0) < self.every:
            raise ValueError(f"an event every {self.every:g} s must end before the next one begins")


class Script:
    """The events of a device, in their order."""

    def __init__(self, device: DeviceState, events: Iterable[ScriptedEvent]) -> None:
        self._device = device
        self._due: list[tuple[int, int, ScriptedEvent, bool]] = []  # time, order, event, does it begin?
        self._active: list[ScriptedEvent] = []
        self._order = 0
        for event in events:
            event.check()
            self._plan(round(event.at * SECOND), event, True)

    @property
    def next(self) -> int | None:
        """The time at which the next event begins or ends."""
        return self._due[0][0] if self._due else None

    @property
    def plugged(self) -> bool:
        """Are the ports of the device connected?"""
        return not any(e.event in ("disconnect", "unplug") for e in self._active)

    def run(self, now: int) -> None:
        """Begins and ends the events that are due by now."""
        while self._due and self._due[0][0] <= now:
            time, _, event, begins = heapq.heappop(self._due)
            if begins:
                self._begin(time, event)
            else:
                self._active.remove(event)
            self._settle(event, begins)

    def _plan(self, time: int, event: ScriptedEvent, begins: bool) -> None:
        self._order += 1
        heapq.heappush(self._due, (time, self._order, event, begins))

    def _begin(self, time: int, event: ScriptedEvent) -> None:
        if event.every is not None:
            self._plan(time + round(event.every * SECOND), event, True)
        if event.event == "restart":
            return
        self._active.append(event)
        if event.duration is not None:
            self._plan(time + round(event.duration * SECOND), event, False)

    def _settle(self, event: ScriptedEvent, begins: bool) -> None:
        """Applies the active events to the device and its world."""
        device, world = self._device, self._device.world
        active = [e for e in self._active if e.event == event.event]
        if device.faults is not None:
            device.faults.tell(device.now, event.event, "begins" if begins else "ends")
        if event.event == "gnss_outage":
            world.advance()
            world.gnss = device.outdoors and not active
            world.synchronize()
        elif event.event == "magnetic_disturbance":
            x, y, z = (sum(axis) for axis in zip((0.0, 0.0, 0.0), *(e.field for e in active)))
            world.disturbance = (x, y, z)
        elif event.event == "faults":
            assert device.faults is not None
            device.faults.add(parse_faults(e.faults) for e in active)
        elif begins:  # the cable is pulled, or the device restarts
            if event.event == "restart":
                device.reset()
            else:
                device.unplug()
        elif event.event == "unplug":  # power has returned
            device.reset()
