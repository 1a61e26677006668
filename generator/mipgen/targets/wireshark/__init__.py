"""Wireshark: a dissector in Lua, one file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Target
from mipgen.lower import extent

from . import names, rows, texts
from .names import identifiers


def files(model: m.Model) -> Iterator[File]:
    yield File("mip.lua", "mip.lua.j2", {"parts": names.LANGUAGE["parts"], "prefix": names.PREFIX})
    yield File("README.md", "README.md.j2", {"prefix": names.PREFIX, "examples": names.examples(model)})


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        "string": texts.string,
        "octets": texts.octets,
        "hex": "0x{:02X}".format,
        "plain": names.plain,
        "units": rows.units,
        "item_size": extent.element,
        "place": rows.place,
        "types": rows.types,
        "structs": rows.structs,
        "field_doc": partial(texts.field_doc, model=model),
        "parameter_doc": partial(texts.parameter_doc, model=model),
        "bits_doc": partial(texts.bits_doc, model=model),
    }


TARGET = Target(
    title="Wireshark dissector, Lua",
    files=files,
    filters=filters,
    runtime=lambda _files, _model: {},  # mip.lua includes them
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=names.GRAMMAR,
    conformance=("decode",),
    needs="tshark",
)
