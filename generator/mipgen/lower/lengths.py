"""Lengths of fields as manuals count them."""

from __future__ import annotations

import re

from mipgen import model as m

from .extent import Extent, shortest_size


def computed_length(f: m.Field, rule: str) -> str:
    """Returns the length of a whole field as a manual counts it: "14", or "4 + 3*count".

    `wire` counts every byte. `scalars` counts scalars and arrays of them, and counted arrays in
    formulas, but neither vectors nor structures nor unions.
    """
    counted = (p for p in f.parameters if rule == "wire" or p.open or _is_number(p))
    return str(Extent(2) + shortest_size(counted))


def _is_number(p: m.Parameter) -> bool:
    return isinstance(p.element, (m.Scalar, m.Enum, m.Bitfield))


def same(printed: str, computed: str) -> bool:
    """True if a printed length equals the computed one.

    >>> same("4 + 3*N", "4 + 3*N"), same("4+3*N", "4 + 3*N"), same("0x0E", "14"), same("5 + 1*n", "5 + n")
    (True, True, True, True)
    """
    if re.fullmatch(r"0x[0-9A-Fa-f]+", printed):
        printed = str(int(printed, 16))
    return re.sub(r"\b1\*|\s", "", printed) == re.sub(r"\s", "", computed)
