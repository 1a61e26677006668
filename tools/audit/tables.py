"""Extracts facts from a manual's tables: the parameters of each layout in order, with types and meaning.

Only facts are extracted: names, numbers, units, frames and function letters, in the format of `spec/witness`. A table
that a converter has damaged, so that its rows do not add up to the printed length, is skipped.

Manuals use one of two styles. In the first, each parameter is a row: name, type, description. In the second, a command
is a text in one cell, and the values of a data field are rows with offsets.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from math import pi
from pathlib import Path
from typing import Any

from mipgen import model as m

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

_HEX = "[0-9A-Fa-f]{2}"
_HEADING = re.compile(rf"^(?:#+ |\d+\.\d+\.\d+ )(?:\*\*)?(.*?)\s*\(0x({_HEX}), ?0x({_HEX})\)")
_OTHER_HEADING = re.compile(r"^#+ |^\d+\.\d+(\.\d+)? [A-Z]")
_TYPE = re.compile(
    rf"^({'|'.join(m.SCALARS)}|Vector[34][fd]|Quatf|Matrix3[fd]|[A-Z]\w+)"
    r"(?:\[(\w*)\])?(?: (enum|bitfield))?$"
)
_CELL = re.compile(r"<tr>\s*<td>([^<]*)</td>\s*<td>([^<]*)</td>")
_NUMBER = r"-?\d+(?:\.\d+)?"


def extract_manual(manual: str, path: Path) -> dict[str, Any]:
    """Returns the facts of a manual in the format of a `spec/witness` file."""
    lines = path.read_text("utf-8", errors="replace").splitlines()
    layouts = [layout for section in _sections(lines) for layout in _layouts(*section)]
    return {
        "source": {"manual": manual},
        "partial": True,
        "units": symbols({p.get("unit") for layout in layouts for p in layout["parameters"]}),
        "layouts": list({repr(layout): layout for layout in layouts}.values()),
    }


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


def _sections(lines: list[str]) -> Iterator[tuple[str, int, int, Rows]]:
    """Yields title, set, descriptor and rows of each section whose heading contains a descriptor."""
    current: tuple[str, int, int, Rows] | None = None
    for line in lines:
        heading = _HEADING.match(line)
        if heading:
            key = int(heading[2], 16), int(heading[3], 16)
            if current and current[1:3] == key:
                continue  # the heading is repeated at the top of a page
            if current:
                yield current
            current = (_plain(heading[1]), *key, [])
        elif _OTHER_HEADING.match(line):
            if current:
                yield current
            current = None
        elif current:
            current[3].append([_unmarked(cell) for cell in line.split("\t")])
    if current:
        yield current


def _unmarked(cell: str) -> str:
    """Returns a cell without text markup, but with its nested tables."""
    return re.sub(r"\s+", " ", re.sub(r"</?(b|i|u|a|p|ul|li|em|strong|ol|br|sup)\b[^>]*>", " ", cell)).strip()


def _plain(text: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>|[*_]", " ", text)).strip()


def _layouts(title: str, number: int, descriptor: int, rows: Rows) -> Iterator[Layout]:
    if any(row[0] == "Parameter Name" for row in rows):
        yield from _of_rows(title, number, descriptor, rows)
    else:
        yield from _of_text(title, number, descriptor, rows)


def frames(text: str) -> list[str]:
    return [frame for frame, words in FRAMES.items() if re.search(words, text, re.IGNORECASE)]


def _about(rows: Rows) -> str:
    """Returns the description and the notes of a section."""
    return " ".join(cell for row in rows if row[0] in ("Description", "Notes") for cell in row[1:])


# --------------------------------------------------------------------------- a row for each parameter


def _of_rows(title: str, number: int, descriptor: int, rows: Rows) -> Iterator[Layout]:
    role = "command" if number < 0x80 else "data"
    about = _about(rows)
    layout: Layout | None = None
    whole = True
    for row in rows:
        name, kind, text = (*row, "", "", "")[:3]
        if name in ("Parameter Name", "Response Data"):
            if layout and whole:
                yield _with_defaults(layout, about)
            role = "response" if name == "Response Data" else role
            whole = True
            key = f"0x{number:02X},0x{descriptor:02X}"
            layout = {"key": key, "role": role, "name": title, "parameters": []}
            named = frames(f"{title} {about}")
            if named:
                layout["frames"] = named
        elif layout is None:
            continue
        elif name == "Response Descriptor":
            layout["key"] = f"0x{number:02X},{text.upper().replace('0X', '0x')}"
            whole = whole and re.fullmatch(f"0x{_HEX}", text) is not None
        elif name == "Function Selector":
            letters = re.search(r"\[([WRSLDA]+)\]", text)
            layout["functions"] = letters[1] if letters else ""
        elif name in ("Field Length", "Response Length", "Descriptor"):
            continue
        elif kind.startswith("u8") or _TYPE.match(kind) or kind.lower() == "union":
            p = _parameter(name, kind, " ".join(row[2:]), about)
            whole = whole and p is not None
            if p:
                layout["parameters"].append(p)
    if layout and whole:
        yield _with_defaults(layout, about)


def _with_defaults(layout: Layout, about: str) -> Layout:
    """Adds factory defaults to a command; responses and data have none."""
    if layout["role"] == "command":
        defaults(layout["parameters"], about)
    return layout


#: Default of a switch -> the words that state it.
_SWITCHED = {
    1: r"default for .{0,20} all .{0,20}enabled|(enabled|filtered) by default|by default filtered",
    0: r"disabled by default",
}


def defaults(parameters: list[dict[str, Any]], about: str) -> None:
    """Adds the factory defaults of switches, enumerations and times that a description states."""
    for p in parameters:
        name = p.get("name") or p["label"]
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


def _parameter(name: str, kind: str, text: str, about: str) -> dict[str, Any] | None:
    match = _TYPE.match(kind)
    letters = re.search(r"\[([WRSLDA]+)\]", name)
    label = re.sub(r"\s*\[.*", "", name).strip().replace(" ", "_").lower()
    p: dict[str, Any] = {"name": label}
    if match is None:
        return None
    element, count, meaning = match.groups()
    if element in m.SCALARS or re.match("Vector|Quat|Matrix", element):
        p["type"] = element
        if element not in m.SCALARS:
            size = 9 if element.startswith("Matrix") else int(element[6]) if element.startswith("V") else 4
            p |= {"type": "double" if element.endswith("d") else "float", "count": size, "of": element}
    else:
        p |= {"type": "struct", "struct": element}
    if count is not None:
        if count.isdecimal():
            p["count"] = int(count) * p.get("count", 1)
        elif count:
            p["by"] = count
        else:
            p["count"] = "rest"
    if letters:
        p["for"] = letters[1]
    listed = _CELL.findall(text)
    if meaning == "enum":
        p["values"] = {_label(k): int(v, 0) for k, v in listed if re.fullmatch(r"0x[0-9A-Fa-f]+|\d+", v.strip())}
    elif meaning == "bitfield":
        bits = [(k, re.fullmatch(r"(\d+)(?:\s*[-–]\s*(\d+))?", v.strip())) for k, v in listed]
        p["bits"] = {_label(k): [int(b[1]), int(b[2] or b[1]) - int(b[1]) + 1] for k, b in bits if b}
    words = re.sub(r"<table.*?</table>", " ", text) if "</table>" in text else text.partition("<table")[0]
    words = words.replace("Bit(s)", " ")
    if meaning is None and re.search(r"0 ?- ?invalid,? ?1 ?-? ?valid", words, re.IGNORECASE):
        p["values"] = {"invalid": 0, "valid": 1}
    facts = stated_value(words, element, about if "noise" in label else "")
    return p | {key: fact for key, fact in facts.items() if key != "unit" or meaning is None}


def _label(text: str) -> str:
    return re.sub(r"\W+", "_", text.strip())


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


# --------------------------------------------------------------------------- commands as text, data with offsets

_ITEM = re.compile(r"\b(U8|U16|U32|S8|S16|S32|Float|Double|float|double|u8|u16|u32)\s*[-–]\s*")
_OFFSET = re.compile(r"\d{1,3}")
_SELECTORS = (("W", "1"), ("R", "2"), ("S", "3"), ("L", "4"), ("D", "5"), ("A", "6"))


def _of_text(title: str, number: int, descriptor: int, rows: Rows) -> Iterator[Layout]:
    about = _about(rows)
    if number < 0x80:
        yield from _command(title, number, descriptor, rows, about)
    yield from _offsets(title, number, descriptor, rows, about)


def _command(title: str, number: int, descriptor: int, rows: Rows, about: str) -> Iterator[Layout]:
    label, cells = "", dict[str, list[str]]()
    for row in rows:
        if row[0].startswith("Example"):
            break
        if row[0].startswith(("Command", "Reply Field")):
            label = row[0]
            cells[label] = [c for c in row[1:] if c]
        elif label and not row[0]:
            cells[label] += [c for c in row if c]
    for label, several in cells.items():
        text = " ".join(several)
        answer = label.startswith("Reply")
        codes = [int(c, 16) for c in re.findall(rf"\b0x0?({_HEX})\b", " ".join(several[:2]))]
        if len(codes) < 2 or codes[1] == 0xF1:
            continue
        echo = re.search(r"U8 [-–] echo the command descriptor", text)  # the next row, joined by a converter
        parts = _ITEM.split(text[: echo.start()] if echo else text)
        items = list(zip(parts[1::2], parts[2::2], strict=True))
        selector = bool(items) and "unction selector" in items[0][1].lower().replace("function", "unction")
        parameters = [_item(kind.lower(), words, about) for kind, words in items[selector:]]
        size = 2 + selector + sum(m.SCALARS[p["type"]].size for p in parameters)
        if size != codes[0]:
            continue  # the cell is broken
        layout: Layout = {
            "key": f"0x{number:02X},0x{codes[1] if answer else descriptor:02X}",
            "role": "response" if answer else "command",
            "name": title,
        }
        if selector:
            layout["functions"] = "".join(x for x, n in _SELECTORS if f"0x0{n} -" in about or f"0x0{n} –" in about)
        named = frames(f"{title} {about}")
        if named:
            layout["frames"] = named
        if len(parameters) == 1 and not answer:
            parameters[0] |= {k: v for k, v in stated_value(about, parameters[0]["type"], "").items() if k == "range"}
        modes = [row for row in rows if "default" in " ".join(row[1:]) and re.fullmatch(f"0x{_HEX}", row[0])]
        if len(parameters) == 1 and not answer and len(modes) == 1:
            parameters[0]["default"] = int(modes[0][0], 16)
        yield _with_defaults(layout | {"parameters": parameters}, about)


def _item(kind: str, words: str, about: str) -> dict[str, Any]:
    name = _label(re.sub(r"\(.*|[:,.].*", "", words).strip()).strip("_").lower()
    return {"label": name or "value", "type": kind} | stated_value(words, kind, about)


def _offsets(title: str, number: int, descriptor: int, rows: Rows, about: str) -> Iterator[Layout]:
    """Yields the layouts whose rows contain the offset of each number; a layout begins at offset 0."""
    layout: Layout | None = None
    size, layouts = 0, list[Layout]()
    for row in rows:
        cells = [c for c in row if c]
        codes = [int(c, 16) for c in cells[:4] if re.fullmatch(f"0x{_HEX}", c)]
        if len(codes) == 2:
            descriptor = codes[1] if number < 0x80 else descriptor
        match cells[-4:]:
            case [offset, name, kind, unit] if _OFFSET.fullmatch(offset) and kind.lower() in m.SCALARS:
                if int(offset) == 0:
                    role = "response" if number < 0x80 else "data"
                    layout = {"key": f"0x{number:02X},0x{descriptor:02X}", "role": role, "name": title}
                    named = frames(f"{title} {about}")
                    if named:
                        layout["frames"] = named
                    layout["parameters"] = []
                    layouts.append(layout)
                    size = 0
                if layout is None or int(offset) != size:
                    if layout in layouts:
                        layouts.remove(layout)  # a row is missing
                    layout = None
                    continue
                label = _label(re.sub(r"\(.*", "", name)).strip("_").lower()
                p: dict[str, Any] = {"label": label or "value", "type": kind.lower()}
                printed = _unit(unit)
                if printed:
                    p["unit"] = printed
                layout["parameters"].append(p)
                size += m.SCALARS[kind.lower()].size
    yield from layouts
