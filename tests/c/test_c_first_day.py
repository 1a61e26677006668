"""The first minutes with a device: mip/connect.h, the ports of a computer, and the README's first program."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import socket
import subprocess
import threading
from pathlib import Path

import pytest
from c_build import HERE, SANITIZED, WARNINGS, archive, compiled, folder, include, run
from mip_protocol import base, open_port
from mip_protocol.baud import rates
from mipgen.targets.c import calls
from support import PATIENCE, ROOT, heavy, model, need, simulated, uses

PORTS = folder("real") / "ports"
SOURCES = sorted(PORTS.glob("*.c"))
EXAMPLE = folder("real") / "examples/stream.c"
#: A line of the example.
LINE = re.compile(r" *\d+\.\d{3} s: +-?0\.0\d{3} +-?0\.0\d{3} +-(?:0\.9|1\.0)\d{3} g")


def built(tmp_path: Path, source: Path) -> Path:
    library = archive("real", "cc", *SANITIZED)
    flags = (*SANITIZED, f"-I{PORTS}")
    return compiled(tmp_path / source.stem, "real", "cc", source, *flags, also=SOURCES, library=library)


@pytest.fixture(scope="module")
def stream(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("stream"), EXAMPLE)


def ran(program: Path, *arguments: str) -> tuple[int, list[str], str]:
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=PATIENCE)
    return done.returncode, done.stdout.splitlines(), done.stderr


# --------------------------------------------------------------------------- connect and stream


def test_connect_and_stream_at_a_scripted_port(tmp_path: Path) -> None:
    run(compiled(tmp_path / "connect", "real", "cc", HERE / "unit/connect.c", *SANITIZED))


def test_the_rates_are_those_of_all_devices() -> None:
    """The same as in Python, in the same order."""
    session = calls.session_calls(model("real"))
    assert session is not None and tuple(rates()) == session.of.bauds


def test_a_part_without_these_commands_has_no_such_files() -> None:
    """The small specification has none of them."""
    assert calls.session_calls(model("invented")) is None
    assert not (folder("invented") / "src/mip/connect.h").exists()
    assert (folder("real") / "src/mip/connect.h").exists()


# --------------------------------------------------------------------------- ports


@pytest.mark.parametrize(
    "compiler",
    [
        "cc",
        pytest.param("g++", marks=heavy("g++")),
        pytest.param("clang", marks=heavy("clang")),
        pytest.param("x86_64-w64-mingw32-gcc", marks=heavy("gcc-mingw-w64-x86-64")),
    ],
)
def test_ports_compile(compiler: str, tmp_path: Path) -> None:
    """Every file compiles on every system: those of other systems are empty."""
    language = ["-std=c++11", "-x", "c++"] if compiler == "g++" else ["-std=c99"]
    for source in SOURCES:
        run(need(compiler), *language, *WARNINGS, include("real"), f"-I{PORTS}", "-c", source, "-o", tmp_path / "o")


@heavy("gcc-mingw-w64-x86-64")
def test_the_example_for_windows(tmp_path: Path) -> None:
    compiler = need("x86_64-w64-mingw32-gcc")
    library = archive("real", "x86_64-w64-mingw32-gcc", "-std=c99", "-O1")
    flags = ["-std=c99", *WARNINGS, "-D__USE_MINGW_ANSI_STDIO=1", include("real"), f"-I{PORTS}"]
    run(compiler, *flags, EXAMPLE, *SOURCES, library, "-lws2_32", "-o", tmp_path / "stream.exe")


def good(result: tuple[int, list[str], str], most: int = 1000, model: str = "3DM-CV7-GNSS/INS") -> None:
    code, (name, *lines), error = result
    assert (code, error) == (0, "") and name.startswith(model)
    assert 50 < len(lines) < most and all(LINE.fullmatch(line) for line in lines), lines[:3]


def test_serial(stream: Path, tmp_path: Path) -> None:
    """At a pseudo-terminal, until the device is gone."""
    path = f"{tmp_path}/terminal"
    assert ran(stream, path) == (1, [], f"{path}: No such file or directory\n")
    with simulated("--pty", path, "--duration", "2"):
        good(ran(stream, path), most=310)


def test_tcp(stream: Path) -> None:
    with simulated("--tcp", "0", "--duration", "2") as place:
        good(ran(stream, place), most=310)
    code, _, error = ran(stream, place)
    assert code == 1 and error == f"{place}: Connection refused\n"
    assert ran(stream, "no.such.host.invalid:1")[0] == 1
    assert ran(stream, "h" * 300 + ":1")[2].endswith(": the host name is too long\n")


@heavy("threads")
@pytest.mark.parametrize("system", ["freertos", "zephyr", "esp_idf", "stm32"])
def test_boards(system: str, tmp_path: Path) -> None:
    """The examples for boards, without a data race: tasks and interrupts are threads. `boards/` has what they call."""
    source = EXAMPLE.parent / f"{system}.c"
    flags = ("-std=gnu99", "-pthread", "-g1", "-fsanitize=thread", "-DMIP_HOOKS")
    for name in re.findall(r'#include ["<](?!mip/)([^">]*)', source.read_text("utf-8")):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(f'#include "boards/{system}.h"\n')
    also = [*SOURCES, *([] if system == "freertos" else [EXAMPLE.parent / "application.c"])]
    program = compiled(
        tmp_path / "program", "real", "cc", source, *flags, f"-I{PORTS}", f"-I{HERE}", f"-I{tmp_path}", also=also,
        library=archive("real", "cc", *flags),
    )  # fmt: skip
    with simulated("--tcp", "0") as place:
        done = subprocess.run([program], env={**os.environ, "MIP_PLACE": place}, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert all(abs(float(line) + 1) < 0.01 for line in done.stdout.split()) and len(done.stdout.split()) == 20


def test_a_device_with_the_older_commands(stream: Path) -> None:
    """It rejects the base rate and the format of any set, and has commands for each of its sets."""
    with simulated("--tcp", "0", "--duration", "2", device="3dm-gx5-15") as place:
        good(ran(stream, place), most=310, model="3DM-GX5-15")


@uses("g++")
def test_the_first_program_in_cpp(tmp_path: Path) -> None:
    """It starts a device of any generation, and reports what failed."""
    library = archive("real", "cc", "-std=c99", "-O1")
    first = ROOT / "examples/first.cpp"
    program = compiled(
        tmp_path / "first", "real", "g++", first, "-std=c++17", f"-I{PORTS}", also=SOURCES, library=library
    )
    for device in ("3dm-gx5-45", "3dm-cv7-gnss-ins"):
        with simulated("--tcp", "0", "--duration", "2", device=device) as place:
            code, (name, *lines), error = ran(program, place)
        assert (code, error) == (0, "") and name.startswith(device[:7].upper()) and len(lines) > 50
    with simulated("--tcp", "0", "--fault", "refuse@4") as place:
        code, _, error = ran(program, place)
    assert code == 1 and error.startswith("stream: refused, ")


def test_faults(stream: Path, tmp_path: Path) -> None:
    """Commands with lost replies are repeated, NACKs are reported, and noise costs nothing; see also unit/connect.c."""
    path = f"{tmp_path}/terminal"
    with simulated("--pty", path, "--duration", "2", "--fault", "lose_answer@2,nmea=0.2,noise=0.05"):
        good(ran(stream, path))
    with simulated("--pty", path, "--fault", "refuse@4"):
        code, _, error = ran(stream, path)
        assert code == 1 and error.startswith("stream: refused ") and error.endswith(" (0x0C,0x0E)\n")


def test_the_baud_rate_is_found(stream: Path, tmp_path: Path) -> None:
    path = f"{tmp_path}/terminal"
    with simulated("--port", f"UART 1=pty:{path}", "--strict-baud", "--duration", "8"):
        with open_port(path) as device:
            device.request(base.SetIdle())
            assert device.change_baud(base.CommSpeed.write(0x11, 460800)) == 460800
        good(ran(stream, path), most=1200)


def test_a_port_has_one_user(stream: Path) -> None:
    first, second = pty.openpty()
    try:
        fcntl.flock(second, fcntl.LOCK_EX)
        name = os.ttyname(second)
        assert ran(stream, name) == (1, [], f"{name}: the port is in use by another program\n")
    finally:
        os.close(first)
        os.close(second)


#: Cases that the example does not reach: a rate that the system does not have, an IPv6 address, a port that is gone.
LINES = """
#include "check.h"
#include "mip/line.h"
int main(int argc, char **argv) {
    struct mip_line line;
    uint8_t byte;
    size_t count = 0;
    CHECK(argc == 4 && !mip_line_open(&line, argv[1], 12345));
    CHECK(strcmp(line.error, "the port does not support this baud rate") == 0);
    mip_line_close(&line); /* that is not open */
    CHECK(mip_line_open(&line, argv[1], 115200) && line.error == NULL);
    CHECK(mip_line_set_baud(&line, 9600) && !mip_line_set_baud(&line, 12345));
    CHECK(line.port.write(line.port.user, (const uint8_t *)"x", 1));
    const uint32_t before = line.port.now(line.port.user);
    CHECK(line.port.read(line.port.user, &byte, 1, &count) && count == 0);
    CHECK(line.port.now(line.port.user) - before < 5000);
    mip_line_close(&line);
    mip_line_close(&line);
    CHECK(mip_line_open(&line, argv[2], 115200) && !mip_line_set_baud(&line, 9600));
    mip_line_close(&line);
    CHECK(mip_line_open(&line, argv[3], 115200)); /* it is closed at once by the other end */
    while (line.port.read(line.port.user, &byte, 1, &count)) {
    }
    CHECK(count == 0 && strcmp(line.error, "the connection was closed") == 0);
    /* A line that could not be opened again stays lost until it is. */
    line.name = "/nowhere";
    line.is_tcp = false;
    CHECK(!mip_line_reopen(&line, 0) && line.error != NULL);
    CHECK(!line.port.read(line.port.user, &byte, 1, &count) && count == 0);
    CHECK(!line.port.write(line.port.user, (const uint8_t *)"x", 1));
    line.name = argv[1];
    CHECK(mip_line_reopen(&line, 0) && line.port.read(line.port.user, &byte, 1, &count) && count == 0);
    mip_line_close(&line);
    return 0;
}
"""


def test_lines(tmp_path: Path) -> None:
    (tmp_path / "lines.c").write_text(LINES)
    program = built(tmp_path, tmp_path / "lines.c")
    first, second = pty.openpty()
    with (
        socket.create_server(("::1", 0), family=socket.AF_INET6) as six,
        socket.create_server(("127.0.0.1", 0)) as four,
    ):

        def hang_up() -> None:
            four.accept()[0].close()

        thread = threading.Thread(target=hang_up)
        thread.start()
        places = (f"[::1]:{six.getsockname()[1]}", f"localhost:{four.getsockname()[1]}")
        try:
            assert ran(program, os.ttyname(second), *places) == (0, [], "")
        finally:
            thread.join(PATIENCE)
            os.close(first)
            os.close(second)
