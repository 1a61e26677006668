"""The clocks of timestamps, and how far they are ahead of UTC."""

from __future__ import annotations

#: Clock -> the day of its epoch; None if it has none. Preferred clocks come first.
CLOCKS: dict[str, str | None] = {
    "gps": "1980-01-06",
    "external": None,
    "reference": None,
    "device": None,
}

#: Set and descriptor of the fields that contain the time of their packet -> the clock, and the one
#: that has the time when it is not valid as a date.
TIMESTAMPS: dict[tuple[int, int], tuple[str, ...]] = {
    (0xFF, 0xD3): ("gps", "device"),
    (0x80, 0x12): ("gps", "device"),
    (0x82, 0x11): ("gps", "device"),
    (0x81, 0x09): ("gps",),
    (0x91, 0x09): ("gps",),
    (0x92, 0x09): ("gps",),
    (0x94, 0x09): ("gps",),
    (0x95, 0x09): ("gps",),
    (0xFF, 0xD7): ("external",),
    (0xFF, 0xD5): ("reference",),
}

#: The clock of times that are not valid as a date; "" if there is none.
DEVICE_CLOCK = "device"

#: Symbol of a unit -> its key, if that differs.
UNIT_KEYS: dict[str, str] = {}

#: Day -> the seconds by which clocks with an epoch are ahead of UTC, from 00:00 UTC on that day.
LEAP_SECONDS: tuple[tuple[str, int], ...] = (
    ("1981-07-01", 1),
    ("1982-07-01", 2),
    ("1983-07-01", 3),
    ("1985-07-01", 4),
    ("1988-01-01", 5),
    ("1990-01-01", 6),
    ("1991-01-01", 7),
    ("1992-07-01", 8),
    ("1993-07-01", 9),
    ("1994-07-01", 10),
    ("1996-01-01", 11),
    ("1997-07-01", 12),
    ("1999-01-01", 13),
    ("2006-01-01", 14),
    ("2009-01-01", 15),
    ("2012-07-01", 16),
    ("2015-07-01", 17),
    ("2017-01-01", 18),
)
