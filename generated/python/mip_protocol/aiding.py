"""Aiding commands (0x13).

Measurements of external sensors for the navigation filter, and the frames of the sensors.

- 3dm-cv7-gnss-ins: Aiding (0x13)
- 3dm-cv7-gnss-ins: Filter Aiding Measurements
"""

from __future__ import annotations

from enum import IntFlag
from typing import Any

from . import codec, types
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_2B = codec.Block("2B")

_2BQ = codec.Block("2BQ")

_3B3f = codec.Block("3B3f")

_3f = codec.Block("3f")

_4f = codec.Block("4f")

_B = codec.Block("B")

_B2fH = codec.Block("B2fH")

_B3d3fH = codec.Block("B3d3fH")

_B6fH = codec.Block("B6fH")


class AidingFrameFormat(codec.OpenEnum):
    """Format of the rotation of an aiding frame.

    - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
    """

    EULER = 1
    """Euler angles: roll, pitch, yaw."""
    QUATERNION = 2
    """Quaternion: w, x, y, z."""


class AidingEchoMode(codec.OpenEnum):
    """Replies of the device to aiding measurements.

    - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
    """

    SUPPRESS_ACK = 0
    """No acknowledge."""
    STANDARD = 1
    """ACK, as for any command."""
    RESPONSE = 2
    """The data is returned in a response."""


class Timebase(codec.OpenEnum):
    """Clock that the time of a measurement refers to."""

    INTERNAL_REFERENCE = 1
    """Internal reference clock of the device."""
    EXTERNAL_TIME = 2
    """External clock, to which the PPS synchronizes the device."""
    TIME_OF_ARRIVAL = 3
    """Latency relative to the arrival of the command."""


class MeasurementTime(Structure):
    """Time at which a measurement was taken."""

    __slots__ = ("timebase", "reserved", "nanoseconds")
    __match_args__ = ("timebase", "nanoseconds")

    _SIZE = 10

    timebase: Timebase
    """Clock that the time refers to."""
    reserved: int
    """Reserved: send 1."""
    nanoseconds: int
    """Time by that clock. Unit: ns."""

    def __init__(self, timebase: Timebase, nanoseconds: int, *, reserved: int = 1) -> None:
        self.timebase = timebase
        self.reserved = reserved
        self.nanoseconds = nanoseconds

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BQ.unpack(raw, at)
        self.timebase = codec.KNOWN[Timebase][v[0]]
        self.reserved = v[1]
        self.nanoseconds = v[2]
        return at + 10

    def _write(self) -> bytes:
        return _2BQ.write(
            "timebase reserved nanoseconds", self.timebase, self.reserved, self.nanoseconds
        )


@codec.open_flag(16)
class AxisFlags(IntFlag):
    """Valid axes of a measurement; the others are ignored."""

    X = 1 << 0
    """First axis. Bit 0."""
    Y = 1 << 1
    """Second axis. Bit 1."""
    Z = 1 << 2
    """Third axis. Bit 2."""


@codec.open_flag(16)
class LlhAxisFlags(IntFlag):
    """Valid coordinates of a position; the others are ignored."""

    LATITUDE = 1 << 0
    """Latitude and its uncertainty are valid. Bit 0."""
    LONGITUDE = 1 << 1
    """Longitude and its uncertainty are valid. Bit 1."""
    HEIGHT = 1 << 2
    """Height and its uncertainty are valid. Bit 2."""


class FrameConfigResponse(Response):
    """Frame configuration response (0x13,0x81).

    Response to `FrameConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
    3DM-CV7-INS; likely or assumed on 7 more.

    - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
    - 3dm-cv7-gnss-ins: Aiding Frames
    """

    __slots__ = ("frame_id", "format", "tracking_enabled", "translation", "rotation")
    __match_args__ = ("frame_id", "format", "tracking_enabled", "translation", "rotation")

    SET = 0x13
    DESCRIPTOR = 0x81
    NAME = "aiding.frame_config_response"
    _VECTORS = {"translation": (types.Vector3f,), "rotation": (types.Vector3f, types.Quatf)}

    frame_id: int
    """Number of the frame. Range: 1 to 4."""
    format: AidingFrameFormat
    """Format of the rotation."""
    tracking_enabled: bool
    """True if the filter estimates the errors of the frame."""
    translation: types.Vector3f
    """Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame:
    vehicle.
    """
    rotation: types.Vector3f | types.Quatf | None
    """Rotates vectors of this frame into the vehicle frame. Selected by `format`.

    - If `format` is `AidingFrameFormat.EULER`: `types.Vector3f`. Roll, pitch and yaw of the frame
      relative to the vehicle; positive are right side down, nose up, and clockwise seen from above.
      Elements: x, y, z. Unit: rad. Frame: vehicle. Range: -pi to pi.
    - If `format` is `AidingFrameFormat.QUATERNION`: `types.Quatf`. Quaternion, scalar part first.
      Elements: w, x, y, z. Unit: 1.
    """

    def __init__(
        self,
        frame_id: int,
        format: AidingFrameFormat,
        tracking_enabled: bool,
        translation: types.Vector3f | codec.Numbers,
        rotation: types.Vector3f | types.Quatf | None | codec.Numbers = None,
    ) -> None:
        self.frame_id = frame_id
        self.format = format
        self.tracking_enabled = tracking_enabled
        self.translation = codec.vector(translation, types.Vector3f)
        self.rotation = codec.vector(rotation, types.Vector3f, types.Quatf)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3B3f.read(raw, at)
        self.frame_id = v[0]
        self.format = codec.KNOWN[AidingFrameFormat][v[1]]
        self.tracking_enabled = codec.TRUTH[v[2]]
        self._translation = v[3:6]
        at += 15
        self._rotation = None
        if self.format == 1:
            self._rotation = types.Vector3f._make(_3f.read(raw, at))
            at += 12
        if self.format == 2:
            self._rotation = types.Quatf._make(_4f.read(raw, at))
            at += 16
        return at

    def _write(self) -> bytes:
        out = _3B3f.write(
            "frame_id format tracking_enabled translation*3",
            self.frame_id,
            self.format,
            self.tracking_enabled,
            *codec.elements("translation", self.translation, 3),
        )
        if self.format == 1:
            codec.check_selected("rotation", self.rotation, self.format, None)
            out += _3f.write("rotation*3", *codec.elements("rotation", self.rotation, 3))
        elif self.format == 2:
            codec.check_selected("rotation", self.rotation, self.format, None)
            out += _4f.write("rotation*4", *codec.elements("rotation", self.rotation, 4))
        else:
            codec.check_unselected("rotation", self.rotation, self.format)
        return codec.finished(out)


class SensorFrameMapResponse(Response):
    """Sensor frame map response (0x13,0x82).

    Also called `sensor_frame_mapping_response`. Response to `SensorFrameMap`. Known only from the
    MicroStrain MIP SDK, versions 1 to 3.

    - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
    """

    __slots__ = ("sensor_id", "frame_id")
    __match_args__ = ("sensor_id", "frame_id")

    SET = 0x13
    DESCRIPTOR = 0x82
    NAME = "aiding.sensor_frame_map_response"
    _SIZE = 2

    sensor_id: int
    """Number of the sensor. Range: at least 1."""
    frame_id: int
    """Frame of the sensor, defined by `FrameConfig`. Range: 1 to 4. Default: 1."""

    def __init__(self, sensor_id: int, frame_id: int) -> None:
        self.sensor_id = sensor_id
        self.frame_id = frame_id

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.sensor_id, self.frame_id = _2B.unpack(raw, at)
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("sensor_id frame_id", self.sensor_id, self.frame_id)


class EchoControlResponse(Response):
    """Echo control response (0x13,0x9F).

    Response to `EchoControl`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or
    assumed on 8 more.

    - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
    - 3dm-cv7-gnss-ins: Aiding Command Echo Control
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x13
    DESCRIPTOR = 0x9F
    NAME = "aiding.echo_control_response"
    _SIZE = 1

    mode: AidingEchoMode
    """Reply mode."""

    def __init__(self, mode: AidingEchoMode) -> None:
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.mode = codec.KNOWN[AidingEchoMode][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("mode", self.mode)


class FrameConfig(Command[R]):
    """Frame configuration (0x13,0x01).

    Sets the position and the orientation of an external sensor on the vehicle.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `FrameConfigResponse`.
    Affects `filter_data.AidingFrameConfigError`. Probably affects
    `filter_data.AidingFrameConfigErrorUncertainty`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
    3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 7 more.

    Aiding measurements refer to the frame by its number. `p_vehicle = R * p_frame + t`, with the
    rotation R and the translation t. For GNSS positions and velocities the rotation does not
    matter. Send the identity: Euler angles 0, 0, 0 or the quaternion 1, 0, 0, 0. In a read,
    `format` selects the format of the rotation in the reply.

    - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
    - 3dm-cv7-gnss-ins: Aiding Frames
    """

    __slots__ = ("function", "frame_id", "format", "tracking_enabled", "translation", "rotation")
    __match_args__ = (
        "function",
        "frame_id",
        "format",
        "tracking_enabled",
        "translation",
        "rotation",
    )

    SET = 0x13
    DESCRIPTOR = 0x01
    NAME = "aiding.frame_config"
    RESPONSES = (FrameConfigResponse,)
    REQUIRED = {1: 5, 2: 2, 3: 1, 4: 1, 5: 1}
    _VECTORS = {"translation": (types.Vector3f,), "rotation": (types.Vector3f, types.Quatf)}

    function: FunctionSelector
    """Operation on the setting."""
    frame_id: int | None
    """Number of the frame. Range: 1 to 4."""
    format: AidingFrameFormat | None
    """Format of the rotation. Required for `write` and `read`."""
    tracking_enabled: bool | None
    """True if the filter estimates the errors of the frame. Required for `write`."""
    translation: types.Vector3f | None
    """Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame:
    vehicle. Required for `write`.
    """
    rotation: types.Vector3f | types.Quatf | None
    """Rotates vectors of this frame into the vehicle frame. Selected by `format`. Required for
    `write`.

    - If `format` is `AidingFrameFormat.EULER`: `types.Vector3f`. Roll, pitch and yaw of the frame
      relative to the vehicle; positive are right side down, nose up, and clockwise seen from above.
      Elements: x, y, z. Unit: rad. Frame: vehicle. Range: -pi to pi.
    - If `format` is `AidingFrameFormat.QUATERNION`: `types.Quatf`. Quaternion, scalar part first.
      Elements: w, x, y, z. Unit: 1.
    """

    def __init__(
        self,
        function: FunctionSelector,
        frame_id: int | None = None,
        format: AidingFrameFormat | None = None,
        tracking_enabled: bool | None = None,
        translation: types.Vector3f | codec.Numbers | None = None,
        rotation: types.Vector3f | types.Quatf | None | codec.Numbers = None,
    ) -> None:
        self.function = function
        self.frame_id = frame_id
        self.format = format
        self.tracking_enabled = tracking_enabled
        self.translation = codec.vector(translation, types.Vector3f)
        self.rotation = codec.vector(rotation, types.Vector3f, types.Quatf)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.frame_id = self.format = self.tracking_enabled = self._translation = self._rotation = (
            None
        )
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.frame_id = _B.read(raw, at)[0]
            at += 1
            done, end = 1, at
            codec.check_more(raw, at, required < 2)
            self.format = codec.KNOWN[AidingFrameFormat][_B.read(raw, at)[0]]
            at += 1
            done, end = 2, at
            codec.check_more(raw, at, required < 3)
            self.tracking_enabled = codec.TRUTH[_B.read(raw, at)[0]]
            at += 1
            done, end = 3, at
            codec.check_more(raw, at, required < 4)
            self._translation = _3f.read(raw, at)
            at += 12
            done, end = 4, at
            codec.check_more(raw, at, required < 5)
            self._rotation = None
            if self.format == 1:
                self._rotation = types.Vector3f._make(_3f.read(raw, at))
                at += 12
            if self.format == 2:
                self._rotation = types.Quatf._make(_4f.read(raw, at))
                at += 16
            done, end = 5, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "frame_id"),
            (2, "format"),
            (3, "tracking_enabled"),
            (4, "translation"),
            (5, "rotation?"),
        )
        out += _B.write("frame_id", self.frame_id) if there >= 1 else b""
        out += _B.write("format", self.format) if there >= 2 else b""
        out += _B.write("tracking_enabled", self.tracking_enabled) if there >= 3 else b""
        if there >= 4:
            out += _3f.write("translation*3", *codec.elements("translation", self.translation, 3))
        if there >= 5:
            if self.format == 1:
                codec.check_selected("rotation", self.rotation, self.format, None)
                out += _3f.write("rotation*3", *codec.elements("rotation", self.rotation, 3))
            elif self.format == 2:
                codec.check_selected("rotation", self.rotation, self.format, None)
                out += _4f.write("rotation*4", *codec.elements("rotation", self.rotation, 4))
            else:
                codec.check_unselected("rotation", self.rotation, self.format)
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[FrameConfig[Any]],
        frame_id: int,
        format: AidingFrameFormat,
        tracking_enabled: bool,
        translation: types.Vector3f | codec.Numbers,
        rotation: types.Vector3f | types.Quatf | None | codec.Numbers,
    ) -> FrameConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            frame_id=frame_id,
            format=format,
            tracking_enabled=tracking_enabled,
            translation=translation,
            rotation=rotation,
        )

    @classmethod
    def read(
        cls: ClassOf[FrameConfig[Any]], frame_id: int, format: AidingFrameFormat
    ) -> FrameConfig[FrameConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, frame_id=frame_id, format=format)

    @classmethod
    def save(cls: ClassOf[FrameConfig[Any]], frame_id: int) -> FrameConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, frame_id=frame_id)

    @classmethod
    def load(cls: ClassOf[FrameConfig[Any]], frame_id: int) -> FrameConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, frame_id=frame_id)

    @classmethod
    def default(cls: ClassOf[FrameConfig[Any]], frame_id: int) -> FrameConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, frame_id=frame_id)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (FrameConfigResponse,)
        return ()


class SensorFrameMap(Command[R]):
    """Sensor frame map (0x13,0x02).

    Sets the frame in which an aiding sensor measures.

    Also called `sensor_frame_mapping`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `SensorFrameMapResponse`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of a branch of the SDK of
    2024; later versions do not have it. Uncertain: No source lists the devices that support it.

    - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
    """

    __slots__ = ("function", "sensor_id", "frame_id")
    __match_args__ = ("function", "sensor_id", "frame_id")

    SET = 0x13
    DESCRIPTOR = 0x02
    NAME = "aiding.sensor_frame_map"
    RESPONSES = (SensorFrameMapResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    sensor_id: int | None
    """Number of the sensor. Range: at least 1. Required for `write`."""
    frame_id: int | None
    """Frame of the sensor, defined by `FrameConfig`. Range: 1 to 4. Default: 1. Required for
    `write`.
    """

    def __init__(
        self, function: FunctionSelector, sensor_id: int | None = None, frame_id: int | None = None
    ) -> None:
        self.function = function
        self.sensor_id = sensor_id
        self.frame_id = frame_id

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.sensor_id = _B.read(raw, at)[0] if there >= 1 else None
        self.frame_id = _B.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "sensor_id"), (2, "frame_id")
        )
        out += _B.write("sensor_id", self.sensor_id) if there >= 1 else b""
        out += _B.write("frame_id", self.frame_id) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SensorFrameMap[Any]], sensor_id: int, frame_id: int
    ) -> SensorFrameMap[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, sensor_id=sensor_id, frame_id=frame_id)

    @classmethod
    def read(cls: ClassOf[SensorFrameMap[Any]]) -> SensorFrameMap[SensorFrameMapResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[SensorFrameMap[Any]]) -> SensorFrameMap[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[SensorFrameMap[Any]]) -> SensorFrameMap[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[SensorFrameMap[Any]]) -> SensorFrameMap[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SensorFrameMapResponse,)
        return ()


class EchoControl(Command[R]):
    """Echo control (0x13,0x1F).

    Sets how the device replies to aiding measurements.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `EchoControlResponse`.
    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.

    The manual does not contain the layout of the responses that carry the data back.

    - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
    - 3dm-cv7-gnss-ins: Aiding Command Echo Control
    """

    __slots__ = ("function", "mode")
    __match_args__ = ("function", "mode")

    SET = 0x13
    DESCRIPTOR = 0x1F
    NAME = "aiding.echo_control"
    RESPONSES = (EchoControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    mode: AidingEchoMode | None
    """Reply mode. Required for `write`."""

    def __init__(self, function: FunctionSelector, mode: AidingEchoMode | None = None) -> None:
        self.function = function
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.mode = codec.KNOWN[AidingEchoMode][_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "mode"))
        out += _B.write("mode", self.mode) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[EchoControl[Any]], mode: AidingEchoMode) -> EchoControl[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, mode=mode)

    @classmethod
    def read(cls: ClassOf[EchoControl[Any]]) -> EchoControl[EchoControlResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[EchoControl[Any]]) -> EchoControl[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[EchoControl[Any]]) -> EchoControl[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[EchoControl[Any]]) -> EchoControl[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (EchoControlResponse,)
        return ()


class EcefPosition(Command[None]):
    """ECEF position (0x13,0x21).

    Sends a measured position in Earth-fixed coordinates.

    Also called `pos_ecef`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    Use only one form of position: ECEF or LLH. In mode `response` of `EchoControl`, the device
    sends the data back in a response of unknown layout.

    - 3dm-cv7-gnss-ins: ECEF Position (0x13,0x21)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Position
    """

    __slots__ = ("time", "frame_id", "position", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "position", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x21
    NAME = "aiding.ecef_position"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"position": (types.Vector3d,), "uncertainty": (types.Vector3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    position: types.Vector3d
    """Position of the origin of the frame. Elements: x, y, z. Unit: m. Frame: ecef. Each element
    has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of `valid_flags`, z:
    `AxisFlags.Z` of `valid_flags`.
    """
    uncertainty: types.Vector3f
    """Uncertainty of the position. Elements: x, y, z. Unit: m. Frame: ecef. Range: greater than 0.
    Each element has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of
    `valid_flags`, z: `AxisFlags.Z` of `valid_flags`.
    """
    valid_flags: AxisFlags
    """Valid axes."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        position: types.Vector3d | codec.Numbers,
        uncertainty: types.Vector3f | codec.Numbers,
        valid_flags: AxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.position = codec.vector(position, types.Vector3d)
        self.uncertainty = codec.vector(uncertainty, types.Vector3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B3d3fH.read(raw, at)
        self.frame_id = v[0]
        self._position = v[1:4]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[AxisFlags][v[7]]
        at += 39
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B3d3fH.write(
            "frame_id position*3 uncertainty*3 valid_flags",
            self.frame_id,
            *codec.elements("position", self.position, 3),
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class LlhPosition(Command[None]):
    """LLH position (0x13,0x22).

    Sends a measured position as latitude, longitude and height.

    Also called `pos_llh`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    Use only one form of position: ECEF or LLH. To send a height only, clear the valid flags of
    latitude and longitude. An uncertainty of 0 is no substitute. In mode `response` of
    `EchoControl`, the device sends the data back in a response of unknown layout.

    - 3dm-cv7-gnss-ins: LLH Position (0x13,0x22)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > LLH Position
    """

    __slots__ = (
        "time",
        "frame_id",
        "latitude",
        "longitude",
        "height",
        "uncertainty",
        "valid_flags",
    )
    __match_args__ = (
        "time",
        "frame_id",
        "latitude",
        "longitude",
        "height",
        "uncertainty",
        "valid_flags",
    )

    SET = 0x13
    DESCRIPTOR = 0x22
    NAME = "aiding.llh_position"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"uncertainty": (types.Ned3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    latitude: float
    """Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
    `LlhAxisFlags.LATITUDE` of `valid_flags` is set.
    """
    longitude: float
    """Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
    `LlhAxisFlags.LONGITUDE` of `valid_flags` is set.
    """
    height: float
    """Height above the ellipsoid. Unit: m. Frame: llh. Valid if `LlhAxisFlags.HEIGHT` of
    `valid_flags` is set.
    """
    uncertainty: types.Ned3f
    """Uncertainty of the position. Elements: north, east, down. Unit: m. Frame: ned. Range: greater
    than 0. Each element has its own valid flag. north: `LlhAxisFlags.LATITUDE` of `valid_flags`,
    east: `LlhAxisFlags.LONGITUDE` of `valid_flags`, down: `LlhAxisFlags.HEIGHT` of `valid_flags`.
    """
    valid_flags: LlhAxisFlags
    """Valid coordinates."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        latitude: float,
        longitude: float,
        height: float,
        uncertainty: types.Ned3f | codec.Numbers,
        valid_flags: LlhAxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.latitude = latitude
        self.longitude = longitude
        self.height = height
        self.uncertainty = codec.vector(uncertainty, types.Ned3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B3d3fH.read(raw, at)
        self.frame_id = v[0]
        self.latitude = v[1]
        self.longitude = v[2]
        self.height = v[3]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[LlhAxisFlags][v[7]]
        at += 39
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B3d3fH.write(
            "frame_id latitude longitude height uncertainty*3 valid_flags",
            self.frame_id,
            self.latitude,
            self.longitude,
            self.height,
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class HeightAboveEllipsoid(Command[None]):
    """Height above ellipsoid (0x13,0x23).

    Sends a measured height above the ellipsoid.

    Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    In mode `response` of `EchoControl`, the device sends the data back in a response of unknown
    layout.

    - 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)
    """

    __slots__ = ("time", "frame_id", "height", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "height", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x23
    NAME = "aiding.height_above_ellipsoid"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    height: float
    """Height above the ellipsoid. Unit: m. Frame: llh."""
    uncertainty: float
    """Uncertainty of the height. Unit: m. Range: at least 0."""
    valid_flags: int
    """Nonzero if the measurement is valid."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        height: float,
        uncertainty: float,
        valid_flags: int,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.height = height
        self.uncertainty = uncertainty
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        self.frame_id, self.height, self.uncertainty, self.valid_flags = _B2fH.read(raw, at)
        at += 11
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B2fH.write(
            "frame_id height uncertainty valid_flags",
            self.frame_id,
            self.height,
            self.uncertainty,
            self.valid_flags,
        )
        return codec.finished(out)


class PressureOld(Command[None]):
    """Pressure (old) (0x13,0x25).

    Sends a static air pressure measured by an external sensor (superseded by `Pressure`).

    Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Not listed in any
    device profile. Known only from the MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout
    is that of a branch of the SDK of 2024; later versions do not have it. Uncertain: No source
    lists the devices that support it.

    - mip-sdk-3: Pressure (0x13,0x25), branch feature/UsbSerial
    """

    __slots__ = ("time", "frame_id", "pressure", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "pressure", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x25
    NAME = "aiding.pressure_old"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    pressure: float
    """Air pressure. Unit: mbar."""
    uncertainty: float
    """Standard deviation of the pressure. Unit: mbar. Range: greater than 0."""
    valid_flags: int
    """Nonzero if the measurement is valid."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        pressure: float,
        uncertainty: float,
        valid_flags: int,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.pressure = pressure
        self.uncertainty = uncertainty
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        self.frame_id, self.pressure, self.uncertainty, self.valid_flags = _B2fH.read(raw, at)
        at += 11
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B2fH.write(
            "frame_id pressure uncertainty valid_flags",
            self.frame_id,
            self.pressure,
            self.uncertainty,
            self.valid_flags,
        )
        return codec.finished(out)


class EcefVelocity(Command[None]):
    """ECEF velocity (0x13,0x28).

    Sends a measured velocity in Earth-fixed coordinates.

    Also called `vel_ecef`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    Use only one form of velocity: ECEF or NED. For a sensor that is fixed to the vehicle, use
    `BodyFrameVelocity`. In mode `response` of `EchoControl`, the device sends the data back in a
    response of unknown layout.

    - 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Velocity
    """

    __slots__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x28
    NAME = "aiding.ecef_velocity"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"velocity": (types.Vector3f,), "uncertainty": (types.Vector3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    velocity: types.Vector3f
    """Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: ecef. Each element
    has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of `valid_flags`, z:
    `AxisFlags.Z` of `valid_flags`.
    """
    uncertainty: types.Vector3f
    """Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: greater than
    0. Each element has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of
    `valid_flags`, z: `AxisFlags.Z` of `valid_flags`.
    """
    valid_flags: AxisFlags
    """Valid axes."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        velocity: types.Vector3f | codec.Numbers,
        uncertainty: types.Vector3f | codec.Numbers,
        valid_flags: AxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.velocity = codec.vector(velocity, types.Vector3f)
        self.uncertainty = codec.vector(uncertainty, types.Vector3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B6fH.read(raw, at)
        self.frame_id = v[0]
        self._velocity = v[1:4]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[AxisFlags][v[7]]
        at += 27
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B6fH.write(
            "frame_id velocity*3 uncertainty*3 valid_flags",
            self.frame_id,
            *codec.elements("velocity", self.velocity, 3),
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class NedVelocity(Command[None]):
    """NED velocity (0x13,0x29).

    Sends a measured velocity in the local level frame.

    Also called `vel_ned`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    Use only one form of velocity: ECEF or NED. For a sensor that is fixed to the vehicle, use
    `BodyFrameVelocity`. In mode `response` of `EchoControl`, the device sends the data back in a
    response of unknown layout.

    - 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > NED Velocity
    """

    __slots__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x29
    NAME = "aiding.ned_velocity"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"velocity": (types.Ned3f,), "uncertainty": (types.Ned3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    velocity: types.Ned3f
    """Velocity of the origin of the frame. Elements: north, east, down. Unit: m/s. Frame: ned. Each
    element has its own valid flag. north: `AxisFlags.X` of `valid_flags`, east: `AxisFlags.Y` of
    `valid_flags`, down: `AxisFlags.Z` of `valid_flags`.
    """
    uncertainty: types.Ned3f
    """Uncertainty of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned. Range:
    greater than 0. Each element has its own valid flag. north: `AxisFlags.X` of `valid_flags`,
    east: `AxisFlags.Y` of `valid_flags`, down: `AxisFlags.Z` of `valid_flags`.
    """
    valid_flags: AxisFlags
    """Valid axes."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        velocity: types.Ned3f | codec.Numbers,
        uncertainty: types.Ned3f | codec.Numbers,
        valid_flags: AxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.velocity = codec.vector(velocity, types.Ned3f)
        self.uncertainty = codec.vector(uncertainty, types.Ned3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B6fH.read(raw, at)
        self.frame_id = v[0]
        self._velocity = v[1:4]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[AxisFlags][v[7]]
        at += 27
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B6fH.write(
            "frame_id velocity*3 uncertainty*3 valid_flags",
            self.frame_id,
            *codec.elements("velocity", self.velocity, 3),
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class BodyFrameVelocity(Command[None]):
    """Body frame velocity (0x13,0x2A).

    Sends a measured velocity of the vehicle in the frame of the sensor.

    Also called `vel_body_frame`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    The device supports up to four sensors of this kind. For a wheeled vehicle constraint, send a
    velocity of 0 with only y valid, at least once per second. With z also valid and 0, motion is
    constrained to a plane (2D mode). For a zero velocity update, send a velocity of 0 while the
    GNSS speed is below a threshold that you choose. In mode `response` of `EchoControl`, the device
    sends the data back in a response of unknown layout.

    - 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > Body Frame Velocity
    - 3dm-cv7-gnss-ins: Filter Kinematic Constraints
    """

    __slots__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "velocity", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x2A
    NAME = "aiding.body_frame_velocity"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"velocity": (types.Vector3f,), "uncertainty": (types.Vector3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    velocity: types.Vector3f
    """Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: aiding. Each
    element has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of
    `valid_flags`, z: `AxisFlags.Z` of `valid_flags`.
    """
    uncertainty: types.Vector3f
    """Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: aiding. Range:
    greater than 0. Each element has its own valid flag. x: `AxisFlags.X` of `valid_flags`, y:
    `AxisFlags.Y` of `valid_flags`, z: `AxisFlags.Z` of `valid_flags`.
    """
    valid_flags: AxisFlags
    """Valid axes."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        velocity: types.Vector3f | codec.Numbers,
        uncertainty: types.Vector3f | codec.Numbers,
        valid_flags: AxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.velocity = codec.vector(velocity, types.Vector3f)
        self.uncertainty = codec.vector(uncertainty, types.Vector3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B6fH.read(raw, at)
        self.frame_id = v[0]
        self._velocity = v[1:4]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[AxisFlags][v[7]]
        at += 27
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B6fH.write(
            "frame_id velocity*3 uncertainty*3 valid_flags",
            self.frame_id,
            *codec.elements("velocity", self.velocity, 3),
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class TrueHeading(Command[None]):
    """True heading (0x13,0x31).

    Sends a measured heading relative to true north.

    Also called `heading_true`. Not acknowledged if `mode` of `EchoControl` is
    `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS;
    likely or assumed on 8 more.

    In mode `response` of `EchoControl`, the device sends the data back in a response of unknown
    layout.

    - 3dm-cv7-gnss-ins: True Heading (0x13,0x31)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > True Heading
    """

    __slots__ = ("time", "frame_id", "heading", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "heading", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x31
    NAME = "aiding.true_heading"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    heading: float
    """Heading relative to true north. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise
    seen from above.
    """
    uncertainty: float
    """Uncertainty of the heading. Unit: rad. Range: greater than 0."""
    valid_flags: int
    """Nonzero if the measurement is valid."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        heading: float,
        uncertainty: float,
        valid_flags: int,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.heading = heading
        self.uncertainty = uncertainty
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        self.frame_id, self.heading, self.uncertainty, self.valid_flags = _B2fH.read(raw, at)
        at += 11
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B2fH.write(
            "frame_id heading uncertainty valid_flags",
            self.frame_id,
            self.heading,
            self.uncertainty,
            self.valid_flags,
        )
        return codec.finished(out)


class MagneticField(Command[None]):
    """Magnetic field (0x13,0x32).

    Sends a magnetic field measured by an external magnetometer.

    Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 7 more.

    The magnetometer must be calibrated. In mode `response` of `EchoControl`, the device sends the
    data back in a response of unknown layout.

    - 3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Magnetometer
    """

    __slots__ = ("time", "frame_id", "magnetic_field", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "magnetic_field", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x32
    NAME = "aiding.magnetic_field"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)
    _VECTORS = {"magnetic_field": (types.Vector3f,), "uncertainty": (types.Vector3f,)}

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    magnetic_field: types.Vector3f
    """Calibrated magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Each element has
    its own valid flag. x: `AxisFlags.X` of `valid_flags`, y: `AxisFlags.Y` of `valid_flags`, z:
    `AxisFlags.Z` of `valid_flags`.
    """
    uncertainty: types.Vector3f
    """Standard deviation of the magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding.
    Range: greater than 0. Each element has its own valid flag. x: `AxisFlags.X` of `valid_flags`,
    y: `AxisFlags.Y` of `valid_flags`, z: `AxisFlags.Z` of `valid_flags`.
    """
    valid_flags: AxisFlags
    """Valid axes."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        magnetic_field: types.Vector3f | codec.Numbers,
        uncertainty: types.Vector3f | codec.Numbers,
        valid_flags: AxisFlags,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.magnetic_field = codec.vector(magnetic_field, types.Vector3f)
        self.uncertainty = codec.vector(uncertainty, types.Vector3f)
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        v = _B6fH.read(raw, at)
        self.frame_id = v[0]
        self._magnetic_field = v[1:4]
        self._uncertainty = v[4:7]
        self.valid_flags = codec.KNOWN[AxisFlags][v[7]]
        at += 27
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B6fH.write(
            "frame_id magnetic_field*3 uncertainty*3 valid_flags",
            self.frame_id,
            *codec.elements("magnetic_field", self.magnetic_field, 3),
            *codec.elements("uncertainty", self.uncertainty, 3),
            self.valid_flags,
        )
        return codec.finished(out)


class Pressure(Command[None]):
    """Pressure (0x13,0x33).

    Sends a static air pressure measured by an external sensor.

    Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 3 more.

    In mode `response` of `EchoControl`, the device sends the data back in a response of unknown
    layout.

    - 3dm-cv7-gnss-ins: Pressure (0x13,0x33)
    - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Pressure
    """

    __slots__ = ("time", "frame_id", "pressure", "uncertainty", "valid_flags")
    __match_args__ = ("time", "frame_id", "pressure", "uncertainty", "valid_flags")

    SET = 0x13
    DESCRIPTOR = 0x33
    NAME = "aiding.pressure"
    SILENCED_BY = ((0x13, 0x1F, "mode", 0),)

    time: MeasurementTime
    """Time of the measurement."""
    frame_id: int
    """Sensor frame, defined by `FrameConfig`. Range: 1 to 4."""
    pressure: float
    """Air pressure. Unit: mbar."""
    uncertainty: float
    """Standard deviation of the pressure. Unit: mbar. Range: greater than 0."""
    valid_flags: int
    """Nonzero if the measurement is valid."""

    def __init__(
        self,
        time: MeasurementTime,
        frame_id: int,
        pressure: float,
        uncertainty: float,
        valid_flags: int,
    ) -> None:
        self.time = time
        self.frame_id = frame_id
        self.pressure = pressure
        self.uncertainty = uncertainty
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.time, at = MeasurementTime._decoded(raw, at)
        self.frame_id, self.pressure, self.uncertainty, self.valid_flags = _B2fH.read(raw, at)
        at += 11
        return at

    def _write(self) -> bytes:
        out = codec.structure("time", self.time, MeasurementTime)
        out += _B2fH.write(
            "frame_id pressure uncertainty valid_flags",
            self.frame_id,
            self.pressure,
            self.uncertainty,
            self.valid_flags,
        )
        return codec.finished(out)


FrameConfigResponse.COMMANDS = (FrameConfig,)
SensorFrameMapResponse.COMMANDS = (SensorFrameMap,)
EchoControlResponse.COMMANDS = (EchoControl,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (FrameConfig,),
    0x02: (SensorFrameMap,),
    0x1F: (EchoControl,),
    0x21: (EcefPosition,),
    0x22: (LlhPosition,),
    0x23: (HeightAboveEllipsoid,),
    0x25: (PressureOld,),
    0x28: (EcefVelocity,),
    0x29: (NedVelocity,),
    0x2A: (BodyFrameVelocity,),
    0x31: (TrueHeading,),
    0x32: (MagneticField,),
    0x33: (Pressure,),
    0x81: (FrameConfigResponse,),
    0x82: (SensorFrameMapResponse,),
    0x9F: (EchoControlResponse,),
}
