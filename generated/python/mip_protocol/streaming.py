"""The commands that start a device's data at rates in Hz, for `Device.stream`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from ._clocks import CLOCKS
from .conversation import Dialog, Step
from .errors import NoSuchRate, Refused
from .exceptions import EncodeError, MipError
from .field import Command, Field

#: Creates a message format's item from a descriptor and a decimation.
Item = Callable[[int, int], Any]

LARGEST = 0xFFFF  # decimation


class Older(NamedTuple):
    """The commands of older devices for one descriptor set."""

    base_rate: Callable[[], Command[Any]]
    rate: Callable[[Any], int]
    format: Callable[[Sequence[Any]], Command[Any]]
    stream: int  # the stream's number, used instead of the set's


class Session(NamedTuple):
    """The commands that start data, as the specification names them."""

    base_rate: Callable[[int], Command[Any]]
    rate: Callable[[Any], int]  # base rate in the response, in Hz
    format: Callable[[int, Sequence[Any]], Command[Any]]
    item: Item
    stream: Callable[[int, bool], Command[Any]]
    resume: Callable[[], Command[Any]]
    identify: Callable[[], Command[Any]]
    descriptors: Sequence[Callable[[], Command[Any]]]  # list what the device has
    older: Mapping[int, Older] = {}
    #: Descriptor set (0 for all) and descriptor of the timestamps to try, in this order.
    timestamps: Sequence[tuple[int, int]] = ()


def steps(
    session: Session | None,
    rates: Mapping[type[Field], float],
    set: int | None,
    timestamp: str | None,
    identified: bool = False,
    clear: Callable[[int], object] = lambda _: None,
) -> Dialog[dict[type[Field], float]]:
    """Yields the commands that start data at these rates, with the first timestamp that the device
    accepts; returns the rates of the device. First asks which model it is, unless it is known.

    `clear` discards the packets of a set that have arrived before its format was replaced.
    """
    if session is None:
        raise NotImplementedError("this package's specification has no commands for streaming")
    number = set_of(rates, set)
    if not identified:
        try:
            yield Step(session.identify())  # the conversation learns from the answer
        except MipError:  # flags are then read as those of no known device
            pass
    older = None
    try:
        base = session.rate((yield Step(session.base_rate(number))))
    except Refused as refused:
        older = session.older.get(number)
        if older is None:
            raise
        try:
            base = older.rate((yield Step(older.base_rate())))
        except Refused:  # the device does not have this set
            raise refused from None
    decimations = {kind: decimation(base, rate) for kind, rate in rates.items()}
    nearest = {kind: base / by for kind, by in decimations.items()}
    # 333.33 Hz is accepted for 1000 Hz / 3.
    missing = {k: r for k, r in rates.items() if r and abs(r - nearest[k]) > 1e-4 * r}
    if missing and base:
        raise NoSuchRate(base, missing, nearest)
    fastest = min(decimations.values(), default=1)
    stamps: list[type[Field] | None] = [*_timestamps(session, number, rates, timestamp)]
    if timestamp == "auto" or not stamps:  # a clock that the program names is not left out
        stamps.append(None)
    for stamp in stamps:
        wanted = {**decimations, **({stamp: fastest} if stamp else {})}
        # Fields that all sets share come first, because each packet of a long message repeats them.
        # The timestamp is that of what follows it.
        kinds = sorted(decimations, key=lambda kind: not isinstance(kind.SETS, range))
        kinds = [stamp, *kinds] if stamp else kinds
        items = [session.item(kind.DESCRIPTOR, wanted[kind]) for kind in kinds]
        try:
            yield Step(session.format(number, items) if older is None else older.format(items))
            nearest = {kind: base / by for kind, by in wanted.items()}
            break
        except Refused:
            if stamp is stamps[-1]:
                raise
    clear(number)
    yield Step(session.stream(number if older is None else older.stream, True))
    yield Step(session.resume())
    return nearest


def _timestamps(
    session: Session, number: int, rates: Mapping[type[Field], float], timestamp: str | None
) -> Sequence[type[Field]]:
    """Returns the timestamps to try for a set, none if one is wanted anyway."""
    from .registry import types
    from .timestamps import clocks_of  # which most programs do not need

    if timestamp not in (None, "auto", *CLOCKS):
        raise ValueError(f"{timestamp!r} is not a clock; use one of {', '.join(CLOCKS)}")
    if not rates or timestamp is None:  # without rates, the message format is cleared
        return ()
    known = [d for occurs, d in session.timestamps if occurs in (0, number)]
    wanted = [d for d in known if timestamp == "auto" or timestamp in clocks_of(number, d)]
    found = [types(number, d)[0] for d in wanted]
    if not found and timestamp != "auto":
        raise ValueError(f"the set 0x{number:02X} has no timestamp of the clock {timestamp!r}")
    return () if any(kind in rates for kind in found) else found


def set_of(rates: Mapping[type[Field], float], set: int | None) -> int:
    """Returns the descriptor set that all of these fields occur in."""
    if wrong := next((rate for rate in rates.values() if not rate >= 0), None):
        raise ValueError(f"a rate must be 0 (the highest rate) or more, not {wrong}")
    if (name := next((kind for kind in rates if not isinstance(kind, type)), None)) is not None:
        raise TypeError(f"{name!r} is not a type of field, as sensor.ScaledAccel is")
    listed = [kind.SETS for kind in rates if not isinstance(kind.SETS, range)]
    common = [s for s in (listed[0] if listed else ()) if all(s in sets for sets in listed)]
    if set is None:
        if len(common) != 1:
            names = ", ".join(kind.NAME for kind in rates)
            if listed and not common:
                raise ValueError(f"{names} are in no common set; call stream once for each set")
            sets = ", ".join(f"0x{s:02X}" for s in common) or "that of the packets"
            raise ValueError(f"`set` is needed for {names or 'no fields'}: {sets}")
        return int(common[0])
    for kind in rates:
        if set not in kind.SETS:
            raise EncodeError("set", f"{kind.NAME} does not occur in the set 0x{set:02X}")
    return set


def decimation(base: int, wanted: float) -> int:
    """Returns the decimation for the nearest rate; 1 for the highest rate."""
    if not base or not wanted or wanted >= base:
        return 1
    below = min(int(base / wanted), LARGEST)
    above = min(below + 1, LARGEST)
    return below if base / below - wanted <= wanted - base / above else above
