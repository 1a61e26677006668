"""Parquet, Arrow and NumPy files, by columns; Parquet and Arrow part by part, in bounded memory."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ..binding import MissingExtra
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from . import clocks, inputs, outputs
from .selection import Selection
from .table import heading, survey

if TYPE_CHECKING:
    from ..columns import Column, Log

#: Bytes of the log that are in memory together, with their columns.
PART = 1 << 25

#: What a table has beside the values of fields.
_PLACES = ("time", "time_own", "packet", "offset", "set")


def require(form: str) -> None:
    """Raises Failure if a package is missing that a format needs."""
    for package in ("numpy",) if form == "npz" else ("numpy", "pyarrow"):
        try:
            import_module(package)
        except ImportError:
            missing = MissingExtra(package, package)
            raise Failure(f"{missing}; csv and jsonl need nothing") from None


class Job:
    """What is to be written of a log."""

    def __init__(
        self, name: str, form: str, options: argparse.Namespace, selection: Selection, aligned: Occurrence | None
    ) -> None:
        if options.named:
            raise Misuse("--names is for csv and jsonl; tables of numbers name their types")
        self._name, self._form, self._options, self._aligned = name, form, options, aligned
        self._selection = selection
        self.types, clock = survey(name, selection)
        self._clock = None if options.time == "none" else clock
        if options.time in ("utc", "unix") and not clocks.dated(self._clock):
            raise Failure("the log has no dates; use --time clock, --time start or --time none")
        self._first: int | None = None
        if form == "npz" and aligned is not None:
            raise Misuse("--align is for csv, jsonl, parquet and arrow")

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes fields of these types into a file."""
        from ..columns import read_log

        with read_log(self._name) as log, ExitStack() as stack:
            if self._form == "npz":
                self._write_npz(path, log, types)
                return
            out = stack.enter_context(outputs.whole(path))
            writer: Any = None
            schema: Any = None
            tables = Tables(self._options, self._clock, types, self._aligned, self._selection)
            for table in tables.of(log):
                if writer is None:
                    writer = stack.enter_context(_writer(self._form, out, table.schema))
                    schema = table.schema
                writer.write_table(table.cast(schema) if table.schema != schema else table)

    def _write_npz(self, path: str, log: Log, types: Sequence[Occurrence]) -> None:
        from ..columns import Ragged

        np: Any = import_module("numpy")  # its masked arrays are not typed in all versions

        arrays: dict[str, Any] = {}
        for one, column in zip(types, log.columns(list(types))):
            rows = kept(column, self._selection, self._options.invalid)
            name = one.name
            if self._clock is not None:
                times = column.time(self._clock)
                arrays[f"{name}/time"] = self._seconds(times.values)[rows]
                arrays[f"{name}/time_own"] = times.own[rows]
            arrays[f"{name}/packet"] = column.packet[rows]
            arrays[f"{name}/offset"] = column.offset[rows]
            for parameter in column.names:
                values = column[parameter]
                if isinstance(values, Ragged):
                    arrays |= _ragged(f"{name}/{parameter}", values, rows)
                    continue
                held = np.ma.getdata(values)
                arrays[f"{name}/{parameter}"] = (held.astype(str) if held.dtype == object else held)[rows]
                valid = ~np.ma.getmaskarray(values)
                if self._options.invalid == "mask":
                    vouched = column.valid(parameter)
                    valid = valid & (vouched[:, None] if vouched.ndim < valid.ndim else vouched)
                if not valid.all():
                    arrays[f"{name}/{parameter}/valid"] = valid[rows]
        with outputs.whole(path) as out:
            np.savez_compressed(out, **arrays)

    def _seconds(self, times: Any) -> Any:
        """Times as NumPy has them if they are UTC, else seconds."""
        self._first, seconds = in_seconds(times, self._options.time, self._clock, self._first)
        return seconds


def in_seconds(times: Any, wanted: str | None, clock: str | None, first: int | None) -> tuple[int | None, Any]:
    """Times in seconds, except dates that are requested as such; and the first of all."""
    import numpy as np

    if wanted in (None, "utc") and clocks.dated(clock):
        return first, times
    numbers = times.astype(np.int64)
    unknown = np.isnat(times)
    if wanted == "start":
        if first is None and not unknown.all():
            first = int(numbers[~unknown].min())
        numbers = numbers - (first or 0)
    return first, np.where(unknown, np.nan, numbers / 1e9)


def kept(column: Column[Any], selection: Selection, invalid: str) -> Any:
    """The rows that are written: of the selected sets; with `drop`, without invalid values."""
    import numpy as np

    wanted = [n for n in column.sets if selection.has(n, column.type.DESCRIPTOR)]
    rows: Any = np.ones(len(column), bool)
    if len(wanted) < len(column.sets):
        rows = np.isin(column.set, wanted)
    if invalid == "drop":
        for name in column.names:
            if column.parameters[name].valid:
                valid = column.valid(name)
                rows &= valid if valid.ndim == 1 else valid.all(axis=1)
    return rows


def _ragged(name: str, ragged: Any, rows: Any) -> dict[str, Any]:
    """Lists of any length as two arrays: row i is values[offsets[i] : offsets[i + 1]]."""
    import numpy as np

    lengths = np.diff(ragged.offsets)[rows]
    if not rows.all():
        begins = ragged.offsets[:-1][rows]
        index = np.concatenate([np.arange(b, b + n) for b, n in zip(begins, lengths)] or [np.zeros(0, np.int64)])
    else:
        index = np.arange(ragged.offsets[-1])
    arrays = {f"{name}/offsets": np.concatenate(([0], np.cumsum(lengths)))}
    if isinstance(ragged.values, np.ndarray):
        return arrays | {f"{name}/values": ragged.values[index]}
    inner = np.zeros(len(ragged.values), bool)
    inner[index] = True
    return arrays | _ragged(f"{name}/values", ragged.values, inner)


# --------------------------------------------------------------------------- parquet and arrow


class Tables:
    """The tables of the parts of a log, all with the same columns."""

    def __init__(
        self,
        options: argparse.Namespace,
        clock: str | None,
        types: Sequence[Occurrence],
        aligned: Occurrence | None,
        selection: Selection,
    ) -> None:
        self._options, self._clock, self._types, self._aligned = options, clock, types, aligned
        self._selection = selection
        self._first: int | None = None
        self._last: dict[Occurrence, Any] = {}

    def of(self, log: Log) -> Iterator[Any]:
        """One for each part."""
        progress = inputs.Progress(log.size)
        for part in log.parts(PART):
            progress.at(part.begin)
            tables = {kind: self._table(part, kind) for kind in self._types}
            rows = self._aligned_rows if self._aligned else self._joined_rows
            yield self._put_together(tables, rows(tables))
        progress.clear()

    def _table(self, part: Log, kind: Occurrence) -> Any:
        """The fields of one type, in the order of the log."""
        pa = import_module("pyarrow")

        invalid = "mask" if self._options.invalid == "mask" else "keep"
        table = part.frame(kind, library="pyarrow", time=self._clock, invalid=invalid, position=True)
        rows = kept(part[kind], self._selection, self._options.invalid)
        return table if rows.all() else table.filter(pa.array(rows))

    def _joined_rows(self, tables: dict[Occurrence, Any]) -> dict[Occurrence, Any]:
        """For each row, that of each type, or -1: a row for each packet, more if it has several of a type."""
        import numpy as np

        keys = {}
        for kind, table in tables.items():
            packet = table["packet"].to_numpy()
            numbers = np.arange(len(packet))
            new = np.ones(len(packet), bool)
            new[1:] = packet[1:] != packet[:-1]
            turn = numbers - np.maximum.accumulate(np.where(new, numbers, 0))
            keys[kind] = packet * 256 + turn
        whole = np.unique(np.concatenate(list(keys.values())))
        rows_of = {}
        for kind, key in keys.items():
            rows = np.full(len(whole), -1, np.int64)
            rows[np.searchsorted(whole, key)] = np.arange(len(key))
            rows_of[kind] = rows
        return rows_of

    def _aligned_rows(self, tables: dict[Occurrence, Any]) -> dict[Occurrence, Any]:
        """For each row of one type the last one of the others, also from the part before."""
        import numpy as np

        pa = import_module("pyarrow")

        assert self._aligned is not None
        base = tables[self._aligned]["offset"].to_numpy()
        rows_of = {}
        for kind, table in list(tables.items()):
            if kind == self._aligned:
                rows_of[kind] = np.arange(len(base))
                continue
            if kind in self._last:
                table = tables[kind] = pa.concat_tables([self._last[kind], table])
            if len(table):
                self._last[kind] = table.slice(len(table) - 1)
            rows_of[kind] = np.searchsorted(table["offset"].to_numpy(), base, side="right") - 1
        return rows_of

    def _put_together(self, tables: dict[Occurrence, Any], rows: dict[Occurrence, Any]) -> Any:
        pa, pc = import_module("pyarrow"), import_module("pyarrow.compute")

        indices = {kind: pa.array(index, mask=index < 0) for kind, index in rows.items()}
        fields, columns = [], []
        for name in ("time", "time_own") if self._clock is not None else ():
            kinds = [self._aligned] if self._aligned else list(tables)
            parts = [tables[kind][name].take(indices[kind]) for kind in kinds]
            column = pc.coalesce(*parts)
            field = tables[kinds[0]].schema.field(name)
            if name == "time":
                column, field = self._time(column, field)
            columns.append(column)
            fields.append(field)
        for kind, table in tables.items():
            for field in table.schema:
                if field.name not in _PLACES:
                    column = table[field.name]
                    if pa.types.is_fixed_size_list(field.type):
                        # Of lists of fixed size, Parquet loses those that are missing.
                        field = field.with_type(pa.list_(field.type.value_field))
                        column = column.cast(field.type)
                    columns.append(column.take(indices[kind]))
                    name = heading(kind, field.name, len(tables) == 1)
                    fields.append(field.with_name(name))
        return pa.Table.from_arrays(columns, schema=pa.schema(fields))

    def _time(self, column: Any, field: Any) -> tuple[Any, Any]:
        pa = import_module("pyarrow")

        times = column.to_numpy(zero_copy_only=False) if isinstance(column, pa.Array) else column.to_numpy()
        wanted = self._options.time
        if wanted in (None, "utc") and clocks.dated(self._clock):
            return column, field
        self._first, seconds = in_seconds(times, wanted, self._clock, self._first)
        metadata = {**(field.metadata or {}), b"unit": b"s"}
        return pa.array(seconds, from_pandas=True), pa.field("time", pa.float64(), metadata=metadata)


def _writer(form: str, out: Any, schema: Any) -> Any:
    if form == "parquet":
        return import_module("pyarrow.parquet").ParquetWriter(out, schema, compression="zstd")
    return import_module("pyarrow").ipc.new_file(out, schema)
