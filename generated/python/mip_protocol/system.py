"""System (0x7F).

Advanced commands of devices that are built from several intelligent parts.
"""

from __future__ import annotations

from dataclasses import dataclass

from . import codec
from .errors import Truncated
from .field import Command, Field, Response
from .protocol import FunctionSelector


class ProtocolMode(codec.OpenEnum):
    """Which part of the device the host talks to, and in which protocol."""

    STANDARD = 1
    """The device itself, MIP."""
    SENSOR_DIRECT = 2
    """The inertial sensor inside, MIP."""
    GNSS_DIRECT = 3
    """The GNSS receiver inside, NMEA and UBX; only on models that have one."""


_COMMUNICATION_MODE_RESPONSE_0 = codec.Block("B", "mode")


@dataclass(slots=True)
class CommunicationModeResponse(Response):
    """Communication mode response (0x7F,0x90).

    Answers Communication mode (0x7F,0x10).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    SET = 0x7F
    DESCRIPTOR = 0x90
    NAME = "system.communication_mode_response"
    ROLE = "response"

    mode: ProtocolMode
    """Communication mode. Factory default: standard."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[CommunicationModeResponse, int]:
        v = _COMMUNICATION_MODE_RESPONSE_0.read(raw, at)
        at += 1
        mode = ProtocolMode(v[0])
        return cls(mode), at

    def _write(self) -> bytes:
        out = _COMMUNICATION_MODE_RESPONSE_0.write(self.mode)
        return codec.finished(out)


_COMMUNICATION_MODE_0 = codec.Block("B", "function")
_COMMUNICATION_MODE_1 = codec.Block("B", "mode")
_COMMUNICATION_MODE_GROUPS = ((1, ("mode",), False),)


@dataclass(slots=True)
class CommunicationMode(Command):
    """Communication mode (0x7F,0x10).

    Switches the port between the device and one of the sensors inside it.
    The acknowledge is sent in the old mode, just before the switch.
    In a direct mode only this command and device status (0x0C,0x64) of the device itself are
    answered.
    For advanced use.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
    """

    SET = 0x7F
    DESCRIPTOR = 0x10
    NAME = "system.communication_mode"
    ROLE = "command"
    RESPONSES = (CommunicationModeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    mode: ProtocolMode | None = None
    """Communication mode. Factory default: standard."""

    @classmethod
    def write(cls, mode: ProtocolMode) -> CommunicationMode:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, mode=mode)

    @classmethod
    def read(cls) -> CommunicationMode:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> CommunicationMode:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> CommunicationMode:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> CommunicationMode:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return CommunicationModeResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[CommunicationMode, int]:
        mode: ProtocolMode | None = None
        v = _COMMUNICATION_MODE_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _COMMUNICATION_MODE_1.read(raw, at)
            at += 1
            mode = ProtocolMode(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, mode), at

    def _write(self) -> bytes:
        out = _COMMUNICATION_MODE_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _COMMUNICATION_MODE_GROUPS)
        if there >= 1:
            out += _COMMUNICATION_MODE_1.write(self.mode)
        return codec.finished(out)


CommunicationModeResponse.COMMANDS = (CommunicationMode,)


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x10: (CommunicationMode,),
    0x90: (CommunicationModeResponse,),
}
