"""Resolves descriptor sets: fields with their responses, and fields that repeat those of another set."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from . import model as m
from .layout import Types
from .nodes import Node
from .problems import Problems, nearest
from .vocabulary import sources

SHARED_SET = 0xFF

Kind = Literal["command", "data", "shared"]

#: Keys of a field that suit one role only.
COMMAND_KEYS = ("functions", "responses", "silent_when", "timeout")
DATA_KEYS = ("max_rate",)


@dataclass
class Sets:
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
                self.problems.add(node.keys[key], f"'{key}' does not belong to a {role} field; remove it")
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
            functions=functions,
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
        record = self.types.record(nodes, command.set_name, plain=plain)
        lengths = node.get("lengths")
        for manual in lengths.value if lengths else ():
            known = [s.manual for s in command.sources]
            if manual not in known:
                assert lengths is not None
                self.problems.add(
                    lengths.keys[manual], f"the command cites no manual '{manual}'{nearest(manual, known)}"
                )
        return m.Field(
            set=command.set, set_name=command.set_name, name=node.scalar("name", f"{command.name}_response"),
            descriptor=node["response"].value, role=m.RESPONSE,
            title=node.scalar("title", f"{command.title} response"),
            description=node.scalar("description", ""),
            parameters=record.parameters, operations=record.operations,
            min_size=record.min_size, max_size=record.max_size,
            sources=tuple(
                replace(s, length=str(lengths[s.manual].value), position=lengths[s.manual].position)
                if lengths and s.manual in lengths
                else replace(s, length=None)
                for s in command.sources
            ),
            command=command.name,
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
            self.problems.add(of.position, f"no set '{of.value}' to repeat{nearest(of.value, others)}")
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
