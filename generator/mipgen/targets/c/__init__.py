"""C99: one header and one source for each descriptor set, or family of them, on a small core."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.base import resources
from mipgen.emit import formatting, package
from mipgen.emit.target import File, Target
from mipgen.facts import describe
from mipgen.lower import memory
from mipgen.model import SHARED_DESCRIPTORS

from . import bytecode, calls, cpp, direct, literals, members, names, tables
from .comments import Comments, comment
from .identifiers import identifiers
from .names import GRAMMAR

#: Example programs for several kinds of systems. Arduino's IDE requires each in a folder with its name.
EXAMPLES = (
    "stream.c",
    "bare_metal.c",
    "node.cpp",
    "autopilot.cpp",
    "log.cpp",
    "log.c",
    "arduino/arduino.ino",
    "arduino_cpp/arduino_cpp.ino",
)


def files(model: m.Model) -> Iterator[File]:
    made = list(code(model))
    made.append(File("src/mip/mip.h", "mip.h.j2", {"headers": everything(made)}))
    made += list(in_cpp(model))
    headers = sorted(name for name in present(made) if name.endswith(".hpp"))
    made.append(File("src/mip/mip.hpp", "mip.hpp.j2", {"headers": [x for x in headers if x != "ostream.hpp"]}))
    yield from made
    yield from packages(model, made)
    quickstart = model.program("quickstart.c")
    if quickstart:
        yield File("quickstart.c", "verbatim.j2", {"text": quickstart})
    for name in EXAMPLES:
        if example := model.program(name.rpartition("/")[2]):
            yield File(f"examples/{name}", "verbatim.j2", {"text": example})
    shown = {name: model.program(f"{name}.c").rstrip() for name in ("device", "client", "present", "receivers")}
    shown |= {name: model.program(f"{name}.cpp").rstrip() for name in ("cpp", "cpp_stream", "cpp_client")}
    shown |= {"vendor_sdk": model.program("vendor_sdk.md").rstrip(), "bench": model.program("bench_c.md").rstrip()}
    shown["by_source"] = model.program("bench_c_sources.md").rstrip()
    shown["bench_peer"] = model.program("bench_c_peer.md").rstrip()
    session = calls.session(model)
    shown["first"] = model.program("stream.c").partition("*/\n")[2].rstrip() if session else ""
    shown["ping"] = session.ping if session else ""
    shown["quickstart"] = quickstart.partition("*/\n")[2].rstrip()
    yield File("README.md", "README.md.j2", shown)


def code(model: m.Model) -> Iterator[File]:
    """Yields the C headers and sources."""
    yield File(
        "src/mip/constants.h",
        "constants.h.j2",
        {"first_shared": SHARED_DESCRIPTORS.start, "max_field_data": m.MAX_FIELD_DATA},
    )
    for name in ("names", "profiles", "protocol", "types"):
        yield File(f"src/mip/{name}.h", f"{name}.h.j2")
    for name in ("names", "profiles", "protocol", "reflection", "registry"):
        yield File(f"src/mip/{name}.c", f"{name}.c.j2")
    if session := calls.session(model):
        for end in ("h", "c"):
            yield File(f"src/mip/connect.{end}", f"connect.{end}.j2", {"session": session})
    yield from inline("protocol", [model.protocol.acknowledge])
    for x in model.families:
        name = names.module(x.name)
        yield File(f"src/mip/{name}.h", "family.h.j2", {"family": x}, x)
        yield from inline(name, in_order(x), x)
        if calls.commands(x):
            yield File(f"src/mip/{name}_commands.h", "commands.h.j2", {"family": x}, x)
        if x.fields:
            yield File(f"src/mip/{name}.c", "family.c.j2", {"family": x}, x)


def inline(header: str, fields: Iterable[m.Field], of: m.Family | None = None) -> Iterator[File]:
    """Yields a separate file with the straight-line code for a header's fields, because it compiles slowly."""
    if plain := [f for f in fields if direct.direct(f)]:
        yield File(f"src/mip/{header}_inline.h", "inline.h.j2", {"header": header, "fields": plain}, of)


def in_cpp(model: m.Model) -> Iterator[File]:
    """Yields the C++ headers."""
    yield File("src/mip/types.hpp", "types.hpp.j2")
    for x in model.families:
        name = names.module(x.name)
        yield File(f"src/mip/{name}.hpp", "family.hpp.j2", {"family": x}, x)
        if calls.commands(x):
            yield File(f"src/mip/{name}_commands.hpp", "commands.hpp.j2", {"family": x}, x)


def everything(made: list[File]) -> list[str]:
    """Returns the headers that programs include, both generated and from the runtime."""
    inner = ("checksum.h", "export.h", "mip.h", "program.h")
    return [name for name in present(made) if name.endswith(".h") and name not in inner]


def present(made: list[File]) -> list[str]:
    """Returns the names of all headers and sources, both generated and from the runtime."""
    folder = "src/mip/"
    runtime = (resources.root() / "runtime/c" / folder).iterdir()
    return sorted({*(p.name for p in runtime), *(f.path.removeprefix(folder) for f in made)})


def packages(model: m.Model, made: list[File]) -> Iterator[File]:
    """Yields the files for build systems and package managers, which list version, sources and headers."""
    names = present(made)
    facts = {
        "sources": [name for name in names if name.endswith(".c")],
        "headers": [name for name in names if name.endswith((".h", ".hpp"))],
        "soversion": ".".join(model.protocol.version.split(".")[:2]),
        "summary": f"The {model.protocol.title}",
        "keywords": list(
            dict.fromkeys([model.protocol.package, *(word.lower() for word in model.protocol.keywords), "protocol"])
        ),
    }
    yield File("cmake/sources.cmake", "sources.cmake.j2", facts)
    manifests = (
        "meson.build",
        "library.json",
        "library.properties",
        "idf_component.yml",
        "conanfile.py",
        "Doxyfile",
        "Doxyfile.cpp",
    )
    for path in (*manifests, "vcpkg/vcpkg.json", "cmake/mip.pc.in", "zephyr/Kconfig"):
        yield File(path, f"{path.rpartition('/')[2]}.j2", facts)


def in_order(family: m.Family) -> Iterator[m.Field]:
    """Yields the fields of a family, each command followed by its own responses."""
    for f in family.fields:
        if f.role != m.RESPONSE:
            yield f
            yield from (r for r in family.fields if r.role == m.RESPONSE and r.command == f.name)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    docs = Comments(model)
    renamed = model.protocol.package != m.OWN_PACKAGE
    length = (lambda text: len(package.everywhere(text, model.protocol.package))) if renamed else len
    return {
        # names
        "module": names.module,
        "macro": names.macro,
        "member": names.member,
        "argument": names.argument_name,
        "type": names.type_name,
        "c_type": names.c_type,
        "field": names.field_name,
        "record": names.symbol,
        "bare": names.bare,
        "union": names.union_name,
        "constant": names.constant,
        "accessor": names.accessor,
        "short": names.short,
        "is_enum": names.is_enum,
        "set_constant": names.set_constant,
        "key": literals.key,
        "several": lambda f: len(f.occurrences) > 1,
        "belongs": literals.belongs,
        "is_struct": names.is_struct,
        # literals
        "hex": literals.hexadecimal,
        "number": literals.number,
        "mask": literals.mask,
        "decimal": literals.decimal,
        "string": literals.string,
        "version_number": literals.version_number,
        "quarters": lambda seconds: math.ceil(seconds * 4) if seconds else 0,
        # records
        "members": memory.members,
        "takes_enum": members.takes_enum,
        "declaration": members.declaration,
        "in_order": in_order,
        "last_present": members.last_present,
        "constructors": members.constructors,
        "replies": lambda f: members.replies(f, model),
        "commands": calls.commands,
        "sends": lambda f: calls.sends(f, model),
        "calls": lambda f: calls.calls(f, model),
        "bits_type": members.bits_type,
        "has_accessor": members.has_accessor,
        # C++
        "namespace": cpp.namespace,
        "cpp_word": cpp.word,
        "cpp_bare": cpp.bare,
        "cpp_qualified": cpp.qualified,
        "cpp_accessors": cpp.accessors,
        "cpp_commands": lambda f: cpp.commands(f, model),
        "cpp_response": lambda f: cpp.whole_response(f, model),
        # layouts
        "program": lambda f: bytecode.program(f, model.layouts(f), model.sizes(f)),
        "numbers_only": lambda f: f.min_size if bytecode.is_numbers(f, model.layouts(f)) else 0,
        "shape": lambda f: bytecode.shape(f, model.layouts(f)),
        "interpreter": lambda f: bytecode.interpreter(f, model.layouts(f)),
        "direct": direct.direct,
        "layouts": lambda f: len(model.layouts(f)) > 1,
        # tables
        "required": tables.required,
        "entry": tables.entry,
        "entries": lambda of: list(tables.entries(of)),
        "sets": lambda of: list(tables.sets(of)),
        "names": tables.names,
        "array": lambda declaration, rows: tables.array(declaration, rows, length),
        "parameters": lambda r: [tables.parameter(p, r) for p in r.parameters],
        "alternatives": lambda p, r: [tables.parameter(a, r, p) for a in p.alternatives],
        "cases": tables.cases,
        "readings": tables.readings,
        "reflection": tables.reflection,
        "numbers": tables.numbers,
        "labels": tables.labels,
        "letters": m.letters,
        "max_value_size": memory.largest,
        # comments
        "comment": comment,
        "device_doc": docs.device,
        "why": lambda e: describe.why(e, model),
        "family_doc": docs.family,
        "set_doc": docs.set,
        "field_doc": docs.field,
        "key_doc": docs.key,
        "present_doc": docs.present,
        "type_doc": docs.type,
        "member_doc": docs.member,
        "arguments_doc": docs.arguments,
        "case_doc": docs.case,
        "value_doc": docs.value,
        "bits_doc": docs.bits,
    }


TARGET = Target(
    title="C99, library mip",
    files=files,
    filters=filters,
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=GRAMMAR,
    formatter=formatting.CLANG_FORMAT,
    conformance=("parse", "decode", "encode", "client", "live"),
)
