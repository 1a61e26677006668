"""Scenario files: the events that affect a device."""

from __future__ import annotations

from dataclasses import replace
from math import isfinite
from pathlib import Path
from typing import Any

from mip_tools.binding import Device
from mip_tools.devices.profiles import port_named
from mip_tools.errors import Failure, Misuse
from mip_tools.text.yaml_reader import Wrong, YamlReader, hint, kind_of

from .endpoints.endpoint import KINDS as ENDPOINTS
from .endpoints.endpoint import Endpoint
from .script import KINDS, ScriptedEvent


def read_scenario(path: Path) -> tuple[ScriptedEvent, ...]:
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


class _Reader(YamlReader):
    def scenario(self) -> tuple[ScriptedEvent, ...]:
        root = self.root("a scenario; it needs 'events'")
        node = self.keys(root, ("events",), "a scenario").get("events")
        events = []
        if node is None or kind_of(node) != "sequence" or not node.value:
            self.wrong(Wrong(node or root, "'events' must be a list with at least one item"))
        else:
            for item in node.value:
                try:
                    events.append(self.event(item))
                except Wrong as mistake:
                    self.wrong(mistake)
        self.end()
        return tuple(events)

    def text(self, node: Any) -> str:
        if kind_of(node) != "scalar" or not node.value:
            raise Wrong(node, "this needs a text")
        return str(node.value)

    def number(self, node: Any, name: str, least: float = 0.0) -> float:
        try:
            value = float(node.value)
        except (TypeError, ValueError):
            value = -1.0
        if not least <= value < 1e10 or not isfinite(value):
            limit = "more than 0" if least else "0 or more"
            raise Wrong(node, f"'{name}' needs a number of seconds, {limit}")
        return value

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
