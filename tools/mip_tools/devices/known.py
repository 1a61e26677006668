"""The device that sends data, as far as it is known: named by the user, asked at the port, or found in the data."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..binding import DEVICES, MipError, UnknownName, device_id, identify, registry

#: The field with which a device identifies itself, and its command.
IDENTITY, _COMMAND = "base.get_device_info_response", "base.get_device_info"
#: Seconds to wait for a reply. Ports may also be those of programs that only send.
_PATIENCE = 1.0


def in_words(names: Sequence[str]) -> str:
    """Lists names in a sentence: `a`, `a and b`, `a, b and c`."""
    return " and ".join([", ".join(names[:-1])] * (len(names) > 1) + [*names[-1:]])


def identity_type() -> Any:
    """Returns the type of the field with which a device identifies itself; None if the specification has none."""
    try:
        return registry.by_name(IDENTITY)
    except UnknownName:
        return None


class KnownDevice:
    """What is known of the device so far."""

    def __init__(self, named: str | None = None, at_port: str | None = None) -> None:
        """`at_port` is the id of the device that replied at a port."""
        #: The id of the device that was named.
        self.named = None if named is None else device_id(named)
        self._devices = {at_port: "at the port"} if at_port else {}  # id -> where it was found
        self._reported: set[str] = set()

    @property
    def id(self) -> str | None:
        """The id of the device; None if it is not known, or if several sent the data."""
        return self.named or (next(iter(self._devices)) if len(self._devices) == 1 else None)

    def ask(self, port: Any) -> bool:
        """Asks the device at an open port, which may not reply. Returns True: what it sends meanwhile is kept."""
        if self.named is None and identity_type() is not None:
            try:
                self.add_reply(port.request(registry.by_name(_COMMAND)(), timeout=_PATIENCE), "at the port")
            except (MipError, OSError):
                pass
        return True

    def learn(self, packet: Any) -> None:
        """Searches a packet that has arrived."""
        kind = identity_type()
        if self.named is None and kind is not None and packet.set == kind.SET:
            for field in registry.decode_packet(packet):
                if isinstance(field, kind):
                    self.add_reply(field, "from the log")

    def add_reply(self, reply: Any, where: str) -> None:
        """Adds what a device replied."""
        profile = identify(reply.device_info) if hasattr(reply, "device_info") else None
        if profile is not None:
            self._devices.setdefault(profile.id, where)

    def lines(self) -> list[str]:
        """Says in a line what is assumed about the device."""
        others = [DEVICES[device].title for device in self._devices if device != self.named]
        names = in_words(others)
        if self.named is not None:
            where = next(iter(self._devices.values()), "")
            title = DEVICES[self.named].title
            return [f"device {title} (named), although it is a {names} {where}"] if others else []
        if len(others) > 1:
            return [f"{len(others)} devices in the log, {names}: flags are read as those of no known device"]
        return [f"device {names} ({next(iter(self._devices.values()))})"] if others else []

    def news(self) -> list[str]:
        """Returns the lines that no earlier call has returned."""
        new = [text for text in self.lines() if text not in self._reported]
        self._reported.update(new)
        return new


__all__ = ["IDENTITY", "KnownDevice", "identity_type", "in_words"]
