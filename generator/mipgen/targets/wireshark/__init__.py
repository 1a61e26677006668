"""Wireshark: a dissector in Lua, one file.

The finished source is in runtime/wireshark, which mip.lua.j2 includes.
"""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Target

from . import names, view
from .names import identifiers


def files(model: m.Model) -> Iterator[File]:
    for name in ("mip.lua", "README.md"):
        yield File(name, f"{name}.j2", {"dissector": model.derived(view.Dissector)})


TARGET = Target(
    title="Wireshark dissector, Lua",
    files=files,
    filters={"string": view.string, "octets": view.octets, "hex": view.hexadecimal},
    runtime=lambda _files, _model: {},  # mip.lua includes them
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=names.GRAMMAR,
    conformance=("decode",),
    needs="tshark",
)
