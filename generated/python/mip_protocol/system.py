"""System (0x7F).

Advanced commands of devices that consist of several intelligent parts.

- 3dm-gx5-15: 4.4 System Commands
"""

from __future__ import annotations

from enum import IntFlag
from typing import Any

from . import codec, types
from .field import ClassOf, Command, Field, R, Response, ResponseClasses
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_B = codec.Block("B")

_B2I = codec.Block("B2I")

_I = codec.Block("I")


@codec.open_flag(32)
class CommProtocols(IntFlag):
    """Protocols of a port.

    - mip-sdk-4: Interface Control (0x7F,0x02)
    """

    MIP = 1 << 0
    """Bit 0."""
    NMEA = 1 << 8
    """NMEA-0183. Bit 8."""
    RTCM = 1 << 9
    """RTCM corrections. Bit 9."""
    SPARTN = 1 << 24
    """SPARTN corrections. Bit 24."""
    SBF = 1 << 29
    """SBF, the binary format of Septentrio receivers. Bit 29."""


class ProtocolMode(codec.OpenEnum):
    """Part of the device that the host communicates with, and its protocol."""

    STANDARD = 1
    """The device itself; the protocol is MIP."""
    SENSOR_DIRECT = 2
    """The internal inertial sensor; the protocol is MIP."""
    GNSS_DIRECT = 3
    """The internal GNSS receiver; the protocols are NMEA and UBX. Requires a receiver."""


class InterfaceControlResponse(Response):
    """Interface control response (0x7F,0x82).

    Response to `InterfaceControl`. Supported by 3DM-CV7-GNSS/INS.

    - mip-sdk-4: Interface control (0x7F,0x02)
    - 3dm-cv7-gnss-ins: Ports
    """

    __slots__ = ("port", "protocols_incoming", "protocols_outgoing")
    __match_args__ = ("port", "protocols_incoming", "protocols_outgoing")

    SET = 0x7F
    DESCRIPTOR = 0x82
    NAME = "system.interface_control_response"
    _SIZE = 9

    port: types.CommInterface
    """Port whose protocols are set or read. Uncertain: No source states whether write and read
    accept `all`.
    """
    protocols_incoming: CommProtocols
    """Protocols that the port receives."""
    protocols_outgoing: CommProtocols
    """Protocols that the port sends."""

    def __init__(
        self,
        port: types.CommInterface,
        protocols_incoming: CommProtocols,
        protocols_outgoing: CommProtocols,
    ) -> None:
        self.port = port
        self.protocols_incoming = protocols_incoming
        self.protocols_outgoing = protocols_outgoing

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B2I.unpack(raw, at)
        self.port = codec.KNOWN[types.CommInterface][v[0]]
        self.protocols_incoming = codec.KNOWN[CommProtocols][v[1]]
        self.protocols_outgoing = codec.KNOWN[CommProtocols][v[2]]
        return at + 9

    def _write(self) -> bytes:
        return _B2I.write(
            "port protocols_incoming protocols_outgoing",
            self.port,
            self.protocols_incoming,
            self.protocols_outgoing,
        )


class CommModeResponse(Response):
    """Communication mode response (0x7F,0x90).

    Response to `CommMode`. Confirmed on 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on
    17 more.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x7F
    DESCRIPTOR = 0x90
    NAME = "system.comm_mode_response"
    _SIZE = 1

    mode: ProtocolMode
    """Communication mode. Default: `ProtocolMode.STANDARD`."""

    def __init__(self, mode: ProtocolMode) -> None:
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.mode = codec.KNOWN[ProtocolMode][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("mode", self.mode)


class InterfaceControl(Command[R]):
    """Interface control (0x7F,0x02).

    Sets the protocols that a port receives and sends.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `InterfaceControlResponse`.
    Supported by 3DM-CV7-GNSS/INS.

    Accepted on the main port only. The main port always keeps MIP in both directions. The change
    takes effect before the ACK, which is sent on the main port. Bytes that arrive during the change
    may be lost. The device rejects protocols that it or the port does not support, and settings
    that need more parsers than it has. A rejected command changes nothing. Replies to an incoming
    protocol are sent on the same port, even if the protocol is not an outgoing one. Devices differ
    in how many protocols they receive and send at a time.

    - mip-sdk-4: Interface control (0x7F,0x02)
    - 3dm-cv7-gnss-ins: Ports
    """

    __slots__ = ("function", "port", "protocols_incoming", "protocols_outgoing")
    __match_args__ = ("function", "port", "protocols_incoming", "protocols_outgoing")

    SET = 0x7F
    DESCRIPTOR = 0x02
    NAME = "system.interface_control"
    RESPONSES = (InterfaceControlResponse,)
    REQUIRED = {1: 3, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    port: types.CommInterface | None
    """Port whose protocols are set or read. Uncertain: No source states whether write and read
    accept `all`.
    """
    protocols_incoming: CommProtocols | None
    """Protocols that the port receives. Required for `write`."""
    protocols_outgoing: CommProtocols | None
    """Protocols that the port sends. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        port: types.CommInterface | None = None,
        protocols_incoming: CommProtocols | None = None,
        protocols_outgoing: CommProtocols | None = None,
    ) -> None:
        self.function = function
        self.port = port
        self.protocols_incoming = protocols_incoming
        self.protocols_outgoing = protocols_outgoing

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5, 9))
        self.port = codec.KNOWN[types.CommInterface][_B.read(raw, at)[0]] if there >= 1 else None
        self.protocols_incoming = (
            codec.KNOWN[CommProtocols][_I.read(raw, at + 1)[0]] if there >= 2 else None
        )
        self.protocols_outgoing = (
            codec.KNOWN[CommProtocols][_I.read(raw, at + 5)[0]] if there >= 3 else None
        )
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "port"),
            (2, "protocols_incoming"),
            (3, "protocols_outgoing"),
        )
        out += _B.write("port", self.port) if there >= 1 else b""
        out += _I.write("protocols_incoming", self.protocols_incoming) if there >= 2 else b""
        out += _I.write("protocols_outgoing", self.protocols_outgoing) if there >= 3 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[InterfaceControl[Any]],
        port: types.CommInterface,
        protocols_incoming: CommProtocols,
        protocols_outgoing: CommProtocols,
    ) -> InterfaceControl[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            port=port,
            protocols_incoming=protocols_incoming,
            protocols_outgoing=protocols_outgoing,
        )

    @classmethod
    def read(
        cls: ClassOf[InterfaceControl[Any]], port: types.CommInterface
    ) -> InterfaceControl[InterfaceControlResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, port=port)

    @classmethod
    def save(
        cls: ClassOf[InterfaceControl[Any]], port: types.CommInterface
    ) -> InterfaceControl[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, port=port)

    @classmethod
    def load(
        cls: ClassOf[InterfaceControl[Any]], port: types.CommInterface
    ) -> InterfaceControl[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, port=port)

    @classmethod
    def default(
        cls: ClassOf[InterfaceControl[Any]], port: types.CommInterface
    ) -> InterfaceControl[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, port=port)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (InterfaceControlResponse,)
        return ()


class CommMode(Command[R]):
    """Communication mode (0x7F,0x10).

    Switches the port between the device and one of its internal sensors.

    For advanced use. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `CommModeResponse`. Confirmed on 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 17
    more.

    The ACK is sent in the old mode, just before the switch. In a direct mode, the device itself
    replies only to this command and `mip_3dm.DeviceStatus`.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    __slots__ = ("function", "mode")
    __match_args__ = ("function", "mode")

    SET = 0x7F
    DESCRIPTOR = 0x10
    NAME = "system.comm_mode"
    RESPONSES = (CommModeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    mode: ProtocolMode | None
    """Communication mode. Default: `ProtocolMode.STANDARD`. Required for `write`.

    - On the 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-15 and
      3DM-GX5-25: only `ProtocolMode.STANDARD` and `ProtocolMode.SENSOR_DIRECT`.
    - On the 3DM-GX5-35: default `ProtocolMode.STANDARD`.
    """

    def __init__(self, function: FunctionSelector, mode: ProtocolMode | None = None) -> None:
        self.function = function
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.mode = codec.KNOWN[ProtocolMode][_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "mode"))
        out += _B.write("mode", self.mode) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[CommMode[Any]], mode: ProtocolMode) -> CommMode[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, mode=mode)

    @classmethod
    def read(cls: ClassOf[CommMode[Any]]) -> CommMode[CommModeResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[CommMode[Any]]) -> CommMode[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[CommMode[Any]]) -> CommMode[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[CommMode[Any]]) -> CommMode[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (CommModeResponse,)
        return ()


InterfaceControlResponse.COMMANDS = (InterfaceControl,)
CommModeResponse.COMMANDS = (CommMode,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x02: (InterfaceControl,),
    0x10: (CommMode,),
    0x82: (InterfaceControlResponse,),
    0x90: (CommModeResponse,),
}
