"""Scenario files: devices with their ports and motions, and the events that affect them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path
from typing import Any

from ..binding import Device
from ..devices.profiles import device_named, port_named
from ..errors import Failure, Misuse
from ..text.yaml_reader import Wrong, YamlReader, hint, kind_of
from .endpoints.endpoint import KINDS as ENDPOINTS
from .endpoints.endpoint import Endpoint, pty_at
from .motion import MotionError, parse_motion
from .motion.state import Motion
from .script import KINDS, ScriptedEvent


@dataclass(frozen=True)
class Simulated:
    """A device of a scenario."""

    profile: Device
    endpoints: tuple[Endpoint, ...] = ()
    motion: Motion | None = None
    seed: int | None = None
    sync: bool | None = None
    storage: Path | None = None
    events: tuple[ScriptedEvent, ...] = ()


@dataclass(frozen=True)
class Scenario:
    """The content of a scenario file."""

    devices: tuple[Simulated, ...] = ()
    events: tuple[ScriptedEvent, ...] = ()
    """The events of all devices, in a file without devices."""


def read_scenario(path: Path) -> Scenario:
    """Reads a scenario. Raises Failure with all mistakes and their positions."""
    return _Reader(path).scenario()


def endpoint(text: str, profile: Device) -> Endpoint:
    """Parses "pty:PATH", "tcp:[HOST:]PORT" or "udp:[HOST:]PORT", optionally after "NAME=", a port of the device. Raises
    Failure."""
    name, equals, where = text.rpartition("=")
    kind, _, place = where.partition(":")
    if kind not in ENDPOINTS:
        raise Misuse(f"'{text}' cannot be read; write NAME=pty:PATH, NAME=tcp:[HOST:]PORT or NAME=udp:[HOST:]PORT")
    return ENDPOINTS[kind](place, port_named(profile, name).name if equals else None)


def _yes_or_no(text: str) -> bool:
    if text.lower() not in ("true", "yes", "false", "no"):
        raise Misuse(f"'{text}' cannot be read; write true or false")
    return text.lower() in ("true", "yes")


class _Reader(YamlReader):
    def scenario(self) -> Scenario:
        root = self.root("a scenario; it needs 'devices', 'events' or both")
        parts = self.keys(root, ("devices", "events"), "a scenario")
        events = self.events(parts.get("events"))
        devices = [self.device(node, events) for node in self.items(parts.get("devices"), "devices")]
        self.end()
        return Scenario(tuple(d for d in devices if d is not None), () if devices else events)

    def items(self, node: Any, what: str) -> Sequence[Any]:
        if node is None:
            return ()
        if kind_of(node) != "sequence" or not node.value:
            self.wrong(Wrong(node, f"'{what}' must be a list with at least one item"))
            return ()
        return list(node.value)

    # ----------------------------------------------------------------- devices

    def device(self, node: Any, events: tuple[ScriptedEvent, ...]) -> Simulated | None:
        parts = self.keys(node, ("device", "ports", "motion", "seed", "sync", "storage", "events"), "a device")
        own = self.events(parts.get("events"))
        try:
            if "device" not in parts:
                raise Wrong(node, "'device' is missing; `mip simulate --list` names the devices")
            made: Simulated = self.tried(
                parts["device"], lambda text: Simulated(device_named(text), events=events + own)
            )
            if "motion" in parts:
                made = replace(made, motion=self.tried(parts["motion"], lambda x: parse_motion(x, self.path.parent)))
            if "seed" in parts:
                made = replace(made, seed=int(self.number(parts["seed"], "seed", whole=True)))
            if "sync" in parts:
                made = replace(made, sync=self.tried(parts["sync"], _yes_or_no))
            if "storage" in parts:
                made = replace(made, storage=self.path.parent / self.text(parts["storage"]))
            ports = self.items(parts.get("ports"), "ports")
            endpoints = [self.tried(port, lambda text: endpoint(text, made.profile)) for port in ports]
        except Wrong as mistake:
            self.wrong(mistake)
            return None
        return replace(made, endpoints=tuple(endpoints) or (pty_at(""),))

    def text(self, node: Any) -> str:
        if kind_of(node) != "scalar" or not node.value:
            raise Wrong(node, "this needs a text")
        return str(node.value)

    def tried(self, node: Any, read: Any) -> Any:
        """Parses a text in the form of the command line. Raises Wrong at this node."""
        try:
            return read(self.text(node))
        except (Failure, MotionError) as error:
            raise Wrong(node, str(error)) from None

    def number(self, node: Any, name: str, least: float = 0.0, whole: bool = False) -> float:
        try:
            value = float(node.value)
        except (TypeError, ValueError):
            value = -1.0
        if not least <= value < 1e10 or not isfinite(value) or (whole and value != int(value)):
            limit = "more than 0" if least else "0 or more"
            what = "a whole number" if whole else "a number of seconds"
            raise Wrong(node, f"'{name}' needs {what}, {limit}")
        return value

    # ----------------------------------------------------------------- events

    def events(self, node: Any) -> tuple[ScriptedEvent, ...]:
        events = []
        for item in self.items(node, "events"):
            try:
                events.append(self.event(item))
            except Wrong as mistake:
                self.wrong(mistake)
        return tuple(events)

    def event(self, node: Any) -> ScriptedEvent:
        parts = self.keys(node, ("event", "at", "for", "every", "field", "faults"), "an event")
        for key in ("event", "at"):
            if key not in parts:
                raise Wrong(node, f"'{key}' is missing; an event has, for example, {{at: 10, event: unplug, for: 5}}")
        kind = self.text(parts["event"])
        if kind not in KINDS:
            names = "; there are " + ", ".join(KINDS)
            raise Wrong(parts["event"], f"there is no event '{kind}'{hint(kind, KINDS, names)}")
        for key, of in {"field": "magnetic_disturbance", "faults": "faults"}.items():
            if kind == of and key not in parts:
                raise Wrong(node, f"'{key}' is missing; {of} needs it")
            if kind != of and key in parts:
                raise Wrong(parts[key], f"'{key}' is only for {of}; remove it")
        if kind == "restart" and "for" in parts:
            raise Wrong(parts["for"], "a restart has no 'for'; remove it")
        event = ScriptedEvent(
            kind,
            self.number(parts["at"], "at"),
            self.number(parts["for"], "for") if "for" in parts else None,
            self.number(parts["every"], "every", 1e-9) if "every" in parts else None,
        )
        try:
            if "field" in parts:
                event = replace(event, field=self.vector(parts["field"]))
            if "faults" in parts:
                event = replace(event, faults=self.text(parts["faults"]))
            event.check()
        except (Failure, ValueError) as error:
            raise Wrong(parts.get("faults") or parts.get("every") or node, str(error)) from None
        return event

    def vector(self, node: Any) -> tuple[float, float, float]:
        try:
            x, y, z = (float(item.value) for item in node.value)
        except (AttributeError, TypeError, ValueError):
            x = y = z = float("nan")
        if not all(isfinite(v) and abs(v) < 100 for v in (x, y, z)):
            raise Wrong(node, "'field' needs three numbers in gauss, [x, y, z], of less than 100")
        return x, y, z
