"""The audit of a manual that is written here."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from audit.__main__ import main
from audit.manuals import audit_manuals
from support import ROOT, model

GOOD = """\
# A guide

See (0x01,0x02) and (0x80, 0xD3).

Copy-Paste version: "7565 0102 0201 E0C6"
The reply is 7565 0104 04F1 0200 D56A.

Command: Ping\t0x75\t0x65\t0x01\t0x02\t0x02\t0x01\tN/A\t0xE0\t0xC6
"""
SECTIONS = next(x.sections for x in model("invented").protocol.manuals if x.id == "guide")
GOOD += "".join(f"# {1 + i}. **{section}**\n" for i, section in enumerate(SECTIONS))


def findings(tmp_path: Path, text: str, manual: str = "guide") -> list[str]:
    path = tmp_path / "manual.txt"
    path.write_text(text, "utf-8")
    return [str(f) for f in audit_manuals(model("invented"), manual, path)]


def test_what_the_specification_has_is_no_finding(tmp_path: Path) -> None:
    assert findings(tmp_path, GOOD) == []


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("See (0x01,0x55).", "(0x01,0x55) is not defined, and no erratum reports this"),
        ("See (0x01.0x55).", "(0x01,0x55) is not defined, and no erratum reports this"),
        ("## Reset (0x01,0x7E)", "no field cites the heading Reset (0x01,0x7E)"),
        ("4.1.1 Ping again (0x01, 0x01)", "no field cites the heading Ping again (0x01, 0x01)"),
        ('"7565 0102 0203 E2C8"', "no example contains the string 7565 0102 0203 E2C8"),
        ("75650c03 030E80 7A7E", "no example contains the string 75650c03 030E80 7A7E"),
        ("Twice: 7565 0102 0201 E0C6", "no example contains the string 7565 0102 0201 E0C6"),
        ("X\t0x75\t0x65\t0x0C\t0x02\t0x02\t0x06", "no example has a table that begins 75 65 0C 02 02 06"),
    ],
)
def test_what_it_lacks_is_found(tmp_path: Path, line: str, message: str) -> None:
    found = findings(tmp_path, GOOD + line + "\n")
    assert f"manual.txt:{len(GOOD.splitlines()) + 1}: {message}" in found


def test_sections_are_those_of_the_manual(tmp_path: Path) -> None:
    without = "".join(line for line in GOOD.splitlines(True) if "Set time" not in line)
    assert findings(tmp_path, without) == ["manual.txt:1: the manual has no section 'Set time'"]
    assert findings(tmp_path, without + "set-time\n") == []


def test_a_section_of_a_page_comes_after_its_title(tmp_path: Path) -> None:
    manuals = tuple(replace(x, sections=("Events > Setup",)) for x in model("invented").protocol.manuals)
    paged = replace(model("invented"), protocol=replace(model("invented").protocol, manuals=manuals))

    def found(text: str) -> list[str]:
        (tmp_path / "manual.txt").write_text(text, "utf-8")
        return [f"{f.line}: {f.message}" for f in audit_manuals(paged, "leaflet", tmp_path / "manual.txt")]

    assert found("# Setup\n# Events\n## Setup\n") == []
    assert found("# Setup\n# Events\n") == ["2: the manual has no section 'Events > Setup'"]
    assert found("## Setup\n") == ["1: the manual has no section 'Events > Setup'"]


def test_an_erratum_explains_an_undefined_reference(tmp_path: Path) -> None:
    assert findings(tmp_path, "See (0x01,0x7F).\n", "leaflet") == []
    assert len(findings(tmp_path, GOOD + "See (0x01,0x7F).\n", "guide")) == 1


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec, path = str(ROOT / "tests/invented/spec"), tmp_path / "manual.txt"
    path.write_text(GOOD, "utf-8")
    assert main(["--spec", spec, "--manual", f"guide={path}"]) == 0
    assert capsys.readouterr().out == "0 findings\n"
    path.write_text("(0x01,0x55)\n", "utf-8")
    assert main(["--spec", spec, "--manual", f"guide={path}"]) == 1
    assert main(["--spec", spec, "--manual", f"giude={path}"]) == 1
    assert "did you mean 'guide'?" in capsys.readouterr().err
    assert main(["--spec", spec, "--manual", "guide=/no/such"]) == 1
    assert "no such file" in capsys.readouterr().err
