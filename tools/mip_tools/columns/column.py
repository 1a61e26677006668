"""The rows of one field of a log."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from ..binding import Field, Flag, Parameter, Structure, info
from .general import Ragged, Values
from .piece import Where
from .scan import Array
from .sender import Sender
from .stamps import Times

F = TypeVar("F", bound=Field)


class Owner(Protocol):
    """What a column uses of its log."""

    sender: Sender

    def reads(self, kind: type[Field]) -> str | None: ...
    def times(self, column: Column[Any], clock: str | None = None) -> Times: ...
    def objects(self, kind: type[F], set_number: int | None = None) -> Iterator[F]: ...


class Column(Generic[F]):
    """All fields of one type and set in a log, in the order of the log: an array for each parameter.

    `column["scaled_accel"]` has the shape (rows, 3), a number (rows,), an array of fixed length
    (rows, length). Enumerations, bitfields and bools are the integers on the wire; their types are
    in `parameters`. Text is an array of `str`, an array of varying length a `Ragged`. A parameter of
    a structure has a name such as `place.x`, in a member of a union `shape.circle.radius`. Values that
    are absent in a row are masked (`numpy.ma`).
    """

    def __init__(self, log: Owner, kind: type[F], values: dict[str, Values], where: Where, only: int | None) -> None:
        self._log = log
        self._values = values
        #: The source of the rows, for `times`.
        self.where = where
        #: The descriptor set of all rows, if it was named or there is only one.
        self.only = only
        #: The class of the field.
        self.type = kind

    def __len__(self) -> int:
        return len(self.where)

    @cached_property
    def packet(self) -> Array:
        """The number of the packet of each row in this log, from 0: shape (rows,), int64."""
        return self.where.packet()

    @cached_property
    def offset(self) -> Array:
        """The offset of that packet, in bytes from the beginning of the file: (rows,), int64."""
        return self.where.offset()

    @cached_property
    def set(self) -> Array:
        """The descriptor set of that packet: (rows,), uint8. It varies for shared fields."""
        return self.where.set()

    @property
    def sets(self) -> list[int]:
        """The descriptor sets of the packets, each once."""
        return self.where.sets()

    @property
    def name(self) -> str:
        """The full name of the field, in its set: "gnss_2.dop"."""
        return self.type.NAME if self.only is None else self.type.name_in(self.only)

    def __repr__(self) -> str:
        return f"<Column {self.name}: {len(self)} rows of {', '.join(self.names)}>"

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the columns."""
        return tuple(self._values)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __getitem__(self, name: str) -> Array | Any:
        """Returns the values of a parameter: an array, or a `Ragged` if their number varies.

        Raises KeyError if there is no such parameter.
        """
        try:
            return self._values[name]
        except KeyError:
            raise KeyError(f"{self.name} has {', '.join(self.names)}, not {name!r}") from None

    @cached_property
    def parameters(self) -> Mapping[str, Parameter]:
        """The description of each column: type, unit, frame, range, flags."""
        self._log.reads(self.type)  # so that all of the log is known
        recognized = self._log.sender.recognized
        return {name: recognized(self.type, p) for name, p in described_columns(info(self.type).parameters, "")}

    @cached_property
    def titles(self) -> Mapping[str, str]:
        """The name of each column in the specification, which tables use; the name in Python may differ."""
        parameters = info(self.type).parameters
        return dict(zip((name for name, _ in described_columns(parameters, "")), _titles(parameters, "")))

    def time(self, clock: str | None = None) -> Times:
        """Returns the time of each row: the timestamp in its packet, or the last one before it."""
        return self._log.times(self, clock)

    def valid(self, name: str) -> Array:
        """Returns whether each value is valid according to its flags. The shape is (rows,), or (rows, elements) if
        each element has its own flag.

        A value without a flag is valid, an absent one is not.
        """
        values = self[name]
        flags = [self._holds(name, flag) for flag in self.parameters[name].flags]
        if isinstance(values, Ragged):
            there = np.ones(len(values), bool) if values.mask is None else ~values.mask
        else:
            there = np.logical_not(absent(values))
        if len(flags) > 1:
            return np.asarray(np.stack(flags, axis=1) & there[:, None])
        if flags:
            there &= flags[0]
        return np.asarray(there)

    def _holds(self, name: str, flag: Flag) -> Array:
        """Finds the rows in which the valid flag of a column is set."""
        record = name.rpartition(".")[0]
        flags = self._values[f"{record}.{flag.attribute}" if record else flag.attribute]
        if isinstance(flags, Ragged):  # flags of structures in an array
            return np.ones(len(self), bool)
        return np.asarray(flag.holds(np.asarray(flags)))

    def objects(self) -> Iterator[F]:
        """Yields the rows as objects."""
        return self._log.objects(self.type, self.only)


def absent(values: Array) -> Array:
    """Finds the rows that have no value."""
    mask: Any = getattr(values, "mask", False)
    whole = np.broadcast_to(mask, values.shape)
    if not whole.size:
        return np.zeros(len(values), bool)
    return np.array(whole.reshape(len(values), -1)[:, 0])


def described_columns(parameters: tuple[Parameter, ...], prefix: str) -> Iterator[tuple[str, Parameter]]:
    """Yields the columns of some parameters, with their descriptions."""
    for p in parameters:
        if p.kind == "counter" or p.constant is not None:
            continue
        name = prefix + p.attribute
        cases = [c for c in p.cases.values() if c is not None]
        if p.kind == "switch":
            yield from described_columns(tuple(cases), name + ".")
        elif p.type is not None and issubclass(p.type, Structure):
            yield from described_columns(info(p.type).parameters, name + ".")
        else:
            yield name, p


def _titles(parameters: tuple[Parameter, ...], prefix: str) -> Iterator[str]:
    """Yields the names of the same columns in the specification."""
    for p in parameters:
        if p.kind == "counter" or p.constant is not None:
            continue
        if p.kind == "switch":
            yield from _titles(tuple(c for c in p.cases.values() if c is not None), f"{prefix}{p.name}.")
        elif p.type is not None and issubclass(p.type, Structure):
            yield from _titles(info(p.type).parameters, f"{prefix}{p.name}.")
        else:
            yield prefix + p.name
