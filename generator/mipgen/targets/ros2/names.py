"""Identifiers: the words of the specification as ROS 2 interfaces write them."""

from __future__ import annotations

import re

from mipgen import model as m
from mipgen.emit.naming import Escape, Grammar, pascal, upper
from mipgen.emit.render import language

_LANGUAGE = language("ros2")
_RESERVED = frozenset({"header", *(str(word) for word in _LANGUAGE["reserved"])})  # messages of fields have a header
_member = Escape(_RESERVED, suffix="_value", digit_prefix="n")

#: Packages that ROS 2 has.
PACKAGES: list[str] = _LANGUAGE["packages"]

#: Scalar -> its type.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]


def message(thing: m.Field | m.Struct | m.Vector) -> str:
    """Returns the name of the message for a field or a structure; all are in one package."""
    name = f"{thing.owner}_{thing.name}" if thing.owner else thing.name
    made = pascal(name).replace("_", "")
    return f"N{made}" if made[:1].isdigit() else made


def member(name: str) -> str:
    """
    >>> member("class"), member("tow"), member("a__b_")
    ('class_value', 'tow', 'a_b')
    """
    return _member(re.sub(r"_+", "_", name).strip("_"))


def constant(parameter: str, name: str) -> str:
    """Returns the constant for a value or a bit of a parameter."""
    return re.sub(r"_+", "_", upper(f"{member(parameter)}_{name}")).strip("_")


#: Identifiers of messages, members and constants.
GRAMMAR = Grammar(r"[A-Z][A-Za-z0-9]*|[a-z][a-z0-9_]*|[A-Z][A-Z0-9_]*")
