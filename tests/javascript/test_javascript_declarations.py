"""Every fact that `describe` knows of fields, parameters, values and bits is in the declarations."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.javascript import blocks, names, view
from support import SPECS, model, small

say = view.COMMENTS.say


@cache
def words(path: Path) -> str:
    """A file without line breaks and the margins of comments."""
    return re.sub(r"\s+", " ", re.sub(r"^ *(\*/|\*|/\*\*) ?", " ", path.read_text("utf-8"), flags=re.M))


def declared(spec: str, thing: m.Type | m.Field) -> tuple[str, str]:
    """The text between the declaration before and this one, with its comment; and its body."""
    text = words(SPECS[spec][1] / f"javascript/{names.home(thing)}.d.mts")
    kind = {"enum": "declare const", "bitfield": "declare const", "vector": "type", "struct": "interface"}
    head = kind.get(getattr(thing, "kind", ""), "declare class")
    found = re.search(rf"export {head} {names.class_name(thing)}\b", text)
    assert found, thing.name
    end = text.find(" export ", found.end())
    begin = max(text.rfind(" export ", 0, found.start()), 0)
    return text[begin : found.start()], text[found.end() : end if end > 0 else None]


def sentences(facts: Iterable[describe.Fact], where: str) -> list[str]:
    return [re.sub(r"\s+", " ", say(fact.sentence, where)) for fact in facts]


@small("declarations of the real modules")
def test_every_fact_of_a_field_is_declared(spec: str) -> None:
    of, seen = model(spec), 0
    for f in of.fields:
        comment, body = declared(spec, f)
        wanted = [f.title, *sentences(describe.in_code(f, of), names.home(f)), *describe.sources(f)]
        missing = [s for s in wanted if s not in comment]
        for p in f.parameters:
            found = sentences(describe.parameter(p, f, of), names.home(f))
            missing += [f"{p.name}: {s}" for s in found if s not in body]
            seen += len(found)
            if not p.derived:
                line = f" {view.declared(p, names.home(f), p.name in f.present_with)};"
                missing += [] if line in body else [line]
        assert not missing, f"{f.full_name}: {missing}"
    assert seen > 100


@small("declarations of the real modules")
def test_every_fact_of_a_type_is_declared(spec: str) -> None:
    of = model(spec)
    for t in (t for t in of.all_types if not isinstance(t, m.Vector)):
        comment, body = declared(spec, t)
        where = names.home(t)
        missing = [s for s in sentences(describe.type_facts(t, of), where) if s not in comment]
        if isinstance(t, m.Struct):
            missing += [
                s for p in t.parameters for s in sentences(describe.parameter(p, t, of), where) if s not in body
            ]
        parts = t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()
        for part in parts:
            missing += [] if f" readonly {blocks.object_key(names.constant(part.name))}: " in body else [part.name]
            facts = describe.value(part, of) if isinstance(part, m.EnumValue) else describe.bits(part, of)
            missing += [s for s in sentences(facts, where) if s not in body]
        assert not missing, f"{t.name}: {missing}"
