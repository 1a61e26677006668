"""Identifiers: the words of the specification in the case of JavaScript, with its own names escaped."""

from __future__ import annotations

import re

from mipgen import model as m
from mipgen.emit.naming import Escape, Grammar, pascal, upper
from mipgen.emit.render import language

_LANGUAGE = language("javascript")
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])

GRAMMAR = Grammar(r"[A-Za-z_$][\w$]*", _KEYWORDS)

#: Scalar -> its type in TypeScript.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]

_constant = Escape(frozenset(), digit_prefix="N")
_class = Escape(frozenset(_LANGUAGE["classes"]), digit_prefix="Mip")
_member = Escape(frozenset(_LANGUAGE["members"]))

#: A family -> the name of its module, after which its file is called.
module = Escape(frozenset(_LANGUAGE["modules"]), digit_prefix="")

#: A family -> what a program that imports its module as a whole calls it.
namespace = Escape(_KEYWORDS | frozenset(_LANGUAGE["modules"]), digit_prefix="mip")


def camel(words: str) -> str:
    """
    >>> camel("scaled_accel"), camel("gnss_1"), camel("port_2_3"), camel("ping")
    ('scaledAccel', 'gnss1', 'port2_3', 'ping')
    """

    def joint(match: re.Match[str]) -> str:
        before, following = words[match.start() - 1], match[1]
        return match[0] if before.isdigit() and following.isdigit() else following.upper()

    return re.sub(r"(?<!^)_(.)", joint, words)


def member(words: str) -> str:
    """A parameter -> the member of objects that holds it; a function -> its constructor. `memberName` does the same."""
    return _member(camel(words))


def constant(words: str) -> str:
    """A value or a bit."""
    return _constant(upper(words))


def class_name(thing: m.Type | m.Field) -> str:
    name = pascal(thing.name)
    return name if home(thing) == "protocol" else _class(name)


def home(thing: m.Type | m.Field) -> str:
    """The module that defines it."""
    if isinstance(thing, m.Field):
        return module(thing.family) if thing.set else "protocol"
    if thing.name == "function_selector":  # no type of a specification can be called so
        return "protocol"
    return module(thing.owner) if thing.owner else "types"


def reference(thing: m.Type | m.Field, where: str) -> str:
    """What the module `where` calls it."""
    return class_name(thing) if home(thing) in (where, "protocol") else f"{home(thing)}.{class_name(thing)}"
