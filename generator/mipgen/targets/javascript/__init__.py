"""JavaScript: modules of classes with declarations for TypeScript, and the model for tools."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.lower import calls
from mipgen.targets.json import api as json

from . import blocks, docs, members, names, session

#: The modules that programs import, except those of families: name -> path without extension.
EXPORTS = {
    ".": "./mip/index",
    "./protocol": "./protocol",
    "./types": "./types",
    "./registry": "./registry",
    "./tcp": "./mip/tcp",
    "./serial": "./mip/serial",
    "./websocket": "./mip/websocket",
    "./tools": "./mip/tools",
    "./model": "./model",
}


def files(model: m.Model) -> Iterator[File]:
    families = {f"./{names.module(x.name)}": f"./{names.module(x.name)}" for x in model.families}
    yield File("package.json", "package.json.j2", {"exports": [*EXPORTS.items(), *families.items()]})
    quickstart = model.program("quickstart.mjs")
    if quickstart:
        yield File("quickstart.mjs", "verbatim.j2", {"text": quickstart})
    shown = {
        "quickstart": quickstart.rstrip(),
        "live": model.program("live.mjs").rstrip(),
        "typed": model.program("typed.mts").rstrip(),
        "decode_log": model.program("decode_log.mjs").rstrip(),
    }
    yield File("README.md", "README.md.j2", shown)
    for name in ("model", "types", "protocol", "registry"):
        yield File(f"{name}.mjs", f"{name}.mjs.j2")
        yield File(f"{name}.d.mts", f"{name}.d.mts.j2")
    for name in ("session.mjs", "session.d.mts"):
        yield File(name, f"{name}.j2", {"session": session.of(model)})
    for x in model.families:
        yield File(f"{names.module(x.name)}.mjs", "set.mjs.j2", {"family": x}, x)
        yield File(f"{names.module(x.name)}.d.mts", "set.d.mts.j2", {"family": x}, x)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        "document": lambda model: blocks.exact(json.text(model)),
        # identifiers
        "class": names.class_name,
        "constant": names.constant,
        "home": names.home,
        "key": blocks.key,
        "member": names.member,
        "module": names.module,
        "namespace": names.namespace,
        # layouts
        "bits": blocks.bits,
        "block": blocks.block,
        "hex": "0x{:02x}".format,
        "more": lambda f: blocks.more(f, model),
        "needs": lambda family: blocks.needs(family, model),
        "scalar_of": blocks.scalar_of,
        "sets": blocks.sets,
        # declarations
        "answer": lambda function, f: members.answer(function, f, model),
        "answers": lambda f: members.answers(f, model),
        "constructors": calls.constructors,
        "depends": lambda f: members.depends(f, model),
        "given": members.given,
        "hint": members.hint,
        "may_be_absent": members.may_be_absent,
        "member_key": members.key,
        "members": calls.members,
        "number": members.number,
        "unneeded": members.unneeded,
        # comments
        **docs.filters(model),
    }


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterator[Identifier]:
    yield from json.identifiers(model)  # fields and types are also found by the names that they have in JSON
    yield from names.identifiers(model, _attributes)


def _attributes(t: m.Type | m.Field) -> Iterator[tuple[str, str, m.Position | None]]:
    """Yields the names of a class's members in JavaScript and in the specification."""
    if isinstance(t, m.Enum):
        for v in t.values:
            yield names.constant(v.name), v.name, v.position
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            yield names.constant(b.name), b.name, b.position
    elif isinstance(t, (m.Field, m.Struct)):
        for p in calls.members(t):
            yield names.member(p.name), p.name, p.position


TARGET = Target(
    title="JavaScript modules with types, without dependencies",
    files=files,
    filters=filters,
    identifiers=identifiers,
    rename=package.in_source,
    beside="json",
    conformance=("parse", "decode", "encode", "client"),
    program="node",
)
