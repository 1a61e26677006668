"""Measurements (0x80, 0x81, 0x92).

Data of every type; `tools` has what they are set up with.

- measurements (0x80): Data of every type; `tools` has what they are set up with.
- more (0x81): A second sensor with some fields of the first.
- copy (0x92): All the fields of another set. Uncertain: Which device sends it.
"""

from __future__ import annotations

from collections.abc import Sequence

from . import codec, types, wire
from .field import Data, Field, Shared


class Accel(Shared, Data):
    """Acceleration (0x01).

    A vector whose elements are valid together.

    Occurs in measurements (0x80), more (0x81) and copy (0x92). Maximum rate: 100 Hz. Supported by
    Model A, Model B and Model C. On the Model C: firmware > 1.0.07.

    - guide: Acceleration
    - leaflet: Acceleration
    - guide: Second acceleration
    - guide: Third acceleration
    """

    __slots__ = ("scaled_accel", "valid_flags")
    __match_args__ = ("scaled_accel", "valid_flags")

    SETS = (0x80, 0x81, 0x92)
    DESCRIPTOR = 0x01
    NAME = "measurements.accel"
    ROLE = "data"
    _LAYOUT = (("scaled_accel", "fff", types.Vector3f), ("valid_flags", "H", types.StateFlags))

    _VECTORS = {"scaled_accel": (types.Vector3f,)}

    scaled_accel: types.Vector3f
    """Specific force. Elements: x, y, z. Unit: g. Frame: sensor. At rest and level: x 0, z -1.
    Positive: along `types.Point`. Each element has its own valid flag. x: `types.StateFlags.READY`
    of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`, z: `types.StateFlags.READY` of
    `valid_flags`.

    - On the Model B: unit m, m, s; frame ned; valid flags x: `types.StateFlags.HOT` of
      `valid_flags`, y: `types.StateFlags.READY` of `valid_flags`, z: `types.StateFlags.HOT` of
      `valid_flags`. Turned by the device.
    - On the Model C: no flag marks it as valid.
    """
    valid_flags: types.StateFlags
    """What is valid.

    - On the Model C: only `types.StateFlags.READY` and `types.StateFlags.LEVEL`.
    """

    def __init__(
        self, scaled_accel: types.Vector3f | codec.Numbers, valid_flags: types.StateFlags
    ) -> None:
        self.scaled_accel = codec.vector(scaled_accel, types.Vector3f)
        self.valid_flags = valid_flags


class Numbers(Shared, Data):
    """Numbers (0x02).

    One of each.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.

    - guide: Numbers
    """

    __slots__ = (
        "u8",
        "u16",
        "u32",
        "u64",
        "s8",
        "s16",
        "s32",
        "s64",
        "float_",
        "double",
        "bool_",
        "char",
    )
    __match_args__ = (
        "u8",
        "u16",
        "u32",
        "u64",
        "s8",
        "s16",
        "s32",
        "s64",
        "float_",
        "double",
        "bool_",
        "char",
    )

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x02
    NAME = "measurements.numbers"
    ROLE = "data"
    _LAYOUT = (
        ("u8", "B", None),
        ("u16", "H", None),
        ("u32", "I", None),
        ("u64", "Q", None),
        ("s8", "b", None),
        ("s16", "h", None),
        ("s32", "i", None),
        ("s64", "q", None),
        ("float_", "f", None),
        ("double", "d", None),
        ("bool_", "B", codec.truth),
        ("char", "B", None),
    )

    u8: int
    """Unsigned."""
    u16: int
    """Unsigned."""
    u32: int
    """Unsigned."""
    u64: int
    """Unsigned."""
    s8: int
    """Signed."""
    s16: int
    """Signed."""
    s32: int
    """Signed."""
    s64: int
    """Signed."""
    float_: float
    """Four bytes. Unit: 1."""
    double: float
    """Eight bytes. Unit: 1."""
    bool_: bool
    """True or false."""
    char: int
    """One character."""

    def __init__(
        self,
        u8: int,
        u16: int,
        u32: int,
        u64: int,
        s8: int,
        s16: int,
        s32: int,
        s64: int,
        float_: float,
        double: float,
        bool_: bool,
        char: int,
    ) -> None:
        self.u8 = u8
        self.u16 = u16
        self.u32 = u32
        self.u64 = u64
        self.s8 = s8
        self.s16 = s16
        self.s32 = s32
        self.s64 = s64
        self.float_ = float_
        self.double = double
        self.bool_ = bool_
        self.char = char


class Strings(Shared, Data):
    """Strings (0x03).

    Fixed, counted, and to the end.

    Occurs in measurements (0x80), more (0x81) and copy (0x92). Supported by Model A and Model C.

    - guide: Strings
    - guide: Second strings
    """

    __slots__ = ("model", "name", "rest")
    __match_args__ = ("model", "name", "rest")

    SETS = (0x80, 0x81, 0x92)
    DESCRIPTOR = 0x03
    NAME = "measurements.strings"
    ROLE = "data"
    _LAYOUT = (
        ("model", "", wire.Text(16, 16)),
        ("length", "B", wire.Counts("name", 236)),
        ("name", "", wire.Text("length", 236)),
        ("rest", "", wire.Text(None, 236)),
    )

    model: str
    """Padded with spaces."""
    # On the wire only: length. Of the name. Counts the elements of `name`.
    name: str
    """The name."""
    rest: str
    """All that follows."""

    def __init__(self, model: str, name: str, rest: str) -> None:
        self.model = model
        self.name = name
        self.rest = rest


class Health(Shared, Data):
    """Health (0x04).

    The wide bitfield.

    Deprecated: use `Numbers` instead. Occurs in measurements (0x80) and copy (0x92). Supported by
    Model A and Model C.

    - guide: Health
    """

    __slots__ = ("result", "code")
    __match_args__ = ("result", "code")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x04
    NAME = "measurements.health"
    ROLE = "data"
    _LAYOUT = (
        ("result", "BBBBBBBBBBBBBBBB", wire.Bits(types.Health)),
        ("code", "I", types.WideCode),
    )

    result: types.Health
    """The bits."""
    code: types.WideCode
    """An enumeration over four bytes."""

    def __init__(self, result: types.Health, code: types.WideCode) -> None:
        self.result = result
        self.code = code


class Arrays(Shared, Data):
    """Arrays (0x05).

    Arrays of all that can stand in one.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.

    - guide: Arrays
    """

    __slots__ = ("modes", "flags", "vectors", "points", "track", "offsets")
    __match_args__ = ("modes", "flags", "vectors", "points", "track", "offsets")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x05
    NAME = "measurements.arrays"
    ROLE = "data"
    _LAYOUT = (
        ("modes", "BBB", wire.Each(types.Mode)),
        ("flags", "HH", wire.Each(types.StateFlags)),
        ("vectors", "fff", wire.Items(types.Vector3f, 2, 2)),
        ("points", "", wire.Items(types.Point, 2, 2)),
        ("track", "", types.Segment),
        ("offsets", "bbbb", tuple),
    )

    modes: tuple[types.Mode, ...]
    """Enumerations."""
    flags: tuple[types.StateFlags, ...]
    """Bitfields."""
    vectors: tuple[types.Vector3f, types.Vector3f]
    """Vectors. Elements: x, y, z. Unit: m."""
    points: tuple[types.Point, ...]
    """Structures. Unit: m."""
    track: types.Segment
    """A nested structure."""
    offsets: tuple[int, int, int, int]
    """Reserved."""

    def __init__(
        self,
        modes: Sequence[types.Mode],
        flags: Sequence[types.StateFlags],
        vectors: Sequence[types.Vector3f | codec.Numbers],
        points: Sequence[types.Point],
        track: types.Segment,
        offsets: Sequence[int] = (0, 0, 0, 0),
    ) -> None:
        self.modes = codec.several(modes)
        self.flags = codec.several(flags)
        self.vectors = codec.vectors(vectors, types.Vector3f)
        self.points = codec.several(points)
        self.track = track
        self.offsets = codec.several(offsets)


class Growing(Shared, Data):
    """Growing (0x06).

    Newer devices send more of it.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.

    - guide: Growing
    """

    __slots__ = ("first", "second", "third")
    __match_args__ = ("first", "second", "third")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x06
    NAME = "measurements.growing"
    ROLE = "data"
    _LAYOUT = (("first", "H", None), ("second", "H", None), ("third", "f", None))
    _ALWAYS = 1

    first: int
    """Always there."""
    second: int | None
    """From version 2 on. Optional."""
    third: float | None
    """From version 3 on. Unit: deg. Optional."""

    def __init__(self, first: int, second: int | None = None, third: float | None = None) -> None:
        self.first = first
        self.second = second
        self.third = third


class Radio(Shared, Data):
    """Radio (0x07).

    A bool vouches for values; one source has no layout that agrees with it.

    Occurs in measurements (0x80) and copy (0x92). Also called `modem` and `rf`. Supported by Model
    C. Known only from the Kit of names. Uncertain: The leaflet gives the strength two bytes.
    Uncertain: Inferred: the strength is never positive.

    - sheet: Radio
    """

    __slots__ = ("connected", "strength", "noise", "gap", "gaps")
    __match_args__ = ("connected", "strength", "noise", "gap", "gaps")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x07
    NAME = "measurements.radio"
    ROLE = "data"
    _LAYOUT = (
        ("connected", "B", codec.truth),
        ("strength", "i", None),
        ("noise", "f", None),
        ("gap", "f", None),
        ("gaps", "dd", tuple),
    )

    connected: bool
    """Whether there is a connection."""
    strength: int
    """Of the signal. Range: less than 1. Valid if `connected` is true. Uncertain: Its unit."""
    noise: float
    """Never nothing. Unit: m. Range: greater than 0, at most 10. Valid if `connected` is true.

    - On the Model C: valid if `connected` is true; deprecated.
    """
    gap: float
    """Reserved. Reserved."""
    gaps: tuple[float, float]
    """Reserved."""

    def __init__(
        self,
        connected: bool,
        strength: int,
        noise: float,
        gap: float = 0.0,
        gaps: Sequence[float] = (0.0, 0.0),
    ) -> None:
        self.connected = connected
        self.strength = strength
        self.noise = noise
        self.gap = gap
        self.gaps = codec.several(gaps)


class Own(Data):
    """Own (0x81,0x07).

    In one of the sets only, with a descriptor that has another layout in the others.

    Supported by Model A and Model C. On the Model C: firmware > 1.0.07.

    - guide: Own
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x81
    SETS = (0x81,)
    DESCRIPTOR = 0x07
    NAME = "measurements.own"
    ROLE = "data"
    _LAYOUT = (("mode", "B", types.Mode),)

    mode: types.Mode
    """Of the second sensor."""

    def __init__(self, mode: types.Mode) -> None:
        self.mode = mode


class Cloud(Shared, Data):
    """Cloud (0x08).

    The count can exceed what a field holds beside the value behind the array.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.

    - guide: Cloud
    """

    __slots__ = ("points", "stamp")
    __match_args__ = ("points", "stamp")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x08
    NAME = "measurements.cloud"
    ROLE = "data"
    _LAYOUT = (
        ("num_points", "B", wire.Counts("points", 61)),
        ("points", "", wire.Items(types.Point, "num_points", 61)),
        ("stamp", "Q", None),
    )

    # On the wire only: num_points. Number of points. Counts the elements of `points`.
    points: tuple[types.Point, ...]
    """The points."""
    stamp: int
    """Behind an array that fills the field. Unit: s."""

    def __init__(self, points: Sequence[types.Point], stamp: int) -> None:
        self.points = codec.several(points)
        self.stamp = stamp


class Gust(Shared, Data):
    """Gust (0x09).

    One valid flag for all values but one; `Breeze` has the same place.

    Occurs in measurements (0x80) and copy (0x92). Not listed in any device profile.

    `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see `types.Mode` and
    `tools.Shape`.

    - guide: Gust
    """

    __slots__ = ("station", "place", "height", "speed", "valid_flags")
    __match_args__ = ("station", "place", "height", "speed", "valid_flags")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x09
    NAME = "measurements.gust"
    ROLE = "data"
    _LAYOUT = (
        ("station", "B", None),
        ("place", "", types.Point),
        ("height", "f", None),
        ("speed", "fff", types.Vector3f),
        ("gap", "B", 7),
        ("valid_flags", "H", types.StateFlags),
    )

    _VECTORS = {"speed": (types.Vector3f,)}

    station: int
    """Which one."""
    place: types.Point
    """Where it was measured. Valid if `types.StateFlags.READY` of `valid_flags` is set."""
    height: float
    """Above the plane. Unit: m. Valid if `types.StateFlags.READY` of `valid_flags` is set."""
    speed: types.Vector3f
    """Of the wind. Elements: x, y, z. Unit: m. Range: magnitude at most 40. Valid if
    `types.StateFlags.READY` of `valid_flags` is set.
    """
    # On the wire only: gap. Always the same. Always 7.
    valid_flags: types.StateFlags
    """What is valid."""

    def __init__(
        self,
        station: int,
        place: types.Point,
        height: float,
        speed: types.Vector3f | codec.Numbers,
        valid_flags: types.StateFlags,
    ) -> None:
        self.station = station
        self.place = place
        self.height = height
        self.speed = codec.vector(speed, types.Vector3f)
        self.valid_flags = valid_flags


class Breeze(Shared, Data):
    """Breeze (0x0A).

    Its place is told as in `Gust`.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.

    - guide: Breeze
    """

    __slots__ = ("place", "height", "turn")
    __match_args__ = ("place", "height", "turn")

    SETS = (0x80, 0x92)
    DESCRIPTOR = 0x0A
    NAME = "measurements.breeze"
    ROLE = "data"
    _LAYOUT = (("place", "", types.Point), ("height", "f", None), ("turn", "ffff", types.Quatf))

    _VECTORS = {"turn": (types.Quatf,)}

    place: types.Point
    """Where it was measured."""
    height: float
    """Above the plane. Unit: m."""
    turn: types.Quatf
    """Of the vane. Elements: w, x, y, z. Unit: 1. Range: -1 to 1, magnitude 0.5 to 1.5. Default: 1,
    0, 0, 0.
    """

    def __init__(
        self, place: types.Point, height: float, turn: types.Quatf | codec.Numbers
    ) -> None:
        self.place = place
        self.height = height
        self.turn = codec.vector(turn, types.Quatf)


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Accel,),
    0x02: (Numbers,),
    0x03: (Strings,),
    0x04: (Health,),
    0x05: (Arrays,),
    0x06: (Growing,),
    0x07: (Radio, Own),
    0x08: (Cloud,),
    0x09: (Gust,),
    0x0A: (Breeze,),
}
