"""The error that ends the program with a message."""

from __future__ import annotations


class Failure(Exception):
    """A message for the user: the problem and the remedy."""

    def __init__(self, message: str, place: str = "mipgen") -> None:
        super().__init__(message, place)

    def __str__(self) -> str:
        message, place = self.args
        return f"{place}: error: {message}"
