"""What ends the program with a message."""

from __future__ import annotations


class Failure(Exception):
    """Something to tell the person at the command line: what is wrong, and what would be right."""

    def __init__(self, message: str, place: str = "mipgen") -> None:
        super().__init__(message, place)

    def __str__(self) -> str:
        message, place = self.args
        return f"{place}: error: {message}"
