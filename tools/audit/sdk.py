"""Extracts facts from a working copy of the vendor's SDK: its layouts, and the comments on each number.

Members and comments are read from `definitions/*.hpp`; their order, counts, conditions and functions from the `extract`
functions in `definitions/*.cpp`. Both are generated and so uniform that they can be read line by line. Only facts are
extracted, in the format of `spec/witness`.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass, field
from math import pi
from pathlib import Path
from typing import Any

from mipgen import model as m
from mipgen.base.errors import Failure

from . import leaves

NAME = "sdk"
DEFINITIONS = Path("src/cpp/mip/definitions")

#: The name of each scalar in C++ -> our own.
_SCALARS = {
    {"unsigned": f"uint{8 * s.size}_t", "signed": f"int{8 * s.size}_t"}.get(s.kind, s.name): s.name
    for s in m.SCALARS.values()
}
_VECTORS = {
    "Vector3f": ["float", "xyz"],
    "Vector4f": ["float", "xyzw"],
    "Quatf": ["float", "wxyz"],
    "Matrix3f": ["float", "abcdefghi"],
    "Vector3d": ["double", "xyz"],
    "Vector4d": ["double", "xyzw"],
    "Matrix3d": ["double", "abcdefghi"],
}
_LETTERS = {"write": "W", "read": "R", "save": "S", "load": "L", "default": "D"}
_ROLES = {"CMD": "command", "REPLY": "response", "DATA": "data"}

_SCOPE = re.compile(r"(namespace|enum class|struct|union) (\w+)(?: : (Bitfield<\w+>|\w+))?(?: \{)?$")
_ALTERNATIVES = re.compile(r"union(?: \{)?$")
_NUMBERS = re.compile(r"enum *(?:_enumType : (\w+))?$")
_NUMBER = re.compile(r"(?:static constexpr const \w+ )?(\w+) *= *(0x[0-9A-Fa-f]+|\d+)[,;]")
_DESCRIPTOR = re.compile(r"FIELD_DESCRIPTOR = ::mip::\w+::(\w+);")
_MEMBER = re.compile(r"([\w:]+) (\w+)(?:\[(\d+)\])?(?: = [^;]*)?;(?: *///< ?(.*))?$")
_CALL = re.compile(r"TypedResult<(\w+)> (write|read|save|load|default)\w+\(")
_EXTRACT = re.compile(r"void ([\w:]+)::extract\(Serializer& serializer\)$")
_CONDITION = re.compile(r"if\( (\w+) == ([\w:]+)")
_LOOP = re.compile(r"for\(unsigned int i=0; i < (\w+);")
_READ = re.compile(r"serializer\.extract(?:_count)?\(([\w.]+)")

#: Values that a comment lists, such as "0 - Disabled, 1 - Enabled (default)", or "GLONASS = 0".
_LISTED = re.compile(r"\b(\d+)\s*[-=:]\s*([A-Za-z][\w-]*(?: [A-Za-z][\w-]*)*)(?: *\((default)\))?")
_NAMED = re.compile(r"([A-Z][\w-]*) = (\d+)()")
_INVALID = re.compile(r"0 ?[-=] ?invalid,? ?1 ?[-=]? ?valid", re.IGNORECASE)


def extract_sdk(folder: Path) -> dict[str, Any]:
    """Returns the facts of a working copy in the format of a `spec/witness` file. Raises Failure."""
    if not (folder / DEFINITIONS).is_dir():
        raise Failure("this is no working copy of the vendor's SDK", str(folder))
    try:
        return _facts(folder)
    except (KeyError, StopIteration, OSError) as error:
        reason = error.strerror if isinstance(error, OSError) else f"nothing defines {error}"
        raise Failure(f"this SDK's definitions have an unknown format: {reason}", str(folder / DEFINITIONS)) from error


def _facts(folder: Path) -> dict[str, Any]:
    parts = [_Definitions(path) for path in sorted((folder / DEFINITIONS).glob("*_*.hpp"))]
    layouts = sorted((x for part in parts for x in part.layouts()), key=lambda x: (x["key"], x["role"]))
    structs = _PUBLIC_STRUCTS | {name: record for part in parts for name, record in part.structs().items()}
    types = _codes(folder) | {name: entry for part in parts for name, entry in part.types().items()}
    records = [*(x["parameters"] for x in layouts), *structs.values()]
    printed = {p.get("unit") for record in records for q in record for p in (q, *q.get("cases", ()))}
    receivers = {f"0x{n:02X}" for part in parts for s in part.scopes.values() for k, n in s.numbers.items() if _GNSS(k)}
    return {
        "source": _SOURCE | revision(folder),
        "same_layouts": {"0x81": sorted(receivers)},
        "vectors": _VECTORS,
        "units": symbols(printed),
        "layouts": [_shortened(x, layouts) for x in layouts],
        "structs": dict(sorted(structs.items())),
        "enums": dict(sorted((k, v) for k, v in types.items() if "values" in v)),
        "bitfields": dict(sorted((k, v) for k, v in types.items() if "bits" in v)),
        "constants": {k: v for part in parts for k, v in part.constants().items()},
        "named": dict(sorted((k, v) for part in parts for k, v in part.named().items())),
    }


def _shortened(layout: dict[str, Any], layouts: list[dict[str, Any]]) -> dict[str, Any]:
    """Returns a layout that refers to the parameters of the command to which it is the response, if they are the same;
    the command states besides which function requires them."""
    commands = leaves.commands_of(layout, layouts)
    same = len(commands) == 1 and layout["parameters"] and leaves.as_command(commands[0]) == layout["parameters"]
    return {**layout, "parameters": leaves.AS_COMMAND} if same else layout


def revision(folder: Path) -> dict[str, str]:
    """Returns commit and date of a working copy; empty if git is missing or has no history of it."""
    command = ["git", "-C", str(folder), "log", "-1", "--format=%H %cs"]
    git = subprocess.run(command, capture_output=True, text=True, check=False) if shutil.which("git") else None
    commit, date = git.stdout.split() if git is not None and git.returncode == 0 else ("", "")
    return {"commit": commit, "date": date} if commit else {}


_SOURCE = {"name": "MicroStrain MIP SDK", "repository": "github.com/HBK-MicroStrain/mip_sdk", "licence": "MIT"}

#: Matches the descriptor set constants of further receivers.
_GNSS = re.compile(r"MIP_GNSS\d_DATA_DESC_SET").match

#: The only structure outside of the definitions.
_PUBLIC_STRUCTS = {"DescriptorRate": [{"name": "descriptor", "type": "u8"}, {"name": "decimation", "type": "u16"}]}


def _codes(folder: Path) -> dict[str, Any]:
    """Returns the function selectors and the acknowledge codes, which C headers define."""
    enums = {}
    for name, file, prefix in (
        ("CmdResult", "mip_result.h", r"MIP_(?=N?ACK)"),
        ("FunctionSelector", "mip_descriptors.h", r"MIP_FUNCTION_"),
    ):
        path = next((folder / "src").rglob(file))
        entries = re.findall(rf"^\s*{prefix}(\w+) *= *(0x\w+|\d+)", path.read_text("utf-8"), re.MULTILINE)
        enums[name] = {"type": "u8", "values": {key: int(number, 0) for key, number in entries}}
    return enums


# --------------------------------------------------------------------------- lines


@dataclass
class _Scope:
    """A namespace, structure, union, enumeration or bitfield of a header."""

    kind: str
    name: str  # with the enclosing types, but without the namespace
    scalar: str = ""
    numbers: dict[str, int] = field(default_factory=dict)  # values, masks, descriptors or constants
    members: dict[str, dict[str, Any]] = field(default_factory=dict)
    descriptor: str = ""  # the name of the constant
    functions: str = ""
    about: str = ""


@dataclass(frozen=True)
class _Step:
    """A number, or an array, that `extract` reads."""

    member: str
    written: bool  # only for function write, in some fields also for read
    letters: str
    repeat: int | str | None  # the number of items, the counter's name, or "rest"
    case: tuple[str, str] | None  # the parameter that selects it, and the value


def _scopes(lines: list[str], space: str) -> Iterator[_Scope]:
    """Yields each scope of a header when it ends. The braces of functions are only counted."""
    stack: list[_Scope | None] = []
    pending: _Scope | None = None
    about: list[str] = []
    for line in map(str.strip, lines):
        inside = next((s for s in reversed(stack) if s), None)
        if line.startswith("///"):
            about = [] if "@defgroup" in line else [*about, line.removeprefix("///").strip()]
            continue
        if begun := _begun(line, inside, space):
            pending = begun
            pending.about = inside.about if inside and inside.about else " ".join(about)
        if line.startswith(("{", "}")) or line.endswith("{"):
            if line.startswith("}"):
                closed = stack.pop() if stack else None
                owner = next((s for s in reversed(stack) if s), None)
                if closed and owner and closed.kind == "alternatives":
                    first = next(iter(closed.members))
                    owner.members |= {name: x | {"first": first} for name, x in closed.members.items()}
                elif closed and owner and closed.kind == "numbers":
                    owner.numbers |= closed.numbers
                    owner.scalar = closed.scalar or owner.scalar
                elif closed and closed.kind != "mip":
                    yield closed
            else:
                stack.append(pending)
                pending = None
        elif inside and stack[-1] is inside:
            _member(inside, line)


def _begun(line: str, inside: _Scope | None, space: str) -> _Scope | None:
    """Returns the scope that begins on a line; None if none does."""
    if match := _SCOPE.match(line):
        kind, name, base = match[1], match[2], match[3] or ""
        if kind == "namespace":
            return _Scope("namespace" if name == space else "mip", "")
        full = f"{inside.name}::{name}".lstrip(":") if inside and inside.kind != "mip" else name
        if base.startswith("Bitfield"):
            return _Scope("bitfield", full)
        return _Scope(kind.removesuffix(" class"), full, _SCALARS.get(base, ""))
    if _ALTERNATIVES.match(line):
        return _Scope("alternatives", "")
    match = _NUMBERS.match(line)
    return _Scope("numbers", "", _SCALARS.get(match[1] or "", "")) if match else None


def _member(scope: _Scope, line: str) -> None:
    """Adds the content of a line that is directly inside a scope."""
    if match := _DESCRIPTOR.search(line):
        scope.descriptor = match[1]
    elif (match := _NUMBER.match(line)) and "NAME" not in line:
        scope.numbers[match[1]] = int(match[2], 0)
    elif scope.kind in ("struct", "union", "alternatives") and (match := _MEMBER.match(line)):
        scope.members[match[2]] = {"type": match[1], "size": match[3], "text": (match[4] or "").strip()}


def _steps(lines: list[str]) -> dict[str, list[_Step]]:
    """Returns the values that `extract` reads for each structure, in order."""
    steps_of: dict[str, list[_Step]] = {}
    steps: list[_Step] | None = None
    conditions: list[str] = []
    repeat: int | str | None = None
    for raw in lines:
        line = raw.strip()
        if match := _EXTRACT.match(raw):
            steps = steps_of[match[1]] = []
        elif raw == "}":
            steps = None
        elif steps is None or line == "{":
            continue
        elif line.startswith("if("):
            conditions.append(line)
        elif line == "}":
            conditions.pop()
        elif line.startswith("for("):
            match = _LOOP.match(line)
            repeat = "rest" if match is None else int(match[1]) if match[1].isdecimal() else match[1]
        elif match := _READ.match(line):
            words = re.findall(r"FunctionSelector::([A-Z]+)", " ".join(conditions))
            letters = "".join(_LETTERS[{"RESET": "default"}.get(w, w.lower())] for w in words)
            chosen = next((x for c in conditions if (x := _CONDITION.match(c)) and x[1] != "function"), None)
            case = (chosen[1], chosen[2]) if chosen else None
            steps.append(_Step(match[1], bool(words), letters, repeat, case))
            repeat = None
    return steps_of


# --------------------------------------------------------------------------- facts


class _Definitions:
    """The facts of one header and its implementation, which define one namespace."""

    def __init__(self, header: Path) -> None:
        self.space = header.stem
        text = header.read_text("utf-8")
        self.scopes = {s.name: s for s in _scopes(text.splitlines(), self.space)}
        self.steps = _steps(header.with_suffix(".cpp").read_text("utf-8").splitlines())
        calls = set(_CALL.findall(text))
        self.functions = {
            name: "".join(letter for word, letter in _LETTERS.items() if (name, word) in calls) for name, _ in calls
        }
        self.descriptors = self.scopes[""].numbers

    def full(self, name: str) -> str:
        return f"{self.space}::{name}"

    def key(self, constant: str) -> str:
        return f"0x{self.descriptors['DESCRIPTOR_SET']:02X},0x{self.descriptors[constant]:02X}"

    def layouts(self) -> Iterator[dict[str, Any]]:
        for scope in self.scopes.values():
            if not scope.descriptor:
                continue
            role = _ROLES[scope.descriptor.partition("_")[0]]
            layout: dict[str, Any] = {"key": self.key(scope.descriptor), "role": role, "name": self.full(scope.name)}
            functions = self.functions.get(scope.name, "") if role == "command" else ""
            if functions:
                layout["functions"] = functions
            response = self.scopes.get(f"{scope.name}::Response")
            if response and response.descriptor:
                layout["response"] = self.key(response.descriptor).rpartition(",")[2]
            if named := frames(scope.about):
                layout["frames"] = named
            layout["parameters"] = self.record(scope, functions)
            if role == "command":
                defaults(layout["parameters"], scope.about)
            yield layout

    def structs(self) -> dict[str, Any]:
        plain = [s for s in self.scopes.values() if s.kind == "struct" and s.members and not s.descriptor]
        return {self.full(s.name): self.record(s, "") for s in plain}

    def types(self) -> dict[str, Any]:
        shown: dict[str, Any] = {}
        for s in self.scopes.values():
            if s.kind == "enum":
                shown[self.full(s.name)] = {"type": s.scalar, "values": s.numbers}
            elif s.kind == "bitfield":
                masks = {name: mask for name, mask in s.numbers.items() if mask and name != "ALL"}
                bits = {name: [(m & -m).bit_length() - 1, m.bit_count()] for name, m in masks.items()}
                shown[self.full(s.name)] = {"type": s.scalar, "bits": bits}
        return shown

    def constants(self) -> dict[str, dict[str, int]]:
        """Returns the constants that are neither enumeration values nor descriptors, by scope."""
        spaces = {}
        for s in self.scopes.values():
            prefixes = ("DESCRIPTOR_SET", *(f"{role}_" for role in _ROLES)) if s.kind == "namespace" else ()
            numbers = {k: n for k, n in s.numbers.items() if not k.startswith(prefixes)} if prefixes else s.numbers
            if s.kind in ("namespace", "struct") and numbers:
                spaces[self.full(s.name) if s.name else self.space] = numbers
        return spaces

    def named(self) -> dict[str, str]:
        """Returns the descriptors without a layout."""
        used = {s.descriptor for s in self.scopes.values()}
        wanted = [k for k in self.descriptors if k.partition("_")[0] in _ROLES and k not in used]
        return {self.key(k): k for k in wanted}

    # ------------------------------------------------------------------ parameters

    def record(self, scope: _Scope, functions: str) -> list[dict[str, Any]]:
        """Returns the parameters in the order in which they are read; the members of a union are its cases."""
        parameters: dict[str, dict[str, Any]] = {}
        for step in self.steps[scope.name]:
            name, _, inner = step.member.partition(".")
            first = name if name == "function" else scope.members[name].get("first", name)
            if name == "function" or (first in parameters and first != name):
                continue  # another name of a number that was read
            p = parameters.get(name) or self.parameter(scope, name, step)
            if functions and name not in parameters:
                p["for"] = "".join(x for x in functions if x in step.letters or not step.written)
            parameters[name] = p
            if inner and step.case:
                by, value = step.case
                enum, _, entry = value.rpartition("::")
                number = self.scopes[self.find(enum, scope)].numbers[entry]
                union = self.scopes[self.find(scope.members[name]["type"], scope)]
                p["by"] = by
                case = self.parameter(union, inner, step) | {"when": [entry, number]}
                p.setdefault("cases", []).append(case)
        return list(parameters.values())

    def find(self, name: str, scope: _Scope) -> str:
        """Finds a type by name, as C++ does: in the scope, then in each enclosing one."""
        around = scope.name.split("::")
        candidates = ["::".join([*around[:i], name]) for i in range(len(around), -1, -1)]
        return next(c for c in candidates if c in self.scopes)

    def parameter(self, scope: _Scope, name: str, step: _Step) -> dict[str, Any]:
        member = scope.members[name]
        kind, size, text = member["type"], int(member["size"] or 0), member["text"]
        p: dict[str, Any] = {"name": name}
        if kind in _SCALARS:
            p["type"] = _SCALARS[kind]
        elif kind in _VECTORS:
            p |= {"type": _VECTORS[kind][0], "count": len(_VECTORS[kind][1]), "of": kind}
        elif kind == "DescriptorRate":
            p |= {"type": "struct", "struct": kind}
        else:
            record = self.scopes[self.find(kind, scope)]
            p["type"] = record.kind if record.kind in ("struct", "union") else record.scalar
            if record.kind != "union":
                p[record.kind] = self.full(record.name)
        if isinstance(step.repeat, int):
            p["count"] = step.repeat * p.get("count", 1)
        elif step.repeat == "rest":
            p |= {"count": "rest", "max": size}
        elif step.repeat:
            p |= {"by": step.repeat, "max": size}
        return p | self.meaning(text, p, scope.about)

    def meaning(self, text: str, p: dict[str, Any], about: str) -> dict[str, Any]:
        """Returns the facts in a member's comment; none for a named type, which has its own definition."""
        if {"enum", "bitfield", "struct"} & {*p} or p["type"] == "union":
            return {}
        plain = re.sub(r"<br */?>|</?[bui]>|//$", " ", text)
        facts = stated_value(plain, p["type"], about if "noise" in p["name"] else "")
        listed = _listed(plain) if p["type"].startswith("u") else []
        numbers = {re.sub(r"\W+", "_", words).upper(): number for words, number, _ in listed}
        if "itfield" in text and numbers:
            return facts | {"bits": {name: [number, 1] for name, number in numbers.items()}}
        if len(numbers) > 1 and len(set(numbers.values())) == len(numbers):
            facts |= {"values": numbers}
            facts.pop("range", None)
        chosen = [number for _, number, default in listed if default]
        return facts | ({"default": chosen[0]} if len(chosen) == 1 else {})


def _listed(text: str) -> list[tuple[str, int, str]]:
    if _INVALID.search(text):
        return [("INVALID", 0, ""), ("VALID", 1, "")]
    named = [(words, int(number), default) for words, number, default in _NAMED.findall(text)]
    return named or [(words, int(number), default) for number, words, default in _LISTED.findall(text)]


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

_DECIMAL = r"-?\d+(?:\.\d+)?"


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


def _record(layout: dict[str, Any]) -> str:
    if layout["parameters"] == leaves.AS_COMMAND:
        return f"- {_flow(layout)}\n"
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
        number = re.search(rf"default ?= ?({_DECIMAL}) (\w+)", about)
        if name in ("enable", "mode") and switch is not None:
            p["default"] = switch
        elif "enable" in name and listed:
            p["default"] = int(listed[1], 16)
        elif number and p.get("unit") and _SYMBOLS.get(p["unit"]) == _SYMBOLS.get(number[2]):
            p["default"] = float(number[1])
        if number and "default" in p and "unit" in p:
            limits = re.search(rf"({_DECIMAL})-({_DECIMAL}) {number[2]}", about)
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
    limits = re.search(rf"[(:]\s*({_DECIMAL})\s*(?:-|–|to)\s*({_DECIMAL})\s*\)?", text)
    limits = limits or re.search(rf"({_DECIMAL}) to ({_DECIMAL})\.", text)
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
