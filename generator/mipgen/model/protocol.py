"""The protocol itself: framing, function selectors, vocabularies, clocks."""

from __future__ import annotations

from dataclasses import dataclass, field

from mipgen.read.position import Position

from .details import Detail, Prose
from .evidence import Manual
from .fields import Field
from .types import Enum, Function, Source

#: The package that the templates and runtimes of the targets are written for.
OWN_PACKAGE = "mip"


@dataclass(frozen=True, slots=True)
class Conversion:
    """From a frame to one that other software uses in its place."""

    name: str
    title: Prose
    axes: tuple[str, ...]  # where x, y and z point there
    values: tuple[str, ...]  # x, y and z there, by the elements of a vector in the frame: ("y", "x", "-z")
    description: Prose


@dataclass(frozen=True, slots=True)
class Word:
    """An entry of a controlled vocabulary: a unit or a frame of reference."""

    symbol: str
    title: Prose
    description: Prose
    plural: Detail[str] = ""  # of a unit that is a word: its plural
    numbered: bool = False  # of a unit: a value is the number of one, "week 2412"
    elements: tuple[str, ...] = ()  # of a frame: what vectors in it have, if not x, y, z
    axes: Detail[tuple[str, ...]] = ()  # of a frame: where x, y and z point; right-handed
    origin: Prose = ""  # of a frame: the place of its origin
    conversions: Detail[tuple[Conversion, ...]] = ()  # of a frame: to those that other software uses
    sources: tuple[Source, ...] = ()  # of a frame


@dataclass(frozen=True, slots=True)
class Chapter:
    """Notes on the protocol for programmers, besides its fields."""

    title: Prose
    text: tuple[Prose, ...]  # sentences that belong together, each
    sources: tuple[Source, ...]


@dataclass(frozen=True, slots=True)
class Clock:
    """A clock whose time packets have."""

    name: str
    title: Prose
    description: Prose
    epoch: str | None  # "1980-01-06"; without it, it starts with the device
    timestamps: tuple[str, ...]  # full names of the data fields that hold it
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Older:
    """The way to start the data of one set on older devices: full names of commands."""

    set: str
    base_rate: str
    format: str
    stream: int  # its number for the stream, in place of the descriptor set
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Session:
    """The commands that identify a device and start its data: their full names."""

    baud: int  # the rate of a new device
    ping: str
    idle: str
    resume: str
    identify: str
    model_numbers: tuple[str, ...]  # paths in its response: "device_info.model_number"
    base_rate: str
    format: str
    stream: str
    older: tuple[Older, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def commands(self) -> tuple[str, ...]:
        return (self.ping, self.idle, self.resume, self.identify, self.base_rate, self.format, self.stream)


@dataclass(frozen=True, slots=True)
class Usage:
    """The word that names use for a thing, and those that they do not use."""

    word: str
    instead_of: tuple[str, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Protocol:
    name: str
    title: Prose  # what it is, after "the": "MIP protocol of MicroStrain inertial sensors"
    package: str  # the name of libraries and packages: `mip` for `mip_parser_init`, `mip_protocol`
    keywords: tuple[Prose, ...]  # for searches
    version: Detail[str]
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
    synonyms: Detail[tuple[tuple[str, ...], ...]] = ()  # words of the same meaning
    clocks: tuple[Clock, ...] = ()  # preferred clocks come first
    session: Session | None = None
    barrier: tuple[int, int] = (0, 0)  # set and descriptor of the command after which no answer is late; 0: none
    url: Prose = ""  # the public repository
    leap_seconds: Detail[tuple[tuple[str, int], ...]] = ()  # day -> seconds that clocks with an epoch are ahead of UTC
