"""C++17: what it does, what compiles and what must not, and how large it is beside C."""

from __future__ import annotations

import re
import struct
import subprocess
from pathlib import Path

import pytest
from c_build import SANITIZE, SANITIZED, WARNINGS, archive, compiled, folder, headers, include, run
from mipgen.lower import codec
from support import ROOT, SPECS, heavy, model, need, packaging, small, uses

HERE = Path(__file__).parent
EXAMPLES = folder("real") / "examples"
pytestmark = uses("g++")
BARE = ["-fno-exceptions", "-fno-rtti"]
both = pytest.mark.parametrize("spec", sorted(SPECS))
compilers = pytest.mark.parametrize(
    ("compiler", "standard"),
    [
        ("g++", "-std=c++17"),
        pytest.param("g++", "-std=c++20", marks=heavy("g++")),
        pytest.param("clang++", "-std=c++17", marks=heavy("clang")),
        pytest.param("clang++", "-std=c++20", marks=heavy("clang")),
        pytest.param("x86_64-w64-mingw32-g++", "-std=c++17", marks=heavy("mingw")),
    ],
)


def checked(source: Path, compiler: str, *flags: str, spec: str = "real") -> subprocess.CompletedProcess[str]:
    """Checks a program without building it."""
    command = [need(compiler), *WARNINGS, *flags, include(spec), "-fsyntax-only", str(source)]
    return subprocess.run(command, capture_output=True, text=True)


def built(tmp: Path, source: Path, *flags: str) -> Path:
    library = archive("real", "cc", *SANITIZED)
    return compiled(tmp / source.stem, "real", "g++", source, "-std=c++17", *SANITIZE, *flags, library=library)


# --------------------------------------------------------------------------- what compiles


@compilers
@small("all headers of C++")
def test_all_headers_compile(spec: str, compiler: str, standard: str, tmp_path: Path) -> None:
    program = tmp_path / "all.cpp"
    span = "#ifdef __cpp_lib_span\nstd::span<const std::uint8_t> same(mip::bytes of) { return of; }\n#endif\n"
    program.write_text(f'#include "mip/cpp/mip.hpp"\n{span}')
    assert (done := checked(program, compiler, standard, *BARE, spec=spec)).returncode == 0, done.stderr


@heavy("each header alone")
@both
def test_each_header_compiles_alone(spec: str, tmp_path: Path) -> None:
    names = headers(folder(spec), ".hpp")
    assert len(names) > 5
    for name in names:
        program = tmp_path / f"{Path(name).stem}.cpp"
        program.write_text(f'#include "{name}"\n')
        flags = [] if name.endswith("ostream.hpp") else BARE
        assert (done := checked(program, "g++", "-std=c++17", *flags, spec=spec)).returncode == 0, done.stderr


MISUSE = {
    "auto one = mip::mip_3dm::write_pps_source_control{mip::ack_code::ok};": "cannot convert",  # of another enumeration
    "auto two = mip::gnss_data::dop_flags{} | mip::gnss_data::sv_flags{};": "no match",  # flags of another bitfield
    "void three(mip::builder &b) { b.add(mip::base::ping{}); }": "nodiscard",  # a field that is not looked at
    "void four(mip::device<> &d) { d.call(mip::base::ping{}); }": "nodiscard",  # an outcome that is not looked at
    "void five(mip::device<> &d, double a, double b, double c) {"
    " d.on<mip::acknowledge>([=](const auto &) { (void)(a + b + c); }); }": "captures too much",
    "void six(mip::device<> &d) { d.on<mip::acknowledge>([](int) {}); }": "a handler takes the value",
    "auto seven = mip::traits<mip::gnss_data::fix_info>::key;": "not a member",  # it occurs in several sets
    "void eight(mip::device<> &d, void f(const mip::packet &, bool)) { d.observe(*f); }": "an observer is an object",
}


def test_what_must_not_compile(tmp_path: Path) -> None:
    program = tmp_path / "misuse.cpp"
    program.write_text('#include "mip/cpp/mip.hpp"\n' + "\n".join(MISUSE))
    done = checked(program, "g++", "-std=c++17")
    assert done.returncode != 0
    for line, (code, message) in enumerate(MISUSE.items(), 2):
        assert f"misuse.cpp:{line}:" in done.stderr and message in done.stderr, f"{code}\n{done.stderr}"
    assert len(re.findall(r"misuse.cpp:\d+:.*nodiscard", done.stderr)) == 2
    program.write_text('#include "mip/cpp/mip.hpp"\n')
    assert "needs C++17" in checked(program, "g++", "-std=c++14").stderr


def test_readme_shows_programs_that_compile(tmp_path: Path) -> None:
    section = (folder("real") / "docs/cpp.md").read_text("utf-8")
    blocks = re.findall(r"```cpp\n(.*?)```", section, re.S)
    assert len(blocks) == 4
    program = tmp_path / "blocks.cpp"
    includes = "".join(line + "\n" for block in blocks for line in re.findall("^#include.*", block, re.M))
    outside = (
        "static void show(const float *) {}\nstatic void report(std::string_view, std::string_view) {}\n"
        "static void report(unsigned, unsigned) {}\nstatic std::uint32_t milliseconds() { return 0; }\n"
        "static void transmit(mip::bytes) {}\nstatic std::size_t receive(std::uint8_t *, std::size_t) { return 0; }\n"
    )
    outside += (
        "struct Port {\n  std::optional<std::size_t> read(mip::span<std::uint8_t>) { return 0; }\n"
        "  bool write(mip::bytes) { return true; }\n  std::uint32_t now() { return 0; }\n};\n"
    )
    used = "int main() {\n  Port port;\n  mip::device<> d(port);\n  mip::builder b(1);\n  mip::client c;\n"
    used += "  return run(port) && ask(b) && move_frame(d, 1, 2) && set_pps_source(c, {});\n}\n"
    bodies = "".join(re.sub("^#include.*\n", "", block, flags=re.M) for block in blocks)
    program.write_text(f"{includes}{outside}{bodies}{used}")
    assert (done := checked(program, "g++", "-std=c++17", *BARE)).returncode == 0, done.stderr


# --------------------------------------------------------------------------- what it does


@pytest.mark.parametrize(
    ("compiler", "standard"), [("g++", "-std=c++17"), pytest.param("clang++", "-std=c++20", marks=heavy("clang"))]
)
def test_unit(compiler: str, standard: str, tmp_path: Path) -> None:
    """Under the sanitizers."""
    library = archive("real", "cc" if compiler == "g++" else "clang", *SANITIZED)
    flags = [standard, *SANITIZE, *BARE]
    run(compiled(tmp_path / "use", "real", compiler, HERE / "unit/use.cpp", *flags, library=library))


THROWS = """#include "mip/cpp/mip.hpp"
#include <algorithm>
#include <cstdlib>
#include <exception>
struct Port {
    bool lost;
    std::optional<std::size_t> read(mip::span<std::uint8_t> room) {
        const std::uint8_t reply[] = {0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A};
        return lost ? throw 1 : std::copy(std::begin(reply), std::end(reply), room.begin()) - room.begin();
    }
    bool write(mip::bytes) { return true; }
    std::uint32_t now() { return 0; }
};
int main(int argc, char **) {
    std::set_terminate([] { std::_Exit(0); });
    Port port{argc == 1};
    mip::device device(port);
    const auto observer = [](const mip::packet &, bool) { throw 1; };
    if (argc == 2) {
        device.on<mip::acknowledge>([](const auto &) { throw 1; });
    } else if (argc == 3) {
        device.on_other([](const mip::field &) { throw 1; });
    } else {
        device.observe(observer);
    }
    try {
        device.poll();
    } catch (int) {
    }
    return 1;
}
"""


def test_an_exception_from_a_port_or_a_handler_ends_the_program(tmp_path: Path) -> None:
    """It must not pass through the C library, which would leave the device in the middle of a packet."""
    source = tmp_path / "throws.cpp"
    source.write_text(THROWS)
    program = built(tmp_path, source)
    for arguments in ([], ["on"], ["on", "other"], ["observe"] * 3):
        run(program, *arguments)


def test_examples_are_in_the_style_of_the_folder() -> None:
    style = f"--style=file:{folder('real') / '.clang-format'}"
    paths = sorted(EXAMPLES.glob("*.cpp"))
    assert [p.name for p in paths] == ["log.cpp"]
    run(need("clang-format"), style, "--dry-run", "-Werror", *paths)
    texts = [p.read_text("utf-8") for p in (ROOT / "examples").glob("*.cpp")]
    assert all("#include <string>" in text for text in texts if "std::string(" in text)


@pytest.mark.parametrize("source", ["log.cpp", "log.c"])
def test_the_log_reader_reads_a_log(source: str, tmp_path: Path) -> None:
    of, log = model("real"), tmp_path / "log.bin"
    fields = {name: of.field(f"filter_data.{name}") for name in ("timestamp", "llh_position")}
    data = {
        "timestamp": struct.pack(">dHH", 345678.123, 2000, 1),
        "llh_position": struct.pack(">dddH", 48.137154372, 11.575382, 500.0, 1),
    }
    parts = [(f.descriptor, data[name]) for name, f in fields.items() if f]
    packet = codec.build(of, 0x82, parts)
    log.write_bytes(b"$GPGGA\r\n" + packet + b"ue" + packet)
    if source == "log.c":
        program = compiled(tmp_path / "log", "real", "cc", EXAMPLES / source, *SANITIZED)
        flags, heading = "", "time,latitude,longitude\n"
    else:
        program = built(tmp_path, EXAMPLES / source)
        flags, heading = ",valid", "time,latitude,longitude,flags\n"
    line = f"345678.123,48.137154372,11.575382000{flags}\n"
    done = subprocess.run([program, log], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, f"{heading}{line}{line}"), done.stderr
    summary = "2 x filter_data.llh_position\n2 x filter_data.timestamp\n10 bytes are not part of a packet\n"
    assert summary in done.stderr
    assert subprocess.run([program], capture_output=True).returncode == 2


@packaging
def test_cmake(tmp_path: Path) -> None:
    project, prefix = tmp_path / "project", tmp_path / "prefix"
    project.mkdir()
    fast = ("-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={need('ninja')}", "-DCMAKE_C_FLAGS=-O0")
    run(need("cmake"), "-S", folder("real"), "-B", tmp_path / "mip", f"-DCMAKE_INSTALL_PREFIX={prefix}", *fast)
    run(need("cmake"), "--build", tmp_path / "mip", "--target", "install")
    (project / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.14)\nproject(user LANGUAGES C CXX)\nadd_executable(main main.cpp)\n"
        "find_package(mip REQUIRED)\ntarget_link_libraries(main mip::mip_cpp)\n"
    )
    (project / "main.cpp").write_text(
        '#include "mip/cpp/mip.hpp"\nint main() { return mip::field(mip_field{}).is<mip::acknowledge>(); }\n'
    )
    run(need("cmake"), "-S", project, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}", *fast)
    run(need("cmake"), "--build", tmp_path / "build", "--target", "main")
    run(tmp_path / "build/main")


# --------------------------------------------------------------------------- what it costs

#: Functions of the board and of the C library, so that a program links without either.
OUTSIDE = ("memchr", "memcmp", "memcpy", "memmove", "memset", "strlen", "uart", "use")
#: Bytes of firmware.cpp on a Cortex-M4; the same in C takes about a hundred less.
FIRMWARE_BYTES = 2900
#: Bytes of parser and dispatch of three fields on a Cortex-M4.
DISPATCH = """#include "mip/cpp/filter_data.hpp"
#include "mip/cpp/sensor.hpp"
extern "C" {
void use(const void *);
std::size_t uart(std::uint8_t *, std::size_t);
void start() {
    static mip::parser parser;
    std::uint8_t bytes[64];
    for (;;) {
        for (const mip::packet &packet : parser.feed({bytes, uart(bytes, sizeof(bytes))})) {
            mip::dispatch(packet, [](const mip::sensor::scaled_accel &accel) { use(&accel); },
                          [](const mip::sensor::scaled_gyro &gyro) { use(&gyro); },
                          [](const mip::filter_data::attitude_quaternion &q) { use(&q); });
        }
    }
}
}
"""
DISPATCH_BYTES = 720


@heavy("arm-none-eabi-g++")
def test_firmware_is_small(tmp_path: Path) -> None:
    flags = ["-mcpu=cortex-m4", "-mthumb", "-Os", "-ffunction-sections", "-fdata-sections"]
    library = archive("real", "arm-none-eabi-gcc", "-std=c99", *flags)
    link = ["-nostdlib", "-lgcc", "-Wl,--gc-sections", "-Wl,-e,start", *(f"-Wl,--defsym={n}=0" for n in OUTSIDE)]
    dispatch = tmp_path / "dispatch.cpp"
    dispatch.write_text(DISPATCH)
    for source, most in ((HERE / "cost/firmware.cpp", FIRMWARE_BYTES), (dispatch, DISPATCH_BYTES)):
        how = ["-std=c++17", *BARE, "-fno-threadsafe-statics", include("real"), source, library]
        run(need("arm-none-eabi-g++"), *WARNINGS, *flags, *how, *link, "-o", tmp_path / "elf")
        code, data = run(need("arm-none-eabi-size"), tmp_path / "elf").splitlines()[1].split()[:2]
        assert int(code) + int(data) <= most, source


def test_the_driver_is_built_from_every_layout() -> None:
    """So that none is left out of the conformance suite."""
    paths = (folder("real") / "src/mip").rglob("*.hpp")
    listed = re.findall(r"^MIP_LAYOUT\((\w+),", "".join(p.read_text("utf-8") for p in paths), re.M)
    assert len(listed) == len(set(listed)) == len(model("real").fields) + 1
    assert (ROOT / "tests/cpp/build_driver.sh").is_file()
