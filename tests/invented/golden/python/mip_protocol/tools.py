"""Tools (0x01).

Commands of every shape.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types, wire
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector


class Shape(codec.OpenEnum):
    """Which member the union has."""

    NONE = 0
    CIRCLE = 1
    PATH = 2
    TURN = 3
    LABEL = 4


class Fill(codec.OpenEnum):
    """How a circle is filled."""

    EMPTY = 0
    SOLID = 1
    STRIPED = 2


class Stripes(Structure):
    """Two numbers."""

    __slots__ = ("width", "angle")
    __match_args__ = ("width", "angle")

    _LAYOUT = (("width", "d", None), ("angle", "f", None))

    width: float
    """Of a stripe. Unit: m."""
    angle: float
    """Of all stripes. Unit: deg. Range: -180 to 180."""

    def __init__(self, width: float, angle: float) -> None:
        self.width = width
        self.angle = angle


class Circle(Structure):
    """Ends in a union of its own."""

    __slots__ = ("center", "fill", "filling")
    __match_args__ = ("center", "fill", "filling")

    _LAYOUT = (
        ("center", "", types.Point),
        ("fill", "B", Fill),
        ("filling", "", wire.Union("fill", {1: ("solid", "I", None), 2: ("striped", "", Stripes)})),
    )

    center: types.Point
    """The middle."""
    fill: Fill
    """Which member follows."""
    filling: int | Stripes | None
    """How it is filled. Selected by `fill`.

    - If `fill` is `Fill.EMPTY`: `None`.
    - If `fill` is `Fill.SOLID`: `int`. A colour.
    - If `fill` is `Fill.STRIPED`: `Stripes`.
    """

    def __init__(
        self, center: types.Point, fill: Fill, filling: int | Stripes | None = None
    ) -> None:
        self.center = center
        self.fill = fill
        self.filling = filling


class Path(Structure):
    """A counted array at its end."""

    __slots__ = ("closed", "points")
    __match_args__ = ("closed", "points")

    _LAYOUT = (
        ("closed", "B", codec.truth),
        ("num_points", "B", wire.Counts("points", 62)),
        ("points", "", wire.Items(types.Point, "num_points", 62)),
    )

    closed: bool
    """Does it return to its start?"""
    # On the wire only: num_points. Number of points. Counts the elements of `points`.
    points: tuple[types.Point, ...]
    """The points."""

    def __init__(self, closed: bool, points: Sequence[types.Point]) -> None:
        self.closed = closed
        self.points = codec.several(points)


class Drive(codec.OpenEnum):
    """What drives a pin."""

    OFF = 0
    PULSE = 1
    SERIAL = 2


class PulseUse(codec.OpenEnum):
    """Of a pulse."""

    INPUT = 1
    OUTPUT = 2


class SerialUse(codec.OpenEnum):
    """Of a serial line."""

    RECEIVE = 1
    TRANSMIT = 33


class Reading(Structure):
    """One of a list; what it is depends on what was asked for."""

    __slots__ = ("kind", "value")
    __match_args__ = ("kind", "value")

    _LAYOUT = (("kind", "B", None), ("value", "f", None))

    kind: int
    """Of the reading."""
    value: float
    """Of the reading."""

    def __init__(self, kind: int, value: float) -> None:
        self.kind = kind
        self.value = value


@codec.open_flag(32)
class ModelAFaults(IntFlag):
    """Of the model A."""

    CLOCK = 1 << 0
    """Bit 0."""
    SENSOR = 1 << 8
    """The sensor is broken. Bit 8. Concerns `measurements.Accel` and `CaptureBias`."""
    SOLUTION = 1 << 24
    """Bit 24."""


@codec.open_flag(32)
class ModelBFaults(IntFlag):
    """Of the model B."""

    GENERAL = 1 << 0
    """Bit 0."""
    OVERLOAD = 1 << 1
    """Bit 1."""
    ACCEL = 1 << 12
    """Bit 12."""


class SettingsResponse(Response):
    """Settings response (0x01,0x82).

    Response to `Settings`. Supported by Model A, Model B and Model C.

    - guide: Settings
    - leaflet: Settings
    """

    __slots__ = ("port", "mode", "baud", "limit", "reserved")
    __match_args__ = ("port", "mode", "baud", "limit", "reserved")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x82
    NAME = "tools.settings_response"
    ROLE = "response"
    _LAYOUT = (
        ("port", "B", None),
        ("mode", "B", types.Mode),
        ("baud", "I", None),
        ("limit", "H", None),
        ("reserved", "B", None),
    )

    port: int
    """Number of the port, 0 for all. Range: 0 to 8."""
    mode: types.Mode
    """What to do. Default: `types.Mode.FAST`."""
    baud: int
    """Speed. Unit: Bd. Default: 115200."""
    limit: int
    """Required by no function, not even by write.

    - If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.
    - If `mode` is `types.Mode.SLOW`: unit m.
    """
    reserved: int
    """Reserved."""

    def __init__(
        self, port: int, mode: types.Mode, baud: int, limit: int, reserved: int = 1
    ) -> None:
        self.port = port
        self.mode = mode
        self.baud = baud
        self.limit = limit
        self.reserved = reserved


class SetTimeFastResponse(Response):
    """Set time response (0x01,0x83).

    Response to `SetTime`. Sent if `part` is `types.Mode.FAST`. Supported by Model A and Model C.

    - guide: Set time
    """

    __slots__ = ("value",)
    __match_args__ = ("value",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x83
    NAME = "tools.set_time_fast_response"
    ROLE = "response"
    _LAYOUT = (("value", "I", None),)

    value: int
    """The fast half. Unit: s."""

    def __init__(self, value: int) -> None:
        self.value = value


class SetTimeSlowResponse(Response):
    """Set time response (0x01,0x84).

    Response to `SetTime`. Sent if `part` is `types.Mode.SLOW`. Supported by Model A and Model C.

    - guide: Set time
    """

    __slots__ = ("value",)
    __match_args__ = ("value",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x84
    NAME = "tools.set_time_slow_response"
    ROLE = "response"
    _LAYOUT = (("value", "I", None),)

    value: int
    """The slow half. Unit: s."""

    def __init__(self, value: int) -> None:
        self.value = value


class ChoiceResponse(Response):
    """Choice response (0x01,0x88).

    Response to `Choice`. Supported by Model A.

    - guide: Choice
    """

    __slots__ = ("instance", "shape", "parameters")
    __match_args__ = ("instance", "shape", "parameters")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x88
    NAME = "tools.choice_response"
    ROLE = "response"
    _LAYOUT = (
        ("instance", "B", None),
        ("shape", "B", Shape),
        (
            "parameters",
            "",
            wire.Union(
                "shape",
                {
                    1: ("circle", "", Circle),
                    2: ("path", "", Path),
                    3: ("rotation", "ffff", types.Quatf),
                    4: ("label", "", wire.Text(8, 8)),
                },
            ),
        ),
    )

    _VECTORS = {"parameters": (types.Quatf,)}

    instance: int
    """Which one."""
    shape: Shape
    """Which member follows."""
    parameters: Circle | Path | types.Quatf | str | None
    """The member. Selected by `shape`.

    - If `shape` is `Shape.NONE`: `None`.
    - If `shape` is `Shape.CIRCLE`: `Circle`.
    - If `shape` is `Shape.PATH`: `Path`.
    - If `shape` is `Shape.TURN`: `types.Quatf`. A rotation. Elements: w, x, y, z. Unit: 1.
    - If `shape` is `Shape.LABEL`: `str`. A name.
    """

    def __init__(
        self,
        instance: int,
        shape: Shape,
        parameters: Circle | Path | types.Quatf | str | None | codec.Numbers = None,
    ) -> None:
        self.instance = instance
        self.shape = shape
        self.parameters = codec.vector(parameters, types.Quatf)


class ListResponse(Response):
    """List response (0x01,0x89).

    Response to `List`. Supported by Model A and Model C.

    - guide: List
    """

    __slots__ = ("items",)
    __match_args__ = ("items",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x89
    NAME = "tools.list_response"
    ROLE = "response"
    _LAYOUT = (
        ("count", "B", wire.Counts("items", 126)),
        ("items", "H", wire.Items(None, "count", 126)),
    )

    # On the wire only: count. Number of items. Counts the elements of `items`.
    items: tuple[int, ...]
    """The items."""

    def __init__(self, items: Sequence[int]) -> None:
        self.items = codec.several(items)


class InventoryResponse(Response):
    """Inventory response (0x01,0x8A).

    Response to `Inventory`. Supported by Model A and Model C.

    - guide: Inventory
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x8A
    NAME = "tools.inventory_response"
    ROLE = "response"
    _LAYOUT = (("descriptors", "H", wire.Items(None, None, 126)),)

    descriptors: tuple[int, ...]
    """As many as there are."""

    def __init__(self, descriptors: Sequence[int]) -> None:
        self.descriptors = codec.several(descriptors)


class PinResponse(Response):
    """Pin response (0x01,0x8B).

    Response to `Pin`. Supported by Model A and Model C.

    - guide: Pin
    """

    __slots__ = ("drive", "use")
    __match_args__ = ("drive", "use")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x8B
    NAME = "tools.pin_response"
    ROLE = "response"
    _LAYOUT = (("drive", "B", Drive), ("use", "B", None))

    drive: Drive
    """What drives it now."""
    use: int
    """How it is used.

    - If `drive` is `Drive.PULSE`: values of `PulseUse`.
    - If `drive` is `Drive.SERIAL`: values of `SerialUse`.
    """

    def __init__(self, drive: Drive, use: int) -> None:
        self.drive = drive
        self.use = use


class HelloResponse(Response):
    """Hello response (0x01,0x8C).

    No device is known for certain to support it. Also called `keep_alive_response` and `welcome`.
    Response to `Hello`. Known only from the Kit of names. Uncertain: When it comes.

    - sheet: Hello
    """

    __slots__ = ("seen",)
    __match_args__ = ("seen",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x8C
    NAME = "tools.hello_response"
    ROLE = "response"
    _LAYOUT = (("seen", "I", None),)

    seen: int
    """When the device was seen. Unit: s."""

    def __init__(self, seen: int) -> None:
        self.seen = seen


class ReadingsResponse(Response):
    """Readings response (0x01,0x8D).

    Response to `Readings`. Supported by Model A and Model C.

    - guide: Readings
    """

    __slots__ = ("drive", "readings", "last")
    __match_args__ = ("drive", "readings", "last")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x8D
    NAME = "tools.readings_response"
    ROLE = "response"
    _LAYOUT = (
        ("drive", "B", Drive),
        ("count", "B", wire.Counts("readings", 49)),
        ("readings", "", wire.Items(Reading, "count", 49)),
        ("last", "", Reading),
    )

    drive: Drive
    """What was asked for."""
    # On the wire only: count. Number of readings. Counts the elements of `readings`.
    readings: tuple[Reading, ...]
    """The readings.

    - If `drive` is `Drive.PULSE`: `kind` has values of `PulseUse`. Seldom 2.
    - If `drive` is `Drive.SERIAL`: `kind` has values of `SerialUse`.
    """
    last: Reading
    """The last one.

    - If `drive` is `Drive.PULSE`: `value` has unit s; range 0 to 1.
    - If `drive` is `Drive.SERIAL`: `value`: Nothing.
    """

    def __init__(self, drive: Drive, readings: Sequence[Reading], last: Reading) -> None:
        self.drive = drive
        self.readings = codec.several(readings)
        self.last = last


class StatusPaged(Response):
    """Status response (0x01,0x90).

    As long as the short layout. A further constant tells it from that one.

    Response to `Status`. Sent if `selector` is 1. Supported by Model C.

    - guide: Status
    """

    __slots__ = ("uptime", "level")
    __match_args__ = ("uptime", "level")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x90
    NAME = "tools.status_paged"
    ROLE = "response"
    _LAYOUT = (
        ("model", "H", 4711),
        ("selector", "B", 1),
        ("page", "B", 7),
        ("uptime", "H", None),
        ("level", "B", None),
    )

    # On the wire only: model. The model. Always 4711.
    # On the wire only: selector. The short layout. Always 1.
    # On the wire only: page. The page. Always 7.
    uptime: int
    """Since start. Unit: s."""
    level: int
    """How full it is."""

    def __init__(self, uptime: int, level: int) -> None:
        self.uptime = uptime
        self.level = level

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return (
            b"\x12g".startswith(data[0:2])
            and b"\x01".startswith(data[2:3])
            and b"\x07".startswith(data[3:4])
        )


class StatusShort(Response):
    """Status response (0x01,0x90).

    Response to `Status`. Sent if `selector` is 1. Supported by Model A and Model B.

    - guide: Status
    """

    __slots__ = ("flags",)
    __match_args__ = ("flags",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x90
    NAME = "tools.status_short"
    ROLE = "response"
    _LAYOUT = (("model", "H", 4711), ("selector", "B", 1), ("flags", "I", None))

    # On the wire only: model. The model. Always 4711.
    # On the wire only: selector. The short layout. Always 1.
    flags: int
    """Faults.

    - On the Model A and Model C: values of `ModelAFaults`.
    - On the Model B: values of `ModelBFaults`.
    """

    def __init__(self, flags: int) -> None:
        self.flags = flags

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return b"\x12g".startswith(data[0:2]) and b"\x01".startswith(data[2:3])


class StatusLong(Response):
    """Status response (0x01,0x90).

    Response to `Status`. Distinguished from `StatusOld` and `StatusFull` by the size of its data.
    Sent if `selector` is 2. Supported by Model B.

    - guide: Status
    """

    __slots__ = ("flags", "uptime")
    __match_args__ = ("flags", "uptime")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x90
    NAME = "tools.status_long"
    ROLE = "response"
    _LAYOUT = (
        ("model", "H", 4711),
        ("selector", "B", 2),
        ("flags", "I", None),
        ("uptime", "Q", None),
    )

    # On the wire only: model. The model. Always 4711.
    # On the wire only: selector. The long layout. Always 2.
    flags: int
    """Faults.

    - On the Model A: values of `ModelAFaults`.
    - On the Model B: values of `ModelBFaults`.
    - On the Model C: the values are unknown.
    """
    uptime: int
    """Since start. Unit: s."""

    def __init__(self, flags: int, uptime: int) -> None:
        self.flags = flags
        self.uptime = uptime

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return (
            15 <= len(data) < 16
            and b"\x12g".startswith(data[0:2])
            and b"\x02".startswith(data[2:3])
        )


class StatusOld(Response):
    """Status response (0x01,0x90).

    The long layout of old devices. Its size tells it from the others.

    Response to `Status`. Distinguished from `StatusLong` and `StatusFull` by the size of its data.
    Sent if `selector` is 2. Supported by Model A.

    - guide: Status
    """

    __slots__ = ("uptime",)
    __match_args__ = ("uptime",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x90
    NAME = "tools.status_old"
    ROLE = "response"
    _LAYOUT = (("model", "H", 4711), ("selector", "B", 2), ("uptime", "I", None))

    # On the wire only: model. The model. Always 4711.
    # On the wire only: selector. The long layout. Always 2.
    uptime: int
    """Since start. Unit: s."""

    def __init__(self, uptime: int) -> None:
        self.uptime = uptime

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 15 and b"\x12g".startswith(data[0:2]) and b"\x02".startswith(data[2:3])


class StatusFull(Response):
    """Status response (0x01,0x90).

    Response to `Status`. Distinguished from `StatusLong` and `StatusOld` by the size of its data.
    Sent if `selector` is 2. Supported by Model C.

    - guide: Status
    """

    __slots__ = ("place", "uptime", "mode")
    __match_args__ = ("place", "uptime", "mode")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x90
    NAME = "tools.status_full"
    ROLE = "response"
    _LAYOUT = (
        ("model", "H", 4711),
        ("selector", "B", 2),
        ("place", "", types.Point),
        ("uptime", "Q", None),
        ("mode", "B", types.Mode),
    )

    # On the wire only: model. The model. Always 4711.
    # On the wire only: selector. The long layout. Always 2.
    place: types.Point
    """Where it is."""
    uptime: int
    """Since start. Unit: s."""
    mode: types.Mode
    """What it does."""

    def __init__(self, place: types.Point, uptime: int, mode: types.Mode) -> None:
        self.place = place
        self.uptime = uptime
        self.mode = mode

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 16 <= len(data) and b"\x12g".startswith(data[0:2]) and b"\x02".startswith(data[2:3])


class BiasVector(Response):
    """Bias response (0x01,0x9B).

    Response to `Bias` and `CaptureBias`. Supported by Model A and Model C.

    - guide: Bias
    - leaflet: Bias
    """

    __slots__ = ("bias",)
    __match_args__ = ("bias",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x9B
    NAME = "tools.bias_vector"
    ROLE = "response"
    _LAYOUT = (("bias", "fff", types.Vector3f),)

    _VECTORS = {"bias": (types.Vector3f,)}

    bias: types.Vector3f
    """Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor."""

    def __init__(self, bias: types.Vector3f | codec.Numbers) -> None:
        self.bias = codec.vector(bias, types.Vector3f)


class Ping(Command[None]):
    """Ping (0x01,0x01).

    Tests the line.

    Supported by Model A, Model B, Model C and Old 1.

    - guide: Ping
    - leaflet: Ping
    """

    __slots__ = ()

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x01
    NAME = "tools.ping"
    ROLE = "command"


class Settings(Command[R]):
    """Settings (0x01,0x02).

    Every function, and a prefix of parameters for each.

    Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response: `SettingsResponse`.
    Supported by Model A, Model B and Model C. On the Model B: `write` and `read` only. On the Model
    C: `write`, `read` and `save` only.

    - guide: Settings
    - leaflet: Settings
    """

    __slots__ = ("function", "port", "mode", "baud", "limit", "reserved")
    __match_args__ = ("function", "port", "mode", "baud", "limit", "reserved")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x02
    NAME = "tools.settings"
    ROLE = "command"
    RESPONSES = (SettingsResponse,)
    REQUIRED = {1: 3, 2: 2, 3: 1, 4: 1, 5: 1, 6: 3}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("port", "B", None),
        ("mode", "B", types.Mode),
        ("baud", "I", None),
        ("limit", "H", None),
        ("reserved", "B", None),
    )
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    port: int | None
    """Number of the port, 0 for all. Range: 0 to 8."""
    mode: types.Mode | None
    """What to do. Default: `types.Mode.FAST`. Required for `write`, `read` and `apply`.

    - On the Model C: only `types.Mode.DEFAULT` and `types.Mode.FAST`; not deprecated.
    """
    baud: int | None
    """Speed. Unit: Bd. Default: 115200. Required for `write` and `apply`."""
    limit: int | None
    """Required by no function, not even by write. Optional.

    - If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.
    - If `mode` is `types.Mode.SLOW`: unit m.
    """
    reserved: int | None
    """Reserved: send 1. Optional."""

    def __init__(
        self,
        function: FunctionSelector,
        port: int | None = None,
        mode: types.Mode | None = None,
        baud: int | None = None,
        limit: int | None = None,
        reserved: int | None = None,
    ) -> None:
        self.function = function
        self.port = port
        self.mode = mode
        self.baud = baud
        self.limit = limit
        self.reserved = reserved

    @classmethod
    def write(
        cls: ClassOf[Settings[Any]],
        port: int,
        mode: types.Mode,
        baud: int,
        limit: int | None = None,
    ) -> Settings[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, port=port, mode=mode, baud=baud, limit=limit)

    @classmethod
    def read(
        cls: ClassOf[Settings[Any]], port: int, mode: types.Mode
    ) -> Settings[SettingsResponse]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, port=port, mode=mode)

    @classmethod
    def save(cls: ClassOf[Settings[Any]], port: int) -> Settings[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, port=port)

    @classmethod
    def load(cls: ClassOf[Settings[Any]], port: int) -> Settings[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, port=port)

    @classmethod
    def default(cls: ClassOf[Settings[Any]], port: int) -> Settings[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, port=port)

    @classmethod
    def apply(
        cls: ClassOf[Settings[Any]],
        port: int,
        mode: types.Mode,
        baud: int,
        limit: int | None = None,
    ) -> Settings[None]:
        """Apply the new setting and send no acknowledge (5-series devices)."""
        return cls(FunctionSelector.APPLY, port=port, mode=mode, baud=baud, limit=limit)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SettingsResponse,)
        return ()


class SetTime(Command[R]):
    """Set time (0x01,0x03).

    Two responses for one command.

    Functions: `write`, `read` and `apply`. Response: `SetTimeFastResponse` or
    `SetTimeSlowResponse`. Supported by Model A and Model C.

    Send it once a second.

    - guide: Set time
    """

    __slots__ = ("function", "part", "value")
    __match_args__ = ("function", "part", "value")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x03
    NAME = "tools.set_time"
    ROLE = "command"
    RESPONSES = (SetTimeFastResponse, SetTimeSlowResponse)
    REQUIRED = {1: 2, 2: 1, 6: 2}
    _LAYOUT = (("function", "B", FunctionSelector), ("part", "B", types.Mode), ("value", "I", None))
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    part: types.Mode | None
    """Which half of the time."""
    value: int | None
    """The new value. Unit: s. Required for `write` and `apply`."""

    def __init__(
        self, function: FunctionSelector, part: types.Mode | None = None, value: int | None = None
    ) -> None:
        self.function = function
        self.part = part
        self.value = value

    @classmethod
    def write(cls: ClassOf[SetTime[Any]], part: types.Mode, value: int) -> SetTime[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, part=part, value=value)

    @classmethod
    def read(
        cls: ClassOf[SetTime[Any]], part: types.Mode
    ) -> SetTime[SetTimeFastResponse | SetTimeSlowResponse]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, part=part)

    @classmethod
    def apply(cls: ClassOf[SetTime[Any]], part: types.Mode, value: int) -> SetTime[None]:
        """Apply the new setting and send no acknowledge (5-series devices)."""
        return cls(FunctionSelector.APPLY, part=part, value=value)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ and self.part == 1:
            return (SetTimeFastResponse,)
        if self.function == FunctionSelector.READ and self.part == 2:
            return (SetTimeSlowResponse,)
        return ()


class Status(Command[StatusPaged | StatusShort | StatusLong | StatusOld | StatusFull]):
    """Status (0x01,0x04).

    Layouts of one response, told apart by constants and by size.

    For advanced use. Response: `StatusPaged`, `StatusShort`, `StatusLong`, `StatusOld` or
    `StatusFull`. The device may take 2.5 s to reply. Supported by Model A, Model B and Model C.

    - guide: Status
    """

    __slots__ = ("selector",)
    __match_args__ = ("selector",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x04
    NAME = "tools.status"
    ROLE = "command"
    RESPONSES = (StatusPaged, StatusShort, StatusLong, StatusOld, StatusFull)
    TIMEOUT = 2.5
    _LAYOUT = (("model", "H", 4711), ("selector", "B", None))

    # On the wire only: model. The model that the layouts belong to. Always 4711.
    selector: int
    """Which layout. Range: 1 to 2.

    - On the Model C: always 2. Inferred: It has one layout.
    """

    def __init__(self, selector: int) -> None:
        self.selector = selector

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return b"\x12g".startswith(data[0:2])

    @property
    def expected(self) -> ResponseClasses:
        if self.selector == 1:
            return (StatusPaged, StatusShort)
        if self.selector == 2:
            return (StatusLong, StatusOld, StatusFull)
        return ()


class Bias(Command[R]):
    """Bias (0x01,0x05).

    Its response serves another command too.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `BiasVector`. Changes
    `measurements.Accel` and `measurements.Gust`. Probably changes more (0x81). Supported by Model A
    and Model C.

    - guide: Bias
    - leaflet: Bias
    """

    __slots__ = ("function", "bias")
    __match_args__ = ("function", "bias")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x05
    NAME = "tools.bias"
    ROLE = "command"
    RESPONSES = (BiasVector,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}
    _LAYOUT = (("function", "B", FunctionSelector), ("bias", "fff", types.Vector3f))
    _ALWAYS = 1

    _VECTORS = {"bias": (types.Vector3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    bias: types.Vector3f | None
    """Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for `write`.
    """

    def __init__(
        self, function: FunctionSelector, bias: types.Vector3f | codec.Numbers | None = None
    ) -> None:
        self.function = function
        self.bias = codec.vector(bias, types.Vector3f)

    @classmethod
    def write(cls: ClassOf[Bias[Any]], bias: types.Vector3f | codec.Numbers) -> Bias[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, bias=bias)

    @classmethod
    def read(cls: ClassOf[Bias[Any]]) -> Bias[BiasVector]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[Bias[Any]]) -> Bias[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[Bias[Any]]) -> Bias[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[Bias[Any]]) -> Bias[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (BiasVector,)
        return ()


class CaptureBias(Command[BiasVector]):
    """Capture bias (0x01,0x06).

    Measures the bias.

    Response: `BiasVector`. Probably changes `measurements.Accel`. Supported by Model A and Model C.
    Deprecated on the Model C: use `Bias` instead. On the Model C: firmware >= 1.0, < 1.1.

    - guide: Capture bias
    """

    __slots__ = ("time",)
    __match_args__ = ("time",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x06
    NAME = "tools.capture_bias"
    ROLE = "command"
    RESPONSES = (BiasVector,)
    _LAYOUT = (("time", "H", None),)

    time: int
    """How long. Unit: s. Range: 1 to 30."""

    def __init__(self, time: int) -> None:
        self.time = time


class Formats(Command[None]):
    """Formats (0x01,0x07).

    Counted arrays of structures and of numbers; not answered if told so.

    Not acknowledged if `suppress_ack` is true. Supported by Model A and Model C.

    - guide: Formats
    """

    __slots__ = ("suppress_ack", "checkpoint", "segments")
    __match_args__ = ("suppress_ack", "checkpoint", "segments")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x07
    NAME = "tools.formats"
    ROLE = "command"
    _LAYOUT = (
        ("suppress_ack", "B", codec.truth),
        ("num_segments", "B", wire.Counts("segments", 25)),
        ("checkpoint", "B", None),
        ("segments", "", wire.Items(types.Segment, "num_segments", 25)),
    )

    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: num_segments. Number of segments. Counts the elements of `segments`.
    checkpoint: int
    """Between a counter and its array. Deprecated."""
    segments: tuple[types.Segment, ...]
    """The segments."""

    def __init__(
        self, suppress_ack: bool, checkpoint: int, segments: Sequence[types.Segment]
    ) -> None:
        self.suppress_ack = suppress_ack
        self.checkpoint = checkpoint
        self.segments = codec.several(segments)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class Choice(Command[R]):
    """Choice (0x01,0x08).

    A tagged union with an empty variant, nested unions, arrays and strings in it.

    Functions: `write` and `read`. Response: `ChoiceResponse`. Supported by Model A.

    - guide: Choice
    """

    __slots__ = ("function", "instance", "shape", "parameters")
    __match_args__ = ("function", "instance", "shape", "parameters")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x08
    NAME = "tools.choice"
    ROLE = "command"
    RESPONSES = (ChoiceResponse,)
    REQUIRED = {1: 3, 2: 1}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("instance", "B", None),
        ("shape", "B", Shape),
        (
            "parameters",
            "",
            wire.Union(
                "shape",
                {
                    1: ("circle", "", Circle),
                    2: ("path", "", Path),
                    3: ("rotation", "ffff", types.Quatf),
                    4: ("label", "", wire.Text(8, 8)),
                },
            ),
        ),
    )
    _ALWAYS = 1

    _VECTORS = {"parameters": (types.Quatf,)}

    function: FunctionSelector
    """Operation on the setting."""
    instance: int | None
    """Which one."""
    shape: Shape | None
    """Which member follows. Required for `write`."""
    parameters: Circle | Path | types.Quatf | str | None
    """The member. Selected by `shape`. Required for `write`.

    - If `shape` is `Shape.NONE`: `None`.
    - If `shape` is `Shape.CIRCLE`: `Circle`.
    - If `shape` is `Shape.PATH`: `Path`.
    - If `shape` is `Shape.TURN`: `types.Quatf`. A rotation. Elements: w, x, y, z. Unit: 1.
    - If `shape` is `Shape.LABEL`: `str`. A name.
    """

    def __init__(
        self,
        function: FunctionSelector,
        instance: int | None = None,
        shape: Shape | None = None,
        parameters: Circle | Path | types.Quatf | str | None | codec.Numbers = None,
    ) -> None:
        self.function = function
        self.instance = instance
        self.shape = shape
        self.parameters = codec.vector(parameters, types.Quatf)

    @classmethod
    def write(
        cls: ClassOf[Choice[Any]],
        instance: int,
        shape: Shape,
        parameters: Circle | Path | types.Quatf | str | None | codec.Numbers,
    ) -> Choice[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, instance=instance, shape=shape, parameters=parameters)

    @classmethod
    def read(cls: ClassOf[Choice[Any]], instance: int) -> Choice[ChoiceResponse]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, instance=instance)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ChoiceResponse,)
        return ()


class List(Command[R]):
    """List (0x01,0x09).

    Optional counted array; a read may carry a zero count.

    Functions: `write`, `read` and `save`. Response: `ListResponse`. Supported by Model A and Model
    C.

    - guide: List
    """

    __slots__ = ("function", "items")
    __match_args__ = ("function", "items")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x09
    NAME = "tools.list"
    ROLE = "command"
    RESPONSES = (ListResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0}
    _LAYOUT = (
        ("function", "B", FunctionSelector),
        ("count", "B", wire.Counts("items", 125)),
        ("items", "H", wire.Items(None, "count", 125)),
    )
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    # On the wire only: count. Number of items. Counts the elements of `items`. Required for
    # `write`.
    items: tuple[int, ...] | None
    """The items. Required for `write`."""

    def __init__(self, function: FunctionSelector, items: Sequence[int] | None = None) -> None:
        self.function = function
        self.items = codec.several(items)

    @classmethod
    def write(cls: ClassOf[List[Any]], items: Sequence[int]) -> List[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, items=items)

    @classmethod
    def read(cls: ClassOf[List[Any]]) -> List[ListResponse]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[List[Any]]) -> List[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ListResponse,)
        return ()


class Inventory(Command[InventoryResponse]):
    """Inventory (0x01,0x0A).

    Answers with an array to the end of the field.

    Response: `InventoryResponse`. Supported by Model A and Model C.

    - guide: Inventory
    """

    __slots__ = ()

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x0A
    NAME = "tools.inventory"
    ROLE = "command"
    RESPONSES = (InventoryResponse,)


class Pin(Command[R]):
    """Pin (0x01,0x0B).

    The names of one number depend on another.

    Functions: `write` and `read`. Response: `PinResponse`. Supported by Model A and Model C.

    - guide: Pin
    """

    __slots__ = ("function", "drive", "use")
    __match_args__ = ("function", "drive", "use")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x0B
    NAME = "tools.pin"
    ROLE = "command"
    RESPONSES = (PinResponse,)
    REQUIRED = {1: 2, 2: 1}
    _LAYOUT = (("function", "B", FunctionSelector), ("drive", "B", Drive), ("use", "B", None))
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    drive: Drive | None
    """What drives it."""
    use: int | None
    """How it is used. Required for `write`.

    - If `drive` is `Drive.PULSE`: values of `PulseUse`.
    - If `drive` is `Drive.SERIAL`: values of `SerialUse`.
    """

    def __init__(
        self, function: FunctionSelector, drive: Drive | None = None, use: int | None = None
    ) -> None:
        self.function = function
        self.drive = drive
        self.use = use

    @classmethod
    def write(cls: ClassOf[Pin[Any]], drive: Drive, use: int) -> Pin[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, drive=drive, use=use)

    @classmethod
    def read(cls: ClassOf[Pin[Any]], drive: Drive) -> Pin[PinResponse]:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, drive=drive)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (PinResponse,)
        return ()


class Hello(Command[HelloResponse]):
    """Hello (0x01,0x0C).

    The device asks and a host answers.

    No device is known for certain to support it. Also called `keep_alive`. Response:
    `HelloResponse`. Sent by the device; the host replies. Known only from the Kit of names.

    - sheet: Hello
    """

    __slots__ = ("reserved", "later")
    __match_args__ = ("reserved", "later")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x0C
    NAME = "tools.hello"
    ROLE = "command"
    RESPONSES = (HelloResponse,)
    _LAYOUT = (("reserved", "f", None), ("later", "dd", tuple))
    _ALWAYS = 1

    reserved: float
    """Reserved: send 1.0."""
    later: tuple[float, float] | None
    """Reserved: send 0.0. Optional."""

    def __init__(self, reserved: float = 1.0, later: Sequence[float] | None = None) -> None:
        self.reserved = reserved
        self.later = codec.several(later)


class Readings(Command[ReadingsResponse]):
    """Readings (0x01,0x0D).

    A parameter outside of a structure says how its members are read.

    Response: `ReadingsResponse`. Supported by Model A and Model C.

    - guide: Readings
    """

    __slots__ = ("drive",)
    __match_args__ = ("drive",)

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x0D
    NAME = "tools.readings"
    ROLE = "command"
    RESPONSES = (ReadingsResponse,)
    _LAYOUT = (("drive", "B", Drive),)

    drive: Drive
    """What is asked for."""

    def __init__(self, drive: Drive) -> None:
        self.drive = drive


class Poll(Command[None]):
    """Poll (0x01,0x0E).

    Descriptors of a set that a parameter names, and of one that is always the same.

    Supported by Model C.

    - guide: Formats
    """

    __slots__ = ("descriptor_set", "first", "descriptors")
    __match_args__ = ("descriptor_set", "first", "descriptors")

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x0E
    NAME = "tools.poll"
    ROLE = "command"
    _LAYOUT = (
        ("descriptor_set", "B", None),
        ("first", "B", None),
        ("count", "B", wire.Counts("descriptors", 250)),
        ("descriptors", "B", wire.Items(None, "count", 250)),
    )

    descriptor_set: int
    """Data descriptor set. Range: 0x80 to 0xFE."""
    first: int
    """Field descriptor. Refers to fields of Measurements. Default: 0x01."""
    # On the wire only: count. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[int, ...]
    """Field descriptors. Refers to fields of `descriptor_set`."""

    def __init__(self, descriptor_set: int, first: int, descriptors: Sequence[int]) -> None:
        self.descriptor_set = descriptor_set
        self.first = first
        self.descriptors = codec.several(descriptors)


SettingsResponse.COMMANDS = (Settings,)
SetTimeFastResponse.COMMANDS = (SetTime,)
SetTimeSlowResponse.COMMANDS = (SetTime,)
ChoiceResponse.COMMANDS = (Choice,)
ListResponse.COMMANDS = (List,)
InventoryResponse.COMMANDS = (Inventory,)
PinResponse.COMMANDS = (Pin,)
HelloResponse.COMMANDS = (Hello,)
ReadingsResponse.COMMANDS = (Readings,)
StatusPaged.COMMANDS = (Status,)
StatusShort.COMMANDS = (Status,)
StatusLong.COMMANDS = (Status,)
StatusOld.COMMANDS = (Status,)
StatusFull.COMMANDS = (Status,)
BiasVector.COMMANDS = (Bias, CaptureBias)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Ping,),
    0x02: (Settings,),
    0x03: (SetTime,),
    0x04: (Status,),
    0x05: (Bias,),
    0x06: (CaptureBias,),
    0x07: (Formats,),
    0x08: (Choice,),
    0x09: (List,),
    0x0A: (Inventory,),
    0x0B: (Pin,),
    0x0C: (Hello,),
    0x0D: (Readings,),
    0x0E: (Poll,),
    0x82: (SettingsResponse,),
    0x83: (SetTimeFastResponse,),
    0x84: (SetTimeSlowResponse,),
    0x88: (ChoiceResponse,),
    0x89: (ListResponse,),
    0x8A: (InventoryResponse,),
    0x8B: (PinResponse,),
    0x8C: (HelloResponse,),
    0x8D: (ReadingsResponse,),
    0x90: (StatusPaged, StatusShort, StatusLong, StatusOld, StatusFull),
    0x9B: (BiasVector,),
}
