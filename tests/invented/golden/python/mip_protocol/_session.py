"""The commands that start the data of a device."""

from __future__ import annotations


def session() -> None:
    """Imports the modules of these commands and returns the commands; None if the specification names none."""
    return None
