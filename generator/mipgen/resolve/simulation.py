"""Resolves `simulation`: the knowledge, the data and the behavior of a simulated device."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from mipgen import model as m
from mipgen.facts import simulated_values
from mipgen.lower import codec
from mipgen.lower.codec import in_numbers
from mipgen.model.simulation import AFFECTED, PORTS, SETS, Behavior, Effect, Quantity, Simulation, Source, Value
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

from . import meaning

FOR_EACH, VALID_IF = "for_each", "valid_if"


def resolve(roots: Sequence[Node], model: m.Model, problems: Problems) -> Simulation:
    """Joins all files; each name may occur only once."""
    quantities = tuple(_quantity(name, n, model, problems) for name, n, _ in _entries(roots, "quantities", problems))
    effects = tuple(
        Effect(name, tuple(n["arguments"].plain()) if "arguments" in n else (), n["description"].value)
        for name, n, _ in _entries(roots, "effects", problems)
    )
    equals = {word.key: word.equals for word in model.protocol.units if word.equals}
    values = _Values(model, {q.name: q for q in quantities}, equals, problems)
    commands = _Commands(model, {e.name: e for e in effects}, problems)
    shown = [*_entries(roots, "values", problems)]
    sources = (values.of(name, n, at) for name, n, at in _written_out(shown, problems))
    resolved = [commands.of(name, n, at) for name, n, at in _entries(roots, "commands", problems)]
    behaviors = [b for b in resolved if b is not None]
    names = {b.command.full_name for b in behaviors}
    others = (Behavior(f, answers=_layouts(f, model)) for f in model.fields if f.full_name not in names)
    behaviors += (b for b in others if b.answers)
    return Simulation(quantities, effects, tuple(s for s in sources if s is not None), tuple(behaviors))


def _layouts(f: m.Field, model: m.Model) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Returns the responses of a command that only some devices send, with these devices."""
    return tuple((r.name, r.devices) for r in model.responses(f) if r.devices)


#: A name, what is stated of it, and where.
Entry: TypeAlias = "tuple[str, Node, m.Position]"


def _entries(roots: Iterable[Node], part: str, problems: Problems) -> Iterator[Entry]:
    seen: dict[str, m.Position] = {}
    for root in roots:
        for name, node in root[part].items() if part in root else ():
            at = root[part].keys[name]
            if name in seen:
                problems.add(at, f"'{name}' is already given at {seen[name]}; remove one")
                continue
            seen[name] = at
            yield name, node, at


def _written_out(shown: Sequence[Entry], problems: Problems) -> Iterator[Entry]:
    """Yields the values of each field; those that name another field are the same as there."""
    values = {name: node for name, node, _ in shown if isinstance(node.value, dict)}
    for name, node, at in shown:
        same = values.get(node.value) if isinstance(node.value, str) else node
        if same is not None:
            yield name, same, at
        else:
            near = nearest(node.value, values)
            problems.add(node.position, f"no field '{node.value}' with values of its own{near}")


def _quantity(name: str, node: Node, model: m.Model, problems: Problems) -> Quantity:
    elements = node.scalar("elements", 1)
    typical = node.get("typical")
    value = typical.plain() if typical else None
    if typical and elements > 1 and not (isinstance(value, list) and len(value) == elements):
        problems.add(typical.position, f"the typical value of '{name}' must be a list of {elements} numbers")
        value = None
    noise = tuple((key, float(n.value)) for key, n in _pairs(node, "noise"))
    unit = meaning.unit(node, model.protocol.units, problems)
    return Quantity(name, unit, elements, node["description"].value, value, noise)


def _field(name: str, roles: Collection[str], at: m.Position, model: m.Model, problems: Problems) -> m.Field | None:
    f = model.field(name)
    if f is None or f.role not in roles:
        names = [x.full_name for x in model.fields if x.role in roles]
        problems.add(at, f"no {' or '.join(roles)} '{name}'{nearest(name, names)}")
        return None
    return f


# --------------------------------------------------------------------------- values


@dataclass(frozen=True)
class _Values:
    model: m.Model
    quantities: dict[str, Quantity]
    equals: dict[str, tuple[str, float]]  # unit -> a number of another unit
    problems: Problems

    def of(self, name: str, node: Node, at: m.Position) -> Source | None:
        f = _field(name, (m.DATA, m.RESPONSE), at, self.model, self.problems)
        if f is None:
            return None
        values = []
        for path, n in node.items():
            p = None if path in (FOR_EACH, VALID_IF) else self.parameter(f, path, node.keys[path])
            if p is not None:
                values.append(self.value(f, path, n, p))
        own = None if name == f.full_name else self.model.set_of(name)
        return Source(f, own, self.quantity_named(node, FOR_EACH), tuple(values), self.quantity_named(node, VALID_IF))

    def quantity_named(self, node: Node, key: str) -> str:
        """Returns the name of the quantity that a key states, or "" without it."""
        stated = node.get(key)
        if stated is None:
            return ""
        if not isinstance(stated.value, str):
            self.problems.add(stated.position, f"'{key}' must be the name of a quantity")
            return ""
        self.quantity(stated)
        return stated.value

    def quantity(self, node: Node) -> Quantity | None:
        quantity = self.quantities.get(node.value)
        if quantity is None:
            self.problems.add(node.position, f"unknown quantity '{node.value}'{nearest(node.value, self.quantities)}")
        return quantity

    def parameter(self, f: m.Field, path: str, at: m.Position) -> m.Parameter | None:
        parameters, p = f.parameters, None
        for name in path.split("."):
            p = next((x for x in parameters if x.name == name), None)
            if p is None:
                near = nearest(name, [x.name for x in parameters if not x.derived])
                self.problems.add(at, f"'{f.full_name}' has no parameter '{path}'{near}")
                return None
            parameters = p.element.parameters if isinstance(p.element, m.Struct) and p.length is None else ()
        if p is not None and p.derived:
            self.problems.add(at, f"'{path}' follows from the rest of the field; remove it")
            return None
        return p

    def value(self, f: m.Field, path: str, node: Node, p: m.Parameter) -> Value:
        if not isinstance(node.value, dict):
            q = self.quantity(node)
            factor = self.factor(q, p, node) if q else 1.0
            shows = q is None or self.shows_typical(q, p, factor, node)
            return Value(path, node.value if shows else "", factor)
        ((kind, n),) = node.items()
        if kind == "number":
            return Value(path, number=n.value)
        if kind == "text":
            return Value(path, text=n.value)
        if kind == "parameter":
            self.asked(f, n)
            return Value(path, parameter=n.value)
        names = tuple(n.plain())
        types = [t for t in (p.element, *(v.type for v in p.readings)) if isinstance(t, (m.Enum, m.Bitfield))]
        wanted = m.Enum if kind == "name" else m.Bitfield
        choices = {name for t in types if isinstance(t, wanted) for name in _names(t)}
        for entry in n:
            if entry.value not in choices:
                what = "value" if kind == "name" else "bit"
                self.problems.add(
                    entry.position, f"'{path}' has no {what} '{entry.value}'{nearest(entry.value, choices)}"
                )
        return Value(path, names=names) if kind == "name" else Value(path, bits=names)

    def asked(self, f: m.Field, node: Node) -> None:
        """Checks that the commands of a response have a parameter."""
        commands = [c for c in self.model.fields if c.role == m.COMMAND and f in self.model.responses(c)]
        names = [p.name for c in commands for p in c.parameters if not p.derived]
        if not commands:
            self.problems.add(node.position, f"'{f.full_name}' is not a response and has no setting; write a quantity")
        elif node.value not in names:
            near = nearest(node.value, names)
            self.problems.add(
                node.position, f"'{commands[0].full_name}' has no parameter '{node.value}' to be shown{near}"
            )

    def shows_typical(self, q: Quantity, p: m.Parameter, factor: float, node: Node) -> bool:
        if q.typical is None:
            return True
        try:
            value = simulated_values.simulated_value(p, q.typical, factor)
            codec.encode_value(p, value)
        except (ValueError, codec.CodecError) as error:
            self.problems.add(node.position, f"'{p.name}' cannot show the typical value of '{q.name}': {error}")
            return False
        return True

    def factor(self, q: Quantity, p: m.Parameter, node: Node) -> float:
        """Returns the factor from the unit of a quantity to the unit of a parameter, whose elements may have
        several."""
        units = set(p.units)
        if q.unit is None or not units or units == {q.unit}:
            return 1.0
        if len(units) > 1:
            self.problems.add(node.position, f"'{p.name}' has several units; '{q.name}' must have none")
            return 1.0
        (unit,) = units
        if unit in self.equals and self.equals[unit][0] == q.unit:
            return 1 / self.equals[unit][1]
        if q.unit in self.equals and self.equals[q.unit][0] == unit:
            return self.equals[q.unit][1]
        self.problems.add(
            node.position,
            f"'{p.name}' is in {unit}, '{q.name}' in {q.unit}; state in protocol.yaml what one {unit} equals, "
            "or use another quantity",
        )
        return 1.0


def _names(t: m.Enum | m.Bitfield) -> Iterator[str]:
    """Yields the names of values or bits; for a number inside a bitfield, also the names of its values: bits.value."""
    for x in t.values if isinstance(t, m.Enum) else t.bits:
        yield x.name
        if isinstance(x, m.Bits) and x.enum is not None:
            yield from (f"{x.name}.{value.name}" for value in x.enum.values)


# --------------------------------------------------------------------------- commands


@dataclass(frozen=True)
class _Commands:
    model: m.Model
    effects: dict[str, Effect]
    problems: Problems

    def of(self, name: str, node: Node, at: m.Position) -> Behavior | None:
        f = _field(name, (m.COMMAND,), at, self.model, self.problems)
        if f is None:
            return None
        self.references(f, node)
        return Behavior(
            f,
            effect=self.effect(node),
            arguments=tuple((k, self.argument(f, n)) for k, n in _pairs(node, "with")),
            all=tuple((k, n.value) for k, n in _pairs(node, "all")),
            writes_all=bool(node.scalar("writes_all", False)),
            instances=tuple((k, self.instance(n)) for k, n in _pairs(node, "instances")),
            translate=tuple((k, self.translation(n)) for k, n in _pairs(node, "translate")),
            setting=self.setting(node),
            key=tuple((k, self.number(n)) for k, n in _pairs(node, "key")),
            initial=tuple((k, self.initial(f, k, n)) for k, n in _pairs(node, "default")),
            once=bool(node.scalar("once", False)),
            affected=self.affected(f, node),
            answers=_layouts(f, self.model),
        )

    def references(self, f: m.Field, node: Node) -> None:
        """Checks that the named parameters of the command exist."""
        names = [p.name for p in f.parameters]
        for part in ("all", "instances", "translate", "default"):
            for name, _ in _pairs(node, part):
                if name not in names:
                    place = node[part].keys[name]
                    self.problems.add(place, f"'{f.full_name}' has no parameter '{name}'{nearest(name, names)}")

    def effect(self, node: Node) -> str:
        effect_node = node.get("effect")
        if effect_node is None:
            return ""
        effect = self.effects.get(effect_node.value)
        if effect is None:
            near = nearest(effect_node.value, self.effects)
            self.problems.add(effect_node.position, f"unknown effect '{effect_node.value}'{near}")
        else:
            names = [name for name, _ in _pairs(node, "with")]
            for name in names:
                if name not in effect.arguments:
                    place = node["with"].keys[name]
                    near = nearest(name, effect.arguments)
                    self.problems.add(place, f"the effect '{effect.name}' has no argument '{name}'{near}")
        return str(effect_node.value)

    def argument(self, f: m.Field, node: Node) -> str | int:
        if isinstance(node.value, int):
            return node.value
        if "." in node.value:
            self.member(f, node)
            return str(node.value)
        if any(p.name == node.value for p in f.parameters):
            return str(node.value)
        return self.number(node, [p.name for p in f.parameters])

    def member(self, f: m.Field, node: Node) -> None:
        """Checks that a member of a structure, or of any case of a union, exists."""
        members, path = f.parameters, list[str]()
        for name in node.value.split("."):
            same = [p for p in members if p.name == name]
            if not same:
                near = nearest(name, [p.name for p in members])
                self.problems.add(node.position, f"'{'.'.join([f.full_name, *path])}' has no parameter '{name}'{near}")
                return
            path.append(name)
            members = tuple(inner for p in same for inner in _members(p))

    def number(self, node: Node, others: Sequence[str] = ()) -> int:
        """Returns a number, or the number of a set given by name."""
        if isinstance(node.value, int):
            return node.value
        numbers = {s.name: s.number for s in self.model.sets}
        if node.value not in numbers:
            near = nearest(node.value, [*others, *numbers])
            self.problems.add(node.position, f"'{node.value}' is neither a number nor the name of a set{near}")
        return numbers.get(node.value, 0)

    def translation(self, node: Node) -> tuple[tuple[int, int], ...]:
        pairs = []
        for text, n in node.items():
            if not text.isdecimal():
                self.problems.add(node.keys[text], f"'{text}' is not a number; write one")
                continue
            pairs.append((int(text), self.number(n)))
        return tuple(pairs)

    def instance(self, node: Node) -> str:
        limits = {limit.name for d in self.model.devices for limit in d.limits}
        if node.value not in limits | {PORTS, SETS, AFFECTED}:
            near = nearest(node.value, sorted(limits | {PORTS, SETS, AFFECTED}))
            self.problems.add(node.position, f"no device has the limit '{node.value}'{near}")
        return str(node.value)

    def affected(self, f: m.Field, node: Node) -> tuple[tuple[int, int], ...]:
        """Returns the data fields that the command certainly affects, if they select the instances of its setting."""
        entries = [n for _, n in _pairs(node, "instances") if n.value == AFFECTED]
        if not entries:
            return ()
        fields = [x for x in self.model.affected(f, True) if isinstance(x, m.Field)]
        if not fields:
            self.problems.add(entries[0].position, f"'{f.full_name}' lists no data fields that it `affects`; add them")
        return tuple((number, x.descriptor) for x in fields for number in x.sets)

    def setting(self, node: Node) -> str:
        command_name = node.get("setting")
        if command_name is None:
            return ""
        f = _field(command_name.value, (m.COMMAND,), command_name.position, self.model, self.problems)
        for name, _ in _pairs(node, "key"):
            names = [p.name for p in f.parameters] if f else [name]
            if name not in names:
                place = node["key"].keys[name]
                self.problems.add(place, f"'{command_name.value}' has no parameter '{name}'{nearest(name, names)}")
        return str(command_name.value)

    def initial(self, f: m.Field, name: str, node: Node) -> Any:
        """Converts a value to the form of the parameter, with numbers for names. An enumeration may have several."""
        p = next((p for p in f.parameters if p.name == name), None)
        if p is None:
            return None
        for n in node if isinstance(p.element, m.Enum) and isinstance(node.value, list) else (node,):
            meaning.check_default(n, p, self.problems.add)
        return in_numbers(node.plain(), p.element)


def _members(p: m.Parameter) -> Iterator[m.Parameter]:
    """Yields the parameters inside a structure, or inside the cases of a union."""
    inside = [c.parameter.element for c in p.cases if c.parameter is not None] if p.cases else [p.element]
    for element in inside if p.length is None else ():
        if isinstance(element, m.Struct):
            yield from element.parameters


def _pairs(node: Node, part: str) -> list[tuple[str, Node]]:
    return list(node[part].items()) if part in node else []
