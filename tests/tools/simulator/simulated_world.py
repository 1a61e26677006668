"""A world whose data fields are shown by name."""

from __future__ import annotations

from typing import Any

from mip_protocol import registry
from mip_protocol.devices import by_name
from mip_protocol.field import Data
from mip_protocol.profile import Device
from mip_simulator.motion import Motion
from mip_simulator.streams.values import encoder
from mip_simulator.world.world import World

#: The data fields of each set -> their sets.
SETS = {kind.name_in(number): number for number, kind in registry.all_types() if issubclass(kind, Data)}
#: And their classes.
TYPES = {kind.name_in(number): kind for number, kind in registry.all_types() if issubclass(kind, Data)}


def profile(name: str = "3dm-cv7-gnss-ins") -> Device:
    found = by_name(name)
    assert found is not None
    return found


class Shown:
    """Shows data fields at any time; without noise and bias unless they are wanted."""

    def __init__(self, motion: Motion, *, exact: bool = True, seed: int = 0, start: int | None = None) -> None:
        self.world = World(motion, seed=seed, start=start, noise=0 if exact else 1)
        if exact:
            self.world.accel_bias = self.world.accel_bias_left
            self.world.gyro_bias = self.world.gyro_bias_left
        self._encoders: dict[str, Any] = {}

    def at(self, seconds: float) -> Shown:
        self.world.move_to(round(seconds * 1e9))
        return self

    def raw(self, name: str) -> list[bytes]:
        if name not in self._encoders:
            self._encoders[name] = encoder(TYPES[name], profile(), self.world, SETS[name])
        data: list[bytes] = self._encoders[name]()
        return data

    def all(self, name: str) -> list[Any]:
        return [TYPES[name].decode(data) for data in self.raw(name)]

    def __call__(self, name: str) -> Any:
        (found,) = self.all(name)
        return found
