"""Writes MCAP files that Foxglove can open: a channel for each field, with JSON messages and their schemas."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib import import_module
from typing import IO, Any

from .. import __version__
from ..binding import MissingExtra
from ..errors import Failure
from ..names.occurrence import Occurrence
from .json_messages import Message, Topic, clock_meaning, timed


def require(form: str) -> Any:
    """Returns the module that writes MCAP. Raises Failure if it is not installed."""
    try:
        return import_module("mcap.writer")
    except ImportError:
        raise Failure(f"{MissingExtra('mcap', 'mcap')}; csv and jsonl need no extra") from None


def write_mcap(
    out: IO[bytes],
    messages: Iterable[Message],
    clock: str | None,
    topic_of: Callable[[Occurrence], Topic],
    live: bool = False,
) -> None:
    """Writes messages. The file is complete even after an interrupt.

    `topic_of` makes the topic of a field. `live`: without a clock, messages have the time of the host.
    """
    module = require("mcap")
    writer = module.Writer(_Counted(out))
    writer.start(profile="", library=f"mip-tools {__version__}")
    meaning = clock_meaning(clock)
    writer.add_metadata("mip", {"clock": clock or "host", "time": meaning})
    channels: dict[Occurrence, int] = {}
    try:
        for message, moment in timed(messages, live and clock is None):
            kind = message.kind
            if kind not in channels:
                topic = topic_of(kind)
                schema = writer.register_schema(topic.schema_name, "jsonschema", topic.schema.encode())
                about = {"descriptor": f"0x{kind.set:02X},0x{kind.kind.DESCRIPTOR:02X}", "time": meaning}
                channels[kind] = writer.register_channel(topic.name, "json", schema, about)
            writer.add_message(channels[kind], moment, message.data, moment, message.packet & 0xFFFFFFFF)
    finally:
        writer.finish()


class _Counted:
    """An output that knows its position, even if it is a pipe."""

    def __init__(self, out: IO[bytes]) -> None:
        self._out, self._size = out, 0

    def write(self, data: bytes) -> int:
        self._size += len(data)
        return self._out.write(data)

    def tell(self) -> int:
        return self._size

    def flush(self) -> None:
        self._out.flush()
