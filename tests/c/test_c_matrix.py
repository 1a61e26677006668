"""The library and its unit programs, built and run under many compilers, languages, levels and flags.

`make test` runs a few, `make test-all` the rest; other machines are in tests/cross.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from c_build import (
    FIRMWARE,
    HERE,
    PEDANTIC,
    SANITIZE,
    SANITIZED,
    WARNINGS,
    archive,
    compiled,
    folder,
    headers,
    include,
    linked,
    pages,
    run,
    small_parser,
    sources,
    units,
)
from support import ROOT, SEED, SPECS, heavy, need, nightly, small

sys.path.append(str(HERE.parent / "fuzz"))
import fuzz

both = pytest.mark.parametrize("spec", sorted(SPECS))
compilers = pytest.mark.parametrize("compiler", ["cc", pytest.param("clang", marks=heavy("clang"))])

C = ("c99", "c11", "c17", "newest C")
CPP = ("c++11", "c++14", "c++17", "c++20")
LEVELS = ("-Os", "-O2", "-O3")
CHARS = ("-fsigned-char", "-funsigned-char")
NEWEST = ("c23", "c2x")


def standard(compiler: str, name: str) -> str:
    """The option for a language; the newest C has another name in older compilers."""
    for candidate in NEWEST if name == "newest C" else (name,):
        known = subprocess.run(
            [need(compiler), f"-std={candidate}", "-x", "c++" if "+" in name else "c", "-fsyntax-only", "-"],
            input="int unused;\n", capture_output=True, text=True,
        )  # fmt: skip
        if known.returncode == 0:
            return f"-std={candidate}"
    raise AssertionError(f"{compiler} does not know {name}: {known.stderr}")


# --------------------------------------------------------------------------- languages and levels


@compilers
def test_units(compiler: str, tmp_path: Path) -> None:
    """Under the sanitizers, including the check of alignment; with both parsers."""
    run(units(tmp_path / "units", compiler, *SANITIZED))
    if compiler == "cc":
        small = small_parser("invented", "cc", *SANITIZED)
        run(linked(tmp_path / "units", "cc", *SANITIZED, small, archive("invented", "cc", *SANITIZED)))


def test_debug_builds_stop_at_mistakes(tmp_path: Path) -> None:
    program = tmp_path / "mistakes.c"
    program.write_text("""#include "mip/device.h"
#include "mip/tools.h"
int main(int count, char **arguments) {
    static const struct mip_port p = {NULL, NULL, NULL, NULL};
    static struct mip_device d;
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder b;
    (void)mip_builder_start(&b, bytes, sizeof(bytes), MIP_TOOLS_SET);
    (void)mip_tools_ping_encode(NULL, &b);
    if (count > 1 && arguments[1][0] == 'e') {
        (void)!mip_encode(&mip_tools_settings_codec, NULL, &b);
    } else if (count > 1) {
        mip_device_init(&d, &p, 0, NULL);
    }
    return 0;
}
""")
    made, options = tmp_path / "made", ("-std=gnu99", "-DMIP_DEBUG", include("invented"))
    run(need("cc"), *options, program, *sources("invented"), "-o", made)
    run(made)
    for mistake in ("encode", "device"):
        assert subprocess.run([made, mistake]).returncode < 0


@pytest.mark.parametrize("parser", ["SMALL", "FAST"])
def test_options(parser: str, tmp_path: Path) -> None:
    """What is compiled out unless it is wanted."""
    options = ["-std=c99", *WARNINGS, *SANITIZED, "-DMIP_HOOKS", "-DMIP_DIAGNOSTICS", f"-DMIP_PARSER_{parser}"]
    program, made = tmp_path / "options", [source for source in sources("invented") if "/extra/" not in source]
    run(need("cc"), *options, include("invented"), HERE / "unit/options.c", *made, "-o", program)
    run(program)


@pytest.mark.parametrize(("options", "most"), [("", 12), ("-DMIP_WHOLE_ARRAYS", 243)])
def test_room_of_arrays(options: str, most: int, tmp_path: Path) -> None:
    """Arrays have room for their documented range, or for all that fits into a field; a larger count is an error."""
    program = tmp_path / "room.c"
    program.write_text(f"""#include "check.h"
#include "mip/3dm.h"
int main(void) {{
    for (unsigned count = 0; count <= 243; count++) {{
        uint8_t bytes[] = {{1, 1, 1, MIP_EVENT_ACTION_TYPE_MESSAGE, 0x80, 0, 1, (uint8_t)count, [250] = 7}};
        const struct mip_field field = {{bytes, (uint8_t)(8 + count), 0x0C, MIP_3DM_EVENT_ACTION_CONFIG_DESCRIPTOR}};
        struct mip_3dm_event_action_config value;
        const mip_error error = mip_3dm_event_action_config_decode(&value, &field);
        CHECK(error == (count <= {most} ? MIP_OK : MIP_ERROR_COUNT));
        CHECK(count < 243 || error != MIP_OK || value.parameters.message.descriptors[242] == 7);
    }}
    return 0;
}}
""")
    needed = {"3dm", "core", "codec", "double", "program", "value"}
    made = [source for source in sources("real") if Path(source).stem in needed]
    flags = ("-std=c99", *WARNINGS, *SANITIZE, *options.split(), include("real"), f"-I{HERE}/unit")
    run(need("cc"), *flags, program, *made, "-o", tmp_path / "room")
    run(tmp_path / "room")


def test_the_parser_is_chosen_by_macros(tmp_path: Path) -> None:
    """Whichever the compiler's options: the default depends on the machine only, and both at once are an error."""
    made, source = tmp_path / "parser.o", folder("invented") / "src/mip/core"
    chosen = {"": "fast", "-Os": "fast", "-DMIP_PARSER_FAST": "fast", "-DMIP_PARSER_SMALL": "small"}
    for options, parser in chosen.items():
        for name in ("small", "fast"):
            run(need("cc"), *options.split(), include("invented"), "-c", source / f"parser_{name}.c", "-o", made)
            assert ("mip_parser_next" in run(need("nm"), made)) == (name == parser)
    both_macros = [need("cc"), "-DMIP_PARSER_SMALL", "-DMIP_PARSER_FAST", include("invented"), "-fsyntax-only"]
    done = subprocess.run([*both_macros, str(source / "parser.c")], capture_output=True, text=True)
    assert done.returncode != 0 and "MIP_PARSER_SMALL and MIP_PARSER_FAST are both defined" in done.stderr


ALL = nightly("all builds of C")


def rows() -> Iterator[object]:
    """Every language with every level; the flags change from row to row, so that all pairs occur.

    `make test-all` builds each language at one level with one compiler; the next seed draws others.
    """
    for n, compiler in enumerate(("cc", "clang")):
        for i, language in enumerate(C):
            for k, level in enumerate(LEVELS):
                flags = [CHARS[(i + k) % 2], *(["-fshort-enums"] if k != i % 3 else [])]
                row = (compiler, language, level)
                marks = heavy("clang" if compiler == "clang" else "many builds of C")
                if (i + k + SEED) % len(LEVELS) or (n + i + SEED) % 2:
                    marks = ALL
                yield pytest.param(*row, flags, marks=marks, id="-".join((*row, *flags)).replace(" ", "_"))


def cpp_rows() -> Iterator[object]:
    """Every language with both compilers; `make test-all` builds each with one of them."""
    for i, language in enumerate(CPP):
        for n, (pair, marks) in enumerate({"cc g++": heavy("g++"), "clang clang++": heavy("clang")}.items()):
            yield pytest.param(pair, language, marks=ALL if (i + n + SEED) % 2 else marks)


@pytest.mark.parametrize("compiler,language,level,flags", list(rows()))
def test_c(compiler: str, language: str, level: str, flags: list[str], tmp_path: Path) -> None:
    run(units(tmp_path / "units", compiler, standard(compiler, language), level, *flags))


@pytest.mark.parametrize(
    "compiler,level",
    [
        pytest.param(c, level, marks=ALL if (n + k + SEED) % len(LEVELS) else heavy("many builds of C"))
        for n, c in enumerate(("cc", "clang"))
        for k, level in enumerate(LEVELS)
    ],
)
def test_the_real_library(compiler: str, level: str, tmp_path: Path) -> None:
    chars = CHARS[LEVELS.index(level) % 2]
    any_field(tmp_path, compiler, standard(compiler, "newest C"), level, chars, "-fshort-enums")


def any_field(tmp: Path, compiler: str, *flags: str, library: Path | None = None) -> None:
    """All fields of the real specification, as they are fuzzed, with a few inputs."""
    parts, inputs = [HERE / "fuzz/replay.c"], fuzz.hexadecimal(tmp / "inputs", fuzz.begin("fields"))
    program = compiled(tmp / "fields", "real", compiler, HERE / "fuzz/fields.c", *flags, also=parts, library=library)
    run(program, inputs, "3000")


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=ALL)])
@pytest.mark.parametrize("pair,language", list(cpp_rows()))
def test_the_sources_are_cpp_too(pair: str, language: str, spec: str, tmp_path: Path) -> None:
    """The programs stay C, and so does what they link with."""
    c, cpp = pair.split()
    flags = [LEVELS[CPP.index(language) % 3], CHARS[CPP.index(language) % 2]]
    library = archive(spec, cpp, "-x", "c++", standard(cpp, language), *flags)
    if spec == "invented":
        run(units(tmp_path / "units", c, "-std=c99", *flags, library=library))
    else:
        any_field(tmp_path, c, "-std=c99", *flags, library=library)


# --------------------------------------------------------------------------- warnings


@small("many builds of C")
@compilers
@pytest.mark.parametrize("level", [pytest.param("-O0", marks=ALL), "-O2"])  # -O2 finds more
def test_c99_without_a_warning(level: str, compiler: str, spec: str) -> None:
    archive(spec, compiler, *FIRMWARE, level)


@heavy("many builds of C")
@both
def test_further_warnings_of_gcc(spec: str, tmp_path: Path) -> None:
    """Casts that raise the alignment and the like: a project with stricter flags sees no warning either."""
    for source in sources(spec):
        run(need("gcc"), "-std=c99", "-O2", *WARNINGS, *PEDANTIC, include(spec), "-c", source, "-o", tmp_path / "o")


#: The warnings of clang that are not heeded. The README states the reasons.
ACCEPTED = ("bad-function-cast", "declaration-after-statement", "padded", "unsafe-buffer-usage")


@heavy("clang")
@both
def test_every_warning_of_clang(spec: str, tmp_path: Path) -> None:
    shown = pages(spec)
    assert all(f"`-W{name}`" in shown for name in ACCEPTED)
    flags = ["-Weverything", "-Werror", "-Wno-unknown-warning-option", *(f"-Wno-{name}" for name in ACCEPTED)]
    program = tmp_path / "headers.c"  # also those that no source includes
    program.write_text("".join(f'#include "{header}"\n' for header in headers(folder(spec))))
    run(need("clang"), "-std=c99", "-fsyntax-only", *flags, include(spec), *sources(spec), program)


@heavy("cppcheck")
def test_misra_names_what_is_reported(tmp_path: Path) -> None:
    """MISRA.md names exactly the rules that are not kept."""
    copy = tmp_path / "c"  # cppcheck leaves files beside the sources if it is stopped
    shutil.copytree(folder("real"), copy)
    page = (folder("real") / "MISRA.md").read_text("utf-8")
    command = re.search(r"^ {4}(cppcheck .*) \S+$", page, re.M)
    assert command
    finished = [path.relative_to(ROOT / "runtime/c") for path in (ROOT / "runtime/c").rglob("*.c")]
    small = command[1].replace("PARSER_FAST", "PARSER_SMALL")
    reported = set()
    for line in (
        [*command[1].split(), *finished, "src/mip/sets/base.c"],
        [*small.split(), "src/mip/core/parser_small.c"],
    ):
        done = subprocess.run(line, cwd=copy, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        reported |= set(re.findall(r"\[misra-c2012-([\d.]+)\]", done.stderr))
    assert reported == set(re.findall(r"^\| ([\d.]+) ", page, re.M))


# --------------------------------------------------------------------------- checksum

#: The unit programs have that of the machine: vectors, if it has any.
FORMS = ["PLAIN", "WORDS"]


@pytest.mark.parametrize("form", FORMS)
@compilers
def test_every_form_of_the_checksum(compiler: str, form: str, tmp_path: Path) -> None:
    flags = ["-std=c99", "-O2", f"-DMIP_CHECKSUM=MIP_CHECKSUM_{form}"]
    source = folder("invented") / "src/mip/core/core.c"
    run(need(compiler), *WARNINGS, *flags, include("invented"), HERE / "unit/checksum.c", source,
        "-o", tmp_path / "checksum")  # fmt: skip
    run(tmp_path / "checksum")


# --------------------------------------------------------------------------- bare machines, as far as clang goes


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=ALL)])
@heavy("bare-metal machines with clang")
@pytest.mark.parametrize("machine", ["thumbv7m-none-eabi", "powerpc-none-eabi", "msp430-none-elf", "avr"])
def test_freestanding_on_small_machines(machine: str, spec: str, tmp_path: Path) -> None:
    """32 and 16 bits, both byte orders, no C library except five functions of <string.h>."""
    flags = ["-std=c99", "-Os", "-ffreestanding", "-nostdlibinc", *WARNINGS, "-Wno-avr-rtlib-linking-quirks"]
    for source in sources(spec):
        run(need("clang"), f"--target={machine}", *flags, "-isystem", HERE / "freestanding", include(spec),
            "-fsyntax-only", source)  # fmt: skip
