"""Facts about values: elements, unit, frame, range, default, and the flag that marks them as valid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import pi

from mipgen import model as m

from . import descriptors
from .texts import Fact, Ref, Text, fact, interleaved, joined, number, prose


def measures(of: m.Parameter | m.Variant, p: m.Parameter, model: m.Model) -> Iterator[Fact]:
    """Yields elements, unit, frame, range and default of a parameter, or of a variant of it."""
    elements = of.elements if isinstance(of, m.Variant) else p.elements
    if elements:
        yield fact("elements", (", ".join(elements),), "Elements: {}.")
    if of.units:
        yield fact("unit", (", ".join(m.unit_symbols(of.units)),), "Unit: {}." if len(of.units) == 1 else "Units: {}.")
    if of.frame:
        word = next(w for w in model.protocol.frames if w.symbol == of.frame)
        yield fact("frame", (Ref(word, word.symbol),), "Frame: {}.")
    above, below = (of.above, of.below) if isinstance(of, m.Parameter) else (None, None)
    bounds = limits_text(of.minimum, of.maximum, above, below, lambda x: numeral(p, x))
    if isinstance(of, m.Parameter) and of.magnitude != (None, None):
        bounds = ", ".join(filter(None, (bounds, f"magnitude {limits_text(*of.magnitude)}")))
    if bounds:
        yield fact("range", (bounds,), "Range: {}.")
    if isinstance(of, m.Parameter) and of.at_rest:
        yield fact("at_rest", (rest(of),), "At rest and level: {}.")
    if isinstance(of, m.Parameter) and of.positive:
        yield fact("positive", prose(of.positive, model), "Positive: {}.")
    if of.default is not None:
        yield fact("default", default_text(of.default, p), "Default: {}.")


def rest(p: m.Parameter) -> str:
    """Writes the values of a level device at rest: "x 0, y 0, z -1"."""
    if not p.elements:
        return number(p.at_rest[0])
    pairs = zip(p.elements, p.at_rest, strict=True)
    return ", ".join(f"{name} {number(value)}" for name, value in pairs if value is not None)


Bound = float | int | None


def limits_text(
    low: Bound, high: Bound, above: Bound = None, below: Bound = None, say: Callable[[float | int], str] = number
) -> str:
    """Words bounds; `low` and `high` are inclusive, `above` and `below` exclusive.

    >>> limits_text(1, 2.5), limits_text(0, None), limits_text(None, 10)
    ('1 to 2.5', 'at least 0', 'at most 10')
    >>> limits_text(None, 10, above=0), limits_text(None, None, below=1)
    ('greater than 0, at most 10', 'less than 1')
    >>> limits_text(-pi, pi)
    '-pi to pi'
    """

    def text(bound: float | int) -> str:
        return {pi: "pi", -pi: "-pi"}.get(bound) or say(bound)

    if low is not None and high is not None:
        return f"{text(low)} to {text(high)}"
    words = (("at least", low), ("greater than", above), ("at most", high), ("less than", below))
    return ", ".join(f"{word} {text(bound)}" for word, bound in words if bound is not None)


def numeral(p: m.Parameter, value: float | int) -> str:
    """Writes a number of a parameter in its usual notation."""
    return descriptors.hexadecimal(p, int(value)) if p.shown else number(value)


def default_text(value: object, p: m.Parameter) -> Text:
    """Writes a factory default, with the names of values and bits."""
    if isinstance(value, bool):
        return (str(value).lower(),)
    if isinstance(value, str):
        entry = p.element.by_name(value) if isinstance(p.element, m.Enum) else None
        return (Ref(entry, value, p.element),) if entry and isinstance(p.element, m.Enum) else (f'"{value}"',)
    if isinstance(value, (list, tuple)):
        if isinstance(p.element, m.Bitfield) and all(isinstance(v, str) for v in value):
            bits = {b.name: b for b in p.element.bits}
            return joined([(Ref(bits[name], name, p.element),) for name in value]) if value else ("0",)
        return interleaved([default_text(v, p) for v in value], ", ")
    return (numeral(p, value) if isinstance(value, (int, float)) else str(value),)


def validity(paths: tuple[str, ...], p: m.Parameter, record: m.Record, device: str | None = None) -> Fact:
    """Words the bit that marks a value as valid, or a bit for each element."""
    refs = [_bit(path, record, device) for path in dict.fromkeys(paths)]
    if len(refs) == 1:
        return fact("valid", (refs[0],), "Valid if {} is set." if "." in refs[0].words else "Valid if {} is true.")
    names = p.elements or tuple(map(str, range(len(paths))))
    each = [(f"{name}: ", _bit(path, record, device)) for name, path in zip(names, paths, strict=False)]
    return fact("valid", interleaved(each, ", "), "Each element has its own valid flag. {}.")


def _bit(path: str, record: m.Record, device: str | None) -> Ref:
    """Refers to a bit of another parameter, by that parameter's type on a device."""
    name, _, bit = path.partition(".")
    flags = next(q for q in record.parameters if q.name == name)
    own = (v.type for v in flags.readings if v.by_device and v.key == device)
    e = next(own, None) or flags.element
    entry = next((b for b in e.bits if b.name == bit), None) if isinstance(e, m.Bitfield) else None
    return Ref(entry, path, e) if entry and isinstance(e, m.Bitfield) else Ref(flags, path, record)
