"""Builds the model from the nodes: follows every reference, computes every size."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from . import evidence, loader
from . import model as m
from .layout import Types, Vocabulary, sources
from .loader import Document, Node
from .problems import Problems, nearest

SHARED_SET = 0xFF


def load_model(spec: Path) -> m.Model:
    """Loads, resolves and checks a specification; raises SpecError with all that is wrong."""
    from . import checks  # checks need the model, the model needs no checks

    problems = Problems()
    documents = loader.load(spec, problems)
    problems.raise_if_any()
    model = resolve(documents, problems)
    if model is not None and not problems:
        checks.check(model, problems)
    problems.raise_if_any()
    assert model is not None
    return model


def resolve(documents: list[Document], problems: Problems) -> m.Model | None:
    def of(kind: str) -> list[Node]:
        return [d.root for d in documents if d.kind == kind]

    root = of("protocol")[0]
    functions = _functions(root["functions"])
    words = Vocabulary(
        units=set(root["units"].value),
        frames=set(root["frames"].value),
        manuals=set(root["manuals"].value),
        devices={d["device"].value for d in of("device")},
        functions=functions,
        selector=_selector(functions),
    )
    types = Types(words, problems)
    for document in of("types"):
        types.define(None, document["types"])
    for document in of("set"):
        types.define(document["name"].value, document.get("types"))
    shared = types.of(None)
    protocol = _protocol(root, types, functions, problems)
    if protocol is None:
        return None
    sets = _Sets(types, problems).resolve(of("set"))
    model = m.Model(protocol, shared, sets, (), (), ())
    devices = tuple(
        d for node in of("device") if (d := _Devices(model, types, problems).resolve(node)) is not None
    )
    model = replace(model, devices=tuple(sorted(devices, key=lambda d: d.id)))
    examples = evidence.examples(of("examples"), model, problems)
    errata = evidence.errata(of("errata"), words.manuals, problems)
    return replace(model, examples=examples, errata=errata)


# --------------------------------------------------------------------------- protocol


def _functions(node: Node) -> tuple[m.Function, ...]:
    found = [
        m.Function(
            name, n["letter"].value, n["value"].value, n.scalar("reply", True), n.scalar("responds", False),
            n["description"].value,
        )
        for name, n in node.items()
    ]  # fmt: skip
    return tuple(sorted(found, key=lambda f: f.value))


def _selector(functions: Iterable[m.Function]) -> m.Enum:
    values = tuple(m.EnumValue(f.name, f.value, f.description) for f in functions)
    return m.Enum("function_selector", m.SCALARS["u8"], values, "What a settings command is asked to do.", None)


def _protocol(root: Node, types: Types, functions: tuple[m.Function, ...], problems: Problems) -> m.Protocol | None:
    node = root["acknowledge"]
    record = types.record(list(node["parameters"]), None, "")
    codes = [p.element for p in record.parameters if isinstance(p.element, m.Enum)]
    if len(codes) != 1:
        problems.add(node.position, "the acknowledge field needs exactly one enumeration: the code")
        return None
    acknowledge = m.Field(
        set=0, set_name="protocol", name=node["name"].value, descriptor=node["descriptor"].value, role=m.RESPONSE,
        title=node["title"].value, description=node["description"].value, parameters=record.parameters,
        operations=record.operations, min_size=record.min_size, max_size=record.max_size,
        sources=sources(node, types.vocabulary, problems), required_count=record.required_count,
        position=node.position,
    )  # fmt: skip
    first, second = root["sync"].plain()
    return m.Protocol(
        name=root["name"].value,
        version=root["version"].value,
        sync=(first, second),
        max_payload=root["max_payload"].value,
        functions=functions,
        acknowledge=acknowledge,
        ack_code=codes[0],
        function_selector=types.vocabulary.selector,
        units=_words(root["units"]),
        frames=_words(root["frames"]),
        manuals=tuple(
            m.Manual(i, n["title"].value, n["document"].value, n["lengths"].value)
            for i, n in root["manuals"].items()
        ),
    )


def _words(node: Node) -> tuple[m.Word, ...]:
    return tuple(m.Word(s, n["title"].value, n.scalar("description", "")) for s, n in node.items())


# --------------------------------------------------------------------------- sets


@dataclass
class _Sets:
    types: Types
    problems: Problems

    def resolve(self, nodes: list[Node]) -> tuple[m.Set, ...]:
        found: dict[str, m.Set] = {}
        pending = sorted(nodes, key=lambda n: ("repeats" in n, n["set"].value))
        for node in pending:
            name = node["name"].value
            if name in found:
                self.problems.add(node["name"].position, f"there are two sets called '{name}'; rename one")
                continue
            found[name] = self.set(node, found)
        return tuple(sorted(found.values(), key=lambda s: s.number))

    def set(self, node: Node, others: dict[str, m.Set]) -> m.Set:
        number, name = node["set"].value, node["name"].value
        kind = "command" if number < 0x80 else "shared" if number == SHARED_SET else "data"
        fields: list[m.Field] = []
        for entry in node.get("fields") or ():
            fields += self.field(entry, number, name, kind)
        fields = self.share(node, fields)
        fields += self.repeats(node, number, name, others)
        order = {m.COMMAND: 0, m.DATA: 0, m.RESPONSE: 1}
        fields.sort(key=lambda f: (order[f.role], f.descriptor))
        return m.Set(
            number, name, kind, node["title"].value, node["description"].value, self.types.of(name), tuple(fields),
            sources(node, self.types.vocabulary, self.problems), node.position,
        )  # fmt: skip

    def field(self, node: Node, number: int, set_name: str, kind: str) -> list[m.Field]:
        """A command with its responses, or a data field."""
        role: m.Role = m.COMMAND if kind == "command" else m.DATA
        if (role in node) is False or (m.COMMAND in node) == (m.DATA in node):
            self.problems.add(node.position, f"a field of the {kind} set 0x{number:02X} begins with '{role}: 0x..'")
            return []
        for key in ("functions", "responses", "silent_when") if role == m.DATA else ("max_rate",):
            if key in node:
                self.problems.add(node.value[key].position, f"'{key}' does not belong to a {role} field; remove it")
        letters = node.scalar("functions", "")
        functions = self.types.vocabulary.letters(letters)
        record = self.types.record(list(node.get("parameters") or ()), set_name, letters)
        command = m.Field(
            set=number, set_name=set_name, name=node["name"].value, descriptor=node[role].value, role=role,
            title=node["title"].value, description=node["description"].value,
            parameters=record.parameters, operations=record.operations,
            min_size=record.min_size, max_size=record.max_size,
            sources=sources(node, self.types.vocabulary, self.problems),
            functions=functions, required=record.required, required_count=record.required_count,
            max_rate=node.scalar("max_rate"), timeout=node.scalar("timeout"),
            advanced=node.scalar("advanced", False), deprecated=node.scalar("deprecated"),
            notes=tuple(node["notes"].plain()) if "notes" in node else (), position=node.position,
        )  # fmt: skip
        silent = self.conditions(node.get("silent_when"), command)
        responses = [r for entry in node.get("responses") or () if (r := self.response(entry, node, command))]
        names = []
        for entry in node.get("responses") or ():
            names.append(entry.scalar("same_as") or entry.scalar("name", f"{command.name}_response"))
        return [replace(command, responses=tuple(names), silent_when=silent), *responses]

    def response(self, node: Node, owner: Node, command: m.Field) -> m.Field | None:
        if "same_as" in node:
            for key in set(node.value) - {"same_as", "when"}:
                self.problems.add(node.keys[key], f"'{key}' does not go with same_as; remove it")
            return None
        if "response" not in node:
            self.problems.add(node.position, "a response begins with 'response: 0x..' or is 'same_as' another's")
            return None
        listed = node.get("parameters")
        plain = listed is not None and listed.value == "as_command"
        if listed is not None and isinstance(listed.value, str) and not plain:
            self.problems.add(listed.position, f"parameters: '{listed.value}' is neither a list nor as_command")
            return None
        nodes = list((owner.get("parameters") or ()) if plain else (listed or ()))
        record = self.types.record(nodes, command.set_name, "", plain)
        lengths = node.get("lengths")
        for manual in lengths.value if lengths else ():
            known = [s.manual for s in command.sources]
            if manual not in known:
                assert lengths is not None
                self.problems.add(lengths.keys[manual], f"the command cites no manual '{manual}'{nearest(manual, known)}")
        return m.Field(
            set=command.set, set_name=command.set_name, name=node.scalar("name", f"{command.name}_response"),
            descriptor=node["response"].value, role=m.RESPONSE,
            title=node.scalar("title", f"{command.title} response"),
            description=node.scalar("description", f"Answers {command.title} (0x{command.set:02X},0x{command.descriptor:02X})."),
            parameters=record.parameters, operations=record.operations,
            min_size=record.min_size, max_size=record.max_size,
            sources=tuple(
                replace(s, length=str(lengths[s.manual].value) if lengths and s.manual in lengths else None)
                for s in command.sources
            ),
            required_count=record.required_count, command=command.name,
            when=self.conditions(node.get("when"), command),
            notes=tuple(node["notes"].plain()) if "notes" in node else (), position=node.position,
        )  # fmt: skip

    def conditions(self, node: Node | None, command: m.Field) -> tuple[m.Condition, ...]:
        found = []
        for name, entry in node.items() if node else ():
            assert node is not None
            parameter = next((p for p in command.parameters if p.name == name), None)
            if parameter is None:
                near = nearest(name, [p.name for p in command.parameters])
                self.problems.add(node.keys[name], f"the command has no parameter '{name}'{near}")
                continue
            value = entry.value
            if isinstance(value, str) and isinstance(parameter.element, m.Enum):
                known = parameter.element.by_name(value)
                if known is None:
                    near = nearest(value, [v.name for v in parameter.element.values])
                    self.problems.add(entry.position, f"'{parameter.element.name}' has no value '{value}'{near}")
                    continue
                found.append(m.Condition(name, known.value, value))
            elif isinstance(value, (bool, int)):
                found.append(m.Condition(name, int(value), str(value).lower()))
            else:
                self.problems.add(entry.position, f"'{name}' must be a number or a value name")
        return tuple(found)

    def share(self, node: Node, fields: list[m.Field]) -> list[m.Field]:
        """Checks that every same_as names a response of this set."""
        known = [f.name for f in fields if f.role == m.RESPONSE]
        for entry in node.get("fields") or ():
            for response in entry.get("responses") or ():
                name = response.scalar("same_as")
                if name is not None and name not in known:
                    place = response["same_as"].position
                    self.problems.add(place, f"no command of this set has the response '{name}'{nearest(name, known)}")
        return fields

    def repeats(self, node: Node, number: int, set_name: str, others: dict[str, m.Set]) -> list[m.Field]:
        if "repeats" not in node:
            return []
        of = node["repeats"]["of"]
        origin = others.get(of.value)
        if origin is None:
            self.problems.add(of.position, f"no set '{of.value}' to repeat{nearest(of.value, others)}")
            return []
        found = []
        for entry in node["repeats"]["fields"]:
            name = entry["name"].value
            field = next((f for f in origin.own_fields if f.name == name and f.role == m.DATA), None)
            if field is None:
                near = nearest(name, [f.name for f in origin.own_fields])
                self.problems.add(entry["name"].position, f"the set '{of.value}' has no data field '{name}'{near}")
                continue
            found.append(
                replace(
                    field, set=number, set_name=set_name, definition=field.full_name,
                    title=entry.scalar("title", field.title), position=entry.position,
                    sources=sources(entry, self.types.vocabulary, self.problems),
                )  # fmt: skip
            )
        return found


# --------------------------------------------------------------------------- devices


@dataclass
class _Devices:
    model: m.Model
    types: Types
    problems: Problems

    def resolve(self, node: Node) -> m.Device:
        device_id = node["device"].value
        manuals = [x.id for x in self.model.protocol.manuals]
        if node["manual"].value not in manuals:
            manual = node["manual"].value
            self.problems.add(node["manual"].position, f"unknown manual '{manual}'{nearest(manual, manuals)}")
        return m.Device(
            id=device_id,
            name=node["name"].value,
            title=node["title"].value,
            manual=node["manual"].value,
            description=node["description"].value,
            model_number=node.scalar("model_number"),
            fields=self.supports(node["supports"]),
            functions=self.functions(node.get("functions")),
            base_rates=self.rates(node["base_rates"]),
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
            readings=self.readings(device_id, node.get("readings")),
            ack_codes=self.codes(node["ack_codes"]),
            position=node.position,
        )  # fmt: skip

    def supports(self, node: Node) -> tuple[str, ...]:
        found = []
        for set_name, entries in node.items():
            of = next((s for s in self.model.sets if s.name == set_name), None)
            if of is None:
                near = nearest(set_name, [s.name for s in self.model.sets])
                self.problems.add(node.keys[set_name], f"unknown set '{set_name}'{near}")
                continue
            known = [f.name for f in of.fields if f.role != m.RESPONSE]
            for entry in entries:
                full = f"{set_name}.{entry.value}"
                if entry.value not in known:
                    self.problems.add(entry.position, f"undefined field '{full}'{nearest(entry.value, known)}")
                elif full in found:
                    self.problems.add(entry.position, f"'{full}' stands twice; remove one")
                found.append(full)
        return tuple(found)

    def functions(self, node: Node | None) -> tuple[tuple[str, str], ...]:
        found = []
        for name, letters in node.items() if node else ():
            assert node is not None
            known = [f.full_name for f in self.model.fields if f.functions]
            field = self.model.field(name)
            if field is None or not field.functions:
                self.problems.add(node.keys[name], f"no command '{name}' with functions{nearest(name, known)}")
                continue
            extra = set(letters.value) - {f.letter for f in field.functions}
            if extra:
                more = "".join(sorted(extra))
                self.problems.add(letters.position, f"'{name}' is not defined with the functions {more}; add them there")
            found.append((name, letters.value))
        return tuple(found)

    def rates(self, node: Node) -> tuple[tuple[str, float], ...]:
        known = [s.name for s in self.model.sets if s.kind == "data"]
        for name in node.value:
            if name not in known:
                self.problems.add(node.keys[name], f"unknown data set '{name}'{nearest(name, known)}")
        return tuple((name, rate.value) for name, rate in node.items())

    def limit(self, node: Node) -> m.Limit:
        unit = node.scalar("unit")
        known = [u.symbol for u in self.model.protocol.units]
        if unit is not None and unit not in known:
            self.problems.add(node["unit"].position, f"unknown unit '{unit}'{nearest(unit, known)}")
        return m.Limit(node["name"].value, node["value"].value, unit, node["description"].value)

    def readings(self, device_id: str, node: Node | None) -> tuple[tuple[str, m.Enum | m.Bitfield], ...]:
        """Those of `read_as: {by: device}`, and those that the device file adds."""
        found: list[tuple[str, m.Enum | m.Bitfield]] = []
        for f in self.model.fields:
            for p in f.parameters:
                if p.reading is not None and p.reading.by == "device":
                    found += [(f"{f.full_name}.{p.name}", t) for key, t in p.reading.types if key == device_id]
        for key, entry in node.items() if node else ():
            t = self.types.find(entry.value, None, entry.position)
            if isinstance(t, (m.Enum, m.Bitfield)):
                found.append((key, t))
            elif t is not None:
                self.problems.add(entry.position, f"'{t.name}' is neither an enumeration nor a bitfield")
        return tuple(found)

    def codes(self, node: Node) -> tuple[int, ...]:
        known = {v.value for v in self.model.protocol.ack_code.values}
        for code in node:
            if code.value not in known:
                name = self.model.protocol.ack_code.name
                self.problems.add(code.position, f"{code.value} is no value of '{name}'; add it there")
        return tuple(node.plain())
