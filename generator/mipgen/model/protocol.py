"""The protocol itself: framing, function selectors, vocabularies, clocks."""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import date

from mipgen.read.problems import Position

from .evidence import Manual
from .fields import Field
from .types import Enum, Function, Source

#: The package for which the templates and runtimes of the targets are written.
OWN_PACKAGE = "mip"


@dataclass(frozen=True, slots=True)
class Conversion:
    """The conversion from a frame to the frame of other software."""

    name: str
    title: str
    axes: tuple[str, ...]  # the directions of x, y and z there
    values: tuple[str, ...]  # x, y and z there, by the elements of a vector in the frame: ("y", "x", "-z")
    description: str


@dataclass(frozen=True, slots=True)
class Word:
    """An entry of a controlled vocabulary: a unit or a frame of reference."""

    symbol: str
    title: str
    description: str
    plural: str = ""  # of a unit that is a word: its plural
    numbered: bool = False  # of a unit: values are ordinal, "week 2412"
    elements: tuple[str, ...] = ()  # of a frame: the elements of its vectors, if not x, y, z
    axes: tuple[str, ...] = ()  # of a frame: the directions of x, y and z; right-handed
    origin: str = ""  # of a frame: the location of its origin
    conversions: tuple[Conversion, ...] = ()  # of a frame: to the frames of other software
    sources: tuple[Source, ...] = ()  # of a frame
    key: str = ""  # of a unit: what fields of the specification state
    equals: tuple[str, float] | None = None  # of a unit: a number of another unit


@dataclass(frozen=True, slots=True)
class Chapter:
    """Notes on the protocol for programmers that concern no single field."""

    title: str
    text: tuple[str, ...]  # paragraphs
    sources: tuple[Source, ...]


@dataclass(frozen=True, slots=True)
class Clock:
    """A clock of timestamps."""

    name: str
    title: str
    description: str
    epoch: str | None  # "1980-01-06"; None: it starts with the device
    timestamps: tuple[str, ...]  # full names of the data fields that contain its time
    position: Position | None = field(default=None, compare=False)

    @property
    def epoch_days(self) -> int | None:
        """The days from 1970 to its epoch."""
        return days(self.epoch) if self.epoch else None


@dataclass(frozen=True, slots=True)
class Older:
    """The full names of the commands that start the data of one set on older devices."""

    set: str
    base_rate: str
    format: str
    stream: int  # its number for the stream, in place of the descriptor set
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Session:
    """The full names of the commands that identify a device and start its data."""

    baud: int  # the baud rate of a new device
    ping: str
    idle: str
    resume: str
    identify: str
    model_numbers: tuple[str, ...]  # paths in its response: "device_info.model_number"
    base_rate: str
    format: str
    stream: str
    older: tuple[Older, ...] = ()
    descriptors: tuple[str, ...] = ()  # commands that list what the device has
    position: Position | None = field(default=None, compare=False)

    @property
    def commands(self) -> tuple[str, ...]:
        return (self.ping, self.idle, self.resume, self.identify, self.base_rate, self.format, self.stream)


@dataclass(frozen=True, slots=True)
class Usage:
    """The word that names use for a thing, and the words to avoid."""

    word: str
    instead_of: tuple[str, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Protocol:
    name: str
    title: str  # what it is, after "the": "MIP protocol of MicroStrain inertial sensors"
    package: str  # the name of libraries and packages: `mip` for `mip_parser_init`, `mip_protocol`
    keywords: tuple[str, ...]  # for searches
    version: str
    sync: tuple[int, int]
    max_payload: int
    functions: tuple[Function, ...]
    acknowledge: Field
    ack_code: Enum
    function_selector: Enum
    units: tuple[Word, ...]
    frames: tuple[Word, ...]
    manuals: tuple[Manual, ...]
    notes: tuple[Chapter, ...] = ()
    vocabulary: tuple[Usage, ...] = ()
    synonyms: tuple[tuple[str, ...], ...] = ()  # words of the same meaning
    clocks: tuple[Clock, ...] = ()  # preferred clocks come first
    session: Session | None = None
    barrier: tuple[int, int] = (0, 0)  # set and descriptor of the barrier's command; 0: none
    repository: str = ""  # its public address
    position: Position | None = field(default=None, compare=False)  # of the name of the package
    leap_seconds: tuple[tuple[str, int], ...] = ()  # day -> seconds that clocks with an epoch are ahead of UTC

    @property
    def max_packet(self) -> int:
        """The most bytes of a packet, with header and checksum."""
        return 4 + self.max_payload + 2

    @property
    def leaps(self) -> tuple[tuple[int, int], ...]:
        """The leap seconds, each with the days from 1970."""
        return tuple((days(day), ahead) for day, ahead in self.leap_seconds)


def days(date_text: str) -> int:
    """Returns the days from 1970 to a date."""
    return (date.fromisoformat(date_text) - date(1970, 1, 1)).days
