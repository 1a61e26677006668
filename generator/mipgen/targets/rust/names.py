"""The names of the model in Rust, and their modules."""

from __future__ import annotations

import re
from collections.abc import Iterable

from mipgen import model as m
from mipgen.base import resources
from mipgen.emit.naming import Escape, Grammar, pascal, upper
from mipgen.emit.render import language

LANGUAGE = language("rust")
KEYWORDS = frozenset(LANGUAGE["keywords"])


def _in_runtime(path: str, pattern: str) -> list[str]:
    """Returns the names that a file of the runtime defines."""
    return re.findall(pattern, (resources.root() / "runtime/rust/src" / path).read_text("utf-8"), re.MULTILINE)


GRAMMAR = Grammar(r"[A-Za-z]\w*|_\w+", KEYWORDS)

module = Escape(KEYWORDS, digit_prefix="mip_")
member = Escape(KEYWORDS)
method = Escape(KEYWORDS.union(_in_runtime("macros/bitfield.rs", r"pub (?:const )?fn (\w+)")))
_constructor = Escape(KEYWORDS | frozenset(LANGUAGE["functions"]))
_type = Escape(KEYWORDS | frozenset(LANGUAGE["types"]), digit_prefix="Mip")
_variant = Escape(KEYWORDS, digit_prefix="Mip")
_constant = Escape(frozenset(LANGUAGE["constants"]))


def type_name(words: str) -> str:
    """
    >>> type_name("pps_source"), type_name("3dm"), type_name("result"), type_name("self")
    ('PpsSource', 'Mip3dm', 'Result_', 'Self_')
    """
    return _type(pascal(words))


def variant(words: str) -> str:
    """
    >>> variant("none"), variant("self")
    ('None', 'Self_')
    """
    return _variant(pascal(words))


def constant(words: str) -> str:
    """
    >>> constant("receiver_1"), constant("values"), constant("5_hz")
    ('RECEIVER_1', 'VALUES_', '_5_HZ')
    """
    return _constant(upper(words))


def selector_macros(functions: Iterable[m.Function]) -> str:
    """Writes function selectors as the macros of the crate list them."""
    return " ".join(constant(f.name) for f in functions)


def constructor(function: m.Function) -> str:
    name: str = LANGUAGE["constructors"].get(function.name, function.name)
    return _constructor(name)


def call_type(function: m.Function) -> str:
    """Returns the type of a command with this function. `Read` and `Write` alone are traits of the standard library."""
    return _type(pascal(f"{constructor(function)}_call"))


def with_words(escape: Escape, words: str) -> str:
    """Writes an identifier, followed by the name in the specification if that differs.

    >>> with_words(member, "mode"), with_words(member, "type")
    ('mode', 'type_ "type"')
    """
    return words if escape(words) == words else f'{escape(words)} "{words}"'


def response_type(command: m.Field) -> str:
    """Returns the type of the responses to a command; an enumeration, if it has several."""
    several = len(command.responses) > 1
    return type_name(f"{command.name}_responses" if several else command.responses[0]) if command.responses else "()"


def response_variant(response: m.Field, command: m.Field) -> str:
    words = response.name.removeprefix(f"{command.name}_").removesuffix("_response")
    return variant(words or response.name)


# --------------------------------------------------------------------------- places


def crate_modules() -> list[str]:
    """Returns the modules that every crate has, also those that are private."""
    return sorted({"session", *_in_runtime("lib.rs", r"^(?:pub )?mod (\w+);")})


def features() -> list[str]:
    """Returns the features that every crate has; each family is one more."""
    template = (resources.root() / "templates/rust/Cargo.toml.j2").read_text("utf-8")
    section = template.partition("[features]\n")[2].partition("[dependencies]\n")[0]
    return re.findall(r"^([a-z-]+) = ", section, re.MULTILINE)


def home(thing: m.Type | m.Record) -> str:
    """Returns the module of a type."""
    return module(thing.owner) if thing.owner else "types"


def set_constant(s: m.Set, family: m.Family) -> str:
    """Returns the constant for the number of a descriptor set; empty if no packet uses it."""
    if family.kind == "shared":
        return ""
    return "SET" if len(family.sets) == 1 else f"{module(s.name).upper()}_SET"


def path(thing: m.Type | m.Record, here: str) -> str:
    """Returns the name of a type inside the module `here`."""
    name, where = type_name(thing.name), home(thing)
    return name if where == here else f"types::{name}" if where == "types" else f"crate::{where}::{name}"


# --------------------------------------------------------------------------- scalars


def scalar(number: m.Scalar | None) -> str:
    assert number is not None
    return str(LANGUAGE["scalars"][number.name])


def inner(t: m.Enum | m.Bitfield | m.Vector) -> str:
    """Returns the type inside a newtype, or of the array of a vector."""
    if isinstance(t, m.Vector):
        return f"[{scalar(t.scalar)}; {len(t.elements)}]"
    return f"[u8; {t.size}]" if isinstance(t, m.Bitfield) and t.scalar is None else scalar(t.scalar)


def bits_type(bits: m.Bits, here: str) -> str:
    """Returns the type of some bits: a flag, an enumeration, or the smallest sufficient number."""
    if bits.enum is not None:
        return path(bits.enum, here)
    return "bool" if bits.width == 1 else next(f"u{n}" for n in (8, 16, 32, 64) if n >= bits.width)
