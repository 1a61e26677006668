"""Examines the bytes between packets, which are NMEA sentences or damage."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from .. import sentences
from ..binding import SYNC
from ..columns.between import Gaps
from ..columns.piece import Piece
from ..text import show

#: The beginning of a sentence whose end is missing.
_BEGUN = re.compile(rb"[$!][ -~]*\r?\Z")
_MOST = 1 << 16  # bytes that are kept
_BLOCK = 400  # more equal bytes than a packet can have


class Damage(NamedTuple):
    """Bytes between two packets, of which some are not NMEA sentences."""

    begin: int
    end: int
    text: str
    cause: str


class Skipped:
    """Finds the damage in the pieces of a log."""

    def __init__(self) -> None:
        self.sentences = 0
        self._gaps = Gaps()
        self._begin = self._end = 0
        self._others = b""  # bytes outside sentences
        self._count = 0  # of these bytes
        self._line = b""  # the last line, which may continue

    def add(self, piece: Piece) -> Iterator[Damage]:
        """Yields the damage before each packet of the next piece."""
        for gap in self._gaps.in_piece(piece):
            if not gap.goes_on:
                yield from self._complete(False)
                self._begin = gap.offset
            self._end = gap.offset + len(gap.data)
            text = self._line + gap.data
            stop = text.rfind(b"\n") + 1
            self._lines(text[:stop])
            self._line = text[stop:]
            if len(self._line) > _MOST:
                self._other(self._line)
                self._line = b""
        if self._end < piece.begin + piece.size:  # a packet follows
            yield from self._complete(False)

    def end(self) -> Iterator[Damage]:
        """Yields the damage at the end of the log."""
        yield from self._complete(True)

    def _lines(self, text: bytes) -> None:
        """Examines whole lines. As in all commands, a sentence is a line with a correct checksum."""
        others = []
        for line in text.split(b"\n")[:-1]:
            sentence = sentences.last(line)
            self.sentences += sentence is not None
            others.append(line + b"\n" if sentence is None else line[: sentence[0]])
        self._other(b"".join(others))

    def _other(self, data: bytes) -> None:
        self._others = (self._others + data)[-_MOST:]
        self._count += len(data)

    def _complete(self, at_end: bool) -> Iterator[Damage]:
        if not (at_end and _BEGUN.match(self._line)):
            self._other(self._line)
        rest = self._others.strip(b"\r\n")
        count = self._count - len(self._others) + len(rest)
        self._others, self._line, self._count = b"", b"", 0
        reason = show.damage_text(rest)
        cut_off = at_end and ((SYNC.startswith(rest[:2]) and len(rest) < 4) or "missing" in reason)
        if rest and self._begin:  # a recording may begin within a packet
            text = f"{count} bytes of a packet" if cut_off else f"{count} bytes are not packets"
            cause = "cut off" if cut_off else "line damage"
            empty = max((0, 0xFF), key=rest.count)
            if rest.count(empty) > max(_BLOCK, 0.9 * len(rest)):
                text, reason, cause = f"{count} bytes, nearly all of them {empty:02X}", "", "never written"
            yield Damage(self._begin, self._end, f"{text}{': ' * bool(reason)}{reason}", cause)
