"""Resolves descriptor sets: fields with their responses, and fields that repeat those of another set."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

from . import model as m
from .layout import Types
from .nodes import Node
from .problems import Problems, nearest
from .vocabulary import sentences, short_name, sources

Kind = Literal["command", "data", "shared"]

ROLES: tuple[m.Role, ...] = (m.COMMAND, m.RESPONSE, m.DATA)

#: Keys of a field that suit one role only.
COMMAND_KEYS = ("functions", "responses", "silent_when", "sent_by", "timeout")
DATA_KEYS = ("max_rate",)


@dataclass
class Sets:
    types: Types
    problems: Problems
    silences: dict[str, Node] = field(default_factory=dict)  # `silent_when` of a command, by its full name

    def resolve(self, nodes: list[Node]) -> tuple[m.Set, ...]:
        found: dict[str, m.Set] = {}
        pending = sorted(nodes, key=lambda n: ("repeats" in n, n["set"].value))
        for node in pending:
            name = node["name"].value
            if name in found:
                self.problems.add(node["name"].position, f"two sets are called '{name}'; rename one")
                continue
            found[name] = self.set(node, found)
        self.types.unused()
        return self.silenced(sorted(found.values(), key=lambda s: s.number))

    def set(self, node: Node, others: dict[str, m.Set]) -> m.Set:
        number, name = node["set"].value, node["name"].value
        kind: Kind = "command" if number < 0x80 else "shared" if number == m.SHARED_SET else "data"
        fields: list[m.Field] = []
        for entry in node.get("fields") or ():
            fields += self.field(entry, number, name, kind)
        fields = self.shared(node, fields)
        fields += self.repeats(node, number, name, kind, others)
        order = {m.COMMAND: 0, m.DATA: 0, m.RESPONSE: 1}
        fields.sort(key=lambda f: (order[f.role], f.descriptor))
        return m.Set(
            number, name, kind, node["title"].value, node["description"].value, self.types.of(name), tuple(fields),
            sources(node, self.types.vocabulary, self.problems), self.named(node, kind, others),
            sentences(node, "uncertain"), node.position,
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
        record = self.types.record(list(node.get("parameters") or ()), set_name, letters, whole=node)
        command = m.Field(
            set=number, set_name=set_name, name=node["name"].value, descriptor=node[role].value, role=role,
            title=node["title"].value, description=node["description"].value,
            parameters=record.parameters, operations=record.operations,
            min_size=record.min_size, max_size=record.max_size,
            sources=sources(node, self.types.vocabulary, self.problems),
            functions=functions,
            max_rate=node.scalar("max_rate"), timeout=node.scalar("timeout"),
            advanced=node.scalar("advanced", False), deprecated=node.scalar("deprecated"),
            sent_by=node.scalar("sent_by", "host"), also=sentences(node, "also"), keywords=sentences(node, "keywords"),
            notes=sentences(node, "notes"), uncertain=sentences(node, "uncertain"),
            short=short_name(node, node["name"].value, self.problems), position=node.position,
        )  # fmt: skip
        if role == m.COMMAND and "silent_when" in node:
            self.silences[command.full_name] = node["silent_when"]
        responses, names = [], []
        for entry in node.get("responses") or ():
            made = self.response(entry, node, command)
            if made is not None:
                responses.append(made)
            if made is not None or "same_as" in entry:
                names.append(made.name if made else entry["same_as"].value)
        return [replace(command, responses=tuple(names)), *responses]

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
        nodes = self.described(node, nodes, command, plain)
        record = self.types.record(nodes, command.set_name, plain=plain, whole=node)
        lengths = node.get("lengths")
        for manual in lengths.value if lengths else ():
            known = [s.manual for s in command.sources]
            if manual not in known:
                assert lengths is not None
                self.problems.add(
                    lengths.keys[manual], f"the command cites no manual '{manual}'{nearest(manual, known)}"
                )
        name = node.scalar("name", f"{command.name}_response")
        usual = f"{command.short}_response" if command.short and "name" not in node else None
        return m.Field(
            set=command.set, set_name=command.set_name, name=name,
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
            command=command.name, devices=self.devices(node.get("devices")),
            when=self.conditions(node.get("when"), command),
            also=(*(f"{name}_response" for name in command.also if "name" not in node), *sentences(node, "also")),
            notes=sentences(node, "notes"), uncertain=sentences(node, "uncertain"),
            short=short_name(node, name, self.problems) or usual, position=node.position,
        )  # fmt: skip

    def described(self, node: Node, nodes: list[Node], command: m.Field, plain: bool) -> list[Node]:
        """The parameters of a response, with its own descriptions of those that it has from its command."""
        own = node.get("descriptions")
        if own is None:
            return nodes
        if not plain:
            place = node.keys["descriptions"]
            remedy = "give each parameter its own description"
            self.problems.add(place, f"descriptions are for a response with parameters: as_command; {remedy}")
            return nodes
        nodes = list(self.types.included(nodes, command.set_name))
        known = [n["name"].value for n in nodes]
        for name in own.value:
            if name not in known:
                self.problems.add(own.keys[name], f"the command has no parameter '{name}'{nearest(name, known)}")
        return [
            Node({**n.value, "description": own[name]}, n.position, n.keys) if (name := n["name"].value) in own else n
            for n in nodes
        ]

    def devices(self, node: Node | None) -> tuple[str, ...]:
        """The devices that send a layout."""
        known = self.types.vocabulary.devices
        for entry in node or ():
            if entry.value not in known:
                self.problems.add(entry.position, f"unknown device '{entry.value}'{nearest(entry.value, known)}")
        return tuple(node.plain()) if node else ()

    # ----------------------------------------------------------------------- conditions

    def conditions(self, node: Node | None, command: m.Field) -> tuple[m.Condition, ...]:
        """Parameters of a command, and the values that they must have."""
        found = [self.condition(name, node.keys[name], entry, command) for name, entry in node.items()] if node else []
        return tuple(c for c in found if c is not None)

    def condition(self, name: str, place: m.Position, entry: Node, command: m.Field) -> m.Condition | None:
        parameter = next((p for p in command.parameters if p.name == name), None)
        if parameter is None:
            near = nearest(name, [p.name for p in command.parameters])
            self.problems.add(place, f"the command has no parameter '{name}'{near}")
            return None
        value = entry.value
        if isinstance(value, str) and isinstance(parameter.element, m.Enum):
            known = parameter.element.by_name(value)
            if known is not None:
                return m.Condition(name, known.value, value)
            near = nearest(value, [v.name for v in parameter.element.values])
            self.problems.add(entry.position, f"'{parameter.element.name}' has no value '{value}'{near}")
        elif isinstance(value, (bool, int)):
            return m.Condition(name, int(value), str(value).lower())
        else:
            wanted = "a whole number, true, false, or the name of a value of its enumeration"
            self.problems.add(entry.position, f"'{name}' must be {wanted}")
        return None

    def silenced(self, sets: list[m.Set]) -> tuple[m.Set, ...]:
        """The same sets, with what keeps commands from being acknowledged: it may be a setting of any command."""
        commands = {f.full_name: f for s in sets for f in s.fields if f.role == m.COMMAND}
        found: dict[str, m.Field] = {}
        for name, node in self.silences.items():
            own: list[m.Condition] = []
            others: list[m.Condition] = []
            for path, entry in node.items():
                place = node.keys[path]
                other, _, parameter = path.rpartition(".")
                if other and other not in commands:
                    self.problems.add(place, f"no command '{other}'{nearest(other, commands)}")
                elif c := self.condition(parameter, place, entry, commands[other or name]):
                    (others if other else own).append(replace(c, command=other or None))
            found[name] = replace(commands[name], silent_when=tuple(own), silenced_by=tuple(others))
        return tuple(replace(s, fields=tuple(found.get(f.full_name, f) for f in s.fields)) for s in sets)

    def shared(self, node: Node, fields: list[m.Field]) -> list[m.Field]:
        """Every same_as names a response of this set; what does not is dropped once it is reported."""
        known = [f.name for f in fields if f.role == m.RESPONSE]
        for entry in node.get("fields") or ():
            for response in entry.get("responses") or ():
                name = response.scalar("same_as")
                if name is not None and name not in known:
                    place = response["same_as"].position
                    self.problems.add(place, f"no command of this set has the response '{name}'{nearest(name, known)}")
        return [replace(f, responses=tuple(name for name in f.responses if name in known)) for f in fields]

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
        if "fields" not in node["repeats"] and not self.whole(node):
            self.problems.add(
                node.keys["repeats"],
                "list the fields that are repeated in 'fields', or give 'sources' to repeat them all",
            )
        known = {f.name: f for f in origin.own_fields if f.role == m.DATA}
        found: dict[str, m.Field] = {}

        def repeat(
            field: m.Field, title: str, short: str | None, cited: tuple[m.Source, ...], place: m.Position
        ) -> None:
            found[field.name] = replace(
                field,
                set=number,
                set_name=set_name,
                definition=field.full_name,
                title=title,
                short=short,
                sources=cited,
                position=place,
            )

        for entry in node["repeats"].get("fields") or ():
            name = entry["name"].value
            field = known.get(name)
            if field is None:
                near = nearest(name, known)
                self.problems.add(entry["name"].position, f"the set '{of.value}' has no data field '{name}'{near}")
                continue
            if name in found:
                self.problems.add(entry["name"].position, f"'{name}' is listed twice; remove one")
            cited = sources(entry, self.types.vocabulary, self.problems)
            short = short_name(entry, name, self.problems) or field.short
            repeat(field, entry.scalar("title", field.title), short, cited, entry.position)
        if self.whole(node):
            cited = sources(node["repeats"], self.types.vocabulary, self.problems)
            for name, field in known.items():
                if name not in found:
                    repeat(field, field.title, field.short, cited, of.position)
        return list(found.values())

    @staticmethod
    def whole(node: Node) -> bool:
        """Does a set repeat all of another? Then it gives the sources of all those that it does not list."""
        return "repeats" in node and "sources" in node["repeats"]

    def named(self, node: Node, kind: Kind, others: dict[str, m.Set]) -> tuple[m.Named, ...]:
        """Descriptors without a layout, those of a set that this one repeats as a whole included."""
        found: list[m.Named] = []
        for entry in node.get("named") or ():
            roles: list[m.Role] = [r for r in ROLES if r in entry]
            if len(roles) != 1 or (roles == [m.DATA]) != (kind != "command"):
                wanted = "'command: 0x..' or 'response: 0x..'" if kind == "command" else "'data: 0x..'"
                self.problems.add(entry.position, f"a named descriptor of a {kind} set has {wanted}")
                continue
            found.append(
                m.Named(
                    entry[roles[0]].value, roles[0], entry["name"].value, entry["title"].value,
                    sources(entry, self.types.vocabulary, self.problems), entry.position,
                )
            )  # fmt: skip
        origin = others.get(node["repeats"]["of"].value) if self.whole(node) else None
        found += origin.named if origin else ()
        return tuple(sorted(found, key=lambda x: (x.role == m.RESPONSE, x.descriptor)))
