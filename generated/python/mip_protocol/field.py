"""The common part of all fields."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache, wraps
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeAlias, TypeVar, overload

from ._sets import SETS
from .codec import typed, vector
from .described import Described, Description, help_of
from .exceptions import EncodeError, Truncated
from .packet import Packet, PacketBuilder, RawField, as_bytes

if TYPE_CHECKING:
    import dataclasses

    # Type checkers know type variables with defaults for every Python version.
    from typing_extensions import TypeVar as TypeVarWithDefault

    from .info import FieldInfo, StructureInfo

    class _Info(Description):
        @overload
        def __get__(self, holder: object, kind: type[Field]) -> FieldInfo: ...
        @overload
        def __get__(self, holder: object, kind: type[Structure]) -> StructureInfo: ...
        def __get__(self, holder: object, kind: Any) -> Any: ...


F = TypeVar("F", bound="Field")
S = TypeVar("S", bound="Structure")
H = TypeVar("H", bound="Shared")


class _OfDataclass:
    """The attributes that `dataclasses` requires of a class, created on demand."""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, instance: object, owner: Any) -> Any:
        return getattr(_as_dataclass(owner), self._name)


@cache
def _as_dataclass(kind: Any) -> type:
    """Creates a data class with the same members."""
    import dataclasses
    import inspect

    def described(p: inspect.Parameter) -> Any:
        default = {} if p.default is p.empty else {"default": p.default}
        return dataclasses.field(kw_only=p.kind is p.KEYWORD_ONLY, **default)

    parameters = inspect.signature(kind).parameters if kind._MEMBERS else {}
    members = [
        (name, str(p.annotation), described(p))
        for name, p in ((name, parameters[name]) for name in kind._MEMBERS)
    ]
    return dataclasses.make_dataclass(kind.__name__, members)


# A vector attribute. Decoders store the numbers; the vector is created when it is first read.
class VectorMember:
    __slots__ = ("_get", "_kinds", "_set", "_slot")

    def __init__(self, slot: Any, kinds: tuple[type[Any], ...]) -> None:
        self._slot = slot
        self._get = slot.__get__
        self._set = slot.__set__
        self._kinds = kinds

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        if instance is None:
            return self
        value = self._get(instance)
        if type(value) not in self._kinds:
            made = vector(value, *self._kinds)
            if made is not value:
                self._set(instance, made)
            return made
        return value

    def __set__(self, instance: object, value: Any) -> None:
        self._set(instance, value)

    def __delete__(self, instance: object) -> None:
        raise AttributeError("a value cannot be deleted")

    @property
    def __doc__(self) -> str:  # type: ignore[override]
        """The text that `help()` shows."""
        return help_of(self._slot.__objclass__, self._slot.__name__)


def _checked(init: Callable[..., None]) -> Callable[..., None]:
    """Makes a constructor that raises EncodeError for values that cannot be sent."""

    @wraps(init)
    def checked(self: Any, *arguments: Any, **named: Any) -> None:
        init(self, *arguments, **named)
        try:
            self._write()
        except EncodeError as error:
            raise typed(self, error) from None

    return checked


class Structure(Described):
    """A group of named values: a field or part of a field.

    It also works as a data class, with `dataclasses.replace`, `fields` and `asdict`.
    """

    __slots__ = ()

    #: The names of its values, in wire order.
    _MEMBERS: ClassVar[tuple[str, ...]] = ()

    #: Members that are vectors, and their kinds.
    _VECTORS: ClassVar[dict[str, tuple[type[Any], ...]]] = {}

    #: Its size in bytes if it consists of plain numbers at fixed offsets, else 0.
    _SIZE: ClassVar[int] = 0

    if TYPE_CHECKING:
        INFO: _Info
        __dataclass_fields__: ClassVar[dict[str, dataclasses.Field[Any]]]
    else:
        __dataclass_fields__ = _OfDataclass()
        __dataclass_params__ = _OfDataclass()

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        added = cls.__dict__.get("__slots__", ())
        cls._MEMBERS += tuple([name for name in added if not name.startswith("_")])
        for name, kinds in cls.__dict__.get("_VECTORS", {}).items():
            slot = cls.__dict__[name]
            setattr(cls, f"_{name}", slot)  # for decoders
            setattr(cls, name, VectorMember(slot, kinds))
        if "__init__" in cls.__dict__:
            cls.__init__ = _checked(cls.__init__)  # type: ignore[method-assign]

    def _values(self) -> tuple[Any, ...]:
        return tuple([getattr(self, name) for name in self._MEMBERS])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Structure) or other.__class__ is not self.__class__:
            return NotImplemented
        return self._values() == other._values()

    def __repr__(self) -> str:
        values = ", ".join([f"{name}={getattr(self, name)!r}" for name in self._MEMBERS])
        return f"{type(self).__qualname__}({values})"

    def __replace__(self: S, **changes: Any) -> S:
        return type(self)(**(dict(zip(self._MEMBERS, self._values())) | changes))

    def _read(self, raw: bytes, at: int) -> int:
        """Reads the values at an offset, and returns the offset at which they end. There are at
        least `_SIZE` bytes; if there are too few, it raises Truncated."""
        return at

    def _write(self) -> bytes:
        """Encodes the values. Raises EncodeError."""
        return b""

    @classmethod
    def _decoded(cls: type[S], raw: bytes, at: int) -> tuple[S, int]:
        """Reads an object at an offset. Returns it, and the offset at which it ends."""
        if cls._SIZE > len(raw) - at:
            raise Truncated(cls._SIZE, len(raw) - at)
        value = cls.__new__(cls)
        return value, value._read(raw, at)


class Field(Structure):
    """One field: a command, a response or data."""

    __slots__ = ()

    SET: ClassVar[int]  # its descriptor set; one that occurs in several listed sets has none
    SETS: ClassVar[Sequence[int]]  # the descriptor sets in which it occurs
    DESCRIPTOR: ClassVar[int]
    NAME: ClassVar[str]  # in the specification: "base.ping"
    ROLE: ClassVar[str]  # "command", "response" or "data"

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        if "SET" in cls.__dict__ and "SETS" not in cls.__dict__:
            cls.SETS = (cls.SET,)

    @property
    def packet_set(self) -> int | None:
        """The descriptor set of the packet that contained it; None if that is unknown."""
        return self.SET

    @classmethod
    def name_in(cls, set: int) -> str:
        """Returns its full name in a descriptor set: "gnss_2.dop". A field that occurs in every set
        has only one name."""
        listed = set in cls.SETS and not isinstance(cls.SETS, range)
        names = SETS.get(set) if listed else None
        return f"{names[0]}.{cls.NAME.partition('.')[2]}" if names else cls.NAME

    def encode(self) -> bytes:
        """Encodes the field's data, without length and descriptor. Raises EncodeError."""
        try:
            return self._write()
        except EncodeError as error:
            raise typed(self, error) from None

    @classmethod
    def decode(cls: type[F], data: bytes | bytearray | memoryview) -> F:
        """Decodes a field's data. Raises DecodeError; bytes left over are not an error."""
        return cls._decoded(data if type(data) is bytes else as_bytes(data), 0)[0]

    @classmethod
    def decode_with_trailing(cls: type[F], data: bytes | bytearray | memoryview) -> tuple[F, int]:
        """Like `decode`, but also returns how many bytes are left, which newer devices may send."""
        raw = data if type(data) is bytes else as_bytes(data)
        value, end = cls._decoded(raw, 0)
        return value, len(raw) - end

    @classmethod
    def matches(cls, data: bytes) -> bool:
        """Can this be the field's data? Checks constants and size, which distinguish layouts."""
        return True

    def _called(self, name: str) -> str:
        return name if self.packet_set is None else self.name_in(self.packet_set)

    def packet(self, set: int | None = None) -> Packet:
        """Makes a packet of this field, in its set or in `set`. Raises EncodeError."""
        number = self.packet_set if set is None else set
        if number is None:
            raise EncodeError(
                "set", f"{self.NAME} belongs to packets of several sets; select one: packet(set)"
            )
        if number not in self.SETS:
            raise EncodeError(
                "set", f"{self.NAME} does not occur in packets of the set 0x{number:02X}"
            )
        return PacketBuilder(number).add(self.DESCRIPTOR, self.encode()).build()

    @classmethod
    def find(cls: type[F], packet: Packet) -> F | None:
        """Returns the first field of this type in a packet, or None.

        Raises DecodeError if it cannot be decoded, or if the packet ends within a field before it
        is found.
        """
        return next(cls.find_all(packet), None)

    @classmethod
    def find_all(cls: type[F], packet: Packet) -> Iterator[F]:
        """Yields the fields of this type in a packet, in order. Raises DecodeError at one that
        cannot be decoded, or within which the packet ends."""
        if packet.set in cls.SETS:
            for raw in packet:
                if raw.descriptor == cls.DESCRIPTOR and cls.matches(raw.data):
                    yield cls._received(raw)

    @classmethod
    def _received(cls: type[F], raw: RawField) -> F:
        """Decodes a field of a packet."""
        return cls._decoded(raw.data, 0)[0]


class Shared(Field):
    """A field that occurs in packets of several sets, and remembers which one contained it."""

    __slots__ = ("_packet_set",)

    _packet_set: int

    @property
    def packet_set(self) -> int | None:
        """The descriptor set of the packet that contained it, or None. Comparisons ignore it."""
        return getattr(self, "_packet_set", None)

    @classmethod
    def _received(cls: type[H], raw: RawField) -> H:
        field = cls._decoded(raw.data, 0)[0]
        field._packet_set = raw.set
        return field

    def __replace__(self: H, **changes: Any) -> H:
        field = super().__replace__(**changes)
        if self.packet_set is not None:
            field._packet_set = self.packet_set
        return field


class Response(Field):
    """A field with which the device answers a command, after the acknowledge."""

    __slots__ = ()

    ROLE = "response"

    COMMANDS: ClassVar[tuple[type[Command], ...]] = ()


#: The built-in `type`, for use where a field has a member of that name.
ResponseClasses: TypeAlias = "tuple[type[Response], ...]"
ClassOf: TypeAlias = "type[F]"


#: The result of a command: its response, or None.
if TYPE_CHECKING:
    R = TypeVarWithDefault("R", bound="Response | None", covariant=True, default="Response | None")
else:
    R = TypeVar("R", bound="Response | None", covariant=True)


class Command(Field, Generic[R]):
    """A field that the device acknowledges, with or without a response.

    A `Command[R]` has a response of type R; R is None if it has none.
    """

    __slots__ = ()

    ROLE = "command"

    RESPONSES: ClassVar[tuple[type[Response], ...]] = ()
    TIMEOUT: ClassVar[float | None] = None  # seconds, if the device may take longer than usual
    #: Device settings that suppress the acknowledge of this command: set and descriptor of the
    #: command that makes the setting, the parameter and its value.
    SILENCED_BY: ClassVar[tuple[tuple[int, int, str, int], ...]] = ()
    #: Function selector -> the number of parameters that it requires; the others may be None.
    REQUIRED: ClassVar[dict[int, int]] = {}

    @property
    def answered(self) -> bool:
        """Does the device acknowledge the command with these values?"""
        return True

    @property
    def expected(self) -> ResponseClasses:
        """The types of the response that it requests with these values; devices may differ."""
        return self.RESPONSES


class Data(Field):
    """A field that a device sends as data."""

    __slots__ = ()

    ROLE = "data"


def change(response: Response, /, **values: Any) -> Command:
    """Makes the command that writes the setting in a response, with some values changed:
    `device.request(change(response, baud=460800))`.

    Raises TypeError if it has no such value, if the response lacks one that is not in `values`,
    or if it is not that of one command that can write; and EncodeError for wrong values.
    """
    from inspect import signature  # only here: a program that does not call this need not load it

    writes: list[Any] = [x for kind in response.COMMANDS if (x := getattr(kind, "write", None))]
    if len(writes) != 1:
        raise TypeError(f"{response.NAME} is not the setting of one command that can be written")
    names = [name for name in signature(writes[0]).parameters if name in response._MEMBERS]
    made: Command = writes[0](**({name: getattr(response, name) for name in names} | values))
    return made


def chosen(types: tuple[type[Field], ...], raw: RawField) -> type[Field] | None:
    """Chooses the type whose layout fits a field's data, if the descriptor has several."""
    if len(types) == 1:
        return types[0]
    return next((t for t in types if t.matches(raw.data)), None)
