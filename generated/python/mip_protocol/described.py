"""The meaning of objects: names, units, validity, text.

Most programs never ask for it. The descriptions of a module's classes are generated, name all of
them, and are loaded by the module's name when one is first used.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from importlib import import_module
from typing import Any

from ._sets import MODULES


@cache
def description(kind: Any) -> Any:
    """Returns the description of a field, structure, enumeration or bitfield of the specification.

    A class that is made at run time describes itself. Raises LookupError for any other class.
    """
    own = vars(kind).get("INFO")
    if own is not None and not isinstance(own, (Description, kind)):
        return own
    for base in kind.__mro__:
        package, _, module = base.__module__.rpartition(".")
        if package == __package__ and module in (*MODULES.values(), "protocol", "types"):
            table = import_module(f"._meaning.{module}", __package__).TYPES
            if base.__name__ in table:
                return table[base.__name__]
    raise LookupError(f"{kind.__module__}.{kind.__qualname__} is not a type of the specification")


class Description:
    """The attribute `INFO` of a class."""

    def __get__(self, holder: object, kind: Any) -> Any:
        try:
            return description(kind)
        except LookupError as error:  # `Field` and other base classes, and the user's own
            raise AttributeError(str(error)) from None


class _Help(dict[str, str]):
    """The slots of a class; `help()` shows the text of each."""

    def __init__(self, kind: type[Described], slots: Iterable[str]) -> None:
        super().__init__(dict.fromkeys(slots, ""))
        self._kind = kind

    def __getitem__(self, name: str) -> str:
        return help_of(self._kind, name)


def help_of(kind: type[Described], name: str) -> str:
    """Returns the text about a parameter."""
    try:
        return str(kind.INFO[name].text)
    except (AttributeError, LookupError):  # the user's own class
        return ""


class Described:
    """A field or a structure, with its descriptions."""

    __slots__ = ()

    INFO = Description()
    """Facts about it and its parameters."""

    def _called(self, name: str) -> str:
        """Returns its name for texts; a field's name depends on the set that contained it."""
        return name

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        slots = cls.__dict__.get("__slots__")
        if slots:
            names = (slots,) if isinstance(slots, str) else slots
            cls.__slots__ = _Help(cls, names)  # type: ignore[assignment]

    def is_valid(self, name: str, device: str | None = None) -> bool:
        """Is a value valid according to its flags? A value without flags is valid.

        `name` may name an element: "velocity.x". A vector is valid if all of its elements are. An
        absent value is not valid. `device` is the device's id, on which the flags may depend.
        Raises EncodeError if the flags are not a number.
        """
        return bool(self.INFO.is_valid(self, name, device))

    def meaning(self, name: str, device: str | None = None) -> Any:
        """Returns the value `name` as a member of the enumeration or bitfield that defines it.

        The type may depend on another value of this field or on the device (its id, such as
        "3dm-gx5-15"). Without such a type, the value is returned unchanged. Raises EncodeError if
        the value does not fit into its parameter.
        """
        return self.INFO.meaning(self, name, device)

    def to_dict(
        self, names: bool = True, json: bool = False, device: str | None = None
    ) -> dict[str, Any]:
        """Returns the values by their names in the specification, in wire order, without counters
        and constants.

        Structures and vectors become dicts, arrays become lists, and absent values None. An
        enumeration value becomes its name, or stays a number if it has none. A bitfield becomes a
        list of what is set: names, "name=number" for numbers of several bits, and unnamed bits as a
        hexadecimal number. With `names=False`, all of these are numbers, and vectors are lists.
        With `json`, NaN and infinities become None, because JSON cannot represent them. `device` is
        the device's id, on which some names depend. Raises EncodeError if a value of an enumeration
        or a bitfield is not a number.
        """
        values: dict[str, Any] = self.INFO.to_dict(self, names, json, device)
        return values

    def to_text(self, device: str | None = None) -> str:
        """Returns one line with names, values and units, interpreted for a device; `str()` returns
        the line for an unknown device. If a value cannot be sent, this may be the same as `repr()`.
        """
        try:
            info = self.INFO
        except AttributeError:
            return repr(self)  # the user's own class
        return str(info.to_text(self, device))

    def __str__(self) -> str:
        return self.to_text()
