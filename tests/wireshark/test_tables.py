"""What can be tested of the dissector without tshark: names, and what must not become one name."""

from __future__ import annotations

from pathlib import Path

import pytest
from mipgen.emit import naming
from mipgen.read.problems import Problems
from mipgen.resolve.load import load_model
from mipgen.targets import wireshark
from support import SPECS, model

SET = """
set: 0x70
name: collisions
title: Collisions
description: Names that become one filter.
fields:
  - command: 0x01
    name: place
    title: Place
    description: A place.
    parameters:
      - {name: place, type: vector3f, unit: m, description: Where.}
      - {name: OTHER, type: u8, description: Another.}
"""


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_filters_are_names_of_the_specification(spec: str) -> None:
    names = [i.name for i in wireshark.identifiers(model(spec))]
    assert len(set(names)) == len(names)
    for f, o in ((x, o) for x in model(spec).fields for o in x.occurrences):
        own = f"mip.{f.name_in(o.set)}"
        assert any(name == own or name.startswith(f"{own}.") for name in names)


@pytest.mark.parametrize(("name", "collides"), [("x", True), ("size", False)])
def test_collisions_are_reported(name: str, collides: bool, tmp_path: Path) -> None:
    mine = tmp_path / "mine"
    (mine / "sets").mkdir(parents=True)
    (mine / "sets/collisions.yaml").write_text(SET.replace("OTHER", name), "utf-8")
    problems = Problems()
    naming.collisions("wireshark", wireshark.identifiers(load_model(SPECS["invented"][0], mine)), problems)
    assert any("mip.collisions.place.x" in str(problem) for problem in problems.sorted()) == collides
    assert bool(problems) == collides
