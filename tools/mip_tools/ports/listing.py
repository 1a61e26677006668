"""Reads the identity, the descriptors, the base rates and the ports of a device."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from ..binding import MipError, PortClosed, Refused, UnknownName, identify, info, lookup, registry
from ..errors import Failure

if TYPE_CHECKING:
    from ..binding import Device, DeviceAtPort

REFUSED, SILENT = 3, 4

#: Commands that report the base rate of one data set.
RATES = {
    "3dm.get_imu_base_rate": "sensor",
    "3dm.get_gnss_base_rate": "gnss_data",
    "3dm.get_filter_base_rate": "filter_data",
}
#: The command that reports the base rate of any data set, and the commands that report the settings of a port.
RATE, SPEED, PROTOCOLS = "3dm.get_base_rate", "base.comm_speed", "system.interface_control"
EXTENDED = "base.get_extended_descriptors"

#: The port number that means all ports.
_ALL = "all"
_WORDS = {"uart": "UART", "usb": "USB"}

Key = tuple[int, int]  # descriptor set and descriptor


@dataclass(frozen=True)
class ListedPort:
    """A port with its current settings. Settings that the device did not report are None."""

    id: int
    name: str
    baud: int | None
    receives: tuple[str, ...] | None
    sends: tuple[str, ...] | None

    @property
    def virtual(self) -> bool:
        """Is this a USB port, or can it be one? If so, its baud rate has no effect."""
        return self.name.split()[0] in ("USB", "Main")


@dataclass(frozen=True)
class Listing:
    info: Any  # `base.BaseDeviceInfo`
    descriptors: tuple[Key, ...]
    base_rates: dict[int, int] = field(default_factory=dict)  # data set -> Hz
    ports: tuple[ListedPort, ...] = ()

    @property
    def title(self) -> str:
        """The name of the model, without characters that cannot be printed."""
        text = "".join(c for c in self.info.model_name if c.isprintable())
        return " ".join(text.split())

    @property
    def firmware(self) -> str:
        """The firmware version as the vendor writes it: 1202 is 1.2.02."""
        number = self.info.firmware_version
        return f"{number // 1000}.{number // 100 % 10}.{number % 100:02}"


def ask(link: DeviceAtPort, name: str, complain: Callable[[str], None] = lambda text: None) -> Listing:
    """Queries a device while it is idle, and resumes its streams, even after an error or an interrupt. Raises Failure.

    `name` is the name of the port, for messages. `complain` is called with a message for each missing answer that the
    listing can do without, and if the streams could not be resumed.
    """
    questions = _Questions(link, name, complain)
    questions.greet()
    with idle(link, name, complain):
        return questions.listing()


def read_identity(link: DeviceAtPort, name: str, complain: Callable[[str], None]) -> Listing:
    """Reads only the identity and the descriptors of a device, which may be streaming. Raises Failure."""
    questions = _Questions(link, name, complain)
    questions.greet()
    return questions.identity()


@contextmanager
def idle(link: DeviceAtPort, name: str, complain: Callable[[str], None] = lambda text: None) -> Iterator[None]:
    """Sets a device to idle, and resumes its streams afterwards, even after an error or an interrupt."""
    questions = _Questions(link, name, complain)
    resumes = True
    try:
        # A device that rejects it continues to stream, which does no harm. One that does not answer may be idle.
        resumes = questions.carried_out("base.set_idle") is not False
        yield
    finally:
        if resumes and not questions.carried_out("base.resume"):
            complain(f"{name} did not acknowledge base.resume, so it may be idle; send it again")


class _Questions:
    def __init__(self, link: DeviceAtPort, name: str, complain: Callable[[str], None]) -> None:
        self._link = link
        self.name = name
        self.complain = complain
        self._listed: frozenset[Key] = frozenset()

    def greet(self) -> None:
        """Checks that the device answers, even with a NACK. Raises Failure if it does not."""
        try:
            self._link.request(command_type("base.ping")())
        except Refused:
            pass

    def carried_out(self, command: str) -> bool | None:
        """Sends a command. Did the device carry it out? None if it did not answer."""
        try:
            self._link.request(command_type(command)())
        except Refused:
            return False
        except MipError:
            return None
        return True

    def listing(self) -> Listing:
        reply = self.identity()
        self._listed = frozenset(reply.descriptors)
        return replace(reply, base_rates=dict(self._rates()), ports=tuple(self._ports(identify(reply.info))))

    def identity(self) -> Listing:
        identity = self._needed("base.get_device_info").device_info
        numbers = list(self._needed("base.get_device_descriptors").descriptors)
        extended = command_type(EXTENDED)
        if extended.SET << 8 | extended.DESCRIPTOR in numbers:
            numbers += self._needed(EXTENDED).descriptors
        keys = tuple(sorted({divmod(number, 0x100) for number in numbers}))
        return Listing(identity, keys)

    def _needed(self, command: str) -> Any:
        """Requests a response that the listing needs. Raises Failure if there is none."""
        try:
            return self._link.request(command_type(command)())
        except Refused as error:
            code = f"{error.code.name.lower()} ({int(error.code)})"
            raise Failure(f"the device refused {command}: {code}; its descriptors are unknown", REFUSED) from None

    def optional(self, command: str, *values: Any, function: str = "") -> Any:
        """Requests the response to a command that the device lists; None if there is none, as for a missing port."""
        kind = _type_or_none(command)
        if kind is None:
            return None
        try:
            return self._link.request(getattr(kind, function)(*values) if function else kind(*values))
        except PortClosed as error:
            raise Failure(f"{self.name}: {error}") from None
        except Refused:
            return None
        except MipError as error:
            self.complain(f"{error.detail}; the data of {command} is left out")
            return None

    def _lists(self, command: str) -> bool:
        kind = _type_or_none(command)
        return kind is not None and (kind.SET, kind.DESCRIPTOR) in self._listed

    # ----------------------------------------------------------------- rates

    def _rates(self) -> Iterator[tuple[int, int]]:
        if self._lists(RATE):
            for number in sorted({set_number for set_number, _ in self._listed if 0x80 <= set_number < 0xFF}):
                reply = self.optional(RATE, number)
                if reply is not None:
                    yield number, reply.rate
            return
        for command, set_number in RATES.items():
            reply = self.optional(command) if self._lists(command) else None
            if reply is not None:
                yield lookup.set_number(set_number), reply.rate

    # ----------------------------------------------------------------- ports

    def _ports(self, profile: Device | None) -> Iterator[ListedPort]:
        """Yields the ports of the device. All port numbers that the specification defines are tried."""
        speed, protocols = self._lists(SPEED), self._lists(PROTOCOLS)
        if not (speed or protocols) or _type_or_none(PROTOCOLS) is None:
            return
        numbers = command_type(PROTOCOLS).INFO["port"].type
        names = {value.value: _port_name(value.name) for value in info(numbers).values if value.name != _ALL}
        names |= {port.id: port.name for port in (profile.ports if profile else ()) if port.id is not None}
        for number, name in sorted(names.items()):
            rate = self.optional(SPEED, number, function="read") if speed else None
            ways = self.optional(PROTOCOLS, numbers(number), function="read") if protocols else None
            if rate is not None or ways is not None:
                yield ListedPort(
                    number,
                    name,
                    rate.baud if rate is not None and rate.baud else None,
                    _names(ways.protocols_incoming) if ways is not None else None,
                    _names(ways.protocols_outgoing) if ways is not None else None,
                )


def _port_name(value: str) -> str:
    """Converts the name of an enumeration value to the name of a port.

    >>> _port_name("uart_1"), _port_name("main")
    ('UART 1', 'Main')
    """
    return " ".join(_WORDS.get(word, word.capitalize()) for word in value.split("_"))


def _names(protocols: Any) -> tuple[str, ...]:
    """Returns the names of protocols, in the order of their bits; for a bit without a name, its number."""
    kind: Any = type(protocols)
    bits = list(kind)
    named = [str(bit.name) for bit in bits if bit in protocols]
    rest = int(protocols) & ~sum(int(bit) for bit in bits)
    return tuple(named) + tuple(f"0x{1 << i:08X}" for i in range(32) if rest >> i & 1)


def _type_or_none(command: str) -> Any:
    """Returns the type of a command; None if the specification does not define it."""
    try:
        return registry.by_name(command)
    except UnknownName:
        return None


def command_type(name: str) -> Any:
    """Returns the type of a command that querying a device needs. Raises Failure if the package lacks it."""
    kind = _type_or_none(name)
    if kind is None:
        raise Failure(f"the generated package has no {name}, which is needed to query a device")
    return kind
