"""RTK commands (0x0F).

Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.

Uncertain: The SDK describes hardly any of this set; most descriptions are inferred from the names.
Uncertain: No source states how strings are padded or terminated.

- mip-sdk-4: Rtk Commands (0x0F)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types
from .field import ClassOf, Command, Field, R, Response, ResponseClasses
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_2I = codec.Block("2I")

_7BI = codec.Block("7BI")

_B = codec.Block("B")

_B2IQ = codec.Block("B2IQ")

_B2i = codec.Block("B2i")

_I = codec.Block("I")


class ConnectedDevice(codec.OpenEnum):
    """Type of device connected to a corrections modem.

    - mip-sdk-4: Connected Device Type (0x0F,0x06)
    """

    GENERIC = 0
    """Any device."""
    GQ7 = 1
    """3DM-GQ7."""


@codec.open_flag(8)
class ServiceFlags(IntFlag):
    """State of the correction service.

    - mip-sdk-4: Service Status (0x0F,0x0A)
    """

    THROTTLE = 1 << 0
    """The server limits the rate. Bit 0."""
    CORRECTIONS_UNAVAILABLE = 1 << 1
    """There are no corrections. Bit 1."""


class StorageMedium(codec.OpenEnum):
    """A storage medium of a corrections modem.

    - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
    """

    EXTERNAL_FLASH = 0
    """External flash memory."""
    SD = 1
    """SD card."""


class LedAction(codec.OpenEnum):
    """Pattern of an LED.

    - mip-sdk-4: Led Control (0x0F,0x21)
    """

    NONE = 0
    """No pattern."""
    FLASH = 1
    """Flashing."""
    PULSATE = 2
    """Pulsating."""


class GetStatusFlagsResponse(Response):
    """Get status flags response (0x0F,0x81).

    No device is known for certain to support it. Response to `GetStatusFlags`. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: Get status flags (0x0F,0x01)
    """

    __slots__ = ("flags",)
    __match_args__ = ("flags",)

    SET = 0x0F
    DESCRIPTOR = 0x81
    NAME = "rtk.get_status_flags_response"
    _SIZE = 4

    flags: types.RtkStatusFlags
    """State of the modem and of the corrections."""

    def __init__(self, flags: types.RtkStatusFlags) -> None:
        self.flags = flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.flags = codec.KNOWN[types.RtkStatusFlags][_I.unpack(raw, at)[0]]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("flags", self.flags)


class GetImeiResponse(Response):
    """Get IMEI response (0x0F,0x82).

    Response to `GetImei`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get IMEI (0x0F,0x02)
    """

    __slots__ = ("imei",)
    __match_args__ = ("imei",)

    SET = 0x0F
    DESCRIPTOR = 0x82
    NAME = "rtk.get_imei_response"

    imei: str
    """International mobile equipment identity."""

    def __init__(self, imei: str) -> None:
        self.imei = imei

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = 32
        self.imei = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.padded("imei", self.imei, 32)
        return codec.finished(out)


class GetImsiResponse(Response):
    """Get IMSI response (0x0F,0x83).

    Response to `GetImsi`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get IMSI (0x0F,0x03)
    """

    __slots__ = ("imsi",)
    __match_args__ = ("imsi",)

    SET = 0x0F
    DESCRIPTOR = 0x83
    NAME = "rtk.get_imsi_response"

    imsi: str
    """International mobile subscriber identity."""

    def __init__(self, imsi: str) -> None:
        self.imsi = imsi

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = 32
        self.imsi = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.padded("imsi", self.imsi, 32)
        return codec.finished(out)


class GetIccidResponse(Response):
    """Get ICCID response (0x0F,0x84).

    Response to `GetIccid`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get ICCID (0x0F,0x04)
    """

    __slots__ = ("iccid",)
    __match_args__ = ("iccid",)

    SET = 0x0F
    DESCRIPTOR = 0x84
    NAME = "rtk.get_iccid_response"

    iccid: str
    """Number of the SIM card."""

    def __init__(self, iccid: str) -> None:
        self.iccid = iccid

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = 32
        self.iccid = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.padded("iccid", self.iccid, 32)
        return codec.finished(out)


class GetRssiResponse(Response):
    """Get RSSI response (0x0F,0x85).

    Response to `GetRssi`. Known only from the MicroStrain MIP SDK. Uncertain: That `valid` applies
    to the other values is inferred.

    - mip-sdk-4: Get RSSI (0x0F,0x05)
    """

    __slots__ = ("valid", "rssi", "signal_quality")
    __match_args__ = ("valid", "rssi", "signal_quality")

    SET = 0x0F
    DESCRIPTOR = 0x85
    NAME = "rtk.get_rssi_response"
    _SIZE = 9

    valid: bool
    """True if the modem is connected."""
    rssi: int
    """Received signal strength. Valid if `valid` is true. Uncertain: No source states the unit; dBm
    is likely.
    """
    signal_quality: int
    """Quality of the modem's radio signal. Valid if `valid` is true. Uncertain: No source states
    the unit.
    """

    def __init__(self, valid: bool, rssi: int, signal_quality: int) -> None:
        self.valid = valid
        self.rssi = rssi
        self.signal_quality = signal_quality

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B2i.unpack(raw, at)
        self.valid = codec.TRUTH[v[0]]
        self.rssi = v[1]
        self.signal_quality = v[2]
        return at + 9

    def _write(self) -> bytes:
        return _B2i.write("valid rssi signal_quality", self.valid, self.rssi, self.signal_quality)


class ConnectedDeviceTypeResponse(Response):
    """Connected device type response (0x0F,0x86).

    Response to `ConnectedDeviceType`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Connected device type (0x0F,0x06)
    """

    __slots__ = ("device_type",)
    __match_args__ = ("device_type",)

    SET = 0x0F
    DESCRIPTOR = 0x86
    NAME = "rtk.connected_device_type_response"
    _SIZE = 1

    device_type: ConnectedDevice
    """Type of device that the modem is connected to."""

    def __init__(self, device_type: ConnectedDevice) -> None:
        self.device_type = device_type

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.device_type = codec.KNOWN[ConnectedDevice][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("device_type", self.device_type)


class GetActivationCodeResponse(Response):
    """Get activation code response (0x0F,0x87).

    No device is known for certain to support it. Also called `get_act_code_response`. Response to
    `GetActivationCode`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get Act Code (0x0F,0x07)
    """

    __slots__ = ("activation_code",)
    __match_args__ = ("activation_code",)

    SET = 0x0F
    DESCRIPTOR = 0x87
    NAME = "rtk.get_activation_code_response"

    activation_code: str
    """Code that activates the modem for its service."""

    def __init__(self, activation_code: str) -> None:
        self.activation_code = activation_code

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = 32
        self.activation_code = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.padded("activation_code", self.activation_code, 32)
        return codec.finished(out)


class GetModemFirmwareVersionResponse(Response):
    """Get modem firmware version response (0x0F,0x88).

    Response to `GetModemFirmwareVersion`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get modem firmware version (0x0F,0x08)
    """

    __slots__ = ("modem_firmware_version",)
    __match_args__ = ("modem_firmware_version",)

    SET = 0x0F
    DESCRIPTOR = 0x88
    NAME = "rtk.get_modem_firmware_version_response"

    modem_firmware_version: str
    """Firmware version of the modem, not of the dongle."""

    def __init__(self, modem_firmware_version: str) -> None:
        self.modem_firmware_version = modem_firmware_version

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = 32
        self.modem_firmware_version = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.padded("modem_firmware_version", self.modem_firmware_version, 32)
        return codec.finished(out)


class ServiceStatusResponse(Response):
    """Service status response (0x0F,0x8A).

    Connection status according to the server.

    Response to `ServiceStatus`. Known only from the MicroStrain MIP SDK. Uncertain: No source
    states what the counters count.

    - mip-sdk-4: Service status (0x0F,0x0A)
    """

    __slots__ = ("flags", "received_bytes", "last_bytes", "last_bytes_time")
    __match_args__ = ("flags", "received_bytes", "last_bytes", "last_bytes_time")

    SET = 0x0F
    DESCRIPTOR = 0x8A
    NAME = "rtk.service_status_response"
    _SIZE = 17

    flags: ServiceFlags
    """State of the service."""
    received_bytes: int
    """Number of correction bytes that the service has sent. Unit: byte."""
    last_bytes: int
    """Number of bytes in the last transfer. Unit: byte."""
    last_bytes_time: int
    """Time of the last transfer. Uncertain: No source states the unit and the epoch."""

    def __init__(
        self, flags: ServiceFlags, received_bytes: int, last_bytes: int, last_bytes_time: int
    ) -> None:
        self.flags = flags
        self.received_bytes = received_bytes
        self.last_bytes = last_bytes
        self.last_bytes_time = last_bytes_time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B2IQ.unpack(raw, at)
        self.flags = codec.KNOWN[ServiceFlags][v[0]]
        self.received_bytes = v[1]
        self.last_bytes = v[2]
        self.last_bytes_time = v[3]
        return at + 17

    def _write(self) -> bytes:
        return _B2IQ.write(
            "flags received_bytes last_bytes last_bytes_time",
            self.flags,
            self.received_bytes,
            self.last_bytes,
            self.last_bytes_time,
        )


class GetStatusFlags(Command[GetStatusFlagsResponse]):
    """Get status flags (0x0F,0x01).

    Gets the state of the modem and of the corrections.

    No device is known for certain to support it. Response: `GetStatusFlagsResponse`. Known only
    from the MicroStrain MIP SDK.

    The status word in the response has two forms: `types.RtkStatusFlags` if its `version` is not 0,
    and `types.RtkStatusFlagsLegacy` if it is.

    - mip-sdk-4: Get status flags (0x0F,0x01)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x01
    NAME = "rtk.get_status_flags"
    RESPONSES = (GetStatusFlagsResponse,)


class GetImei(Command[GetImeiResponse]):
    """Get IMEI (0x0F,0x02).

    Gets the identity of the modem.

    Response: `GetImeiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get IMEI (0x0F,0x02)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x02
    NAME = "rtk.get_imei"
    RESPONSES = (GetImeiResponse,)


class GetImsi(Command[GetImsiResponse]):
    """Get IMSI (0x0F,0x03).

    Gets the identity of the subscriber.

    Response: `GetImsiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get IMSI (0x0F,0x03)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x03
    NAME = "rtk.get_imsi"
    RESPONSES = (GetImsiResponse,)


class GetIccid(Command[GetIccidResponse]):
    """Get ICCID (0x0F,0x04).

    Gets the number of the SIM card.

    Response: `GetIccidResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get ICCID (0x0F,0x04)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x04
    NAME = "rtk.get_iccid"
    RESPONSES = (GetIccidResponse,)


class GetRssi(Command[GetRssiResponse]):
    """Get RSSI (0x0F,0x05).

    Gets the strength of the cellular signal.

    Response: `GetRssiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get RSSI (0x0F,0x05)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x05
    NAME = "rtk.get_rssi"
    RESPONSES = (GetRssiResponse,)


class ConnectedDeviceType(Command[R]):
    """Connected device type (0x0F,0x06).

    Sets the type of device that the modem is connected to.

    Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `ConnectedDeviceTypeResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Connected device type (0x0F,0x06)
    """

    __slots__ = ("function", "device_type")
    __match_args__ = ("function", "device_type")

    SET = 0x0F
    DESCRIPTOR = 0x06
    NAME = "rtk.connected_device_type"
    RESPONSES = (ConnectedDeviceTypeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    device_type: ConnectedDevice | None
    """Type of device that the modem is connected to. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, device_type: ConnectedDevice | None = None
    ) -> None:
        self.function = function
        self.device_type = device_type

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.device_type = codec.KNOWN[ConnectedDevice][_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "device_type"))
        out += _B.write("device_type", self.device_type) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ConnectedDeviceType[Any]], device_type: ConnectedDevice
    ) -> ConnectedDeviceType[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, device_type=device_type)

    @classmethod
    def read(
        cls: ClassOf[ConnectedDeviceType[Any]],
    ) -> ConnectedDeviceType[ConnectedDeviceTypeResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ConnectedDeviceType[Any]]) -> ConnectedDeviceType[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ConnectedDeviceType[Any]]) -> ConnectedDeviceType[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ConnectedDeviceType[Any]]) -> ConnectedDeviceType[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ConnectedDeviceTypeResponse,)
        return ()


class GetActivationCode(Command[GetActivationCodeResponse]):
    """Get activation code (0x0F,0x07).

    Reads the code that activates the modem for its service.

    No device is known for certain to support it. Also called `get_act_code`. Response:
    `GetActivationCodeResponse`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get Act Code (0x0F,0x07)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x07
    NAME = "rtk.get_activation_code"
    RESPONSES = (GetActivationCodeResponse,)


class GetModemFirmwareVersion(Command[GetModemFirmwareVersionResponse]):
    """Get modem firmware version (0x0F,0x08).

    Gets the firmware version of the cellular modem.

    Response: `GetModemFirmwareVersionResponse`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    - mip-sdk-4: Get modem firmware version (0x0F,0x08)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x08
    NAME = "rtk.get_modem_firmware_version"
    RESPONSES = (GetModemFirmwareVersionResponse,)


class ServiceStatus(Command[ServiceStatusResponse]):
    """Service status (0x0F,0x0A).

    Queries a correction server about the connection, which also keeps it open.

    Response: `ServiceStatusResponse`. Sent by the device; the host replies. Not listed in any
    device profile. Known only from the MicroStrain MIP SDK.

    The modem acts as the host and the server as the device.

    - mip-sdk-4: Service status (0x0F,0x0A)
    """

    __slots__ = ("reserved1", "reserved2")
    __match_args__ = ("reserved1", "reserved2")

    SET = 0x0F
    DESCRIPTOR = 0x0A
    NAME = "rtk.service_status"
    RESPONSES = (ServiceStatusResponse,)
    _SIZE = 8

    reserved1: int
    """Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed."""
    reserved2: int
    """Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed."""

    def __init__(self, reserved1: int = 0, reserved2: int = 0) -> None:
        self.reserved1 = reserved1
        self.reserved2 = reserved2

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.reserved1, self.reserved2 = _2I.unpack(raw, at)
        return at + 8

    def _write(self) -> bytes:
        return _2I.write("reserved1 reserved2", self.reserved1, self.reserved2)


class EraseStorage(Command[None]):
    """Erase storage (0x0F,0x20).

    Returns a storage medium to its raw state. Everything on it is erased.

    For advanced use. Also called `prod_erase_storage`. Not listed in any device profile. Known only
    from the MicroStrain MIP SDK.

    All stored data is lost. The command is for production. Accepted in calibration mode only.

    - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
    """

    __slots__ = ("media",)
    __match_args__ = ("media",)

    SET = 0x0F
    DESCRIPTOR = 0x20
    NAME = "rtk.erase_storage"
    _SIZE = 1

    media: StorageMedium
    """The medium."""

    def __init__(self, media: StorageMedium) -> None:
        self.media = media

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.media = codec.KNOWN[StorageMedium][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("media", self.media)


class LedControl(Command[None]):
    """LED control (0x0F,0x21).

    Sets the colours and the pattern of the LED.

    For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    Accepted in calibration mode and production test mode only.

    - mip-sdk-4: LED control (0x0F,0x21)
    """

    __slots__ = ("primary_color", "alternate_color", "action", "period")
    __match_args__ = ("primary_color", "alternate_color", "action", "period")

    SET = 0x0F
    DESCRIPTOR = 0x21
    NAME = "rtk.led_control"
    _SIZE = 11

    primary_color: tuple[int, int, int]
    """First colour. Uncertain: No source states the order of its parts; red, green, blue is likely.
    """
    alternate_color: tuple[int, int, int]
    """Second colour. Uncertain: No source states the order of its parts; red, green, blue is
    likely.
    """
    action: LedAction
    """Pattern."""
    period: int
    """Period of the pattern. Uncertain: No source states the unit; ms is likely."""

    def __init__(
        self,
        primary_color: Sequence[int],
        alternate_color: Sequence[int],
        action: LedAction,
        period: int,
    ) -> None:
        self.primary_color = codec.several(primary_color)
        self.alternate_color = codec.several(alternate_color)
        self.action = action
        self.period = period

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _7BI.unpack(raw, at)
        self.primary_color = v[:3]
        self.alternate_color = v[3:6]
        self.action = codec.KNOWN[LedAction][v[6]]
        self.period = v[7]
        return at + 11

    def _write(self) -> bytes:
        return _7BI.write(
            "primary_color*3 alternate_color*3 action period",
            *codec.exactly("primary_color", self.primary_color, 3),
            *codec.exactly("alternate_color", self.alternate_color, 3),
            self.action,
            self.period,
        )


class ModemHardReset(Command[None]):
    """Modem hard reset (0x0F,0x22).

    Clears the flash memory of the modem.

    For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    It wears out the flash memory; use it rarely. Accepted in calibration mode only.

    - mip-sdk-4: Modem hard reset (0x0F,0x22)
    """

    __slots__ = ()

    SET = 0x0F
    DESCRIPTOR = 0x22
    NAME = "rtk.modem_hard_reset"


GetStatusFlagsResponse.COMMANDS = (GetStatusFlags,)
GetImeiResponse.COMMANDS = (GetImei,)
GetImsiResponse.COMMANDS = (GetImsi,)
GetIccidResponse.COMMANDS = (GetIccid,)
GetRssiResponse.COMMANDS = (GetRssi,)
ConnectedDeviceTypeResponse.COMMANDS = (ConnectedDeviceType,)
GetActivationCodeResponse.COMMANDS = (GetActivationCode,)
GetModemFirmwareVersionResponse.COMMANDS = (GetModemFirmwareVersion,)
ServiceStatusResponse.COMMANDS = (ServiceStatus,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (GetStatusFlags,),
    0x02: (GetImei,),
    0x03: (GetImsi,),
    0x04: (GetIccid,),
    0x05: (GetRssi,),
    0x06: (ConnectedDeviceType,),
    0x07: (GetActivationCode,),
    0x08: (GetModemFirmwareVersion,),
    0x0A: (ServiceStatus,),
    0x20: (EraseStorage,),
    0x21: (LedControl,),
    0x22: (ModemHardReset,),
    0x81: (GetStatusFlagsResponse,),
    0x82: (GetImeiResponse,),
    0x83: (GetImsiResponse,),
    0x84: (GetIccidResponse,),
    0x85: (GetRssiResponse,),
    0x86: (ConnectedDeviceTypeResponse,),
    0x87: (GetActivationCodeResponse,),
    0x88: (GetModemFirmwareVersionResponse,),
    0x8A: (ServiceStatusResponse,),
}
