"""The clocks of timestamps, and by how much they are ahead of UTC."""

from __future__ import annotations

#: Clock -> the day on which it began; None if it starts with the device. Those to prefer come first.
CLOCKS: dict[str, str | None] = {"wall": "2000-01-01", "uptime": None}

#: Set and descriptor of the fields that hold the time of their packet -> its clock.
TIMESTAMPS: dict[tuple[int, int], str] = {(0xFF, 0xD3): "wall", (0x80, 0x08): "uptime"}

#: The days from whose beginning in UTC on the clocks with a day are so many seconds ahead of UTC.
LEAP_SECONDS: tuple[tuple[str, int], ...] = (("2000-01-02", 1), ("2001-01-01", 3))
