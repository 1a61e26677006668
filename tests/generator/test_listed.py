"""What a device lists itself: files that extend a device, in a specification or an overlay, and which evidence counts
if it is repeated."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from bad_spec_files import BASE
from mipgen import model as m
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import some

PORT = "{name: Main, id: 1, baud_rates: [9600], receives: [MIP], sends: [MIP]}"
DEVICES = f"""\
families:
  - family: relatives
    description: What they have.
    incomplete: [No manual is known.]
    supports: {{measurements: [accel]}}
    evidence:
      - {{kind: family, of: [model-a], fields: {{tools: [ping]}}}}
      - {{kind: documented, fields: {{tools: [settings]}}}}
    deprecated: {{tools.settings: use `tools.ping` instead}}
    functions: {{tools.settings: WR}}
    limits: [{{name: slots, value: 4, description: Number of slots.}}]
    base_rates: {{measurements: 100}}
    ports: [{PORT}]
devices:
  - {{device: cousin, name: cousin, title: Cousin, like: relatives}}
  - {{device: heir, name: heir, title: Heir, like: cousin}}
"""
LISTED = """\
extend: cousin
evidence:
  - kind: listed
    firmware: 1.0.01
    date: 2026-01-31
    fields: {tools: [ping, settings], measurements: [accel]}
    undefined: {tools: [0x6F], 0x3F: [0x01]}
base_rates: {measurements: 100}
"""


def loaded(folder: Path, extension: str, within: bool) -> m.Model:
    """A specification with a device file that extends one of its devices: its own file, or that of an overlay."""
    spec, over = folder / "spec", folder / "over"
    shutil.copytree(BASE, spec)
    (spec / "devices/relatives.yaml").write_text(DEVICES, "utf-8")
    file = (spec if within else over) / "devices/0_cousin.yaml"  # read before what it extends
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(extension, "utf-8")
    return load_model(spec, *([] if within else [over]))


def device(model: m.Model, device_id: str) -> m.Device:
    return some(model.device(device_id))


def kinds(d: m.Device) -> dict[str, str]:
    return {s.name: s.evidence.kind for s in (*d.supports, *d.refuses)}


@pytest.mark.parametrize("within", [False, True])
def test_the_strongest_evidence_counts(tmp_path: Path, within: bool) -> None:
    model = loaded(tmp_path, LISTED, within)
    cousin = device(model, "cousin")
    assert kinds(cousin) == {"tools.ping": "listed", "tools.settings": "documented", "measurements.accel": "documented"}
    (ping,) = (s.evidence for s in cousin.supports if s.name == "tools.ping")
    assert (ping.firmware, ping.date, ping.undefined) == ("1.0.01", "2026-01-31", ((0x01, 0x6F), (0x3F, 0x01)))
    assert [(r.set.name, r.hertz) for r in cousin.base_rates] == [("measurements", 100)]
    assert [p.name for p in cousin.ports] == ["Main"]


def test_what_a_device_lists_is_only_probable_of_those_that_are_like_it(tmp_path: Path) -> None:
    heir = device(loaded(tmp_path, LISTED, True), "heir")
    assert kinds(heir) == {"tools.ping": "sister", "tools.settings": "documented", "measurements.accel": "documented"}
    (settings,) = (s for s in heir.supports if s.name == "tools.settings")
    assert (settings.deprecated, m.letters(settings.functions)) == ("use `tools.ping` instead", "WR")
    assert [limit.name for limit in heir.limits] == ["slots"]
    (ping,) = (s.evidence for s in heir.supports if s.name == "tools.ping")
    assert (ping.of, ping.firmware, ping.date, ping.undefined) == (("cousin",), None, None, ())


def test_another_firmware_lists_again(tmp_path: Path) -> None:
    more = "  - {kind: listed, firmware: 1.0.02, fields: {tools: [ping]}, undefined: {tools: [0x6E]}}\n"
    refused = "  - {kind: refused, firmware: 1.0.00, fields: {tools: [ping]}}\n"
    text = LISTED.replace("base_rates", f"{refused}{more}base_rates")
    cousin = device(loaded(tmp_path, text, True), "cousin")
    (ping,) = (s.evidence for s in cousin.supports if s.name == "tools.ping")
    assert (ping.kind, ping.firmware) == ("listed", "1.0.01")
    assert [e.undefined for e in cousin.evidence if e.firmware == "1.0.02"] == [((0x01, 0x6E),)]  # not lost


@pytest.mark.parametrize("order", [("listed", "software"), ("software", "listed"), ("refused", "listed")])
def test_the_order_does_not_matter(tmp_path: Path, order: tuple[str, str]) -> None:
    more = "".join(f"  - {{kind: {kind}, fields: {{measurements: [accel]}}}}\n" for kind in order)
    text = OWN.format(rate=100, port=PORT).replace("supports: {measurements: [accel]}\n", f"evidence:\n{more}")
    assert kinds(both(tmp_path, text, "also: [P]\n")) == {"measurements.accel": "listed"}


OWN = """\
device: model-p
name: model_p
title: Model P
description: With ports.
incomplete: [Nothing is sure.]
supports: {{measurements: [accel]}}
base_rates: {{measurements: {rate}}}
ports: [{port}]
"""


def both(folder: Path, own: str, more: str) -> m.Device:
    for name, text in (("p.yaml", own), ("p_more.yaml", f"extend: model-p\n{more}")):
        (folder / "devices").mkdir(exist_ok=True)
        (folder / "devices" / name).write_text(text, "utf-8")
    return device(load_model(BASE, folder), "model-p")


def test_what_is_the_same_may_be_said_again(tmp_path: Path) -> None:
    second = PORT.replace("Main", "Other").replace("id: 1", "id: 2")
    more = f"base_rates: {{measurements: 100.0}}\nports: [{PORT}, {second}]\n"
    made = both(tmp_path, OWN.format(rate=100, port=PORT), more)
    assert [r.hertz for r in made.base_rates] == [100] and [p.id for p in made.ports] == [1, 2]


def test_a_rate_that_is_not_known_contradicts_none(tmp_path: Path) -> None:
    for one, other in (("~", "100"), ("100", "~")):
        made = both(tmp_path, OWN.format(rate=one, port=PORT), f"base_rates: {{measurements: {other}}}\n")
        assert [r.hertz for r in made.base_rates] == [100], (one, other)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ("base_rates: {measurements: 50}\n", "2:14: error: 'measurements' is already given at {own}:7:28; "),
        (
            f"ports: [{PORT.replace('[MIP]', '[MIP, NMEA]')}]\n",
            "2:9: error: the port 'Main' differs from its definition at {own}:8:9; make them equal",
        ),
    ],
)
def test_a_contradiction_names_both_places(tmp_path: Path, more: str, message: str) -> None:
    with pytest.raises(SpecError) as caught:
        both(tmp_path, OWN.format(rate=100, port=PORT), more)
    (problem,) = map(str, caught.value.problems)
    assert f"devices/p_more.yaml:{message.format(own=tmp_path / 'devices/p.yaml')}" in problem


def test_a_list_says_nothing_of_readings(tmp_path: Path) -> None:
    """A field whose values each device names may be listed without that; in a manual it may not."""
    spec = tmp_path / "spec"
    shutil.copytree(BASE, spec)
    sets = spec / "sets/measurements.yaml"
    own = "      - {name: state, type: u8, varies: device, description: Read by device.}\n"
    text = sets.read_text("utf-8").rstrip() + "\n  - data: 0x22\n    name: states\n    title: States\n"
    sets.write_text(text + f"    description: States.\n    parameters:\n{own}", "utf-8")
    file = spec / "devices/more.yaml"
    file.write_text("extend: model-a\nevidence: [{kind: listed, fields: {measurements: [states]}}]\n", "utf-8")
    assert kinds(device(load_model(spec), "model-a"))["measurements.states"] == "listed"
    file.write_text("extend: model-a\nsupports: {measurements: [states]}\n", "utf-8")
    with pytest.raises(SpecError, match=r"the meaning of 'measurements\.states\.state' is missing"):
        load_model(spec)
