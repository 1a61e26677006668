"""Identifiers: the words of the specification, escaped if Kaitai or one of its target languages reserves them."""

from __future__ import annotations

import re

from mipgen import model as m
from mipgen.base import resources
from mipgen.emit.naming import Escape, Grammar
from mipgen.emit.render import language

_LANGUAGE = language("kaitai")
RESERVED = frozenset(str(word) for word in _LANGUAGE["reserved"])

#: Modules of Python's standard library.
MODULES = frozenset(str(name) for name in _LANGUAGE["modules"])

#: Scalar -> its type.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]

#: A parameter, a bit, or an element of a vector -> the attribute that holds it.
member = Escape(RESERVED | frozenset(_LANGUAGE["members"]), suffix="_value", digit_prefix="n")

#: A value of an enumeration.
value = Escape(RESERVED | frozenset(_LANGUAGE["values"]), suffix="_value", digit_prefix="n")

#: The file, the enumeration of its fields, and the types of the framing.
_TEMPLATE = (resources.root() / "templates/kaitai/mip.ksy.j2").read_text("utf-8")
_TYPES = frozenset({"mip", "kind", *re.findall(r"^  (\w+):$", _TEMPLATE, re.MULTILINE)})

_type = Escape(RESERVED | _TYPES, suffix="_type", digit_prefix="mip_")


def type_name(thing: m.Type | m.Field) -> str:
    """Returns the name of a type or an enumeration; all are in one scope.

    >>> type_name(m.Vector("vector3f", m.SCALARS["float"], ("x", "y", "z"), ""))
    'vector3f'
    """
    owner = None if isinstance(thing, m.Field) and not thing.set else thing.owner  # the acknowledge has no set
    return _type(f"{owner}_{thing.name}" if owner else thing.name)


def kind_name(f: m.Field, number: int) -> str:
    """Returns the name of a field in one of its sets."""
    return _type(f.name_in(number).replace(".", "_")) if f.set else type_name(f)


def camel_case(name: str) -> str:
    """Returns a name in camel case, as some languages write it, to find names that would be equal there.

    >>> camel_case("pos_1"), camel_case("pos1")
    ('pos1', 'pos1')
    """
    first, *others = name.split("_")
    return first + "".join(word[:1].upper() + word[1:] for word in others)


def cases(union: str) -> str:
    """Returns the type of a union, which is nested in the type of its record."""
    return f"{union}_cases"


#: Identifiers as `camel_case` writes them.
GRAMMAR = Grammar(r"[a-z][A-Za-z0-9]*", frozenset(map(camel_case, RESERVED)))
