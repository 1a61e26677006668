"""A log as columns. Packets are found once; values are read when they are requested."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypeVar, overload

from ..binding import Field
from ..names.occurrence import every, occurrence_in
from . import contents, frames, times
from .column import Column
from .contents import TypeCount
from .packets import Kind, Packets
from .reader import Reader
from .sender import Sender
from .stamps import Times

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

F = TypeVar("F", bound=Field)

#: What the rows of a table stand for.
By: TypeAlias = Literal["time", "packet"]
#: Treatments of values that are not valid according to their flags.
Invalid: TypeAlias = Literal["keep", "mask", "drop"]
Names: TypeAlias = Literal["full", "plain"]
Library: TypeAlias = Literal["pandas", "polars", "pyarrow"]


class Log(Packets):
    """The packets that begin within a range of bytes of a log.

    They are exactly those that `Parser` finds, however the file is divided: a packet belongs to the
    part that contains its first byte. Memory is needed for the positions of the packets, up to a
    limit, and for the requested columns; the file itself is not read into memory. A log that was
    opened from a path can be pickled for other processes, as the path and the range.
    """

    _types: list[TypeCount] | None = None

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
        return Log, (origin, self.begin, self.end, self.sender.named)

    def __repr__(self) -> str:
        origin = self.source.origin
        name = repr(origin) if isinstance(origin, str) else "in memory"
        return f"<Log {name}: bytes {self.begin} to {self.end}>"

    def assumed(self, names: bool = True) -> list[str]:
        """Returns in a line each what is assumed about the device: who it is, or how its flags are read. `names`: also
        if that only names values."""
        return self.sender.assumed(self, names)

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

    def column(self, kind: Kind, set_number: int | None = None) -> Column[Any]:
        """Returns the fields of a type; with `set_number`, only those in packets of this set.

        Raises LookupError as `log[kind]` does.
        """
        return self.columns([kind], set_number)[0]

    def columns(self, kinds: Sequence[Kind] | None = None, set_number: int | None = None) -> list[Column[Any]]:
        """Returns the columns of several types, read in one pass; by default those of all types in the log, separately
        for each set."""
        if kinds is None:
            counts = [count for count in self.types() if set_number is None or count.set == set_number]
            kinds = list(
                dict.fromkeys(occurrence_in(count.set, count.type) for count in counts if count.type is not None)
            )
        readers = [Reader(self, kind, set_number) for kind in kinds]
        for piece in self.pieces():
            for reader in readers:
                reader.add(piece)
        return [reader.column() for reader in readers]

    def objects(self, kind: type[F], set_number: int | None = None) -> Iterator[F]:
        """Yields the fields of a type as objects. Raises LookupError as `log[kind]` does."""
        return Reader(self, kind, set_number).objects()

    # ----------------------------------------------------------------- what is in it

    def types(self) -> list[TypeCount]:
        """Returns the number and the rate of the fields of each type, sorted by set and descriptor."""
        if self._types is None:
            self._types = contents.ordered_types(self)
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
        index: Literal["time"] | None = ...,
        names: Names = ...,
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
        index: Literal["time"] | None = None,
        names: Names = "full",
    ) -> Any:
        """Returns a data frame of one or several types, with a row for each instant that has any of them.

        Packets with the same timestamp belong to one instant if they are near each other in the file;
        a packet without a timestamp is an instant by itself. If an instant has several fields of one
        type, it has several rows. With `by="packet"`, there is a row for each packet.

        `library` is "pandas", "polars" or "pyarrow". `time` is a clock, None for no time. With "auto",
        `time` has dates, and `time_device` seconds by a clock without a date, if rows have no date.
        `time_own` is False if the packet itself has no timestamp
        (see `Times`). `invalid="mask"` leaves out values that are not valid according to their flags,
        `"drop"` leaves out fields that have such a value. Vectors have a column for each element,
        "scaled_accel.x [g]"; `units` includes their units, in the names or in the metadata of Arrow.
        A type without parameters has one column, which is True in its rows. `position` adds the number
        of the row's first packet, its descriptor set and its offset in the file.

        In pandas, `index="time"` makes the time the index, and `frame.attrs["units"]` has the unit of
        each column. With `names="plain"`, names are identifiers without units: "scaled_accel_x".

        Raises LookupError as `log[kind]` does, ValueError for other choices or if a type is named twice,
        MissingExtra if the library is missing.
        """
        return frames.frame(self, types_listed(kinds), by, library, time, invalid, units, position, index, names)

    # ----------------------------------------------------------------- time

    def times(self, column: Column[Any], clock: str | None = None) -> Times:
        """Returns the time of each row of a column; see `Column.time`."""
        return times.row_times(self, column, clock)


def types_listed(kinds: Kind | Iterable[Kind]) -> list[Kind]:
    """Returns a list of one or several types. Raises ValueError if there is none."""
    chosen: list[Any] = [kinds]
    pair = isinstance(kinds, tuple) and len(kinds) == 2 and isinstance(kinds[0], int)
    if isinstance(kinds, Iterable) and not isinstance(kinds, (str, type)) and not pair:
        chosen = list(kinds)
    if not chosen:
        raise ValueError("a table needs at least one type")
    return chosen


def read_log(source: Any, begin: int = 0, end: int | None = None, device: str | Sender | None = None) -> Log:
    """Opens a log: a file (a path or a binary file, which is mapped into memory) or bytes.

    With `begin` and `end`, in bytes, the log has only the packets that begin in this range. `device` is
    the id or name of the device that sent it: the flags that mark values as valid depend on the device.
    Without it, a reply of the device in the log identifies it; `log.assumed()` says what was assumed.

    Raises OSError, TypeError if `source` is something else, ValueError if `begin` is negative or
    after `end`, LookupError if there is no such device.
    """
    return Log(source, begin, end, device)
