"""The C library on machines that are unlike most: it is compiled for them and runs in emulators.

`make test-cross` runs this, and only this; .ci/run installs the compilers and emulators.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import c_build
import pytest
from conformance import scenarios
from random_values import drawn
from support import (
    BUILD,
    ROOT,
    SPECS,
    Driver,
    all_fields,
    decode_request,
    differences,
    encode_request,
    expected,
    locked,
    model,
    need,
    set_of,
)  # fmt: skip

C = ROOT / "tests/c"
sys.path.append(str(ROOT / "tests/fuzz"))
import fuzz  # noqa: E402

HERE = Path(__file__).parent

pytestmark = pytest.mark.cross
both = pytest.mark.parametrize("spec", sorted(SPECS))


@dataclass(frozen=True)
class Machine:
    """A machine with an operating system, as far as qemu-user is one."""

    compiler: str
    emulator: str
    bits: int
    big_endian: bool = False
    strict: bool = False  # it traps unaligned access
    signed_char: bool = True


MACHINES = {
    "i686": Machine("i686-linux-gnu-gcc", "qemu-i386", 32),
    "arm": Machine("arm-linux-gnueabihf-gcc", "qemu-arm", 32, signed_char=False),
    "aarch64": Machine("aarch64-linux-gnu-gcc", "qemu-aarch64", 64, signed_char=False),
    "powerpc": Machine("powerpc-linux-gnu-gcc", "qemu-ppc", 32, big_endian=True, signed_char=False),
    "mips": Machine("mips-linux-gnu-gcc", "qemu-mips", 32, big_endian=True, strict=True),
    "sparc64": Machine("sparc64-linux-gnu-gcc", "qemu-sparc64", 64, big_endian=True, strict=True),
}
machines = pytest.mark.parametrize("name", MACHINES)

#: Undefined behaviour ends the program, without the sanitizer's library, which other machines do not have.
TRAP = ("-fsanitize=undefined", "-fsanitize-undefined-trap-on-error")
BUILDS = {"speed": ("-O3",), "size": ("-Os", "-fshort-enums"), "sanitized": ("-O1", *TRAP)}


def emulated(name: str, *command: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([need(MACHINES[name].emulator), *map(str, command)], capture_output=True, text=True)


# --------------------------------------------------------------------------- machines with an operating system


@machines
def test_the_machine_is_what_it_should_be(name: str, tmp_path: Path) -> None:
    machine = MACHINES[name]
    macros = subprocess.run(
        [need(machine.compiler), "-dM", "-E", "-x", "c", os.devnull],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    value = dict(re.findall(r"^#define (\w+) (.*)$", macros, re.M))
    assert value["__SIZEOF_POINTER__"] == str(machine.bits // 8)
    assert (value["__BYTE_ORDER__"] == "__ORDER_BIG_ENDIAN__") == machine.big_endian
    assert ("__CHAR_UNSIGNED__" not in value) == machine.signed_char
    program = tmp_path / "unaligned"
    c_build.run(need(machine.compiler), "-static", HERE / "unaligned.c", "-o", program)
    assert emulated(name, program).returncode in ((-signal.SIGBUS, 128 + signal.SIGBUS) if machine.strict else (0,))


@machines
@pytest.mark.parametrize("kind", BUILDS)
def test_units(kind: str, name: str, tmp_path: Path) -> None:
    machine = MACHINES[name]
    flags = ("-std=c99", "-static", *BUILDS[kind])
    done = emulated(name, c_build.units(tmp_path / "units", machine.compiler, *flags))
    assert done.returncode == 0, f"{done.returncode} {done.stdout}{done.stderr}"


@machines
@pytest.mark.parametrize("target", fuzz.C)
def test_fuzz_targets(target: str, name: str, tmp_path: Path) -> None:
    _, source, spec = fuzz.TARGETS[target]
    machine = MACHINES[name]
    flags = ("-std=c99", "-static", "-O2")
    program = c_build.compiled(tmp_path / "replay", spec, machine.compiler, C / f"fuzz/{source}.c", *flags,
                               also=[C / "fuzz/replay.c"])  # fmt: skip
    inputs = tmp_path / "inputs"
    inputs.write_text("".join(f"{data.hex()}\n" for data in [*fuzz.begin(target), *fuzz.known(target)] if data))
    done = emulated(name, program, inputs, "3000")
    assert done.returncode == 0 and "3000 that were made" in done.stdout, done.stderr[-3000:]


@cache
def requests(spec: str) -> list[dict[str, Any]]:
    """All printed packets, values of every field both ways, streams in pieces, and conversations of a client."""
    of = model(spec)
    packets = [e.packet.hex() for e in of.examples]
    encode = [encode_request(set_of(f, of), f, values) for f in all_fields(of) for values in drawn(f, 3)]
    packets += [answer["packet"] for r in encode if "packet" in (answer := expected(of, r))]
    stream = scenarios.LONG.hex().join([*packets[:60], scenarios.NMEA.hex()])
    return [
        *(decode_request(bytes.fromhex(p)) for p in packets),
        *encode,
        *({"op": "parse", "stream": stream, "chunk": chunk} for chunk in (1, 7, 64, 10_000)),
        *({"op": "client", "steps": steps} for _, steps, _ in scenarios.scenarios(of)),
    ]


@both
@machines
def test_the_conformance_driver(name: str, spec: str) -> None:
    """It gives the answers of the reference."""
    machine, build = MACHINES[name], BUILD / f"cross/{name}-{spec}"
    environment = {**os.environ, "CC": need(machine.compiler), "CFLAGS": "-static"}
    with locked(build):
        done = subprocess.run(
            [str(C / "build_driver.sh"), str(SPECS[spec][1] / "c"), str(build)],
            capture_output=True, text=True, env=environment,
        )  # fmt: skip
    assert done.returncode == 0, done.stderr[-3000:]
    *driver, program = done.stdout.splitlines()[-1].split()
    asked = requests(spec)
    answers = Driver(name, [*driver, need(machine.emulator), program], {}).ask(asked)
    wrong = differences(asked, [expected(model(spec), r) for r in asked], answers)
    assert not wrong, wrong
    assert len(asked) > 100


# --------------------------------------------------------------------------- machines without one


@pytest.mark.parametrize("level", ["-Os", "-O2"])
def test_cortex_m4(level: str, tmp_path: Path) -> None:
    """The unit programs, on an emulated board."""
    flags = ["-std=c99", "-mthumb", "-mcpu=cortex-m4", level, "--specs=rdimon.specs"]
    link = [HERE / "cortex_m.c", "-Wl,--section-start=.vectors=0"]
    program = c_build.units(tmp_path / "units", "arm-none-eabi-gcc", *flags, link=link)
    board = [need("qemu-system-arm"), "-M", "mps2-an386", "-nographic", "-monitor", "none", "-semihosting"]
    done = subprocess.run([*board, "-kernel", str(program)], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, f"{done.returncode} {done.stdout}{done.stderr}"


@both
@pytest.mark.parametrize("cpu", ["cortex-m0", "cortex-m33"])
def test_other_cores_compile(cpu: str, spec: str) -> None:
    c_build.archive(spec, "arm-none-eabi-gcc", "-std=c99", "-mthumb", f"-mcpu={cpu}", "-Os", "-ffreestanding")


AVR = ["-mmcu=atmega1284p", "-Os"]


@both
def test_avr_compiles(spec: str) -> None:
    """`int` of 16 bits, `double` of four bytes, and no alignment."""
    c_build.archive(spec, "avr-gcc", "-std=c99", *AVR)


# The tables do not fit, and doubles.c compares with doubles of eight bytes.
AVR_PROGRAMS = [*(C / f"unit/{name}.c" for name in ("packets", "fields", "client", "checksum")), HERE / "narrow.c"]


@pytest.mark.parametrize("source", AVR_PROGRAMS, ids=lambda path: path.stem)
def test_avr_runs(source: Path, tmp_path: Path) -> None:
    library = c_build.archive("invented", "avr-gcc", "-std=c99", *AVR)
    part, program = tmp_path / "unit.o", tmp_path / "unit.elf"
    flags = [*AVR, "-std=gnu99", c_build.include("invented"), f"-I{C}/unit"]
    c_build.run(need("avr-gcc"), *flags, "-c", "-include", HERE / "avr.h", source, "-o", part)
    c_build.run(need("avr-gcc"), *flags, HERE / "avr.c", part, library, "-o", program)
    done = subprocess.run(
        [need("simavr"), "-m", "atmega1284p", str(program)], capture_output=True, text=True, timeout=300
    )
    assert re.search(r"exit 0\b", done.stdout + done.stderr), done.stdout + done.stderr
