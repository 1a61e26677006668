"""Writes MCAP files that Foxglove can open: a channel for each field, with JSON messages and their schemas."""

from __future__ import annotations

import struct
import zlib
from collections import Counter
from collections.abc import Callable, Iterable
from importlib import import_module
from itertools import chain
from typing import IO, TYPE_CHECKING, Any

from .. import __version__
from ..binding import MissingExtra
from ..errors import Failure
from ..names.occurrence import Occurrence
from .json_messages import Batch, Topic, clock_meaning, timed

if TYPE_CHECKING:
    from ..columns.scan import Array

_MAGIC = b"\x89MCAP0\r\n"
#: Bytes of messages that are compressed together.
_CHUNK = 1 << 20
#: The head of a message: opcode, size of the rest, channel, sequence number, log time, publish time.
_HEAD = [("opcode", "u1"), ("size", "<u8"), ("channel", "<u2"), ("sequence", "<u4"), ("logged", "<u8"), ("sent", "<u8")]
_HEAD_SIZE = 31


def require(form: str) -> Any:
    """Returns the module that writes the records of MCAP. Raises Failure if it is not installed."""
    try:
        return import_module("mcap.records")
    except ImportError:
        raise Failure(f"{MissingExtra('mcap', 'mcap')}; csv and jsonl need no extra") from None


def write_mcap(
    out: IO[bytes],
    messages: Iterable[Batch],
    clock: str | None,
    topic_of: Callable[[Occurrence | None], Topic],
    live: bool = False,
) -> bool:
    """Writes messages. Are there any? The file is complete even after an interrupt.

    `topic_of` makes the topic of a field, or of gaps. `live`: without a clock, messages have the time of the host.
    """
    import numpy as np

    meaning = clock_meaning(clock)
    file = _File(out, {"clock": clock or "host", "time": meaning})
    channels: dict[Occurrence | None, int] = {}
    try:
        for batch, moments in timed(messages, live and clock is None):
            for kind in (batch.kinds[number] for number in dict.fromkeys(batch.kind.tolist())):
                if kind not in channels:
                    about = {"time": meaning}
                    if kind is not None:
                        about["descriptor"] = f"0x{kind.set:02X},0x{kind.kind.DESCRIPTOR:02X}"
                    channels[kind] = file.channel(topic_of(kind), about)
            numbers = np.array([channels.get(kind, 0) for kind in batch.kinds], np.int64)[batch.kind]
            file.add(numbers, moments, batch.packet, batch.data)
    finally:
        file.finish()
    return bool(channels)


class _File:
    """A file of chunks. The records are those of `mcap`, whose writer encodes each message by itself, which takes most
    of the time of an export; here, the messages of a chunk are encoded together."""

    def __init__(self, out: IO[bytes], about: dict[str, str]) -> None:
        self._records = require("mcap")
        self._builder = import_module("mcap.data_stream").RecordBuilder
        self._compress = import_module("zstandard").ZstdCompressor(level=1).compress
        self._out, self._size = out, 0  # also of a pipe, which does not know its position
        self._schemas: list[Any] = []
        self._channels: list[Any] = []
        self._chunks: list[Any] = []
        self._new = b""  # records of channels that precede the next messages
        self._waiting: list[tuple[Array, list[bytes]]] = []  # heads and contents of messages
        self._waiting_size = 0
        self._counts: Counter[int] = Counter()
        self._write(_MAGIC, self._encoded(self._records.Header(profile="", library=f"mip-tools {__version__}")))
        metadata = self._encoded(self._records.Metadata(name="mip", metadata=about))
        self._metadata = self._records.MetadataIndex(offset=self._size, length=len(metadata), name="mip")
        self._write(metadata)

    def _encoded(self, *records: Any) -> bytes:
        builder = self._builder()
        for record in records:
            record.write(builder)
        return bytes(builder.end())

    def _write(self, *parts: bytes) -> None:
        for part in parts:
            self._out.write(part)
            self._size += len(part)

    def channel(self, topic: Topic, about: dict[str, str]) -> int:
        """Adds a channel, and returns its number."""
        number = len(self._channels) + 1
        schema = self._records.Schema(
            id=number, data=topic.schema.encode(), encoding="jsonschema", name=topic.schema_name
        )
        channel = self._records.Channel(
            id=number, topic=topic.name, message_encoding="json", metadata=about, schema_id=number
        )
        self._schemas.append(schema)
        self._channels.append(channel)
        self._new += self._encoded(schema, channel)
        return number

    def add(self, channels: Array, moments: Array, packets: Array, data: list[bytes]) -> None:
        """Adds messages."""
        import numpy as np

        heads = np.zeros(len(data), _HEAD)
        heads["opcode"], heads["channel"], heads["sequence"] = 5, channels, packets & 0xFFFFFFFF
        heads["logged"] = heads["sent"] = moments
        heads["size"] = np.fromiter(map(len, data), np.int64, len(data)) + _HEAD_SIZE - 9
        ends, begin = np.cumsum(heads["size"].astype(np.int64) + 9), 0
        while begin < len(data):
            before = int(ends[begin - 1]) if begin else 0
            stop = int(np.searchsorted(ends, before + _CHUNK - self._waiting_size, side="right")) + 1
            self._waiting.append((heads[begin:stop], data[begin:stop]))
            self._waiting_size += int(ends[min(stop, len(data)) - 1]) - before
            begin = stop
            if self._waiting_size > _CHUNK:
                self._flush()

    def _flush(self) -> None:
        """Writes a chunk of the waiting messages, with an index for each channel."""
        if not self._waiting:
            return
        import numpy as np

        from ..columns.distinct import distinct

        heads = np.concatenate([some for some, _ in self._waiting])
        data = chain.from_iterable(some for _, some in self._waiting)
        content = self._new + b"".join(chain.from_iterable(zip(heads.view(f"V{_HEAD_SIZE}").tolist(), data)))
        index = np.empty((len(heads), 2), "<u8")
        index[:, 0] = heads["logged"]
        index[:, 1] = len(self._new) + np.cumsum(heads["size"] + 9) - heads["size"] - 9
        packed = self._compress(content)
        begin, end = int(index[:, 0].min()), int(index[:, 0].max())
        chunk = self._encoded(
            self._records.Chunk(
                compression="zstd",
                data=packed,
                message_start_time=begin,
                message_end_time=end,
                uncompressed_crc=zlib.crc32(content),
                uncompressed_size=len(content),
            )
        )
        start = self._size
        self._write(chunk)
        offsets: dict[int, int] = {}
        for number in distinct(heads["channel"]).tolist():
            entries = index[heads["channel"] == number].tobytes()
            offsets[number] = self._size
            self._counts[number] += len(entries) // 16
            self._write(struct.pack("<BQHI", 7, 6 + len(entries), number, len(entries)), entries)
        self._chunks.append(
            self._records.ChunkIndex(
                chunk_length=len(chunk),
                chunk_start_offset=start,
                compression="zstd",
                compressed_size=len(packed),
                message_end_time=end,
                message_index_length=self._size - start - len(chunk),
                message_index_offsets=offsets,
                message_start_time=begin,
                uncompressed_size=len(content),
            )
        )
        self._new, self._waiting, self._waiting_size = b"", [], 0

    def finish(self) -> None:
        """Writes the last messages, and the summary: groups of records, and where they are."""
        self._flush()
        self._write(self._encoded(self._records.DataEnd(data_section_crc=0)))
        statistics = self._records.Statistics(
            attachment_count=0,
            channel_count=len(self._channels),
            channel_message_counts=self._counts,
            chunk_count=len(self._chunks),
            message_count=sum(self._counts.values()),
            message_end_time=max((chunk.message_end_time for chunk in self._chunks), default=0),
            message_start_time=min((chunk.message_start_time for chunk in self._chunks), default=0),
            metadata_count=1,
            schema_count=len(self._schemas),
        )
        begin, summary, offsets = self._size, b"", b""
        for group in (self._schemas, self._channels, [statistics], self._chunks, [self._metadata]):
            if records := self._encoded(*group):
                place = {"group_start": begin + len(summary), "group_length": len(records)}
                offsets += self._encoded(self._records.SummaryOffset(group_opcode=records[0], **place))
                summary += records
        footer = self._encoded(
            self._records.Footer(summary_start=begin, summary_offset_start=begin + len(summary), summary_crc=0)
        )
        footer = footer[:-4] + struct.pack("<I", zlib.crc32(summary + offsets + footer[:-4]))
        self._write(summary, offsets, footer, _MAGIC)
