"""Writes tables to files, part by part: CSV, JSON lines and Parquet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from importlib import import_module
from typing import IO, Any

from ..binding import MissingExtra
from ..columns import frames, text
from ..columns.tables import Series
from ..errors import Failure

#: Writes the columns of a part.
Write = Callable[[Sequence[Series]], None]
#: The number of rows that are written together.
_GROUP = 1 << 15


def require(form: str) -> None:
    """Raises Failure if a package that the format needs is missing."""
    try:
        if form == "parquet":
            frames.library("pyarrow")
    except MissingExtra as missing:
        raise Failure(f"{missing}; csv and jsonl need only NumPy") from None


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
    pa = import_module("pyarrow")
    with ExitStack() as stack:
        writer: Any = None
        waiting: list[Any] = []

        def flush() -> None:
            nonlocal writer
            whole = pa.concat_tables(waiting).combine_chunks()
            writer = writer or stack.enter_context(parquet_writer(out, whole.schema))
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


def parquet_writer(out: Any, schema: Any) -> Any:
    """Opens a Parquet writer. Floats rarely repeat, so they are stored without dictionaries, as byte streams."""
    pa: Any = import_module("pyarrow")
    floats = [field.name for field in schema if pa.types.is_floating(field.type)]
    alone = {*floats, "time", "offset"}
    others = [field.name for field in schema if field.name not in alone]
    writer = import_module("pyarrow.parquet").ParquetWriter
    return writer(out, schema, compression="zstd", use_dictionary=others, use_byte_stream_split=floats)


FORMS: dict[str, Callable[[IO[bytes]], AbstractContextManager[Write]]] = {
    "csv": csv,
    "jsonl": jsonl,
    "parquet": parquet,
}
