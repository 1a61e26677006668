"""C99: one header and one source for each descriptor set, on a small core."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from ... import formatting, resources
from ... import model as m
from ...checks import SHARED_DESCRIPTORS
from ...render import File
from . import calls, direct, literals, members, names, programs, sizes, tables
from .comments import Comments, comment
from .identifiers import identifiers
from .names import MAX_IDENTIFIER

__all__ = ["CONFORMANCE", "FORMATTER", "MAX_IDENTIFIER", "TITLE", "files", "filters", "identifiers"]

TITLE = "C99, library mip"
CONFORMANCE = ("parse", "decode", "encode", "client", "live")
FORMATTER = formatting.CLANG_FORMAT
#: Programs for several kinds of systems. Arduino's IDE wants each in a folder of its name.
EXAMPLES = ("posix.c", "bare_metal.c", "cplusplus.cpp", "arduino/arduino.ino")


def files(model: m.Model) -> Iterator[File]:
    made = list(code(model))
    made.append(File("src/mip/mip.h", "mip.h.j2", {"headers": everything(made)}))
    yield from made
    yield from packages(model, made)
    taste = model.taste("taste.c")
    if taste:
        yield File("taste.c", "verbatim.j2", {"text": taste})
    for name in EXAMPLES:
        if example := model.taste(name.rpartition("/")[2]):
            yield File(f"examples/{name}", "verbatim.j2", {"text": example})
    shown = {name: model.taste(f"{name}.c").rstrip() for name in ("device", "client", "present")}
    shown["taste"] = taste.partition("*/\n")[2].rstrip()
    yield File("README.md", "README.md.j2", shown)


def code(model: m.Model) -> Iterator[File]:
    """Headers and sources."""
    yield File(
        "src/mip/constants.h",
        "constants.h.j2",
        {"first_shared": SHARED_DESCRIPTORS.start, "max_field_data": m.MAX_FIELD_DATA},
    )
    for name in ("names", "profiles", "protocol", "types"):
        yield File(f"src/mip/{name}.h", f"{name}.h.j2")
    for name in ("names", "profiles", "protocol", "reflection", "registry"):
        yield File(f"src/mip/{name}.c", f"{name}.c.j2")
    for s in model.sets:
        name = names.module(s.name)
        yield File(f"src/mip/{name}.h", "set.h.j2", {"set": s})
        if calls.commands(s):
            yield File(f"src/mip/{name}_commands.h", "commands.h.j2", {"set": s})
        if s.fields:
            yield File(f"src/mip/{name}.c", "set.c.j2", {"set": s})


def everything(made: list[File]) -> list[str]:
    """The headers that programs include; of the runtime too."""
    return [name for name in present(made) if name.endswith(".h") and name not in ("export.h", "mip.h", "program.h")]


def present(made: list[File]) -> list[str]:
    """The names of all headers and sources, those that are made and those of the runtime."""
    folder = "src/mip/"
    runtime = (resources.root() / "templates/c/runtime" / folder).iterdir()
    return sorted({*(p.name for p in runtime), *(f.path.removeprefix(folder) for f in made)})


def packages(model: m.Model, made: list[File]) -> Iterator[File]:
    """What build systems and package managers read: version, sources and headers, of the runtime too."""
    found = present(made)
    facts = {
        "sources": [name for name in found if name.endswith(".c")],
        "headers": [name for name in found if name.endswith(".h")],
        "soversion": ".".join(model.protocol.version.split(".")[:2]),
        "summary": "The MIP protocol of MicroStrain inertial sensors",
    }
    yield File("cmake/sources.cmake", "sources.cmake.j2", facts)
    for path in ("meson.build", "library.json", "library.properties", "idf_component.yml", "Doxyfile"):
        yield File(path, f"{path}.j2", facts)


def in_order(s: m.Set) -> Iterator[m.Field]:
    """The fields of a set, each command followed by the responses that it owns."""
    for f in s.fields:
        if f.role != m.RESPONSE:
            yield f
            yield from (r for r in s.fields if r.role == m.RESPONSE and r.command == f.name)


def includes(s: m.Set, model: m.Model) -> list[str]:
    """The headers that the header of a set needs: of the sets whose fields it repeats too, for their types."""
    repeated = (model.original(f).set_name for f in s.fields if f.definition)
    return list(dict.fromkeys(["protocol", *map(names.module, repeated)]))


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    docs = Comments(model)
    return {
        # names
        "module": names.module,
        "macro": names.macro,
        "member": names.member,
        "argument": names.argument_name,
        "type": names.type_name,
        "c_type": names.c_type,
        "field": names.field_name,
        "record": names.record_name,
        "bare": names.bare,
        "union": names.union_name,
        "constant": names.constant,
        "accessor": names.accessor,
        "short": names.short,
        "is_enum": names.is_enum,
        "key": literals.key,
        "is_struct": names.is_struct,
        "spec_name": names.spec_name,
        # literals
        "hex": literals.hexadecimal,
        "number": literals.number,
        "mask": literals.mask,
        "decimal": literals.decimal,
        "string": literals.string,
        "version_number": literals.version_number,
        "milliseconds": lambda seconds: round(seconds * 1000) if seconds else 0,
        # records
        "members": members.members,
        "alternatives": members.alternatives,
        "takes_enum": members.takes_enum,
        "declaration": members.declaration,
        "home": members.home,
        "in_order": in_order,
        "includes": lambda s: includes(s, model),
        "optional": lambda record: isinstance(record, m.Field) and record.optional,
        "last_present": members.last_present,
        "constructors": members.constructors,
        "silent": members.silent,
        "responses": lambda f: members.responses(f, model),
        "commands": calls.commands,
        "sends": lambda f: calls.sends(f, model),
        "calls": lambda f: calls.calls(f, model),
        "bits_type": members.bits_type,
        "has_accessor": members.has_accessor,
        # layouts
        "program": lambda f: programs.program(f, model.layouts(f), model.sizes(f)),
        "numbers_only": lambda f: programs.numbers(f, model.layouts(f)),
        "direct": direct.direct,
        "layouts": lambda f: len(model.layouts(f)) > 1,
        # tables
        "required": tables.required,
        "entries": lambda of: list(tables.entries(of)),
        "names": tables.names,
        "parameter_row": tables.parameter,
        "reflection_row": lambda f: tables.reflection(f, model),
        "readings": tables.readings,
        "numbers": tables.numbers,
        "labels": tables.labels,
        "letters": m.letters,
        "max_value_size": sizes.max_value_size,
        # comments
        "comment": comment,
        "device_doc": docs.device,
        "set_doc": docs.set,
        "field_doc": docs.field,
        "present_doc": docs.present,
        "type_doc": docs.type,
        "member_doc": docs.member,
        "arguments_doc": docs.arguments,
        "case_doc": docs.case,
        "value_doc": docs.value,
        "bits_doc": docs.bits,
    }
