"""What all fields have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Generic, TypeAlias, TypeVar

from .described import Described
from .errors import DecodeError
from .packet import Packet, PacketBuilder, RawField

if TYPE_CHECKING:
    # Checkers know defaults of type variables in every version of Python.
    from typing_extensions import TypeVar as TypeVarWithDefault

    from .info import FieldInfo

F = TypeVar("F", bound="Field")
S = TypeVar("S", bound="Structure")


class Structure(Described):
    """A group of named values: a field, or a part of one."""

    __slots__ = ()

    @classmethod
    def _read(cls: type[S], raw: bytes, at: int) -> tuple[S, int]:
        """The values at an offset, and where they end."""
        raise NotImplementedError

    def _write(self) -> bytes:
        raise NotImplementedError


class Field(Structure):
    """One field: a command, a response or data."""

    __slots__ = ()

    if TYPE_CHECKING:
        INFO: ClassVar[FieldInfo]
        """What is known of it and of its parameters."""

    SET: ClassVar[int]
    DESCRIPTOR: ClassVar[int]
    NAME: ClassVar[str]  # in the specification: "base.ping"
    ROLE: ClassVar[str]  # "command", "response" or "data"

    def encode(self) -> bytes:
        """The data of the field, without its length and descriptor. Raises EncodeError."""
        return self._write()

    @classmethod
    def decode(cls: type[F], data: bytes) -> F:
        """The values of a field's data. Raises DecodeError; bytes left over are not an error."""
        return cls._read(data, 0)[0]

    @classmethod
    def decode_with_trailing(cls: type[F], data: bytes) -> tuple[F, int]:
        """The values, and how many bytes are left over (newer devices send more)."""
        value, end = cls._read(data, 0)
        return value, len(data) - end

    @classmethod
    def matches(cls, data: bytes) -> bool:
        """Can this be its data? Looks at what tells the layouts of one descriptor apart: constants and size."""
        return True

    def packet(self) -> Packet:
        """A packet with only this field."""
        return PacketBuilder(self.SET).add(self.DESCRIPTOR, self.encode()).build()

    @classmethod
    def find(cls: type[F], packet: Packet) -> F | None:
        """The first field of this type in a packet, if there is one."""
        shared = cls.SET == 0xFF and packet.set >= 0x80
        ack = cls.SET == 0 and packet.set < 0x80
        if packet.set == cls.SET or shared or ack:
            for raw in packet:
                if raw.descriptor == cls.DESCRIPTOR and cls.matches(raw.data):
                    return cls.decode(raw.data)
        return None


class Response(Field):
    """Follows the acknowledge of a command."""

    __slots__ = ()

    COMMANDS: ClassVar[tuple[type[Command], ...]] = ()


#: For where a field's own member is called `type`.
ResponseClasses: TypeAlias = "tuple[type[Response], ...]"
ClassOf: TypeAlias = "type[F]"


#: What a client gets for a command: its response, or None.
if TYPE_CHECKING:
    R = TypeVarWithDefault("R", bound="Response | None", covariant=True, default="Response | None")
else:
    R = TypeVar("R", bound="Response | None", covariant=True)


class Command(Field, Generic[R]):
    """Is acknowledged by the device, with a response or without.

    `Command[R]` is one that gets a response of type R, or None.
    """

    __slots__ = ()

    RESPONSES: ClassVar[tuple[type[Response], ...]] = ()
    TIMEOUT: ClassVar[float | None] = None  # seconds, if the device may take longer than usual
    #: Settings of the device with which it does not acknowledge the command: set and descriptor of
    #: the command that sets it, the parameter and its value.
    SILENCED_BY: ClassVar[tuple[tuple[int, int, str, int], ...]] = ()
    #: Function selector -> how many parameters it requires; others may be None.
    REQUIRED: ClassVar[dict[int, int]] = {}

    @property
    def answered(self) -> bool:
        """Does the device acknowledge it, with these values?"""
        return True

    @property
    def expected(self) -> ResponseClasses:
        """The response that it asks for, with these values: devices may have different layouts of it."""
        return self.RESPONSES


class Data(Field):
    """A measurement."""

    __slots__ = ()


def chosen(types: tuple[type[Field], ...], raw: RawField) -> type[Field] | None:
    """The layout of a field's data, if its descriptor has several."""
    if len(types) == 1:
        return types[0]
    return next((t for t in types if t.matches(raw.data)), None)


__all__ = [
    "ClassOf",
    "Command",
    "Data",
    "DecodeError",
    "Field",
    "R",
    "Response",
    "ResponseClasses",
    "Structure",
    "chosen",
]
