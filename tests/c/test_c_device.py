"""mip/device.h: every call of every command, and the examples, each against a device."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from c_build import HERE, SANITIZED, WARNINGS, compiled, folder, include, run
from mipgen import model as m
from mipgen.lower import codec
from mipgen.targets.c import calls, members, names
from support import PATIENCE, ROOT, heavy, model, need, small
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
    (void)user, (void)size;
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
            fixed = [p for p in made.parameters if call.way and members.argument(p, f) not in call.arguments]
            for p in fixed:
                assert call.response is not None
                given_values |= {c.parameter: c.value for c in call.response.when if c.parameter == p.name}
            if call.response is not None and call.response.full_name not in asks(f, made.function, given_values, of):
                assert call.value == "command"  # only a call with any values may ask for no response
                continue
            arguments = ["&x"] if call.value == "command" else [given(p) for p in made.parameters if p not in fixed]
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
    headers = "".join(
        f'#include "mip/{names.module(x.name)}_commands.h"\n'
        for x in of.families
        if any(f.role == m.COMMAND for f in x.fields)
    )
    checks = ["mip_device_init(&device, &port, 0, NULL);", *(c for _, c in found)]
    program = written(tmp_path / "calls.c", of, checks, f"{headers}{PORT}")
    run(build(tmp_path, "cc", spec, program))


#: Settings that are read, changed and written, with the program that the README shows.
CHANGES = """{
        struct mip_3dm_event_trigger_config trigger;
        union mip_3dm_event_trigger_config_parameters window;
        memset(&window, 0, sizeof(window));
        /* a threshold: instance 2, field (0x80,0x04), parameter 1, a window from 1 to 2 */
        answers(0x0C, 0x2E, 0xB8, "020280040101" "3ff0000000000000" "4000000000000000");
        mip_device_init(&device, &port, 0, NULL);
        write_follows = true;
        CHECK(set_threshold(&device, 2, 1.5).outcome == MIP_ACKNOWLEDGED);
        CHECK(is_sent(0x0C, 0x2E, "01" "020280040101" "3ff8000000000000" "4000000000000000"));
        /* a type without a name: refused when it is made, kept when it was decoded */
        mip_3dm_event_trigger_config_write(&trigger, 2, (enum mip_event_trigger_type)9, &window);
        CHECK(mip_call_3dm_event_trigger_config_with(&device, &trigger, NULL).error == MIP_ERROR_MISSING);
        struct mip_field field = field_of(0x0C, 0x2E, "010209");
        CHECK(mip_3dm_event_trigger_config_decode(&trigger, &field) == MIP_OK);
        CHECK(is_field(&mip_3dm_event_trigger_config_codec, &trigger, "010209"));
        /* reserved values in a structure are filled, and kept when they were decoded */
        struct mip_aiding_measurement_time time = {MIP_AIDING_TIMEBASE_TIME_OF_ARRIVAL, 0, 5};
        struct mip_aiding_height_above_ellipsoid height;
        mip_aiding_height_above_ellipsoid_make(&height, &time, 1, 2, 3, 1);
        CHECK(height.time.reserved == 1 && height.time.nanoseconds == 5);
        field = field_of(0x13, 0x23, "0300" "0000000000000005" "01" "40000000" "40400000" "0001");
        CHECK(mip_aiding_height_above_ellipsoid_decode(&height, &field) == MIP_OK && height.time.reserved == 0);
}"""


@heavy("programs of the real C library")
def test_settings_are_read_changed_and_written(tmp_path: Path) -> None:
    example = (
        (ROOT / "examples/change.c")
        .read_text("utf-8")
        .replace("struct mip_result set_", "static struct mip_result set_")
    )
    then = '    if (write_follows) {\n        write_follows = false;\n        answers(0x0C, 0x2E, 0, "");\n    }\n'
    port = PORT.replace("    return *count > 0;\n", f"{then}    return *count > 0;\n")
    declared = "static bool write_follows;\nstatic void answers(uint8_t, uint8_t, uint8_t, const char *);\n"
    head = f'#include "mip/aiding.h"\n{example}{declared}{port}'
    run(build(tmp_path, "cc", "real", written(tmp_path / "changes.c", model("real"), [CHANGES], head)))


# --------------------------------------------------------------------------- mistakes

#: What a compiler reports: the specification, what stands before the statements, their variables, those that compile,
#: and those that do not.
MISTAKES = {
    "an addition that is not looked at": (
        "invented", '#include "mip/tools.h"', "struct mip_builder *b",
        ["if (mip_tools_ping_encode(NULL, b) != MIP_OK) { b->error = MIP_OK; }"],
        ["mip_tools_ping_encode(NULL, b);", "mip_encode(&mip_tools_ping_codec, NULL, b);",
         "mip_builder_add(b, 1, NULL, 0);"],
    ),
    "a wrong response": (
        "invented", '#include "mip/tools_commands.h"',
        "struct mip_device *d, struct mip_tools_bias_vector *r, struct mip_tools_settings_response *s",
        ["mip_call_tools_bias_read(d, r);"], ["mip_call_tools_bias_read(d, s);"],
    ),
    "a set in place of true": (
        "real", '#include "mip/3dm_commands.h"\n#include "mip/sensor.h"',
        "struct mip_device *d, struct mip_3dm_data_stream_control *c, uint8_t x",
        ["mip_3dm_data_stream_control_write(c, MIP_SENSOR_SET, true);",
         "mip_call_3dm_data_stream_control_write(d, MIP_SENSOR_SET, x);"],
        ["mip_3dm_data_stream_control_write(c, true, MIP_SENSOR_SET);",
         "mip_call_3dm_data_stream_control_write(d, true, MIP_SENSOR_SET);"],
    ),
    "a count above the array": (
        "real", '#include "mip/3dm_commands.h"\nstatic const struct mip_descriptor_rate a[3] = {{4, 1}, {5, 1}};',
        "struct mip_device *d, struct mip_3dm_message_format *c, const struct mip_descriptor_rate *p, uint8_t x",
        ["mip_3dm_message_format_write(c, 0x80, 3, a);", "mip_3dm_message_format_write(c, 0x80, x, a);",
         "mip_call_3dm_message_format_write(d, 0x80, 4, p);",
         "mip_call_3dm_message_format_write(d, 0x80, MIP_ARRAY(a));"],
        ["mip_3dm_message_format_write(c, 0x80, 4, a);", "mip_3dm_message_format_write(c, 0x80, MIP_ARRAY(p));",
         "mip_call_3dm_message_format_write(d, 0x80, 4, a);",
         "mip_call_3dm_message_format_write(d, 0x80, MIP_ARRAY(p));"],
    ),
    "a number in place of a type": (
        "invented", '#include "mip/device.h"\n#include "mip/measurements.h"',
        "void (*on)(void *user, const struct mip_field *field, uint32_t arrived)",
        ["struct mip_handler h = {&mip_measurements_accel_codec, MIP_ANY_SET, on, NULL};",
         "struct mip_handler h = {MIP_ANY_FIELD, MIP_MEASUREMENTS_SET, on, NULL};"],
        ["struct mip_handler h = {MIP_MEASUREMENTS_ACCEL_DESCRIPTOR, MIP_ANY_SET, on, NULL};",
         "struct mip_handler h = {MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET), MIP_ANY_SET, on, NULL};",
         "struct mip_handler h = {MIP_MEASUREMENTS_SET, &mip_measurements_accel_codec, on, NULL};",
         "struct mip_handler h = {1, MIP_MEASUREMENTS_SET, on, NULL};"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("compiler", ["cc", pytest.param("clang", marks=heavy("clang"))])
@pytest.mark.parametrize("mistake", MISTAKES)
def test_the_compiler_sees(mistake: str, compiler: str, tmp_path: Path) -> None:
    """Some of these only if it optimizes."""
    spec, before, variables, good, bad = MISTAKES[mistake]
    program = tmp_path / "program.c"
    unused = ["-Wno-unused-parameter", "-Wno-unused-variable", "-Wno-unused-const-variable"]
    for statement in (" ".join(f"{{ {s} }}" for s in good), *bad):
        program.write_text(f"{before}\nvoid f({variables});\nvoid f({variables}) {{ {statement} }}\n")
        command = [need(compiler), *WARNINGS, *unused, "-O1", include(spec), "-c", program, "-o", tmp_path / "o"]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        assert (done.returncode != 0) == (statement in bad), f"{statement}\n{done.stderr}"


# --------------------------------------------------------------------------- examples


def test_bare_metal(tmp_path: Path) -> None:
    source, board = EXAMPLES / "bare_metal.c", HERE / "unit/board.c"
    assert "#include <" not in source.read_text("utf-8")  # nothing of the C library
    program = compiled(tmp_path / "bare_metal", "real", "cc", source, *SANITIZED, also=[board])
    done = subprocess.run([program], capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
