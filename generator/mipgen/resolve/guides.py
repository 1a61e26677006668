"""Resolves guides: follows their references, and computes the packets and the replies of every step.

`tests/virtual/test_guides.py` plays every guide on virtual devices; `targets/markdown/view/guides` lays out its page.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import codec
from mipgen.model.guides import Change, Guide, Migration, Picture, Question, Sequence, Shown, Step, Stream
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, elsewhere, nearest

from . import evidence
from .vocabulary import Vocabulary, sources_of_node, texts_of_node


def resolve(roots: Iterable[Node], model: m.Model, words: Vocabulary, problems: Problems) -> tuple[Guide, ...]:
    """Resolves the guides, in the order of their files."""
    samples, nodes, guides = SampleValues(model), list(roots), dict[str, Guide]()
    for node in nodes:
        name = node["guide"].value
        if name in guides:
            where = elsewhere(guides[name])
            problems.add(node["guide"].position, f"two guides are called '{name}', {where}; rename one")
        guides[name] = _Guide(node, model, samples, problems).resolve(words)
    for node in nodes:
        _see(node, set(guides), model, problems)
    return tuple(guides.values())


def _see(node: Node, guides: set[str], model: m.Model, problems: Problems) -> None:
    names = guides | set(model.names)
    for entry in (e for n in (node, *(node.get("questions") or ())) for e in n.get("see") or ()):
        if entry.value not in names:
            problems.add(entry.position, f"no guide or field '{entry.value}'{nearest(entry.value, names)}")
        elif entry.value == node["guide"].value:
            problems.add(entry.position, f"'{entry.value}' is this guide itself; remove it")


def _question(node: Node) -> Question:
    see = tuple(n.value for n in node.get("see") or ())
    return Question(node["question"].value, node["answer"].value, see)


def _picture(node: Node | None) -> Picture | None:
    return Picture(node["shows"].value, node["svg"].value) if node is not None else None


@dataclass
class _Guide:
    node: Node
    model: m.Model
    samples: SampleValues
    problems: Problems

    def resolve(self, words: Vocabulary) -> Guide:
        node = self.node
        migration = node.get("migration")
        return Guide(
            name=node["guide"].value,
            title=node["title"].value,
            question=node["question"].value,
            answer=node["answer"].value,
            sequences=tuple(self.sequence(n) for n in node.get("sequences") or ()),
            picture=_picture(node.get("picture")),
            lead=node.scalar("lead", ""),
            before=texts_of_node(node, "before"),
            questions=tuple(_question(n) for n in node.get("questions") or ()),
            notes=texts_of_node(node, "notes"),
            tables=tuple(n.value for n in node.get("tables") or ()),
            migration=self.migration(migration) if migration is not None else None,
            see=tuple(n.value for n in node.get("see") or ()),
            sources=sources_of_node(node, words, self.problems),
            position=node["guide"].position,
        )

    def sequence(self, node: Node) -> Sequence:
        chosen = dict[str, m.Device]()
        for n in node["devices"]:
            if n.value in chosen:
                self.problems.add(n.position, f"'{n.value}' is listed twice; remove one")
            elif (d := self.device(n)) is not None:
                chosen[n.value] = d
        devices = tuple(chosen.values())
        steps = tuple(s for n in node["steps"] if (s := self.step(n, devices)) is not None)
        return Sequence(node["title"].value, devices, steps, texts_of_node(node, "notes"))

    def device(self, node: Node) -> m.Device | None:
        device = self.model.device(node.value)
        if device is None:
            near = nearest(node.value, [d.id for d in self.model.devices])
            self.problems.add(node.position, f"unknown device '{node.value}'{near}")
        return device

    # ----------------------------------------------------------------------- steps

    def step(self, node: Node, devices: tuple[m.Device, ...]) -> Step | None:
        """Resolves a command, its reply and the data that follow; None if it has a mistake."""
        try:
            return self.resolved(node, devices)
        except evidence.Wrong as wrong:
            self.problems.add(wrong.place, str(wrong))
            return None

    def resolved(self, node: Node, devices: tuple[m.Device, ...]) -> Step:
        command = evidence.field_named(self.model, node["command"].value, node["command"].position)
        if command.role != m.COMMAND:
            raise evidence.Wrong(node["command"].position, f"'{command.full_name}' is not a command")
        stated = evidence.stated_values(command, node["values"]) if "values" in node else {}
        place = node["values"].position if "values" in node else node["command"].position
        values = evidence.with_counters(command, stated)
        call = self.call(command, values, place)
        self.supported(command, call.function, devices, node["command"].position)
        packet = self.packet(command.set, [(command, values)], place)
        silent = _silent(command, call, values)
        response = self.response(node, command, call, values, silent)
        return Step(
            reason=node["reason"].value,
            command=command,
            values=values,
            packet=packet,
            answer=b"" if silent else self.answer(command, response, place),
            host=node["host"].value if "host" in node else "",
            response=response,
            data=tuple(self.stream(n, devices) for n in node.get("data") or ()),
        )

    def call(self, f: m.Field, values: codec.Values, place: m.Position) -> m.Call:
        """Finds the form of a command for these values."""
        for call in f.calls:
            if (call.function.value if call.function else None) == values.get("function"):
                wanted = {p.name for p in call.required if p.constant is None}
                missing, more = wanted - values.keys(), values.keys() - wanted - {"function"}
                if missing:
                    raise evidence.Wrong(place, f"'{f.full_name}' needs {_listed(missing)} here")
                if more:
                    raise evidence.Wrong(place, f"'{f.full_name}' accepts no {_listed(more)} here")
                return call
        functions = " or ".join(x.name for x in f.functions)
        raise evidence.Wrong(place, f"'{f.full_name}' needs values: {{function: {functions}}}")

    def supported(
        self,
        f: m.Field,
        function: m.Function | None,
        devices: tuple[m.Device, ...],
        place: m.Position,
        number: int | None = None,
    ) -> None:
        """Requires that the devices support the field, in the set with that number if one is given."""
        for d in devices:
            of = (s for s in d.supports if s.field.full_name == f.full_name and number in (None, s.set))
            field = next(of, None)
            if field is None:
                name = f.full_name if number is None else f.name_in(number)
                self.problems.add(place, f"the {d.title} does not support '{name}'")
            elif function is not None and function not in field.functions:
                self.problems.add(place, f"the {d.title} does not accept {function.name} of '{f.full_name}'")

    def packet(self, number: int, fields: list[tuple[m.Field, codec.Values]], place: m.Position) -> bytes:
        try:
            parts = [(f.descriptor, codec.encode(f, values)) for f, values in fields]
        except codec.CodecError as error:
            raise evidence.Wrong(place, f"no packet can be built from this: {error}") from error
        return evidence.built(self.model, number, parts, place)

    # ----------------------------------------------------------------------- answers

    def response(self, node: Node, f: m.Field, call: m.Call, values: codec.Values, silent: bool) -> Shown | None:
        """Resolves the response, with the values that the step states, and typical ones for the rest."""
        answer = node.get("answer")
        possible = {
            r.full_name: r
            for reply in self.model.replies(f)
            if not silent
            and (call.function is None or call.function in reply.functions)
            and all(c.holds(values.get(c.parameter)) for c in reply.when)
            for r in reply.layouts
        }
        if answer is None:
            return self.shown(next(iter(possible.values())), None) if possible else None
        name, stated = next(answer.items())
        if name not in possible:
            nothing = "no answer; leave it out" if silent else "an acknowledge alone; leave it out"
            remedy = f"the response is {' or '.join(possible)}" if possible else nothing
            raise evidence.Wrong(answer.keys[name], f"'{f.full_name}' is not answered with '{name}' here: {remedy}")
        return self.shown(possible[name], stated, node.get("typical"))

    def answer(self, f: m.Field, response: Shown | None, place: m.Position) -> bytes:
        acknowledge = (self.model.protocol.acknowledge.descriptor, bytes([f.descriptor, 0]))
        responses = [(response.field.descriptor, response.data)] if response else []
        return evidence.built(self.model, f.set, [acknowledge, *responses], place)

    def shown(self, f: m.Field, stated: Node | None, example: Node | None = None) -> Shown:
        """Returns a field with all its values: stated values, else those of an example, else typical ones."""
        sure, seen = (
            evidence.stated_values(f, n) if n is not None and n.value is not None else {} for n in (stated, example)
        )
        values = _merged(self.samples.values(f, f.calls[0]), {**seen, **sure})
        values |= codec.counters(f.parameters, values)
        try:
            return Shown(f, values, codec.encode(f, values), tuple(sure))
        except codec.CodecError as error:
            place = next((n.position for n in (stated, example) if n is not None), self.node.position)
            raise evidence.Wrong(place, f"'{f.full_name}' cannot be encoded: {error}") from error

    # ----------------------------------------------------------------------- data

    def stream(self, node: Node, devices: tuple[m.Device, ...]) -> Stream:
        data_set = self.model.set_named(node["set"].value)
        if data_set is None or data_set.kind != "data":
            names = [s.name for s in self.model.sets if s.kind == "data"]
            raise evidence.Wrong(node["set"].position, f"no data set '{node['set'].value}'{nearest('', names)}")
        fields = tuple(self.data_field(n, data_set, devices) for n in node["fields"])
        packet = self.packet(data_set.number, [(x.field, x.values) for x in fields], node["fields"].position)
        rate = node.get("rate")
        if rate is not None:
            self.rate(rate, data_set, devices)
        return Stream(data_set, fields, packet, rate.value if rate else None, node.scalar("on_event", ""))

    def data_field(self, node: Node, s: m.Set, devices: tuple[m.Device, ...]) -> Shown:
        if isinstance(node.value, dict) and len(node.value) != 1:
            raise evidence.Wrong(node.position, "give one field and its values: - set.field: {parameter: value}")
        name, values = (node.value, None) if isinstance(node.value, str) else next(node.items())
        f = evidence.field_named(self.model, name, node.position)
        if f.role != m.DATA or s.number not in f.sets:
            raise evidence.Wrong(node.position, f"'{name}' does not occur in packets of the set '{s.name}'")
        self.supported(f, None, devices, node.position, None if f.everywhere else s.number)
        return self.shown(f, None, values)

    def rate(self, node: Node, s: m.Set, devices: tuple[m.Device, ...]) -> None:
        """Requires that a rate is the base rate divided by a whole number."""
        for d in devices:
            base = next((r.hertz for r in d.base_rates if r.set.name == s.name), 0)
            if base and (Fraction(str(base)) / Fraction(str(node.value))).denominator != 1:  # exact decimals
                message = f"{node.value} Hz is not the base rate of '{s.name}' on the {d.title}, {base} Hz, "
                self.problems.add(node.position, message + "divided by a whole number")

    # ----------------------------------------------------------------------- migrations

    def migration(self, node: Node) -> Migration | None:
        before, after = self.device(node["from"]), self.device(node["to"])
        if before is None or after is None:
            return None
        if before is after:
            self.problems.add(node["to"].position, f"'{after.id}' is also the device in 'from'; choose a different one")
        changes = tuple(
            Change(self.those(n, "fields", before), self.those(n, "by", after), " ".join(texts_of_node(n, "notes")))
            for n in node["changes"]
        )
        named = {f.full_name for c in changes for f in c.fields}
        for name in _lost(before, after):
            if name not in named:
                message = f"the {after.title} lacks '{name}' of the {before.title}; state in 'changes' what replaces it"
                self.problems.add(node.keys["changes"], message)
        return Migration(before, after, changes)

    def those(self, node: Node, key: str, device: m.Device) -> tuple[m.Field, ...]:
        """Returns the fields at a key, which the device must support."""
        fields = []
        for entry in node.get(key) or ():
            try:
                f = evidence.field_named(self.model, entry.value, entry.position)
            except evidence.Wrong as wrong:
                self.problems.add(wrong.place, str(wrong))
                continue
            self.supported(f, None, (device,), entry.position)
            fields.append(f)
        return tuple(fields)


def _silent(f: m.Field, call: m.Call, values: codec.Values) -> bool:
    """True if the device does not answer the command with these values."""
    if call.function is not None and not call.function.reply:
        return True
    return bool(f.silent_when) and all(c.holds(values.get(c.parameter)) for c in f.silent_when)


def _lost(before: m.Device, after: m.Device) -> Iterator[str]:
    names = {s.field.full_name for s in after.supports}
    return (s.name for s in before.certain if s.field.full_name not in names)


def _merged(typical: codec.Values, stated: codec.Values) -> codec.Values:
    """Merges values in wire order; members of structures are merged one by one."""
    merged = {**typical, **stated}
    for name, value in stated.items():
        if isinstance(value, dict) and isinstance(typical.get(name), dict) and value.keys() < typical[name].keys():
            merged[name] = _merged(typical[name], value)
    return merged


def _listed(names: set[str]) -> str:
    return ", ".join(f"'{name}'" for name in sorted(names))
