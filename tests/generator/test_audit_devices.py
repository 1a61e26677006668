"""The comparison with facts about other devices; the facts are made up here."""

from __future__ import annotations

from pathlib import Path

import pytest
from mipgen.audit.devices import audit
from mipgen.read.problems import SpecError
from support import model

INVENTED = model("invented")

MODELS = """\
models:
  - {name: Old 1, number: 4001, generation: 1, also: First}
  - {name: Model C, number: 4713, generation: 3}
"""

DEVICES = """\
devices:
  old-1:
    model_number: {value: 4001, source: models.yaml}
    commands: {0x01: {seen: [0x01, 0x7E]}}
    data: {0x80: {inferred: [0x02]}}
  model-c:
    model_number: {a: 4713, source: models.yaml}
    commands: {0x01: {seen: [0x02], contents: [0x03, 0x0C]}}
    base_rates: {0x80: 1000, 0x81: {value: 250, source: guide}, printed: {0x80: 5}}
"""


def findings(folder: Path, models: str = MODELS, devices: str = DEVICES) -> list[str]:
    (folder / "models.yaml").write_text(models)
    (folder / "devices.yaml").write_text(devices)
    return [str(f) for f in audit(INVENTED, folder)]


def test_what_agrees(tmp_path: Path) -> None:
    """Descriptors without a layout are not findings: no device can list them."""
    assert findings(tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("number: 4001,", "number: 4009,", "models.yaml:2: no device has the model number 4009"),
        ("name: Old 1", "name: Older", "models.yaml:2: old-1 is not called 'Older'"),
        ("also: First", "also: Second", "models.yaml:2: old-1 is not called 'Second'"),
        ("generation: 3", "generation: 4", "models.yaml:3: model-c is generation 3 in the specification"),
        ("value: 4001", "value: 4009", "devices.yaml:2: no device has the model number 4009"),
        ("seen: [0x01, 0x7E]", "seen: [0x03]", "devices.yaml:4: old-1 does not support (0x01,0x03)"),
        ("inferred: [0x02]", "seen: [0x02]", "devices.yaml:5: old-1 does not support (0x80,0x02) for certain"),
        ("inferred: [0x02]", "inferred: [0x03]", "devices.yaml:5: old-1 does not support (0x80,0x03)"),
        ("contents: [0x03, 0x0C]", "contents: [0x08]", "devices.yaml:8: model-c does not support (0x01,0x08)"),
        ("0x80: 1000", "0x80: 500", "devices.yaml:9: model-c has base rate 1000 for set 0x80 in the specification"),
        ("value: 250", "value: 500", "devices.yaml:9: model-c has base rate 250 for set 0x81 in the specification"),
    ],
)
def test_what_differs(tmp_path: Path, old: str, new: str, message: str) -> None:
    assert findings(tmp_path, MODELS.replace(old, new), DEVICES.replace(old, new)) == [message]


def test_a_device_known_by_its_name_only(tmp_path: Path) -> None:
    row, other = "{name: Old 1, number: 4001, generation: 1, also: First}", "{name: Old 3, number: 4003, generation: 1"
    facts = DEVICES.replace("value: 4001", "value: 4003")
    assert findings(tmp_path, MODELS.replace(row, f"{other}, also: Third}}"), facts) == []
    assert findings(tmp_path, MODELS.replace(row, f"{other}, also: Fourth}}"), facts) == [
        "models.yaml:2: old-3 is not called 'Fourth'"
    ]


def test_files(tmp_path: Path) -> None:
    assert audit(INVENTED, tmp_path) == []
    (tmp_path / "models.yaml").write_text("models: [\n")
    with pytest.raises(SpecError, match="not closed"):
        audit(INVENTED, tmp_path)
