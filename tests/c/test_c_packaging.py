"""The C library in build systems and package managers, with the lines that its README shows.

Where the real tool is too large, tests/c/packages stands in for what the library sees of it: ESP-IDF and Zephyr.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import tarfile
from pathlib import Path

import pytest
import yaml
from c_build import HERE, folder, headers, pages, run, sources
from support import ROOT, SPECS, model, need, packaging

pytestmark = packaging

PACKAGES = HERE / "packages"
ARDUINO = folder("real") / "examples/arduino/arduino.ino"
VERSION = re.search(r"^version: (\S+)", (ROOT / "spec/protocol.yaml").read_text("utf-8"), re.M)[1]  # type: ignore[index]
README = pages("real")


def shown(section: str, language: str) -> list[str]:
    """The blocks of a section of the README."""
    text = re.split(r"\n##+ ", README.partition(f"# {section}\n")[2])[0]
    found = re.findall(rf"```{language}\n(.*?)```", text, re.S)
    assert found, (section, language)
    return found


def quickstart(program: Path, **environment: str) -> None:
    assert run(program, **environment) == "8 bytes to send\n0.2445 g along x\n"


def installed(prefix: Path) -> list[str]:
    return sorted(str(p.relative_to(prefix)) for p in prefix.rglob("*") if not p.is_dir())


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A user's project: a program, and the library in the folder mip."""
    where = tmp_path / "project"
    shutil.copytree(folder("real"), where / "mip")
    shutil.copy(folder("real") / "quickstart.c", where / "main.c")
    return where


def cmake(source: Path, build: Path, *options: str) -> None:
    """Configures and builds. Not optimized, as that takes longer."""
    fast = ("-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={need('ninja')}", "-DCMAKE_C_FLAGS=-O0")
    run(need("cmake"), "-S", source, "-B", build, *fast, *options)
    run(need("cmake"), "--build", build)


def user(where: Path, lines: str) -> Path:
    """A program that is built by CMake with these lines."""
    start = "cmake_minimum_required(VERSION 3.14)\nproject(user LANGUAGES C)\nadd_executable(main main.c)\n"
    (where / "CMakeLists.txt").write_text(f"{start}{lines}\ninstall(TARGETS main DESTINATION bin)\n")
    return where


def add_unmarked(library: Path) -> None:
    """A function that MIP_API does not mark; there may be none."""
    with (library / "src/mip/core/core.c").open("a") as file:
        file.write("\nint mip_unmarked(void);\nint mip_unmarked(void) { return 0; }\n")


def exported(library: Path) -> set[str]:
    lines = run(need("nm"), "--dynamic", "--defined-only", library).splitlines()
    return {name for line in lines if (name := line.split()[-1]).startswith("mip_")}


def marked(where: Path) -> set[str]:
    """The functions and tables that headers mark with MIP_API, in macros too."""
    program = where / "headers.c"
    program.write_text("".join(f'#include "{header}"\n' for header in headers(folder("real"))))
    windows = ("-D_WIN32", "-DMIP_SHARED")  # for a MIP_API that the preprocessor leaves recognizable
    text = run(need("cc"), "-E", "-P", f"-I{folder('real')}/src", *windows, program)
    return set(re.findall(r"__declspec\(dllimport\)[^;({]*?\b(mip_\w+)\s*[(\[;]", text))


# --------------------------------------------------------------------------- the folder


def test_folder_alone_builds(project: Path) -> None:
    for name in ("README.md", "LICENSE", "CMakeLists.txt"):
        assert (project / "mip" / name).is_file()
    (line,) = shown("Add it to your project", "sh")
    run("sh", "-c", f"cd {project} && {line}")
    quickstart(project / "main")


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_the_list_names_every_source(spec: str) -> None:
    wanted = [Path(source).relative_to(folder(spec)).as_posix() for source in sources(spec)]
    text = (folder(spec) / "cmake/sources.cmake").read_text("utf-8")
    assert re.findall(r"^  \${MIP_FOLDER}/(src/\S+\.c)$", text, re.M) == wanted


# --------------------------------------------------------------------------- CMake


@pytest.mark.parametrize("how", ["subdirectory", "fetched"])
def test_cmake_part_of_a_project(how: str, project: Path, tmp_path: Path) -> None:
    """It installs nothing into the prefix of the project, unless the project wants it to."""
    subdirectory, fetched, _ = shown("CMake", "cmake")
    if how == "fetched":
        archive = tmp_path / "mip.tar.gz"
        with tarfile.open(archive, "w:gz") as file:
            file.add(project / "mip", "mip-0")
        shutil.rmtree(project / "mip")
        address = f"${{CMAKE_CURRENT_SOURCE_DIR}}/mip-c-{VERSION}.zip"
        assert address in fetched
        fetched = fetched.replace(address, archive.as_uri())
    build, prefix = tmp_path / "build", tmp_path / "prefix"
    lines = fetched if how == "fetched" else subdirectory
    other = "add_library(mip INTERFACE)\n"  # what the vendor's SDK calls its target
    cmake(user(project, other + lines), build, f"-DCMAKE_INSTALL_PREFIX={prefix}")
    quickstart(build / "main")
    assert "-isystem" in (build / "build.ninja").read_text("utf-8")
    run(need("cmake"), "--install", build)
    assert installed(prefix) == ["bin/main"]
    if how == "subdirectory":
        cmake(project, build, "-DMIP_INSTALL=ON", "-DCMAKE_INSTALL_LIBDIR=lib")
        run(need("cmake"), "--install", build)
        assert {"bin/main", "lib/libmip.a", "include/mip/core.h", "lib/pkgconfig/mip.pc"} <= {*installed(prefix)}


@pytest.mark.parametrize("kind", ["static", "shared"])
def test_cmake_installed(kind: str, project: Path, tmp_path: Path) -> None:
    """Found by CMake and by pkg-config after the whole prefix has moved, to a folder with a blank in its name."""
    commands = shown("CMake", "sh")[0].splitlines()
    assert commands == [
        "cmake -S mip -B build -DCMAKE_INSTALL_PREFIX=/usr/local", "cmake --build build", "cmake --install build",
    ]  # fmt: skip
    build, prefix, moved = project / "build", tmp_path / "prefix", tmp_path / "moved away"
    add_unmarked(project / "mip")
    options = ["-DCMAKE_INSTALL_LIBDIR=lib", *(["-DBUILD_SHARED_LIBS=ON"] if kind == "shared" else [])]
    cmake(project / "mip", build, f"-DCMAKE_INSTALL_PREFIX={prefix}", *options)
    run(need("cmake"), "--install", build)
    for gone in (build, project / "mip"):
        shutil.rmtree(gone)
    prefix.rename(moved)
    library = moved / "lib"
    series = VERSION.rpartition(".")[0]
    names = {"static": {"libmip.a"}, "shared": {"libmip.so", f"libmip.so.{series}", f"libmip.so.{VERSION}"}}
    assert {p.name for p in library.glob("libmip*")} == names[kind] | {"libmip_ports.a"}
    if kind == "shared":
        assert exported(library / "libmip.so") == marked(tmp_path) > {"mip_parser_next"}

    cmake(user(project, shown("CMake", "cmake")[2]), tmp_path / "user", f"-DCMAKE_PREFIX_PATH={moved}")
    quickstart(tmp_path / "user/main")

    package = {"PKG_CONFIG_PATH": f"{library}/pkgconfig"}
    assert run(need("pkg-config"), "--modversion", "mip", **package).strip() == VERSION
    flags = run(need("pkg-config"), "--cflags", "mip", **package)
    assert ("-DMIP_SHARED" in flags) == (kind == "shared")
    line = shown("CMake", "sh")[1].strip()
    path = f"{Path(need('pkg-config')).parent}{os.pathsep}{os.environ['PATH']}"  # where only pkgconf of PyPI has one
    run("sh", "-c", f'cd {project} && eval "{line}"', PATH=path, **package)  # eval: for the blank
    quickstart(project / "main", LD_LIBRARY_PATH=str(library))


def test_a_library_for_windows(project: Path, tmp_path: Path) -> None:
    """A DLL and a program that imports from it."""
    compiler, build = need("x86_64-w64-mingw32-gcc"), tmp_path / "build"
    machine = ("-DCMAKE_SYSTEM_NAME=Windows", f"-DCMAKE_C_COMPILER={compiler}", "-DCMAKE_RC_COMPILER=false")
    cmake(user(project, shown("CMake", "cmake")[0]), build, *machine, "-DBUILD_SHARED_LIBS=ON")
    dump = need("x86_64-w64-mingw32-objdump")
    table = run(dump, "-p", build / "mip/libmip.dll").partition("[Ordinal/Name Pointer] Table")[2]
    assert set(re.findall(r"\b(mip_\w+)", table)) == marked(tmp_path) > {"mip_parser_next"}
    assert "DLL Name: libmip.dll" in run(dump, "-p", build / "main.exe")
    unresolved = run(need("x86_64-w64-mingw32-nm"), *build.glob("CMakeFiles/main.dir/*.obj"))
    assert "U __imp_mip_parser_next" in unresolved  # imported directly


# --------------------------------------------------------------------------- manifests


def test_manifests_have_the_home_page() -> None:
    address = model("invented").protocol.repository
    assert address and not model("real").protocol.repository
    for name in ("library.json", "library.properties", "idf_component.yml"):
        assert address in (folder("invented") / name).read_text("utf-8")
        assert not re.search(r"homepage|\burl\b(?!=$)", (folder("real") / name).read_text("utf-8"), re.M)


# --------------------------------------------------------------------------- boards


def test_platformio(project: Path) -> None:
    """What the manifest must have, and a build as PlatformIO does it: all of src, with src as the include path."""
    library = project / "lib/mip"
    library.parent.mkdir()
    (project / "mip").rename(library)
    manifest = json.loads((library / "library.json").read_text("utf-8"))
    assert re.fullmatch(r"[a-z0-9-]{1,50}", manifest["name"]) and manifest["version"] == VERSION
    assert 0 < len(manifest["description"]) <= 255 and manifest["license"] == "MIT"
    assert manifest["frameworks"] == manifest["platforms"] == "*"
    assert all(re.fullmatch(r"[a-z0-9 -]{1,50}", word) for word in manifest["keywords"])
    main = project / "main.c"
    main.write_text(f'#include "{manifest["headers"]}"\n{main.read_text("utf-8")}')
    files = sorted((library / "src").rglob("*.c"))
    run(need("cc"), "-std=gnu11", f"-I{library}/src", main, *files, "-o", project / "program")
    quickstart(project / "program")


def test_arduino_manifest() -> None:
    lines = (folder("real") / "library.properties").read_text("utf-8").splitlines()
    properties = dict(line.split("=", 1) for line in lines)
    assert {"name", "author", "maintainer", "sentence", "paragraph"} <= {k for k, v in properties.items() if v}
    assert properties["version"] == VERSION and properties["architectures"] == "*"
    assert properties["category"] == "Communication"
    assert "url" in properties  # mandatory for the IDE 1.8, even if it is empty
    # The IDE looks for it here only, and not in folders below.
    assert (folder("real") / "src" / properties["includes"]).is_file()
    first = shown("PlatformIO and Arduino", "cpp")[0].splitlines()[0]
    assert first == f"#include <{properties['includes']}>"
    assert first == ARDUINO.read_text("utf-8").splitlines()[1]


def test_arduino(project: Path, tmp_path: Path) -> None:
    """A sketch for an Arduino Uno, by the builder of Arduino's IDE."""
    sketch = tmp_path / "sketch/sketch.ino"
    sketch.parent.mkdir()
    shutil.copy(ARDUINO, sketch)
    shared, build = Path("/usr/share"), tmp_path / "build"
    build.mkdir()
    done = run(
        need("arduino-builder"), "-compile", "-hardware", shared / "arduino/hardware",
        "-hardware", shared / "arduino-builder", "-tools", "/usr/bin", "-libraries", project,
        "-fqbn", "arduino:avr:uno", "-build-path", build, "-warnings", "all",
        # Debian's core needs this of C99, which its avr-gcc does not define in C++.
        "-prefs", "compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__",
        "-prefs", "compiler.c.extra_flags=-Werror", sketch,
    )  # fmt: skip
    assert re.search(r"Sketch uses \d+ bytes", done)
    assert (build / "sketch.ino.hex").is_file()
    assert {p.name.removesuffix(".o") for p in (build / "libraries/mip/mip").rglob("*.o")} == {
        Path(source).name for source in sources("real")
    }


def test_esp_idf(project: Path, tmp_path: Path) -> None:
    component = project / "components/mip"
    component.parent.mkdir()
    (project / "mip").rename(component)
    (project / "main").mkdir()
    (project / "main.c").rename(project / "main/main.c")
    (project / "main/CMakeLists.txt").write_text(shown("ESP-IDF", "cmake")[0])
    run(need("cmake"), f"-DCOMPONENT={component}", "-P", PACKAGES / "esp_idf/requirements.cmake")
    cmake(PACKAGES / "esp_idf", tmp_path / "build", f"-DPROJECT={project}")
    quickstart(tmp_path / "build/program")
    manifest = yaml.safe_load((component / "idf_component.yml").read_text("utf-8"))
    assert manifest["version"] == VERSION and manifest["license"] == "MIT" and manifest["description"]


def test_zephyr(project: Path, tmp_path: Path) -> None:
    module = yaml.safe_load((project / "mip/zephyr/module.yml").read_text("utf-8"))
    assert module == {"name": "mip", "build": {"cmake": "zephyr", "kconfig": "zephyr/Kconfig"}}
    (option,) = shown("Zephyr", "ini")
    assert option == "CONFIG_MIP=y\n"
    assert re.match(r"config MIP\n\tbool ", (project / "mip" / module["build"]["kconfig"]).read_text("utf-8"))
    (project / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.20)\n{shown('Zephyr', 'cmake')[0]}"
        "find_package(Zephyr REQUIRED)\nproject(user)\ntarget_sources(app PRIVATE main.c)\n"
    )
    (project / "prj.conf").write_text(option)
    cmake(project, tmp_path / "build", f"-DZephyr_DIR={PACKAGES}/zephyr")
    quickstart(tmp_path / "build/program")
    (project / "prj.conf").write_text("")  # without the option it is not even compiled
    (project / "main.c").write_text("int main(void) { return 0; }\n")
    cmake(project, tmp_path / "without", f"-DZephyr_DIR={PACKAGES}/zephyr")
    assert not [*(tmp_path / "without").rglob("libmip.a")] and [*(tmp_path / "build").rglob("libmip.a")]
