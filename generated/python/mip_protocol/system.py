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
    """The internal GNSS receiver, if there is one; the protocols are NMEA and UBX."""


class InterfaceControlResponse(Response):
    """Interface control response (0x7F,0x82).

    Response to `InterfaceControl`. Supported by 3DM-CV7-GNSS/INS.

    - mip-sdk-4: Interface control (0x7F,0x02)
    - 3dm-cv7-gnss-ins: Ports
    """

    __slots__ = ("port", "protocols_incoming", "protocols_outgoing")
    __match_args__ = ("port", "protocols_incoming", "protocols_outgoing")

    SET = 0x7F
    SETS = (0x7F,)
    DESCRIPTOR = 0x82
    NAME = "system.interface_control_response"
    ROLE = "response"
    _LAYOUT = (
        ("port", "B", types.CommInterface),
        ("protocols_incoming", "I", CommProtocols),
        ("protocols_outgoing", "I", CommProtocols),
    )

    port: types.CommInterface
    """Port whose protocols are set or read. Uncertain: Whether write and read accept `all`."""
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


class CommModeResponse(Response):
    """Communication mode response (0x7F,0x90).

    Response to `CommMode`. Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x7F
    SETS = (0x7F,)
    DESCRIPTOR = 0x90
    NAME = "system.comm_mode_response"
    ROLE = "response"
    _LAYOUT = (("mode", "B", ProtocolMode),)

    mode: ProtocolMode
    """Communication mode. Default: `ProtocolMode.STANDARD`."""

    def __init__(self, mode: ProtocolMode) -> None:
        self.mode = mode


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
    SETS = (0x7F,)
    DESCRIPTOR = 0x02
    NAME = "system.interface_control"
    ROLE = "command"
    RESPONSES = (InterfaceControlResponse,)
    REQUIRED = {1: 3, 2: 1, 3: 1, 4: 1, 5: 1}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("port", "B", types.CommInterface),
        ("protocols_incoming", "I", CommProtocols),
        ("protocols_outgoing", "I", CommProtocols),
    )
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    port: types.CommInterface | None
    """Port whose protocols are set or read. Uncertain: Whether write and read accept `all`."""
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
    `CommModeResponse`. Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.

    The ACK is sent in the old mode, just before the switch. In a direct mode, the device itself
    replies only to this command and `mip_3dm.DeviceStatus`.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    __slots__ = ("function", "mode")
    __match_args__ = ("function", "mode")

    SET = 0x7F
    SETS = (0x7F,)
    DESCRIPTOR = 0x10
    NAME = "system.comm_mode"
    ROLE = "command"
    RESPONSES = (CommModeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (("function", "B", FunctionSelector), ("mode", "B", ProtocolMode))
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    mode: ProtocolMode | None
    """Communication mode. Default: `ProtocolMode.STANDARD`. Required for `write`.

    - On the 3DM-GX5-35: default `ProtocolMode.STANDARD`.
    """

    def __init__(self, function: FunctionSelector, mode: ProtocolMode | None = None) -> None:
        self.function = function
        self.mode = mode

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
