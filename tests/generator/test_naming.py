"""Words into identifiers, and the doctests of all modules of the generator."""

from __future__ import annotations

import doctest
import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import replace

import mipgen
import pytest
from mipgen.emit import package
from mipgen.emit.naming import Escape, Grammar, Identifier, judge, pascal, upper
from mipgen.read.problems import Problems
from mipgen.resolve import checks
from mipgen.targets.javascript import names as javascript
from mipgen.targets.python import names as python
from support import model

MODULES = [m.name for m in pkgutil.walk_packages(mipgen.__path__, "mipgen.") if m.name != "mipgen.__main__"]


def test_doctests() -> None:
    results = {name: doctest.testmod(importlib.import_module(name)) for name in MODULES}
    assert [name for name, result in results.items() if result.failed] == []
    assert sum(result.attempted for result in results.values()) >= 10


@pytest.mark.parametrize(
    ("words", "camel"),
    [
        ("ping", "Ping"), ("gps_time_update", "GpsTimeUpdate"), ("gnss_1", "Gnss1"), ("gnss1", "Gnss1"),
        ("3dm", "3dm"), ("axis_1_2", "Axis1_2"), ("a_b_c", "ABC"), ("vector3f", "Vector3f"), ("x_3d_point", "X3dPoint"),
    ],
)  # fmt: skip
def test_cases(words: str, camel: str) -> None:
    assert pascal(words) == camel
    assert upper(words) == words.upper()


def test_pascal_keeps_numbers_apart() -> None:
    assert pascal("port_1_12") != pascal("port_11_2")


def test_escape() -> None:
    escape = Escape(frozenset({"class", "n3"}), suffix="_", digit_prefix="n")
    assert [escape(n) for n in ("class", "classes", "3d", "3")] == ["class_", "classes", "n3d", "n3_"]


@pytest.mark.parametrize(
    ("legal", "taken", "free"),
    [
        # a module of the runtime, a function of the package, a name where all sets are imported, a class
        (python.module, ["streaming", "checksum", "bytes", "class"], ["filter", "sensor"]),
        (python.legal_class, ["Sequence", "ResponseClasses", "NamedTuple"], ["Sensor"]),
        (javascript.module, ["registry", "tcp", "session"], ["class", "sensor"]),
        (javascript.namespace, ["registry", "class"], ["sensor"]),
        (javascript.member, ["packet", "replies"], ["length"]),
        (javascript.legal_class, ["Values", "FunctionSelector"], ["Sensor"]),
    ],
)
def test_names_of_the_runtime_are_escaped(legal: Callable[[str], str], taken: list[str], free: list[str]) -> None:
    assert [legal(name) for name in taken] == [f"{name}_" for name in taken]
    assert [legal(name) for name in free] == free


@pytest.mark.parametrize(
    "text",
    [
        "mip_x", "a mip-x", "Mip", "MIP_X", "the mip here", "mip_tools_x",
        "MIP packets", "mip_tools", "mip-tools", "mip_simulator", "mipmap", "gmip_x",
    ],
)  # fmt: skip
def test_values_that_a_package_would_change_are_refused(text: str) -> None:
    changed = package.everywhere(text, "a_b") != text
    of = model("invented")
    device = replace(of.devices[0], also=(text,), notes=())
    problems = Problems()
    checks.check_package(replace(of, protocol=replace(of.protocol, package="a_b"), devices=(device,)), problems)
    assert [p.message.partition(" contains ")[0] for p in problems.sorted()] == [repr(text)] * changed


def test_names_of_other_things_than_the_language_has() -> None:
    problems = Problems()
    judge("c", [Identifier("files", "3dm", "set 3dm", None, word=False)], Grammar(r"[a-z]\w*", longest=2), problems)
    assert not problems
