"""The clocks of timestamps, and how far they are ahead of UTC."""

from __future__ import annotations

#: Clock -> the day of its epoch; None if it has none. Preferred clocks come first.
CLOCKS: dict[str, str | None] = {"wall": "2000-01-01", "uptime": None}

#: Set and descriptor of the fields that contain the time of their packet -> the clock.
TIMESTAMPS: dict[tuple[int, int], str] = {(0xFF, 0xD3): "wall", (0x80, 0x08): "uptime"}

#: Day -> the seconds by which clocks with an epoch are ahead of UTC, from 00:00 UTC on that day.
LEAP_SECONDS: tuple[tuple[str, int], ...] = (("2000-01-02", 1), ("2001-01-01", 3))
