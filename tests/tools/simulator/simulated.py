"""Simulated worlds and devices: their data fields by name, and a host of a device."""

from __future__ import annotations

from typing import Any

from mip_protocol import Answer, Client, Command, Packet, Parser, Received, mip_3dm, registry, types
from mip_protocol.devices import by_name
from mip_protocol.field import Data
from mip_protocol.profile import Device
from mip_simulator import VirtualDevice
from mip_simulator.motion import Motion
from mip_simulator.streams.values import encoder
from mip_simulator.world.world import World

#: The data fields of each set -> their sets.
SETS = {kind.name_in(number): number for number, kind in registry.all_types() if issubclass(kind, Data)}
#: And their classes.
TYPES = {kind.name_in(number): kind for number, kind in registry.all_types() if issubclass(kind, Data)}


def profile(name: str = "3dm-cv7-gnss-ins") -> Device:
    found = by_name(name)
    assert found is not None
    return found


class Shown:
    """Shows data fields at any time; without noise and bias unless they are wanted."""

    def __init__(self, motion: Motion, *, exact: bool = True, seed: int = 0, start: int | None = None) -> None:
        self.world = World(motion, seed=seed, start=start, noise=0 if exact else 1)
        if exact:
            self.world.accel_bias = self.world.accel_bias_left
            self.world.gyro_bias = self.world.gyro_bias_left
        self._encoders: dict[str, Any] = {}

    def at(self, seconds: float) -> Shown:
        self.world.move_to(round(seconds * 1e9))
        return self

    def raw(self, name: str) -> list[bytes]:
        if name not in self._encoders:
            self._encoders[name] = encoder(TYPES[name], profile(), self.world, SETS[name])
        data: list[bytes] = self._encoders[name]()
        return data

    def all(self, name: str) -> list[Any]:
        return [TYPES[name].decode(data) for data in self.raw(name)]

    def __call__(self, name: str) -> Any:
        (found,) = self.all(name)
        return found


def show(device: VirtualDevice, name: str) -> Any:
    """A data field of a device at this time."""
    kind = TYPES[name]
    return kind.decode(device.encoder(SETS[name], kind.DESCRIPTOR)()[0].data)


class Host:
    """Sends commands to a device, and keeps the data that arrive in between."""

    def __init__(self, device: VirtualDevice, port: str | None = None) -> None:
        self.device = device
        self.link = device.connect(port)
        self.client = Client()
        self.data: list[Packet] = []

    def ask(self, *commands: Command, patience: float = 40.0) -> list[Any]:
        """The outcomes of commands in one packet; a silent command has none."""
        self.link.write(self.client.send(*commands, now=self.now))
        found: list[Any] = []
        end = self.now + patience
        while True:
            for event in self.client.receive(self.link.read(), now=self.now):
                if isinstance(event, Received):
                    self.data.append(event.packet)
                else:
                    found.append(event)
            if not self.client.pending or self.now >= end:
                return found
            self.device.advance(0.05)

    def ok(self, command: Command) -> Any:
        """The response to a command that must succeed."""
        (answer,) = self.ask(command)
        assert isinstance(answer, Answer) and answer.accepted and answer.error is None, answer
        return answer.response

    def refused(self, command: Command) -> int:
        (answer,) = self.ask(command)
        assert isinstance(answer, Answer) and not answer.accepted, answer
        return int(answer.code)

    def raw(self, data: bytes) -> list[Packet]:
        """The packets that come back for any bytes."""
        self.link.write(data)
        return Parser().feed(self.link.read())

    @property
    def now(self) -> float:
        return self.device.now / 1e9

    def stream(self, number: int, *fields: tuple[Any, int]) -> None:
        """Starts fields, which are types or descriptors, each with its decimation."""
        rates = tuple(types.DescriptorRate(getattr(kind, "DESCRIPTOR", kind), n) for kind, n in fields)
        self.ok(mip_3dm.MessageFormat.write(number, rates))

    def received(self, seconds: float, kind: Any = None) -> list[Any]:
        """The packets of the next seconds, or the fields of a type in them."""
        self.device.advance(seconds)
        packets = Parser().feed(self.link.read())
        return packets if kind is None else [f for f in map(kind.find, packets) if f is not None]
