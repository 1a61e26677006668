"""The meaning of objects: names, units, validity, text. Descriptions are loaded on first use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

from .errors import EncodeError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .field import Field
    from .info import FieldInfo, StructureInfo


class _Info:
    """The attribute `INFO` of a class."""

    @overload
    def __get__(self, holder: object, kind: type[Field]) -> FieldInfo: ...
    @overload
    def __get__(self, holder: object, kind: type[Described]) -> StructureInfo: ...
    def __get__(self, holder: object, kind: type[Described]) -> Any:
        from .reflection import info

        try:
            return info(kind)
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
        return kind.INFO[name].text
    except (AttributeError, LookupError):  # the user's own class
        return ""


class Described:
    """A field or a structure, with its descriptions."""

    __slots__ = ()

    INFO = _Info()
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
        name, _, element = name.partition(".")
        p = self.INFO[name].of(self, device)
        if getattr(self, p.attribute) is None:
            return False
        flags = p.flags
        if element:
            if element not in p.elements:
                from .lookup import unknown

                raise unknown(element, f"an element of {p.name}", p.elements)
            flags = flags[p.elements.index(element) :][:1] if len(flags) > 1 else flags
        held = [(flag, getattr(self, flag.attribute)) for flag in flags]
        try:
            return all(value is not None and flag.holds(value) for flag, value in held)
        except TypeError:
            wrong = ", ".join({f"{f.attribute} is {value!r}": None for f, value in held})
            raise EncodeError("range", f"{wrong}, needs a whole number") from None

    def meaning(self, name: str, device: str | None = None) -> Any:
        """Returns the value `name` as a member of the enumeration or bitfield that defines it.

        The type may depend on another value of this field or on the device (its id, such as
        "3dm-gx5-15"). Without such a type, the value is returned unchanged. Raises EncodeError if
        the value does not fit into its parameter.
        """
        from .text import meant

        p = self.INFO[name].of(self, device)
        return meant(p, getattr(self, p.attribute))

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
        from .text import as_dict

        return as_dict(self, names, json, device)

    def to_text(self, device: str | None = None) -> str:
        """Returns one line with names, values and units, interpreted for a device; `str()` returns
        the line for an unknown device. If a value cannot be sent, this may be the same as `repr()`.
        """
        from .text import as_text

        return as_text(self, device)

    def __str__(self) -> str:
        return self.to_text()
