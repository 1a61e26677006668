"""Commands to try on a device: each with every function, with valid values and some invalid ones."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from mipgen import model as m
from mipgen.lower import codec
from support import model, rounds, sent

Values = dict[str, Any]

#: How many values of one parameter are tried beside the first.
MOST = rounds(3, 12)

#: Plain numbers of which a device defines a few, by the name of the parameter.
KNOWN: dict[str, Callable[[m.Device], Iterable[int]]] = {
    "descriptor_set": lambda device: data_fields(device),
    "port": lambda device: (p.id for p in device.ports if p.id is not None),
    "baud": lambda device: (rate for p in device.ports for rate in p.baud_rates),
    "model_number": lambda device: (device.model_number or 0,),
    "target_descriptor": lambda device: filtered(device),
    "field_descriptor": lambda device: filtered(device),
}


def filtered(device: m.Device) -> Iterable[int]:
    """The sensor data that low-pass filters affect."""
    command = model("real").field("3dm.imu_low_pass_filter")
    affected = model("real").affected(command) if command else ()
    has = {s.field.full_name for s in device.supports}
    return [f.descriptor for f in affected if isinstance(f, m.Field) and f.full_name in has]


@dataclass(frozen=True)
class Trial:
    """A command with values. `good`: the specification permits them."""

    command: m.Field
    values: Values
    good: bool

    @property
    def function(self) -> m.Function | None:
        return next((f for f in self.command.functions if f.value == self.values.get("function")), None)

    @property
    def entry(self) -> Values:
        return {"descriptor": self.command.descriptor, "name": self.command.full_name, "values": self.values}


def commands(device: m.Device) -> list[m.Support]:
    """What a host can send to the device, whose firmware is newer than all that profiles name."""
    supported = [s for s in device.supports if not (s.firmware or "").startswith("<")]
    return [s for s in supported if s.field.role == m.COMMAND and s.field.sent_by == "host"]


def data_fields(device: m.Device) -> dict[int, list[int]]:
    """The descriptors of each data set that it sends, shared ones in the first."""
    found: dict[int, list[int]] = {}
    for s in device.supports:
        if s.field.role == m.DATA and not s.field.everywhere:
            found.setdefault(s.set, []).append(s.field.descriptor)
    shared = [s.field.descriptor for s in device.supports if s.field.everywhere]
    for descriptors in list(found.values())[:1]:
        descriptors[:0] = shared
    return found


def trials(support: m.Support, device: m.Device) -> Iterator[Trial]:
    """Every function with plain values, then each parameter with each of its values while the others are plain."""
    command = support.field
    for call in command.calls:
        if call.function is not None and call.function not in support.functions:
            continue
        base: Values = {} if call.function is None else {"function": call.function.value}
        plain = base | settled(call.required, base, device)
        yield Trial(command, plain, True)
        for p in (*call.required, *call.optional):
            if p.derived or p.reserved is not None:
                continue
            upto = (*call.required, *call.optional) if p in call.optional else call.required
            good, bad = choices(p, plain, device)
            for right, values in ((True, good[1:]), (False, bad)):
                for value in values[:MOST]:
                    yield Trial(command, base | settled(upto, {**base, p.name: value}, device), right)


def unsupported(support: m.Support) -> Iterator[Trial]:
    """Functions that the device does not support, including an unknown one."""
    command = support.field
    if command.functions:
        known = {f.value for f in support.functions}
        for function in [f.value for f in command.functions if f.value not in known] + [99]:
            plain = settled(command.calls[0].required, {}, None)
            yield Trial(command, {"function": function} | plain, False)


def settled(parameters: tuple[m.Parameter, ...], given: Values, device: m.Device | None) -> Values:
    """The plain value of each parameter, except for those that are given."""
    values: Values = {}
    for p in parameters:
        if p.constant is not None or p.counts:
            values.update({p.name: None} if p.counts else {})  # keeps its place; its array determines it
        else:
            values[p.name] = given[p.name] if p.name in given else choices(p, values | given, device)[0][0]
    for p in parameters:
        if p.counts:
            values[p.name] = len(values[p.counts])
    return values


# --------------------------------------------------------------------------- the values of one parameter


def choices(p: m.Parameter, values: Values, device: m.Device | None) -> tuple[list[Any], list[Any]]:
    """Values that a parameter may have, the plainest first, and some that it may not."""
    if p.reserved is not None:
        return [sent(p)], []
    if p.tag is not None:
        return union(p, values, device)
    good, bad = items(p, device)
    if p.kind == "text":
        good, bad = ["A" * (p.count or 1), "\0" * (p.count or 0)], []
    elif isinstance(p.length, int):
        good, bad = [[g] * p.length for g in good], [[b] * p.length for b in bad]
    elif p.length is not None:
        good = [[], [good[0]], good[:2], good[-3:], [good[0]] * 2]
        bad = [[b] for b in bad]
    if p.default is not None:
        first = codec.canonical(p, p.default, p.name)
        good = [first, *(g for g in good if g != first)]
    return good, bad


def union(p: m.Parameter, values: Values, device: m.Device | None) -> tuple[list[Any], list[Any]]:
    case = next((c for c in p.cases if c.tag.value == values[p.tag or ""]), None)
    if case is None or case.parameter is None:
        return [{}], []
    good, bad = choices(case.parameter, values, device)
    name = case.parameter.name
    return [{name: g} for g in good], [{name: b} for b in bad]


def items(p: m.Parameter, device: m.Device | None) -> tuple[list[Any], list[Any]]:
    """One element."""
    kind = p.element
    own = next((v for v in p.variants if v.by_device and device and v.key == device.id and not v.member), None)
    if own is not None and own.type is not None:
        kind = own.type
    match kind:
        case m.Enum():
            return enumerated(kind, own)
        case m.Bitfield():
            return flags(kind)
        case m.Struct():
            plain = settled(kind.parameters, {}, device)
            good, bad = [plain], []
            for q in kind.parameters:
                if not q.derived and q.reserved is None:
                    right, wrong = choices(q, plain, device)
                    good += [settled(kind.parameters, {q.name: v}, device) for v in right[1:]]
                    bad += [settled(kind.parameters, {q.name: v}, device) for v in wrong]
            return good, bad
        case m.Vector():
            return vectors(p, kind)
        case m.Scalar() if device and p.name in KNOWN and (own_numbers := list(KNOWN[p.name](device))):
            return list(dict.fromkeys(own_numbers)), []
        case m.Scalar():
            right, wrong = numbers(p, kind)
            return [put(kind, n) for n in right], [put(kind, n) for n in wrong]
    raise AssertionError(p)


def enumerated(kind: m.Enum, own: m.Variant | None) -> tuple[list[Any], list[Any]]:
    named = [v.value for v in (own.only if own and own.only else kind.values) if isinstance(v, m.EnumValue)]
    every = {v.value for v in kind.values}
    return named, [n for n in range(256 ** min(kind.scalar.size, 2) - 1, 0, -1) if n not in every][:1]


def flags(kind: m.Bitfield) -> tuple[list[Any], list[Any]]:
    numbers = [0, *(b.mask & -b.mask for b in kind.bits), kind.known_mask]
    return [n if kind.scalar else list(n.to_bytes(kind.size, "little")) for n in numbers], []


def vectors(p: m.Parameter, kind: m.Vector) -> tuple[list[Any], list[Any]]:
    """The same number in each element, or a unit vector where the length matters; a matrix is that of no rotation."""
    size = len(kind.elements)
    if size == 9 and p.above is None:
        return [[put(kind.scalar, float(i % 4 == 0)) for i in range(size)]], []
    least, _ = p.magnitude
    if size == 4 or least:
        unit = [put(kind.scalar, n) for n in (1.0, *[0.0] * (size - 1))]
        return [unit, unit[1:] + unit[:1]], [[put(kind.scalar, 0.0)] * size] if least else []
    right, wrong = numbers(p, kind.scalar)
    return [[put(kind.scalar, n)] * size for n in right], [[put(kind.scalar, n)] * size for n in wrong]


def numbers(p: m.Parameter, scalar: m.Scalar) -> tuple[list[float | int], list[float | int]]:
    """Numbers within the range of a parameter, and some outside of it."""
    if scalar.kind == "bool":
        return [0, 1], []
    step: float | int = 0.25 if scalar.kind == "float" else 1
    wide = 2 ** (8 * scalar.size - (scalar.kind == "signed"))
    low = p.minimum if p.minimum is not None else None if p.above is None else p.above + step
    high = p.maximum if p.maximum is not None else None if p.below is None else p.below - step
    good: list[float | int] = [n for n in (1, 0, 2) if (low is None or n >= low) and (high is None or n <= high)]
    good += [n for n in (low, high) if n is not None and n not in good]
    bad: list[float | int] = [p.above] if p.above is not None else []
    bad += [p.minimum - 1] if p.minimum is not None else []
    bad += [p.below] if p.below is not None else []
    bad += [p.maximum + 1] if p.maximum is not None else []
    if scalar.kind == "float":
        return good, bad
    least = -wide if scalar.kind == "signed" else 0
    return good, [n for n in bad if least <= n < wide]


def put(scalar: m.Scalar, number: float | int) -> Any:
    """A number in the form of the conformance protocol."""
    if scalar.kind == "float":
        return "0x" + struct.pack(">f" if scalar.size == 4 else ">d", number).hex()
    return int(number)
