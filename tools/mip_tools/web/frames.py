"""The part of WebSocket (RFC 6455) that a server of bytes needs: the handshake, and frames."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator

_GUID = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
_CONTINUED = 0

#: Codes of a close frame.
NORMAL, GOING, PROTOCOL, TOO_LONG, TRY_AGAIN = 1000, 1001, 1002, 1009, 1013

#: The maximum size of a message from a page, in bytes.
LONGEST = 1 << 16


class Wrong(Exception):
    """A frame that violates the protocol; the connection is closed with `code`."""

    def __init__(self, code: int, text: str) -> None:
        super().__init__(text)
        self.code = code


def accept_key(key: str) -> str:
    """Computes the key with which a server accepts a handshake.

    >>> accept_key("dGhlIHNhbXBsZSBub25jZQ==")
    's3pPLMBiTxaQ9kYGzzhZRbK+xOo='
    """
    return base64.b64encode(hashlib.sha1(key.encode() + _GUID).digest()).decode()


def frame(kind: int, data: bytes = b"") -> bytes:
    """Makes a complete message of the server, which is not masked."""
    size = len(data)
    if size < 126:
        head = bytes((0x80 | kind, size))
    elif size < 1 << 16:
        head = bytes((0x80 | kind, 126)) + size.to_bytes(2, "big")
    else:
        head = bytes((0x80 | kind, 127)) + size.to_bytes(8, "big")
    return head + data


def closing(code: int, reason: str = "") -> bytes:
    return frame(CLOSE, code.to_bytes(2, "big") + reason.encode()[:123])


class Frames:
    """Divides the bytes from a client into messages, each with its kind; joins fragmented ones."""

    def __init__(self) -> None:
        self._pending = b""
        self._kind = 0
        self._begun = b""

    def feed(self, data: bytes) -> Iterator[tuple[int, bytes]]:
        """Adds bytes, and yields the messages that they complete. Raises Wrong."""
        self._pending += data
        while (found := self._next()) is not None:
            final, kind, payload = found
            if kind >= CLOSE:
                if not final or len(payload) > 125:
                    raise Wrong(PROTOCOL, "a control frame is fragmented or too long")
                yield kind, payload
                continue
            if (kind == _CONTINUED) != bool(self._kind):
                raise Wrong(PROTOCOL, "a continuation frame is missing or unexpected")
            self._kind = self._kind or kind
            self._begun += payload
            if len(self._begun) > LONGEST:
                raise Wrong(TOO_LONG, f"a message has more than {LONGEST} bytes")
            if final:
                kind, whole = self._kind, self._begun
                self._kind, self._begun = 0, b""
                yield kind, whole

    def _next(self) -> tuple[bool, int, bytes] | None:
        held = self._pending
        if len(held) < 2:
            return None
        first, second = held[0], held[1]
        if first & 0x70 or not second & 0x80:
            raise Wrong(PROTOCOL, "a frame without a mask, or with extensions")
        extra = {126: 2, 127: 8}.get(second & 0x7F, 0)
        start = 6 + extra
        if len(held) < start:
            return None
        size = int.from_bytes(held[2 : 2 + extra], "big") if extra else second & 0x7F
        if size > LONGEST:
            raise Wrong(TOO_LONG, f"a frame has more than {LONGEST} bytes")
        if len(held) < start + size:
            return None
        mask = held[start - 4 : start]
        payload = bytes(byte ^ mask[i & 3] for i, byte in enumerate(held[start : start + size]))
        self._pending = held[start + size :]
        return bool(first & 0x80), first & 0x0F, payload


__all__ = ["BINARY", "CLOSE", "GOING", "LONGEST", "NORMAL", "PING", "PONG", "TRY_AGAIN", "Frames", "Wrong",
           "accept_key", "closing", "frame"]  # fmt: skip
