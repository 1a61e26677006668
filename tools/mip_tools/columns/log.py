"""A log as columns. Packets are found once; values are read when they are requested."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from copy import copy
from html import escape
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypeVar, overload

import numpy as np

from ..binding import Field, device_id
from ..occurrence import every, of
from . import contents, frames, scan, times, walk
from .column import Column
from .contents import TypeCount
from .piece import NOTHING, Piece
from .reader import Kind, Reader
from .source import Source
from .times import Stamps, Times

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

F = TypeVar("F", bound=Field)

#: What the rows of a table stand for.
By: TypeAlias = Literal["time", "packet"]
#: Treatments of values that are not valid according to their flags.
Invalid: TypeAlias = Literal["keep", "mask", "drop"]
Method: TypeAlias = Literal["linear", "nearest", "last"]
Library: TypeAlias = Literal["pandas", "polars", "pyarrow"]

_PIECE = 1 << 20  # bytes that are read at once
#: The number of packets whose offsets are stored, so that they are found only once: some 250 MB. Later
#: packets are found again for each request.
_KEPT = 10_000_000


class Log:
    """The packets that begin within a range of bytes of a log.

    They are exactly those that `Parser` finds, however the file is divided: a packet belongs to the
    part that contains its first byte. Memory is needed for the positions of the packets, up to a
    limit, and for the requested columns; the file itself is not read into memory. A log that was
    opened from a path can be pickled for other processes, as the path and the range.
    """

    def __init__(self, source: Any, begin: int = 0, end: int | None = None, device: str | None = None) -> None:
        """See `read_log`."""
        #: The id of the device that sent the log, if it is known.
        self.device = None if device is None else device_id(device)
        if begin < 0 or (end is not None and end < begin):
            raise ValueError(f"bytes {begin} to {end}: `begin` must be 0 or more, and not after `end`")
        self._earlier: Log | None = None
        self.source = source if isinstance(source, Source) else Source(source)
        #: The size of the whole file, in bytes.
        self.size = self.source.size
        #: The range of bytes in which the packets begin.
        self.begin = min(begin, self.size)
        self.end = self.size if end is None else min(end, self.size)
        self._kept: dict[int, Piece] = {}
        self._first: int | None = None
        self._counts: tuple[int, int] | None = None  # of packets, of skipped bytes
        self._types: list[TypeCount] | None = None
        #: (set, clock) -> timestamps, for `times`, including those of packets shortly before this part.
        self.own_stamps: dict[tuple[int, str], Stamps] = {}
        self.stamps: dict[tuple[int, str], Stamps] = {}

    def __enter__(self) -> Log:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes the file. Columns already read remain valid."""
        self.source.close()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the path and the range: copies, also in other processes, open the file again."""
        origin = self.source.origin
        if origin is None:
            raise TypeError("a log of an open file or a buffer cannot be pickled: read it from a path or from bytes")
        return Log, (origin, self.begin, self.end, self.device)

    def __repr__(self) -> str:
        origin = self.source.origin
        name = repr(origin) if isinstance(origin, str) else "in memory"
        return f"<Log {name}: bytes {self.begin} to {self.end}>"

    def _repr_html_(self) -> str:
        """Shows the contents in notebooks."""
        rows = "".join(
            f"<tr><td>{escape(one.name)}</td><td style='text-align: right'>{one.count}</td>"
            f"<td style='text-align: right'>{'' if one.rate is None else f'{one.rate:.4g}'}</td></tr>"
            for one in self.types()
        )
        facts = f"{self.packets} packets, {self.skipped} bytes outside packets"
        head = "<tr><th>field</th><th>count</th><th>rate in Hz</th></tr>"
        return f"<p>{escape(repr(self))}: {facts}</p><table>{head}{rows}</table>"

    def _ipython_key_completions_(self) -> list[str]:
        """Returns the names that complete `log[...]`."""
        return list(dict.fromkeys(one.name for one in self.types() if one.type is not None))

    def parts(self, size: int = 1 << 26) -> Iterator[Log]:
        """Yields the log in parts of this many bytes; together they have every packet once."""
        if size < 1:
            raise ValueError(f"a part must have 1 byte or more, not {size}")
        for begin in range(self.begin, self.end, size):
            yield Log(self.source, begin, min(begin + size, self.end), self.device)

    # ----------------------------------------------------------------- packets

    @property
    def packets(self) -> int:
        """The number of packets."""
        return self._counted()[0]

    @property
    def skipped(self) -> int:
        """The number of bytes that are not part of a packet."""
        return self._counted()[1]

    def _counted(self) -> tuple[int, int]:
        if self._counts is None:
            for _ in self.pieces(fields=False):
                pass
        assert self._counts is not None
        return self._counts

    def pieces(self, fields: bool = True) -> Iterator[Piece]:
        """Yields the pieces of the log in order, with their packets and the fields in them. For `Reader`."""
        if self._first is None:
            self._first = self._beginning()
        free, number = self._first, 0
        covered = min(free, self.end) - self.begin
        for begin in range(self.begin, self.end, _PIECE):
            limit = min(_PIECE, self.end - begin)
            data, length = self.source.piece(begin, limit, scan.AHEAD)
            piece = self._kept.get(begin)
            if piece is None:
                piece = Piece(begin, limit, number, *scan.packets(data, max(0, free - begin), limit, length))
                if number < _KEPT:
                    self._kept[begin] = piece
            if fields and piece.runs is None:
                piece.runs = walk.runs(data, piece.at, piece.end)
            own = copy(piece)  # other requests may use the same piece meanwhile
            own.data = data
            yield own
            own.data = NOTHING
            self.source.forget(begin, begin + limit)
            number += len(piece.at)
            if len(piece.end):
                free = begin + int(piece.end[-1])
                covered += int((piece.end - piece.at).sum())
        if number:  # the last packet may end after this part
            covered -= max(0, free - self.end)
        self._counts = number, self.end - self.begin - covered

    def _beginning(self) -> int:
        """Returns the offset at which the first packet may begin: after one that reaches into this part."""
        back = 8 * scan.REACH
        while True:
            begin = max(0, self.begin - back)
            data, length = self.source.piece(begin, self.begin - begin, scan.AHEAD)
            found = scan.clear(data, self.begin - begin, length, begin == 0)
            if found is not None:
                return begin + found
            back *= 4

    # ----------------------------------------------------------------- columns

    @overload
    def __getitem__(self, kind: type[F]) -> Column[F]: ...
    @overload
    def __getitem__(self, kind: Kind) -> Column[Any]: ...
    def __getitem__(self, kind: Kind) -> Column[Any]:
        """Returns the fields of a type, also by name ("sensor.scaled_accel"); for a shared field, those of all sets.

        They are exactly the fields that `registry.decode_packet` returns: well formed, and long enough.
        If several sets have their own fields of a type, such as the sets of two GNSS receivers, the
        class finds them only if the log has them in one of these sets. "gnss_2.dop" names one set.

        Raises LookupError if the specification has no such type, or if the log has it in several
        sets and none of them is named.
        """
        return self.column(kind)

    def __contains__(self, kind: Kind) -> bool:
        """Does the log have a field of this type, in any set?"""
        kinds: Sequence[Kind] = [kind]
        if isinstance(kind, type) and issubclass(kind, Field) and hasattr(kind, "SETS"):
            kinds = every(kind)
        return any(map(len, self.columns(kinds)))

    def column(self, kind: Kind, set: int | None = None) -> Column[Any]:
        """Returns the fields of a type; with `set`, only those in packets of this set.

        Raises LookupError as `log[kind]` does.
        """
        return self.columns([kind], set)[0]

    def columns(self, kinds: Sequence[Kind] | None = None, set: int | None = None) -> list[Column[Any]]:
        """Returns the columns of several types, read in one pass; by default those of all types in the log, separately
        for each set."""
        if kinds is None:
            known = [count for count in self.types() if set is None or count.set == set]
            kinds = list(dict.fromkeys(of(count.set, count.type) for count in known if count.type is not None))
        readers = [Reader(self, kind, set) for kind in kinds]
        for piece in self.pieces():
            for reader in readers:
                reader.add(piece)
        return [reader.column() for reader in readers]

    def objects(self, kind: type[F], set: int | None = None) -> Iterator[F]:
        """Yields the fields of a type as objects. Raises LookupError as `log[kind]` does."""
        return Reader(self, kind, set).objects()

    # ----------------------------------------------------------------- what is in it

    def types(self) -> list[TypeCount]:
        """Returns the number and the rate of the fields of each type, sorted by set and descriptor."""
        if self._types is None:
            self._types = contents.types(self)
        return self._types

    @overload
    def frame(
        self,
        kinds: Kind | Sequence[Kind],
        *,
        by: By = ...,
        library: Literal["pandas"] = ...,
        time: str | None = ...,
        invalid: Invalid = ...,
        units: bool = ...,
        position: bool = ...,
    ) -> pandas.DataFrame: ...
    @overload
    def frame(
        self,
        kinds: Kind | Sequence[Kind],
        *,
        by: By = ...,
        library: Literal["polars"],
        time: str | None = ...,
        invalid: Invalid = ...,
        units: bool = ...,
        position: bool = ...,
    ) -> polars.DataFrame: ...
    @overload
    def frame(
        self,
        kinds: Kind | Sequence[Kind],
        *,
        by: By = ...,
        library: Literal["pyarrow"],
        time: str | None = ...,
        invalid: Invalid = ...,
        units: bool = ...,
        position: bool = ...,
    ) -> pyarrow.Table: ...
    def frame(
        self,
        kinds: Kind | Sequence[Kind],
        *,
        by: By = "time",
        library: Library = "pandas",
        time: str | None = "auto",
        invalid: Invalid = "keep",
        units: bool = True,
        position: bool = False,
    ) -> Any:
        """Returns a data frame of one or several types, with a row for each instant that has any of them.

        Packets with the same timestamp belong to one instant if they are near each other in the file;
        a packet without a timestamp is an instant by itself. If an instant has several fields of one
        type, it has several rows. With `by="packet"`, there is a row for each packet.

        `library` is "pandas", "polars" or "pyarrow". `time` is a clock, "auto" for the first one
        that the log has, None for no time; `time_own` is False if the packet itself has no timestamp
        (see `Times`). `invalid="mask"` leaves out values that are not valid according to their flags,
        `"drop"` leaves out fields that have such a value. Vectors have a column for each element,
        "scaled_accel.x [g]"; `units` includes their units, in the names or in the metadata of Arrow.
        A type without parameters has one column, which is True in its rows. `position` adds the number
        of the row's first packet, its descriptor set and its offset in the file.

        Raises LookupError as `log[kind]` does, ValueError for other choices, MissingExtra if the library
        is missing.
        """
        return frames.frame(self, several(kinds), by, library, time, invalid, units, position)

    @overload
    def resample(
        self,
        rate: str | float,
        kinds: Kind | Sequence[Kind] | None = ...,
        *,
        method: Method = ...,
        library: Literal["pandas"] = ...,
        time: str = ...,
        units: bool = ...,
    ) -> pandas.DataFrame: ...
    @overload
    def resample(
        self,
        rate: str | float,
        kinds: Kind | Sequence[Kind] | None = ...,
        *,
        method: Method = ...,
        library: Literal["polars"],
        time: str = ...,
        units: bool = ...,
    ) -> polars.DataFrame: ...
    @overload
    def resample(
        self,
        rate: str | float,
        kinds: Kind | Sequence[Kind] | None = ...,
        *,
        method: Method = ...,
        library: Literal["pyarrow"],
        time: str = ...,
        units: bool = ...,
    ) -> pyarrow.Table: ...
    def resample(
        self,
        rate: str | float,
        kinds: Kind | Sequence[Kind] | None = None,
        *,
        method: Method = "linear",
        library: Library = "pandas",
        time: str = "auto",
        units: bool = True,
    ) -> Any:
        """Returns a data frame at a fixed rate, "100Hz", "10ms" or a number in Hz, of some types or of all data.

        The rows are at whole multiples of the step. `method` is "linear", "nearest" or "last", the value
        before. "linear" interpolates floats; angles in rad or deg go the short way round, and quaternions
        are normalized. Integers, flags, text and matrices keep the value before. Values whose flags mark
        them as invalid, and values in packets without a timestamp, are ignored. There is no value where
        the neighbours are further apart than 2.5 usual intervals of their field. After a pause of more
        than 10 s, or if time goes back by as much, the rows restart.

        All times are of one clock, as for `frame`. Times of a set without this clock are converted from
        another clock, using packets that have both; the metadata of `time` state this (in pandas,
        `frame.attrs`).

        Raises LookupError as `log[kind]` does, ValueError for other choices or if the log has no
        timestamps, MissingExtra if the library is missing.
        """
        chosen = None if kinds is None else several(kinds)
        return frames.resampled(self, chosen, rate, method, library, time, units)

    @overload
    def nmea(self, *, library: Literal["pandas"] = ..., time: str | None = ...) -> pandas.DataFrame: ...
    @overload
    def nmea(self, *, library: Literal["polars"], time: str | None = ...) -> polars.DataFrame: ...
    @overload
    def nmea(self, *, library: Literal["pyarrow"], time: str | None = ...) -> pyarrow.Table: ...
    def nmea(self, *, library: Library = "pandas", time: str | None = "auto") -> Any:
        """Returns a data frame of the NMEA sentences between the packets that have a correct checksum.

        Its columns are `time` (of the last packet with a timestamp before the sentence), `time_own`
        (False), `offset` (in the file), `talker` ("GP"), `type` ("GGA"), `sentence` (the whole line), and
        `fields` (the texts between its commas). Raises ValueError and MissingExtra as `frame` does.
        """
        return frames.nmea(self, library, time)

    # ----------------------------------------------------------------- time

    def sets(self) -> list[int]:
        """Returns the descriptor sets of the packets, each once."""
        counts = np.zeros(256, np.int64)
        for piece in self.pieces(fields=False):
            counts += np.bincount(piece.sets(), minlength=256)
        return [int(number) for number in np.flatnonzero(counts)]

    def before_offset(self, offset: int) -> int:
        """Counts the packets that begin before an offset in the file."""
        return sum(int(np.searchsorted(piece.at, offset - piece.begin)) for piece in self.pieces(fields=False))

    def before(self, size: int) -> Log | None:
        """Returns the part of this many bytes before this one, if there is any. For `times`."""
        if not self.begin:
            return None
        if self._earlier is None:
            self._earlier = Log(self.source, max(0, self.begin - size), self.begin, self.device)
        return self._earlier

    def times(self, column: Column[Any], clock: str | None = None) -> Times:
        """Returns the time of each row of a column; see `Column.time`."""
        return times.of(self, column, clock)


def several(kinds: Kind | Iterable[Kind]) -> list[Kind]:
    """Returns a list of one or several types. Raises ValueError if there is none."""
    chosen: list[Any] = [kinds]
    pair = isinstance(kinds, tuple) and len(kinds) == 2 and isinstance(kinds[0], int)
    if isinstance(kinds, Iterable) and not isinstance(kinds, (str, type)) and not pair:
        chosen = list(kinds)
    if not chosen:
        raise ValueError("a table needs at least one type")
    return chosen


def read_log(source: Any, begin: int = 0, end: int | None = None, device: str | None = None) -> Log:
    """Opens a log: a file (a path or a binary file, which is mapped into memory) or bytes.

    With `begin` and `end`, in bytes, the log has only the packets that begin in this range. `device` is
    the id or name of the device that sent it: the flags that mark values as valid depend on the device.

    Raises OSError, TypeError if `source` is something else, ValueError if `begin` is negative or
    after `end`, LookupError if there is no such device.
    """
    return Log(source, begin, end, device)
