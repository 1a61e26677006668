"""The results of examining a stream."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .events import Event

if TYPE_CHECKING:
    from ..columns.timeline import TimesOfSet

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
class SeldomValid:
    """A field whose values are seldom or never valid."""

    title: str
    valid: int
    total: int
    state: str  # of the filter, at the end


@dataclass
class Examined:
    """The results of examining a stream."""

    size: int = 0
    begin: bytes = b""  # the first bytes
    packets: int = 0
    malformed: int = 0  # packets with a field that runs past their end
    clock: str | None = None
    events: list[Event] = field(default_factory=list)
    warned: list[Warned] = field(default_factory=list)
    times: dict[int, TimesOfSet] = field(default_factory=dict)  # set -> what is known of its times
    seldom_valid: list[SeldomValid] = field(default_factory=list)
    untimed: list[int] = field(default_factory=list)  # sets without timestamps
    rates: dict[Key, float] = field(default_factory=dict)  # in Hz, from the last usual interval
    names: dict[Key, str] = field(default_factory=dict)
    spans: dict[int, list[tuple[int, int]]] = field(default_factory=dict)  # set -> when its packets arrived, in ns
    seconds: float = 0.0  # from the first packet to the last by this clock, without its steps back
    sentences: int = 0
    devices: list[str] = field(default_factory=list)  # that have replied
    unnamed: list[str] = field(default_factory=list)  # fields whose flags depend on the device
