"""The verdicts of cargo-semver-checks on the crate.

Each test makes two crates from the invented specification. Adding something must be a minor version, removing it a
major one, as docs/versions.md promises. If there is a release, the crate as it is now is compared with that, and the
version must have been raised far enough.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest
from crates import WORK, without_dependencies
from mipgen.emit import output, render
from mipgen.resolve.load import load_model
from support import BUILD, ROOT, SPECS, locked, need, nightly

pytestmark = nightly("cargo-semver-checks")
TOOLS = BUILD / "tools/bin"

SET = """# yaml-language-server: $schema=../../../../spec/schema/set.schema.json
set: 0x84
name: extra
title: Extra
description: A set more.
fields:
  - data: 0x01
    name: one
    title: One
    description: A field.
    parameters: [{name: mode, type: mode, description: Of the set.}]
"""

DEVICE = """# yaml-language-server: $schema=../../../../spec/schema/device.schema.json
device: model-d
name: model_d
title: Model D
manual: guide
description: Another one.
supports: {tools: [ping]}
base_rates: {}
incomplete: [Its acknowledge codes are not known.]
"""

OWN = "parameters: [{name: mode, type: mode, description: Of the second sensor.}]\n"
FIELD = (SET.partition("fields:\n")[2]).replace("0x01", "0x0B").replace("name: one", "name: another")

Change = tuple[str, str, str]  #: file, old text, new text; a file that is new has no old text

#: What can be added.
ADDITIONS: dict[str, list[Change]] = {
    "field": [("sets/measurements.yaml", OWN, OWN + FIELD)],
    "set": [("sets/extra.yaml", "", SET)],
    "device": [("devices/model_d.yaml", "", DEVICE)],
    "value": [("types/types.yaml", "slow: {value: 2,", "idle: {value: 3, description: N.}\n      slow: {value: 2,")],
    "bit": [("types/types.yaml", "level: {bit: 4-6,", "cold: {bit: 2, description: C.}\n      level: {bit: 4-6,")],
    "alternative": [
        ("sets/tools.yaml", "solid: 1, striped: 2}", "solid: 1, striped: 2, dotted: 3}"),
        ("sets/tools.yaml", "striped: {type: stripes}}",
         "striped: {type: stripes}, dotted: {type: u8, description: D.}}"),
    ],
}  # fmt: skip

#: Without those that bring dependencies.
FEATURES = ("--default-features", "--features", "std", "--features", "dynamic")


@cache
def made(*names: str) -> Path:
    """The crate of the invented specification with these changes."""
    folder = WORK / "semver" / (" and ".join(names) or "none")
    spec = folder / "spec"
    with locked(WORK / "semver.made"):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(SPECS["invented"][0], spec)
        for file, old, new in (change for name in names for change in ADDITIONS[name]):
            text = (spec / file).read_text("utf-8") if old else ""
            at = text.rindex(old)
            (spec / file).write_text(text[:at] + new + text[at + len(old) :], "utf-8")
        files = without_dependencies(render.render("rust", load_model(spec)))
        output.write(files, folder / "crate")
    return folder / "crate"


def verdict(old: Path, new: Path, *arguments: str) -> tuple[bool, str]:
    """Is the new crate as compatible as the release type, or its version, says?"""
    command = [need("cargo"), "semver-checks", "--manifest-path", str(new / "Cargo.toml"), "--baseline-root", str(old)]
    path = f"{TOOLS}{os.pathsep}{os.environ['PATH']}"
    with locked(WORK / "semver.run"):
        done = subprocess.run(
            [*command, "--color=never", *arguments],
            capture_output=True, text=True, cwd=new, env={**os.environ, "PATH": path},
        )  # fmt: skip
    said = done.stdout + done.stderr
    assert "Checked [" in said, said[-4000:]
    return done.returncode == 0, said


#: What is added -> items of the crate that come with it, as the tool names them.
ITEMS = {
    "field": ("variant AnyField::MeasurementsAnother", "struct mip_protocol::measurements::Another"),
    "set": ("feature extra", "mod mip_protocol::extra", "variant AnyField::ExtraOne"),
    "device": ("MODEL_D",),
    "value": ("Mode::IDLE",),
    "bit": ("StateFlags::COLD", "StateFlags::set_cold"),
    "alternative": ("variant CircleFilling::Dotted", "Fill::DOTTED"),
}

MAJOR = "Summary semver requires new major version"


def test_additions_are_minor() -> None:
    fits, said = verdict(made(), made(*ADDITIONS), *FEATURES, "--release-type", "minor")
    assert fits, said


def test_each_removal_is_major() -> None:
    fits, said = verdict(made(*ADDITIONS), made(), *FEATURES, "--release-type", "minor")
    assert not fits and MAJOR in said, said
    assert ITEMS.keys() == ADDITIONS.keys()
    assert [item for items in ITEMS.values() for item in items if f"\n  {item}" not in said] == []


@pytest.fixture
def release(tmp_path: Path) -> Path | None:
    """The crate of the last release, if there is one."""
    command = ["git", "describe", "--tags", "--abbrev=0", "--match=v[0-9]*"]
    tag = subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout.strip()
    if not tag:
        return None
    archive = subprocess.run(
        ["git", "archive", tag, "generated/rust"], cwd=ROOT, capture_output=True, check=True
    ).stdout
    subprocess.run(["tar", "-x", "-C", tmp_path], input=archive, check=True)
    return tmp_path / "generated/rust"


def test_the_version_was_raised_far_enough(release: Path | None) -> None:
    if release is None:
        return  # nothing is released yet, so anything goes
    fits, said = verdict(release, ROOT / "generated/rust", "--all-features")
    assert fits, said
