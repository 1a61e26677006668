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
GRAMMAR = Grammar(r"[A-Za-z]\w*|_\w+", KEYWORDS)

module = Escape(KEYWORDS, digit_prefix="mip_")
member = Escape(KEYWORDS)
method = Escape(KEYWORDS | frozenset(LANGUAGE["bit_methods"]))
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


def constants(functions: Iterable[m.Function]) -> str:
    """Writes function selectors as the macros of the crate list them."""
    return " ".join(constant(f.name) for f in functions)


def constructor(function: m.Function) -> str:
    name: str = LANGUAGE["constructors"].get(function.name, function.name)
    return _constructor(name)


def call_type(function: m.Function) -> str:
    """Returns the type of a command with this function."""
    return _type(pascal(constructor(function)))


def named(name: str, words: str) -> str:
    """Writes an identifier, followed by the name in the specification if that differs.

    >>> named("mode", "mode"), named("type_", "type")
    ('mode', 'type_ "type"')
    """
    return name if name == words else f'{name} "{words}"'


def responses_name(command: m.Field) -> str:
    """Returns the type of the responses to a command that has several."""
    return type_name(f"{command.name}_responses")


def response_variant(response: m.Field, command: m.Field) -> str:
    words = response.name.removeprefix(f"{command.name}_").removesuffix("_response")
    return variant(words or response.name)


# --------------------------------------------------------------------------- places


def modules() -> list[str]:
    """Returns the modules that every crate has, also those that are private."""
    root = (resources.root() / "runtime/rust/src/lib.rs").read_text("utf-8")
    return sorted({"session", *re.findall(r"^(?:pub )?mod (\w+);", root, re.MULTILINE)})


def home(thing: m.Type | m.Record) -> str:
    """Returns the module of a type."""
    return module(thing.owner) if thing.owner else "types"


def feature(family: m.Family) -> str:
    """Returns the cargo feature of a family."""
    return module(family.name)


def set_constant(s: m.Set, family: m.Family) -> str:
    """Returns the constant for the number of a descriptor set; empty if no packet uses it. Names are unique across
    modules, so that programs can import several modules with `*`."""
    return "" if family.kind == "shared" else f"{module(s.name).upper()}_SET"


def path(thing: m.Type | m.Record, here: str) -> str:
    """Returns the name of a type inside the module `here`."""
    name, where = type_name(thing.name), home(thing)
    return name if where == here else f"types::{name}" if where == "types" else f"crate::{where}::{name}"


# --------------------------------------------------------------------------- scalars


def scalar(of: m.Scalar | None) -> str:
    assert of is not None
    return str(LANGUAGE["scalars"][of.name])


def inner(t: m.Enum | m.Bitfield) -> str:
    """Returns the type inside a newtype."""
    return f"[u8; {t.size}]" if isinstance(t, m.Bitfield) and t.scalar is None else scalar(t.scalar)


def bits_type(bits: m.Bits, here: str) -> str:
    """Returns the type of some bits: a flag, an enumeration, or the smallest sufficient number."""
    if bits.enum is not None:
        return path(bits.enum, here)
    return "bool" if bits.width == 1 else next(f"u{n}" for n in (8, 16, 32, 64) if n >= bits.width)
