"""GNSS commands (0x0E).

Commands that describe and set up the internal GNSS receivers.

- 3dm-cv7-gnss-ins: GNSS (0x0E)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, wire
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector


class ReceiverInfoEntry(Structure):
    """Description of a GNSS receiver.

    - 3dm-cv7-gnss-ins: Info
    - mip-sdk-4: Receiver Info (0x0E,0x01)
    """

    __slots__ = ("receiver_id", "mip_data_descriptor_set", "description")
    __match_args__ = ("receiver_id", "mip_data_descriptor_set", "description")

    _LAYOUT = (
        ("receiver_id", "B", None),
        ("mip_data_descriptor_set", "B", None),
        ("description", "", wire.Text(32, 32)),
    )

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
    """Restarts the positioning engine only. Uncertain: The name. An earlier branch of the SDK calls
    3 hot and 4 warm, with the same descriptions of the two numbers; GNSS receivers usually keep
    their satellite data in a hot start and lose it in a warm one.
    """
    HOT = 4
    """Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: The name,
    which an earlier branch of the SDK swaps with that of 3.
    """


class AmbiguityFixMode(codec.OpenEnum):
    """Strategy for fixing the RTK carrier phase ambiguities to whole numbers. Uncertain: The
    descriptions of `conservative` and `moderate`, which are inferred from the names.

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

    Response to `ReceiverInfo`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
    """

    __slots__ = ("receiver_info",)
    __match_args__ = ("receiver_info",)

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x81
    NAME = "gnss.receiver_info_response"
    ROLE = "response"
    _LAYOUT = (
        ("num_receivers", "B", wire.Counts("receiver_info", 7)),
        ("receiver_info", "", wire.Items(ReceiverInfoEntry, "num_receivers", 7)),
    )

    # On the wire only: num_receivers. Number of physical receivers. Counts the elements of
    # `receiver_info`.
    receiver_info: tuple[ReceiverInfoEntry, ...]
    """One entry for each receiver."""

    def __init__(self, receiver_info: Sequence[ReceiverInfoEntry]) -> None:
        self.receiver_info = codec.several(receiver_info)


class SignalConfigResponse(Response):
    """Signal configuration response (0x0E,0x82).

    Also called `signal_configuration_response`. Response to `SignalConfig`. Supported by
    3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
    - 3dm-cv7-gnss-ins: GNSS
    """

    __slots__ = ("gps_enable", "glonass_enable", "galileo_enable", "beidou_enable", "reserved")
    __match_args__ = ("gps_enable", "glonass_enable", "galileo_enable", "beidou_enable", "reserved")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x82
    NAME = "gnss.signal_config_response"
    ROLE = "response"
    _LAYOUT = (
        ("gps_enable", "B", GpsSignals),
        ("glonass_enable", "B", GlonassSignals),
        ("galileo_enable", "B", GalileoSignals),
        ("beidou_enable", "B", BeidouSignals),
        ("reserved", "BBBB", tuple),
    )

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


class RtkConfigResponse(Response):
    """RTK configuration response (0x0E,0x84).

    Also called `rtk_configuration_response`. Response to `RtkConfig`. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: RTK configuration (0x0E,0x04)
    """

    __slots__ = ("ambiguity_fix_mode", "reserved")
    __match_args__ = ("ambiguity_fix_mode", "reserved")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x84
    NAME = "gnss.rtk_config_response"
    ROLE = "response"
    _LAYOUT = (("ambiguity_fix_mode", "B", AmbiguityFixMode), ("reserved", "BBBB", tuple))

    ambiguity_fix_mode: AmbiguityFixMode
    """Strategy for fixing ambiguities."""
    reserved: tuple[int, int, int, int]
    """Reserved."""

    def __init__(
        self, ambiguity_fix_mode: AmbiguityFixMode, reserved: Sequence[int] = (0, 0, 0, 0)
    ) -> None:
        self.ambiguity_fix_mode = ambiguity_fix_mode
        self.reserved = codec.several(reserved)


class RtkDongleConfigResponse(Response):
    """RTK dongle configuration response (0x0E,0x90).

    No device is known for certain to support it. Also called `rtk_dongle_configuration_response`.
    Response to `RtkDongleConfig`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
    """

    __slots__ = ("enable", "reserved")
    __match_args__ = ("enable", "reserved")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x90
    NAME = "gnss.rtk_dongle_config_response"
    ROLE = "response"
    _LAYOUT = (("enable", "B", None), ("reserved", "BBB", tuple))

    enable: int
    """1 enables the dongle, 0 disables it. Range: 0 to 1."""
    reserved: tuple[int, int, int]
    """Reserved. Uncertain: What to send; 0 is assumed."""

    def __init__(self, enable: int, reserved: Sequence[int] = (0, 0, 0)) -> None:
        self.enable = enable
        self.reserved = codec.several(reserved)


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
    SETS = (0x0E,)
    DESCRIPTOR = 0xA0
    NAME = "gnss.spartn_config_response"
    ROLE = "response"
    _LAYOUT = (
        ("enable", "B", None),
        ("type", "B", SpartnConnection),
        ("current_key_tow", "I", None),
        ("current_key_week", "H", None),
        ("current_key", "BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB", tuple),
        ("next_key_tow", "I", None),
        ("next_key_week", "H", None),
        ("next_key", "BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB", tuple),
    )

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


class ReceiverInfo(Command[ReceiverInfoResponse]):
    """Receiver info (0x0E,0x01).

    Gets the GNSS receivers of the device.

    Response: `ReceiverInfoResponse`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
    """

    __slots__ = ()

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x01
    NAME = "gnss.receiver_info"
    ROLE = "command"
    RESPONSES = (ReceiverInfoResponse,)


class SignalConfig(Command[R]):
    """Signal configuration (0x0E,0x02).

    Selects the GNSS signals that the device uses.

    Also called `signal_configuration`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `SignalConfigResponse`. Probably changes `gnss_data.FixInfo`,
    `gnss_data.SatelliteStatus` and `gnss_data.Raw`. Supported by 3DM-CV7-GNSS/INS. On the
    3DM-GQ7-GNSS/INS: firmware > 1.0.10.

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
    SETS = (0x0E,)
    DESCRIPTOR = 0x02
    NAME = "gnss.signal_config"
    ROLE = "command"
    RESPONSES = (SignalConfigResponse,)
    REQUIRED = {1: 5, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("gps_enable", "B", GpsSignals),
        ("glonass_enable", "B", GlonassSignals),
        ("galileo_enable", "B", GalileoSignals),
        ("beidou_enable", "B", BeidouSignals),
        ("reserved", "BBBB", tuple),
    )
    _ALWAYS = 1

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

    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Which
    devices support it. The SDK does not name any.

    Only internal receivers can be reset. Some devices do not support all reset types.

    - mip-sdk-4: Receiver reset (0x0E,0x03)
    """

    __slots__ = ("receiver_id", "reset_type")
    __match_args__ = ("receiver_id", "reset_type")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x03
    NAME = "gnss.receiver_reset"
    ROLE = "command"
    _LAYOUT = (("receiver_id", "B", ReceiverId), ("reset_type", "B", ReceiverResetType))

    receiver_id: ReceiverId
    """Receiver to reset."""
    reset_type: ReceiverResetType
    """Extent of the restart."""

    def __init__(self, receiver_id: ReceiverId, reset_type: ReceiverResetType) -> None:
        self.receiver_id = receiver_id
        self.reset_type = reset_type


class RtkConfig(Command[R]):
    """RTK configuration (0x0E,0x04).

    Sets how readily the device fixes the ambiguities of an RTK solution.

    Also called `rtk_configuration`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `RtkConfigResponse`. Probably changes `gnss_data.FixInfo` and `gnss_data.LlhPosition`.
    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Which
    devices support it. Users of the vendor's ROS driver report it as experimental on the 3DM-GQ7,
    which accepts `conservative` only.

    The available modes differ by device.

    - mip-sdk-4: RTK configuration (0x0E,0x04)
    """

    __slots__ = ("function", "ambiguity_fix_mode", "reserved")
    __match_args__ = ("function", "ambiguity_fix_mode", "reserved")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x04
    NAME = "gnss.rtk_config"
    ROLE = "command"
    RESPONSES = (RtkConfigResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("ambiguity_fix_mode", "B", AmbiguityFixMode),
        ("reserved", "BBBB", tuple),
    )
    _ALWAYS = 1

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
    changes `gnss_data.RtkCorrectionsStatus`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
    """

    __slots__ = ("function", "enable", "reserved")
    __match_args__ = ("function", "enable", "reserved")

    SET = 0x0E
    SETS = (0x0E,)
    DESCRIPTOR = 0x10
    NAME = "gnss.rtk_dongle_config"
    ROLE = "command"
    RESPONSES = (RtkDongleConfigResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("enable", "B", None),
        ("reserved", "BBB", tuple),
    )
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    enable: int | None
    """1 enables the dongle, 0 disables it. Range: 0 to 1. Required for `write`."""
    reserved: tuple[int, int, int] | None
    """Reserved: send 0. Required for `write`. Uncertain: What to send; 0 is assumed."""

    def __init__(
        self,
        function: FunctionSelector,
        enable: int | None = None,
        reserved: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.enable = enable
        self.reserved = codec.several(reserved)

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
    Response: `SpartnConfigResponse`. Probably changes `gnss_data.RtkCorrectionsStatus`. Supported
    by 3DM-CV7-GNSS/INS. Uncertain: Whether the device accepts upper and lower case. The section on
    UART uses the digits 0-9 and A-F, the description of the command uses "bc" for 0xBC.

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
    SETS = (0x0E,)
    DESCRIPTOR = 0x20
    NAME = "gnss.spartn_config"
    ROLE = "command"
    RESPONSES = (SpartnConfigResponse,)
    REQUIRED = {1: 8, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("enable", "B", None),
        ("type", "B", SpartnConnection),
        ("current_key_tow", "I", None),
        ("current_key_week", "H", None),
        ("current_key", "BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB", tuple),
        ("next_key_tow", "I", None),
        ("next_key_week", "H", None),
        ("next_key", "BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB", tuple),
    )
    _ALWAYS = 1

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
    0x81: (ReceiverInfoResponse,),
    0x82: (SignalConfigResponse,),
    0x84: (RtkConfigResponse,),
    0x90: (RtkDongleConfigResponse,),
    0xA0: (SpartnConfigResponse,),
}
