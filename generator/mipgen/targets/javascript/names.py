"""Identifiers: the words of the specification in JavaScript's case, with JavaScript's own names escaped."""

from __future__ import annotations

import re

from mipgen.emit.classes import Classes
from mipgen.emit.naming import Escape, Grammar, upper
from mipgen.emit.render import language

_LANGUAGE = language("javascript")
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])

GRAMMAR = Grammar(r"[A-Za-z_$][\w$]*", _KEYWORDS)

#: Scalar -> its type in TypeScript.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]

_constant = Escape(frozenset(), digit_prefix="N")
_member = Escape(frozenset(_LANGUAGE["members"]))

#: A family -> the name of its module and of the module's file.
module = Escape(frozenset(_LANGUAGE["modules"]), digit_prefix="")

_classes = Classes(module, Escape(frozenset(_LANGUAGE["classes"]), digit_prefix="Mip"))
class_name, home, reference, identifiers = _classes.name, _classes.home, _classes.reference, _classes.identifiers

#: A family -> the name under which a program imports its whole module.
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
    """Returns the member for a parameter, or the constructor for a function, as `memberName` does at run time."""
    return _member(camel(words))


def constant(words: str) -> str:
    """Returns the constant for a value or a bit."""
    return _constant(upper(words))
