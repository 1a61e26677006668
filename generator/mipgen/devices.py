"""Resolves devices: what each supports, and what its values mean where they differ."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from . import meaning
from . import model as m
from .layout import Types
from .nodes import Node
from .problems import Problems, nearest
from .variation import variant


def resolve(nodes: list[Node], model: m.Model, types: Types, problems: Problems) -> m.Model:
    """The model with its devices, and with what differs on them said of each parameter."""
    for key, what in (("device", "called"), ("name", "called"), ("title", "titled")):
        _unique((node[key] for node in nodes), f"two devices are {what} '{{}}'; rename one", problems)
    nodes = sorted(nodes, key=lambda node: str(node["device"].value))
    found = [(path, v) for node in nodes for path, v in _variants(node, model, types, problems)]
    model = _with_variants(model, found)
    made = tuple(_Device(node, model, problems).resolve() for node in nodes)
    return replace(model, devices=made)


def _unique(entries: Iterable[Node], message: str, problems: Problems) -> None:
    seen: set[str] = set()
    for entry in entries:
        if entry.value in seen:
            problems.add(entry.position, message.format(entry.value))
        seen.add(entry.value)


# --------------------------------------------------------------------------- variants


def _variants(node: Node, model: m.Model, types: Types, problems: Problems) -> Iterable[tuple[str, m.Variant]]:
    """`varies` of a device: the path of a parameter -> what it is there."""
    device, spec = node["device"].value, node.get("varies")
    for path, case in spec.items() if spec else ():
        assert spec is not None
        name, _, last = path.rpartition(".")
        f = model.field(name)
        if f is None:
            known = [x.full_name for x in (*model.fields, model.protocol.acknowledge)]
            problems.add(
                spec.keys[path], f"'{path}' is not a set.field.parameter: unknown field '{name}'{nearest(name, known)}"
            )
            continue
        p = next((p for p in f.parameters if p.name == last), None)
        if p is None:
            near = nearest(last, [p.name for p in f.parameters])
            problems.add(spec.keys[path], f"'{name}' has no parameter '{last}'{near}")
            continue
        yield path, variant(case, p, m.DEVICE, device, None, types.scope(f.set_name))


def _unsupported(node: Node, supports: tuple[m.Support, ...], model: m.Model, problems: Problems) -> None:
    """What varies belongs to a field that the device supports."""
    known = {f.full_name for s in supports for f in (s.field, *model.responses(s.field))}
    known.add(model.protocol.acknowledge.full_name)
    for path in node["varies"].value if "varies" in node else ():
        name = path.rpartition(".")[0]
        if model.field(name) is not None and name not in known:
            problems.add(node["varies"].keys[path], f"the device does not support '{name}'; add it to supports")


def _with_variants(model: m.Model, found: list[tuple[str, m.Variant]]) -> m.Model:
    """The same fields, with these variants added to their parameters."""
    by_path: dict[str, list[m.Variant]] = {}
    for path, v in found:
        by_path.setdefault(path, []).append(v)

    def varied(f: m.Field) -> m.Field:
        parameters = tuple(
            replace(p, variants=(*p.variants, *by_path.get(f"{f.full_name}.{p.name}", ()))) for p in f.parameters
        )
        return replace(f, parameters=parameters) if parameters != f.parameters else f

    protocol = replace(model.protocol, acknowledge=varied(model.protocol.acknowledge))
    sets = tuple(replace(s, fields=tuple(varied(f) for f in s.fields)) for s in model.sets)
    return replace(model, protocol=protocol, sets=sets)


# --------------------------------------------------------------------------- one device


@dataclass(frozen=True, slots=True)
class _Device:
    node: Node
    model: m.Model
    problems: Problems

    def resolve(self) -> m.Device:
        node = self.node
        device_id = node["device"].value
        manuals = [x.id for x in self.model.protocol.manuals]
        manual = node["manual"]
        if manual.value not in manuals:
            self.problems.add(manual.position, meaning.unknown_manual(manual.value, manuals))
        for key in ("limits", "notes"):
            entries = (entry["name"] for entry in node.get(key) or ())
            _unique(entries, f"'{{}}' is used twice in {key}; rename one", self.problems)
        supports = self.supports(node["supports"], self.functions(node.get("functions")))
        _unsupported(node, supports, self.model, self.problems)
        self.readings(device_id, supports)
        return m.Device(
            id=device_id,
            name=node["name"].value,
            title=node["title"].value,
            manual=manual.value,
            description=node["description"].value,
            model_number=node.scalar("model_number"),
            supports=supports,
            base_rates=self.rates(node["base_rates"], node.keys["base_rates"], supports),
            ports=tuple(
                m.Port(p["name"].value, p.scalar("id"), tuple(p["baud_rates"].plain()), tuple(p["protocols"].plain()))
                for p in node.get("ports") or ()
            ),
            limits=tuple(self.limit(n) for n in node.get("limits") or ()),
            notes=tuple(
                m.Note(
                    n["name"].value, n["title"].value, n["description"].value,
                    tuple(tuple(str(c) for c in row) for row in n["rows"].plain()) if "rows" in n else (),
                )
                for n in node.get("notes") or ()
            ),
            variants=tuple(
                m.DeviceVariant(f, p, v)
                for f in (self.model.protocol.acknowledge, *self.model.fields)
                for p in f.parameters
                for v in p.variants
                if v.by_device and v.key == device_id
            ),
            ack_codes=self.codes(node["ack_codes"]),
            position=node.position,
        )  # fmt: skip

    def supports(self, node: Node, functions: dict[str, Node]) -> tuple[m.Support, ...]:
        found: dict[str, m.Support] = {}
        for set_name, entries in node.items():
            of = next((s for s in self.model.sets if s.name == set_name), None)
            if of is None:
                near = nearest(set_name, [s.name for s in self.model.sets])
                self.problems.add(node.keys[set_name], f"unknown set '{set_name}'{near}")
                continue
            known = {f.name: f for f in of.fields if f.role != m.RESPONSE}
            for entry in entries:
                f, full = known.get(entry.value), f"{set_name}.{entry.value}"
                if f is None:
                    self.problems.add(entry.position, f"unknown field '{full}'{nearest(entry.value, known)}")
                elif full in found:
                    self.problems.add(entry.position, f"'{full}' is listed twice; remove one")
                else:
                    own = functions.get(full)
                    taken = tuple(x for x in f.functions if own is None or x.letter in own.value)
                    found[full] = m.Support(f, taken)
        for full in functions.keys() - found.keys():
            place = self.node["functions"].keys[full]
            self.problems.add(place, f"the device does not support '{full}'; add it to supports")
        return tuple(sorted(found.values(), key=lambda s: (s.field.set, s.field.descriptor)))

    def functions(self, node: Node | None) -> dict[str, Node]:
        """Full name -> letters, where the device takes others than the definition says."""
        found = {}
        for name, letters in node.items() if node else ():
            assert node is not None
            field = self.model.field(name)
            if field is None or not field.functions:
                known = [f.full_name for f in self.model.fields if f.functions]
                self.problems.add(node.keys[name], f"there is no command '{name}' with functions{nearest(name, known)}")
                continue
            extra = set(letters.value) - set(m.letters(field.functions))
            if extra:
                more = "".join(sorted(extra))
                self.problems.add(
                    letters.position, f"'{name}' is not defined with the functions {more}; add them to its definition"
                )
            found[name] = letters
        return found

    def readings(self, device_id: str, supports: tuple[m.Support, ...]) -> None:
        """A parameter whose values are read by device needs a reading from each that supports it."""
        for s in supports:
            for f in (s.field, *self.model.responses(s.field)):
                for p in f.parameters:
                    named = any(v.key == device_id and v.type for v in p.variants if v.by_device)
                    if p.by_device and not named:
                        path = f"{f.full_name}.{p.name}"
                        place = self.node.keys["varies"] if "varies" in self.node else self.node.position
                        self.problems.add(
                            place, f"the device must say how it reads '{path}'; add {path}: {{type: ...}} to varies"
                        )

    def rates(self, node: Node, place: m.Position, supports: tuple[m.Support, ...]) -> tuple[m.Rate, ...]:
        known = {s.name: s for s in self.model.sets if s.kind == "data"}
        for name in node.value:
            if name not in known:
                self.problems.add(node.keys[name], f"unknown data set '{name}'{nearest(name, known)}")
        for name in sorted({s.field.set_name for s in supports}):
            if name in known and name not in node:
                self.problems.add(place, f"the rate of '{name}' is missing (0 if its data are sent as they come)")
        return tuple(m.Rate(known[name], rate.value) for name, rate in node.items() if name in known)

    def limit(self, node: Node) -> m.Limit:
        unit = node.scalar("unit")
        known = [u.symbol for u in self.model.protocol.units]
        if unit is not None and unit not in known:
            self.problems.add(node["unit"].position, meaning.unknown_unit(unit, known))
        return m.Limit(node["name"].value, node["value"].value, unit, node["description"].value)

    def codes(self, node: Node) -> tuple[int, ...]:
        of = self.model.protocol.ack_code
        known = {v.value for v in of.values}
        for code in node if of is not self.model.protocol.function_selector else ():
            if code.value not in known:
                self.problems.add(code.position, f"'{of.name}' has no value {code.value}; add it to the enumeration")
        return tuple(node.plain())
