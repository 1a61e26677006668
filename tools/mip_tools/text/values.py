"""Formats values of fields as text and for JSON."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from ..binding import Described, Parameter, Structure, info
from ..binding import shortest as shortest
from .references import Inside


def value_text(p: Parameter, value: Any) -> str:
    """Formats a value, with names but without units."""
    return replace(p, units=()).format(value)


def rounded(value: float, scalar: str) -> str:
    """Formats a number with the precision of its type on the wire."""
    return shortest(value) if scalar == "float" else repr(value)


def to_plain(value: Described, named: bool, device: str | None = None, inside: Inside | None = None) -> dict[str, Any]:
    """Converts a field for strict JSON; numbers have the precision of their type on the wire. `inside` are the
    differences of its members."""
    values: dict[str, Any] = value.INFO.to_dict(value, named, True, device, inside)
    _shorten(value.INFO.members, values)
    return values


def _shorten(members: Iterable[Parameter], plain_values: dict[str, Any]) -> None:
    for p in members:
        if isinstance(p.type, type) and issubclass(p.type, Structure):
            for inner in plain_values[p.name] if isinstance(plain_values[p.name], list) else [plain_values[p.name]]:
                if isinstance(inner, dict):
                    _shorten(info(p.type).members, inner)
        elif p.scalar == "float":
            plain_values[p.name] = _shorter(plain_values[p.name])


def _shorter(value: Any) -> Any:
    if isinstance(value, float) and math.isfinite(value):
        return float(shortest(value))
    if isinstance(value, list):
        return [_shorter(v) for v in value]
    return {k: _shorter(v) for k, v in value.items()} if isinstance(value, dict) else value
