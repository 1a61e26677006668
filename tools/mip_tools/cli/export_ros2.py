"""A bag of ROS 2: standard messages in the axes of REP 103, and those of mip_msgs as the device sends the data."""

from __future__ import annotations

import argparse
import os
import shutil
from collections.abc import Sequence
from importlib import import_module
from itertools import chain
from pathlib import Path
from typing import Any

from ..binding import SECOND
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from ..ros.standard import Converter
from ..ros.types import Types
from . import clocks, inputs
from .export_mcap import check, timed
from .messages import survey
from .samples import Sample, kept, samples
from .selection import Selection


def require(form: str) -> None:
    """Raises Failure if the package that writes bags is missing."""
    Types()


class Job:
    """The output for a log."""

    def __init__(self, name: str, options: argparse.Namespace, selection: Selection) -> None:
        if options.split or options.named:
            raise Misuse("--split and --names are for tables; a bag has a topic for each message")
        if options.output == "-":
            raise Misuse("a bag is a folder; name one with -o")
        self._name, self._options, self._selection = name, options, selection
        with inputs.columns(name) as log:
            self.types, self._clock = survey(log, selection)
        check(self._clock, options)

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes a bag, a folder that must not exist. Raises Failure."""
        folder = Path(path)
        if os.path.lexists(path):
            raise Failure(f"{path} exists; name another folder")
        packets = kept(samples(inputs.pieces(self._name), types, self._selection, self._clock), self._options.invalid)
        try:
            self._write(folder, packets)
        except BaseException as error:
            shutil.rmtree(folder, ignore_errors=True)
            if isinstance(error, OSError):
                raise Failure(f"{path} cannot be written: {error.strerror or error}") from None
            raise

    def _write(self, folder: Path, packets: Any) -> None:
        rosbag2: Any = import_module("rosbags.rosbag2")
        known = Types(self._options.messages)
        converter = Converter()
        with rosbag2.Writer(folder, version=9, storage_plugin=rosbag2.StoragePlugin.MCAP) as bag:
            topics: dict[str, Any] = {}

            def write(topic: str, kind: str, moment: int, frame: str, values: dict[str, Any]) -> None:
                if topic not in topics:
                    topics[topic] = bag.add_connection(topic, kind, typestore=known.store)
                stamp = {"sec": moment // SECOND, "nanosec": moment % SECOND}
                message = known.build(kind, {"header": {"stamp": stamp, "frame_id": frame}, **values})
                bag.write(topics[topic], moment, known.store.serialize_cdr(message, kind))

            packet: list[Sample] = []
            last = 0
            for sample, moment in timed(chain.from_iterable(packets), False):
                if packet and packet[0].packet != sample.packet:
                    self._standard(converter, packet, last, write)
                    packet = []
                packet.append(sample)
                last = moment
                kind = known.of(sample.kind.kind)
                if kind is not None:
                    values = known.content(sample.value, kind)
                    write(f"/mip/{sample.kind.name.replace('.', '/')}", kind, moment, "imu_link", values)
            if packet:
                self._standard(converter, packet, last, write)
        if not topics:
            raise Failure(f"{self._options.file} has nothing of which there are messages; name the folder of mip_msgs")

    def _standard(self, converter: Converter, packet: list[Sample], moment: int, write: Any) -> None:
        for m in converter.messages({sample.kind.name: sample.value for sample in packet}):
            write(m.topic, m.type, moment, m.frame, m.values)
        own = packet[0]
        if own.own and own.time is not None and clocks.dated(self._clock):
            at = {"sec": own.time // SECOND, "nanosec": own.time % SECOND}
            values = {"time_ref": at, "source": self._clock}
            write("/time_reference", "sensor_msgs/msg/TimeReference", moment, "imu_link", values)


__all__ = ["Job", "require"]
