"""Words into identifiers, and the doctests of all modules of the generator."""

from __future__ import annotations

import doctest
import importlib
import pkgutil
from collections.abc import Callable

import mipgen
import pytest
from mipgen.emit.naming import Escape, Grammar, Identifier, collisions, judge, pascal, upper
from mipgen.read.problems import Position, Problems
from mipgen.targets.javascript import names as javascript
from mipgen.targets.python import names as python

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


def test_collisions_name_both_and_point_at_the_second() -> None:
    problems = Problems()
    collisions(
        "c",
        [
            Identifier("module a", "Port1", "a.port_1", Position("a.yaml", 1, 1)),
            Identifier("module b", "Port1", "b.port_1", Position("b.yaml", 1, 1)),
            Identifier("module a", "Port1", "a.port1", Position("a.yaml", 5, 3)),
        ],
        problems,
    )
    assert [str(p) for p in problems.sorted()] == [
        "a.yaml:5:3: error: 'a.port1' and 'a.port_1' both become Port1 in module a of the target c; rename one"
    ]


@pytest.mark.parametrize("name", ["", "1st", "a-b", "a b", "été", "a\n"])
def test_a_name_that_is_no_identifier(name: str) -> None:
    problems = Problems()
    place = Position("a.yaml", 5, 3)
    judge("c", [Identifier("C", name, "set.field", place)], Grammar(r"[a-z]\w*"), problems)
    assert [str(p) for p in problems.sorted()] == [
        f"a.yaml:5:3: error: 'set.field' becomes '{name}' in C; this is not an identifier in the target c: rename it, "
        "or let the target escape it"
    ]


def test_names_of_other_things_than_the_language_has() -> None:
    problems = Problems()
    judge("c", [Identifier("files", "3dm", "set 3dm", None, word=False)], Grammar(r"[a-z]\w*", longest=2), problems)
    assert not problems


def test_names_that_begin_alike_for_too_long_are_reported_once_for_each_thing() -> None:
    place = Position("a.yaml", 5, 3)
    names = [Identifier("C", "a" * n, "set.field", place) for n in (63, 64, 66, 65)]

    def judged(identifiers: list[Identifier], longest: int | None) -> list[str]:
        problems = Problems()
        judge("c", identifiers, Grammar(r"a+", longest=longest), problems)
        return [str(p) for p in problems.sorted()]

    assert judged(names[2:3], 63) == judged(names, 66) == judged(names, None) == []
    assert judged(names[1:], 63) == [
        f"a.yaml:5:3: error: 'set.field' becomes {'a' * 66}, and the target c distinguishes only the first 63 "
        f"characters, which are also those of {'a' * 64}; use 'short' to define a shorter name for it or its parent"
    ]
