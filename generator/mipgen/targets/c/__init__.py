"""C99: one header and one source for each descriptor set, or family of them, on a small core.

The finished source is in runtime/c. Where to change what, and its tests in `tests/c` unless they state a folder:

- replies to a command, `mip_exchange`: `replies` in `members`, client.c; `unit/client.c`, `tests/conformance`
- folders: headers for every program in src/mip, sources in core/ and sets/ below it; extra/ and cpp/ are whole parts
- C++17: `cpp`, `cpp_snippets`, *.hpp.j2, core.hpp, device.hpp, client.hpp; `tests/cpp`: what it does, what must not
  compile, what it costs compared with C
- a device at a port, mip/device.h: `calls`; `test_c_device.py` calls every command and runs the examples
- finding a device and starting its data, mip/connect.h: `session` in `calls`; `unit/connect.c`, `test_c_first_day.py`
- serial ports and TCP, which are no part of the library: ports/; `test_c_first_day.py`, also with mingw; a lost port,
  line.c: `tests/virtual/test_reopen.py`
- deviations from MISRA C, with reasons: MISRA.md; `test_c_matrix.py`
- what is proved, and what is fuzzed: `tests/prove`, `tests/fuzz`, docs/proofs.md
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from mipgen import model as m
from mipgen.emit import formatting, package
from mipgen.emit.target import File, Target
from mipgen.lower.lists import alternatives, by_command, defined

from . import calls, literals, names, validity, view
from .comments import comment, inert
from .identifiers import identifiers
from .names import GRAMMAR

#: Headers that every program may need, and folders.
FOLDER = "src/mip/"
FOLDERS = ("core", "cpp", "extra", "sets")
#: What users can leave out, with the examples that need it.
PARTS = {
    "cpp": rf"{FOLDER}cpp/|.*\.[hc]pp$|docs/cpp\.md",
    "extra": rf"{FOLDER}extra/|examples/log\.",
}
#: Example programs for several kinds of systems. Arduino's IDE requires each in a folder with its name.
EXAMPLES = (
    "stream.c",
    "bare_metal.c",
    "freertos.c",
    "application.c",
    "zephyr.c",
    "esp_idf.c",
    "stm32.c",
    "log.cpp",
    "log.c",
    "arduino/arduino.ino",
)
#: Pages beside the README.
PAGES = ("packets", "commands", "cpp", "threads", "building", "measurements")
#: Files for build systems and package managers.
MANIFESTS = (
    *("library.json", "library.properties", "idf_component.yml"),
    *("Doxyfile", "cmake/sources.cmake", "cmake/mip.pc.in", "zephyr/Kconfig"),
)


def files(model: m.Model) -> Iterator[File]:
    yield from code(model)
    yield from in_cpp(model)
    yield File(f"{FOLDER}mip.h", "mip.h.j2", lambda paths: {"headers": named(paths, r"mip/\w+\.h")})
    yield File(f"{FOLDER}cpp/mip.hpp", "mip.hpp.j2", lambda paths: {"headers": named(paths, r"mip/cpp/\w+\.hpp")})
    yield from packages(model)
    quickstart = model.program("quickstart.c")
    if quickstart:
        yield File("quickstart.c", "", {"text": quickstart})
    for name in EXAMPLES:
        if example := model.program(name.rpartition("/")[2]):
            yield File(f"examples/{name}", "", {"text": example})
    in_c = ("device", "client", "present", "receivers", "change", "defer")
    shown = {name: model.program(f"{name}.c").rstrip() for name in in_c}
    shown |= {name: model.program(f"{name}.cpp").rstrip() for name in ("cpp", "cpp_stream", "cpp_client", "cpp_change")}
    shown |= {"vendor_sdk": model.program("vendor_sdk.md").rstrip(), "bench": model.program("bench_c.md").rstrip()}
    shown["bench_peer"] = model.program("bench_c_peer.md").rstrip()
    session = calls.session_calls(model)
    shown["first"] = model.program("stream.c").partition("*/\n")[2].rstrip() if session else ""
    shown["ping"] = session.ping if session else ""
    shown["quickstart"] = quickstart.partition("*/\n")[2].rstrip()

    def texts(paths: Sequence[str]) -> dict[str, object]:
        return {**shown, "folders": {path.split("/")[1] for path in named(paths, "mip/.*/.*")}}

    for path, name in (("README.md", "README"), *((f"docs/{name}.md", name) for name in PAGES)):
        yield File(path, f"{name}.md.j2", texts)


def code(model: m.Model) -> Iterator[File]:
    """Yields the C headers and sources."""
    library = model.derived(view.Library)
    session = calls.session_calls(model)
    for name in ("constants", "protocol", "types"):
        yield File(f"{FOLDER}{name}.h", f"{name}.h.j2", {"library": library})
    yield File(f"{FOLDER}core/protocol.c", "protocol.c.j2", {"library": library})
    if session:
        yield File(f"{FOLDER}connect.h", "connect.h.j2", {"session": session})
        yield File(f"{FOLDER}sets/connect.c", "connect.c.j2", {"session": session})
    yield from times(model)
    for name in ("names.h", "names.c", "profiles.h", "profiles.c", "reflection.c", "registry.c", "rejected.h"):
        yield File(f"{FOLDER}extra/{name}", f"{name}.j2", {"library": library, "session": session})
    bits = {n: [sum(1 << d % 8 for d in ds if d // 8 == i) for i in range(32)] for n, ds in defined(model).items()}
    rejected = {
        "commands": by_command(model),
        "alternatives": alternatives(model),
        "defined": [*bits.items()],
        "session": session,
    }
    yield File(f"{FOLDER}extra/rejected.c", "rejected.c.j2", rejected)
    if inline := library.inline:
        yield File(f"{FOLDER}protocol_inline.h", "inline.h.j2", {"header": "protocol", "fields": inline})
    for family in library.families:
        name, of = family.name, family.of
        yield File(f"{FOLDER}{name}.h", "family.h.j2", {"family": family}, of)
        if family.inline:  # a separate file, because it compiles slowly
            yield File(f"{FOLDER}{name}_inline.h", "inline.h.j2", {"header": name, "fields": family.inline}, of)
        if family.has_commands:
            yield File(f"{FOLDER}{name}_commands.h", "commands.h.j2", {"family": family}, of)
        if functions := [x for f in family.fields for x in validity.validity_functions(f.of, model)]:
            yield File(f"{FOLDER}{name}_valid.h", "valid.h.j2", {"family": family, "functions": functions}, of)
        if of.fields:
            yield File(f"{FOLDER}sets/{name}.c", "family.c.j2", {"family": family}, of)


def times(model: m.Model) -> Iterator[File]:
    """Yields what finds the times of packets."""
    sources, clocks = [*validity.clock_sources(model)], model.protocol.clocks
    devices = model.derived(validity.reading_devices)
    facts = {
        "clocks": [{"of": c, "name": validity.clock_constant(c)} for c in clocks],
        "epochs": [c.epoch_days or 0 for c in clocks],
        "leaps": model.protocol.leaps,
        "sources": sources,
        "groups": [*enumerate(devices.groups, validity.USUAL + 1)],
        "models": [(number, devices.of(some)) for number, name in model.read_as if (some := model.device(name))],
        "most_parts": max((len(s.parts) for s in sources), default=1),
        "most_readings": max((1, *(len(s.readings) for s in sources))),
        "unknown": validity.UNKNOWN,
        "usual": validity.USUAL,
    }
    if sources:
        yield File(f"{FOLDER}timestamps.h", "timestamps.h.j2", facts)
        yield File(f"{FOLDER}sets/timestamps.c", "timestamps.c.j2", facts)


def in_cpp(model: m.Model) -> Iterator[File]:
    """Yields the C++ headers."""
    library = model.derived(view.Library)
    yield File(f"{FOLDER}cpp/types.hpp", "types.hpp.j2", {"library": library})
    for family in library.families:
        yield File(f"{FOLDER}cpp/{family.name}.hpp", "family.hpp.j2", {"family": family}, family.of)
        if family.has_commands:
            yield File(f"{FOLDER}cpp/{family.name}_commands.hpp", "commands.hpp.j2", {"family": family}, family.of)


def named(paths: Sequence[str], pattern: str) -> list[str]:
    """Returns the headers and sources whose paths, below src, match a pattern, in order."""
    names = (path.removeprefix("src/") for path in paths if path.startswith(FOLDER))
    return sorted(name for name in names if re.fullmatch(pattern, name))


def packages(model: m.Model) -> Iterator[File]:
    """Yields the files for build systems and package managers, which list version, sources and headers."""
    protocol = model.protocol
    facts = {
        "soversion": ".".join(protocol.version.split(".")[:2]),
        "summary": f"The {protocol.title}",
        "keywords": list(dict.fromkeys([protocol.package, *map(str.lower, protocol.keywords), "protocol"])),
    }

    def listed(paths: Sequence[str]) -> dict[str, object]:
        headers = {folder: named(paths, rf"{folder}/\w+\.hp*") for folder in ("mip", *(f"mip/{x}" for x in FOLDERS))}
        return {**facts, "sources": named(paths, r".*\.c"), "headers": {k: v for k, v in headers.items() if v}}

    for path in MANIFESTS:
        yield File(path, f"{path.rpartition('/')[2]}.j2", listed)


TARGET = Target(
    title="C99, library mip",
    files=files,
    parts=PARTS,
    filters={
        "comment": comment,
        "hex": literals.hexadecimal,
        "inert": inert,
        "macro": names.macro,
        "module": names.module,
        "plain": literals.plain,
        "string": literals.string,
        "version_number": literals.version_number,
    },
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=GRAMMAR,
    formatter=formatting.CLANG_FORMAT,
    conformance=("parse", "decode", "encode", "client"),
)
