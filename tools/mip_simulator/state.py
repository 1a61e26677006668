"""The state of a virtual device, and what commands, events and streams do with it; `device` lets time pass."""

from __future__ import annotations

import operator
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from typing import Any

from mip_tools.binding import Device, RawField
from mip_tools.devices.checks import NOTHING
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.profiles import assumed_ports
from mip_tools.devices.settings import Place, Settings, arguments, command_type

from .faults import Faults
from .link import Link
from .world.world import World

Encoder = Callable[[], list[RawField]]


def firmware(profile: Device) -> int:
    """Returns the version that the device reports: 7000 is 7.0.00."""
    return 1000 * (profile.generation or 1)


def _includes(versions: str | None, version: int) -> bool:
    """Does a statement of a profile include a version? Of "> 1.0.07", 7000 is one."""
    match = re.fullmatch(r"([<>]=?) ([0-9]+)\.([0-9]+)\.([0-9]+)", versions or "")
    if match is None:
        return True
    limit = 1000 * int(match[2]) + 100 * int(match[3]) + int(match[4])
    return bool({"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}[match[1]](version, limit))


class DeviceState(ABC):
    """The settings, the world and the connections of a device. Times are in nanoseconds since the start."""

    def __init__(self, profile: Device, settings: Settings, world: World, faults: Faults | None, seed: int) -> None:
        self.profile = profile
        self.settings = settings
        self.world = world
        self.faults = faults
        self.seed = seed
        self.ports = assumed_ports(profile)
        self.field_keys = {key for key in profile.fields if _includes(profile.firmware.get(key), firmware(profile))}
        self.links: list[Link] = []
        self.outdoors = True  # the receivers receive satellites unless an event prevents it
        self.idle = False
        self.direct = False
        self.now = 0
        self.booted = 0
        self.ready_at = 0
        self.bytes_sent = 0
        self.bytes_received = 0
        self.rtcm_frames = 0  # that ports with RTCM input have received

    @property
    def dropped(self) -> int:
        """The number of packets that were dropped because hosts had no room."""
        return sum(link.dropped for link in self.links)

    def settings_of(self, effect: str) -> list[dict[str, Any]]:
        """Returns the current settings with an effect, one for each instance, as the arguments of the effect."""
        return [
            arguments(kept) for _, kept in self.settings.items() if COMMANDS.get(kept.NAME, NOTHING).effect == effect
        ]

    def has_effect(self, effect: str) -> bool:
        """Does the device know a command with this effect?"""
        return any(behavior.effect == effect and self.knows(name) for name, behavior in COMMANDS.items())

    def knows(self, name: str) -> bool:
        """Does the device have this command?"""
        kind = command_type(name)
        return (kind.SET, kind.DESCRIPTOR) in self.field_keys

    def sends(self, set_number: int, descriptor: int) -> bool:
        """Does the device send this field in this data set? It may be a shared one."""
        return (set_number, descriptor) in self.field_keys or (0xFF, descriptor) in self.field_keys

    # What time and commands do, in `device`.

    @abstractmethod
    def reset(self) -> None: ...
    @abstractmethod
    def unplug(self) -> None: ...
    @abstractmethod
    def pause(self, time: int) -> None: ...
    @abstractmethod
    def arrange(self) -> None: ...
    @abstractmethod
    def restore(self, at: Place, saved: bool) -> None: ...
    @abstractmethod
    def all_settings(self, function: int) -> None: ...
    @abstractmethod
    def disable_trigger(self, instance: int) -> None: ...
    @abstractmethod
    def encoder(self, set_number: int, descriptor: int) -> Encoder: ...
    @abstractmethod
    def send_data(self, set_number: int, wanted: Iterable[int], link: Link | None = None) -> None: ...
    @abstractmethod
    def send_fields(self, set_number: int, encoders: Iterable[Encoder], link: Link | None = None) -> None: ...
    @abstractmethod
    def send_sentences(self, entries: Iterable[Any], link: Link | None = None) -> None: ...
