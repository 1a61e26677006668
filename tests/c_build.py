"""Compiles the generated library, once for each set of flags, and programs with it."""

from __future__ import annotations

import hashlib
import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

from support import BUILD, SPECS, locked, need

HERE = Path(__file__).parent / "c"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
#: Further warnings of gcc, for the library only: test programs need not be so clean.
PEDANTIC = ["-Wcast-align=strict", "-Wcast-qual", "-Wdouble-promotion", "-Wfloat-equal", "-Wlogical-op",
            "-Wmissing-prototypes", "-Wnull-dereference", "-Wredundant-decls", "-Wsign-conversion",
            "-Wstrict-prototypes", "-Wswitch-enum", "-Wundef", "-Wvla", "-Wwrite-strings"]  # fmt: skip
#: Programs of unit/ that run with the library of the invented specification.
UNITS = ("packets", "fields", "client", "device", "tables", "checksum", "doubles")
#: How firmware is compiled, so that the linker can leave out each function; and with most of the warnings.
FIRMWARE = ("-std=c99", "-O2", "-ffunction-sections", "-fdata-sections")
SANITIZE = ["-g1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
#: The flags of the one library for all programs under the sanitizers: compiling it takes most of their time. Its arrays
#: have room for all that fits, as the conformance drivers require.
SANITIZED = ["-std=c99", "-O0", "-DMIP_WHOLE_ARRAYS", *SANITIZE]


def folder(spec: str) -> Path:
    return SPECS[spec][1] / "c"


def sources(spec: str) -> list[str]:
    return [str(p) for p in sorted((folder(spec) / "src/mip").glob("*/*.c"))]


def pages(spec: str) -> str:
    """The README and the pages beside it."""
    paths = [folder(spec) / "README.md", *sorted((folder(spec) / "docs").glob("*.md"))]
    return "\n".join(path.read_text("utf-8") for path in paths)


def headers(made: Path, end: str = ".h") -> list[str]:
    """The headers that programs include, without those that only the sources of the core need."""
    paths = sorted(p.relative_to(made / "src").as_posix() for p in (made / "src/mip").rglob(f"*{end}"))
    return [path for path in paths if "/core/" not in path]


def include(spec: str) -> str:
    return f"-I{folder(spec)}/src"


def run(*command: object, cwd: Path | None = None, **environment: str) -> str:
    environment = {**os.environ, **environment}
    done = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True, env=environment)
    assert done.returncode == 0, f"{' '.join(map(str, command))[:400]}\n{done.stdout[-3000:]}{done.stderr[-6000:]}"
    return done.stdout


def builds(made: Path, included: list[str]) -> None:
    """All sources compile and link without warnings, each with all that it calls, and so does each header."""
    program = made / "main.c"
    program.write_text("".join(f'#include "{name}"\n' for name in included) + "int main(void) { return 0; }\n")
    flags = [*WARNINGS, f"-I{made}/src"]
    run(need("cc"), "-std=c99", *flags, program, *sorted(made.glob("src/mip/*/*.c")), "-o", made / "main")


def stamp(spec: str, *command: str) -> str:
    digest = hashlib.sha256(" ".join(command).encode())
    for path in sorted(p for p in (folder(spec) / "src/mip").rglob("*") if p.is_file()):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def archive(spec: str, compiler: str, *flags: str) -> Path:
    """The whole library, under all warnings; kept as long as nothing changes."""
    command = [need(compiler), *WARNINGS, *flags]
    key = hashlib.sha256(" ".join([spec, *command]).encode()).hexdigest()[:16]
    where = BUILD / f"c/{key}"
    library, mark = where / "libmip.a", where / "stamp"
    with locked(where):
        now = stamp(spec, *command)
        if not mark.is_file() or mark.read_text() != now:
            where.mkdir(exist_ok=True)
            mark.unlink(missing_ok=True)  # before the library: sources that do not compile leave neither
            library.unlink(missing_ok=True)
            objects = []
            for source in sources(spec):
                objects.append(str(where / f"{Path(source).stem}.o"))
                run(*command, include(spec), "-c", source, "-o", objects[-1])
            tools = compiler[: -len("gcc")] if compiler.endswith("-gcc") else ""
            run(need(f"{tools}ar"), "rcs", library, *objects)
            mark.write_text(now)
    return library


def small_parser(spec: str, compiler: str, *flags: str) -> Path:
    """The parser that 64-bit machines do not have by default; linked before the library, it is used instead."""
    made = BUILD / f"c/small-parser-{hashlib.sha256(' '.join([spec, compiler, *flags]).encode()).hexdigest()[:16]}.o"
    source = folder(spec) / "src/mip/core/parser_small.c"
    with locked(made):
        run(need(compiler), *WARNINGS, *flags, "-DMIP_PARSER_SMALL", include(spec), "-c", source, "-o", made)
    return made


def compiled(
    out: Path,
    spec: str,
    compiler: str,
    source: Path,
    *flags: str,
    also: Sequence[Path] = (),
    library: Path | None = None,
) -> Path:
    """Builds a program with the library; `library`: one that was compiled in another way."""
    library = library or archive(spec, compiler, *flags)
    run(need(compiler), *WARNINGS, *flags, include(spec), f"-I{HERE}/unit", source, *also, library, "-o", out)
    return out


def units(out: Path, compiler: str, *flags: str, library: Path | None = None, link: Sequence[str | Path] = ()) -> Path:
    """Builds one program that runs all unit programs. `link`: what else it is linked with."""
    prototypes = "".join(f"int unit_{name}(void);\n" for name in UNITS)
    calls = " || ".join(f"unit_{name}() != 0" for name in UNITS)
    out.with_suffix(".c").write_text(f"{prototypes}int main(void) {{\n    return {calls};\n}}\n")
    for name in UNITS:
        source, made = HERE / f"unit/{name}.c", out.with_suffix(f".{name}.o")
        run(need(compiler), *WARNINGS, *flags, include("invented"), f"-Dmain=unit_{name}", "-c", source, "-o", made)
    return linked(out, compiler, *flags, *link, library or archive("invented", compiler, *flags))


def linked(out: Path, compiler: str, *flags: str | Path) -> Path:
    """Links the program of `units` once more, with another library or parser."""
    run(need(compiler), out.with_suffix(".c"), *(out.with_suffix(f".{name}.o") for name in UNITS), *flags, "-o", out)
    return out
