"""The satellites that the receivers of a virtual device see: the same at all places and times."""

from __future__ import annotations

from collections.abc import Sequence
from math import radians, sin
from typing import NamedTuple

#: Constellation -> signal, its frequency in Hz, and the mean distance of the satellites in m.
_SIGNALS = {
    "gps": ("gps_l1ca", 1575.42e6, 2.2e7),
    "glonass": ("glonass_g1ca", 1602.0e6, 2.1e7),
    "galileo": ("galileo_e1bc", 1575.42e6, 2.5e7),
    "beidou": ("beidou_b1i", 1561.098e6, 2.3e7),
}
#: Satellites of each constellation: id, elevation and azimuth in degrees.
_SKY = ((3, 75, 40), (8, 48, 160), (11, 35, 280), (17, 22, 75), (22, 14, 210))


class Seen(NamedTuple):
    """A satellite as an antenna sees it."""

    number: int  # within the list, from 1
    of: int  # the length of the list
    constellation: str
    id: int
    signal: str
    frequency: float  # Hz
    elevation: float
    azimuth: float
    pseudorange: float

    @property
    def strength(self) -> float:
        """Carrier to noise density ratio in dB-Hz."""
        return 35 + 15 * sin(self.elevation)


def _numbered(satellites: Sequence[Seen]) -> tuple[Seen, ...]:
    return tuple(s._replace(number=i, of=len(satellites)) for i, s in enumerate(satellites, 1))


IN_VIEW = _numbered(
    [
        Seen(
            0,
            0,
            name,
            number,
            signal,
            frequency,
            radians(up),
            radians(azimuth),
            distance + 4e6 * (1 - sin(radians(up))),
        )
        for name, (signal, frequency, distance) in _SIGNALS.items()
        for number, up, azimuth in _SKY
    ]
)


def only(satellites: Sequence[Seen], constellation: str) -> tuple[Seen, ...]:
    """Returns the satellites of one constellation, renumbered."""
    return _numbered([s for s in satellites if s.constellation == constellation])
