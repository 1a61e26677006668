"""Every fact about every field, parameter, value and bit is documented, at the very item."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from mipgen import model as m
from mipgen.facts import comments, describe
from mipgen.targets.python import docs, names
from support import SPECS, all_fields, model

say = docs.COMMENTS.say


def plain(text: str) -> str:
    """A text in which each white space is one blank."""
    return " ".join(text.split())


@cache
def documentation(path: Path) -> dict[str, str]:
    """The docstrings of a module by name ("Ping", "Settings.port"); what is on the wire only by "Path#num_points"."""
    source = path.read_text("utf-8")
    tree = ast.parse(source)
    found = dict(_attributes("", tree.body))
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = plain(ast.get_docstring(node) or "")
            found |= _attributes(f"{node.name}.", node.body)
            lines = "\n".join(source.splitlines()[node.lineno : node.end_lineno])
            comments = plain(" ".join(re.findall(r"^    # ?(.*)", lines, re.M)))
            for name, text in re.findall(r"On the wire only: (\w+)\. (.*?)(?=On the wire only: |$)", comments):
                found[f"{node.name}#{name}"] = text.strip()
    return found


def _attributes(owner: str, body: list[ast.stmt]) -> Iterator[tuple[str, str]]:
    for node, behind in zip(body, [*body[1:], ast.Pass()]):
        target = (
            node.targets[0] if isinstance(node, ast.Assign) else node.target if isinstance(node, ast.AnnAssign) else 0
        )
        if isinstance(target, ast.Name):
            documented = isinstance(behind, ast.Expr) and isinstance(behind.value, ast.Constant)
            yield owner + target.id, plain(str(behind.value.value)) if documented else ""  # type: ignore[attr-defined]


def texts(of: m.Model) -> Iterator[tuple[str, str, str]]:
    """Module, name in it, and a text that must be there."""
    for f in all_fields(of):
        yield from _about(f, [f"{f.title} ({comments.descriptors(f)}).", *_prose(f.description, f, of)])
        yield from _about(f, _sentences(describe.in_code(f, of), f))
        yield from _about(f, describe.sources(f))
        yield from _parameters(f, of)
    for t in (*of.all_types, of.protocol.function_selector):
        yield from _about(t, [*_prose(t.description, t, of), *_sentences(describe.type_facts(t, of), t)])
        match t:
            case m.Enum():
                for v in t.values:
                    yield from _about(
                        t, [*_prose(v.description, t, of), *_sentences(describe.value(v, of), t)], f".{v.name}"
                    )
            case m.Bitfield():
                for b in t.bits:
                    said = [*_prose(b.description, t, of), *_sentences(describe.bits(b, of), t)]
                    yield from _about(t, said, f".{b.name}")
            case m.Struct():
                yield from _parameters(t, of)
            case m.Vector():
                yield from _about(t, [f"Elements: {', '.join(t.elements)}."])
        if not isinstance(t, m.Vector):
            yield from _about(t, describe.sources(t))


def _parameters(record: m.Field | m.Struct, of: m.Model) -> Iterator[tuple[str, str, str]]:
    for p in record.parameters:
        holder = record
        for q in (p, *(c.parameter for c in p.cases if c.parameter)):
            said = [*_prose(q.description, holder, of), *_sentences(describe.parameter(q, holder, of), holder)]
            yield from _about(holder, said, f"#{p.name}" if p.derived else f".{p.name}")
        for c in p.cases:
            yield from _about(holder, [say(describe.case(c, p, holder).value, names.home(holder))], f".{p.name}")


def _about(thing: m.Field | m.Type, said: list[str], part: str = "") -> Iterator[tuple[str, str, str]]:
    if part.startswith("."):
        part = "." + (names.constant if isinstance(thing, (m.Enum, m.Bitfield)) else names.member)(part[1:])
    for text in said:
        yield names.home(thing), names.class_name(thing) + part, plain(text)


def _prose(text: str, thing: m.Field | m.Type, of: m.Model) -> list[str]:
    return [say(describe.prose(text, of), names.home(thing))] if text else []


def _sentences(facts: list[describe.Fact], thing: m.Field | m.Type) -> list[str]:
    return [say(fact.sentence, names.home(thing)) for fact in facts]


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_every_fact_is_documented_where_it_belongs(spec: str) -> None:
    package = SPECS[spec][1] / "python/mip_protocol"
    wanted = list(texts(model(spec)))
    missing = [
        f"{module}.{name}: {text}"
        for module, name, text in wanted
        if text not in documentation(package / f"{module}.py")[name]
    ]
    assert not missing, "\n".join(missing[:20])
    assert len(wanted) > {"real": 4000, "invented": 300}[spec]


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_every_device_is_documented(spec: str) -> None:
    of = model(spec)
    text = plain((SPECS[spec][1] / "python/mip_protocol/devices.py").read_text("utf-8"))
    for d in of.devices:
        said = say(describe.prose(d.description, of), "devices")
        said += "".join(f" {say(x.sentence, 'devices')}" for x in describe.device(d, of))
        sources = "".join(f" - {s}" for s in describe.sources(d))
        assert plain(f'"""{said}{sources}') in text, d.id


def test_references_are_names_of_python() -> None:
    package = SPECS["invented"][1] / "python/mip_protocol"
    tools, sensors = documentation(package / "tools.py"), documentation(package / "measurements.py")
    assert tools["SetTimeSlowResponse"] == (
        "Set time response (0x01,0x84). Response to `SetTime`. Sent if `part` is `types.Mode.SLOW`. Supported by Model "
        "A and Model C. - guide: Set time"
    )
    assert tools["Settings.mode"] == (
        "What to do. Default: `types.Mode.FAST`. Required for `write`, `read` and `apply`. "
        "- On the Model C: only `types.Mode.DEFAULT` and `types.Mode.FAST`; not deprecated."
    )
    assert tools["Circle.filling"] == (
        "How it is filled. Selected by `fill`. - If `fill` is `Fill.EMPTY`: `None`. "
        "- If `fill` is `Fill.SOLID`: `int`. A colour. - If `fill` is `Fill.STRIPED`: `Stripes`."
    )
    assert "z: `types.StateFlags.HOT` of `valid_flags`. " in sensors["Accel.scaled_accel"]
    assert "Occurs in measurements (0x80), more (0x81) and copy (0x92)." in sensors["Accel"]


def test_the_text_of_a_set() -> None:
    of = model("invented")
    x = replace(of.families[0], description="As `tools.ping`.", uncertain=("How `mode` is.",))
    docstring = docs.docstring(docs.COMMENTS.family(x, of))
    assert ast.literal_eval(docstring) == "Tools (0x01).\n\nAs `Ping`.\n\nUncertain: How `types.Mode` is.\n"
