"""Writes into the README what one field of the specification becomes; with --check, only compares it.

It also compares the picture of a page with what the page shows: `make pictures` notes a digest of that (--pictures).
"""

from __future__ import annotations

import hashlib
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "README.md"
BEGIN, END = "<!-- a field, written by make first-page -->\n", "<!-- end of the field -->"


def part(path: str, begin: str, end: str) -> str:
    """Returns the lines of a file from one that begins as `begin` to the first that is or contains `end`."""
    text = (ROOT / path).read_text("utf-8")
    found = re.search(rf"^{begin}.*?{end}$", text, re.M | re.S)
    assert found, (path, begin)
    lines = found[0].splitlines()
    margin = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    return "\n".join(line[margin:] for line in lines).rstrip()


def field() -> str:
    page = (ROOT / "generated/markdown/docs/fields/sensor/scaled_gyro.md").read_text("utf-8")
    table = re.findall(r"^\| .*\|$", page, re.M)[:3]
    row = re.sub(r'<a id="[^"]*"></a>', "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", "\n".join(table)))
    python = part("generated/python/mip_protocol/sensor.py", r"    scaled_gyro: ", r'"""')
    c = part("generated/c/src/mip/sensor.h", r"struct mip_sensor_scaled_gyro \{", r"\};")
    rust = part("generated/rust/src/sets/sensor.rs", r"    pub struct ScaledGyro \{", "    }")
    yaml = part("spec/sets/sensor.yaml", r"  - data: 0x05", r"axis\.\}")
    blocks = (
        ("`spec/sets/sensor.yaml`", "yaml", yaml),
        ("C, `mip/sensor.h`", "c", c),
        ("Python, `mip_protocol.sensor.ScaledGyro`", "py", python),
        ("Rust, `mip_protocol::sensor`", "rust", rust),
    )
    shown = "\n\n".join(f"{title}:\n\n```{language}\n{text}\n```" for title, language, text in blocks)
    return f"{shown}\n\n[Its page](generated/markdown/docs/fields/sensor/scaled_gyro.md):\n\n{row}\n"


#: What docs/pictures/field.png shows: the beginning of this page, in this style.
SHOWN, STYLE = "generated/markdown/docs/fields/sensor/scaled_accel.md", "runtime/markdown/docs/assets/site.css"
NOTED = ROOT / "docs/pictures/field.sha256"


def shown() -> str:
    page = (ROOT / SHOWN).read_text("utf-8").partition("\n## Try it\n")[0]
    return hashlib.sha256((page + (ROOT / STYLE).read_text("utf-8")).encode()).hexdigest() + "\n"


def main() -> None:
    if "--pictures" in sys.argv:
        NOTED.write_text(shown(), "utf-8")
    elif "--check" in sys.argv and NOTED.read_text("utf-8") != shown():
        sys.exit(f"docs/pictures/field.png shows an older {SHOWN}; run: make pictures")
    text = PAGE.read_text("utf-8")
    before, _, rest = text.partition(BEGIN)
    after = rest.partition(END)[2]
    written = f"{before}{BEGIN}\n{field()}\n{END}{after}"
    if written != text:
        if "--check" in sys.argv:
            sys.exit("README.md does not show the field as it is generated; run: make first-page")
        PAGE.write_text(written, "utf-8")


if __name__ == "__main__":
    main()
