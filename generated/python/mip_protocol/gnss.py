"""GNSS commands (0x0E).

Commands that describe and set up the internal GNSS receivers.

- 3dm-cv7-gnss-ins: GNSS (0x0E)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_2B = codec.Block("2B")

_2BIH32BIH32B = codec.Block("2BIH32BIH32B")

_32B = codec.Block("32B")

_3B = codec.Block("3B")

_4B = codec.Block("4B")

_5B = codec.Block("5B")

_8B = codec.Block("8B")

_B = codec.Block("B")

_H = codec.Block("H")

_I = codec.Block("I")


class ReceiverInfoEntry(Structure):
    """Description of a GNSS receiver.

    - 3dm-cv7-gnss-ins: Info
    - mip-sdk-4: Receiver Info (0x0E,0x01)
    """

    __slots__ = ("receiver_id", "mip_data_descriptor_set", "description")
    __match_args__ = ("receiver_id", "mip_data_descriptor_set", "description")

    receiver_id: int
    """Receiver, numbered as in `receiver_id`: 1 and 2 are internal, 4 and 5 external. Range: at
    least 1.
    """
    mip_data_descriptor_set: int
    """Descriptor set of this receiver's data. Range: 0x80 to 0xFE."""
    description: str
    """Module name or model and firmware version, separated by a comma."""

    def __init__(self, receiver_id: int, mip_data_descriptor_set: int, description: str) -> None:
        self.receiver_id = receiver_id
        self.mip_data_descriptor_set = mip_data_descriptor_set
        self.description = description

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.receiver_id, self.mip_data_descriptor_set = _2B.read(raw, at)
        at += 2
        n = 32
        self.description = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "receiver_id mip_data_descriptor_set", self.receiver_id, self.mip_data_descriptor_set
        )
        out += codec.padded("description", self.description, 32)
        return out


@codec.open_flag(8)
class GpsSignals(IntFlag):
    """GPS signals that are enabled."""

    L1CA = 1 << 0
    """L1 C/A. Bit 0."""
    L2C = 1 << 1
    """Bit 1."""
    L5 = 1 << 2
    """Bit 2."""


@codec.open_flag(8)
class GlonassSignals(IntFlag):
    """GLONASS signals that are enabled."""

    L1OF = 1 << 0
    """Bit 0."""
    L2OF = 1 << 1
    """Bit 1."""


@codec.open_flag(8)
class GalileoSignals(IntFlag):
    """Galileo signals that are enabled."""

    E1 = 1 << 0
    """Bit 0."""
    E5B = 1 << 1
    """Bit 1."""
    E5A = 1 << 2
    """Bit 2."""


@codec.open_flag(8)
class BeidouSignals(IntFlag):
    """BeiDou signals that are enabled."""

    B1 = 1 << 0
    """Bit 0."""
    B2 = 1 << 1
    """Bit 1."""
    B2A = 1 << 2
    """Bit 2."""


class ReceiverId(codec.OpenEnum):
    """A GNSS receiver.

    - mip-sdk-4: Receiver Reset (0x0E,0x03)
    """

    ALL = 0
    """Every receiver; only for commands that accept it."""
    INTERNAL_RECEIVER_1 = 1
    """The first receiver inside the device."""
    INTERNAL_RECEIVER_2 = 2
    """The second receiver inside the device."""
    USER_RECEIVER_1 = 4
    """The first external receiver."""
    USER_RECEIVER_2 = 5
    """The second external receiver."""


class ReceiverResetType(codec.OpenEnum):
    """Extent of a receiver restart.

    - mip-sdk-4: Receiver Reset (0x0E,0x03)
    """

    HARDWARE = 1
    """Resets the hardware of the receiver."""
    COLD = 2
    """Restarts all software of the receiver."""
    WARM = 3
    """Restarts the positioning engine only. Uncertain: An earlier branch of the SDK calls 3 hot and
    4 warm, with the same descriptions of the two numbers. GNSS receivers usually keep their
    satellite data in a hot start and lose it in a warm one.
    """
    HOT = 4
    """Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: An
    earlier branch of the SDK swaps this name with that of 3.
    """


class AmbiguityFixMode(codec.OpenEnum):
    """Strategy for fixing the RTK carrier phase ambiguities to whole numbers. Uncertain: The
    descriptions of `conservative` and `moderate` are inferred from their names.

    - mip-sdk-4: Rtk Configuration (0x0E,0x04)
    """

    OFF = 1
    """Never fixes them. The solution remains a float solution."""
    CONSERVATIVE = 2
    """Fixes them late, so that few fixes are wrong."""
    MODERATE = 3
    """Between conservative and aggressive."""
    AGGRESSIVE = 4
    """Fixes them as soon as possible."""


class SpartnConnection(codec.OpenEnum):
    """Channel that delivers SPARTN corrections."""

    NONE = 0
    """No connection."""
    NETWORK = 1
    """Over a network."""
    L_BAND = 2
    """By satellite in the L band."""


class ReceiverInfoResponse(Response):
    """Receiver info response (0x0E,0x81).

    Response to `ReceiverInfo`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

    - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
    """

    __slots__ = ("receiver_info",)
    __match_args__ = ("receiver_info",)

    SET = 0x0E
    DESCRIPTOR = 0x81
    NAME = "gnss.receiver_info_response"

    # On the wire only: num_receivers. Number of physical receivers. Counts the elements of
    # `receiver_info`.
    receiver_info: tuple[ReceiverInfoEntry, ...]
    """One entry for each receiver."""

    def __init__(self, receiver_info: Sequence[ReceiverInfoEntry]) -> None:
        self.receiver_info = codec.several(receiver_info)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_num_receivers = v[0]
        at += 1
        n = codec.counted(raw, at, n_num_receivers, 34, 7)
        self.receiver_info, at = codec.read_structures(ReceiverInfoEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("num_receivers", codec.count("receiver_info", self.receiver_info, 7))
        out += codec.write_structures(
            "receiver_info",
            codec.at_most("receiver_info", self.receiver_info, 7),
            ReceiverInfoEntry,
        )
        return codec.finished(out)


class SignalConfigResponse(Response):
    """Signal configuration response (0x0E,0x82).

    Also called `signal_configuration_response`. Response to `SignalConfig`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 1 more.

    - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
    - 3dm-cv7-gnss-ins: GNSS
    """

    __slots__ = ("gps_enable", "glonass_enable", "galileo_enable", "beidou_enable", "reserved")
    __match_args__ = ("gps_enable", "glonass_enable", "galileo_enable", "beidou_enable", "reserved")

    SET = 0x0E
    DESCRIPTOR = 0x82
    NAME = "gnss.signal_config_response"
    _SIZE = 8

    gps_enable: GpsSignals
    """GPS signals."""
    glonass_enable: GlonassSignals
    """GLONASS signals."""
    galileo_enable: GalileoSignals
    """Galileo signals."""
    beidou_enable: BeidouSignals
    """BeiDou signals."""
    reserved: tuple[int, int, int, int]
    """Reserved."""

    def __init__(
        self,
        gps_enable: GpsSignals,
        glonass_enable: GlonassSignals,
        galileo_enable: GalileoSignals,
        beidou_enable: BeidouSignals,
        reserved: Sequence[int] = (0, 0, 0, 0),
    ) -> None:
        self.gps_enable = gps_enable
        self.glonass_enable = glonass_enable
        self.galileo_enable = galileo_enable
        self.beidou_enable = beidou_enable
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _8B.unpack(raw, at)
        self.gps_enable = codec.KNOWN[GpsSignals][v[0]]
        self.glonass_enable = codec.KNOWN[GlonassSignals][v[1]]
        self.galileo_enable = codec.KNOWN[GalileoSignals][v[2]]
        self.beidou_enable = codec.KNOWN[BeidouSignals][v[3]]
        self.reserved = v[4:8]
        return at + 8

    def _write(self) -> bytes:
        return _8B.write(
            "gps_enable glonass_enable galileo_enable beidou_enable reserved*4",
            self.gps_enable,
            self.glonass_enable,
            self.galileo_enable,
            self.beidou_enable,
            *codec.exactly("reserved", self.reserved, 4),
        )


class RtkConfigResponse(Response):
    """RTK configuration response (0x0E,0x84).

    Also called `rtk_configuration_response`. Response to `RtkConfig`. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: RTK configuration (0x0E,0x04)
    """

    __slots__ = ("ambiguity_fix_mode", "reserved")
    __match_args__ = ("ambiguity_fix_mode", "reserved")

    SET = 0x0E
    DESCRIPTOR = 0x84
    NAME = "gnss.rtk_config_response"
    _SIZE = 5

    ambiguity_fix_mode: AmbiguityFixMode
    """Strategy for fixing ambiguities."""
    reserved: tuple[int, int, int, int]
    """Reserved."""

    def __init__(
        self, ambiguity_fix_mode: AmbiguityFixMode, reserved: Sequence[int] = (0, 0, 0, 0)
    ) -> None:
        self.ambiguity_fix_mode = ambiguity_fix_mode
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _5B.unpack(raw, at)
        self.ambiguity_fix_mode = codec.KNOWN[AmbiguityFixMode][v[0]]
        self.reserved = v[1:5]
        return at + 5

    def _write(self) -> bytes:
        return _5B.write(
            "ambiguity_fix_mode reserved*4",
            self.ambiguity_fix_mode,
            *codec.exactly("reserved", self.reserved, 4),
        )


class RtkDongleConfigResponse(Response):
    """RTK dongle configuration response (0x0E,0x90).

    No device is known for certain to support it. Also called `rtk_dongle_configuration_response`.
    Response to `RtkDongleConfig`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
    """

    __slots__ = ("enable", "reserved")
    __match_args__ = ("enable", "reserved")

    SET = 0x0E
    DESCRIPTOR = 0x90
    NAME = "gnss.rtk_dongle_config_response"
    _SIZE = 4

    enable: int
    """1 enables the dongle, 0 disables it. Range: 0 to 1."""
    reserved: tuple[int, int, int]
    """Reserved. Uncertain: No source states what to send; 0 is assumed."""

    def __init__(self, enable: int, reserved: Sequence[int] = (0, 0, 0)) -> None:
        self.enable = enable
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4B.unpack(raw, at)
        self.enable = v[0]
        self.reserved = v[1:4]
        return at + 4

    def _write(self) -> bytes:
        return _4B.write(
            "enable reserved*3", self.enable, *codec.exactly("reserved", self.reserved, 3)
        )


class SpartnConfigResponse(Response):
    """SPARTN configuration response (0x0E,0xA0).

    Also called `spartn_configuration_response`. Response to `SpartnConfig`. Supported by
    3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
    - 3dm-cv7-gnss-ins: SPARTN Corrections
    - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
    """

    __slots__ = (
        "enable",
        "type",
        "current_key_tow",
        "current_key_week",
        "current_key",
        "next_key_tow",
        "next_key_week",
        "next_key",
    )
    __match_args__ = (
        "enable",
        "type",
        "current_key_tow",
        "current_key_week",
        "current_key",
        "next_key_tow",
        "next_key_week",
        "next_key",
    )

    SET = 0x0E
    DESCRIPTOR = 0xA0
    NAME = "gnss.spartn_config_response"
    _SIZE = 78

    enable: int
    """1 enables SPARTN corrections, 0 disables them. Range: 0 to 1."""
    type: SpartnConnection
    """Channel of the corrections."""
    current_key_tow: int
    """GPS time of week until which the current key is valid. Unit: s."""
    current_key_week: int
    """GPS week number until which the current key is valid. Unit: week."""
    current_key: tuple[int, ...]
    """Current key in ASCII digits."""
    next_key_tow: int
    """GPS time of week until which the next key is valid. Unit: s."""
    next_key_week: int
    """GPS week number until which the next key is valid. Unit: week."""
    next_key: tuple[int, ...]
    """Next key in ASCII digits."""

    def __init__(
        self,
        enable: int,
        type: SpartnConnection,
        current_key_tow: int,
        current_key_week: int,
        current_key: Sequence[int],
        next_key_tow: int,
        next_key_week: int,
        next_key: Sequence[int],
    ) -> None:
        self.enable = enable
        self.type = type
        self.current_key_tow = current_key_tow
        self.current_key_week = current_key_week
        self.current_key = codec.several(current_key)
        self.next_key_tow = next_key_tow
        self.next_key_week = next_key_week
        self.next_key = codec.several(next_key)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BIH32BIH32B.unpack(raw, at)
        self.enable = v[0]
        self.type = codec.KNOWN[SpartnConnection][v[1]]
        self.current_key_tow = v[2]
        self.current_key_week = v[3]
        self.current_key = v[4:36]
        self.next_key_tow = v[36]
        self.next_key_week = v[37]
        self.next_key = v[38:70]
        return at + 78

    def _write(self) -> bytes:
        return _2BIH32BIH32B.write(
            "enable type current_key_tow current_key_week current_key*32 next_key_tow next_key_week next_key*32",
            self.enable,
            self.type,
            self.current_key_tow,
            self.current_key_week,
            *codec.exactly("current_key", self.current_key, 32),
            self.next_key_tow,
            self.next_key_week,
            *codec.exactly("next_key", self.next_key, 32),
        )


class ReceiverInfo(Command[ReceiverInfoResponse]):
    """Receiver info (0x0E,0x01).

    Gets the GNSS receivers of the device.

    Response: `ReceiverInfoResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

    - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
    """

    __slots__ = ()

    SET = 0x0E
    DESCRIPTOR = 0x01
    NAME = "gnss.receiver_info"
    RESPONSES = (ReceiverInfoResponse,)


class SignalConfig(Command[R]):
    """Signal configuration (0x0E,0x02).

    Selects the GNSS signals that the device uses.

    Also called `signal_configuration`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `SignalConfigResponse`. Probably affects `gnss_data.FixInfo`,
    `gnss_data.SatelliteStatus` and `gnss_data.Raw`. Confirmed on 3DM-CV7-GNSS/INS; likely or
    assumed on 1 more. Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.

    A device accepts only certain combinations. The 3DM-CV7-GNSS/INS needs GPS or Galileo, and
    rejects GPS L1 with BeiDou L1 alone. For GPS and BeiDou it accepts none, L1, or L1 and L5; for
    Galileo none, or L1 and L5; for GLONASS none or L1.

    - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
    - 3dm-cv7-gnss-ins: GNSS
    """

    __slots__ = (
        "function",
        "gps_enable",
        "glonass_enable",
        "galileo_enable",
        "beidou_enable",
        "reserved",
    )
    __match_args__ = (
        "function",
        "gps_enable",
        "glonass_enable",
        "galileo_enable",
        "beidou_enable",
        "reserved",
    )

    SET = 0x0E
    DESCRIPTOR = 0x02
    NAME = "gnss.signal_config"
    RESPONSES = (SignalConfigResponse,)
    REQUIRED = {1: 5, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    gps_enable: GpsSignals | None
    """GPS signals. Required for `write`."""
    glonass_enable: GlonassSignals | None
    """GLONASS signals. Required for `write`."""
    galileo_enable: GalileoSignals | None
    """Galileo signals. Required for `write`."""
    beidou_enable: BeidouSignals | None
    """BeiDou signals. Required for `write`."""
    reserved: tuple[int, int, int, int] | None
    """Reserved: send 0. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        gps_enable: GpsSignals | None = None,
        glonass_enable: GlonassSignals | None = None,
        galileo_enable: GalileoSignals | None = None,
        beidou_enable: BeidouSignals | None = None,
        reserved: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.gps_enable = gps_enable
        self.glonass_enable = glonass_enable
        self.galileo_enable = galileo_enable
        self.beidou_enable = beidou_enable
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 3, 4, 8)
        )
        self.gps_enable = codec.KNOWN[GpsSignals][_B.read(raw, at)[0]] if there >= 1 else None
        self.glonass_enable = (
            codec.KNOWN[GlonassSignals][_B.read(raw, at + 1)[0]] if there >= 2 else None
        )
        self.galileo_enable = (
            codec.KNOWN[GalileoSignals][_B.read(raw, at + 2)[0]] if there >= 3 else None
        )
        self.beidou_enable = (
            codec.KNOWN[BeidouSignals][_B.read(raw, at + 3)[0]] if there >= 4 else None
        )
        self.reserved = _4B.read(raw, at + 4) if there >= 5 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "gps_enable"),
            (2, "glonass_enable"),
            (3, "galileo_enable"),
            (4, "beidou_enable"),
            (5, "reserved"),
        )
        out += _B.write("gps_enable", self.gps_enable) if there >= 1 else b""
        out += _B.write("glonass_enable", self.glonass_enable) if there >= 2 else b""
        out += _B.write("galileo_enable", self.galileo_enable) if there >= 3 else b""
        out += _B.write("beidou_enable", self.beidou_enable) if there >= 4 else b""
        if there >= 5:
            out += _4B.write("reserved*4", *codec.exactly("reserved", self.reserved, 4))
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SignalConfig[Any]],
        gps_enable: GpsSignals,
        glonass_enable: GlonassSignals,
        galileo_enable: GalileoSignals,
        beidou_enable: BeidouSignals,
    ) -> SignalConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            gps_enable=gps_enable,
            glonass_enable=glonass_enable,
            galileo_enable=galileo_enable,
            beidou_enable=beidou_enable,
            reserved=(0, 0, 0, 0),
        )

    @classmethod
    def read(cls: ClassOf[SignalConfig[Any]]) -> SignalConfig[SignalConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[SignalConfig[Any]]) -> SignalConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[SignalConfig[Any]]) -> SignalConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[SignalConfig[Any]]) -> SignalConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SignalConfigResponse,)
        return ()


class ReceiverReset(Command[None]):
    """Receiver reset (0x0E,0x03).

    Resets a GNSS receiver of the device.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The SDK
    names no device that supports it.

    Only internal receivers can be reset. Some devices do not support all reset types.

    - mip-sdk-4: Receiver reset (0x0E,0x03)
    """

    __slots__ = ("receiver_id", "reset_type")
    __match_args__ = ("receiver_id", "reset_type")

    SET = 0x0E
    DESCRIPTOR = 0x03
    NAME = "gnss.receiver_reset"
    _SIZE = 2

    receiver_id: ReceiverId
    """Receiver to reset."""
    reset_type: ReceiverResetType
    """Extent of the restart."""

    def __init__(self, receiver_id: ReceiverId, reset_type: ReceiverResetType) -> None:
        self.receiver_id = receiver_id
        self.reset_type = reset_type

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.receiver_id = codec.KNOWN[ReceiverId][v[0]]
        self.reset_type = codec.KNOWN[ReceiverResetType][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("receiver_id reset_type", self.receiver_id, self.reset_type)


class RtkConfig(Command[R]):
    """RTK configuration (0x0E,0x04).

    Sets how readily the device fixes the ambiguities of an RTK solution.

    Also called `rtk_configuration`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `RtkConfigResponse`. Probably affects `gnss_data.FixInfo` and `gnss_data.LlhPosition`.
    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: No source
    lists the devices that support it. Users of the vendor's ROS driver report it as experimental on
    the 3DM-GQ7, which accepts `conservative` only.

    The available modes differ by device.

    - mip-sdk-4: RTK configuration (0x0E,0x04)
    """

    __slots__ = ("function", "ambiguity_fix_mode", "reserved")
    __match_args__ = ("function", "ambiguity_fix_mode", "reserved")

    SET = 0x0E
    DESCRIPTOR = 0x04
    NAME = "gnss.rtk_config"
    RESPONSES = (RtkConfigResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    ambiguity_fix_mode: AmbiguityFixMode | None
    """Strategy for fixing ambiguities. Required for `write`."""
    reserved: tuple[int, int, int, int] | None
    """Reserved: send 0. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        ambiguity_fix_mode: AmbiguityFixMode | None = None,
        reserved: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.ambiguity_fix_mode = ambiguity_fix_mode
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5))
        self.ambiguity_fix_mode = (
            codec.KNOWN[AmbiguityFixMode][_B.read(raw, at)[0]] if there >= 1 else None
        )
        self.reserved = _4B.read(raw, at + 1) if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "ambiguity_fix_mode"), (2, "reserved")
        )
        out += _B.write("ambiguity_fix_mode", self.ambiguity_fix_mode) if there >= 1 else b""
        if there >= 2:
            out += _4B.write("reserved*4", *codec.exactly("reserved", self.reserved, 4))
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[RtkConfig[Any]], ambiguity_fix_mode: AmbiguityFixMode
    ) -> RtkConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE, ambiguity_fix_mode=ambiguity_fix_mode, reserved=(0, 0, 0, 0)
        )

    @classmethod
    def read(cls: ClassOf[RtkConfig[Any]]) -> RtkConfig[RtkConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[RtkConfig[Any]]) -> RtkConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[RtkConfig[Any]]) -> RtkConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[RtkConfig[Any]]) -> RtkConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (RtkConfigResponse,)
        return ()


class RtkDongleConfig(Command[R]):
    """RTK dongle configuration (0x0E,0x10).

    Switches the communication with a connected RTK dongle on or off.

    No device is known for certain to support it. Also called `rtk_dongle_configuration`. Functions:
    `write`, `read`, `save`, `load` and `default`. Response: `RtkDongleConfigResponse`. Probably
    affects `gnss_data.RtkCorrectionsStatus`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
    """

    __slots__ = ("function", "enable", "reserved")
    __match_args__ = ("function", "enable", "reserved")

    SET = 0x0E
    DESCRIPTOR = 0x10
    NAME = "gnss.rtk_dongle_config"
    RESPONSES = (RtkDongleConfigResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    enable: int | None
    """1 enables the dongle, 0 disables it. Range: 0 to 1. Required for `write`."""
    reserved: tuple[int, int, int] | None
    """Reserved: send 0. Required for `write`. Uncertain: No source states what to send; 0 is
    assumed.
    """

    def __init__(
        self,
        function: FunctionSelector,
        enable: int | None = None,
        reserved: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.enable = enable
        self.reserved = codec.several(reserved)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 4))
        self.enable = _B.read(raw, at)[0] if there >= 1 else None
        self.reserved = _3B.read(raw, at + 1) if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "enable"), (2, "reserved")
        )
        out += _B.write("enable", self.enable) if there >= 1 else b""
        if there >= 2:
            out += _3B.write("reserved*3", *codec.exactly("reserved", self.reserved, 3))
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[RtkDongleConfig[Any]], enable: int) -> RtkDongleConfig[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable, reserved=(0, 0, 0))

    @classmethod
    def read(cls: ClassOf[RtkDongleConfig[Any]]) -> RtkDongleConfig[RtkDongleConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[RtkDongleConfig[Any]]) -> RtkDongleConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[RtkDongleConfig[Any]]) -> RtkDongleConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[RtkDongleConfig[Any]]) -> RtkDongleConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (RtkDongleConfigResponse,)
        return ()


class SpartnConfig(Command[R]):
    """SPARTN configuration (0x0E,0x20).

    Sets the source and the keys of SPARTN corrections.

    Also called `spartn_configuration`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `SpartnConfigResponse`. Probably affects `gnss_data.RtkCorrectionsStatus`. Supported
    by 3DM-CV7-GNSS/INS. Uncertain: The device may not accept lower case: the section on UART uses
    the digits 0-9 and A-F, the description of the command uses "bc" for 0xBC.

    A change of `enable` or `type` takes effect only after a power cycle; keys can be changed at any
    time. While SPARTN corrections are enabled, RTCM corrections are blocked. A key has 16 bytes,
    none of them 0. Send it as 32 hexadecimal digits in ASCII, two for each byte.

    - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
    - 3dm-cv7-gnss-ins: SPARTN Corrections
    - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
    """

    __slots__ = (
        "function",
        "enable",
        "type",
        "current_key_tow",
        "current_key_week",
        "current_key",
        "next_key_tow",
        "next_key_week",
        "next_key",
    )
    __match_args__ = (
        "function",
        "enable",
        "type",
        "current_key_tow",
        "current_key_week",
        "current_key",
        "next_key_tow",
        "next_key_week",
        "next_key",
    )

    SET = 0x0E
    DESCRIPTOR = 0x20
    NAME = "gnss.spartn_config"
    RESPONSES = (SpartnConfigResponse,)
    REQUIRED = {1: 8, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    enable: int | None
    """1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. Required for `write`."""
    type: SpartnConnection | None
    """Channel of the corrections. Required for `write`."""
    current_key_tow: int | None
    """GPS time of week until which the current key is valid. Unit: s. Required for `write`."""
    current_key_week: int | None
    """GPS week number until which the current key is valid. Unit: week. Required for `write`."""
    current_key: tuple[int, ...] | None
    """Current key in ASCII digits. Required for `write`."""
    next_key_tow: int | None
    """GPS time of week until which the next key is valid. Unit: s. Required for `write`."""
    next_key_week: int | None
    """GPS week number until which the next key is valid. Unit: week. Required for `write`."""
    next_key: tuple[int, ...] | None
    """Next key in ASCII digits. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        enable: int | None = None,
        type: SpartnConnection | None = None,
        current_key_tow: int | None = None,
        current_key_week: int | None = None,
        current_key: Sequence[int] | None = None,
        next_key_tow: int | None = None,
        next_key_week: int | None = None,
        next_key: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.enable = enable
        self.type = type
        self.current_key_tow = current_key_tow
        self.current_key_week = current_key_week
        self.current_key = codec.several(current_key)
        self.next_key_tow = next_key_tow
        self.next_key_week = next_key_week
        self.next_key = codec.several(next_key)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 6, 8, 40, 44, 46, 78)
        )
        self.enable = _B.read(raw, at)[0] if there >= 1 else None
        self.type = codec.KNOWN[SpartnConnection][_B.read(raw, at + 1)[0]] if there >= 2 else None
        self.current_key_tow = _I.read(raw, at + 2)[0] if there >= 3 else None
        self.current_key_week = _H.read(raw, at + 6)[0] if there >= 4 else None
        self.current_key = _32B.read(raw, at + 8) if there >= 5 else None
        self.next_key_tow = _I.read(raw, at + 40)[0] if there >= 6 else None
        self.next_key_week = _H.read(raw, at + 44)[0] if there >= 7 else None
        self.next_key = _32B.read(raw, at + 46) if there >= 8 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "enable"),
            (2, "type"),
            (3, "current_key_tow"),
            (4, "current_key_week"),
            (5, "current_key"),
            (6, "next_key_tow"),
            (7, "next_key_week"),
            (8, "next_key"),
        )
        out += _B.write("enable", self.enable) if there >= 1 else b""
        out += _B.write("type", self.type) if there >= 2 else b""
        out += _I.write("current_key_tow", self.current_key_tow) if there >= 3 else b""
        out += _H.write("current_key_week", self.current_key_week) if there >= 4 else b""
        if there >= 5:
            out += _32B.write("current_key*32", *codec.exactly("current_key", self.current_key, 32))
        out += _I.write("next_key_tow", self.next_key_tow) if there >= 6 else b""
        out += _H.write("next_key_week", self.next_key_week) if there >= 7 else b""
        if there >= 8:
            out += _32B.write("next_key*32", *codec.exactly("next_key", self.next_key, 32))
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SpartnConfig[Any]],
        enable: int,
        type: SpartnConnection,
        current_key_tow: int,
        current_key_week: int,
        current_key: Sequence[int],
        next_key_tow: int,
        next_key_week: int,
        next_key: Sequence[int],
    ) -> SpartnConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            enable=enable,
            type=type,
            current_key_tow=current_key_tow,
            current_key_week=current_key_week,
            current_key=current_key,
            next_key_tow=next_key_tow,
            next_key_week=next_key_week,
            next_key=next_key,
        )

    @classmethod
    def read(cls: ClassOf[SpartnConfig[Any]]) -> SpartnConfig[SpartnConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[SpartnConfig[Any]]) -> SpartnConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[SpartnConfig[Any]]) -> SpartnConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[SpartnConfig[Any]]) -> SpartnConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SpartnConfigResponse,)
        return ()


class ReceiverSafeMode(Command[None]):
    """Receiver safe mode (0x0E,0x60).

    Switches the safe mode of one receiver on or off. In safe mode, it sends no valid data.

    Affects gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known only from the
    MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of version 1.0.0 of the SDK;
    later versions do not have it. Uncertain: No source lists the devices that support it.

    - mip-sdk-3: Receiver Safe Mode (0x0E,0x60), tag v1.0.0
    """

    __slots__ = ("receiver_id", "enable")
    __match_args__ = ("receiver_id", "enable")

    SET = 0x0E
    DESCRIPTOR = 0x60
    NAME = "gnss.receiver_safe_mode"
    _SIZE = 2

    receiver_id: int
    """Number of the receiver, from 1. Range: at least 1."""
    enable: int
    """1 switches safe mode on, 0 off. Range: 0 to 1."""

    def __init__(self, receiver_id: int, enable: int) -> None:
        self.receiver_id = receiver_id
        self.enable = enable

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.receiver_id, self.enable = _2B.unpack(raw, at)
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("receiver_id enable", self.receiver_id, self.enable)


ReceiverInfoResponse.COMMANDS = (ReceiverInfo,)
SignalConfigResponse.COMMANDS = (SignalConfig,)
RtkConfigResponse.COMMANDS = (RtkConfig,)
RtkDongleConfigResponse.COMMANDS = (RtkDongleConfig,)
SpartnConfigResponse.COMMANDS = (SpartnConfig,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (ReceiverInfo,),
    0x02: (SignalConfig,),
    0x03: (ReceiverReset,),
    0x04: (RtkConfig,),
    0x10: (RtkDongleConfig,),
    0x20: (SpartnConfig,),
    0x60: (ReceiverSafeMode,),
    0x81: (ReceiverInfoResponse,),
    0x82: (SignalConfigResponse,),
    0x84: (RtkConfigResponse,),
    0x90: (RtkDongleConfigResponse,),
    0xA0: (SpartnConfigResponse,),
}
