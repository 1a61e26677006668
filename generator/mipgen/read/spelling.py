"""Alternative spellings of known words: type names of other languages, common units, look-alike characters."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection

#: Known word -> other spellings with the same meaning: km/h is not a spelling of m/s.
SYNONYMS = {
    # types
    "u8": ("uint8_t", "uint8", "unsigned char", "uchar", "byte", "ubyte", "octet"),
    "u16": ("uint16_t", "uint16", "unsigned short", "ushort", "word"),
    "u32": ("uint32_t", "uint32", "unsigned int", "unsigned", "uint", "dword"),
    "u64": ("uint64_t", "uint64", "unsigned long long", "qword"),
    "s8": ("int8_t", "int8", "i8", "signed char"),
    "s16": ("int16_t", "int16", "i16", "short"),
    "s32": ("int32_t", "int32", "i32", "int", "integer", "long"),
    "s64": ("int64_t", "int64", "i64", "long long"),
    "float": ("float32_t", "float32", "f32", "real", "single"),
    "double": ("float64_t", "float64", "f64"),
    "bool": ("boolean", "_bool", "bool_t"),
    "char": ("string", "str", "text"),
    "vector3f": ("vec3f", "vec3", "vector3", "vector", "float[3]"),
    "vector3d": ("vec3d", "double[3]"),
    "matrix3f": ("mat3f", "mat3", "matrix3", "matrix", "dcm"),
    "quatf": ("quaternion", "quat", "float[4]"),
    # units
    "1": ("none", "dimensionless", "unitless", "-", "count", "ratio"),
    "m": ("meter", "meters", "metre", "metres"),
    "m/s": ("m/sec", "mps", "meters/second", "metres/second", "meters/sec", "metres/sec", "m s^-1"),
    "m/s^2": ("m/s2", "m/s²", "m/s/s", "m/sec^2", "m/sec2", "m/s**2", "m s^-2"),
    "s": ("sec", "secs", "second", "seconds"),
    "ms": ("msec", "millisecond", "milliseconds"),
    "us": ("µs", "usec", "microsecond", "microseconds"),
    "ns": ("nsec", "nanosecond", "nanoseconds"),
    "week": ("weeks",),
    "rad": ("radian", "radians"),
    "rad/s": ("rad/sec", "radians/second"),
    "rad/s^2": ("rad/s2", "rad/s²", "rad/s/s", "rad/sec^2"),
    "deg": ("°", "degree", "degrees"),
    "deg/s": ("°/s", "deg/sec", "dps", "degrees/second"),
    "Hz": ("hertz", "cycles/s"),
    "1/s": ("s^-1", "1/sec"),
    "Bd": ("baud", "bps", "bit/s"),
    "degC": ("°C", "C", "celsius", "deg c"),
    "g": ("gee", "gees"),
    "gauss": ("gs",),
    "mbar": ("millibar", "mb", "hpa", "hectopascal"),
    "%": ("percent", "pct"),
    "byte": ("bytes", "B"),
    "min": ("minute", "minutes"),
    "day": ("days",),
    "cycle": ("cycles",),
    "dB-Hz": ("dbhz", "db hz", "db*hz"),
    "kg/m^3": ("kg/m3", "kg/m³"),
    "V": ("volt", "volts"),
    # keys
    "description": ("desc", "doc", "docs", "comment", "summary"),
    "range": ("min", "max", "minimum", "maximum", "limits"),
    "count": ("length", "len", "size", "elements"),
}

#: Look-alike characters -> the characters that they resemble.
_STRAIGHT = str.maketrans(
    {
        **dict.fromkeys("\u2010\u2011\u2012\u2013\u2014\u2015\u2212", "-"),
        **dict.fromkeys("\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000", " "),
        **dict.fromkeys("\u201c\u201d\u201e\u201f\u00ab\u00bb", '"'),
        **dict.fromkeys("\u2018\u2019\u201a\u201b\u00b4", "'"),
        **dict.fromkeys("\u200b\u200c\u200d\u2060\ufeff", ""),
        "\u00d7": "x",
        "\u2215": "/",
        "\u2044": "/",
        "\uff1a": ":",
        "\uff0c": ",",
    }
)

_USUAL = {spelling.casefold(): word for word, spellings in SYNONYMS.items() for spelling in spellings}


def usual_word(word: str, words: Collection[str]) -> str | None:
    """Returns the known word with the same meaning, if there is one.

    >>> usual_word("uint32_t", ["u16", "u32"]), usual_word("deg/sec", ["deg/s"]), usual_word("HZ", ["Hz"])
    ('u32', 'deg/s', 'Hz')
    >>> usual_word("km/h", ["m/s"]), usual_word("uint32_t", ["m/s"])
    (None, None)
    """
    folded = word.casefold().strip()
    canonical = _USUAL.get(folded)
    return canonical if canonical in words else next((k for k in words if k.casefold() == folded), None)


def straight(text: str) -> str:
    """
    >>> straight("4–6"), straight("“mode”"), straight("mode")
    ('4-6', '"mode"', 'mode')
    """
    return text.translate(_STRAIGHT)


def strange(text: str, usual: str = "") -> str:
    """Names the characters of a text that do not belong in a name or a number, except the characters in `usual`.

    >>> strange("4–6"), strange("4-6")
    ("; '–' is an en dash (U+2013), write '-'", '')
    >>> strange("\\u00a0level"), strange("mоde")
    ("; U+00A0 is a no-break space, write ' '", "; 'о' is a cyrillic small letter o (U+043E), write plain letters")
    """
    remarks = []
    for c in dict.fromkeys(text):
        if c.isascii() or c in usual:
            continue
        what = unicodedata.name(c, "special character").lower()
        article = "an" if what[0] in "aeiou" else "a"
        straight = c.translate(_STRAIGHT)
        remedy = "remove it" if not straight else f"write '{straight}'" if straight != c else "write plain letters"
        shown = f"'{c}' is {article} {what} (U+{ord(c):04X})"
        remarks.append(f"; {shown if straight.strip() else f'U+{ord(c):04X} is {article} {what}'}, {remedy}")
    return "".join(remarks)
