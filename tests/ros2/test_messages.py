"""The package mip_msgs: the content of its files, and, with rosbags, that they are messages."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.ros2 import names
from mipgen.targets.ros2.view import data_fields, say
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
        said = words(text.replace("\n# ", " "))
        assert all(words(say(fact.sentence)) in said for fact in describe.caveats(f, of))
        for p in f.parameters:
            if p.derived or p.union:
                continue
            assert re.search(rf" {names.member(p.name)}\b", text)
            topics = ("unit", "range", "positive", "valid", "variant", "note", "uncertain")
            for fact in describe.topics(describe.parameter(p, f, of), *topics):
                assert words(say(fact.sentence)) in said


def words(text: str) -> str:
    return " ".join(text.split())


@specs
def test_values_and_bits_are_constants(spec: str) -> None:
    of = model(spec)
    for f in data_fields(of):
        text = (folder(spec) / "msg" / f"{names.message(f)}.msg").read_text("utf-8")
        for p in f.parameters:
            kind = p.leaf.named
            if isinstance(kind, m.Enum) and not p.derived:
                assert all(f" {names.constant(p.name, v.name)}={v.value}\n" in text for v in kind.values)
            for t in (v.type for v in p.readings):  # of each device, in order
                group = text.partition(f"{t.name}")[2]
                assert all(re.search(rf"_{x.name}(_BIT)?=\d+\n", group, re.I) for x in m.named_parts(t)), t.name
        assert [*map(int, re.findall(r"\bDESCRIPTOR_SET_\w+=(\d+)", text))] == sets(f, of)
        assert f.full_name != "filter_data.status" or "uint16 FILTER_STATE_CV7_FULL_NAV=4\n" in text


def sets(f: m.Field, of: m.Model) -> list[int]:
    """The numbers of the sets of a field that occurs in several."""
    found = [s.number for s in of.sets if s.number in f.sets]
    return found if len(found) > 1 else []


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
        assert list(members)[1:] == [*["descriptor_set"] * bool(sets(f, model(spec))), *wanted]
        store.generate_msgdef(f"mip_msgs/msg/{names.message(f)}")
