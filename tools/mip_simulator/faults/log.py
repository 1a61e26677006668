"""The log of injected faults."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TextIO

from mip_tools.binding import RawField


@dataclass(frozen=True)
class Injected:
    """One injected fault, or, with `every_packet`, one sent packet (kind `sent`)."""

    now: int
    """Nanoseconds since the start of the simulation."""
    kind: str
    detail: str
    packet: bytes | None = None
    """The packet before the fault."""
    damaged: bool = False
    """May this packet be missing or changed at the receiver? All others arrive intact."""
    added: bytes = b""
    """The extra bytes that the fault inserted."""
    command: RawField | None = None
    """The command whose answer is wrong, late or missing."""

    def as_json(self) -> str:
        """Formats one line, without absent values; bytes are hexadecimal."""
        line: dict[str, Any] = {"time": self.now / 1e9, "kind": self.kind, "detail": self.detail}
        if self.packet is not None:
            line |= {"packet": self.packet.hex(), "damaged": self.damaged}
        if self.added:
            line["added"] = self.added.hex()
        if self.command is not None:
            set_number, descriptor, data = self.command
            line["command"] = {"set": set_number, "descriptor": descriptor, "data": data.hex()}
        return json.dumps(line)


def json_log(file: TextIO) -> Callable[[Injected], None]:
    """Makes a log that writes each fault at once, as one JSON object."""

    def write(injected: Injected) -> None:
        file.write(injected.as_json() + "\n")
        file.flush()

    return write
