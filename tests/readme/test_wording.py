"""`tests/wording.py`, which `make check` runs, finds what it should."""

from __future__ import annotations

from pathlib import Path

import pytest
import wording


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("- description: Where the data comes from.\n", "is a question"),
        ("- {data: 1, description: A level; it may be 0.}\n", "divide it into sentences"),
        ("- {command: 1, description: The level of the tank.}\n", "begins with a verb"),
        ("- notes:\n    - fine\n    - The manual\n      gives it.\n", "“gives”"),
        ("- {command: 1, description: Sets it., notes: [It takes effect.], section: What it says}\n", ""),
    ],
)
def test_what_it_sees(text: str, found: str, tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(text, "utf-8")
    findings = list(wording.findings(tmp_path / "a.yaml"))
    assert len(findings) == bool(found) and all(found in x for x in findings)
    assert wording.main([str(tmp_path)]) == bool(found)
