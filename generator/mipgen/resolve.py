"""Builds the model from the nodes: follows every reference, computes every size."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from . import checks, evidence, loader, meaning
from . import model as m
from .layout import Types, Vocabulary, sources
from .nodes import Node
from .problems import Problems, nearest

SHARED_SET = 0xFF

Kind = Literal["command", "data", "shared"]

#: Keys of a field that suit one role only.
COMMAND_KEYS = ("functions", "responses", "silent_when", "timeout")
DATA_KEYS = ("max_rate",)


def load_model(spec: Path) -> m.Model:
    """Loads, resolves and checks a specification; raises SpecError with all that is wrong.

    What the manuals print is judged only once the definitions are right: it would seem wrong otherwise.
    """
    problems = Problems()
    documents = loader.load(spec, problems)
    problems.raise_if_any()
    roots = {kind: [d.root for d in documents if d.kind == kind] for kind in loader.LAYOUT}
    types, model = definitions(roots, problems)
    checks.check_definitions(model, problems)
    sound = not problems
    model = _supported(replace(model, devices=_Devices(model, types, problems).resolve(roots["device"])))
    if sound:
        manuals = types.vocabulary.manuals
        examples = evidence.examples(roots["examples"], model, problems)
        errata = evidence.errata(roots["errata"], manuals, problems)
        model = replace(model, examples=examples, errata=errata)
        checks.check_evidence(model, problems)
    problems.raise_if_any()
    tastes = sorted(p for p in (spec / "taste").glob("*") if p.is_file())
    return replace(model, tastes=tuple((p.name, p.read_text("utf-8")) for p in tastes))


def definitions(roots: dict[str, list[Node]], problems: Problems) -> tuple[Types, m.Model]:
    """The protocol, the types and the sets."""
    root = roots["protocol"][0]
    functions = _functions(root["functions"], problems)
    manuals = _manuals(roots["manual"], problems)
    words = Vocabulary(
        units=list(root["units"].value),
        frames=set(root["frames"].value),
        manuals={x.id: x for x in manuals},
        devices={d["device"].value for d in roots["device"]},
        functions=functions,
        selector=_selector(functions),
    )
    types = Types(words, problems)
    for node in roots["types"]:
        types.define(None, node["types"])
    for node in roots["set"]:
        types.define(node["name"].value, node.get("types"))
    shared = types.of(None)
    protocol = _protocol(root, types, functions, problems)
    sets = _Sets(types, problems).resolve(roots["set"])
    return types, m.Model(protocol, shared, sets, (), (), ())


def _supported(model: m.Model) -> m.Model:
    """The same with the titles of the devices that support each field."""

    def titles(f: m.Field) -> tuple[str, ...]:
        name = f"{f.set_name}.{f.command}" if f.command else f.full_name
        return tuple(d.title for d in model.devices if name in d.fields)

    sets = (replace(s, fields=tuple(replace(f, devices=titles(f)) for f in s.fields)) for s in model.sets)
    return replace(model, sets=tuple(sets))


# --------------------------------------------------------------------------- protocol


def _functions(node: Node, problems: Problems) -> tuple[m.Function, ...]:
    found: list[m.Function] = []
    for name, n in node.items():
        letter, value = n["letter"], n["value"]
        for other in found:
            if other.letter == letter.value:
                problems.add(letter.position, f"'{other.name}' already has the letter {letter.value}; choose another")
            if other.value == value.value:
                problems.add(value.position, f"'{other.name}' already has the value {value.value}; choose another")
        reply, responds = n.scalar("reply", True), n.scalar("responds", False)
        found.append(m.Function(name, letter.value, value.value, reply, responds, n["description"].value))
    return tuple(sorted(found, key=lambda f: f.value))


def _selector(functions: Iterable[m.Function]) -> m.Enum:
    values = tuple(m.EnumValue(f.name, f.value, f.description) for f in functions)
    return m.Enum("function_selector", m.SCALARS["u8"], values, "What a settings command is asked to do.", None)


def _protocol(root: Node, types: Types, functions: tuple[m.Function, ...], problems: Problems) -> m.Protocol:
    node = root["acknowledge"]
    record = types.record(list(node["parameters"]), None)
    codes = [p.element for p in record.parameters if isinstance(p.element, m.Enum)]
    if len(codes) != 1:
        problems.add(node.keys["parameters"], "the acknowledge field needs exactly one enumeration: the code")
        codes.append(types.vocabulary.selector)  # in its place, to go on and find what else is wrong
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
        manuals=tuple(types.vocabulary.manuals.values()),
    )


def _manuals(nodes: list[Node], problems: Problems) -> list[m.Manual]:
    """The manuals in the order of their document numbers."""
    found: dict[str, m.Manual] = {}
    for node in nodes:
        name = node["manual"].value
        if name in found:
            problems.add(node["manual"].position, f"the manual '{name}' is defined twice; rename one")
        sections = tuple(node["sections"].plain()) if "sections" in node else ()
        found[name] = m.Manual(name, node["title"].value, node["document"].value, node["lengths"].value, sections)
    return sorted(found.values(), key=lambda x: (x.document, x.id))


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
                self.problems.add(node["name"].position, f"two sets are called '{name}'; rename one")
                continue
            found[name] = self.set(node, found)
        return tuple(sorted(found.values(), key=lambda s: s.number))

    def set(self, node: Node, others: dict[str, m.Set]) -> m.Set:
        number, name = node["set"].value, node["name"].value
        kind: Kind = "command" if number < 0x80 else "shared" if number == SHARED_SET else "data"
        fields: list[m.Field] = []
        for entry in node.get("fields") or ():
            fields += self.field(entry, number, name, kind)
        self.check_shared(node, fields)
        fields += self.repeats(node, number, name, kind, others)
        order = {m.COMMAND: 0, m.DATA: 0, m.RESPONSE: 1}
        fields.sort(key=lambda f: (order[f.role], f.descriptor))
        return m.Set(
            number, name, kind, node["title"].value, node["description"].value, self.types.of(name), tuple(fields),
            sources(node, self.types.vocabulary, self.problems), node.position,
        )  # fmt: skip

    def field(self, node: Node, number: int, set_name: str, kind: Kind) -> list[m.Field]:
        """A command with its responses, or a data field."""
        role: m.Role = m.COMMAND if kind == "command" else m.DATA
        wrong = m.DATA if role == m.COMMAND else m.COMMAND
        if role not in node or wrong in node:
            place = node.keys.get(wrong, node.position)
            self.problems.add(place, f"a field of the {kind} set 0x{number:02X} begins with '{role}: 0x..'")
            return []
        for key in COMMAND_KEYS if role == m.DATA else DATA_KEYS:
            if key in node:
                self.problems.add(node.keys[key], f"a {role} field has no '{key}'; remove it")
        letters = node.scalar("functions", "") if role == m.COMMAND else ""
        functions = self.types.vocabulary.letters(letters)
        unknown = sorted(set(letters) - {f.letter for f in functions})
        if unknown:
            known = "".join(f.letter for f in self.types.vocabulary.functions)
            self.problems.add(node["functions"].position, f"no function has the letter {unknown[0]}; known: {known}")
            letters = "".join(c for c in letters if c not in unknown)
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
        silent = self.conditions(node.get("silent_when") if role == m.COMMAND else None, command)
        responses = [r for entry in node.get("responses") or () if (r := self.response(entry, node, command))]
        names = []
        for entry in node.get("responses") or ():
            names.append(entry.scalar("same_as") or entry.scalar("name", f"{command.name}_response"))
        return [replace(command, responses=tuple(names), silent_when=silent), *responses]

    def response(self, node: Node, owner: Node, command: m.Field) -> m.Field | None:
        if "same_as" in node:
            for key in set(node.value) - {"same_as"}:
                self.problems.add(node.keys[key], f"a response with same_as has no '{key}' of its own; remove it")
            return None
        if "response" not in node:
            self.problems.add(
                node.position,
                "a response begins with 'response: 0x..', or with 'same_as' and the name of another command's response",
            )
            return None
        listed = node.get("parameters")
        plain = listed is not None and listed.value == "as_command"
        if listed is not None and isinstance(listed.value, str) and not plain:
            self.problems.add(listed.position, f"parameters: '{listed.value}' is neither a list nor as_command")
            return None
        nodes = list((owner.get("parameters") or ()) if plain else (listed or ()))
        record = self.types.record(nodes, command.set_name, plain=plain)
        lengths = node.get("lengths")
        for manual in lengths.value if lengths else ():
            known = [s.manual for s in command.sources]
            if manual not in known:
                assert lengths is not None
                self.problems.add(
                    lengths.keys[manual], f"the command cites no manual '{manual}'{nearest(manual, known)}"
                )
        answers = f"Answers {command.title} (0x{command.set:02X},0x{command.descriptor:02X})."
        return m.Field(
            set=command.set, set_name=command.set_name, name=node.scalar("name", f"{command.name}_response"),
            descriptor=node["response"].value, role=m.RESPONSE,
            title=node.scalar("title", f"{command.title} response"),
            description=node.scalar("description", answers),
            parameters=record.parameters, operations=record.operations,
            min_size=record.min_size, max_size=record.max_size,
            sources=tuple(
                replace(s, length=str(lengths[s.manual].value), position=lengths[s.manual].position)
                if lengths and s.manual in lengths
                else replace(s, length=None)
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
                wanted = "a whole number, true, false, or the name of a value of its enumeration"
                self.problems.add(entry.position, f"'{name}' must be {wanted}")
        return tuple(found)

    def check_shared(self, node: Node, fields: list[m.Field]) -> None:
        """Every same_as names a response of this set."""
        known = [f.name for f in fields if f.role == m.RESPONSE]
        for entry in node.get("fields") or ():
            for response in entry.get("responses") or ():
                name = response.scalar("same_as")
                if name is not None and name not in known:
                    place = response["same_as"].position
                    self.problems.add(place, f"no command of this set has the response '{name}'{nearest(name, known)}")

    def repeats(self, node: Node, number: int, set_name: str, kind: Kind, others: dict[str, m.Set]) -> list[m.Field]:
        if "repeats" not in node:
            return []
        if kind == "command":
            self.problems.add(
                node.keys["repeats"], f"the command set 0x{number:02X} cannot repeat data fields; remove it"
            )
            return []
        of = node["repeats"]["of"]
        origin = others.get(of.value)
        if origin is None:
            self.problems.add(of.position, f"unknown set '{of.value}'{nearest(of.value, others)}")
            return []
        found = []
        known = {f.name: f for f in origin.own_fields if f.role == m.DATA}
        for entry in node["repeats"]["fields"]:
            name = entry["name"].value
            field = known.get(name)
            if field is None:
                near = nearest(name, known)
                self.problems.add(entry["name"].position, f"the set '{of.value}' has no data field '{name}'{near}")
                continue
            title = entry.scalar("title", field.title)
            cited = sources(entry, self.types.vocabulary, self.problems)
            found.append(
                replace(
                    field,
                    set=number,
                    set_name=set_name,
                    definition=field.full_name,
                    title=title,
                    sources=cited,
                    position=entry.position,
                )
            )
        return found


# --------------------------------------------------------------------------- devices


@dataclass
class _Devices:
    model: m.Model
    types: Types
    problems: Problems

    def resolve(self, nodes: list[Node]) -> tuple[m.Device, ...]:
        taken: set[str] = set()
        for node in nodes:
            for key in ("device", "name"):
                name = node[key].value
                if name in taken:
                    self.problems.add(node[key].position, f"two devices are called '{name}'; rename one")
            taken |= {node["device"].value, node["name"].value}
        return tuple(sorted((self.device(node) for node in nodes), key=lambda d: d.id))

    def device(self, node: Node) -> m.Device:
        device_id = node["device"].value
        manuals = [x.id for x in self.model.protocol.manuals]
        if node["manual"].value not in manuals:
            manual = node["manual"].value
            self.problems.add(node["manual"].position, meaning.unknown_manual(manual, manuals))
        for key in ("limits", "notes"):
            self.unique(key, node.get(key))
        fields = self.supports(node["supports"])
        return m.Device(
            id=device_id,
            name=node["name"].value,
            title=node["title"].value,
            manual=node["manual"].value,
            description=node["description"].value,
            model_number=node.scalar("model_number"),
            fields=fields,
            functions=self.functions(node.get("functions"), fields),
            base_rates=self.rates(node["base_rates"], node.keys["base_rates"], fields),
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

    def unique(self, key: str, entries: Node | None) -> None:
        seen: set[str] = set()
        for entry in entries or ():
            name = entry["name"]
            if name.value in seen:
                self.problems.add(name.position, f"'{name.value}' is used twice in {key}; rename one")
            seen.add(name.value)

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
                    self.problems.add(entry.position, f"unknown field '{full}'{nearest(entry.value, known)}")
                elif full in found:
                    self.problems.add(entry.position, f"'{full}' is listed twice; remove one")
                found.append(full)
        return tuple(found)

    def functions(self, node: Node | None, supported: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
        found = []
        for name, letters in node.items() if node else ():
            assert node is not None
            known = [f.full_name for f in self.model.fields if f.functions]
            field = self.model.field(name)
            if field is None or not field.functions:
                self.problems.add(node.keys[name], f"there is no command '{name}' with functions{nearest(name, known)}")
                continue
            if name not in supported:
                self.problems.add(node.keys[name], f"the device does not support '{name}'; add it to supports")
            extra = set(letters.value) - {f.letter for f in field.functions}
            if extra:
                more = "".join(sorted(extra))
                self.problems.add(
                    letters.position, f"'{name}' is not defined with the functions {more}; add them to its definition"
                )
            found.append((name, letters.value))
        return tuple(found)

    def rates(self, node: Node, place: m.Position, supported: tuple[str, ...]) -> tuple[tuple[str, float], ...]:
        known = [s.name for s in self.model.sets if s.kind == "data"]
        for name in node.value:
            if name not in known:
                self.problems.add(node.keys[name], f"unknown data set '{name}'{nearest(name, known)}")
        for name in sorted({full.partition(".")[0] for full in supported}):
            if name in known and name not in node:
                self.problems.add(place, f"the rate of '{name}' is missing (0 if its data are sent as they come)")
        return tuple((name, rate.value) for name, rate in node.items())

    def limit(self, node: Node) -> m.Limit:
        unit = node.scalar("unit")
        known = [u.symbol for u in self.model.protocol.units]
        if unit is not None and unit not in known:
            self.problems.add(node["unit"].position, meaning.unknown_unit(unit, known))
        return m.Limit(node["name"].value, node["value"].value, unit, node["description"].value)

    def readings(self, device_id: str, node: Node | None) -> tuple[tuple[str, m.Enum | m.Bitfield], ...]:
        """Those of `read_as: {by: device}`, and those that the device file adds."""
        found: list[tuple[str, m.Enum | m.Bitfield]] = []
        for f in self.model.fields:
            for p in f.parameters:
                if p.reading is not None and p.reading.by == "device":
                    found += [(f"{f.full_name}.{p.name}", t) for key, t in p.reading.types if key == device_id]
        known = [*self.types.shared, *(name for types in self.types.local.values() for name in types)]
        for key, entry in node.items() if node else ():
            if node and key not in known:
                self.problems.add(node.keys[key], f"unknown type '{key}'{nearest(key, known)}")
            t = self.types.find(entry.value, None, entry.position)
            if isinstance(t, (m.Enum, m.Bitfield)):
                found.append((key, t))
            elif t is not None:
                self.problems.add(entry.position, f"'{t.name}' is neither an enumeration nor a bitfield")
        return tuple(found)

    def codes(self, node: Node) -> tuple[int, ...]:
        of = self.model.protocol.ack_code
        known = {v.value for v in of.values}
        for code in node if of is not self.model.protocol.function_selector else ():
            if code.value not in known:
                self.problems.add(code.position, f"'{of.name}' has no value {code.value}; add it to the enumeration")
        return tuple(node.plain())
