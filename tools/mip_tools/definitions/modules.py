"""Fills each module of the package."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .commands import Fields
from .document import Document, Item


def _fill(module: Any, **content: Any) -> None:
    vars(module).update(content)


def of_set(document: Document, module: Any) -> None:
    """Fills the module of a family of descriptor sets. Responses are first, because commands refer to them."""
    home, made = module.__name__.rpartition(".")[2], Fields(document, module)
    for t in document.content["types"]:
        if document.symbol(t["name"])[0] == home:
            made.type(t)
    own = [f for f in document.content["fields"] if document.symbol(f["name"])[0] == home]
    kinds: dict[str, Any] = {f["name"]: made.add_field(f) for f in sorted(own, key=lambda f: f["role"], reverse=True)}
    by_descriptor: dict[int, tuple[type, ...]] = {}
    for f in sorted(own, key=lambda f: f["descriptor"]):
        by_descriptor[f["descriptor"]] = (*by_descriptor.get(f["descriptor"], ()), kinds[f["name"]])
        if f["role"] == "response":
            commands = [c for c in own if f["name"] in c.get("responses", ())]
            kinds[f["name"]].COMMANDS = tuple(kinds[c["name"]] for c in commands)
    module.FIELDS = by_descriptor


def types(document: Document, module: Any) -> None:
    made = Fields(document, module)
    for t in document.content["types"]:
        if document.symbol(t["name"])[0] == "types":
            made.type(t)


def protocol(document: Document, module: Any) -> None:
    content, made = document.content, Fields(document, module)
    barrier = content["barrier"]
    _fill(module, VERSION=content["version"], BARRIER=(barrier["set"], barrier["descriptor"]))
    made.type(document.types[content["function_selector"]])
    module.AckCode = document.get(content["ack_code"])
    made.add_field(document.fields[content["acknowledge"]])


def sets(document: Document, module: Any) -> None:
    _fill(module, MODULES={s["number"]: document.module(s["family"]) for s in document.content["sets"]})


def clocks(document: Document, module: Any) -> None:
    found = document.content["clocks"]
    stamps = [(document.place(name), c["name"]) for c in found for name in c.get("timestamps", ())]
    _fill(
        module,
        CLOCKS={c["name"]: c.get("epoch") for c in found},
        TIMESTAMPS={(set, f["descriptor"]): name for (set, f), name in stamps},
        UNIT_KEYS={u["symbol"]: u["key"] for u in document.content["units"] if "key" in u},
        LEAP_SECONDS=tuple(document.content["leap_seconds"].items()),
    )


def index(document: Document, module: Any) -> None:
    content = document.content
    _fill(
        module,
        SETS={s["number"]: (s["name"], s["title"]) for s in content["sets"]},
        FAMILIES={s["name"]: s["family"] for s in content["sets"] if s["family"] != s["name"]},
        FIELDS={
            name: (*document.symbol(name), f["role"], f["title"], tuple(f.get("also", ())))
            for name, f in _listed(document)
        },
        DEVICES={d["id"]: (d["title"], *d.get("also", ())) for d in content["devices"]},
        NAMED={d["id"]: (d["like"], d["title"], *d.get("also", ())) for d in content["named_devices"]},
    )


def _listed(document: Document) -> list[tuple[str, Item]]:
    """Lists all fields by name, the acknowledge last."""
    last = document.content["acknowledge"]
    return sorted(document.fields.items(), key=lambda item: item[0] == last)


def session(document: Document, module: Any) -> None:
    given = document.content.get("session")

    def rate(name: str) -> Any:
        return lambda answer: getattr(answer, document.member(name))

    def make() -> Any:
        if given is None:
            return None
        streaming = import_module(f"{document.package}.streaming")
        older = {
            x["set"]: streaming.Older(
                _call(document, x["base_rate"]), rate(x["rate"]), _call(document, x["format"]), x["stream"]
            )
            for x in given["older"]
        }
        return streaming.Session(
            base_rate=_call(document, given["base_rate"]),
            rate=rate(given["rate"]),
            format=_call(document, given["format"]),
            item=document.get(given["item"]),
            stream=_call(document, given["stream"]),
            resume=_call(document, given["resume"]),
            older=older,
        )

    module.session = make


def _call(document: Document, name: str) -> Any:
    """Returns the constructor of a command: that of its first function."""
    kind, calls = document.get(name), document.fields[name].get("calls")
    return getattr(kind, document.member(calls[0]["function"])) if calls else kind


def simulation(document: Document) -> dict[str, Any]:
    """Returns the behavior of virtual devices, in the form of a generated package's `simulation.json`."""
    given = document.content["simulation"]
    return {
        "functions": {f["letter"]: f["value"] for f in document.content["functions"]},
        "noise": {q["name"]: dict(q["noise"]) for q in given["quantities"] if q.get("noise")},
        "values": {s["field"]: _shown(s) for s in given["sources"]},
        "commands": {b["command"]: _behavior(b) for b in given["behaviors"]},
    }


# --------------------------------------------------------------------------- devices


def devices(document: Document, module: Any) -> None:
    profile, lookup = import_module(f"{document.package}.profile"), import_module(f"{document.package}.lookup")
    readings: dict[str, dict[str, Any]] = {}
    for f in document.content["fields"]:
        for p in f["parameters"]:
            for v in p.get("variants", ()):
                if v["by"] == "device" and "type" in v:
                    path = f"{f['name']}.{p['name']}" + (f".{v['member']}" if "member" in v else "")
                    readings.setdefault(v["key"], {})[path] = document.get(v["type"])
    known = {d["id"]: _device(document, profile, d, readings.get(d["id"], {})) for d in document.content["devices"]}

    def by_name(name: str) -> Any:
        return known[lookup.device_id(name)]

    def by_model(number: int) -> Any:
        return next((d for d in known.values() if d.model_number == number), None)

    def identify(info: Any) -> Any:
        number = profile.model_number(info.model_number) or profile.model_number(info.serial_number)
        return by_model(number) if number else None

    constants = {document.constant(d["name"]): known[d["id"]] for d in document.content["devices"]}
    _fill(
        module, DEVICES=known, by_name=by_name, by_model=by_model, identify=identify,
        model_number=profile.model_number, **constants,
    )  # fmt: skip


def _device(document: Document, profile: Any, d: Item, readings: dict[str, Any]) -> Any:
    said = [(s, *document.place(s["field"])) for s in (*d.get("supports", ()), *d.get("refuses", ()))]
    letters = {name: f["letter"] for name, f in document.functions.items()}
    evidence = tuple(
        profile.Evidence(
            profile.Support(e["answer"]),
            e["kind"],
            e["why"],
            _descriptors([(set, f["descriptor"]) for s, set, f in said if s["evidence"] == i]),
            tuple(tuple(pair) for pair in e.get("undefined", ())),
        )
        for i, e in enumerate(d.get("evidence", ()))
    )
    supports = said[: len(d.get("supports", ()))]
    numbers = {s["name"]: s["number"] for s in document.content["sets"]}
    return profile.Device(
        id=d["id"],
        title=d["title"],
        description=d.get("description", ""),
        model_number=d.get("model_number"),
        evidence=evidence,
        base_rates={numbers[r["set"]]: r["hertz"] for r in d.get("base_rates", ())},
        functions={
            (set, f["descriptor"]): "".join(letters[x] for x in s["functions"])
            for s, set, f in supports
            if "functions" in s
        },
        firmware={(set, f["descriptor"]): s["firmware"] for s, set, f in supports if s.get("firmware")},
        ports=tuple(
            profile.Port(
                p["name"],
                p.get("id"),
                tuple(p.get("baud_rates", ())),
                tuple(p.get("receives", ())),
                tuple(p.get("sends", ())),
            )
            for p in d.get("ports", ())
        ),
        limits={
            x["name"]: profile.Limit(x["value"], x.get("unit"), x.get("description", ""), x.get("firmware"))
            for x in d.get("limits", ())
        },
        notes={
            n["name"]: profile.Note(n["title"], n.get("description", ""), tuple(tuple(r) for r in n.get("rows", ())))
            for n in d.get("notes", ())
        },
        readings=readings,
        ack_codes=frozenset(d.get("ack_codes", ())),
        incomplete=tuple(d.get("incomplete", ())),
        also=tuple(d.get("also", ())),
        generation=d.get("generation"),
        manual=d.get("manual"),
    )


def _descriptors(places: list[tuple[int, int]]) -> dict[int, bytes]:
    found: dict[int, list[int]] = {}
    for set, descriptor in places:
        found.setdefault(set, []).append(descriptor)
    return {set: bytes(found[set]) for set in sorted(found)}


# --------------------------------------------------------------------------- simulation


def _shown(s: Item) -> Item:
    entry = {"for_each": s.get("for_each"), "valid_if": s.get("valid_if")}
    entry["parameters"] = {v["path"]: {k: x for k, x in v.items() if k != "path"} for v in s["values"]}
    return {k: x for k, x in entry.items() if x}


def _behavior(b: Item) -> Item:
    entry = {k: dict(x) if k in _PAIRS else x for k, x in b.items() if k != "command"}
    if "translate" in b:
        entry["translate"] = {name: {str(k): x for k, x in pairs} for name, pairs in b["translate"]}
    return entry


#: Keys whose content is written as pairs.
_PAIRS = ("arguments", "all", "instances", "key", "initial", "answers")
