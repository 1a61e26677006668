"""The quantities of GNSS receivers and their satellites."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import hypot, pi
from typing import Any

from mip_tools.geometry import earth
from mip_tools.geometry.earth import LIGHT, SECOND, Vector

from ..surroundings import satellites
from .world import World

Function = Callable[[World, Any], Any]

#: The dilution of precision; the parts add up.
_DOP = {"gdop": 1.3, "pdop": 1.2, "hdop": 0.72, "vdop": 0.96, "tdop": 0.5, "ndop": 0.52, "edop": 0.498}
#: How long corrections are used.
CORRECTED = 10 * SECOND


def _length(v: Vector) -> float:
    return float(hypot(*v))


def _base_station(w: World, _: Any) -> Vector:
    latitude, longitude, height = earth.llh(*w.start_place)
    return earth.ecef(latitude + 5000.0 / earth.A, longitude, height)


def _aiding(w: World, item: Any) -> tuple[str, ...]:
    """The aiding of the filter by a receiver, or by both."""
    if not w.gnss or getattr(item, "id", 0) not in {0, *w.filter.options.receivers}:
        return ("no_fix",)
    return "tight_coupling", "gps_l1", "glonass_l1", "galileo_e1", "beidou_b1"


def corrected(w: World) -> bool:
    """Do the receivers use corrections?"""
    return w.corrected is not None and w.now - w.corrected < CORRECTED


def _gnss(receiver: int) -> dict[str, Function]:
    """The quantities of one receiver."""

    def course_accuracy(w: World, _: Any) -> float:
        n, e, _d = w.antenna(receiver).velocity
        return min(pi, 0.1 / max(hypot(n, e), 1e-3))

    def ecef_velocity(w: World, _: Any) -> Vector:
        a = w.fix(receiver)
        return earth.from_ned(a.latitude, a.longitude, a.velocity)

    own: dict[str, Function] = {
        "latitude": lambda w, _: w.fix(receiver).latitude,
        "longitude": lambda w, _: w.fix(receiver).longitude,
        "height": lambda w, _: w.fix(receiver).height,
        "msl_height": lambda w, _: w.fix(receiver).height - w.geoid,
        "ecef": lambda w, _: w.fix(receiver).ecef,
        "velocity": lambda w, _: w.fix(receiver).velocity,
        "ecef_velocity": ecef_velocity,
        "speed": lambda w, _: _length(w.fix(receiver).velocity),
        "ground_speed": lambda w, _: hypot(*w.fix(receiver).velocity[:2]),
        "course": lambda w, _: w.course(w.fix(receiver).velocity),
        "course_accuracy": course_accuracy,
        "clock_bias": lambda w, _: w.receiver_clock(receiver)[0],
        "clock_drift": lambda w, _: w.receiver_clock(receiver)[1],
        "satellites": lambda w, _: w.satellites,
    }
    return {f"gnss_{receiver}.{name}": function for name, function in own.items()}


#: Names -> world and item -> value.
GNSS: dict[str, Function] = {
    "gnss.fix": lambda w, _: w.gnss,
    "gnss.fix_type": lambda w, _: "fix_none" if not w.gnss else "fix_rtk_fixed" if corrected(w) else "fix_3d",
    "gnss.fix_flags": lambda w, _: ("sbas_used",) * w.gnss + ("dgnss_used",) * (w.gnss and corrected(w)),
    "gnss.aiding": _aiding,
    **_gnss(1),
    **_gnss(2),
    **{f"dop.{name}": partial(lambda value, w, _: value, value) for name, value in _DOP.items()},
    "gnss.horizontal_accuracy": lambda w, _: 1.0,
    "gnss.vertical_accuracy": lambda w, _: 1.5,
    "gnss.position_accuracy": lambda w, _: hypot(1.0, 1.5),
    "satellite.index": lambda w, s: s.number,
    "satellite.count": lambda w, s: s.of,
    "satellite.used": lambda w, _: len(w.satellites),
    "satellite.channel": lambda w, s: s.number,
    "satellite.constellation": lambda w, s: s.constellation,
    "satellite.id": lambda w, s: s.id,
    "satellite.signal": lambda w, s: s.signal,
    "satellite.elevation": lambda w, s: s.elevation,
    "satellite.azimuth": lambda w, s: s.azimuth,
    "satellite.strength": lambda w, s: s.strength,
    "satellite.pseudorange": lambda w, s: s.pseudorange,
    "satellite.phase": lambda w, s: s.pseudorange * s.frequency / LIGHT,
    "satellite.doppler": lambda w, s: -w.receiver_clock(1)[1] * s.frequency,
    "satellite.lock_time": lambda w, s: (w.now - w.booted) / SECOND,
    "gnss.gps_satellites": lambda w, _: satellites.only(w.satellites, "gps"),
    "base_station.ecef": _base_station,
}
