"""Formats the values of all rows of a column."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import Field, Parameter, info, named
from ..columns import buffers
from ..columns.scan import Array
from ..columns.states import different
from ..columns.text import numbers, pyarrow, shortest_decimals

if TYPE_CHECKING:
    from ..columns.column import Column

#: A format, and an array for each of its arguments, with an item for each row.
Texts = tuple[str, list[Array]]
#: From so many rows on, pyarrow is faster: if it must be imported first, and if it is imported.
_MANY, _SOME = 4096, 200


def formatted_rows(template: str, values: list[Array], count: int) -> list[bytes]:
    """Formats each row; with pyarrow, several times as fast."""
    if not values:
        return [(template % ()).encode()] * count
    pa = pyarrow() if count >= (_SOME if "pyarrow" in sys.modules else _MANY) else None
    if pa is None:
        return [text.encode() for text in map(template.__mod__, zip(*map(_items, values)))]
    first, *others = (between.replace("%%", "%") for between in re.split("%[rds]", template))
    cells = [each for value, after in zip(values, others) for each in (_cells(pa, value), after)]
    return buffers.items(buffers.joined(pa, first, *cells))


def _items(values: Array) -> list[Any]:
    return list((shortest_decimals(values) if values.dtype == np.float32 else values).tolist())


def _cells(pa: Any, values: Array) -> Any:
    if values.dtype.kind == "f":
        return numbers(pa, values, None)
    return (
        buffers.texts(pa, values.tolist()) if values.dtype.kind in "OU" else buffers.array(pa, values).cast(pa.string())
    )


def json_object(
    column: Column[Any],
    kind: type[Field],
    device: str | None,
    names: bool = True,
    separators: tuple[str, str] = (", ", ": "),
) -> Texts | None:
    """Formats the values of fields as JSON objects, like `to_dict`; None if a text depends on more than one value."""
    between, after = separators
    parts: list[str] = []
    values: list[Array] = []
    for p in info(kind).members:
        made = _json(p if device is None else p.on(device), column, names, separators)
        if made is None:
            return None
        parts.append(f"{json.dumps(p.name)}{after}{made[0]}")
        values += made[1]
    return f"{{{between.join(parts)}}}", values


def _json(p: Parameter, column: Column[Any], names_: bool, separators: tuple[str, str]) -> Texts | None:
    values = plain_texts(p, column)
    if values is None:
        return None
    if is_named(p):

        def word(value: Any, holder: object) -> str:
            return json.dumps(named(p, value, holder) if names_ else value, separators=separators)

        return name_texts(p, column, word)
    single, arguments = singles(values)
    if single == "%r" and not np.isfinite(values).all():
        single = "%s"
        texts = [[text.decode() for text in formatted_rows("%r", [each], len(each))] for each in arguments]
        arguments = [np.where(np.isfinite(each), own, "null") for each, own in zip(arguments, texts)]
    if not p.elements:
        return single, arguments
    between, after = separators
    return f"{{{between.join([f'{json.dumps(e)}{after}{single}' for e in p.elements])}}}", arguments


def plain_texts(p: Parameter, column: Column[Any]) -> Array | None:
    """Returns the values of a parameter if each is a number, a name or a vector, independent of other values."""
    if p.attribute not in column.names or any(v.by != "device" for v in p.variants) or p.refers:
        return None
    if p.length is not None or p.scalar in ("char", "bits") or p.kind not in ("scalar", "array"):
        return None
    values: Array = column[p.attribute]
    return None if values.ndim > 1 and is_named(p) else values


def is_named(p: Parameter) -> bool:
    return p.type is not None or p.scalar == "bool"


def name_texts(p: Parameter, column: Column[Any], word: Callable[[Any, Any], str]) -> Texts:
    """Formats values by name; each different value is formatted once in each state on which its bits depend.

    `word` takes a value, and an object with the state.
    """
    values, place = different(column, p.attribute, column[p.attribute])
    as_bool = p.scalar == "bool" and p.type is None
    words = [word(bool(v) if as_bool and v in (0, 1) else v, state) for v, state in values]
    return "%s", [np.array([*words, ""], object)[place]]


def singles(values: Array) -> Texts:
    """Returns the format of one number, and the numbers: an array for each element of a vector."""
    return "%r" if values.dtype.kind == "f" else "%d", list(values.T) if values.ndim > 1 else [values]
