"""Makes standard ROS 2 messages from columns of data fields.

Values that are not set are zero. Fields that a specification or a packet does not have are left out of messages, and a
message without its first value is not made.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from math import radians
from typing import Any, NamedTuple

import numpy as np

from ..binding import info
from ..columns import Log
from ..columns.column import Column
from ..columns.distinct import distinct
from ..columns.instants import TOGETHER
from ..columns.scan import Array
from ..columns.stamps import NONE
from ..geometry import earth
from ..names.occurrence import Occurrence
from . import axes

STANDARD_GRAVITY = 9.80665  # m/s^2 per g
TESLA = 1e-4  # per gauss
UNKNOWN = [-1.0, *[0.0] * 8]  # the covariance of a missing quantity, as sensor_msgs defines it

#: Fix type -> status in NavSatStatus.
_NO_FIX, _FIX, _SATELLITES, _GROUND = -1, 0, 1, 2
_FIXES = {"fix_rtk_float": _GROUND, "fix_rtk_fixed": _GROUND, "fix_differential": _GROUND}
_FIXES |= {"fix_2d": _FIX, "fix_3d": _FIX}

_ATTITUDE = "filter_data.attitude_quaternion"

#: The ends of the names of the fields from which messages are made.
_USED = (
    ".fix_info",
    ".llh_position",
    "sensor.scaled_accel",
    "sensor.scaled_gyro",
    "sensor.scaled_mag",
    "sensor.comp_quaternion",
    _ATTITUDE,
    "filter_data.ned_velocity",
    "filter_data.comp_angular_rate",
    "filter_data.euler_angles_uncertainty",
    "filter_data.llh_position_uncertainty",
    "filter_data.ned_velocity_uncertainty",
)


class Messages(NamedTuple):
    """The messages of a topic for some packets, one for each; `frame` is the frame in their headers."""

    topic: str
    type: str
    frame: str
    packet: Array
    values: dict[str, Array]  # path -> the values of all messages
    child: str = ""  # the other frame of odometry


class Rows(NamedTuple):
    """The fields of a type in a part of a log: the last one of each packet that has any."""

    packet: Array
    column: Column[Any]
    row: Array
    time: Array  # NONE if the packet itself has none

    def some(self, which: Array) -> Rows:
        return Rows(self.packet[which], self.column, self.row[which], self.time[which])

    def within(self, packet: Array) -> Rows:
        """The fields of these packets."""
        return self.some(np.isin(self.packet, packet))

    def values(self, name: str) -> Array:
        """Returns the values of a parameter; for a vector, an array for each element."""
        return np.asarray(self.column[name][self.row], np.float64).T

    def valid(self, name: str) -> Array:
        """Finds the rows in which a parameter is valid according to its flags, and not NaN."""
        both = (self.column.valid(name), np.isfinite(self.column[name]))
        good, finite = (np.asarray(each.reshape(len(self.column), -1).all(axis=1))[self.row] for each in both)
        return np.asarray(good & finite)


Fields = Mapping[str, Rows]


def message_fields(log: Log, kinds: Iterable[Occurrence], kept: Callable[[Column[Any]], Array], clock: str) -> Fields:
    """Returns, by name, the fields of a part of a log from which messages are made; `kept` selects rows of a column."""
    used = [occurrence for occurrence in kinds if occurrence.name.endswith(_USED)]
    rows_by_name = {}
    for occurrence, column in zip(used, log.columns(used)):
        rows_by_name[occurrence.name] = _rows(column, kept, clock)
    return {name: rows for name, rows in rows_by_name.items() if len(rows.packet)}


def _rows(column: Column[Any], kept: Callable[[Column[Any]], Array], clock: str) -> Rows:
    row = np.flatnonzero(kept(column))[::-1] if len(column) else _NONE
    packet, last = np.unique(column.packet[row], return_index=True)
    times = column.time(clock)
    own = np.where(times.own, times.values.view(np.int64), NONE)
    return Rows(packet, column, row[last], own[row[last]])


class Attitudes(NamedTuple):
    """The valid attitudes of the filter in a part of a log, and shortly before and after it."""

    time: Array  # NONE if the packet itself has none
    offset: Array  # of the packet
    q: Array  # (rows, 4)


def attitudes(
    log: Log, kinds: Iterable[Occurrence], kept: Callable[[Column[Any]], Array], clock: str
) -> Attitudes | None:
    """Returns the attitudes that may belong to packets of a part; None if there are none."""
    kind = next((occurrence for occurrence in kinds if occurrence.name == _ATTITUDE), None)
    if kind is None:
        return None
    before, after = max(log.begin - TOGETHER, 0), min(log.end + TOGETHER, log.size)
    found = []
    for part in (log.part(before, log.begin), log, log.part(log.end, after)):
        rows = _rows(part.column(kind), kept, clock)
        if len(rows.packet):
            rows = rows.some(rows.valid("q"))
            found.append((rows.time, rows.column.offset[rows.row], rows.values("q").T))
    return Attitudes(*(np.concatenate(each) for each in zip(*found))) if found else None


class _Last:
    """The last values before each packet, which may be in an earlier part of the log."""

    def __init__(self, first: float | Sequence[float]) -> None:
        self._last = np.array([first])

    def at(self, packet: Array, packets: Array, values: Array) -> Array:
        """Returns the values at some packets; `values` are the values in the packets `packets`."""
        every = np.concatenate((self._last, values))
        self._last = every[-1:]
        latest: Array = every[np.searchsorted(packets, packet, side="right")]
        return latest


class Converter:
    """Makes messages of the parts of a log, in their order: positions are relative to the first one."""

    def __init__(self, frame: str = "imu_link", world: str = "odom") -> None:
        self._frame, self._world = frame, world
        self._origin: tuple[float, float, earth.Vector] | None = None  # radians, and Earth-fixed
        self._status: dict[str, _Last] = {}  # status of the fix, by the set of the receiver
        self._spread: dict[tuple[str, str], _Last] = {}  # squares of uncertainties, by topic and field

    def messages(self, fields: Fields, attitudes: Attitudes | None = None) -> list[Messages]:
        """Makes the messages of a part, with the attitudes in it and around it.

        Messages of one packet are in the order of the topics below.
        """
        with np.errstate(all="ignore"):  # for infinite values and signaling NaNs
            made = (self._imu(fields, attitudes), self._magnetic(fields), self._fixes(fields), self._odometry(fields))
            return [batch for each in made for batch in each if len(batch.packet)]

    def _imu(self, fields: Fields, attitudes: Attitudes | None) -> Iterator[Messages]:
        accel, gyro, quaternion = (
            fields.get(f"sensor.{n}") for n in ("scaled_accel", "scaled_gyro", "comp_quaternion")
        )
        packet = distinct(_NONE, *(each.packet for each in (accel, gyro) if each is not None))
        time, offset = np.full(len(packet), NONE), np.zeros(len(packet), np.int64)
        force, rate = _each(packet, _ZERO), _each(packet, _ZERO)
        of_force, of_rate = _each(packet, UNKNOWN), _each(packet, UNKNOWN)
        for rows in (gyro, accel):
            if rows is not None:
                at = np.searchsorted(packet, rows.packet)
                time[at], offset[at] = rows.time, rows.column.offset[rows.row]
        if gyro is not None:
            at = np.searchsorted(packet, gyro.packet)
            rate[at] = np.transpose(axes.body(gyro.values("scaled_gyro")))
            of_rate[at] = 0
        if accel is not None:
            at = np.searchsorted(packet, accel.packet)
            force[at] = np.transpose(axes.body(STANDARD_GRAVITY * accel.values("scaled_accel")))
            of_force[at] = 0
        values = {
            **_vector("angular_velocity", rate),
            "angular_velocity_covariance": of_rate,
            **_vector("linear_acceleration", force),
            "linear_acceleration_covariance": of_force,
        }

        def imu(topic: str, at: Array, q: Any, variances: Any) -> Messages:
            """Adds the attitude of some packets; variances of 0 are unknown."""
            orientation, spread = _each(packet, axes.NOT_ROTATED), _each(packet, UNKNOWN)
            if len(at):
                orientation[at] = np.transpose(axes.attitude(q))
                spread[at] = _diagonal(variances[at])
            whole = {**_quaternion("orientation", orientation), "orientation_covariance": spread, **values}
            return Messages(topic, "sensor_msgs/msg/Imu", self._frame, packet, whole)

        at, which = (_NONE, _NONE) if attitudes is None else _of_same_time(time, offset, attitudes)
        variances = self._variances(fields, packet, "imu", "euler_angles", "roll", "pitch", "yaw")
        yield imu("/imu/data", at, () if attitudes is None else attitudes.q[which].T, variances)
        if quaternion is not None:  # that of the sensor on devices whose mounting does not rotate it (docs/robots.md)
            quaternion = quaternion.within(packet)
            at = np.searchsorted(packet, quaternion.packet)
            yield imu("/imu/complementary_filter", at, quaternion.values("q"), _each(packet, _ZERO))

    def _magnetic(self, fields: Fields) -> Iterator[Messages]:
        mag = fields.get("sensor.scaled_mag")
        if mag is not None:
            values = _vector("magnetic_field", np.transpose(axes.body(TESLA * mag.values("scaled_mag"))))
            yield Messages("/imu/mag", "sensor_msgs/msg/MagneticField", self._frame, mag.packet, values)

    def _fixes(self, fields: Fields) -> Iterator[Messages]:
        for set_number in dict.fromkeys(name.partition(".")[0] for name in fields):
            place, fix = fields.get(f"{set_number}.llh_position"), fields.get(f"{set_number}.fix_info")
            if place is not None:
                place = place.some(place.valid("latitude"))
            last = self._status.setdefault(set_number, _Last(_FIX))
            status_of_packets = (_NONE, _NONE) if fix is None else _status(fix)
            status = last.at(_NONE if place is None else place.packet, *status_of_packets)
            if place is None or "horizontal_accuracy" not in place.column.names:
                continue
            good = place.valid("horizontal_accuracy") & place.valid("vertical_accuracy")
            across, up = place.values("horizontal_accuracy") ** 2, place.values("vertical_accuracy") ** 2
            values = {
                "status.status": status,
                "latitude": place.values("latitude"),
                "longitude": place.values("longitude"),
                "altitude": np.where(place.valid("ellipsoid_height"), place.values("ellipsoid_height"), np.nan),
                "position_covariance": np.where(good[:, None], _diagonal(np.transpose((across, across, up))), 0),
                "position_covariance_type": good,
            }
            yield Messages(
                f"/{set_number}/fix", "sensor_msgs/msg/NavSatFix", f"{set_number}_antenna", place.packet, values
            )

    def _odometry(self, fields: Fields) -> Iterator[Messages]:
        place, turned = fields.get("filter_data.llh_position"), fields.get("filter_data.attitude_quaternion")
        packet = _NONE
        if place is not None and turned is not None:
            place, turned = place.some(place.valid("latitude")), turned.some(turned.valid("q"))
            packet = np.intersect1d(place.packet, turned.packet)
            place, turned = place.within(packet), turned.within(packet)
        # Uncertainties may be sent more rarely, and in other packets, than their values.
        around = self._variances(fields, packet, "odometry", "euler_angles", "roll", "pitch", "yaw")
        along = self._variances(fields, packet, "odometry", "llh_position", "east", "north", "down")
        spread = self._variances(fields, packet, "odometry", "ned_velocity", "east", "north", "down")
        if place is None or turned is None:
            return
        q = axes.attitude(turned.values("q"))
        where = (place.values(name).tolist() for name in ("latitude", "longitude", "ellipsoid_height"))
        position = np.array([_ZERO, *(self._local(*llh) for llh in zip(*where))])[1:]
        linear, angular = _each(packet, UNKNOWN), _each(packet, UNKNOWN)
        speed, rate = _each(packet, _ZERO), _each(packet, _ZERO)
        moving, turning = fields.get("filter_data.ned_velocity"), fields.get("filter_data.comp_angular_rate")
        if moving is not None:
            moving = moving.some(moving.valid("north")).within(packet)
            at = np.searchsorted(packet, moving.packet)
            w, x, y, z = (each[at] for each in q)
            velocity = axes.world([moving.values(name) for name in ("north", "east", "down")])
            speed[at] = np.transpose(axes.into_body((w, x, y, z), velocity))
            linear[at] = np.transpose(axes.variances_into_body((w, x, y, z), spread[at].T))
        if turning is not None:
            turning = turning.some(turning.valid("gyro")).within(packet)
            at = np.searchsorted(packet, turning.packet)
            rate[at] = np.transpose(axes.body(turning.values("gyro")))
            angular[at] = 0
        values = {
            **_vector("pose.pose.position", position),
            **_quaternion("pose.pose.orientation", np.transpose(q)),
            "pose.covariance": _blocks(_diagonal(along), _diagonal(around)),
            **_vector("twist.twist.linear", speed),
            **_vector("twist.twist.angular", rate),
            "twist.covariance": _blocks(linear, angular),
        }
        yield Messages("/filter/odometry", "nav_msgs/msg/Odometry", self._world, packet, values, self._frame)

    def _local(self, latitude: float, longitude: float, height: float) -> axes.Vector:
        """Returns east, north, up from the first position, in m."""
        lat, lon = radians(latitude), radians(longitude)
        at = earth.ecef(lat, lon, height)
        if self._origin is None:
            self._origin = lat, lon, at
        lat, lon, origin = self._origin
        x, y, z = (a - b for a, b in zip(at, origin))
        return axes.world(earth.to_ned(lat, lon, (x, y, z)))

    def _variances(self, fields: Fields, packet: Array, topic: str, name: str, *parameters: str) -> Array:
        """Returns the squares of the last standard deviations for a topic; zeros if they are unknown."""
        field = fields.get(f"filter_data.{name}_uncertainty")
        packets, values = _NONE, _each(_NONE, _ZERO)
        if field is not None:
            packets, values = field.packet, np.transpose([field.values(p) ** 2 for p in parameters])
            values[~field.valid(parameters[0])] = 0
        return self._spread.setdefault((topic, name), _Last(_ZERO)).at(packet, packets, values)


_NONE: Array = np.zeros(0, np.int64)
_ZERO = (0.0, 0.0, 0.0)


def _status(fix: Rows) -> tuple[Array, Array]:
    """Returns the packets with a fix, and its status in NavSatStatus."""
    fix = fix.some(fix.valid("fix_type"))
    kinds, flags = (info(fix.column.parameters[name].type) for name in ("fix_type", "fix_flags"))
    of_value = {value: _FIXES.get(name, _NO_FIX) for value, name in kinds.names.items()}
    status = np.array([of_value.get(v, _NO_FIX) for v in fix.column["fix_type"][fix.row].tolist()], np.int64)
    used = next((bit.mask for bit in flags.bits if bit.name == "sbas_used"), 0)
    sbas = fix.valid("fix_flags") & (fix.column["fix_flags"][fix.row] & used != 0)
    return fix.packet, np.where(sbas & (status == _FIX), _SATELLITES, status)


def _of_same_time(time: Array, offset: Array, fields: Attitudes) -> tuple[Array, Array]:
    """Finds the packets with the time of a field nearby. Returns the packets and, for each, the number of the field."""
    which = np.full(len(time), -1)
    order = np.argsort(fields.time, kind="stable")
    times, offsets = fields.time[order], fields.offset[order]
    first, last = np.searchsorted(times, time), np.searchsorted(times, time, side="right") - 1
    for place in (first, last) if len(order) else ():  # a clock that restarts may have the same time twice
        at = np.clip(place, 0, len(order) - 1)
        near = (times[at] == time) & (time != NONE) & (np.abs(offsets[at] - offset) <= TOGETHER)
        which[near] = order[at[near]]
    there = np.flatnonzero(which >= 0)
    return there, which[there]


def _each(packet: Array, first: Sequence[float]) -> Array:
    """Repeats the same values for each packet."""
    return np.tile(np.array(first), (len(packet), 1))


def _vector(path: str, v: Array) -> dict[str, Array]:
    return {f"{path}.{name}": v[:, i] for i, name in enumerate("xyz")}


def _quaternion(path: str, q: Array) -> dict[str, Array]:
    return {f"{path}.{name}": q[:, i] for i, name in enumerate("wxyz")}


def _diagonal(variances: Array) -> Array:
    """Makes diagonal 3 x 3 covariances, row by row."""
    made = np.zeros((len(variances), 9))
    made[:, ::4] = variances
    return made


def _blocks(first: Array, second: Array) -> Array:
    """Joins two 3 x 3 covariances with independent errors to 6 x 6 ones."""
    made = np.zeros((len(first), 6, 6))
    made[:, :3, :3], made[:, 3:, 3:] = first.reshape(-1, 3, 3), second.reshape(-1, 3, 3)
    return made.reshape(-1, 36)
