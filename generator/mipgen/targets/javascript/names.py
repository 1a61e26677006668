"""Identifiers: the words of the specification in JavaScript's case, with JavaScript's own names escaped."""

from __future__ import annotations

import re

from mipgen.base import resources
from mipgen.emit.naming import Classes, Escape, Grammar, upper
from mipgen.emit.render import language

_LANGUAGE = language("javascript")
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])

GRAMMAR = Grammar(r"[A-Za-z_$][\w$]*", _KEYWORDS)

#: Scalar -> its type in TypeScript.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]

#: The modules that are generated for every specification.
GENERATED = ("model", "types", "protocol", "registry", "session", "time")

#: The modules that programs import, except those of families: name -> path without extension.
EXPORTS = {
    ".": "mip/index",
    "./protocol": "protocol",
    "./types": "types",
    "./registry": "registry",
    "./time": "time",
    "./tcp": "mip/tcp",
    "./serial": "mip/serial",
    "./websocket": "mip/websocket",
    "./tools": "mip/tools",
    "./rejected": "mip/rejected",
    "./model": "model",
}
_MODULES = frozenset({"mip", "package", "quickstart", *GENERATED, *(name.removeprefix("./") for name in EXPORTS)})


def _listed(path: str, list_: str) -> list[str]:
    """Returns the names in the first text of a file that the regular expression finds."""
    match = re.search(list_, (resources.root() / path).read_text("utf-8"))
    assert match, path
    return re.findall(r"\w+", match[1])


#: Names that all objects have, and names that declarations import.
_MEMBERS = _listed("runtime/javascript/mip/naming.mjs", r"const TAKEN = new Set\(\[(.*?)\]\)")
_CLASSES = _listed("templates/javascript/set.j2", r"import type \{(.*?)\}")

_constant = Escape(frozenset(), digit_prefix="N")
_member = Escape(frozenset(_MEMBERS))

#: A family -> the name of its module and of the module's file.
module = Escape(_MODULES, digit_prefix="")

legal_class = Escape(frozenset({"FunctionSelector", *_CLASSES}), digit_prefix="Mip")
_classes = Classes(module, legal_class)
class_name, home, reference, identifiers = _classes.name, _classes.home, _classes.reference, _classes.identifiers

#: A family -> the name under which a program imports its whole module.
namespace = Escape(_KEYWORDS | _MODULES, digit_prefix="mip")


def camel(words: str) -> str:
    """Returns the words in camel case: the constructor for a function, as in the package at run time.

    >>> camel("scaled_accel"), camel("gnss_1"), camel("port_2_3"), camel("ping")
    ('scaledAccel', 'gnss1', 'port2_3', 'ping')
    """

    def joint(match: re.Match[str]) -> str:
        before, following = words[match.start() - 1], match[1]
        return match[0] if before.isdigit() and following.isdigit() else following.upper()

    return re.sub(r"(?<!^)_(.)", joint, words)


def member(words: str) -> str:
    """Returns the member for a parameter, as `memberName` does for tools."""
    return _member(camel(words))


def constant(words: str) -> str:
    """Returns the constant for a value or a bit."""
    return _constant(upper(words))
