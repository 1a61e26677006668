"""Facts in words, written by hand from tests/invented/spec: what readers of each language find where they look.

Other tests compare documentation with what `mipgen.facts` composes; these know what it must compose.
"""

from __future__ import annotations

import re
from functools import cache

import pytest
from mipgen import model as m
from mipgen.targets.c import names as c
from mipgen.targets.python import names as python
from mipgen.targets.rust import names as rust
from support import SPECS, model

OUT = SPECS["invented"][1]

#: Field or structure -> sentences of its documentation, and of that of its parameters.
SENTENCES = [
    ("measurements.radio", "Also called modem and rf."),
    ("measurements.radio", "Occurs in measurements (0x80) and copy (0x92)."),
    ("measurements.radio", "Supported by Model C."),
    ("measurements.radio", "Known only from the Kit of names."),
    ("measurements.radio", "Uncertain: The leaflet gives the strength two bytes."),
    ("measurements.radio", "Of the signal. Range: less than 1. Valid if connected is true. Uncertain: Its unit."),
    ("measurements.radio", "Unit: m. Range: greater than 0, at most 10. Valid if connected is true."),
    ("measurements.radio", "On the Model C: valid if connected is true; deprecated."),
    ("measurements.accel", "Specific force. Elements: x, y, z. Unit: g. Frame: sensor."),
    ("measurements.health", "Deprecated: use "),
    ("measurements.growing", "From version 2 on. Optional."),
    ("measurements.growing", "From version 3 on. Unit: deg. Optional."),
    ("measurements.gust", "Of the wind. Elements: x, y, z. Unit: m. Range: magnitude at most 40."),
    ("measurements.breeze", "Range: magnitude 0.5 to 1.5. Default: 1, 0, 0, 0."),
    ("tools.settings", "Functions: write, read, save, load, default and apply."),
    ("tools.settings", "Number of the port, 0 for all. Range: 0 to 8."),
    ("tools.settings", "Speed. Unit: Bd. Default: 115200. Required for write and apply."),
    ("tools.settings", "Required by no function, not even by write. Optional."),
    ("tools.status", "For advanced use."),
    ("tools.status", "The device may take 2.5 s to reply."),
    ("tools.status", "Which layout. Range: 1 to 2."),
    ("tools.status_long", "Since start. Unit: s."),
    ("tools.bias", "Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor."),
    ("tools.capture_bias", "How long. Unit: s. Range: 1 to 30."),
    ("tools.capture_bias", "Deprecated on the Model C: use "),
    ("tools.formats", "Not acknowledged if suppress_ack is true."),
    ("tools.formats", "Between a counter and its array. Deprecated."),
    ("tools.hello", "Sent by the device; the host replies."),
    ("tools.hello", "No device is known for certain to support it."),
    ("tools.stripes", "Of a stripe. Unit: m."),
    ("tools.stripes", "Of all stripes. Unit: deg. Range: -180 to 180."),
]

#: Sentences that C words differently.
IN_C = {
    "Occurs in measurements (0x80) and copy (0x92).": "Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET.",
    "Supported by Model C.": "",  # devices are in the profiles
}

#: What pages of the reference have in columns, and not in sentences: the row of a parameter.
ROWS = [
    ("measurements.radio", "| Of the signal. Uncertain: Its unit. | less than 1 | connected | 1 | 4 | 1 |"),
    ("measurements.radio", "| float | m | Never nothing. | greater than 0, at most 10 | connected | 5 | 4 | 1 m |"),
    ("tools.settings", "| 0 to 8 | | | 1 | 1 | 1 |"),
    ("tools.settings", "| baud | u32 | Bd | Speed. | | 115200 | write and apply | 3 | 4 | 9600 Bd |"),
    ("tools.capture_bias", "| time | u16 | s | How long. | 1 to 30 | 0 | 2 | 20 s |"),
    ("tools.bias", "| sensor | write | 1 | 12 | x 0.5, y 0.25, z 0 g |"),
    ("measurements.breeze", "| magnitude 0.5 to 1.5 | 1, 0, 0, 0 |"),
    ("tools.poll", "| 0x80 to 0xFE | | 0 | 1 | 0x80 Measurements |"),
    ("tools.poll", "| 0x01 | 1 | 1 | 0x01 Acceleration |"),
    ("tools.poll", "| 3 | count | 0x01 Acceleration, 0x02 Numbers, 0xD3 Timestamp, 0x7F |"),
]


def plain(text: str) -> str:
    """Words without the marks of comments, code and links."""
    text = re.sub(r"^\s*(///|/\*\*|\*/|\*|//)|\*/\s*$", " ", text, flags=re.M)
    text = re.sub(r"</?\w[^>]*>|`|\\(?=\W)", "", text)
    text = re.sub(r"\[((?:[^][]|\[\w*\])*)\]\([^()\s]*\)", r"\1", " ".join(text.split()))
    return " ".join(text.split())


def thing(name: str) -> m.Field | m.Struct:
    of = model("invented")
    found = of.field(name) or next((t for t in of.all_types if f"{getattr(t, 'owner', '')}.{t.name}" == name), None)
    assert isinstance(found, (m.Field, m.Struct)), name
    return found


@cache
def source(pattern: str) -> str:
    return "\n\n".join(p.read_text("utf-8") for p in sorted(OUT.glob(pattern)))


def section(language: str, name: str) -> str:
    """The declaration of a type with the comments on it and its members."""
    t = thing(name)
    if language == "c":
        found = re.search(
            rf"/\*\*(?:(?!\*/).)*\*/\nstruct {c.symbol(t)} \{{.*?^\}};", source("c/src/mip/*.h"), re.S | re.M
        )
    elif language == "python":
        text = source(f"python/mip_protocol/{python.home(t)}.py")
        found = re.search(rf"^class {python.class_name(t)}\(.*?(?=^(?:class|def) |\Z)", text, re.S | re.M)
    else:
        where = source(f"rust/src/sets/{rust.home(t)}.rs")
        found = re.search(
            rf"record! \{{\n(?:(?!^\}}).)*?pub struct {rust.type_name(t.name)}\b.*?^\}}", where, re.S | re.M
        )
    assert found is not None, (language, name)
    return found[0]


@pytest.mark.parametrize("language", ["c", "python", "rust"])
@pytest.mark.parametrize(("name", "sentence"), SENTENCES)
def test_it_is_said(name: str, sentence: str, language: str) -> None:
    assert (IN_C.get(sentence, sentence) if language == "c" else sentence) in plain(section(language, name))


@pytest.mark.parametrize(("name", "row"), ROWS)
def test_it_is_a_row(name: str, row: str) -> None:
    page = source(f"markdown/docs/fields/{name.replace('.', '/')}.md")
    assert row in plain(page)
