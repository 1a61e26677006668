"""The meaning of values: unit, frame, range, default, valid flag."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import cache
from typing import Any

from mipgen import model as m
from mipgen.read.nodes import Node, parse_number
from mipgen.read.problems import Problems, close, nearest

Problem = Callable[[m.Position, str], None]
Number = int | float


def unknown_word(what: str, word: str, choices: Iterable[str], home: str, guess: bool = True) -> str:
    """Words the message for a word that is not in a vocabulary; `home` is the vocabulary's file.

    >>> unknown_word("unit", "sec", ["m", "s"], "spec.yaml"), unknown_word("unit", "km/h", ["m", "s"], "spec.yaml")
    ("unknown unit 'sec', did you mean 's'?", "unknown unit 'km/h'; known: m, s; add a new one to spec.yaml")
    """
    choices = list(choices)
    remedy = close(word, choices, guess) or f"{nearest(word, choices, guess)}; add a new one to {home}"
    return f"unknown {what} '{word}'{remedy}"


def unknown_unit(word: str, choices: Iterable[str]) -> str:
    return unknown_word("unit", word, choices, "protocol.yaml", guess=False)  # units may differ by one letter


def unit(node: Node, units: Iterable[m.Word], problems: Problems) -> m.Unit | None:
    """Returns the unit that a node states, if it states one."""
    entry, symbols = node.get("unit"), {word.key: word.symbol for word in units}
    if entry is None:
        return None
    if entry.value not in symbols:
        problems.add(entry.position, unknown_unit(entry.value, symbols))
    return m.Unit(entry.value, symbols.get(entry.value, ""))


def unknown_manual(word: str, choices: Iterable[str]) -> str:
    return unknown_word("manual", word, choices, "manuals/")


def resolve_citation(
    node: Node, manuals: Mapping[str, m.Manual], problem: Problem, heading: str | None = None
) -> tuple[str, str]:
    """Resolves the manual and the section that a source, an example or an erratum names. A source of a field may omit
    the section, which is then the `heading`, the title with set and descriptor, as the manual spells it."""
    manual, section = node["manual"].value, node.scalar("section", heading)
    cited = manuals.get(manual)
    if cited is None:
        problem(node["manual"].position, unknown_manual(manual, manuals))
    elif section is None:
        problem(node.position, "'section' is missing; only a source of a field may omit it")
    elif "section" not in node:
        section = _headings(cited.sections).get(_plain(section), section)
    if cited and section and cited.sections and section not in cited.sections:
        near = close(section, cited.sections) or "; add it to the sections of the manual if the manual has it"
        problem((node.get("section") or node).position, f"'{manual}' lists no section '{section}'{near}")
    return manual, section or ""


@cache
def _headings(sections: tuple[str, ...]) -> dict[str, str]:
    """Returns the first heading with each plain form."""
    return {_plain(s): s for s in reversed(sections)}


def _plain(heading: str) -> str:
    """Reduces a heading to what manuals spell consistently: "Ping (0x01, 0x01)"."""
    return heading.casefold().replace(" ", "")


#: Scalars that are not numbers.
_WITHOUT_UNIT = {"bool": "true or false", "char": "a text"}


def resolve_units(node: Node, p: m.Parameter, symbols: Mapping[str, m.Unit], problem: Problem) -> tuple[m.Unit, ...]:
    """Resolves `unit`: one unit for all elements, or one for each."""
    stated = node.get("unit")
    if stated is None or stated.value is None:
        return ()
    kinds = {m.Enum: "an enumeration", m.Bitfield: "a bitfield"}
    what = kinds.get(type(p.element)) or _WITHOUT_UNIT.get(getattr(p.element, "kind", ""))
    if what is not None:
        problem(node.keys["unit"], f"'{p.name}' is {what}, which has no unit; remove it")
        return ()
    entries = list(stated) if isinstance(stated.value, list) else [stated]
    for entry in entries:
        if entry.value not in symbols:
            problem(entry.position, unknown_unit(entry.value, symbols))
    width = len(p.element.elements) if isinstance(p.element, m.Vector) else p.length
    if isinstance(stated.value, list) and len(entries) != width:
        problem(stated.position, f"'{p.name}' has {len(entries)} units; write one, or one for each element")
    return tuple(symbols.get(entry.value, m.Unit(entry.value)) for entry in entries)


def resolve_frame(node: Node, names: Collection[str], problem: Problem) -> str | None:
    frame: str | None = node.scalar("frame")
    if frame is not None and frame not in names:
        problem(node["frame"].position, unknown_word("frame", frame, names, "protocol.yaml"))
    return frame


def frame_elements(p: m.Parameter, frame: str | None, frames: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    """Returns the elements of a vector in a frame with its own names; those of matrices and quaternions are always the
    same."""
    own = p.element.elements if isinstance(p.element, m.Vector) else ()
    wanted = frames.get(frame or "", ())
    return wanted if len(wanted) == len(own) and wanted != own else ()


#: What limits a value: [0, 10], or "> 0, <= 10", or of the length of a vector "magnitude <= 10".
_LIMIT = re.compile(r"([<>]=?) ([^ ,]+)")
_BOUNDS = {">=": "minimum", "<=": "maximum", ">": "above", "<": "below"}


def resolve_range(node: Node, p: m.Parameter, problem: Problem) -> dict[str, Any]:
    """Resolves `range`, if there is one, to the attributes of a parameter."""
    entry = node.get("range")
    if entry is None:
        return {}
    of_length = isinstance(entry.value, str) and entry.value.startswith("magnitude")
    scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
    if not isinstance(scalar, m.Scalar) or scalar.kind in ("bool", "char"):
        problem(entry.position, f"'{p.name}' is not a number, so it has no range; remove it")
        return {}
    if of_length and (scalar is p.element or p.length is not None or isinstance(node.scalar("unit"), list)):
        problem(entry.position, f"'{p.name}' is not a vector of one unit, so it has no magnitude; write a range")
        return {}
    if isinstance(entry.value, str):
        listed = [
            (_BOUNDS[sign], Node(parse_number(text), entry.position)) for sign, text in _LIMIT.findall(entry.value)
        ]
    else:
        listed = [x for x in zip(("minimum", "maximum"), entry, strict=True) if x[1].value is not None]
    what = f"a bound of the {'magnitude' if of_length else 'range'} of '{p.name}'"
    bounds = {key: bound.value for key, bound in listed if _fits(bound, scalar, what, problem)}
    low, high = bounds.get("minimum", bounds.get("above")), bounds.get("maximum", bounds.get("below"))
    if low is not None and high is not None and (low > high or (low == high and {"above", "below"} & bounds.keys())):
        problem(entry.position, f"the range of '{p.name}' is empty; write the smaller number first")
    if of_length and min(low or 0, high or 0) < 0:
        problem(entry.position, f"no vector has a negative magnitude; correct that of '{p.name}'")
    return {"magnitude": (low, high)} if of_length else bounds


#: The largest number that becomes a finite float, which is 3.4028235e38, when it is rounded.
_LARGEST_FLOAT = math.nextafter(2.0**128 - 2.0**103, 0)


def bounds(scalar: m.Scalar) -> tuple[Number, Number]:
    """Returns the smallest and the largest number that a scalar can represent.

    >>> bounds(m.SCALARS["s8"]), bounds(m.SCALARS["u16"]), bounds(m.SCALARS["bool"])
    ((-128, 127), (0, 65535), (0, 1))
    """
    bits = scalar.width
    match scalar.kind:
        case "signed":
            return -(1 << (bits - 1)), (1 << (bits - 1)) - 1
        case "float":
            largest = _LARGEST_FLOAT if scalar.size == 4 else math.inf
            return -largest, largest
        case "bool":
            return 0, 1
        case _:
            return 0, (1 << bits) - 1


def resolve_reserved(node: Node, p: m.Parameter, problem: Problem) -> Number | None:
    """Resolves `reserved`, the value to send for a reserved parameter."""
    value: int | None = node.scalar("reserved")
    if value is None:
        return None
    if not (isinstance(p.element, m.Scalar) and p.element.kind in ("unsigned", "signed", "float")):
        problem(node.keys["reserved"], f"the reserved parameter '{p.name}' must be a number, or an array of them")
        return None
    _fits(node["reserved"], p.element, f"the reserved value of '{p.name}'", problem)
    return float(value) if p.element.kind == "float" else value


def resolve_default(node: Node, p: m.Parameter, problem: Problem) -> object:
    """Resolves the factory default, in the form of the parameter: a number, a value's name, a list."""
    stated = node.get("default")
    if stated is None:
        return None
    check_default(stated, p, problem)
    value: object = stated.plain()
    return value


def at_rest(node: Node, p: m.Parameter, problem: Problem) -> tuple[Number | None, ...]:
    """Resolves `at_rest`, the value of a level device at rest: one number, or one for each element of a vector."""
    stated = node.get("at_rest")
    if stated is None:
        return ()
    scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
    if not isinstance(scalar, m.Scalar) or scalar.kind in ("bool", "char") or p.length is not None:
        problem(node.keys["at_rest"], f"'{p.name}' is neither a number nor a vector, so it has no 'at_rest'; remove it")
        return ()
    entries = list(stated) if isinstance(stated.value, list) else [stated]
    width = len(p.element.elements) if isinstance(p.element, m.Vector) else 1
    if len(entries) != width or isinstance(stated.value, list) != isinstance(p.element, m.Vector):
        wanted = f"a list of {width} numbers" if isinstance(p.element, m.Vector) else "a number"
        problem(stated.position, f"the value of '{p.name}' at rest must be {wanted}")
        return ()
    check = _Default(p, problem, "value at rest")
    for entry in entries:
        if entry.value is not None:
            check.number(entry, scalar)
    return tuple(entry.value for entry in entries)


def check_default(stated: Node, p: m.Parameter, problem: Problem) -> None:
    """Reports a value that the parameter cannot have."""
    _Default(p, problem).check(stated)


def check_typical(node: Node, p: m.Parameter, problem: Problem) -> None:
    """Reports a `typical` value that the parameter cannot have, or that follows from others."""
    if p.derived or p.reserved is not None or p.element is None:
        why = "it has one value" if p.counts is None else f"it counts '{p.counts}'"
        why = "only its cases can have one" if p.element is None else why
        problem(node.keys["typical"], f"'{p.name}' has no typical value: {why}; remove it")
    else:
        _Default(p, problem, "typical value").check(node["typical"])


def check_shown(node: Node, p: m.Parameter, problem: Problem) -> None:
    """Reports a wrong use of `shown` and `fields_of`."""
    what, whole = p.shown, isinstance(p.element, m.Scalar) and p.element.kind == "unsigned"
    if what is not None and not whole:
        problem(node.keys["shown"], f"'{p.name}' is not an unsigned number; remove 'shown'")
    elif what in ("set", "field") and isinstance(p.element, m.Scalar) and p.element.size != 1:
        problem(node.keys["shown"], f"'{p.name}' is {p.element.name}, but the number of a {what} is u8; write hex")
    members = p.element.parameters if isinstance(p.element, m.Struct) else (p,)
    if p.fields_of and not any(q.shown == "field" for q in members):
        problem(node.keys["fields_of"], f"'{p.name}' is not a field descriptor; mark it by shown: field")


class _Default:
    """Checks a default, or another value that an author states; `what` names it in messages."""

    def __init__(self, p: m.Parameter, problem: Problem, what: str = "default") -> None:
        self.p = p
        self.problem = problem
        self.what = what

    def wrong(self, node: Node, wanted: str) -> None:
        self.problem(node.position, f"the {self.what} of '{self.p.name}' must be {wanted}")

    def check(self, node: Node) -> None:
        p = self.p
        if p.length is None:
            self.single(node)
        elif isinstance(p.element, m.Scalar) and p.element.kind == "char":
            most = p.length if isinstance(p.length, int) else m.MAX_FIELD_DATA
            if not isinstance(node.value, str) or len(node.value) > most:
                self.wrong(node, f"text of at most {most} characters, in quotes")
        else:
            self.items(node, p.length)

    def items(self, node: Node, length: int | str) -> None:
        if not isinstance(node.value, list) or (isinstance(length, int) and len(node.value) != length):
            self.wrong(node, f"a list of {length} items" if isinstance(length, int) else "a list")
            return
        for item in node:
            self.single(item)

    def single(self, node: Node) -> None:
        value, element = node.value, self.p.element
        match element:
            case m.Vector():
                self.vector(node, element)
            case m.Enum() if isinstance(value, str):
                self.named(node, value, element.name, "value", [v.name for v in element.values])
            case m.Bitfield() if isinstance(value, list):
                for item in node:
                    self.named(item, item.value, element.name, "bit", [b.name for b in element.bits])
            case m.Enum() if type(value) is int and value not in [v.value for v in element.values]:
                known = ", ".join(f"{v.name} ({v.value})" for v in element.values)
                self.problem(node.position, f"'{element.name}' has no value {value}; known: {known}")
            case m.Enum(scalar=scalar) | m.Bitfield(scalar=m.Scalar() as scalar):
                if isinstance(value, int) and not isinstance(value, bool):
                    self.number(node, scalar)
                else:
                    wanted = "the name of a value" if isinstance(element, m.Enum) else "a list of names of bits"
                    self.wrong(node, f"{wanted} of '{element.name}', or a number")
            case m.Scalar():
                self.number(node, element)
            case m.Struct() if self.what != "default":
                self.members(node, element)
            case m.Bitfield() if self.what != "default":
                if not isinstance(value, str) or not re.fullmatch(f"[0-9A-Fa-f]{{{2 * element.size}}}", value):
                    self.wrong(node, f"{2 * element.size} hexadecimal digits in quotes")
            case _:
                self.wrong(node, "omitted: a structure, a union or a wide bitfield has none")

    def vector(self, node: Node, vector: m.Vector) -> None:
        if isinstance(node.value, list) and len(node.value) == len(vector.elements):
            for item in node:
                self.number(item, vector.scalar)
            self.length(node)
        else:
            self.wrong(node, f"a list of {len(vector.elements)} numbers: {', '.join(vector.elements)}")

    def members(self, node: Node, element: m.Struct) -> None:
        if not isinstance(node.value, dict):
            self.wrong(node, f"a mapping of members of '{element.name}' to values")
            return
        by_name = {q.name: q for q in element.parameters if not q.derived and q.element is not None}
        for name, item in node.items():
            if name in by_name:
                _Default(by_name[name], self.problem, self.what).check(item)
            else:
                self.problem(node.keys[name], f"'{element.name}' has no member '{name}'{nearest(name, by_name)}")

    def length(self, node: Node) -> None:
        low, high = self.p.magnitude
        numbers = [x for x in node.plain() if isinstance(x, (int, float))]
        if not (low or 0) <= math.hypot(*numbers) <= (math.inf if high is None else high):
            wrong = f"the magnitude {math.hypot(*numbers):g}, outside of [{_end(low)}, {_end(high)}]"
            self.problem(node.position, f"the {self.what} of '{self.p.name}' has {wrong}")

    def named(self, node: Node, name: object, owner: str, what: str, names: list[str]) -> None:
        if name not in names:
            self.problem(node.position, f"'{owner}' has no {what} '{name}'{nearest(str(name), names)}")

    def number(self, node: Node, scalar: m.Scalar) -> None:
        value, p = node.value, self.p
        if scalar.kind == "bool":
            if not isinstance(value, bool):
                self.wrong(node, "true or false")
        elif not isinstance(value, (int, float)) or isinstance(value, bool):
            self.wrong(node, "a number")
        elif _fits(node, scalar, f"the {self.what} of '{p.name}'", self.problem):
            low, high = p.minimum, p.maximum
            if (low is not None and value < low) or (high is not None and value > high):
                span = f"[{_end(low)}, {_end(high)}]"
                self.problem(node.position, f"the {self.what} of '{p.name}' is {value}, outside its range {span}")
            if p.above is not None and value <= p.above:
                self.problem(
                    node.position, f"the {self.what} of '{p.name}' is {value}, but must be greater than {p.above}"
                )
            if p.below is not None and value >= p.below:
                self.problem(
                    node.position, f"the {self.what} of '{p.name}' is {value}, but must be less than {p.below}"
                )


def _end(bound: Number | None) -> str:
    """Returns a bound of a range, as an author writes it."""
    return "~" if bound is None else str(bound)


def _fits(node: Node, scalar: m.Scalar, what: str, problem: Problem) -> bool:
    value, (low, high) = node.value, bounds(scalar)
    if scalar.kind != "float" and isinstance(value, float):
        problem(node.position, f"{what} is {value}, but {scalar.name} can only be a whole number")
        return False
    if not low <= value <= high:
        span = "-3.4028235e+38 to 3.4028235e+38" if scalar.kind == "float" else f"{low} to {high}"
        problem(node.position, f"{what} is {value}, but {scalar.name} has the range {span}")
        return False
    return True


def valid_bits(node: Node, p: m.Parameter, beside: Iterable[m.Parameter], problem: Problem) -> None:
    """Checks `valid`: `flags.bit` names a bit of a sibling parameter, `flag` a bool; a list, one for each element."""
    stated = node["valid"]
    entries = list(stated) if isinstance(stated.value, list) else [stated]
    width = len(p.element.elements) if isinstance(p.element, m.Vector) else p.length
    if isinstance(stated.value, list) and len(entries) != width:
        problem(stated.position, f"'{p.name}' has {len(entries)} valid bits; write one, or one for each element")
    names = {q.name: q for q in beside}
    for entry in entries:
        _valid_bit(entry, p, names, problem)


def _valid_bit(node: Node, p: m.Parameter, names: dict[str, m.Parameter], problem: Problem) -> None:
    flags, dot, bit = node.value.partition(".")
    other = names.get(flags)
    if other is None:
        problem(node.position, f"there is no parameter '{flags}' beside '{p.name}'{nearest(flags, names)}")
        return
    if not dot:
        if other.element is not m.SCALARS["bool"] or other.length is not None:
            problem(
                node.position,
                f"'{flags}' is not a bool, so it cannot mark '{p.name}' as valid; use a bool, or a bit: flags.valid",
            )
        return
    defined = bit_names(other)
    if not defined:
        problem(node.position, f"'{flags}' is not a bitfield, so it cannot mark '{p.name}' as valid")
    elif bit not in defined:
        problem(node.position, f"'{flags}' has no bit '{bit}'{nearest(bit, defined)}")


def bit_names(flags: m.Parameter) -> set[str]:
    """Returns the names of the bits of flags, in any reading."""
    return {
        b.name for t in (flags.element, *(v.type for v in flags.readings)) if isinstance(t, m.Bitfield) for b in t.bits
    }


def resolve_valid(node: Node) -> tuple[str, ...]:
    stated = node.get("valid")
    if stated is None or stated.value is None:
        return ()
    return tuple(stated.plain()) if isinstance(stated.value, list) else (stated.value,)
