"""Standard messages of ROS 2, made from the data fields of a packet.

The values of a message are a dictionary; what it leaves out is zero. Fields that a specification or a packet does not
have are left out of messages, and a message without its first value is not made.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import isfinite, radians
from typing import Any, NamedTuple

from ..binding import EnumInfo, Field, info
from ..simulator import earth
from . import axes

STANDARD_GRAVITY = 9.80665  # m/s^2 per g
TESLA = 1e-4  # per gauss
UNKNOWN = [-1.0, *[0.0] * 8]  # covariance of what a message does not have, as sensor_msgs defines it

#: The status in NavSatStatus of each fix type.
_NO_FIX, _FIX, _SATELLITES, _GROUND = -1, 0, 1, 2
_FIXES = {"fix_rtk_float": _GROUND, "fix_rtk_fixed": _GROUND, "fix_differential": _GROUND}
_FIXES |= {"fix_2d": _FIX, "fix_3d": _FIX}


class Message(NamedTuple):
    """A message for a topic; `frame` is that of its header."""

    topic: str
    type: str
    frame: str
    values: dict[str, Any]


Fields = Mapping[str, Field]


class Converter:
    """Makes messages of the fields of packets, in the order of a log: positions are relative to the first one."""

    def __init__(self, frame: str = "imu_link", world: str = "odom") -> None:
        self._frame, self._world = frame, world
        self._origin: tuple[float, float, earth.Vector] | None = None  # radians, and Earth-fixed
        self._status: dict[str, int] = {}  # of the last fix, by the set of the receiver
        self._filter: dict[str, Field] = {}

    def messages(self, fields: Fields) -> Iterator[Message]:
        """The messages of a packet. `fields`: full name in its set -> value."""
        yield from self._imu(fields)
        yield from self._magnetic(fields)
        yield from self._fixes(fields)
        yield from self._odometry(fields)

    def _imu(self, fields: Fields) -> Iterator[Message]:
        accel, gyro = fields.get("sensor.scaled_accel"), fields.get("sensor.scaled_gyro")
        if accel is None and gyro is None:
            return
        quaternion = fields.get("sensor.comp_quaternion")
        made: dict[str, Any] = {
            "orientation": _quaternion(axes.NOT_ROTATED),
            "orientation_covariance": UNKNOWN,
            "angular_velocity_covariance": UNKNOWN,
            "linear_acceleration_covariance": UNKNOWN,
        }
        if quaternion is not None:
            made |= {"orientation": _quaternion(axes.attitude(_of(quaternion, "q")))}
            made |= {"orientation_covariance": [0.0] * 9}  # zeros: not known
        if gyro is not None:
            made |= {"angular_velocity": _vector(axes.body(_of(gyro, "scaled_gyro")))}
            made |= {"angular_velocity_covariance": [0.0] * 9}
        if accel is not None:
            force = [STANDARD_GRAVITY * v for v in _of(accel, "scaled_accel")]
            made |= {"linear_acceleration": _vector(axes.body(force)), "linear_acceleration_covariance": [0.0] * 9}
        yield Message("/imu/data", "sensor_msgs/msg/Imu", self._frame, made)

    def _magnetic(self, fields: Fields) -> Iterator[Message]:
        mag = fields.get("sensor.scaled_mag")
        if mag is not None:
            field = _vector(axes.body([TESLA * v for v in _of(mag, "scaled_mag")]))
            yield Message("/imu/mag", "sensor_msgs/msg/MagneticField", self._frame, {"magnetic_field": field})

    def _fixes(self, fields: Fields) -> Iterator[Message]:
        for name, field in fields.items():
            set, _, short = name.partition(".")
            if short == "fix_info" and _valid(field, "fix_type"):
                said = info(type(_of(field, "fix_type")))
                assert isinstance(said, EnumInfo)
                status = _FIXES.get(said.names.get(int(_of(field, "fix_type")), ""), _NO_FIX)
                sbas = "sbas_used" in field.to_dict()["fix_flags"] and _valid(field, "fix_flags")
                self._status[set] = _SATELLITES if status == _FIX and sbas else status
        for name, field in fields.items():
            set, _, short = name.partition(".")
            if short != "llh_position" or not _valid(field, "latitude") or not hasattr(field, "horizontal_accuracy"):
                continue
            made = {
                "status": {"status": self._status.get(set, _FIX)},
                "latitude": _of(field, "latitude"),
                "longitude": _of(field, "longitude"),
                "altitude": _of(field, "ellipsoid_height") if _valid(field, "ellipsoid_height") else float("nan"),
            }
            if _valid(field, "horizontal_accuracy") and _valid(field, "vertical_accuracy"):
                across, up = _of(field, "horizontal_accuracy") ** 2, _of(field, "vertical_accuracy") ** 2
                made |= {"position_covariance": _diagonal((across, across, up)), "position_covariance_type": 1}
            yield Message(f"/{set}/fix", "sensor_msgs/msg/NavSatFix", f"{set}_antenna", made)

    def _odometry(self, fields: Fields) -> Iterator[Message]:
        # Uncertainties may be sent more rarely, and in other packets, than their values.
        self._filter |= {name: field for name, field in fields.items() if name.endswith("_uncertainty")}
        place, turned = fields.get("filter_data.llh_position"), fields.get("filter_data.attitude_quaternion")
        if place is None or turned is None or not _valid(place, "latitude") or not _valid(turned, "q"):
            return
        q = axes.attitude(_of(turned, "q"))
        position = self._local(_of(place, "latitude"), _of(place, "longitude"), _of(place, "ellipsoid_height"))
        around = self._variances("filter_data.euler_angles_uncertainty", "roll", "pitch", "yaw")
        along = self._variances("filter_data.llh_position_uncertainty", "east", "north", "down")
        pose = {"pose": {"position": _vector(position), "orientation": _quaternion(q)}}
        made: dict[str, Any] = {
            "child_frame_id": self._frame,
            "pose": pose | {"covariance": _blocks(_diagonal(along), _diagonal(around))},
        }
        moving, turning = fields.get("filter_data.ned_velocity"), fields.get("filter_data.comp_angular_rate")
        twist: dict[str, Any] = {}
        linear, angular = UNKNOWN, UNKNOWN
        if moving is not None and _valid(moving, "north"):
            speed = [_of(moving, name) for name in ("north", "east", "down")]
            spread = self._variances("filter_data.ned_velocity_uncertainty", "east", "north", "down")
            twist["linear"] = _vector(axes.into_body(q, axes.world(speed)))
            linear = axes.variances_into_body(q, spread)
        if turning is not None and _valid(turning, "gyro"):
            twist["angular"], angular = _vector(axes.body(_of(turning, "gyro"))), [0.0] * 9
        made["twist"] = {"twist": twist, "covariance": _blocks(linear, angular)}
        yield Message("/filter/odometry", "nav_msgs/msg/Odometry", self._world, made)

    def _local(self, latitude: float, longitude: float, height: float) -> axes.Vector:
        """East, north, up of the first position, in m."""
        lat, lon = radians(latitude), radians(longitude)
        at = earth.ecef(lat, lon, height)
        if self._origin is None:
            self._origin = lat, lon, at
        lat, lon, origin = self._origin
        x, y, z = (a - b for a, b in zip(at, origin))
        return axes.world(earth.to_ned(lat, lon, (x, y, z)))

    def _variances(self, name: str, *parameters: str) -> list[float]:
        """The squares of the last standard deviations; zeros if they are not known."""
        field = self._filter.get(name)
        if field is None or not _valid(field, parameters[0]):
            return [0.0] * 3
        return [_of(field, p) ** 2 for p in parameters]


def _of(field: Field, name: str) -> Any:
    return getattr(field, name)


def _valid(field: Field, name: str) -> bool:
    """Is it valid by its flags, and a number?"""
    held = _of(field, name)
    parameter = info(type(field))[name]
    numbers = held if isinstance(held, (tuple, list)) else [held]
    return all(isfinite(v) for v in numbers) and all(f.holds(_of(field, f.attribute)) for f in parameter.flags)


def _vector(v: axes.Vector) -> dict[str, float]:
    return dict(zip("xyz", v))


def _quaternion(q: axes.Quaternion) -> dict[str, float]:
    return dict(zip("wxyz", q))


def _diagonal(variances: tuple[float, ...] | list[float]) -> list[float]:
    return [variances[i] if i == j else 0.0 for i in range(3) for j in range(3)]


def _blocks(first: list[float], second: list[float]) -> list[float]:
    """A covariance of 6 x 6 of two of 3 x 3 whose errors are independent."""
    rows = [[*first[3 * i : 3 * i + 3], 0.0, 0.0, 0.0] for i in range(3)]
    rows += [[0.0, 0.0, 0.0, *second[3 * i : 3 * i + 3]] for i in range(3)]
    return [v for row in rows for v in row]


__all__ = ["STANDARD_GRAVITY", "UNKNOWN", "Converter", "Fields", "Message"]
