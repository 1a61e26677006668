"""C on microcontrollers, which QEMU emulates and whose instructions it counts: speed and size of the same objects.

With a folder of the vendor's SDK, beside it: the same streams, pieces, fields and compiler options.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

import streams
from bench_c import BUILD, HERE, OUTSIDE, ROOT, SOURCES, Row, library, run, table, version
from mipgen.resolve.load import load_model

SIZE = 100_000
ARM, RISCV = "arm-none-eabi", "riscv64-unknown-elf"


@dataclass(frozen=True, slots=True)
class Machine:
    title: str
    tools: str  # the prefix of its compiler
    flags: tuple[str, ...]
    link: tuple[str, ...]  # with the C library, which reads files from the host
    emulator: tuple[str, ...]


#: The emulated Cortex-M4 also runs the instructions of a Cortex-M0.
_ARM = ("--specs=rdimon.specs", f"{ROOT}/tests/cross/cortex_m.c", "-Wl,--section-start=.vectors=0")
_MPS2 = ("qemu-system-arm", "-M", "mps2-an386")
_VIRT = ("--oslib=semihost", "--crt0=semihost", "-Wl,--defsym=__flash=0x80000000",
         "-Wl,--defsym=__flash_size=4M", "-Wl,--defsym=__ram=0x80400000", "-Wl,--defsym=__ram_size=4M")  # fmt: skip
MACHINES = {
    "M4": Machine("Cortex-M4", ARM, ("-mcpu=cortex-m4", "-mthumb"), _ARM, _MPS2),
    "M0": Machine("Cortex-M0", ARM, ("-mcpu=cortex-m0", "-mthumb"), _ARM, _MPS2),
    "RV32": Machine("RV32IMAC", RISCV, ("-march=rv32imac", "-mabi=ilp32", "--specs=picolibc.specs"), _VIRT,
                    ("qemu-system-riscv32", "-M", "virt", "-bios", "none")),
}  # fmt: skip
SMALL, FAST, VENDOR = "small parser", "fast parser", "SDK"
#: Machine, level, library.
M4 = [("M4", "-Os", SMALL), ("M4", "-Os", VENDOR), ("M4", "-O2", SMALL), ("M4", "-O2", FAST), ("M4", "-O2", VENDOR)]
OTHERS = [(name, "-Os", which) for name in ("M0", "RV32") for which in (SMALL, VENDOR)]
OPTIONS = {SMALL: ("-std=c99", "-DMIP_PARSER_SMALL"), FAST: ("-std=c99", "-DMIP_PARSER_FAST"),
           VENDOR: ("-std=c11", "-w", "-DNDEBUG", "-DMICROSTRAIN_TIMESTAMP_TYPE=uint32_t")}  # fmt: skip
#: Title, stream, function of speed.c, that of peer/speed.c.
SPEEDS = (
    ("parse, in pieces of 64 bytes", "log", "ours_small", "peer_small"),
    ("parse, in pieces of 8 bytes", "log", "ours_eight", "peer_eight"),
    ("parse, byte by byte", "log", "ours_bytewise", "peer_bytewise"),
    ("skip NMEA sentences", "text", "ours_small", "peer_small"),
    ("skip random bytes", "noise", "ours_small", "peer_small"),
    ("parse packets among NMEA sentences", "mixed", "ours_small", "peer_small"),
    ("parse, decode three fields", "log", "ours_small_three", "peer_small_three"),
    ("the same, direct decoders", "log", "ours_small_direct", ""),
    ("the same, through `client.h`", "log", "ours_client", ""),
    ("the same, handlers of `device.h`", "log", "ours_device", "peer_device"),
)
#: Title, program in peer/ of ours, with its macros, that of theirs.
SIZES = (
    ("size: parser, walk and builder", "ours_core", "peer_core"),
    ("size: parser and three fields", "ours_fields", "peer_fields"),
    ("size: application, waiting for replies", "ours_app", "peer_app"),
    ("size: application, never waiting", "ours_app -DSTEP", ""),
)
#: Functions of the hardware, which neither library provides.
HARDWARE = ("rx", "rx_size", "tx", "port_read", "port_write", "port_now", "port_receive", "port_send", "receive")


def objects(machine: Machine, level: str, which: str, sdk: Path | None) -> list[str]:
    """Compiles a library as firmware does."""
    folder = BUILD / f"board-{machine.title}{level}-{which.replace(' ', '-')}"
    folder.mkdir(parents=True, exist_ok=True)
    sources, made = vendor_sources(sdk) if sdk and which == VENDOR else library(), []
    for source in sources:
        made.append(str(folder / f"{Path(source).stem}.o"))
        run(f"{machine.tools}-gcc", *compiled(machine, level, which, sdk), "-c", source, "-o", made[-1])
    return made


def compiled(machine: Machine, level: str, which: str, sdk: Path | None) -> list[str]:
    """The options of the compiler."""
    include = f"-I{sdk}/src/c" if which == VENDOR else f"-I{SOURCES}"
    return [*machine.flags, "-ffunction-sections", "-fdata-sections", *OPTIONS[which], level, include]


def vendor_sources(sdk: Path) -> list[str]:
    folders = ("mip", "mip/definitions", "microstrain")
    return [str(p) for folder in folders for p in sorted((sdk / "src/c" / folder).glob("*.c"))]


def size(machine: Machine, options: list[str], program: str, made: list[str]) -> str:
    """Bytes of code and constants of a program in peer/, without the C library."""
    elf, (source, *macros) = BUILD / "board.elf", program.split()
    hidden = [f"-Wl,--defsym={name}=0" for name in (*OUTSIDE, *HARDWARE, "printf")]
    run(f"{machine.tools}-gcc", *options, *macros, HERE / f"peer/{source}.c", *made, "-nostdlib", "-nostartfiles",
        "-lgcc", "-Wl,--gc-sections", "-Wl,-e,main", *hidden, "-o", elf)  # fmt: skip
    code, data = run(f"{machine.tools}-size", elf).splitlines()[1].split()[:2]
    return f"{int(code) + int(data)} B"


def instructions(machine: Machine, program: Path, stream: Path, function: str) -> str:
    """For each byte."""
    arguments = ",".join(["enable=on", *(f"arg={a}" for a in (program, stream, function, 1))])
    quiet = ("-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=0")
    found = run(*machine.emulator, *quiet, "-semihosting-config", arguments, "-kernel", program).split()
    return f"{float(found[0]) / stream.stat().st_size:.1f}"


def column(name: str, level: str, which: str, sdk: Path | None) -> list[str]:
    machine, program, theirs = MACHINES[name], BUILD / "board-speed.elf", which == VENDOR
    options, made = compiled(machine, level, which, sdk), objects(machine, level, which, sdk)
    source = HERE / ("peer/speed.c" if theirs else "speed.c")
    run(f"{machine.tools}-gcc", *options, "-std=gnu11", "-DBOARD", f"-I{HERE}", source, *made, *machine.link,
        "-o", program)  # fmt: skip
    values = []
    for _, stream, own, peer in SPEEDS:
        function = peer if theirs else own
        values.append(instructions(machine, program, BUILD / f"board-{stream}.bin", function) if function else "")
    for _, own, peer in SIZES:
        function = peer if theirs else own
        values.append(size(machine, options, function, made) if function else "")
    return values


def report(sdk: Path | None = None, vendor: str = "") -> str:
    """As Markdown; without the SDK, only ours."""
    if missing := [
        tool for m in MACHINES.values() for tool in (f"{m.tools}-gcc", m.emulator[0]) if not shutil.which(tool)
    ]:
        return f"\nFigures of microcontrollers need {' and '.join(dict.fromkeys(missing))}.\n"
    BUILD.mkdir(parents=True, exist_ok=True)
    packets, sentences = streams.log(load_model(ROOT / "spec"), SIZE), streams.text(SIZE)
    contents = {"log": packets, "text": sentences, "noise": streams.noise(SIZE)}
    contents["mixed"] = streams.mixed(packets, sentences)
    for name, content in contents.items():
        (BUILD / f"board-{name}.bin").write_bytes(content)
    out = f"\n{version(f'{ARM}-gcc')}, without the C library: instructions per byte, counted by QEMU, in pieces of 64 "
    out += "bytes unless\nstated, and the sizes of programs linked from the same objects.\n"
    for columns in (M4, OTHERS):
        shown = [c for c in columns if sdk or c[2] != VENDOR]
        heads = [
            f"{MACHINES[name].title}, `{level}`, {vendor if which == VENDOR else which}" for name, level, which in shown
        ]
        made = [column(*c, sdk) for c in shown]
        titles = [*(s[0] for s in SPEEDS), *(s[0] for s in SIZES)]
        rows: list[Row] = [[title, *values] for title, *values in zip(titles, *made, strict=True)]
        out += "\n" + table(["", *heads], rows)
    return out
