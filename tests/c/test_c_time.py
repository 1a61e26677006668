"""Times of packets, conversion to UTC, and validity in C, compared with the Python package; rejected fields."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import random_values
from c_build import SANITIZED, compiled, run
from mipgen import model as m
from mipgen.lower import codec
from mipgen.targets.c import names, validity
from mipgen.targets.python import names as python
from packages import mip, real
from random_values import chance
from support import ROOT, heavy, model, rounds
from timed_packets import cases_of_devices, leap_seconds, random_packets

PACKAGES: dict[str, Any] = {"real": real, "invented": mip}

TIMES = """
#include "check.h"
#include "mip/timestamps.h"

/* Reads "DEVICE PACKET" or "utc CLOCK NANOSECONDS", and prints the time of every clock. */
int main(void) {
    char device[64], text[1024];
    long long number;
    while (scanf("%63s %1023s", device, text) == 2) {
        uint8_t bytes[MIP_MAX_PACKET];
        struct mip_packet packet = {bytes, 0, 0};
        if (strcmp(device, "utc") == 0) {
            CHECK(scanf("%lld", &number) == 1);
            printf("%lld\\n", (long long)mip_time_utc((uint8_t)atoi(text), number));
            continue;
        }
        packet.size = octets(text, bytes);
        packet.descriptor_set = bytes[2];
        const uint8_t reading = mip_reading_of(device[0] == '-' ? NULL : device);
        for (unsigned clock = 0; clock < CLOCKS; clock++) {
            int64_t time = -1;
            const enum mip_time_state state = mip_time(&packet, (uint8_t)clock, reading, &time);
            CHECK((state == MIP_TIME_VALID) || time == -1);
            printf(state == MIP_TIME_VALID ? "%lld " : state == MIP_TIME_ABSENT ? "- " : "None ", (long long)time);
        }
        int64_t none = -1;
        CHECK(mip_time(&packet, 0xFF, reading, &none) == MIP_TIME_ABSENT && none == -1);
        (void)mip_time(&packet, 0, 0xFE, &none);
        printf("\\n");
    }
    return 0;
}
"""


def program(tmp: Path, spec: str, source: str) -> Path:
    (tmp / "program.c").write_text(source)
    return compiled(tmp / "program", spec, "cc", tmp / "program.c", *SANITIZED)


def answers(path: Path, lines: list[str]) -> list[str]:
    given = path.with_suffix(".in")
    given.write_text("\n".join(lines) + "\n")
    return [line.rstrip() for line in run("sh", "-c", f"{path} <{given}").splitlines()]


def times(tmp: Path, spec: str) -> Path:
    return program(tmp, spec, f"#define CLOCKS {len(model(spec).protocol.clocks)}U\n{TIMES}")


@pytest.mark.parametrize("spec", ["invented", "real"])
def test_times_are_those_of_python(spec: str, tmp_path: Path) -> None:
    """For all clocks, kinds of timestamps, flags and devices."""
    of, package, luck = model(spec), PACKAGES[spec], chance("times in C", spec)
    lines, wanted = [], []
    for device, data in random_packets(luck, of, rounds(3000, 100000)):
        known = package.timestamps.moments(package.packet.Packet(data), None if device == "-" else device)
        lines.append(f"{device} {data.hex()}")
        wanted.append(" ".join(str(known.get(clock.name, "-")) for clock in of.protocol.clocks))
    assert {"-", "None"} < {word for line in wanted for word in line.split()}
    assert list(zip(lines, answers(times(tmp_path, spec), lines), strict=True)) == list(zip(lines, wanted, strict=True))


def test_times_of_devices(tmp_path: Path) -> None:
    cases = cases_of_devices()
    lines = [f"{device or '-'} {data.hex()}" for device, data, *_ in cases]
    found = [line.split() for line in answers(times(tmp_path, "real"), lines)]
    read = [tuple(None if word in ("-", "None") else int(word) for word in (line[0], line[3])) for line in found]
    assert list(zip(lines, read)) == [(line, case[2:]) for line, case in zip(lines, cases)]


def test_readings_by_model_number_are_those_by_id(tmp_path: Path) -> None:
    numbers = {d.model_number: d.id for d in model("real").devices if d.model_number}
    numbers |= {d.model_number: d.like for d in model("real").named}
    checks = "".join(
        f'    CHECK(mip_reading_of_model({number}) == mip_reading_of("{name}"));\n' for number, name in numbers.items()
    )
    source = f"""#include "check.h"
#include "mip/connect.h"
#include "mip/extra/profiles.h"
#include "mip/timestamps.h"

int main(void) {{
    const struct mip_base_get_device_info_response gx5 = {{{{0, "3DM-GX5-25", "  6253-4220", "", "", ""}}}};
    const struct mip_base_get_device_info_response none = {{{{0, "", "", "", "", ""}}}};
{checks}    CHECK(mip_reading_of_model(mip_device_model(&gx5)) == mip_reading_of("3dm-gx5-25"));
    CHECK(mip_reading_of_model(6253) != mip_reading_of_model(6286));
    CHECK(mip_reading_of_model(mip_device_model(&none)) == MIP_READING_UNKNOWN);
    return 0;
}}
"""
    run(program(tmp_path, "real", source))


def test_gps_time_to_utc_across_every_leap_second(tmp_path: Path) -> None:
    leaps = leap_seconds()
    assert model("real").protocol.clocks[0].name == "gps"
    lines = [*(f"utc 0 {time}" for time, _ in leaps), "utc 2 12345", f"utc 0 {2**63 - 1}"]
    wanted = [*(str(utc) for _, utc in leaps), "12345", str(2**63 - 1)]
    assert answers(times(tmp_path, "real"), lines) == wanted


# --------------------------------------------------------------------------- validity


def validities(of: m.Model) -> list[tuple[m.Field, list[m.Parameter], str, bool]]:
    """Each function with the values whose validity it returns: its name, and whether it has a reading."""
    found = []
    for f in of.fields:
        flagged = [p for p in f.parameters if p.valid or any(v.valid for v in p.variants)]
        for function in validity.validity_functions(f, of):
            own = [p for p in flagged if function.name == f"{names.field_name(f)}_{names.member(p.name)}_valid"]
            found.append((f, own or flagged, function.name, len(function.declarations) > 1))
    return found


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=heavy("programs of the real C library"))])
def test_validity_is_that_of_python(spec: str, tmp_path: Path) -> None:
    of, package, luck = model(spec), PACKAGES[spec], chance("validity in C", spec)
    body, count, seen = [], 0, set()
    for f, values, name, has_reading in validities(of) * rounds(10, 100):
        device = luck.choice(["-", *(d.id for d in of.devices)])
        data = codec.encode(f, random_values.record(luck, f.parameters, 120))
        kind = getattr(getattr(package, python.home(f)), python.class_name(f))
        decoded = kind.decode(data)
        wanted = all(decoded.is_valid(p.name, None if device == "-" else device) for p in values)
        seen.add(wanted)
        structure = names.field_name(f)
        reading = (
            f", mip_reading_of({'NULL' if device == '-' else f'{chr(34)}{device}{chr(34)}'})" if has_reading else ""
        )
        body.append(f"""static void check_{count}(void) {{
    struct {structure} x;
    struct mip_field field = field_of(0x{f.set % 255 or 128:02X}, 0x{f.descriptor:02X}, "{data.hex()}");
    CHECK({structure}_decode(&x, &field) == MIP_OK);
    CHECK({name}(&x{reading}) == {str(wanted).lower()});
}}
""")
        count += 1
    headers = {names.module(f.family) for f, *_ in validities(of)}
    assert count > 10 and seen == {True, False}
    includes = "".join(f'#include "mip/{h}_valid.h"\n' for h in sorted(headers))
    calls = "".join(f"    check_{i}();\n" for i in range(count))
    source = f'#include "check.h"\n#include "mip/timestamps.h"\n{includes}{"".join(body)}'
    run(program(tmp_path, spec, f"{source}int main(void) {{\n{calls}    return 0;\n}}\n"))


# --------------------------------------------------------------------------- rejected fields

REJECTED = """
#include "check.h"
#include "mip/connect.h"
#include "mip/extra/profiles.h"
#include "mip/extra/rejected.h"

/* Reads "DEVICE DESCRIPTORS COMMAND DATA", with - for none, and prints the field as JSON. */
int main(void) {
    const struct mip_known_device ar = {&mip_profile_cv7_ar, NULL, 0};
    const struct mip_rate rates[] = {{0x04, 100, 0}, {0x06, 50, 0}};
    const struct mip_rejected mag = mip_stream_rejected(0x80, 2, rates, &ar);
    CHECK(mag.reason == MIP_REJECTION_ABSENT && mag.index == 1 && mag.descriptor == 0x06);
    CHECK(mip_stream_rejected(0x80, 1, rates, &ar).reason == MIP_REJECTION_UNKNOWN);
    CHECK(mip_stream_rejected(0x91, 0, rates, &ar).reason == MIP_REJECTION_ABSENT);
    /* One that has only the older commands: by its profile, by what it lists, and for a set that it lacks. */
    static const uint16_t listed_by_gx5[] = {0x0C06, 0x0C08, 0x0C11, 0x8004, 0x8005};
    const struct mip_known_device gx5[] = {{&mip_profile_gx5_15, NULL, 0}, {&mip_profile_gx5_15, listed_by_gx5, 5}};
    for (int i = 0; i < 2; i++) {
        const struct mip_rejected absent = mip_stream_rejected(0x80, 2, rates, &gx5[i]);
        CHECK(absent.reason == MIP_REJECTION_ABSENT && absent.index == 1 && absent.descriptor == 0x06);
        CHECK(mip_stream_rejected(0x80, 1, rates, &gx5[i]).reason == MIP_REJECTION_UNKNOWN);
    }
    CHECK(mip_stream_rejected(0x81, 1, rates, &gx5[1]).reason == MIP_REJECTION_ABSENT);
    static struct mip_rate many[MIP_MAX_FIELD_DATA];
    CHECK(mip_stream_rejected(0x91, MIP_MAX_FIELD_DATA, many, &ar).reason == MIP_REJECTION_UNKNOWN); /* not sent */
    static const char *const reasons[] = {"", "absent", "decimation", "too_many", "undefined", "unlisted",
                                          "other_command"};
    char words[4][600];
    while (scanf("%599s %599s %599s %599s", words[0], words[1], words[2], words[3]) == 4) {
        uint8_t listed[64], command[2], data[256];
        uint16_t descriptors[32];
        struct mip_known_device known = {mip_profile_find(words[0]), NULL, octets(words[1], listed) / 2};
        for (size_t i = 0; i < known.descriptor_count; i++) {
            descriptors[i] = (uint16_t)(listed[2 * i] << 8 | listed[2 * i + 1]);
            known.descriptors = descriptors;
        }
        (void)octets(words[2], command);
        const uint8_t size = (uint8_t)octets(words[3], data);
        const struct mip_field field = {data, size, command[0], command[1]};
        const struct mip_rejected found = mip_find_rejected(&field, &known);
        char text[100], part[6];
        CHECK(mip_rejected_text(&found, &known, text, sizeof(text)) == strlen(text));
        CHECK(mip_rejected_text(&found, &known, part, sizeof(part)) == strlen(text));
        CHECK(strlen(part) == (text[0] == '\\0' ? 0 : 5) && strncmp(part, text, strlen(part)) == 0);
        CHECK(mip_rejected_text(&found, &known, NULL, 0) == strlen(text));
        if (found.reason == MIP_REJECTION_UNKNOWN) {
            printf("null\\n");
            continue;
        }
        printf("[%u, \\"%02X\\", \\"%02X\\", \\"%s\\", \\"%s\\"]\\n", found.index, found.descriptor_set,
               found.descriptor, reasons[found.reason], text);
    }
    return 0;
}
"""


def test_the_field_to_blame(tmp_path: Path) -> None:
    """By the cases that all languages share."""
    cases = json.loads((ROOT / "tests/rejected.json").read_text("utf-8"))
    keys = ("device", "descriptors", "command", "data")
    lines = [" ".join(c.get(key, "").replace(" ", "") or "-" for key in keys) for c in cases]
    found = map(json.loads, answers(program(tmp_path, "real", REJECTED), lines))
    assert {c["title"]: x for c, x in zip(cases, found, strict=True)} == {c["title"]: c["cause"] for c in cases}
