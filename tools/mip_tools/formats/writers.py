"""Writes tables to files, part by part: CSV, JSON lines, Parquet, Arrow and NumPy."""

from __future__ import annotations

import json
import shutil
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from importlib import import_module
from pathlib import Path
from typing import IO, Any

import numpy

from ..binding import MissingExtra
from ..columns import frames, text
from ..columns.scan import Array
from ..columns.tables import Series
from ..errors import Failure

np: Any = numpy  # its file format is not typed

#: Writes the columns of a part.
Write = Callable[[Sequence[Series]], None]
#: The number of rows that are written together.
_GROUP = 1 << 15


def require(form: str) -> None:
    """Raises Failure if a package that the format needs is missing."""
    try:
        if form in ("parquet", "arrow"):
            frames.library("pyarrow")
    except MissingExtra as missing:
        raise Failure(f"{missing}; csv, jsonl and npz need only NumPy") from None


@contextmanager
def csv(out: IO[bytes]) -> Iterator[Write]:
    """Writes a line for each row."""
    begun = False

    def write(columns: Sequence[Series]) -> None:
        nonlocal begun
        if not begun:
            out.write(text.csv_head(columns).encode())
        begun = True
        for lines in text.csv_lines(columns):
            out.write(lines)

    yield write


@contextmanager
def jsonl(out: IO[bytes]) -> Iterator[Write]:
    """Writes an object for each row."""

    def write(columns: Sequence[Series]) -> None:
        for lines in text.json_lines(columns):
            out.write(lines)

    yield write


@contextmanager
def parquet(out: IO[bytes]) -> Iterator[Write]:
    """Writes row groups of some ten thousand rows."""
    with _arrow(lambda schema: parquet_writer(out, schema)) as write:
        yield write


def parquet_writer(out: Any, schema: Any) -> Any:
    """Opens a Parquet writer. Floats rarely repeat, so they are stored without dictionaries, as byte streams."""
    pa: Any = import_module("pyarrow")
    floats = [field.name for field in schema if pa.types.is_floating(field.type)]
    alone = {*floats, "time", "offset"}
    others = [field.name for field in schema if field.name not in alone]
    writer = import_module("pyarrow.parquet").ParquetWriter
    return writer(out, schema, compression="zstd", use_dictionary=others, use_byte_stream_split=floats)


@contextmanager
def arrow(out: IO[bytes]) -> Iterator[Write]:
    """Writes the Arrow file format, which is also that of Feather."""
    with _arrow(lambda schema: import_module("pyarrow").ipc.new_file(out, schema)) as write:
        yield write


@contextmanager
def _arrow(opened: Callable[[Any], Any]) -> Iterator[Write]:
    pa = import_module("pyarrow")
    with ExitStack() as stack:
        writer: Any = None
        waiting: list[Any] = []

        def flush() -> None:
            nonlocal writer
            whole = pa.concat_tables(waiting).combine_chunks()
            writer = writer or stack.enter_context(opened(whole.schema))
            writer.write_table(whole)
            waiting.clear()
            del whole
            pa.default_memory_pool().release_unused()

        def write(columns: Sequence[Series]) -> None:
            waiting.append(frames.as_frame(columns, "pyarrow", True))
            if sum(map(len, waiting)) >= _GROUP:
                flush()

        yield write
        if waiting:
            flush()


@contextmanager
def npz(out: IO[bytes]) -> Iterator[Write]:
    """Writes an array for each column, `NAME/valid` if some rows have no value, and `schema`, which is JSON.

    A column of lists is two arrays: with the array `NAME/offsets`, row i is `NAME[offsets[i] : offsets[i + 1]]`. Lists
    in lists are JSON.
    """
    with tempfile.TemporaryDirectory(prefix="mip-") as folder:
        arrays = _Arrays(Path(folder))
        yield arrays.add
        arrays.save(out)


class _Arrays:
    """Arrays that grow in files, so that a log of any size needs little memory. Texts, which are rare, do not."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._arrays: dict[str, Array] = {}  # name -> an empty array of its type and shape
        self._counts: dict[str, int] = {}
        self._texts: dict[str, list[str]] = {}
        self._gaps: set[str] = set()
        self._schema: dict[str, dict[str, str]] = {}

    def add(self, columns: Sequence[Series]) -> None:
        for series in columns:
            self._schema[series.name] = series.facts
            valid = np.ones(len(series.values), bool) if series.mask is None else ~series.mask
            if not valid.all():
                self._gaps.add(series.name)
            self._append(f"{series.name}/valid", valid)
            depth, item = series.lists
            if depth:
                self._append_lists(series.name, frames.objects(series), None if depth > 1 or item == "|O" else item)
            elif series.values.dtype == object:
                self._texts.setdefault(series.name, []).extend(value or "" for value in frames.objects(series))
            else:
                self._append(series.name, series.values)

    def _append_lists(self, name: str, rows: list[Any], item: str | None) -> None:
        offsets = f"{name}/offsets"
        if offsets not in self._arrays:
            self._append(offsets, np.zeros(1, np.int64))
        before = self._counts.get(name, 0) if item else len(self._texts.setdefault(name, []))
        self._append(offsets, before + np.cumsum([len(row or ()) for row in rows], dtype=np.int64))
        flat = [value for row in rows for value in row or ()]
        if item:
            self._append(name, np.array(flat, item))
        else:
            self._texts[name] += map(json.dumps, flat)

    def _append(self, name: str, values: Array) -> None:
        self._arrays.setdefault(name, values[:0].copy())
        self._counts[name] = self._counts.get(name, 0) + len(values)
        with open(self._path(name), "ab") as file:
            file.write(np.ascontiguousarray(values).tobytes())

    def _path(self, name: str) -> Path:
        return self._folder / str(list(self._arrays).index(name))

    def save(self, out: IO[bytes]) -> None:
        """Writes the file."""
        with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
            for name, kind in self._arrays.items():
                if name.endswith("/valid") and name.removesuffix("/valid") not in self._gaps:
                    continue
                with archive.open(zipfile.ZipInfo(f"{name}.npy"), "w", force_zip64=True) as file:
                    shape = (self._counts[name], *kind.shape[1:])
                    head = {"descr": np.lib.format.dtype_to_descr(kind.dtype), "fortran_order": False, "shape": shape}
                    np.lib.format.write_array_header_2_0(file, head)
                    with open(self._path(name), "rb") as values:
                        shutil.copyfileobj(values, file)
            for name, texts in {**self._texts, "schema": json.dumps(self._schema)}.items():
                with archive.open(zipfile.ZipInfo(f"{name}.npy"), "w", force_zip64=True) as file:
                    np.lib.format.write_array(file, np.array(texts, "U"), allow_pickle=False)


FORMS: dict[str, Callable[[IO[bytes]], AbstractContextManager[Write]]] = {
    "csv": csv,
    "jsonl": jsonl,
    "npz": npz,
    "parquet": parquet,
    "arrow": arrow,
}
