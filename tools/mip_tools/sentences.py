"""NMEA sentences: finds them in the bytes between packets, and composes them."""

from __future__ import annotations

import re
from datetime import datetime
from math import degrees

#: A sentence has at most 82 characters; some devices send longer proprietary ones.
LONGEST = 1024

_END = re.compile(rb"\*([0-9A-Fa-f]{2})\r?\Z")


class Sentences:
    """Accepts bytes in pieces of any size, and returns complete sentences with a correct checksum.

    >>> sentences = Sentences()
    >>> sentences.feed(b"ue$GPZDA,,,,,,*48" + bytes([13]))
    []
    >>> sentences.feed(bytes([10]))
    ['$GPZDA,,,,,,*48']
    """

    def __init__(self) -> None:
        self._line = bytearray()
        self._taken = 0  # bytes before this line

    def feed(self, data: bytes) -> list[str]:
        """Returns the sentences that these bytes complete, without line ends."""
        return [sentence for _, sentence in self.placed(data)]

    def placed(self, data: bytes) -> list[tuple[int, str]]:
        """Returns the same sentences, each with the offset of its beginning in all fed bytes."""
        self._line += data
        *lines, rest = self._line.split(b"\n")
        found = []
        for line in lines:
            if (sentence := last(line[-LONGEST:])) is not None:
                begin, text = sentence
                found.append((self._taken + max(0, len(line) - LONGEST) + begin, text))
            self._taken += len(line) + 1
        self._taken += max(0, len(rest) - LONGEST)
        self._line = rest[-LONGEST:]
        return found


def last(line: bytes | bytearray) -> tuple[int, str] | None:
    """Finds the sentence at the end of a line, and where it begins; bytes before it are noise."""
    end = _END.search(line)
    if end is None:
        return None
    wanted, xor = int(end[1], 16), 0
    for at in range(end.start() - 1, -1, -1):
        byte = line[at]
        if not 0x20 <= byte <= 0x7E:
            return None
        # Texts may also contain such a character: the checksum decides.
        if byte in b"$!" and xor == wanted and at + 1 < end.start():
            return at, line[at:].rstrip(b"\r").decode("ascii")
        xor ^= byte
    return None


def nmea_checksum(text: str) -> str:
    """Computes the checksum of the text between `$` and `*`.

    >>> nmea_checksum("PMSRA,221336.93,-0.172,-0.681,3.072")
    '5D'
    """
    value = 0
    for byte in text.encode("ascii"):
        value ^= byte
    return f"{value:02X}"


def nmea_sentence(text: str) -> str:
    """Adds `$`, the checksum and the line end."""
    return f"${text}*{nmea_checksum(text)}\r\n"


def nmea_clock(time: datetime | None) -> str:
    """Formats the time of day; empty if the time is not known."""
    return "" if time is None else f"{time:%H%M%S}.{time.microsecond // 10_000:02d}"


def nmea_place(latitude: float, longitude: float) -> str:
    """Formats a place, in radians, as degrees and minutes with five decimals, and hemispheres."""
    return f"{_angle(latitude, 2, 'NS')},{_angle(longitude, 3, 'EW')}"


def _angle(radians: float, width: int, signs: str) -> str:
    minutes = round(abs(degrees(radians)) * 60 * 100_000)
    whole, rest = divmod(minutes, 60 * 100_000)
    return f"{whole:0{width}d}{rest // 100_000:02d}.{rest % 100_000:05d},{signs[radians < 0]}"


def gga(
    time: datetime | None, place: str, used: int, hdop: float, height: float, geoid: float, quality: int = 1
) -> str:
    """Composes the text of a GGA sentence, without the talker: `height` is above mean sea level, `geoid` that of the
    sea level above the ellipsoid, in metres. `quality` 1 is a fix without corrections."""
    return f"GGA,{nmea_clock(time)},{place},{quality},{used:02d},{hdop:.2f},{height:.2f},M,{geoid:.2f},M,,"
