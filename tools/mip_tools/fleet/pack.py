"""Packs fragments of many logs into few files with large row groups."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

from .dataset import Part, placed, rows_folder
from .work import Pack, Source

#: The minimum size of a row group in memory, in bytes, if a field has that much.
GROUP = 1 << 26


def planned(
    folder: Path, work: Path, fresh: Sequence[tuple[str, str, Source]], before: Sequence[Part], group: int
) -> tuple[list[tuple[str, str, Pack]], list[Part]]:
    """Plans the files to make from new fragments (clock, field, rows). Also returns the earlier files that remain.

    A file that is smaller than a group is rewritten together with the new rows.
    """
    new = {(clock, field) for clock, field, _ in fresh}
    small = [part for part in before if part.bytes < group and (part.clock, part.field) in new]
    every = [(part.clock, part.field, Source(folder / part.path, part.bytes)) for part in small]
    every = sorted([*every, *fresh], key=lambda part: part[:2])  # stable: the logs stay in their order
    packs = []
    for (clock, field), several in groupby(every, key=lambda part: part[:2]):
        for sources in _enough([source for *_, source in several], group):
            contents = repr([(part.path.relative_to(folder).as_posix(), part.log, part.device) for part in sources])
            name = hashlib.sha256(contents.encode()).hexdigest()[:16]
            place = work / rows_folder(clock, field) / f"{name}.parquet"
            packs.append((clock, field, Pack(place, tuple(sources), group)))
    return packs, [part for part in before if part not in small]


def _enough(sources: Sequence[Source], group: int) -> list[list[Source]]:
    """Divides a list into parts with enough rows for a group each; the remaining rows are added to the last part."""
    parts: list[list[Source]] = [[]]
    for source in sources:
        if sum(part.bytes for part in parts[-1]) >= group:
            parts.append([])
        parts[-1].append(source)
    if len(parts) > 1 and sum(part.bytes for part in parts[-1]) < group:
        parts[-2:] = [parts[-2] + parts[-1]]
    return parts


def write_packed(work: Pack) -> tuple[int, int]:
    """Writes a file, unless it exists. Returns the number of rows, and their size in memory."""
    import pyarrow.parquet as parquet

    from ..formats.writers import parquet_writer

    left = sum(source.bytes for source in work.sources)
    if not work.path.exists():
        work.path.parent.mkdir(parents=True, exist_ok=True)
        with placed(work.path) as part:
            writer: Any = None
            try:
                for table in _groups(work, left):
                    writer = writer or parquet_writer(part, table.schema)
                    writer.write_table(table, row_group_size=len(table))
            finally:
                if writer:
                    writer.close()
    return parquet.read_metadata(work.path).num_rows, left


def _groups(work: Pack, left: int) -> Iterator[Any]:
    """Yields the rows of each group; the last one includes a rest that is too small for a group."""
    import pyarrow as pa

    waiting: list[Any] = []
    size = 0
    for source in work.sources:
        for table in _tables(source):
            own = table.drop_columns(["log", "device"]).nbytes  # these two need almost no space in Parquet
            waiting.append(table)
            size += own
            left -= own
            if size >= work.group and left >= work.group:
                yield pa.concat_tables(waiting).unify_dictionaries()
                waiting, size = [], 0
    if waiting:
        yield pa.concat_tables(waiting).unify_dictionaries()


def _tables(source: Source) -> Iterator[Any]:
    """Yields the rows of a source, in batches, with their log and device."""
    import pyarrow as pa

    if source.path.suffix == ".parquet":
        for batch in pa.parquet.ParquetFile(source.path).iter_batches(1 << 18):
            yield pa.Table.from_batches([batch])
        return
    with pa.memory_map(str(source.path)) as file:
        reader = pa.ipc.open_file(file)
        for i in range(reader.num_record_batches):
            table = pa.Table.from_batches([reader.get_batch(i)])
            for name, text in (("log", source.log), ("device", source.device)):
                table = table.append_column(name, _same(text, len(table)))
            yield table


def _same(text: str | None, count: int) -> Any:
    """Makes a column with the same text in all rows."""
    import numpy as np
    import pyarrow as pa

    from ..columns import buffers

    mask = np.ones(count, bool) if text is None else None
    which = buffers.array(pa, np.zeros(count, np.int32), mask)
    return pa.DictionaryArray.from_arrays(which, buffers.texts(pa, [] if text is None else [text]))
