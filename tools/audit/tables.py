"""What the vendor's comments state of a number: units, frames, ranges, defaults; and how facts are written as YAML, in
the format of `spec/witness`.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from math import pi
from typing import Any

Layout = dict[str, Any]
Rows = list[list[str]]

#: Unit symbols of the specification, each with its spellings in manuals.
UNITS = {
    "m": ["m", "meters", "meter"],
    "m/s": ["m/s", "meters/second", "meters/sec", "m/sec", "meters per second"],
    "m/s^2": ["m/s^2", "m/s²", "meters/second^2", "meters/second²", "meters/second ²", "meters/sec²", "m/sec^2"],
    "rad": ["rad", "radians", "radian"],
    "rad/s": ["rad/s", "radians/second", "radians/sec", "rad/second", "rad/sec"],
    "deg": ["deg", "degrees", "decimal degrees"],
    "degC": ["degC", "deg C", "°C", "degrees C", "degrees Celsius"],
    "s": ["s", "sec", "seconds", "second"],
    "ms": ["ms", "milliseconds", "millisecond"],
    "ns": ["ns", "Nanoseconds"],
    "min": ["minutes"],
    "day": ["days"],
    "week": ["weeks"],
    "gauss": ["gauss", "G"],
    "g": ["g", "Gs"],
    "g*s": ["g*sec", "g*seconds", "g*second"],
    "Hz": ["Hz", "hertz"],
    "mbar": ["mbar", "milliBar", "mBar"],
    "dB-Hz": ["dBHz"],
    "s/s": ["s/s", "seconds/second"],
    "s/s^2": ["s/s^2"],
    "cycle": ["Carrier periods"],
    "pulse/m": ["pulses/meter", "pulses/m"],
    "1/s": ["1/second"],
    "MHz": ["MHz"],
    "kg/m^3": ["kilogram/meter^3"],
    "V": ["volts", "scaled volts"],
    "1": ["dimensionless", "m/m"],
}  # fmt: skip
_SYMBOLS = {token.casefold() if len(token) > 1 else token: s for s, tokens in UNITS.items() for token in tokens}

#: Frames of reference, each with the words that indicate it in a text.
FRAMES = {
    "ned": r"\bNED\b|north, east,? (and )?down|local[- ]level|fixed earth coordinate",
    "ecef": r"\bECEF\b|earth[- ]centered",
    "llh": r"\bLLH\b|\bLLA\b|latitude",
    "vehicle": r"vehicle('s)? (frame|coordinate)|vehicle-frame|body frame|local coordinate system",
    "sensor": r"(sensor|device)('s)? (body )?(frame|coordinate)|local coordinate system",
    "aiding": r"external sensor|frame[ _]id|aiding frame|sensor frame ID",
}

_NUMBER = r"-?\d+(?:\.\d+)?"


def symbols(units: set[str | None]) -> dict[str, list[str]]:
    """Returns the unit symbols that a source uses, each with the source's spellings."""
    used = {symbol: [token for token in tokens if token in units] for symbol, tokens in UNITS.items()}
    return {symbol: tokens for symbol, tokens in used.items() if tokens}


def dump(facts: dict[str, Any], command: str) -> str:
    """Formats the facts as YAML, with the parameters of a layout on as few lines as they fit on."""
    text = "# yaml-language-server: $schema=../schema/witness.schema.json\n"
    text += f"# Facts that a program extracted: {command}.\n"
    for key, value in facts.items():
        if key == "layouts":
            text += "layouts:\n" + "".join(map(_record, value))
        elif key in ("structs", "enums", "bitfields", "constants", "named"):
            text += f"{key}:\n" + "".join(f"  {_flow(name)}: {_flow(entry)}\n" for name, entry in value.items())
        else:
            text += f"{key}: {_flow(value)}\n"
    return text


def _record(layout: Layout) -> str:
    head = {key: value for key, value in layout.items() if key != "parameters"}
    parts = [f"- {_flow(head)[:-1]}, parameters: [", *(f"{_flow(p)}," for p in layout["parameters"])]
    # No line ends inside a parameter.
    whole = " ".join(part.replace(" ", "\0") for part in parts).removesuffix(",") + "]}"
    lines = textwrap.wrap(whole, 120, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)
    return "\n".join(lines).replace("[ {", "[{").replace("\0", " ") + "\n"


def _flow(value: Any) -> str:
    match value:
        case dict():
            return "{" + ", ".join(f"{_flow(k)}: {_flow(v)}" for k, v in value.items()) + "}"
        case list():
            return "[" + ", ".join(map(_flow, value)) + "]"
        case str() if re.fullmatch(r"[A-Za-z_][\w ]*", value) and value.lower() not in _WORDS:
            return value
        case str():
            return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
        case bool():
            return str(value).lower()
        case None:
            return "null"
        case float():
            return repr(value).removesuffix(".0")
        case _:
            return str(value)


_WORDS = {"true", "false", "null", "yes", "no", "on", "off", "y", "n"}


def frames(text: str) -> list[str]:
    return [frame for frame, words in FRAMES.items() if re.search(words, text, re.IGNORECASE)]


#: Default of a switch -> the words that state it.
_SWITCHED = {
    1: r"default for .{0,20} all .{0,20}enabled|(enabled|filtered) by default|by default filtered",
    0: r"disabled by default",
}


def defaults(parameters: list[dict[str, Any]], about: str) -> None:
    """Adds the factory defaults of switches, enumerations and times that a description states."""
    for p in parameters:
        name = p["name"]
        switch = next((n for n, words in _SWITCHED.items() if re.search(words, about, re.IGNORECASE)), None)
        listed = re.search(r"0x0?([0-9A-F]) ?[-–] ?Enabled?\b[^0(]*\(default\)", about)
        number = re.search(rf"default ?= ?({_NUMBER}) (\w+)", about)
        if name in ("enable", "mode") and switch is not None:
            p["default"] = switch
        elif "enable" in name and listed:
            p["default"] = int(listed[1], 16)
        elif number and p.get("unit") and _SYMBOLS.get(p["unit"]) == _SYMBOLS.get(number[2]):
            p["default"] = float(number[1])
        if number and "default" in p and "unit" in p:
            limits = re.search(rf"({_NUMBER})-({_NUMBER}) {number[2]}", about)
            if limits:
                p["range"] = [float(limits[1]), float(limits[2])]


def stated_value(text: str, element: str, about: str) -> dict[str, Any]:
    """Returns the unit, the frames, the range and the exclusive lower bound that a text states."""
    facts: dict[str, Any] = {}
    unit = next((u for u in map(_unit, _units(text)) if u), None)
    if unit:
        facts["unit"] = unit
    named = frames(text)
    if named:
        facts["frames"] = named
    limits = re.search(rf"[(:]\s*({_NUMBER})\s*(?:-|–|to)\s*({_NUMBER})\s*\)?", text)
    limits = limits or re.search(rf"({_NUMBER}) to ({_NUMBER})\.", text)
    if limits and float(limits[1]) < float(limits[2]):
        facts["range"] = [float(limits[1]), float(limits[2])]
    elif re.search(r"0 ?[-=] ?disabled?,? 1 ?[-=] ?enabled?", text, re.IGNORECASE) and element == "u8":
        facts["range"] = [0.0, 1.0]
    elif re.search(r"\+ ?/? ?- ?pi\b|\[-pi, pi\]", text, re.IGNORECASE):
        facts["range"] = [-pi, pi]
    elif re.search(r"\bLimit(ed to)? \d+\.", text):
        facts["range"] = [None, float(re.findall(r"\bLimit(?:ed to)? (\d+)\.", text)[0])]
    elif re.search(r"count(ed|ing) from 1|start(ing|s) (with|at|from) 1|\(1, ?2,|must be > 0", text, re.IGNORECASE):
        facts["range"] = [1.0, None]
    floats = element not in ("bool", "u8", "u16")
    if "annot be 0 unless" in text or (floats and re.search(r"oise.{0,40} must be greater than 0", about)):
        facts["above"] = 0
    return facts


def _units(text: str) -> Iterator[str]:
    """Yields possible units: text in brackets, also up to its comma, the whole text, and words as in "in Hz"."""
    for inside in re.findall(r"(?:\[|(?<!\w)\()([^\[\]()]+)[\])]", text):
        yield inside
        yield inside.partition(",")[0]
    yield text
    yield from re.findall(r"\bin ((?:scaled )?\w+)\b", text)
    yield from re.findall(r"^(\w+?)(?: since\b| ?\()", text)


def _unit(text: str) -> str | None:
    """Returns a unit as it is printed; None if the text is not a unit."""
    text = re.sub(r"\b1-sigma\b,?", "", text, flags=re.IGNORECASE).strip().rstrip(".")
    symbol = _SYMBOLS.get(text if len(text) == 1 else text.casefold())
    return next((t for t in UNITS[symbol] if t.casefold() == text.casefold()), None) if symbol else None
