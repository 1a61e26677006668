"""C names the field for which a device rejects a command, by the cases that all languages share."""

from __future__ import annotations

import json
from pathlib import Path

from c_build import SANITIZED, compiled, run
from support import ROOT

PROGRAM = """
#include "check.h"
#include "mip/connect.h"
#include "mip/extra/profiles.h"
#include "mip/extra/rejected.h"

static size_t octets(const char *text, uint8_t *bytes) {
    const size_t size = text[0] == '-' ? 0 : strlen(text) / 2;
    for (size_t i = 0; i < size; i++) {
        unsigned value;
        CHECK(sscanf(text + 2 * i, "%2x", &value) == 1);
        bytes[i] = (uint8_t)value;
    }
    return size;
}

/* Reads "DEVICE DESCRIPTORS COMMAND DATA", with - for none, and prints the field as JSON. */
int main(void) {
    const struct mip_known_device ar = {&mip_profile_cv7_ar, NULL, 0};
    const struct mip_rate rates[] = {{0x04, 100, 0}, {0x06, 50, 0}};
    const struct mip_rejected mag = mip_stream_rejected(0x80, 2, rates, &ar);
    CHECK(mag.reason == MIP_REJECTION_ABSENT && mag.index == 1 && mag.descriptor == 0x06);
    CHECK(mip_stream_rejected(0x80, 1, rates, &ar).reason == MIP_REJECTION_UNKNOWN);
    CHECK(mip_stream_rejected(0x91, 0, rates, &ar).reason == MIP_REJECTION_ABSENT);
    static struct mip_rate many[MIP_MAX_FIELD_DATA];
    CHECK(mip_stream_rejected(0x91, MIP_MAX_FIELD_DATA, many, &ar).reason == MIP_REJECTION_UNKNOWN); /* not sent */
    static const char *const reasons[] = {"", "absent", "decimation", "too_many", "undefined", "unlisted"};
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
    cases = json.loads((ROOT / "tests/rejected.json").read_text("utf-8"))
    lines = [
        [c.get("device", "-"), *(c.get(key, "").replace(" ", "") or "-" for key in ("descriptors", "command", "data"))]
        for c in cases
    ]
    (tmp_path / "cases").write_text("".join(" ".join(line) + "\n" for line in lines))
    (tmp_path / "program.c").write_text(PROGRAM)
    program = compiled(tmp_path / "program", "real", "cc", tmp_path / "program.c", *SANITIZED)
    found = run("sh", "-c", f"{program} <{tmp_path / 'cases'}").splitlines()
    assert {c["title"]: json.loads(x) for c, x in zip(cases, found, strict=True)} == {
        c["title"]: c["cause"] for c in cases
    }
