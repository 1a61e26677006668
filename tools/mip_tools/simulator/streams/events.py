"""Events: triggers, which define when, and actions, which define what. All are updated in each event cycle.

Their configuration is the setting of the commands with the effects `trigger`, `trigger_mode`,
`action` and `pin`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from ...binding import Command, Structure, reflection, registry
from ...geometry.earth import SECOND
from ..state import DeviceState
from . import formats
from .stream import Stream

Setting = dict[str, Any]  # the arguments of an effect

#: Event cycles per second of a device whose profile does not state them.
USUAL_RATE = 1000

#: Behavior of a pin with timestamps -> the levels to which it must change: rising, falling, either.
EDGES = {"RISING": (True,), "FALLING": (False,), "EITHER": (True, False)}


class Trigger:
    """A configured trigger."""

    __slots__ = ("active", "begins", "mode", "moment", "pulsed", "setting")

    def __init__(self, setting: Setting) -> None:
        self.setting = setting
        self.mode = "DISABLED"
        self.active = False
        self.begins = False  # active since this cycle, or again because of an edge
        self.moment = 0  # when it became active, in nanoseconds
        self.pulsed = False  # a test pulse has been active for a cycle


class Action:
    """A configured action."""

    __slots__ = ("count", "setting", "start")

    def __init__(self, setting: Setting) -> None:
        self.setting = setting
        self.start: int | None = None  # when its trigger became active
        self.count = 0  # packets sent since then


class Events:
    """The triggers and actions of one device."""

    def __init__(self, device: DeviceState) -> None:
        self._device = device
        self._cycle: Stream | None = None
        self.reset()

    def reset(self) -> None:
        """Deactivates everything, as at power-up."""
        self._triggers: dict[int, Trigger] = {}
        self._actions: dict[int, Action] = {}
        self._pins: dict[int, Setting] = {}
        self._edges: dict[int, int] = {}  # pin -> when its first edge in this cycle was
        self._earlier: dict[int, Command] = {}  # trigger -> its mode before a test pulse
        self._cycle = None
        self.arrange()

    def arrange(self) -> None:
        """Applies the settings. A trigger or an action with an unchanged configuration keeps its state."""
        device = self._device
        self._pins = {setting["pin"]: setting for setting in device.settings_of("pin")}
        self._triggers = _kept(self._triggers, device.settings_of("trigger"), Trigger)
        self._actions = _kept(self._actions, device.settings_of("action"), Action)
        modes = {x["instance"]: x["mode"].name for x in device.settings_of("trigger_mode")}
        for instance, trigger in self._triggers.items():
            mode = modes.get(instance, "DISABLED")
            if trigger.mode != mode:
                trigger.mode, trigger.pulsed = mode, False
        if not self._working:
            self._cycle = None
        elif self._cycle is None:
            limit = device.profile.limits.get("event_tick_rate")
            rate = USUAL_RATE if limit is None else limit.value
            begin = max(device.now, device.ready_at)
            self._cycle = Stream(rate, [(1, None)], self._update, device.booted, begin)

    @property
    def _working(self) -> bool:
        enabled = any(trigger.mode != "DISABLED" for trigger in self._triggers.values())
        return enabled or any(action.setting["pin"] is not None for action in self._actions.values())

    @property
    def sends(self) -> bool:
        """Can any action send data?"""
        return self._cycle is not None and any(action.setting["set"] is not None for action in self._actions.values())

    @property
    def next(self) -> int | None:
        """Returns the time of the next event cycle."""
        return None if self._cycle is None else self._cycle.next

    def run(self, time: int) -> None:
        """Runs the event cycle of this moment, if there is one."""
        if self._cycle is not None and self._cycle.next <= time:
            self._cycle.fire()

    def skip(self, until: int) -> None:
        if self._cycle is not None:
            self._cycle.skip(until)

    def active(self, instance: int) -> bool:
        trigger = self._triggers.get(instance)
        return trigger is not None and trigger.active

    def keep_mode(self, instance: int, mode: Command | None) -> None:
        """Stores the mode to which a trigger returns after a test pulse; None: the new mode is permanent."""
        if mode is None:
            self._earlier.pop(instance, None)
        else:
            self._earlier.setdefault(instance, mode)

    def changed(self, pin: int, level: bool) -> None:
        """Handles a change of a pin's level from outside."""
        setting = self._pins.get(pin)
        if setting is None or setting["feature"].name != "TIMESTAMP":
            return
        if level in EDGES.get(setting["behavior"].name, ()):
            self._edges.setdefault(pin, self._device.now)

    # ----------------------------------------------------------------------- the cycle

    def _update(self, _: Any) -> None:
        """Updates simple triggers, then those that combine others, then the actions, which depend on triggers."""
        self._end_pulses()
        for combining in (False, True):
            for instance, trigger in sorted(self._triggers.items()):
                if (trigger.setting["inputs"] is not None) == combining:
                    self._update_trigger(instance, trigger)
        self._edges.clear()
        for instance, action in sorted(self._actions.items()):
            trigger = self._triggers.get(action.setting["trigger"], _NEVER)
            if action.setting["pin"] is not None:
                self._switch(action.setting, trigger)
            else:
                self._stream(instance, action, trigger)

    def _end_pulses(self) -> None:
        ended = [i for i, t in self._triggers.items() if t.mode == "TEST_PULSE" and t.pulsed]
        for instance in ended:
            earlier = self._earlier.pop(instance, None)
            if earlier is None:
                self._device.disable_trigger(instance)
            else:
                self._device.settings.write(earlier)
        if ended:
            self.arrange()

    def _update_trigger(self, instance: int, trigger: Trigger) -> None:
        moment, edge = self._device.now, False
        if trigger.mode == "ENABLED":
            setting = trigger.setting
            if setting["inputs"] is not None:
                active = self._combined(setting)
            elif setting["set"] is not None:
                active = self._inside(instance, setting)
            elif setting["pin_mode"].name == "EDGE":
                active = edge = setting["pin"] in self._edges
                moment = self._edges.get(setting["pin"], moment)
            else:
                active = self._has_level(setting)
        else:
            active = trigger.mode != "DISABLED"
            trigger.pulsed = active
        trigger.begins = active and (edge or not trigger.active)
        trigger.active = active
        if trigger.begins:
            trigger.moment = moment

    def _has_level(self, setting: Setting) -> bool:
        pin = self._pins.get(setting["pin"])
        if pin is None or pin["feature"].name != "GPIO":
            return False
        wanted = {"WHILE_HIGH": True, "WHILE_LOW": False}.get(setting["pin_mode"].name)
        return self._device.world.level(setting["pin"]) == wanted

    def _combined(self, setting: Setting) -> bool:
        """Looks up the truth table. A trigger that refers to itself has its state from the last cycle."""
        row = sum(self.active(x) << n for n, x in enumerate(setting["inputs"]))
        return bool(setting["table"] >> row & 1)

    def _inside(self, instance: int, setting: Setting) -> bool:
        """Does the watched value meet its condition?"""
        value = _watched(self._device, setting, f"trigger {instance}")
        if value is None:
            return False
        if setting["low"] is not None:
            low, high = setting["low"], setting["high"]
            return bool(low <= value <= high if low <= high else value < high or value > low)
        threshold, interval = setting["threshold"], setting["interval"]
        if max(threshold, interval) <= 0:
            return False
        if interval >= threshold:
            return bool(value % interval <= threshold)
        return bool(value % threshold > interval)

    def _switch(self, setting: Setting, trigger: Trigger) -> None:
        pins, pin, mode = self._device.world.pins, setting["pin"], setting["pin_mode"].name
        if pin not in pins:  # not an output
            return
        if mode in ("ACTIVE_HIGH", "ACTIVE_LOW"):
            pins[pin] = trigger.active == (mode == "ACTIVE_HIGH")
        elif trigger.begins and mode in ("ONESHOT_HIGH", "ONESHOT_LOW"):
            pins[pin] = mode == "ONESHOT_HIGH"
        elif trigger.begins and mode == "TOGGLE":
            pins[pin] = not pins[pin]

    def _stream(self, instance: int, action: Action, trigger: Trigger) -> None:
        """Sends a packet when the trigger becomes active; with a decimation, further ones while it remains active."""
        setting, now = action.setting, self._device.now
        if not trigger.active:
            action.start = None
            return
        moment = trigger.moment if trigger.begins else now
        if trigger.begins or (action.start is None and setting["decimation"]):
            action.start, action.count = now, 0
        elif action.start is None or not setting["decimation"]:
            return
        rate = formats.ticks(self._device, setting["set"])
        if (now - action.start) * rate >= action.count * setting["decimation"] * SECOND:
            action.count += 1
            self._send(instance, setting, moment)

    def _send(self, instance: int, setting: Setting, moment: int) -> None:
        """Sends a packet with the time at which the trigger became active."""
        device, world, channel = self._device, self._device.world, f"action {instance}"
        if device.idle or device.direct:
            return
        set_number = setting["set"]
        wanted = [device.encoder(set_number, x, channel) for x in setting["fields"] if device.sends(set_number, x)]
        world.move_to(moment)
        world.trigger = setting["trigger"]
        device.send_fields(set_number, wanted)
        world.trigger = 0
        world.move_to(device.now)


def _kept(old: dict[int, Any], settings: Iterable[Setting], make: Any) -> dict[int, Any]:
    """Instance -> trigger or action. Those with unchanged arguments remain the same objects."""
    kept = {}
    for setting in settings:
        if setting["type"]:
            before = old.get(setting["instance"])
            same = before is not None and before.setting == setting
            kept[setting["instance"]] = before if same else make(setting)
    return kept


def can_watch(device: DeviceState, setting: Setting) -> bool:
    """Does the device have the value that the trigger watches?"""
    return _watched(device, setting, "check") is not None


def _watched(device: DeviceState, setting: Setting, channel: str) -> float | None:
    """Returns the value that a trigger compares; None if the device does not have it."""
    set_number, descriptor = setting["set"], setting["field"]
    if not device.sends(set_number, descriptor):
        return None
    fields = device.encoder(set_number, descriptor, channel)()
    kind = registry.types(set_number, descriptor)[0]
    numbers = list(_numbers(kind.decode(fields[0].data))) if fields else []
    return numbers[setting["element"] - 1] if setting["element"] <= len(numbers) else None


def _numbers(value: Any) -> Iterator[float]:
    """Yields all numbers in a value."""
    if isinstance(value, Structure):
        for p in reflection.info(type(value)).parameters:
            if p.kind not in ("constant", "counter"):
                yield from _numbers(getattr(value, p.attribute))
    elif isinstance(value, tuple):
        for item in value:
            yield from _numbers(item)
    elif isinstance(value, (int, float)):
        yield float(value)


_NEVER = Trigger({})
