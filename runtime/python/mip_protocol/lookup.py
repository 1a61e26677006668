"""Finds fields, sets and devices by name, and suggests the nearest names for unknown ones."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

from ._index import DEVICES, FAMILIES, FIELDS, MODELS, NAMED
from ._sets import SETS
from .exceptions import UnknownName

#: Words in other bindings' names that do not describe the field itself.
NOISE = frozenset(("mip", "data", "command", "commands"))
#: The prefix of names in C, and of modules that would begin with a digit: `mip` in `mip_3dm`.
PREFIX = __name__.split(".")[-2].removesuffix("_protocol")


def descriptors(name: Any) -> tuple[int, int] | None:
    """Returns set and descriptor of a field that is named by them: "0x80,0x04"."""
    numbers = re.fullmatch(
        r"\(?0x([0-9a-f]{1,2}) *, *0x([0-9a-f]{1,2})\)?", _checked(name, "a field").strip(), re.I
    )
    return (int(numbers[1], 16), int(numbers[2], 16)) if numbers else None


def field_home(name: str, names: Sequence[str] | None = None) -> tuple[str, str]:
    """Finds module and class of a field; see `registry.by_name`. `names`: those that it may be."""
    names = _fields(name) if names is None else names
    if len(names) == 1:
        return FIELDS[names[0]][:2]
    if names:
        raise ambiguous(name, tuple(names))
    raise unknown(name, "a field", FIELDS, _near(name))


def _checked(name: Any, what: str) -> str:
    if isinstance(name, str):
        return name
    raise UnknownName("unknown_name", f"{name!r} is not the name of {what}")


def _fields(name: str) -> tuple[str, ...]:
    """Finds the full names of the fields with this name."""
    first, _, own = name.partition(".")
    full = f"{FAMILIES.get(first, first)}.{own}"
    if full in FIELDS:
        return (full,)
    words, prefix = _words(name), _words(PREFIX)
    words = words[len(prefix) :] if words[: len(prefix)] == prefix else words
    names = _keys().get("".join(words)) or _keys().get(_key(words), ())
    for role in ("command", "data"):
        hinted = tuple(x for x in names if FIELDS[x][2] == role)
        if len(names) > 1 and hinted and {role, f"{role}s"} & {*words}:
            names = hinted
    return names


def _words(name: str) -> list[str]:
    """
    >>> _words("sensor.ScaledAccel"), _words("sensor_scaled_accel_data")
    (['sensor', 'scaled', 'accel'], ['sensor', 'scaled', 'accel', 'data'])
    """
    apart = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name)
    return re.findall(r"[a-z0-9]+", apart.lower())


def _joined(name: str) -> str:
    return "".join(_words(name))


def _key(words: list[str]) -> str:
    return "".join(w for w in words if w not in NOISE) or "".join(words)


@cache
def _keys() -> dict[str, tuple[str, ...]]:
    """Returns a table: field names without their insignificant parts -> full names."""
    keys: dict[str, dict[str, None]] = {}
    for full, (_, _, _, title, also) in FIELDS.items():
        family, _, own = full.partition(".")
        sets = ("", family, *(name for name, of in FAMILIES.items() if of == family))
        for words in (_words(f"{a} {b}") for b in (own, title, *also) for a in sets):
            for key in ("".join(words), _key(words)):
                keys.setdefault(key, {})[full] = None
    return {key: tuple(names) for key, names in keys.items()}


def _near(name: str) -> list[str]:
    keys = _keys()
    close = _close(_key(_words(name)), keys, cutoff=0.7)
    return list(dict.fromkeys(full for key in close for full in keys[key]))[:4]


def set_number(name: str) -> int:
    """Finds the number of a descriptor set; see `registry.set_by_name`."""
    _checked(name, "a descriptor set")
    try:
        number = int(name, 16) if name.lower().startswith("0x") else None
    except ValueError:
        number = None
    numbers = [n for n, names in SETS.items() if n == number or name in names]
    if not numbers:
        wanted = _joined(name).removeprefix(_joined(PREFIX))
        numbers = [n for n, names in SETS.items() if wanted in map(_joined, names)]
    if len(numbers) == 1:
        return numbers[0]
    raise unknown(name, "a descriptor set", [names[0] for names in SETS.values()])


@cache
def device_id(name: str) -> str:
    """Finds the id of a device by its id, title or another name, or by the last words of one."""
    wanted = _joined(_checked(name, "a device"))
    for id, names in DEVICES.items():
        if wanted in map(_joined, (id, *names)):
            return id
    named = only_named(name)
    if named:
        raise named
    keys = _ends()
    ids = keys.get(wanted, ())
    if len(ids) == 1:
        return ids[0]
    if ids:
        raise ambiguous(name, ids)
    close = _close(wanted, keys)
    raise unknown(name, "a device", DEVICES, dict.fromkeys(id for k in close for id in keys[k]))


def only_named(name: str) -> UnknownName | None:
    """Returns the error for a device of which only the names are known; None for any other."""
    for id, (like, *names) in NAMED.items():
        if _joined(name) in map(_joined, (id, *names)):
            text = (
                f"only the name of the {names[0]} is known; choose {like}, the device most like it"
            )
            return UnknownName("unknown_name", text, (like,))
    return None


def model_id(info: Any) -> str | None:
    """Returns the id of the device as which the sender of this information is read; None if unknown."""
    from .profile import model_number

    return MODELS.get(model_number(info.model_number) or model_number(info.serial_number) or 0)


@cache
def _ends() -> dict[str, tuple[str, ...]]:
    """Returns a table: the last words of devices' names ("gx5-45", "45") -> the devices' ids."""
    ends: dict[str, dict[str, None]] = {}
    for id, names in DEVICES.items():
        for words in map(_words, (id, *names)):
            for first in range(1, len(words)):
                ends.setdefault("".join(words[first:]), {})[id] = None
    return {end: tuple(ids) for end, ids in ends.items()}


def unknown(
    name: str, what: str, choices: Iterable[str], near: Iterable[str] | None = None
) -> UnknownName:
    """Returns the error for an unknown name, with the nearest names."""
    choices = list(choices)
    close = tuple(_close(name, choices) if near is None else near)[:4]
    few = tuple(choices) if len(choices) <= 8 else ()
    hint = f"did you mean {_either(close)}?" if close else f"known: {', '.join(few)}" if few else ""
    text = f"{name!r} is not {what}"
    return UnknownName("unknown_name", f"{text}; {hint}" if hint else text, close or few)


def _close(name: str, names: Iterable[str], cutoff: float = 0.6) -> list[str]:
    from difflib import get_close_matches  # only errors need it

    return get_close_matches(name, list(names), 4, cutoff)


def ambiguous(name: str, names: tuple[str, ...]) -> UnknownName:
    return UnknownName("ambiguous", f"{name!r} may be {_either(names)}", names)


def _either(names: tuple[str, ...]) -> str:
    return " or ".join(filter(None, (", ".join(names[:-1]), names[-1])))
