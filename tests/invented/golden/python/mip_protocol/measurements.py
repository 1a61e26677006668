"""Measurements (0x80, 0x81, 0x92).

Data of every type; `tools` has what they are set up with.

- measurements (0x80): Data of every type; `tools` has what they are set up with.
- more (0x81): A second sensor with some fields of the first.
- copy (0x92): All the fields of another set. Uncertain: Which device sends it.
"""

from __future__ import annotations

from collections.abc import Sequence

from . import codec, types
from .errors import Truncated
from .field import Data, Field, Shared

_ACCEL_0 = codec.Block("fffH", *["scaled_accel"] * 3, "valid_flags")


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
    """Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element has its own valid
    flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`,
    z: `types.StateFlags.READY` of `valid_flags`.

    - On the Model B: unit m, m, s; frame ned; valid flags x: `types.StateFlags.HOT` of
      `valid_flags`, y: `types.StateFlags.READY` of `valid_flags`, z: `types.StateFlags.HOT` of
      `valid_flags`. Turned by the device.
    - On the Model C: no flag says whether it is valid.
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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Accel, int]:
        v = _ACCEL_0.read(raw, at)
        at += 14
        scaled_accel = types.Vector3f._make(v[0:3])
        valid_flags = types.StateFlags(v[3])
        return cls(scaled_accel, valid_flags), at

    def _write(self) -> bytes:
        out = _ACCEL_0.write(
            *codec.elements("scaled_accel", self.scaled_accel, 3), self.valid_flags
        )
        return codec.finished(out)


_NUMBERS_0 = codec.Block(
    "BHIQbhiqfdBB",
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


class Numbers(Shared, Data):
    """Numbers (0x02).

    One of each.

    Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C. Probably
    supported by Old 1 and Old 2.

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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Numbers, int]:
        v = _NUMBERS_0.read(raw, at)
        at += 44
        u8 = v[0]
        u16 = v[1]
        u32 = v[2]
        u64 = v[3]
        s8 = v[4]
        s16 = v[5]
        s32 = v[6]
        s64 = v[7]
        float_ = v[8]
        double = v[9]
        bool_ = codec.truth(v[10])
        char = v[11]
        return cls(u8, u16, u32, u64, s8, s16, s32, s64, float_, double, bool_, char), at

    def _write(self) -> bytes:
        out = _NUMBERS_0.write(
            self.u8,
            self.u16,
            self.u32,
            self.u64,
            self.s8,
            self.s16,
            self.s32,
            self.s64,
            self.float_,
            self.double,
            self.bool_,
            self.char,
        )
        return codec.finished(out)


_STRINGS_0 = codec.Block("B", "length")


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

    model: str
    """Padded with spaces."""
    # On the wire only: length. Of the name. The number of elements of `name`.
    name: str
    """The name."""
    rest: str
    """All that follows."""

    def __init__(self, model: str, name: str, rest: str) -> None:
        self.model = model
        self.name = name
        self.rest = rest

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Strings, int]:
        model = codec.take(raw, at, 16).decode("latin-1")
        at += 16
        v = _STRINGS_0.read(raw, at)
        at += 1
        length = v[0]
        n = codec.counted(raw, at, length, 1, 236)
        name = codec.take(raw, at, n).decode("latin-1")
        at += n
        n = codec.remaining(raw, at, 1)
        rest = codec.take(raw, at, n).decode("latin-1")
        at += n
        return cls(model, name, rest), at

    def _write(self) -> bytes:
        out = codec.padded("model", self.model, 16)
        out += _STRINGS_0.write(codec.count("name", self.name, 236))
        codec.at_most("name", self.name, 236)
        out += codec.text("name", self.name)
        codec.at_most("rest", self.rest, 236)
        out += codec.text("rest", self.rest)
        return codec.finished(out)


_HEALTH_0 = codec.Block("BBBBBBBBBBBBBBBBI", *["result"] * 16, "code")


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

    result: types.Health
    """The bits."""
    code: types.WideCode
    """An enumeration over four bytes."""

    def __init__(self, result: types.Health, code: types.WideCode) -> None:
        self.result = result
        self.code = code

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Health, int]:
        v = _HEALTH_0.read(raw, at)
        at += 20
        result = types.Health(int.from_bytes(bytes(v[0:16]), "little"))
        code = types.WideCode(v[16])
        return cls(result, code), at

    def _write(self) -> bytes:
        out = _HEALTH_0.write(*codec.little("result", self.result, 16), self.code)
        return codec.finished(out)


_ARRAYS_0 = codec.Block("BBBHH", *["modes"] * 3, *["flags"] * 2)
_ARRAYS_1 = codec.Block("bbbb", *["offsets"] * 4)


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Arrays, int]:
        v = _ARRAYS_0.read(raw, at)
        at += 7
        modes = tuple(map(types.Mode, v[0:3]))
        flags = tuple(map(types.StateFlags, v[3:5]))
        vectors = codec.read_vectors(types.Vector3f, "f", 3, raw, at, 2)
        at += 2 * 12
        points, at = codec.read_structures(types.Point, raw, at, 2)
        track, at = types.Segment._read(raw, at)
        v = _ARRAYS_1.read(raw, at)
        at += 4
        offsets = v[0:4]
        return cls(modes, flags, vectors, points, track, offsets), at

    def _write(self) -> bytes:
        out = _ARRAYS_0.write(
            *codec.exactly("modes", self.modes, 3), *codec.exactly("flags", self.flags, 2)
        )
        out += codec.write_vectors("vectors", "f", 3, codec.exactly("vectors", self.vectors, 2))
        out += codec.write_structures(
            "points", codec.exactly("points", self.points, 2), types.Point
        )
        out += codec.structure("track", self.track, types.Segment)
        out += _ARRAYS_1.write(*codec.exactly("offsets", self.offsets, 4))
        return codec.finished(out)


_GROWING_0 = codec.Block("H", "first")
_GROWING_1 = codec.Block("H", "second")
_GROWING_2 = codec.Block("f", "third")
_GROWING_GROUPS = ((2, ("second",), False), (3, ("third",), False))


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Growing, int]:
        second: int | None = None
        third: float | None = None
        v = _GROWING_0.read(raw, at)
        at += 2
        first = v[0]
        required = 1
        done, end = 1, at
        try:
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _GROWING_1.read(raw, at)
            at += 2
            second = v[0]
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _GROWING_2.read(raw, at)
            at += 4
            third = v[0]
            done, end = 3, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(first, second, third), at

    def _write(self) -> bytes:
        out = _GROWING_0.write(self.first)
        required = 1
        there = codec.present(self, required, _GROWING_GROUPS)
        if there >= 2:
            out += _GROWING_1.write(self.second)
        if there >= 3:
            out += _GROWING_2.write(self.third)
        return codec.finished(out)


_RADIO_0 = codec.Block("Biffdd", "connected", "strength", "noise", "gap", *["gaps"] * 2)


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Radio, int]:
        v = _RADIO_0.read(raw, at)
        at += 29
        connected = codec.truth(v[0])
        strength = v[1]
        noise = v[2]
        gap = v[3]
        gaps = v[4:6]
        return cls(connected, strength, noise, gap, gaps), at

    def _write(self) -> bytes:
        out = _RADIO_0.write(
            self.connected,
            self.strength,
            self.noise,
            self.gap,
            *codec.exactly("gaps", self.gaps, 2),
        )
        return codec.finished(out)


_OWN_0 = codec.Block("B", "mode")


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Own, int]:
        v = _OWN_0.read(raw, at)
        at += 1
        mode = types.Mode(v[0])
        return cls(mode), at

    def _write(self) -> bytes:
        out = _OWN_0.write(self.mode)
        return codec.finished(out)


_CLOUD_0 = codec.Block("B", "num_points")
_CLOUD_1 = codec.Block("Q", "stamp")


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

    # On the wire only: num_points. Number of points. The number of elements of `points`.
    points: tuple[types.Point, ...]
    """The points."""
    stamp: int
    """Behind an array that fills the field. Unit: s."""

    def __init__(self, points: Sequence[types.Point], stamp: int) -> None:
        self.points = codec.several(points)
        self.stamp = stamp

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Cloud, int]:
        v = _CLOUD_0.read(raw, at)
        at += 1
        num_points = v[0]
        n = codec.counted(raw, at, num_points, 4, 61)
        points, at = codec.read_structures(types.Point, raw, at, n)
        v = _CLOUD_1.read(raw, at)
        at += 8
        stamp = v[0]
        return cls(points, stamp), at

    def _write(self) -> bytes:
        out = _CLOUD_0.write(codec.count("points", self.points, 61))
        out += codec.write_structures(
            "points", codec.at_most("points", self.points, 61), types.Point
        )
        out += _CLOUD_1.write(self.stamp)
        return codec.finished(out)


_GUST_0 = codec.Block("B", "station")
_GUST_1 = codec.Block("ffffB", "height", *["speed"] * 3, "gap")
_GUST_2 = codec.Block("H", "valid_flags")


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Gust, int]:
        v = _GUST_0.read(raw, at)
        at += 1
        station = v[0]
        place, at = types.Point._read(raw, at)
        v = _GUST_1.read(raw, at)
        at += 17
        height = v[0]
        speed = types.Vector3f._make(v[1:4])
        codec.constant(v[4], 7)
        v = _GUST_2.read(raw, at)
        at += 2
        valid_flags = types.StateFlags(v[0])
        return cls(station, place, height, speed, valid_flags), at

    def _write(self) -> bytes:
        out = _GUST_0.write(self.station)
        out += codec.structure("place", self.place, types.Point)
        out += _GUST_1.write(self.height, *codec.elements("speed", self.speed, 3), 7)
        out += _GUST_2.write(self.valid_flags)
        return codec.finished(out)


_BREEZE_0 = codec.Block("fffff", "height", *["turn"] * 4)


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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Breeze, int]:
        place, at = types.Point._read(raw, at)
        v = _BREEZE_0.read(raw, at)
        at += 20
        height = v[0]
        turn = types.Quatf._make(v[1:5])
        return cls(place, height, turn), at

    def _write(self) -> bytes:
        out = codec.structure("place", self.place, types.Point)
        out += _BREEZE_0.write(self.height, *codec.elements("turn", self.turn, 4))
        return codec.finished(out)


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
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
