"""The package mip_msgs: the content of its files, and, with rosbags, that they are messages."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.ros2 import names
from mipgen.targets.ros2.view import data_fields
from support import SPECS, heavy, model

specs = pytest.mark.parametrize("spec", sorted(SPECS))
MEMBER = re.compile(r"(\w+(?:/\w+)?)(\[(?:<=)?\d*\])? ([a-z][a-z0-9_]*)")
CONSTANT = re.compile(r"u?int\d+ ([A-Z](?:[A-Z0-9_]?[A-Z0-9]+)*)=-?\d+")


def folder(spec: str) -> Path:
    return SPECS[spec][1] / "ros2"


@specs
def test_each_data_field_is_a_message(spec: str) -> None:
    of = model(spec)
    data = data_fields(of)
    made = {path.stem for path in (folder(spec) / "msg").iterdir()}
    assert {names.message(f) for f in data} <= made and all(re.fullmatch(r"[A-Z][A-Za-z0-9]*", name) for name in made)
    listed = set(re.findall(r"msg/(\w+)\.msg", (folder(spec) / "CMakeLists.txt").read_text()))
    assert listed == made
    for f in data:
        text = (folder(spec) / "msg" / f"{names.message(f)}.msg").read_text("utf-8")
        assert text.startswith(f"# {f.full_name}: ") and "\nstd_msgs/Header header\n" in text
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        assert all(MEMBER.fullmatch(line) or CONSTANT.fullmatch(line) for line in lines), lines
        said = " ".join(text.replace("\n# ", " ").split())
        for p in f.parameters:
            if p.derived or p.union:
                continue
            assert re.search(rf" {names.member(p.name)}\b", text)
            for topic in ("unit", "range", "valid", "variant"):
                for fact in describe.topics(describe.parameter(p, f, of), topic):
                    assert " ".join(describe.say(fact.sentence, lambda ref: ref.words).split()) in said.replace("`", "")


@specs
def test_values_and_bits_are_constants(spec: str) -> None:
    for f in data_fields(model(spec)):
        text = (folder(spec) / "msg" / f"{names.message(f)}.msg").read_text("utf-8")
        for p in f.parameters:
            kind = p.leaf.named
            if isinstance(kind, m.Enum) and not p.derived:
                assert all(f" {names.constant(p, v.name)}={v.value}\n" in text for v in kind.values)


@specs
def test_the_manifest(spec: str) -> None:
    package = ElementTree.parse(folder(spec) / "package.xml").getroot()
    assert package.findtext("name", "").endswith("_msgs") and package.findtext("license") == "MIT"
    assert {x.text for x in package.iter("depend")} == {"std_msgs"}
    assert (folder(spec) / "LICENSE").is_file()


@heavy("rosbags")
@specs
def test_they_are_messages(spec: str) -> None:
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    store, types = get_typestore(Stores.ROS2_HUMBLE), {}
    for path in sorted((folder(spec) / "msg").iterdir()):
        types |= get_types_from_msg(path.read_text("utf-8"), f"mip_msgs/msg/{path.stem}")
    store.register(types)
    for f in data_fields(model(spec)):
        members = dict(types[f"mip_msgs/msg/{names.message(f)}"][1])
        assert next(iter(members)) == "header"
        wanted = [names.member(q.name) for p in f.parameters if not p.derived for q in p.alternatives or (p,)]
        assert list(members)[1:] == wanted
        store.generate_msgdef(f"mip_msgs/msg/{names.message(f)}")
