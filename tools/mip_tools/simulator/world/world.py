"""The world of a virtual device: its surroundings, and the filter and the receivers that estimate them."""

from __future__ import annotations

from math import cos
from typing import Any, NamedTuple

from ...geometry import earth
from ...geometry.attitude import Quaternion, euler, euler_rotation
from ...geometry.earth import Matrix, Vector, turned_back
from ..filter.estimate import Complementary, Filter
from ..motion.state import Motion
from ..surroundings.surroundings import ANTENNAS, ZERO, Antenna, Surroundings, scaled


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
        self.complementary = Complementary(self)

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
        since, left = self.filter.since, self.filter.left
        wrong = [pair.shown(since, left) for pair in self.filter.attitude]
        if not any(wrong):
            return self.quaternion, self.dcm
        roll, pitch, yaw = euler(self.dcm)
        return euler_rotation(roll + wrong[0], pitch + wrong[1], yaw + wrong[2])

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
        since, left = self.filter.since, self.filter.left
        n, e, d = (pair.shown(since, left) for pair in self.filter.navigation)
        to_north, to_east, to_down = (pair.shown_rate(left) for pair in self.filter.navigation)
        along, across = earth.radii(p.latitude)
        u, v, w = p.velocity
        return Place(
            p.latitude + n / (along + p.height),
            p.longitude + e / ((across + p.height) * cos(p.latitude)),
            p.height - d,
            (u + to_north, v + to_east, w + to_down),
        )

    @property
    def gyro_bias_error(self) -> Vector:
        """The error of the estimated bias that the setting does not remove."""
        self.filter.advance()
        estimated = self.filter.options.estimated
        if estimated is not None and "gyro_bias" not in estimated:
            return scaled(self.gyro_bias_left, -1.0)
        left = self.filter.left
        return scaled([pair.shown_rate(left) for pair in self.filter.attitude], -1.0)

    @property
    def accel_bias_error(self) -> Vector:
        self.filter.advance()
        estimated = self.filter.options.estimated
        if estimated is not None and "accel_bias" not in estimated:
            return scaled(self.accel_bias_left, -1.0)
        left = self.filter.left
        return scaled([pair.shown(0.0, left) for pair in self.filter.accel_bias], 1.0)

    def fix(self, receiver: int) -> Antenna:
        """The position of the antenna as the receiver measures it."""
        return self.once(f"fix {receiver}", lambda: self._fix(receiver))

    def _fix(self, receiver: int) -> Antenna:
        self.filter.advance()
        wrong, faster = self.filter.fix_errors[receiver]
        return Antenna(self.state, ANTENNAS[receiver], wrong, faster) if self.noise else self.antenna(receiver)
