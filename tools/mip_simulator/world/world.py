"""The world of a virtual device: its surroundings, and the filter and the receivers that estimate them."""

from __future__ import annotations

from math import cos
from typing import Any, NamedTuple

from mip_tools.geometry import earth
from mip_tools.geometry.attitude import Quaternion, euler, euler_rotation
from mip_tools.geometry.earth import Matrix, Vector, turned_back

from ..filter.estimate import COMPLEMENTARY, Filter, wandering
from ..motion.state import Motion
from ..surroundings.surroundings import ANTENNAS, ZERO, Antenna, Surroundings, summed


class Place(NamedTuple):
    """Position and velocity that the filter estimates for the point that the user has chosen."""

    latitude: float
    longitude: float
    height: float
    velocity: Vector


class World(Surroundings):
    """The source of all quantities. The device advances its time and applies the settings."""

    def __init__(self, motion: Motion, *, seed: int | str = 0, start: int | None = None, noise: float = 1.0) -> None:
        super().__init__(motion, seed=seed, start=start, noise=noise)
        self.filter = Filter(self, settled=True)

    def restart(self) -> None:
        """Restarts the device: its clock is at 0, and its settings have not been applied yet."""
        super().restart()
        if self.now:
            self.filter = Filter(self, settled=False)

    def advance(self) -> None:
        """Advances the filter to this time before a setting changes, unless the device is starting."""
        if self.started:
            self.filter.advance()

    # ------------------------------------------------------------------ filter

    @property
    def attitude(self) -> tuple[Quaternion, Matrix]:
        """The attitude of the vehicle, as the filter estimates it."""
        return self.once("attitude", self._attitude)

    def _attitude(self) -> tuple[Quaternion, Matrix]:
        self.filter.advance()
        wrong = self.filter.error("attitude")
        return euler_rotation(*summed(euler(self.dcm), wrong)) if any(wrong) else (self.quaternion, self.dcm)

    @property
    def place(self) -> Place:
        """Position and velocity as the filter estimates them."""
        return self.once("place", self._place)

    def _place(self) -> Place:
        s = self.state
        p: Any = Antenna(s, turned_back(self.sensor_to_vehicle, self.offset)) if self.offset != ZERO else s
        self.filter.advance()
        if not self.filter.placed:
            return Place(p.latitude, p.longitude, p.height, p.velocity)
        n, e, d = self.filter.error("position")
        along, across = earth.radii(p.latitude)
        return Place(
            p.latitude + n / (along + p.height),
            p.longitude + e / ((across + p.height) * cos(p.latitude)),
            p.height - d,
            summed(p.velocity, self.filter.error("velocity")),
        )

    @property
    def complementary(self) -> Matrix:
        """The attitude of the vehicle, or of the sensor, by the complementary filter: it has errors of its own."""
        return self.once("complementary", self._complementary)

    def _complementary(self) -> Matrix:
        dcm = self.dcm if self.complementary_turns else self.state.dcm
        if not self.noise:
            return dcm
        deviation = self.noise * COMPLEMENTARY
        wrong = [deviation * wandering(f"{self.seed}:complementary:{i}", self.time) for i in range(3)]
        return euler_rotation(*summed(euler(dcm), wrong))[1]

    def fix(self, receiver: int) -> Antenna:
        """The position of the antenna as the receiver measures it."""
        if not self.noise:
            return self.antenna(receiver)
        return self.once(
            f"fix {receiver}", lambda: Antenna(self.state, ANTENNAS[receiver], *self.filter.fix_error(receiver))
        )
