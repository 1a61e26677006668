"""NACK codes, and the function selectors that all devices treat alike."""

from __future__ import annotations

OK = 0
UNKNOWN_COMMAND = 1
INVALID_PARAMETER = 3
COMMAND_FAILED = 4
UNKNOWN_SET = 6

WRITE = 1
READ = 2
SAVE = 3
LOAD = 4
DEFAULT = 5
APPLY = 6

#: The functions that set a new value.
SETS = (WRITE, APPLY)


class Refused(Exception):
    """The device rejects a command with this `code`."""

    def __init__(self, code: int) -> None:
        super().__init__(f"refused with code {code}")
        self.code = code
