"""Identifiers: the words of the specification in Python's case, with Python's own names escaped."""

from __future__ import annotations

import builtins

from mipgen import model as m
from mipgen.emit.naming import Escape, Grammar, pascal, upper
from mipgen.emit.render import language

_LANGUAGE = language("python")
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])

#: Module -> the fact of the specification without which it is left out.
NEEDS: dict[str, str] = dict(_LANGUAGE["needs"])

GRAMMAR = Grammar(r"[A-Za-z_]\w*", _KEYWORDS)

#: Scalar -> its letter in a `struct` format, and its type in Python.
SCALARS: dict[str, tuple[str, str]] = {name: (row[0], row[1]) for name, row in _LANGUAGE["scalars"].items()}

_constant = Escape(frozenset(), digit_prefix="N")
_class = Escape(_KEYWORDS | frozenset(_LANGUAGE["classes"]), digit_prefix="Mip")

#: A descriptor set -> its module.
module = Escape(_KEYWORDS | frozenset(_LANGUAGE["modules"]), digit_prefix="mip_")

#: A parameter -> the attribute of the objects that hold it; a function -> its constructor.
member = Escape(_KEYWORDS | frozenset(_LANGUAGE["members"]), digit_prefix="n")

#: An element of a vector.
element = Escape(_KEYWORDS | frozenset(_LANGUAGE["elements"]), digit_prefix="n")

#: A number inside a bitfield -> the property that reads it.
prop = Escape(_KEYWORDS | frozenset(_LANGUAGE["bits"]), digit_prefix="n")


def constant(words: str) -> str:
    """A value, a bit or a device."""
    return _constant(upper(words))


def class_name(thing: m.Type | m.Field) -> str:
    name = pascal(thing.name)
    return name if home(thing) == "protocol" else _class(name)


def home(thing: m.Type | m.Field) -> str:
    """The module that defines it.

    >>> home(m.Vector("quatf", m.SCALARS["float"], ("w", "x", "y", "z"), ""))
    'types'
    """
    if isinstance(thing, m.Field):
        return module(thing.family) if thing.set else "protocol"
    if thing.name == "function_selector":  # no type of a specification can be called so
        return "protocol"
    return module(thing.owner) if thing.owner else "types"


def qualified(thing: m.Type | m.Field) -> str:
    """What any module may call it that imports its module: `types.AckCode`."""
    return f"{home(thing)}.{class_name(thing)}"


def reference(thing: m.Type | m.Field, where: str) -> str:
    """What the module `where` calls it. What `protocol` defines is imported by name everywhere."""
    return class_name(thing) if home(thing) in (where, "protocol") else qualified(thing)


def hides_builtin(name: str) -> bool:
    """Does `from mip_protocol import name` hide a name of Python itself?"""
    return hasattr(builtins, name)
