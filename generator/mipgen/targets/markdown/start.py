"""The page for new users: in each language, the installation and a complete first program. Also the complete programs
to which the code on the pages of fields belongs."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m

from .snippets import LANGUAGES, Language, Program


@dataclass(frozen=True, slots=True)
class Start:
    """The steps in one language, in an empty folder beside a checkout, `../mipgen`."""

    title: str
    name: str  # of the anchor, and of the fenced block
    program: str  # in `examples/`
    file: str
    install: str
    run: str
    needs: str

    def text(self, model: m.Model) -> str:
        """Returns the program without the comment about the location of its file."""
        lines = model.program(self.program).splitlines()
        begins = next(i for i, line in enumerate(lines) if line.startswith(("#include", "import ", "use ")))
        return "\n".join(lines[begins:])


STARTS = (
    Start(
        "Python", "python", "first.py", "first.py",
        "python3 -m venv .venv && . .venv/bin/activate\npip install ../mipgen/generated/python",
        "python first.py localhost:5005",
        "Python 3.10 or later. A serial port also needs `pip install pyserial`.",
    ),
    Start(
        "C", "c", "stream.c", "first.c", "cp -r ../mipgen/generated/c mip",
        "cc -Imip/src -Imip/ports first.c mip/src/mip/*/*.c mip/ports/*.c -o first\n./first localhost:5005",
        "A C99 compiler. On Windows, link with `-lws2_32`.",
    ),
    Start(
        "C++", "cpp", "first.cpp", "first.cpp", "cp -r ../mipgen/generated/c mip",
        "cc -Imip/src -Imip/ports -c mip/src/mip/*/*.c mip/ports/*.c\n"
        "c++ -std=c++17 -Imip/src -Imip/ports first.cpp *.o -o first\n./first localhost:5005",
        "A C++17 compiler; the headers are part of the C library.",
    ),
    Start(
        "Rust", "rust", "stream.rs", "src/main.rs",
        "cargo init --name first .\ncargo add --path ../mipgen/generated/rust --features open",
        "cargo run -- tcp:localhost:5005",
        "Rust 1.85 or later. A serial port is `serial:/dev/ttyACM0`.",
    ),
    Start(
        "JavaScript", "javascript", "first.mjs", "first.mjs", "npm install ../mipgen/generated/javascript",
        "node first.mjs localhost:5005",
        "Node 18 or later. In a browser, `mip-protocol/serial` opens a serial port.",
    ),
)  # fmt: skip


def starts(model: m.Model) -> list[Start]:
    """Returns the languages with a first program; none if a partial specification lacks a field that the programs
    use."""
    used = ("base.ping", "base.get_device_info", "sensor.scaled_accel", "3dm.message_format", "3dm.data_stream_control")
    complete = model.protocol.session is not None and all(map(model.field, used))
    return [x for x in STARTS if complete and model.program(x.program)]


@dataclass(frozen=True, slots=True)
class Frame:
    """The complete programs, one in each language, to which the code on a field's page belongs."""

    name: str  # the role of the field
    title: str
    about: str
    programs: tuple[Program, ...]


def frame_files(model: m.Model) -> list[Frame]:
    """Collects the files in `examples/` whose names begin with "frame"."""
    kinds = (
        ("command", "frame", "Commands", "These programs open a device, send the command and report the outcome."),
        ("data", "frame_data", "Data", "These programs open a device, stream the field once per second and read it."),
    )
    return [
        Frame(name, title, about, tuple(_program(model, x, file) for x in LANGUAGES))
        for name, file, title, about in kinds
    ]


def _program(model: m.Model, x: Language, file: str) -> Program:
    return Program(x.title, x.name, model.program(f"{file}.{x.suffix}").rstrip())
