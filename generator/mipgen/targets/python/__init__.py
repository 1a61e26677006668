"""Python: a package that needs only the standard library.

The runtime is in runtime/python; pyproject.toml of mipgen defines which of its modules may import which. Where to
change what, and its tests in `tests/python`:

- fast decoding: `codecs`, codec.py, checks.py, registry.py; `test_python_core.py` compares it with plain code
- what is known about fields at run time: `info`, meaning.py.j2, described.py, info.py, ...; `test_python_meaning.py`
- finding a device and starting its data: `session`, streaming.py; `device/test_start.py`
- a lost port: device.py, aio.py; `tests/virtual/test_reopen.py`
- what the virtual device is told, simulation.json: `simulation`; `tests/tools/simulator`
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from mipgen import model as m
from mipgen.emit import formatting, package
from mipgen.emit.target import File, Identifier, Target
from mipgen.lower import calls, validity
from mipgen.lower.lists import alternatives, by_command

from . import docs, info, names, needs, session, simulation
from .view import Device, Family, Field, Type, blocks, types

PACKAGE = "mip_protocol"


def files(model: m.Model) -> Iterator[File]:
    families = [Family(x, model) for x in model.families]
    whole = {"families": families, "omitted": needs.omitted(model)}
    quickstart = model.program("quickstart.py")
    if quickstart:
        yield File("quickstart.py", "", {"text": quickstart})
    programs = ("daily.md", "client.py", "device.py", "device_aio.py", "meaning.py")
    readme = {name.partition(".")[0]: model.program(name).rstrip() for name in programs} | {
        "quickstart": quickstart.partition('"""\n\n')[2].rstrip(),
        "functions": [names.member(f.name) for f in model.protocol.functions],
    }
    yield File("README.md", "README.md.j2", whole | readme)
    keywords = [model.protocol.name, *model.protocol.keywords, "protocol", "decoder", "serial"]
    yield File("pyproject.toml", "pyproject.toml.j2", {"keywords": keywords})
    for name, context in _modules(model).items():
        yield File(f"{PACKAGE}/{name}.py", f"{name}.py.j2", whole | context)
    yield File(f"{PACKAGE}/simulation.json", "", {"text": simulation.document(model)})
    for x in families:
        yield File(f"{PACKAGE}/{x.module}.py", "set.py.j2", {"family": x}, x.of)
    modules: dict[str, tuple[m.Type | m.Field, ...]] = {
        "types": model.types,
        "protocol": (model.protocol.function_selector, model.protocol.acknowledge),
    }
    for module, things in (modules | {x.module: (*x.of.types, *x.of.fields) for x in families}).items():
        described = (info.describe_class(x, model) for x in things if not isinstance(x, m.Vector))
        of = next((x.of for x in families if x.module == module), None)
        context = whole | {"module": module, "described": described}
        yield File(f"{PACKAGE}/_meaning/{module}.py", "meaning.py.j2", context, of)


def _modules(model: m.Model) -> dict[str, dict[str, Any]]:
    """Returns the modules that every package has, with what their templates print."""
    kinds, acknowledge = types(model.types, model), Field(model.protocol.acknowledge, model)
    protocol, rates = model.protocol, {rate for d in model.devices for port in d.ports for rate in port.baud_rates}
    indexed, commands = (*model.fields, protocol.acknowledge), session.session_commands(model)
    return {
        "__init__": {},
        "_clocks": {"timestamps": validity.timestamps(model), "device_clock": validity.device_clock(model)},
        "_index": {
            "fields": [(f.full_name, (names.home(f), names.class_name(f), f.role, f.title, f.also)) for f in indexed],
            "baud_rates": tuple(sorted(rates, reverse=True)),
            "session": commands,
        },
        "_lists": {
            "commands": [((f.set, f.descriptor), [x.row for x in rows]) for f, rows in by_command(model).items()],
            "alternatives": alternatives(model).items(),
        },
        "_scalars": {"scalars": [(s, names.SCALARS[s.name]) for s in m.SCALARS.values()]},
        "_session": {"session": commands},
        "_sets": {"modules": [(s, names.module(s.family)) for s in model.sets]},
        "_words": {"synonyms": (*protocol.synonyms, *((u.word, *u.instead_of) for u in protocol.vocabulary))},
        "devices": {"devices": [Device(d, model) for d in model.devices]},
        "protocol": {
            "ack_code": names.class_name(protocol.ack_code),
            "acknowledge": acknowledge,
            "blocks": blocks([acknowledge]),
            "function_selector": Type(protocol.function_selector, model),
        },
        "types": {"kinds": kinds, "blocks": blocks(kinds)},
    }


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for x in model.families:
        yield Identifier(PACKAGE, names.module(x.name), f"set {x.name}", x.position)
    yield from names.identifiers(model, attributes)
    for d in model.devices:
        yield Identifier(f"{PACKAGE}.devices", names.constant(d.name), f"device {d.id}", d.position)


def attributes(t: m.Type | m.Field) -> Iterator[tuple[str, str, m.Position | None]]:
    """Yields the names of a class's members in Python and in the specification."""
    if isinstance(t, m.Enum):
        for v in t.values:
            yield names.constant(v.name), v.name, v.position
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            yield names.constant(b.name), b.name, b.position
            if b.width > 1 and not b.alias:
                yield names.prop(b.name), b.name, b.position
                yield f"with_{b.name}", f"{b.name}, set to a number", b.position
    elif isinstance(t, (m.Field, m.Struct)):
        for p in calls.members(t):
            yield names.member(p.name), p.name, p.position
        for f in t.functions if isinstance(t, m.Field) else ():
            yield names.member(f.name), f"function {f.name}", None


TARGET = Target(
    title="Python >= 3.10, package mip_protocol",
    files=files,
    runtime=needs.runtime,
    filters={
        "comment": docs.comment,
        "docstring": docs.docstring,
        "escaped": docs.escaped,
        "hex": "0x{:02X}".format,
        "quoted": info.quoted,
        "repr": repr,
    },
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
    formatter=formatting.RUFF,
    conformance=("parse", "decode", "encode", "client"),
)
