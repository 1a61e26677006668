"""The commands that start the data of a device."""

from __future__ import annotations

from .streaming import Session


def session() -> Session | None:
    """Imports the modules of these commands. None if the specification names none."""
    return None
