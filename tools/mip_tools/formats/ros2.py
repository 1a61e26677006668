"""Writes ROS 2 bags: standard messages in the axes of REP 103."""

from __future__ import annotations

import argparse
import os
import shutil
from collections.abc import Iterator, Sequence
from importlib import import_module
from itertools import groupby
from pathlib import Path
from typing import Any

from ..binding import SECOND, Field
from ..columns import Log
from ..columns.column import Column
from ..columns.stamps import NONE
from ..errors import Failure, Misuse
from ..logs import inputs
from ..names.occurrence import Occurrence
from ..names.selection import Selection
from ..ros import cdr, standard
from ..ros.types import Types
from ..text import clocks
from ..text.show import Reads
from .json_messages import Batch, timed
from .messages import MessageExport, Messages, Objects

#: The frame of messages in the axes of the device.
FRAME = "imu_link"
REFERENCE = "sensor_msgs/msg/TimeReference"
#: The first time that a message cannot represent: its seconds are a signed 32-bit number.
END = SECOND << 31


def require(form: str) -> None:
    """Raises Failure if the package that writes bags is not installed."""
    Types()


class _Times:
    """Makes no messages of fields: a bag has only standard ones, with the times of the fields."""

    reads: Reads = staticmethod(lambda kind: None)

    def rows(self, column: Column[Any], kind: Occurrence, objects: Objects) -> Sequence[None]:
        return [None] * len(column)

    def field(self, field: Field, kind: Occurrence) -> None:
        return None


class Job(MessageExport):
    """The output for a log."""

    def __init__(self, name: str, options: argparse.Namespace, selection: Selection) -> None:
        if options.named:
            raise Misuse("--names is for tables; a bag has standard messages")
        if options.invalid == "mask":
            raise Misuse("--invalid mask leaves values out, which standard messages cannot do; use --invalid drop")
        if options.output == "-":
            raise Misuse("a bag is a folder; name one with -o")
        super().__init__(name, options, selection)

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes a bag, a folder that must not exist. Raises Failure."""
        folder = Path(path)
        if os.path.lexists(path):
            raise Failure(f"{path} exists; name another folder")
        try:
            with inputs.open_columns(self._name, self._options.device) as log:
                self._write(folder, log)
        except BaseException as error:
            shutil.rmtree(folder, ignore_errors=True)
            if isinstance(error, OSError):
                raise Failure(f"{path} cannot be written: {error.strerror or error}") from None
            raise

    def _write(self, folder: Path, log: Log) -> None:
        rosbag2: Any = import_module("rosbags.rosbag2")
        types = Types()
        made = Messages(self.types, self._selection, self._clock, self._options.invalid, _Times())
        converter = standard.Converter(FRAME)
        waiting: dict[int, list[tuple[str, str, bytes]]] = {}  # standard messages of packets that are not written yet
        with rosbag2.Writer(folder, version=9, storage_plugin=rosbag2.StoragePlugin.MCAP) as bag:
            topics: dict[str, Any] = {}

            def write(topic: str, kind: str, moment: int, message: bytes) -> None:
                if topic not in topics:
                    topics[topic] = bag.add_connection(topic, kind, typestore=types.store)
                bag.write(topics[topic], moment, cdr.stamped(message, moment))

            def messages() -> Iterator[Batch]:
                for part, first in made.parts(log):
                    chosen = (part, self.types, made.kept, self._clock)
                    for each in converter.messages(standard.message_fields(*chosen), standard.attitudes(*chosen)):
                        for packet, message in zip((each.packet + first).tolist(), _encoded(each, types)):
                            waiting.setdefault(packet, []).append((each.topic, each.type, message))
                    yield from made.of_part(part, first)

            for batch, moments in timed(messages(), False):
                has_time = batch.own & (batch.time != NONE)
                rows = zip(*(each.tolist() for each in (batch.packet, moments, has_time, batch.time)))
                for packet, group in groupby(rows, lambda row: row[0]):
                    several = list(group)
                    self._check(packet, several[-1][1])
                    _, moment, timed_itself, time = several[-1]
                    for topic, kind, message in waiting.pop(packet, ()):
                        write(topic, kind, moment, message)
                    if timed_itself and clocks.dated(self._clock):
                        write("/time_reference", REFERENCE, moment, self._reference(types, time))
        if not topics:
            raise Failure(f"{self._options.file} has no data for standard messages; mcap has messages of all fields")

    def _check(self, packet: int, moment: int) -> None:
        """Raises Failure if a message cannot represent this time."""
        if moment >= END:
            of, last = (clocks.stamp(self._clock, each, 3) for each in (moment, END - SECOND))
            raise Failure(
                f"{self._name}: packet {packet} has the time {of}, but ROS 2 times end at {last}; use --format mcap "
                "instead, which has 64-bit times"
            )

    def _reference(self, types: Types, time: int) -> bytes:
        """Makes the message with the time of a packet by the device's clock."""
        sec, nanosec = divmod(time, SECOND)
        values = {"time_ref.sec": sec, "time_ref.nanosec": nanosec}
        return types.rows(REFERENCE, 1, values, {"header.frame_id": FRAME, "source": self._clock})[0]


def _encoded(made: standard.Messages, types: Types) -> list[bytes]:
    """Encodes standard messages, without their times."""
    texts = {"header.frame_id": made.frame, "child_frame_id": made.child}
    return types.rows(made.type, len(made.packet), made.values, texts)
