"""The results of examining a stream."""

from __future__ import annotations

from dataclasses import dataclass, field

from .events import Event

#: A descriptor set, and a descriptor in it.
Key = tuple[int, int]


@dataclass
class Warned:
    """A warning bit that is set in data."""

    field: str
    bit: str
    text: str
    concerns: tuple[str, ...]
    count: int
    total: int
    last: bool  # is it set in the last field?


@dataclass
class Examined:
    """The results of examining a stream."""

    size: int = 0
    packets: int = 0
    clock: str | None = None
    events: list[Event] = field(default_factory=list)
    warned: list[Warned] = field(default_factory=list)
    unsynchronized: dict[int, tuple[int, int]] = field(default_factory=dict)  # set -> number of invalid times, of all
    untimed: list[int] = field(default_factory=list)  # sets without timestamps
    rates: dict[Key, float] = field(default_factory=dict)  # in Hz, from the last usual interval
    names: dict[Key, str] = field(default_factory=dict)
    spans: dict[int, list[tuple[int, int]]] = field(default_factory=dict)  # set -> when its packets arrived, in ns
    sentences: int = 0
    unnamed: list[str] = field(default_factory=list)  # fields whose flags depend on the device


__all__ = ["Examined", "Key", "Warned"]
