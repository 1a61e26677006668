"""Converts words of a command line to values of parameters."""

from __future__ import annotations

import inspect
import json
import re
from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from enum import IntEnum, IntFlag
from typing import Any

from ..binding import (
    SCALARS,
    SETS,
    Command,
    EncodeError,
    FunctionSelector,
    Parameter,
    Structure,
    info,
    lookup,
    registry,
)
from ..errors import Failure, Misuse
from .selection import matching_fields, near, resolve_keys


def command(kind: type[Command], words: Sequence[str]) -> Command:
    """Makes a command of this type from the words for its function and values. Raises Failure."""
    build, words = _constructor(kind, words)
    accepted = inspect.signature(build).parameters
    wanted = [p for p in info(kind).parameters if p.attribute in accepted]
    values: dict[str, Any] = {}
    for p, word in _assigned(kind, wanted, words):
        values[p.attribute] = parse_value(p, word, values)
    missing = [
        p.name for p in wanted if p.attribute not in values and accepted[p.attribute].default is inspect.Parameter.empty
    ]
    if missing:
        raise Misuse(f"{kind.NAME} needs {', '.join(missing)}; {usage(kind)}")
    try:
        built = build(**values)
        built.encode()
    except EncodeError as error:
        raise Misuse(f"{kind.NAME} cannot be sent: {error.detail}; {usage(kind)}") from None
    except (TypeError, ValueError) as error:
        raise Misuse(f"{kind.NAME} cannot be sent: {error}; {usage(kind)}") from None
    assert isinstance(built, Command)
    return built


def usage(kind: type[Command]) -> str:
    """Names the command that lists the parameters."""
    return f"`mip fields {kind.NAME}` lists its parameters"


def constructor_functions(kind: type[Command]) -> list[str]:
    """Returns the functions for which a command has constructors."""
    return [f.name.lower() for f in FunctionSelector if f.value in kind.REQUIRED and hasattr(kind, f.name.lower())]


def value_names(kind: type[Command], function: str) -> list[str]:
    """Returns the names of a function's values; optional ones are in brackets."""
    build = getattr(kind, function) if function else kind
    accepted = inspect.signature(build).parameters
    return [
        p.name if accepted[p.attribute].default is inspect.Parameter.empty else f"[{p.name}]"
        for p in info(kind).parameters
        if p.attribute in accepted
    ]


def _constructor(kind: type[Command], words: Sequence[str]) -> tuple[Callable[..., Any], list[str]]:
    names = constructor_functions(kind)
    if not names:
        return kind, list(words)
    if not words or words[0].lower() not in names:
        got = f", not '{words[0]}'" if words else ""
        raise Misuse(f"{kind.NAME} needs a function{got}: {', '.join(names)}")
    return getattr(kind, words[0].lower()), list(words[1:])


def _assigned(kind: type[Command], wanted: list[Parameter], words: list[str]) -> list[tuple[Parameter, str]]:
    """Assigns words to parameters, by name or in order. Returns them in the order of the parameters."""
    by_name = {p.name: p for p in wanted} | {p.attribute: p for p in wanted}
    assigned: dict[str, tuple[Parameter, str]] = {}
    free = list(wanted)
    for word in words:
        name, equal, rest = word.partition("=")
        if equal and name in by_name:
            p, text = by_name[name], rest
            if p.attribute in assigned:
                raise Misuse(f"{name} is given twice")
        elif equal and name.isidentifier():
            names = ", ".join(p.name for p in wanted) or "none"
            raise Misuse(f"{kind.NAME} has no parameter '{name}' here; it has {names}")
        else:
            while free and free[0].attribute in assigned:
                free.pop(0)
            if not free:
                names = ", ".join(p.name for p in wanted) or "no values"
                raise Misuse(f"'{word}' is one value too many; {kind.NAME} has {names}")
            p, text = free.pop(0), word
        assigned[p.attribute] = (p, text)
    return [assigned[p.attribute] for p in wanted if p.attribute in assigned]


# --------------------------------------------------------------------------- values


def parse_value(p: Parameter, text: str, before: Mapping[str, Any], set_number: int | None = None) -> Any:
    """Converts a text to a parameter's value.

    `before` has the values of the parameters before it; `set_number` is the set of the fields that it names.
    """
    set_number = _set_of(p, before, set_number)
    if p.kind == "switch":
        tag = before.get(p.tag)
        case = p.cases.get(int(tag)) if tag is not None else None
        if case is None:
            raise Misuse(f"{p.name} has no value for {p.tag}={tag}; leave it out")
        return parse_value(case, text, before, set_number)
    if text[:1] in "[{" and text:
        try:
            return _from_json(p, json.loads(text), set_number)
        except json.JSONDecodeError as error:
            raise Misuse(f"{p.name}: '{text}' is not JSON: {error.msg}") from None
    if p.kind == "struct":
        return _structure(p, text, set_number)
    if p.kind == "array":
        parts = [part for part in text.split(",") if part]
        return tuple(
            _structure(p, t, set_number) if _is_structure(p) else parse_scalar(p, t, set_number) for t in parts
        )
    return parse_scalar(p, text, set_number)


def _set_of(p: Parameter, before: Mapping[str, Any], inside: int | None) -> int | None:
    """Returns the set of the fields that a parameter names: a fixed one, or the value of a parameter before it."""
    if not p.fields_of:
        return inside
    beside = before.get(p.fields_of)
    return lookup.set_number(p.fields_of) if beside is None else int(beside)


def _is_structure(p: Parameter) -> bool:
    return isinstance(p.type, type) and issubclass(p.type, Structure)


def _structure(p: Parameter, text: str, set_number: int | None) -> Any:
    """Parses a structure: `1:2` has two members."""
    members = [m for m in info(p.type).parameters if m.attribute and m.kind != "constant"]
    parts = text.split(":")
    if len(parts) > len(members):
        names = ":".join(m.name for m in members)
        raise Misuse(f"{p.name}: '{text}' has too many parts; write {names}")
    values: dict[str, Any] = {}
    for m, part in zip(members, parts):
        values[m.attribute] = parse_value(m, part, values, set_number)
    return _made(p, values)


def _made(p: Parameter, members: dict[str, Any]) -> Any:
    try:
        return p.type(**members)
    except TypeError:
        names = ":".join(m.name for m in info(p.type).parameters if m.attribute)
        raise Misuse(f"{p.name} has parts that are missing; write {names}") from None
    except EncodeError as error:
        raise Misuse(f"{p.name} cannot be sent: {error.detail}") from None


def _from_json(p: Parameter, content: Any, set_number: int | None) -> Any:
    if isinstance(content, list):
        return tuple(_from_json(p, v, set_number) for v in content)
    if isinstance(content, dict) and _is_structure(p):
        members = {m.name: m for m in info(p.type).parameters}
        unknown = [name for name in content if name not in members]
        if unknown:
            raise Misuse(f"{p.name} has no '{unknown[0]}'; it has {', '.join(members)}")
        values: dict[str, Any] = {}
        for name, v in content.items():
            m = members[name]
            m = p if m is None else m
            case = m.cases.get(int(values.get(m.tag, -1))) if m.kind == "switch" else m
            values[m.attribute] = _from_json(case or m, v, _set_of(m, values, set_number))
        return _made(p, values)
    if isinstance(content, (dict, type(None))):
        raise Misuse(f"{p.name} cannot have the value {json.dumps(content)}")
    return parse_scalar(p, str(content).lower() if isinstance(content, bool) else str(content), set_number)


def parse_scalar(p: Parameter, text: str, set_number: int | None = None) -> Any:
    """Parses one value; `set_number` is the set of a field that it may name. Raises Misuse."""
    kind = p.type if isinstance(p.type, type) else None
    if p.kind == "text" or p.scalar == "char":
        return text
    if kind is not None and issubclass(kind, IntFlag):
        return _flags(p, kind, text)
    if kind is not None and issubclass(kind, IntEnum):
        return _named_value(p, kind, text)
    if p.scalar == "bool":
        return _truth(p, text)
    if p.kind == "bits" or (p.scalar in SCALARS and SCALARS[p.scalar].kind != "float"):
        return _whole(p, text, set_number)
    try:
        return float(text)
    except ValueError:
        raise Misuse(f"{p.name}: '{text}' is not a number") from None


def _named_value(p: Parameter, kind: type[IntEnum], text: str) -> IntEnum:
    names = {name.lower(): member for name, member in kind.__members__.items()}
    if text.lower() in names:
        return names[text.lower()]
    if (number := _integer(text)) is not None:
        return kind(number)
    raise Misuse(f"{p.name}: '{text}' is not one of {', '.join(names)}")


def _truth(p: Parameter, text: str) -> bool | int:
    words = {"true": True, "false": False, "on": True, "off": False, "yes": True, "no": False}
    if text.lower() in words:
        return words[text.lower()]
    if (number := _integer(text)) is not None:
        return number if number not in (0, 1) else bool(number)
    raise Misuse(f"{p.name}: '{text}' is neither true nor false")


def _whole(p: Parameter, text: str, set_number: int | None) -> int:
    """Parses an integer, or, for a byte, the name of a set or a field."""
    number = _integer(text)
    if number is None and p.refers == "field" and set_number is not None:
        return _descriptor(p, text, set_number)
    if number is None and p.scalar == "u8":
        number = _named_number(text)
        if number is None and (close := near(text)):
            raise Misuse(f"{p.name}: '{text}' is neither a number nor a field; did you mean {close}?")
    if number is None:
        raise Misuse(f"{p.name}: '{text}' is not a whole number")
    return number


def _descriptor(p: Parameter, text: str, set_number: int) -> int:
    """Returns the descriptor of a field in this set, or of a shared field."""
    own = SETS.get(set_number, ())
    for name in (*(f"{word}.{text}" for word in own), text):
        try:
            candidates = matching_fields(name)
        except Failure:
            continue
        for number, kind in candidates:
            if number in (set_number, registry.SHARED_SET):
                return int(kind.DESCRIPTOR)
    where = own[0] if own else f"0x{set_number:02X}"
    names = [kind.NAME.partition(".")[2] for number, kind in registry.all_types() if number == set_number]
    close = get_close_matches(text, names, n=3)
    hint = f"did you mean {' or '.join(close)}?" if close else f"`mip fields {where}` lists them"
    raise Misuse(f"{p.name}: '{text}' is not a field of {where}; {hint}")


def _integer(text: str) -> int | None:
    if not re.fullmatch(r"[+-]?(?:0[xX][0-9A-Fa-f]+|0[bB][01]+|[0-9]+)", text):
        return None
    digits = text.lstrip("+-")
    if len(digits) > 100:  # no parameter is so large
        return None
    number = int(digits, 0) if digits[:2].lower() in ("0x", "0b") else int(digits)
    return -number if text.startswith("-") else number


def _named_number(text: str) -> int | None:
    """Returns the number of a set or the descriptor of a field with this name; None if there is none."""
    try:
        number, descriptor = resolve_keys(text)[0]
    except Failure:
        return None
    return number if descriptor is None else descriptor


def _flags(p: Parameter, kind: type[IntFlag], text: str) -> Any:
    names = {name.lower(): member for name, member in kind.__members__.items()}
    bits = 0
    for part in filter(None, text.split("|")):
        name, equal, number = part.strip().lower().partition("=")
        bit = names.get(name)
        if equal and bit is not None:
            inner: Any = getattr(kind(bit), name, None)
            members = {n.lower(): int(v) for n, v in getattr(type(inner), "__members__", {}).items()}
            many = members.get(number, _integer(number))
            mask = int(bit)
            lowest = mask & -mask
            if many is None or not 0 <= many * lowest <= mask:
                raise Misuse(f"{p.name}: '{part}' does not fit; {name} has {bin(mask).count('1')} bits")
            bits |= many * lowest
        elif bit is not None:
            bits |= int(bit)
        elif (whole := _integer(name)) is not None:
            bits |= whole
        else:
            raise Misuse(f"{p.name}: '{part}' is not one of {', '.join(names)}")
    return kind(bits)
