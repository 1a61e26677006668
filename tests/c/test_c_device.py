"""mip/device.h: every call of every command, and the examples, each against a device."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from c_build import HERE, SANITIZE, SANITIZED, WARNINGS, archive, compiled, folder, include, run
from mipgen import cli
from mipgen import model as m
from mipgen.lower import codec
from mipgen.targets.c import calls, members, names
from spec_defaults import filled as filled_in
from support import PATIENCE, SPECS, heavy, model, need, small
from test_c import build, constructed, given, record, written

EXAMPLES = folder("real") / "examples"


# --------------------------------------------------------------------------- calls


#: A device that answers any command with these fields.
PORT = """
static uint8_t sent[MIP_MAX_PACKET], answer[MIP_MAX_PACKET], buffer[MIP_MAX_PACKET];
static size_t sent_size, answer_size;
static bool put(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    memcpy(sent, bytes, size);
    sent_size = size;
    return true;
}
static bool take(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    (void)size;
    memcpy(bytes, answer, answer_size);
    *count = answer_size;
    answer_size = 0;
    return *count > 0;
}
static uint32_t now(void *user) { (void)user; return 0; }
static const struct mip_port port = {take, put, now, NULL};
static struct mip_device device;
static struct mip_builder builder;

static void answers(uint8_t set, uint8_t command, uint8_t response, const char *hex) {
    const uint8_t acknowledge[] = {command, 0};
    const struct mip_field field = field_of(set, response, hex);
    mip_builder_start(&builder, answer, sizeof(answer), set);
    CHECK(mip_builder_add(&builder, 0xF1, acknowledge, 2) == MIP_OK);
    CHECK(response == 0 || mip_builder_add(&builder, response, field.data, field.size) == MIP_OK);
    answer_size = mip_builder_finish(&builder).size;
}

/* Is this what was sent, or came? */
static bool is_field(const struct mip_codec *codec, const void *value, const char *hex) {
    mip_builder_start(&builder, buffer, sizeof(buffer), codec->descriptor_set);
    return mip_encode(codec, value, &builder) == MIP_OK && strcmp(only_field(&builder), hex) == 0;
}
static bool is_sent(uint8_t set, uint8_t descriptor, const char *hex) {
    const struct mip_field field = field_of(set, descriptor, hex);
    mip_builder_start(&builder, buffer, sizeof(buffer), set);
    CHECK(mip_builder_add(&builder, descriptor, field.data, field.size) == MIP_OK);
    return is_packet(mip_builder_finish(&builder), (const char *)sent, sent_size);
}
"""


def full(f: m.Field) -> str:
    """A response with all of its parameters, encoded."""
    return codec.encode(f, record(f.parameters, f.parameters, 0)).hex()


def check(f: m.Field, call: calls.Call, arguments: list[str], data: str, outcome: str, before: str = "") -> str:
    """The call sends this field and nothing else, and decodes the answer."""
    after, response = "", 0
    if call.response is not None:
        name, answer, response = names.field_name(call.response), full(call.response), call.response.descriptor
        before += f"struct {name} r; memset(&r, 0xAA, sizeof(r)); "
        arguments = [*arguments, "&r"]
        after = f'CHECK(is_field(&{name}_codec, &r, "{answer}"));'
    filled = f'"{answer}"' if call.response is not None else '""'
    return (
        f"{{ {before} answers(0x{f.set:02X}, 0x{f.descriptor:02X}, 0x{response:02X}, {filled});\n"
        f"    CHECK({call.name}({', '.join(['&device', *arguments])}).outcome == {outcome});\n"
        f'    CHECK(is_sent(0x{f.set:02X}, 0x{f.descriptor:02X}, "{data}")); {after} }}'
    )


def filled(f: m.Field, call: calls.Call, values: dict[str, Any], arguments: list[str], outcome: str) -> str:
    """The same with arguments of a structure `x` of these values."""
    name, data = names.field_name(f), codec.encode(f, values).hex()
    before = (
        f'struct {name} x; struct mip_field field = field_of(0x{f.set:02X}, 0x{f.descriptor:02X}, "{data}"); '
        f"CHECK({name}_decode(&x, &field) == MIP_OK); "
    )
    return check(f, call, arguments, data, outcome, before)


def asks(f: m.Field, function: m.Function | None, values: dict[str, Any], of: m.Model) -> set[str]:
    """The responses that a command with these values asks for."""
    return {
        layout.full_name
        for r in of.replies(f)
        if (function is None or function in r.functions) and all(values[c.parameter] == c.value for c in r.when)
        for layout in r.layouts
    }


def outcome(f: m.Field, call: calls.Call, function: m.Function | None, values: dict[str, Any], of: m.Model) -> str:
    """The outcome if the device sends an acknowledge, and the response if the call has one."""
    quiet = bool(f.silent_when) and all(values[c.parameter] == c.value for c in f.silent_when)
    if quiet or (function is not None and not function.reply):
        return "MIP_SENT"
    return "MIP_MISSING_RESPONSE" if call.response is None and asks(f, function, values, of) else "MIP_ACKNOWLEDGED"


def every_call(of: m.Model) -> Iterator[tuple[str, str]]:
    """The name of a call, and a check of it with values for its arguments."""
    for f in of.fields:
        if f.role != m.COMMAND:
            continue
        for call in calls.calls(f, of):
            if call.value == "NULL":
                yield call.name, check(f, call, [], codec.encode(f, {}).hex(), outcome(f, call, None, {}, of))
            elif not members.constructors(f):  # all parameters are reserved
                yield call.name, filled(f, call, record(f.always, f.parameters, 0), ["&x"], "MIP_ACKNOWLEDGED")
    for f, made, values in constructed(of):
        name = names.field_name(f)
        for call in calls.calls(f, of):
            if call.value != "command" and not call.value.startswith(f"{name}_{made.name}("):
                continue
            given_values = dict(values)
            fixed = [p for p in made.asked if call.makes and members.argument(p, f) not in call.arguments]
            for p in fixed:
                assert call.response is not None
                given_values |= {c.parameter: c.value for c in call.response.when if c.parameter == p.name}
            if call.response is not None and call.response.full_name not in asks(f, made.function, given_values, of):
                assert call.value == "command"  # only a call with any values may ask for no response
                continue
            arguments = ["&x"] if call.value == "command" else [given(p) for p in made.asked if p not in fixed]
            wanted = outcome(f, call, made.function, given_values, of)
            yield call.name, filled(f, call, given_values, arguments, wanted)


@small("programs of the real C library")
def test_every_call(spec: str, tmp_path: Path) -> None:
    """Sends what the reference encodes from the same values, and returns the response that the device sends."""
    of = model(spec)
    found = list(every_call(of))
    wanted = {c.name for f in of.fields if f.role == m.COMMAND for c in calls.calls(f, of)}
    functions = sum(max(1, len(f.functions)) for f in of.fields if f.role == m.COMMAND)
    assert {name for name, _ in found} == wanted and len(wanted) >= functions
    headers = "".join(f'#include "mip/{names.module(x.name)}_commands.h"\n' for x in of.families if calls.commands(x))
    checks = ["mip_device_init(&device, &port, 0, NULL);", *(c for _, c in found)]
    program = written(tmp_path / "calls.c", of, checks, f"{headers}{PORT}")
    run(build(tmp_path, "cc", spec, program, *SANITIZE))


def test_the_compiler_sees_a_wrong_response(tmp_path: Path) -> None:
    program = tmp_path / "wrong.c"
    for response, good in (("bias_vector", True), ("settings_response", False)):
        program.write_text(
            f'#include "mip/tools_commands.h"\nvoid f(struct mip_device *d, struct mip_tools_{response} *r);\n'
            f"void f(struct mip_device *d, struct mip_tools_{response} *r) {{ mip_call_tools_bias_read(d, r); }}\n"
        )
        command = [need("cc"), *WARNINGS, include("invented"), "-fsyntax-only", str(program)]
        assert (subprocess.run(command, capture_output=True).returncode == 0) == good


@pytest.mark.parametrize(
    "call", ["mip_3dm_data_stream_control_write(c, {})", "mip_call_3dm_data_stream_control_write(d, {})"]
)
@pytest.mark.parametrize(
    "arguments,good", [("MIP_SENSOR_SET, true", True), ("MIP_SENSOR_SET, x", True), ("true, MIP_SENSOR_SET", False)]
)
def test_the_compiler_sees_a_set_in_place_of_true(call: str, arguments: str, good: bool, tmp_path: Path) -> None:
    """Arguments in the wrong order: a constant above 1 for a Boolean is reported if the compiler optimizes."""
    program = tmp_path / "truth.c"
    types = "struct mip_device *d, struct mip_3dm_data_stream_control *c, uint8_t x"
    program.write_text(
        '#include "mip/3dm_commands.h"\n#include "mip/sensor.h"\n'
        f"void f({types});\nvoid f({types}) {{ (void)d, (void)c, (void)x; (void){call.format(arguments)}; }}\n"
    )
    command = [need("cc"), *WARNINGS, "-O1", include("real"), "-c", str(program), "-o", str(tmp_path / "o")]
    assert (subprocess.run(command, capture_output=True).returncode == 0) == good


@pytest.mark.parametrize("cc", ["cc", pytest.param("clang", marks=heavy("clang"))])
@pytest.mark.parametrize("call", ["mip_3dm_message_format_write(c, {})", "mip_call_3dm_message_format_write(d, {})"])
def test_the_compiler_sees_a_count_above_the_array(call: str, cc: str, tmp_path: Path) -> None:
    """A constant count is reported if the compiler optimizes; MIP_ARRAY counts itself, and accepts no pointer."""
    program = tmp_path / "count.c"
    types = "struct mip_device *d, struct mip_3dm_message_format *c, const struct mip_descriptor_rate *p, uint8_t x"
    array = "const struct mip_descriptor_rate a[] = {{4, 1}, {5, 1}, {6, 1}};"
    good = {"3, a": True, "x, a": True, "4, p": True, "MIP_ARRAY(a)": True, "4, a": False, "MIP_ARRAY(p)": False}
    for arguments, compiles in good.items():
        program.write_text(
            f'#include "mip/3dm_commands.h"\nvoid f({types});\nvoid f({types}) {{ {array}\n'
            f"(void)d, (void)c, (void)x, (void)p, (void)a; (void){call.format(f'0x80, {arguments}')}; }}\n"
        )
        command = [need(cc), *WARNINGS, "-O1", include("real"), "-c", str(program), "-o", str(tmp_path / "o")]
        assert (subprocess.run(command, capture_output=True).returncode == 0) == compiles, arguments


#: Entries of a table of handlers, and whether they compile.
ENTRIES = {
    "&mip_measurements_accel_codec, MIP_ANY_SET, on, NULL": True,
    "MIP_ANY_FIELD, MIP_MEASUREMENTS_SET, on, NULL": True,
    "MIP_MEASUREMENTS_ACCEL_DESCRIPTOR, MIP_ANY_SET, on, NULL": False,
    "MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET), MIP_ANY_SET, on, NULL": False,
    "MIP_MEASUREMENTS_SET, &mip_measurements_accel_codec, on, NULL": False,
    "1, MIP_MEASUREMENTS_SET, on, NULL": False,
}


@pytest.mark.parametrize("entry", ENTRIES)
def test_the_compiler_sees_a_number_in_place_of_a_type(entry: str, tmp_path: Path) -> None:
    """A handler names a type by its codec: a descriptor, a key, or set and type swapped, do not compile."""
    program = tmp_path / "entry.c"
    program.write_text(
        '#include "mip/device.h"\n#include "mip/measurements.h"\n'
        "extern void on(void *user, const struct mip_field *field, uint32_t arrived);\n"
        "extern const struct mip_handler handlers[];\n"
        f"const struct mip_handler handlers[] = {{{{{entry}}}}};\n"
    )
    command = [need("cc"), "-Wall", "-Werror", include("invented"), "-fsyntax-only", str(program)]
    assert (subprocess.run(command, capture_output=True).returncode == 0) == ENTRIES[entry]


#: A command whose parameters have the names of arguments of generated functions.
CLASHING = """# yaml-language-server: $schema=../../../../../spec/schema/set.schema.json
set: 0x62
name: clashing
title: Clashing
description: D.
fields:
  - command: 0x01
    name: names
    title: Names
    description: D.
    sources: [{manual: leaflet, section: S}]
    functions: WR
    parameters:
      - {name: command, type: u8, for: WR}
      - {name: device, type: u8, for: W}
      - {name: response, type: u16, count: device, for: W}
      - {name: value, type: char, count: 4, for: W}
    responses: [{response: 0x81, name: response, parameters: as_command}]
"""


def test_parameters_may_have_the_names_of_arguments(tmp_path: Path) -> None:
    shutil.copytree(SPECS["invented"][0], tmp_path / "spec")
    (tmp_path / "spec/sets/clashing.yaml").write_text(filled_in(CLASHING), "utf-8")
    arguments = ("--spec", str(tmp_path / "spec"), "--out", str(tmp_path / "out"), "--target", "c")
    assert cli.main(["generate", *arguments]) == 0
    program = tmp_path / "clashing.c"
    program.write_text(
        """#include "check.h"
#include "mip/clashing_commands.h"
int main(void) {
    struct mip_clashing_names made;
    const uint16_t numbers[] = {7, 8};
    mip_clashing_names_write(&made, 5, 2, numbers, "text");
    CHECK(made.command == 5 && made.device == 2 && made.response[1] == 8 && strcmp(made.value, "text") == 0);
    return sizeof(&mip_call_clashing_names_write) == 0 || sizeof(&mip_call_clashing_names_read) == 0;
}
"""
    )
    where = tmp_path / "out/c/src"
    library = sorted((where / "mip").glob("*.c"))
    run(
        need("cc"),
        "-std=c99",
        *WARNINGS,
        f"-I{where}",
        f"-I{HERE}/unit",
        program,
        *library,
        "-o",
        tmp_path / "clashing",
    )
    run(tmp_path / "clashing")


# --------------------------------------------------------------------------- examples


def example(tmp_path: Path, name: str, *also: Path) -> Path:
    """An example, built with the library as its user would; `also`: further sources."""
    out = tmp_path / name.partition(".")[0]
    library = archive("real", "cc", *SANITIZED)  # that of the unit programs
    return compiled(out, "real", "cc", EXAMPLES / name, "-std=c99", *SANITIZE, also=also, library=library)


def ran(program: Path, *arguments: str) -> tuple[int, str, str]:
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=PATIENCE)
    return done.returncode, done.stdout, done.stderr


def test_the_examples_are_these() -> None:
    assert {p.name for p in EXAMPLES.iterdir()} == {
        "stream.c", "bare_metal.c", "arduino", "arduino_cpp", "autopilot.cpp", "log.c", "log.cpp",
        "node.cpp"
    }  # fmt: skip
    headers = set(re.findall(r"#include <(.*)>", (EXAMPLES / "bare_metal.c").read_text("utf-8")))
    assert headers == set()  # nothing of the C library


def test_bare_metal(tmp_path: Path) -> None:
    ran_well = ran(example(tmp_path, "bare_metal.c", HERE / "unit/board.c"))
    assert ran_well == (0, "", "")
