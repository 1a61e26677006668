"""Displacement commands (0x11).

Commands of the DEMOD-DC, a demodulator for displacement sensors. Inertial sensors have none of
them.

- mscl: Displacement Commands (0x11)
"""

from __future__ import annotations

from .field import Field

#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {}
