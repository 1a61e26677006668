"""JavaScript: modules of classes with declarations for TypeScript, and the model for tools.

The finished source is in runtime/javascript. Where to change what, and its tests in `tests/javascript`:

- how values are read and written, which classes and tools share: codec.mjs, `blocks`, define.j2; `tests/conformance`
- declarations: `view`, declare.j2, *.d.mts; `test_types.py`: what must compile and what must not, sizes of bundles
- starting a device's data: `session`, streaming.mjs; a lost port: device.mjs; `test_javascript.py`
"""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.lower import calls
from mipgen.targets.json import api as json_document

from . import names
from .view import Package, comment


def files(model: m.Model) -> Iterator[File]:
    view = model.derived(Package)
    exports = {name: f"./{path}" for name, path in names.EXPORTS.items()}
    exports |= {f"./{x.module}": f"./{x.module}" for x in view.families}
    yield File("package.json", "package.json.j2", {"exports": exports})
    quickstart = model.program("quickstart.mjs")
    if quickstart:
        yield File("quickstart.mjs", "", {"text": quickstart})
    programs = ("quickstart.mjs", "live.mjs", "typed.mts", "decode_log.mjs")
    shown = {name.partition(".")[0]: model.program(name).rstrip() for name in programs}
    yield File("README.md", "README.md.j2", {"package": view, **shown})
    for end, declared in (("mjs", False), ("d.mts", True)):
        for name in names.GENERATED:
            yield File(f"{name}.{end}", f"{name}.j2", {"package": view, "declared": declared})
        for x in view.families:
            yield File(f"{x.module}.{end}", "set.j2", {"family": x, "declared": declared}, x.family)


# --------------------------------------------------------------------------- identifiers


#: What the class of every command has, so that none of its constructors can.
STATIC = ("decode", "decodeWithTrailing", "layout", "matches", "occursIn", "prototype")


def identifiers(model: m.Model) -> Iterator[Identifier]:
    yield from json_document.identifiers(model)  # fields and types are also found by the names that they have in JSON
    yield from names.identifiers(model, _attributes)
    for name in STATIC:
        yield Identifier("the names of a class", name, f"{name} of every class", None)
    for f in model.protocol.functions:
        yield Identifier("the names of a class", names.camel(f.name), f"function {f.name}", f.position, word=False)


def _attributes(t: m.Type | m.Field) -> Iterator[tuple[str, str, m.Position | None]]:
    """Yields the names of a class's members in JavaScript and in the specification."""
    if isinstance(t, (m.Field, m.Struct)):
        for p in calls.members(t):
            yield names.member(p.name), p.name, p.position
    else:
        for part in m.named_parts(t):
            yield names.constant(part.name), part.name, part.position


TARGET = Target(
    title="JavaScript modules with types, without dependencies",
    files=files,
    filters={"comment": comment, "hex": "0x{:02x}".format, "constant": names.constant},
    identifiers=identifiers,
    rename=package.in_source,
    beside="json",
    conformance=("parse", "decode", "encode", "client"),
    program="node",
)
