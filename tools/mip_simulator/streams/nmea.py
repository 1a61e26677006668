"""Composes the NMEA 0183 sentences of the device: standard ones, and the vendor's proprietary ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from datetime import datetime
from math import degrees, hypot
from typing import Any, NamedTuple, Protocol

from mip_tools.binding import SETS
from mip_tools.geometry.attitude import euler
from mip_tools.geometry.earth import Vector, gps_to_utc
from mip_tools.sentences import gga, nmea_clock, nmea_place, nmea_sentence

from ..surroundings.satellites import only
from ..world.quantities import quantity
from ..world.receivers import corrected
from ..world.world import World

KNOT = 1852 / 3600
GRAVITY = 9.80665

#: Data set -> the receiver whose antenna position the sentences contain; None: the position of the filter.
_SOURCES: dict[str, int | None] = {"filter_data": None, "gnss_data": 1, "gnss_1": 1, "gnss_2": 2}
_TALKERS = {"gnss": "GN", "gps": "GP", "galileo": "GA", "glonass": "GL"}

#: Qualities of a fix, and the modes that state them in RMC; GLL and VTG have no mode for RTK.
_AUTONOMOUS, _RTK, _ESTIMATED = 1, 4, 6
_MODES = {_AUTONOMOUS: "A", _RTK: "R", _ESTIMATED: "E"}

#: Constellation -> talker of its satellites, and the offset of their numbers.
_CONSTELLATIONS = {"gps": ("GP", 0), "glonass": ("GL", 64), "galileo": ("GA", 0), "beidou": ("GB", 0)}


class Entry(Protocol):
    """A sentence, as `types.NmeaMessage` describes it."""

    message_id: Any
    talker_id: Any
    source_descriptor_set: int


class _Fix(NamedTuple):
    """The content of the sentences, from one source."""

    time: datetime | None  # None: not known
    quality: int  # as in GGA; 0: no position
    latitude: float
    longitude: float
    height: float
    velocity: Vector
    deviation: Vector  # of the position north, east and down
    receiver: int


def _fix(world: World, receiver: int | None) -> _Fix:
    measured = 0 if not world.gnss else _RTK if corrected(world) else _AUTONOMOUS
    if receiver is None:
        s = world.place
        time = gps_to_utc(world.clock) if world.dated else None
        quality = (measured or _ESTIMATED) if world.filter.placed else 0
        n, e, d = (quantity(world, f"uncertainty.{axis}") for axis in ("north", "east", "down"))
        return _Fix(time, quality, s.latitude, s.longitude, s.height, s.velocity, (n, e, d), 1)
    a = world.fix(receiver)
    time = gps_to_utc(world.gps) if world.gnss else None
    across = quantity(world, "gnss.horizontal_accuracy") / 2**0.5
    up = quantity(world, "gnss.vertical_accuracy")
    return _Fix(time, measured, a.latitude, a.longitude, a.height, a.velocity, (across, across, up), receiver)


# --------------------------------------------------------------------------- parts of sentences


def _place(fix: _Fix) -> str:
    return nmea_place(fix.latitude, fix.longitude)


def _mode(fix: _Fix) -> str:
    """Returns the mode of GLL and VTG, in which RTK is differential."""
    return "D" if fix.quality == _RTK else _MODES[fix.quality]


def _course(angle: float) -> str:
    return f"{round(angle % 360, 2) % 360:.2f}"


def _declination(world: World) -> float:
    return degrees(quantity(world, "magnetic.declination"))


# --------------------------------------------------------------------------- sentences


def _gga(world: World, fix: _Fix) -> Iterator[str]:
    used, hdop = len(world.satellites), quantity(world, "dop.hdop")
    yield gga(fix.time, _place(fix), used, hdop, fix.height - world.geoid, world.geoid, fix.quality)


def _gll(world: World, fix: _Fix) -> Iterator[str]:
    yield f"GLL,{_place(fix)},{nmea_clock(fix.time)},A,{_mode(fix)}"


def _gsv(world: World, fix: _Fix) -> Iterator[str]:
    for constellation, (talker, offset) in _CONSTELLATIONS.items():
        seen = only(world.satellites, constellation)
        groups = [seen[i : i + 4] for i in range(0, len(seen), 4)] or [()]
        for number, group in enumerate(groups, 1):
            text = f"{talker}GSV,{len(groups)},{number},{len(seen):02d}"
            for s in group:
                azimuth = round(degrees(s.azimuth)) % 360
                text += f",{s.id + offset:02d},{degrees(s.elevation):02.0f},{azimuth:03d},{s.strength:02.0f}"
            yield text


def _rmc(world: World, fix: _Fix) -> Iterator[str]:
    north, east, _ = fix.velocity
    knots, course = hypot(north, east) / KNOT, degrees(world.course(fix.velocity))
    away = _declination(world)
    date = "" if fix.time is None else f"{fix.time:%d%m%y}"
    motion, declination = f"{knots:.3f},{_course(course)}", f"{abs(away):.1f},{'EW'[away < 0]}"
    yield f"RMC,{nmea_clock(fix.time)},A,{_place(fix)},{motion},{date},{declination},{_MODES[fix.quality]}"


def _vtg(world: World, fix: _Fix) -> Iterator[str]:
    north, east, _ = fix.velocity
    speed, course = hypot(north, east), degrees(world.course(fix.velocity))
    magnetic = _course(course - _declination(world))
    yield f"VTG,{_course(course)},T,{magnetic},M,{speed / KNOT:.3f},N,{speed * 3.6:.3f},K,{_mode(fix)}"


def _hdt(world: World, fix: _Fix) -> Iterator[str]:
    yaw = euler(world.attitude[1])[2]
    if world.filter.aligned:
        yield f"HDT,{_course(degrees(yaw))},T"


def _zda(world: World, fix: _Fix) -> Iterator[str]:
    if fix.time is not None:
        yield f"ZDA,{nmea_clock(fix.time)},{fix.time:%d,%m,%Y},00,00"


def _gst(world: World, fix: _Fix) -> Iterator[str]:
    n, e, d = fix.deviation
    major, minor, direction = max(n, e), min(n, e), 0.0 if n >= e else 90.0
    rms = hypot(n, e, d)
    yield f"GST,{nmea_clock(fix.time)},{rms:.2f},{major:.2f},{minor:.2f},{direction},{n:.2f},{e:.2f},{d:.2f}"


def _msra(world: World, fix: _Fix) -> Iterator[str]:
    roll, pitch, yaw = (degrees(angle) for angle in euler(world.attitude[1]))
    if world.filter.level:
        yield f"PMSRA,{nmea_clock(fix.time)},{roll:.3f},{pitch:.3f},{yaw:.3f}"


def _msrr(world: World, fix: _Fix) -> Iterator[str]:
    force = [x / GRAVITY for x in quantity(world, "measured.specific_force")]
    rate = [degrees(x) for x in quantity(world, "measured.angular_rate")]
    yield f"PMSRR,{nmea_clock(fix.time)}," + ",".join(f"{x:.6f}" for x in (*force, *rate))


class _Sentence(NamedTuple):
    make: Callable[[World, _Fix], Iterator[str]]
    sources: tuple[str, ...]
    talker: bool = True  # can it be chosen?
    placed: bool = False  # is it sent only with a position?


_GNSS = tuple(name for name, receiver in _SOURCES.items() if receiver is not None)
_SENTENCES = {
    "gga": _Sentence(_gga, tuple(_SOURCES), placed=True),
    "gll": _Sentence(_gll, tuple(_SOURCES), placed=True),
    "gsv": _Sentence(_gsv, _GNSS, talker=False),
    "rmc": _Sentence(_rmc, tuple(_SOURCES), placed=True),
    "vtg": _Sentence(_vtg, tuple(_SOURCES), placed=True),
    "hdt": _Sentence(_hdt, tuple(_SOURCES)),
    "zda": _Sentence(_zda, _GNSS),
    "gst": _Sentence(_gst, tuple(_SOURCES), placed=True),
    "msra": _Sentence(_msra, ("filter_data",), talker=False),
    "msrr": _Sentence(_msrr, ("sensor",), talker=False),
}


def _sentence(entry: Entry) -> tuple[_Sentence, str, str] | None:
    """Finds the sentence, its source and its talker; None if there is no such sentence."""
    sentence = _SENTENCES.get(getattr(entry.message_id, "name", "").lower())
    source = SETS.get(entry.source_descriptor_set, ("",))[0]
    if sentence is None or source not in sentence.sources:
        return None
    if not sentence.talker:
        return sentence, source, ""
    talker = _TALKERS.get(getattr(entry.talker_id, "name", "").lower())
    return None if talker is None else (sentence, source, talker)


def is_gnss(source: int) -> bool:
    """Are the sentences of this data set those of a receiver?"""
    return SETS.get(source, ("",))[0] in _GNSS


def is_supported(entry: Entry) -> bool:
    """Is there such a sentence with this talker, from this source?"""
    return _sentence(entry) is not None


def compose_sentences(entries: Iterable[Entry], world: World) -> bytes:
    """Composes the sentences at the world's time, with checksums and line ends.

    Unknown entries are skipped, and those whose data is not valid.
    """
    lines = []
    for entry in entries:
        chosen = _sentence(entry)
        if chosen is not None:
            sentence, source, talker = chosen
            fix = _fix(world, _SOURCES.get(source))
            if sentence.placed and not fix.quality:
                continue
            lines += [nmea_sentence(talker + text) for text in sentence.make(world, fix)]
    return "".join(lines).encode("ascii")
