"""The behavior of virtual devices, as data for tools: one line for each field."""

from __future__ import annotations

import json
from typing import Any

from mipgen import model as m
from mipgen.model.simulation import Behavior, Source, Value


def document(model: m.Model) -> str:
    """Writes the text of `simulation.json`; empty parts are omitted."""
    simulation = model.simulation
    shown = {s.field.full_name if s.set is None else s.field.name_in(s.set): s for s in simulation.sources}
    parts: dict[str, dict[str, Any]] = {
        "functions": {f.letter: f.value for f in model.protocol.functions},
        "noise": {q.name: dict(q.noise) for q in simulation.quantities if q.noise},
        "values": {name: _source(s) for name, s in shown.items()},
        "commands": {b.command.full_name: _behavior(b) for b in simulation.behaviors},
    }
    return "{\n" + ",\n".join(f"  {_json(name)}: {_lines(part)}" for name, part in parts.items()) + "\n}\n"


def _lines(part: dict[str, Any]) -> str:
    rows = [f"    {_json(name)}: {_json(value)}" for name, value in part.items()]
    return "{\n" + ",\n".join(rows) + "\n  }" if rows else "{}"


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


def _source(s: Source) -> dict[str, Any]:
    entry = {"for_each": s.for_each, "valid_if": s.valid_if, "parameters": {v.path: _value(v) for v in s.values}}
    return {k: x for k, x in entry.items() if x}


def _value(v: Value) -> dict[str, Any]:
    entry = {"quantity": v.quantity, "factor": v.factor if v.factor != 1 else None, "names": v.names, "bits": v.bits}
    return {k: x for k, x in entry.items() if x} | {
        k: x for k, x in (("number", v.number), ("text", v.text), ("parameter", v.parameter or None)) if x is not None
    }


def _behavior(b: Behavior) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "effect": b.effect,
        "arguments": dict(b.arguments),
        "all": dict(b.all),
        "writes_all": b.writes_all,
        "instances": dict(b.instances),
        "translate": {name: dict(pairs) for name, pairs in b.translate},
        "setting": b.setting,
        "key": dict(b.key),
        "initial": dict(b.initial),
        "once": b.once,
        "affected": b.affected,
        "answers": dict(b.answers),
    }
    return {k: x for k, x in entry.items() if x}
