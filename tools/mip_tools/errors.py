"""Exceptions that end a command, with the line that it prints."""

from __future__ import annotations


class Failure(Exception):
    """An error that ends a command: the message states the problem and the remedy in one line."""

    def __init__(self, text: str, status: int = 1) -> None:
        super().__init__(text)
        self.status = status


class Misuse(Failure):
    """A wrong command line: an unknown name, an impossible value."""

    def __init__(self, text: str) -> None:
        super().__init__(text, 2)


class NoBinding(Failure, ImportError):
    """There is no generated package, or it lacks something that a tool needs."""
