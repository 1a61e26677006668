"""RTK commands (0x0F).

Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.

Uncertain: The SDK describes hardly anything of this set; most descriptions follow from the names.
Uncertain: How the strings are padded or ended.

- mip-sdk-4: Rtk Commands (0x0F)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types
from .errors import Truncated
from .field import ClassOf, Command, Field, R, Response, ResponseClasses
from .protocol import FunctionSelector


class ConnectedDevice(codec.OpenEnum):
    """A device that a corrections modem serves.

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


_GET_STATUS_FLAGS_RESPONSE_0 = codec.Block("I", "flags")


class GetStatusFlagsResponse(Response):
    """Get status flags response (0x0F,0x81).

    Answers `GetStatusFlags`. Probably supported by 3DM-RTK. Known only from the MicroStrain MIP
    SDK.

    - mip-sdk-4: Get status flags (0x0F,0x01)
    """

    __slots__ = ("flags",)
    __match_args__ = ("flags",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x81
    NAME = "rtk.get_status_flags_response"
    ROLE = "response"
    _LAYOUT = (("flags", "I", types.RtkStatusFlags),)

    flags: types.RtkStatusFlags
    """State of the modem and of the corrections."""

    def __init__(self, flags: types.RtkStatusFlags) -> None:
        self.flags = flags

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetStatusFlagsResponse, int]:
        v = _GET_STATUS_FLAGS_RESPONSE_0.read(raw, at)
        at += 4
        flags = types.RtkStatusFlags(v[0])
        return cls(flags), at

    def _write(self) -> bytes:
        out = _GET_STATUS_FLAGS_RESPONSE_0.write(self.flags)
        return codec.finished(out)


class GetImeiResponse(Response):
    """Get IMEI response (0x0F,0x82).

    Answers `GetImei`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get IMEI (0x0F,0x02)
    """

    __slots__ = ("imei",)
    __match_args__ = ("imei",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x82
    NAME = "rtk.get_imei_response"
    ROLE = "response"

    imei: str
    """International mobile equipment identity."""

    def __init__(self, imei: str) -> None:
        self.imei = imei

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetImeiResponse, int]:
        imei = codec.take(raw, at, 32).decode("latin-1")
        at += 32
        return cls(imei), at

    def _write(self) -> bytes:
        out = codec.padded("imei", self.imei, 32)
        return codec.finished(out)


class GetImsiResponse(Response):
    """Get IMSI response (0x0F,0x83).

    Answers `GetImsi`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get IMSI (0x0F,0x03)
    """

    __slots__ = ("imsi",)
    __match_args__ = ("imsi",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x83
    NAME = "rtk.get_imsi_response"
    ROLE = "response"

    imsi: str
    """International mobile subscriber identity."""

    def __init__(self, imsi: str) -> None:
        self.imsi = imsi

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetImsiResponse, int]:
        imsi = codec.take(raw, at, 32).decode("latin-1")
        at += 32
        return cls(imsi), at

    def _write(self) -> bytes:
        out = codec.padded("imsi", self.imsi, 32)
        return codec.finished(out)


class GetIccidResponse(Response):
    """Get ICCID response (0x0F,0x84).

    Answers `GetIccid`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get ICCID (0x0F,0x04)
    """

    __slots__ = ("iccid",)
    __match_args__ = ("iccid",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x84
    NAME = "rtk.get_iccid_response"
    ROLE = "response"

    iccid: str
    """Number of the SIM card."""

    def __init__(self, iccid: str) -> None:
        self.iccid = iccid

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetIccidResponse, int]:
        iccid = codec.take(raw, at, 32).decode("latin-1")
        at += 32
        return cls(iccid), at

    def _write(self) -> bytes:
        out = codec.padded("iccid", self.iccid, 32)
        return codec.finished(out)


_GET_RSSI_RESPONSE_0 = codec.Block("Bii", "valid", "rssi", "signal_quality")


class GetRssiResponse(Response):
    """Get RSSI response (0x0F,0x85).

    Answers `GetRssi`. Known only from the MicroStrain MIP SDK. Uncertain: That `valid` applies to
    the other values is inferred.

    - mip-sdk-4: Get RSSI (0x0F,0x05)
    """

    __slots__ = ("valid", "rssi", "signal_quality")
    __match_args__ = ("valid", "rssi", "signal_quality")

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x85
    NAME = "rtk.get_rssi_response"
    ROLE = "response"
    _LAYOUT = (("valid", "B", codec.truth), ("rssi", "i", None), ("signal_quality", "i", None))

    valid: bool
    """True if the modem is connected."""
    rssi: int
    """Received signal strength. Valid if `valid` is true. Uncertain: The unit; dBm is likely."""
    signal_quality: int
    """Quality of the modem's radio signal. Valid if `valid` is true. Uncertain: The unit."""

    def __init__(self, valid: bool, rssi: int, signal_quality: int) -> None:
        self.valid = valid
        self.rssi = rssi
        self.signal_quality = signal_quality

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetRssiResponse, int]:
        v = _GET_RSSI_RESPONSE_0.read(raw, at)
        at += 9
        valid = codec.truth(v[0])
        rssi = v[1]
        signal_quality = v[2]
        return cls(valid, rssi, signal_quality), at

    def _write(self) -> bytes:
        out = _GET_RSSI_RESPONSE_0.write(self.valid, self.rssi, self.signal_quality)
        return codec.finished(out)


_CONNECTED_DEVICE_TYPE_RESPONSE_0 = codec.Block("B", "device_type")


class ConnectedDeviceTypeResponse(Response):
    """Connected device type response (0x0F,0x86).

    Answers `ConnectedDeviceType`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Connected device type (0x0F,0x06)
    """

    __slots__ = ("device_type",)
    __match_args__ = ("device_type",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x86
    NAME = "rtk.connected_device_type_response"
    ROLE = "response"
    _LAYOUT = (("device_type", "B", ConnectedDevice),)

    device_type: ConnectedDevice
    """Device that the modem is connected to."""

    def __init__(self, device_type: ConnectedDevice) -> None:
        self.device_type = device_type

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ConnectedDeviceTypeResponse, int]:
        v = _CONNECTED_DEVICE_TYPE_RESPONSE_0.read(raw, at)
        at += 1
        device_type = ConnectedDevice(v[0])
        return cls(device_type), at

    def _write(self) -> bytes:
        out = _CONNECTED_DEVICE_TYPE_RESPONSE_0.write(self.device_type)
        return codec.finished(out)


class GetActivationCodeResponse(Response):
    """Get activation code response (0x0F,0x87).

    Also called `get_act_code_response`. Answers `GetActivationCode`. Probably supported by 3DM-RTK.
    Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get Act Code (0x0F,0x07)
    """

    __slots__ = ("activation_code",)
    __match_args__ = ("activation_code",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x87
    NAME = "rtk.get_activation_code_response"
    ROLE = "response"

    activation_code: str
    """Code with which the modem is activated for its service."""

    def __init__(self, activation_code: str) -> None:
        self.activation_code = activation_code

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetActivationCodeResponse, int]:
        activation_code = codec.take(raw, at, 32).decode("latin-1")
        at += 32
        return cls(activation_code), at

    def _write(self) -> bytes:
        out = codec.padded("activation_code", self.activation_code, 32)
        return codec.finished(out)


class GetModemFirmwareVersionResponse(Response):
    """Get modem firmware version response (0x0F,0x88).

    Answers `GetModemFirmwareVersion`. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get modem firmware version (0x0F,0x08)
    """

    __slots__ = ("modem_firmware_version",)
    __match_args__ = ("modem_firmware_version",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x88
    NAME = "rtk.get_modem_firmware_version_response"
    ROLE = "response"

    modem_firmware_version: str
    """Firmware version of the modem, not of the dongle."""

    def __init__(self, modem_firmware_version: str) -> None:
        self.modem_firmware_version = modem_firmware_version

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetModemFirmwareVersionResponse, int]:
        modem_firmware_version = codec.take(raw, at, 32).decode("latin-1")
        at += 32
        return cls(modem_firmware_version), at

    def _write(self) -> bytes:
        out = codec.padded("modem_firmware_version", self.modem_firmware_version, 32)
        return codec.finished(out)


_SERVICE_STATUS_RESPONSE_0 = codec.Block(
    "BIIQ", "flags", "received_bytes", "last_bytes", "last_bytes_time"
)


class ServiceStatusResponse(Response):
    """Service status response (0x0F,0x8A).

    Connection status according to the server.

    Answers `ServiceStatus`. Known only from the MicroStrain MIP SDK. Uncertain: What the counters
    count.

    - mip-sdk-4: Service status (0x0F,0x0A)
    """

    __slots__ = ("flags", "received_bytes", "last_bytes", "last_bytes_time")
    __match_args__ = ("flags", "received_bytes", "last_bytes", "last_bytes_time")

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x8A
    NAME = "rtk.service_status_response"
    ROLE = "response"
    _LAYOUT = (
        ("flags", "B", ServiceFlags),
        ("received_bytes", "I", None),
        ("last_bytes", "I", None),
        ("last_bytes_time", "Q", None),
    )

    flags: ServiceFlags
    """State of the service."""
    received_bytes: int
    """Bytes of corrections that the service has sent. Unit: byte."""
    last_bytes: int
    """Bytes of the last transfer. Unit: byte."""
    last_bytes_time: int
    """Time of the last transfer. Uncertain: The unit and the epoch."""

    def __init__(
        self, flags: ServiceFlags, received_bytes: int, last_bytes: int, last_bytes_time: int
    ) -> None:
        self.flags = flags
        self.received_bytes = received_bytes
        self.last_bytes = last_bytes
        self.last_bytes_time = last_bytes_time

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ServiceStatusResponse, int]:
        v = _SERVICE_STATUS_RESPONSE_0.read(raw, at)
        at += 17
        flags = ServiceFlags(v[0])
        received_bytes = v[1]
        last_bytes = v[2]
        last_bytes_time = v[3]
        return cls(flags, received_bytes, last_bytes, last_bytes_time), at

    def _write(self) -> bytes:
        out = _SERVICE_STATUS_RESPONSE_0.write(
            self.flags, self.received_bytes, self.last_bytes, self.last_bytes_time
        )
        return codec.finished(out)


class GetStatusFlags(Command[GetStatusFlagsResponse]):
    """Get status flags (0x0F,0x01).

    Gets the state of the modem and of the corrections.

    Answered by `GetStatusFlagsResponse`. Flagged by
    `types.Gq7ContinuousBuiltInTest.RTK_DONGLE_FAULT` of `types.Gq7ContinuousBuiltInTest`. Probably
    supported by 3DM-RTK. Known only from the MicroStrain MIP SDK.

    The word of the response has two forms, `types.RtkStatusFlags` and `types.RtkStatusFlagsLegacy`.

    - mip-sdk-4: Get status flags (0x0F,0x01)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x01
    NAME = "rtk.get_status_flags"
    ROLE = "command"
    RESPONSES = (GetStatusFlagsResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetStatusFlags, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


class GetImei(Command[GetImeiResponse]):
    """Get IMEI (0x0F,0x02).

    Gets the identity of the modem.

    Answered by `GetImeiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get IMEI (0x0F,0x02)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x02
    NAME = "rtk.get_imei"
    ROLE = "command"
    RESPONSES = (GetImeiResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetImei, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


class GetImsi(Command[GetImsiResponse]):
    """Get IMSI (0x0F,0x03).

    Gets the identity of the subscriber.

    Answered by `GetImsiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get IMSI (0x0F,0x03)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x03
    NAME = "rtk.get_imsi"
    ROLE = "command"
    RESPONSES = (GetImsiResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetImsi, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


class GetIccid(Command[GetIccidResponse]):
    """Get ICCID (0x0F,0x04).

    Gets the number of the SIM card.

    Answered by `GetIccidResponse`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: Get ICCID (0x0F,0x04)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x04
    NAME = "rtk.get_iccid"
    ROLE = "command"
    RESPONSES = (GetIccidResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetIccid, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


class GetRssi(Command[GetRssiResponse]):
    """Get RSSI (0x0F,0x05).

    Gets the strength of the cellular signal.

    Answered by `GetRssiResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Get RSSI (0x0F,0x05)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x05
    NAME = "rtk.get_rssi"
    ROLE = "command"
    RESPONSES = (GetRssiResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetRssi, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


_CONNECTED_DEVICE_TYPE_0 = codec.Block("B", "function")
_CONNECTED_DEVICE_TYPE_1 = codec.Block("B", "device_type")
_CONNECTED_DEVICE_TYPE_GROUPS = ((1, ("device_type",), False),)


class ConnectedDeviceType(Command[R]):
    """Connected device type (0x0F,0x06).

    Sets the device that the modem serves.

    Functions: `write`, `read`, `save`, `load` and `default`. Answered by
    `ConnectedDeviceTypeResponse`. Not listed in any device profile. Known only from the MicroStrain
    MIP SDK.

    - mip-sdk-4: Connected device type (0x0F,0x06)
    """

    __slots__ = ("function", "device_type")
    __match_args__ = ("function", "device_type")

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x06
    NAME = "rtk.connected_device_type"
    ROLE = "command"
    RESPONSES = (ConnectedDeviceTypeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    device_type: ConnectedDevice | None
    """Device that the modem is connected to. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, device_type: ConnectedDevice | None = None
    ) -> None:
        self.function = function
        self.device_type = device_type

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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ConnectedDeviceType[R], int]:
        device_type: ConnectedDevice | None = None
        v = _CONNECTED_DEVICE_TYPE_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _CONNECTED_DEVICE_TYPE_1.read(raw, at)
            at += 1
            device_type = ConnectedDevice(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, device_type), at

    def _write(self) -> bytes:
        out = _CONNECTED_DEVICE_TYPE_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _CONNECTED_DEVICE_TYPE_GROUPS)
        if there >= 1:
            out += _CONNECTED_DEVICE_TYPE_1.write(self.device_type)
        return codec.finished(out)


class GetActivationCode(Command[GetActivationCodeResponse]):
    """Get activation code (0x0F,0x07).

    Reads the code with which the modem is activated for its service.

    Also called `get_act_code`. Answered by `GetActivationCodeResponse`. Probably supported by
    3DM-RTK. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Get Act Code (0x0F,0x07)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x07
    NAME = "rtk.get_activation_code"
    ROLE = "command"
    RESPONSES = (GetActivationCodeResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetActivationCode, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


class GetModemFirmwareVersion(Command[GetModemFirmwareVersionResponse]):
    """Get modem firmware version (0x0F,0x08).

    Gets the firmware version of the cellular modem.

    Answered by `GetModemFirmwareVersionResponse`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    - mip-sdk-4: Get modem firmware version (0x0F,0x08)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x08
    NAME = "rtk.get_modem_firmware_version"
    ROLE = "command"
    RESPONSES = (GetModemFirmwareVersionResponse,)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GetModemFirmwareVersion, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


_SERVICE_STATUS_0 = codec.Block("II", "reserved1", "reserved2")


class ServiceStatus(Command[ServiceStatusResponse]):
    """Service status (0x0F,0x0A).

    Queries a correction server about the connection, which also keeps it open.

    Answered by `ServiceStatusResponse`. Sent by the device; the host answers. Not listed in any
    device profile. Known only from the MicroStrain MIP SDK.

    The modem sends it as a host would, and the server answers as a device would.

    - mip-sdk-4: Service status (0x0F,0x0A)
    """

    __slots__ = ("reserved1", "reserved2")
    __match_args__ = ("reserved1", "reserved2")

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x0A
    NAME = "rtk.service_status"
    ROLE = "command"
    RESPONSES = (ServiceStatusResponse,)
    _LAYOUT = (("reserved1", "I", None), ("reserved2", "I", None))

    reserved1: int
    """Reserved: send 0. Uncertain: What the modem sends; 0 is assumed."""
    reserved2: int
    """Reserved: send 0. Uncertain: What the modem sends; 0 is assumed."""

    def __init__(self, reserved1: int = 0, reserved2: int = 0) -> None:
        self.reserved1 = reserved1
        self.reserved2 = reserved2

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ServiceStatus, int]:
        v = _SERVICE_STATUS_0.read(raw, at)
        at += 8
        reserved1 = v[0]
        reserved2 = v[1]
        return cls(reserved1, reserved2), at

    def _write(self) -> bytes:
        out = _SERVICE_STATUS_0.write(self.reserved1, self.reserved2)
        return codec.finished(out)


_ERASE_STORAGE_0 = codec.Block("B", "media")


class EraseStorage(Command[None]):
    """Erase storage (0x0F,0x20).

    Returns a storage medium to its raw state; everything on it is erased.

    For advanced use. Also called `prod_erase_storage`. Not listed in any device profile. Known only
    from the MicroStrain MIP SDK.

    All stored data is lost. The command is for production. Accepted in calibration mode only.

    - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
    """

    __slots__ = ("media",)
    __match_args__ = ("media",)

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x20
    NAME = "rtk.erase_storage"
    ROLE = "command"
    _LAYOUT = (("media", "B", StorageMedium),)

    media: StorageMedium
    """The medium."""

    def __init__(self, media: StorageMedium) -> None:
        self.media = media

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[EraseStorage, int]:
        v = _ERASE_STORAGE_0.read(raw, at)
        at += 1
        media = StorageMedium(v[0])
        return cls(media), at

    def _write(self) -> bytes:
        out = _ERASE_STORAGE_0.write(self.media)
        return codec.finished(out)


_LED_CONTROL_0 = codec.Block(
    "BBBBBBBI", *["primary_color"] * 3, *["alternate_color"] * 3, "action", "period"
)


class LedControl(Command[None]):
    """LED control (0x0F,0x21).

    Sets the colours and the pattern of the LED.

    For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    Only in calibration mode or production test mode; otherwise it is rejected.

    - mip-sdk-4: LED control (0x0F,0x21)
    """

    __slots__ = ("primary_color", "alternate_color", "action", "period")
    __match_args__ = ("primary_color", "alternate_color", "action", "period")

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x21
    NAME = "rtk.led_control"
    ROLE = "command"
    _LAYOUT = (
        ("primary_color", "BBB", tuple),
        ("alternate_color", "BBB", tuple),
        ("action", "B", LedAction),
        ("period", "I", None),
    )

    primary_color: tuple[int, int, int]
    """First colour. Uncertain: The order of its parts; red, green, blue is likely."""
    alternate_color: tuple[int, int, int]
    """Second colour. Uncertain: The order of its parts; red, green, blue is likely."""
    action: LedAction
    """Pattern."""
    period: int
    """Period of the pattern. Uncertain: The unit; ms is likely."""

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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[LedControl, int]:
        v = _LED_CONTROL_0.read(raw, at)
        at += 11
        primary_color = v[0:3]
        alternate_color = v[3:6]
        action = LedAction(v[6])
        period = v[7]
        return cls(primary_color, alternate_color, action, period), at

    def _write(self) -> bytes:
        out = _LED_CONTROL_0.write(
            *codec.exactly("primary_color", self.primary_color, 3),
            *codec.exactly("alternate_color", self.alternate_color, 3),
            self.action,
            self.period,
        )
        return codec.finished(out)


class ModemHardReset(Command[None]):
    """Modem hard reset (0x0F,0x22).

    Clears the flash memory of the modem.

    For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    It wears out the flash memory; use it rarely. Accepted in calibration mode only.

    - mip-sdk-4: Modem hard reset (0x0F,0x22)
    """

    __slots__ = ()

    SET = 0x0F
    SETS = (0x0F,)
    DESCRIPTOR = 0x22
    NAME = "rtk.modem_hard_reset"
    ROLE = "command"

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ModemHardReset, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


GetStatusFlagsResponse.COMMANDS = (GetStatusFlags,)
GetImeiResponse.COMMANDS = (GetImei,)
GetImsiResponse.COMMANDS = (GetImsi,)
GetIccidResponse.COMMANDS = (GetIccid,)
GetRssiResponse.COMMANDS = (GetRssi,)
ConnectedDeviceTypeResponse.COMMANDS = (ConnectedDeviceType,)
GetActivationCodeResponse.COMMANDS = (GetActivationCode,)
GetModemFirmwareVersionResponse.COMMANDS = (GetModemFirmwareVersion,)
ServiceStatusResponse.COMMANDS = (ServiceStatus,)

#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
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
