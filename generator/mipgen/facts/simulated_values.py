"""Values of a simulated device: its quantities as values of parameters."""

from __future__ import annotations

from typing import Any

from mipgen import model as m
from mipgen.lower import codec
from mipgen.model.simulation import Value


def simulated_value(p: m.Parameter, quantity: Any, factor: float) -> Any:
    """Converts a quantity to a value of a parameter, in the form of the codec. Raises ValueError if it cannot.

    >>> p = m.Parameter("a", m.SCALARS["float"], None)
    >>> simulated_value(p, 9.80665, 1 / 9.80665)
    '0x3f800000'
    """
    names = (quantity,) if isinstance(quantity, str) else tuple(quantity) if isinstance(quantity, list) else ()
    if names and all(isinstance(x, str) for x in names) and any(v.type for v in p.readings):
        return number_of_name(p, Value("", names=names)) or number_of_name(p, Value("", bits=names))
    if isinstance(quantity, list) and p.kind == "array":
        return codec.canonical(p, [_scaled(p, number, factor) for number in quantity], p.name)
    if p.kind == "array" and p.count is not None:  # one number for all elements
        return codec.canonical(p, [_scaled(p, quantity, factor)] * p.count, p.name)
    return codec.canonical(p, _scaled(p, quantity, factor), p.name)


def _scaled(p: m.Parameter, quantity: Any, factor: float) -> Any:
    """Converts a quantity to the unit of a parameter, with as many digits as a reader would write."""
    scalar = p.leaf.scalar
    if not isinstance(quantity, (int, float)) or p.leaf.kind != "scalar" or p.leaf.named:
        return quantity
    if scalar.kind != "float":
        return round(quantity * factor)
    return quantity if factor == 1 else float(f"{quantity * factor:.{6 if scalar.size == 4 else 10}g}")


def number_of_name(p: m.Parameter, v: Value) -> Any:
    """Returns the number of the first name that a type of the parameter defines, or of all bits that the names
    select."""
    types = [p.element, *(x.type for x in p.readings)]
    if v.names:
        enums = [t for t in types if isinstance(t, m.Enum)]
        return next((x.value for name in v.names for t in enums if (x := t.by_name(name))), None)
    for t in types:
        if isinstance(t, m.Bitfield) and t.scalar is not None:
            masks = [mask(t, name) for name in v.bits]
            if None not in masks:
                return sum(mask for mask in masks if mask is not None)
    return None


def mask(t: m.Bitfield, name: str) -> int | None:
    """Returns the mask of a bit, or of a value `bits.value` of a number inside the bitfield."""
    bits, _, value = name.partition(".")
    b = next((b for b in t.bits if b.name == bits), None)
    if b is None or not value:
        return b.mask if b else None
    entry = b.enum.by_name(value) if b.enum else None
    return entry.value << b.first if entry else None


def parameter_at(parameters: tuple[m.Parameter, ...], path: str) -> m.Parameter | None:
    """Finds a parameter, or the member of a structure: "device_info.model_number"."""
    name, _, rest = path.partition(".")
    p = next((p for p in parameters if p.name == name), None)
    return parameter_at(p.struct.parameters if p and p.struct else (), rest) if rest else p


def set_path(values: codec.Values, path: str, value: Any) -> None:
    name, _, rest = path.partition(".")
    if rest:
        set_path(values.setdefault(name, {}), rest, value)
    else:
        values[name] = value
