"""docs/architecture.md is true: what it names exists, and it names what exists."""

from __future__ import annotations

import re

from support import ROOT

TEXT = (ROOT / "docs/architecture.md").read_text("utf-8")
GENERATOR = ROOT / "generator/mipgen"


def table(heading: str) -> list[list[str]]:
    """The rows of the first table below a heading."""
    rows = re.findall(r"^\|.*\|$", TEXT.partition(f"\n## {heading}\n")[2].partition("\n## ")[0], re.M)
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows[2:]]


def test_modules() -> None:
    rooms = {p.name for p in GENERATOR.iterdir() if (p / "__init__.py").exists()}
    there = {
        str(p.relative_to(GENERATOR).with_suffix(""))
        for room in rooms - {"targets"}
        for p in (GENERATOR / room).glob("*.py")
    }
    there = {name for name in there if not name.endswith("/__init__")} | {"targets/<name>"}
    named = [
        f"{row[0].strip('`')}/{name}" for row in table("Who knows what") for name in re.findall(r"`(.*?)`", row[1])
    ]
    assert sorted(named) == sorted(there)


def test_paths() -> None:
    """Files and folders, with the target that has them for <name>."""
    paths = set(re.findall(r"`((?:spec|tests|templates|generated|docs)/[\w./<>-]*)`", TEXT))
    assert len(paths) > 5
    for path in paths:
        assert list(ROOT.glob(path.replace("<name>", "*"))), path
    for link in re.findall(r"\]\((.*?)\)", TEXT):
        assert (ROOT / "docs" / link.partition("#")[0]).exists(), link


def test_the_way_of_a_fact() -> None:
    """The example agrees with the outputs."""
    c = (ROOT / "generated/c/src/mip/base.h").read_text("utf-8")
    python = (ROOT / "generated/python/mip_protocol/base.py").read_text("utf-8")
    rust = (ROOT / "generated/rust/src/sets/base.rs").read_text("utf-8")
    markdown = (ROOT / "generated/markdown/docs/fields/base/comm_speed.md").read_text("utf-8")
    assert re.search(
        r"mip_base_comm_speed_write\(\s*struct mip_base_comm_speed \*command,\s*uint8_t port,\s*uint32_t baud\)", c
    )
    assert re.search(r"mip_base_comm_speed_read\(\s*struct mip_base_comm_speed \*command,\s*uint8_t port\)", c)
    own = python.partition("\nclass CommSpeed(")[2].partition("\nclass ")[0]
    assert re.search(r"def write\(\s*cls(: [^,]*)?, port: int, baud: int\s*\)", own)
    assert re.search(r"def read\(\s*cls(: [^,]*)?, port: int\s*\)", own)
    assert "\n    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}" in own and "Required for `write`." in own
    own = rust.partition("pub struct CommSpeed ")[2].partition("record!")[0]
    assert "[baud for WRITE]" in own and "fn write(port: u8, baud: u32)" in own and "fn read(port: u8)" in own
    own = re.sub(r'<a id="[^"]*"></a>', "", markdown)
    assert re.search(r"\| `write` \(W, 0x01\) \| `[0-9A-F ]*` \| `port`, `baud` \| 8 \| acknowledge \|", own)
    assert re.search(r"\| 2 \| 4 \| `baud` \| `u32` \| [^|]* \| `write` \| Bd \|", own)
