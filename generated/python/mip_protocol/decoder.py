"""The fast way from a stream of bytes to fields."""

from __future__ import annotations

from typing import Any

from .layouts import KEY, Fields
from .packet import Packet
from .parser import Scanner
from .registry import LAYOUTS


class Decoder(Scanner[Fields]):
    """A parser that returns the fields of each packet, as `registry.decode_packet` does, but
    faster.

    >>> decoder = Decoder()
    >>> decoder.feed(bytes.fromhex("75650104 04f10100 d56a"))
    [(Acknowledge(command=1, code=<AckCode.OK: 0>),)]
    """

    def _scan(
        self, data: bytes, items: list[Any], between: bool = False, final: bool = False
    ) -> None:
        buffer = self._rest + data if self._rest else data
        add, known, slowly = items.append, LAYOUTS.unchecked.get, LAYOUTS.decode_slowly
        at, length = 0, len(buffer)
        while True:
            layout = known(buffer[at : at + KEY])
            if layout is not None:
                size, decode = layout
                end = at + size
                if end <= length and (fields := decode(buffer, at)):
                    add(fields)
                    at = end
                    continue
            begin, end = self._find(buffer, at, final)
            if begin != at:
                self.skipped += begin - at
                if between:
                    add(buffer[at:begin])
            if not end:
                self._rest = buffer[begin:]
                return
            add(slowly(Packet._trusted(buffer[begin:end])))
            at = end
