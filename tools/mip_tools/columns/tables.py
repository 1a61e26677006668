"""Makes tables of several types of fields, which define the rows, names and types of frames and all exports."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..binding import CLOCKS, SETS, Field, Parameter, timestamps, to_text
from ..names.occurrence import occurrence_in, sets_of
from . import contents, instants, timeline, times
from .column import Column, absent
from .distinct import taken
from .general import Ragged, Values
from .packets import Packets
from .scan import Array
from .stamps import NONE, Times
from .states import different

#: Columns of a table besides the parameters of fields.
OWN = ("time", "time_device", "time_own", "time_host", "gap", "packet", "set", "offset")
#: Bytes of a log whose rows are in memory at the same time.
PART = 1 << 20


class Series(NamedTuple):
    """One column of a table."""

    name: str
    values: Array
    mask: Array | None  # True where there is no value
    facts: dict[str, str]  # unit, frame, type, clock
    lists: tuple[int, str] = (0, "")  # for an array of objects: the depth of nested lists, and their NumPy type

    def rows(self, which: Any) -> Series:
        """Returns some of the rows."""
        return self._replace(values=self.values[which], mask=None if self.mask is None else self.mask[which])


def time_column(values: Array, clock: str, **facts: str) -> Series:
    """Makes the column of times from nanoseconds: dates if the clock has one, else seconds since its start."""
    if CLOCKS.get(clock):
        return Series("time", values.view(times.dtype(clock)), values == NONE, {"clock": clock, **facts})
    seconds = np.where(values == NONE, 0, values) / 1e9
    return Series("time_device", seconds, values == NONE, {"unit": "s", "clock": clock, **facts})


class Table(NamedTuple):
    """Rows of a log. Each type of field has some of the columns, and values in some of the rows."""

    columns: list[Series]
    types: list[tuple[slice, Array]]  # for each type, its columns, and the rows that have it
    begin: Array  # the offset of the first packet of each row

    def __len__(self) -> int:
        return len(self.columns[0].values) if self.columns else 0


class Form(NamedTuple):
    """The content of a table; see `Log.frame`."""

    by: str = "time"
    dated: str = ""  # the clock of the dates; "" for none
    undated: str = ""  # the clock of times without a date
    covers: bool = True  # as in `timeline.Clocks`
    shown: tuple[str, ...] | None = None  # the clocks that have a column, if not all
    invalid: str = "keep"
    position: bool = False
    named: bool = False
    wanted: Callable[[int, int], bool] | None = None  # is the field with this set and descriptor selected?
    arrivals: Array | None = None  # when each packet of the log arrived, in ns since 1970, UTC
    gaps: Array | None = None  # for how many seconds the port was lost before each packet

    def check(self) -> None:
        """Raises ValueError if a choice does not exist."""
        if self.by not in ("time", "packet"):
            raise ValueError(f"by {self.by!r}: time or packet")
        if self.invalid not in ("keep", "mask", "drop"):
            raise ValueError(f"invalid {self.invalid!r}: keep, mask or drop")


class _Part(NamedTuple):
    """The fields of one type that are in a table."""

    column: Column[Any]
    rows: Array  # which rows of the column
    times: list[Times]  # by the clock with dates and by the one without, as far as there are such clocks
    once: bool


def apart(kind: type[Field]) -> bool:
    """Has a shared field separate columns for each set? Timestamps have not: all those of an instant are equal."""
    return not sets_of(kind) and kind.SET != 0 and not timestamps.clocks_of(0x80, kind.DESCRIPTOR)


def whole_table(log: Packets, columns: Sequence[Column[Any]], form: Form) -> Table:
    """Makes the table of some columns of a log."""
    if form.by == "time":
        columns = list(_sets_apart(log, columns))
    return _table([_part(column, form) for column in columns], form, slice(None))


def _sets_apart(log: Packets, columns: Sequence[Column[Any]]) -> Iterator[Column[Any]]:
    for column in columns:
        if len(columns) > 1 and len(column.sets) > 1 and apart(column.type):
            yield from log.columns([(number, column.type) for number in column.sets])
        else:
            yield column


def survey_tables(log: Packets, form: Form) -> tuple[list[tuple[int, type[Field]]], timeline.Clocks]:
    """Finds the types of fields for the tables of a log, by set and descriptor, and their clocks, in bounded memory."""
    present: dict[tuple[int, type[Field]], None] = {}
    sets: set[int] = set()
    line = timeline.Timeline()
    for part in log.parts(2 * PART):
        line.add(part)
        for number, kind in contents.decodable(part):
            if form.wanted is None or form.wanted(number, kind.DESCRIPTOR):
                sets.add(number)
                pair = (number, kind) if form.by == "time" and apart(kind) else occurrence_in(number, kind)
                present.setdefault((pair[0], kind))
    if log.whole() is log:
        log.source.notes.setdefault("timeline", line)
    clocks = line.clocks(number for number in sets if number >= 0x80)
    return sorted(present, key=lambda pair: (pair[0], pair[1].DESCRIPTOR, pair[1].NAME)), clocks


def table_parts(log: Packets, kinds: Sequence[Any], form: Form, size: int = 0) -> Iterator[tuple[Table, int]]:
    """Yields the table of a log in parts, in bounded memory, and the offset at which each part ends. All parts have the
    same columns.

    An instant whose packets are in two parts is one row, in the second part.
    """
    begin = stop = log.begin
    number = 0
    done: Array = np.zeros(0, np.int64)
    while True:
        stop = min(log.end, stop + (size or PART))
        part = log.part(begin, stop)
        chosen = [_part(column, form, done) for column in part.columns(kinds)]
        rows, last = _rows_of(chosen, form), stop >= log.end
        limit = stop - instants.TOGETHER
        yield _table(chosen, form, slice(None) if last else rows.begin < limit, rows, number), stop
        if last:
            return
        waits = rows.first >= limit
        begin = int(rows.first[waits].min()) if waits.any() else stop
        done = np.concatenate((done, rows.packets[~waits]))
        done = done[done >= begin]
        number += part.before_offset(begin)


def joined_parts(log: Packets, kinds: Sequence[Any], form: Form, size: int) -> list[Series]:
    """Makes the columns of a log part by part. They grow in place, so memory is needed for the table alone."""
    columns: list[Series] = []
    for table, _ in table_parts(log, kinds, form, size):
        empty = [each.rows(slice(0))._replace(mask=None) for each in table.columns]
        columns = list(map(_extended, columns or empty, table.columns))
    return columns


def _extended(series: Series, more: Series) -> Series:
    """Appends rows to a column."""
    count, mask = len(series.values), series.mask
    if more.mask is not None and mask is None:
        mask = np.zeros(count, bool)
    if mask is not None:
        mask = _grown(mask, more.mask if more.mask is not None else np.zeros(len(more.values), bool))
    return series._replace(values=_grown(series.values, more.values), mask=mask)


def _grown(values: Array, more: Array) -> Array:
    """Appends values to an array. The system moves the pages of a large one, and copies nothing."""
    count = len(values)
    values = values if values.flags.owndata else values.copy()
    values.resize((count + len(more), *more.shape[1:]), refcheck=False)
    values[count:] = more
    return values


def _part(column: Column[Any], form: Form, done: Array | None = None) -> _Part:
    """Selects the rows of a column that are kept, without those of packets that are done."""
    there: Array = np.ones(len(column), bool)
    if form.wanted is not None and len(column):
        sets = [n for n in column.sets if form.wanted(n, column.type.DESCRIPTOR)]
        if len(sets) < len(column.sets):
            there &= np.isin(column.set, sets)
    if done is not None and len(done):
        there &= ~np.isin(column.offset, done)
    if form.invalid == "drop":
        for name in column.names:
            if column.parameters[name].flags:
                valid = column.valid(name)
                there &= valid if valid.ndim == 1 else valid.all(axis=1)
    clocks = [column.time(clock) for clock in (form.dated, form.undated) if clock]
    kind = column.type
    once = not sets_of(kind) and kind.SET != 0 and not apart(kind)
    return _Part(column, np.flatnonzero(there), clocks, once)


def _rows_of(chosen: Sequence[_Part], form: Form) -> instants.Instants:
    fields = []
    for column, rows, clocks, once in chosen:
        own: Array = np.full(len(rows), NONE)
        for time in reversed(clocks):  # the date counts, if there is one
            value = taken(time.values.view(np.int64), rows)
            there = taken(time.own, rows) & (value != NONE)
            own = value if there.all() else np.where(there, value, own)
        fields.append(instants.Fields(taken(column.offset, rows), own, once and len(chosen) > 1))
    # With only one type, the rows have the order of the log.
    return instants.assign(fields, form.by if len(fields) > 1 else "packet")


def _table(
    chosen: Sequence[_Part],
    form: Form,
    which: slice | Array,
    rows: instants.Instants | None = None,
    number: int = 0,
) -> Table:
    """Makes the table of these fields, with only the rows `which`. `number` is the number of the first packet."""
    rows = _rows_of(chosen, form) if rows is None else rows
    new = np.full(len(rows.begin), -1, np.int64)  # number of a row in this table
    count = len(rows.begin[which])
    new[which] = np.arange(count)
    places, lefts = [], []
    for part, kept, place in zip(chosen, rows.kept, rows.place):
        row = new[place]
        left = np.flatnonzero(row >= 0)
        lefts.append(taken(taken(part.rows, kept), left))
        places.append(taken(row, left))
    columns = list(_beside(chosen, lefts, places, rows.begin[which], form, number))
    types = []
    single = len(chosen) == 1
    for (column, *_), left, place in zip(chosen, lefts, places):
        first = len(columns)
        for values in _values(column, form, single):
            columns.append(_spread(values, left, place, count))
        if not column.names:
            there = np.zeros(count, bool)
            there[place] = True
            columns.append(Series(column_heading(column, "", single), there, None, {}))
        types.append((slice(first, len(columns)), place))
    return Table(columns, types, rows.begin[which])


def _beside(
    chosen: Sequence[_Part], lefts: list[Array], places: list[Array], begin: Array, form: Form, number: int
) -> Iterator[Series]:
    """Yields the columns of the time and the position in the log, from the first packet of each row."""
    count = len(begin)
    clocks = [clock for clock in (form.dated, form.undated) if clock]
    own = np.zeros(count, bool)
    for i, clock in enumerate(clocks):
        values = np.full(count, NONE, np.int64)
        for part, left, place in zip(chosen, lefts, places):
            value = taken(part.times[i].values.view(np.int64), left)
            there = np.flatnonzero(value != NONE)
            values[taken(place, there)] = taken(value, there)
            own[place] |= taken(part.times[i].own, left)
        if form.shown is None or clock in form.shown:
            yield time_column(values, clock)
    if clocks and form.shown != ():
        yield Series("time_own", own, None, {})
    if not form.position and form.arrivals is None and form.gaps is None:
        return
    packet, set_number = np.zeros(count, np.int64), np.zeros(count, np.uint8)
    for part, left, place in zip(chosen, lefts, places):
        first = part.column.offset[left] == begin[place]
        packet[place[first]] = part.column.packet[left[first]] + number
        set_number[place[first]] = part.column.set[left[first]]
    if form.arrivals is not None:
        yield Series("time_host", form.arrivals[packet].view("datetime64[ns]"), None, {"clock": "host"})
    if form.gaps is not None:
        before = np.append(0.0, np.cumsum(form.gaps))  # also those within a row
        lost = np.round(before[np.append(packet[1:], len(form.gaps))] - before[packet], 3)
        yield Series("gap", lost, lost == 0, {"unit": "s"})
    if not form.position:
        return
    yield Series("packet", packet, None, {})
    yield Series("set", set_number, None, {})
    yield Series("offset", begin, None, {})


def column_heading(column: Column[Any], name: str, single: bool) -> str:
    """Returns the name of a parameter in a table: its name in the specification, after set and field if there are
    several types."""
    number = column.only
    set_number, _, field = column.name.partition(".")
    if number is not None and not sets_of(column.type):  # a shared field of one set
        set_number = SETS[number][0] if number in SETS else f"0x{number:02X}"
    if not name:
        return field if single else f"{set_number}.{field}"
    if single:
        return f"{field}.{name}" if name in OWN else name
    return f"{set_number}.{name}" if name.split(".")[0] == field else f"{set_number}.{field}.{name}"


class _Values(NamedTuple):
    """The values of a parameter, or of an element of it, in all rows of a column."""

    name: str
    values: Values
    mask: Array | None
    facts: dict[str, str]
    group: str = ""  # for an element, the parameter that it belongs to


def _values(column: Column[Any], form: Form, single: bool) -> Iterator[_Values]:
    """Yields the columns of a table for one type; a vector has one for each element."""
    for path, title in column.titles.items():
        p, values = column.parameters[path], column[path]
        name = column_heading(column, title, single)
        facts = {"frame": p.frame} if p.frame else {}
        if p.type is not None:
            facts["type"] = p.type.__name__
        bad = ~column.valid(path) if form.invalid == "mask" and p.flags else None
        units = {"unit": p.units[0]} if len(set(p.units)) == 1 and p.units[0] not in ("", "1") else {}
        if isinstance(values, Ragged):
            yield _Values(name, values, values.mask, facts | units)
            continue
        gone = absent(values) if isinstance(values, np.ma.MaskedArray) else None
        array = np.asarray(values)
        if array.dtype == object:
            array = _stripped(array)
        if form.named and p.type is not None and array.dtype.kind in "iu" and array.ndim == 1:
            array = _names(p, *different(column, path, array))
        if p.elements and array.ndim == 2:
            for i, element in enumerate(p.elements):
                unit = p.units[min(i, len(p.units) - 1)] if p.units else ""
                wrong = bad if bad is None or bad.ndim == 1 else bad[:, i]
                own = {"unit": unit} if unit not in ("", "1") else {}
                yield _Values(f"{name}.{element}", array[:, i], _either(gone, wrong), facts | own, name)
        else:
            wrong = bad if bad is None or bad.ndim == 1 else np.asarray(bad.all(axis=1))
            yield _Values(name, array, _either(gone, wrong), facts | units)


def _stripped(texts: Array) -> Array:
    """Removes the zeros and spaces that pad texts."""
    short = np.empty(texts.shape, object)
    flat = short.reshape(-1)
    flat[:] = [None if text is None else text.strip("\0 ") for text in texts.reshape(-1).tolist()]
    return short


def _names(p: Parameter, values: list[tuple[Any, Any]], place: Array) -> Array:
    """Converts numbers to the names of enumeration values or flags."""
    names = np.empty(len(values), object)
    names[:] = [to_text(p, number, state, None) for number, state in values]
    return np.asarray(names[place])


def _lists(ragged: Ragged) -> tuple[int, str]:
    """Returns the depth of nested lists, and the type of their elements."""
    if isinstance(ragged.values, Ragged):
        depth, item = _lists(ragged.values)
        return depth + 1, item
    return ragged.values.ndim, ragged.values.dtype.str


def _listed(row: Any) -> Any:
    """Converts arrays to lists."""
    if isinstance(row, np.ndarray):
        return row.tolist()
    return [_listed(item) for item in row] if isinstance(row, list) else row


def _either(first: Array | None, second: Array | None) -> Array | None:
    if first is None or second is None:
        return second if first is None else first
    return first | second


def _spread(column: _Values, left: Array, place: Array, count: int) -> Series:
    """Puts some of the values in their rows; the other rows have none."""
    if isinstance(column.values, Ragged):
        every = column.values.rows()
        items = np.empty(count, object)
        for row, i in zip(place.tolist(), left.tolist()):
            items[row] = _listed(every[i])
        mask = np.ones(count, bool)
        mask[place] = False if column.mask is None else column.mask[left]
        return Series(column.name, items, mask, column.facts, _lists(column.values))
    if len(left) == count == len(column.values) and (place[1:] > place[:-1]).all():
        return Series(column.name, column.values, column.mask, column.facts)  # all, in this order
    values = np.zeros((count, *column.values.shape[1:]), column.values.dtype)
    values[place] = column.values[left]
    if len(left) == count and column.mask is None:
        return Series(column.name, values, None, column.facts)
    mask = np.ones(count, bool)
    mask[place] = False if column.mask is None else column.mask[left]
    return Series(column.name, values, mask, column.facts)
