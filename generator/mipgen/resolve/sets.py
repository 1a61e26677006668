"""Resolves families: descriptor sets, the fields that occur in them, and their responses."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, elsewhere, nearest

from .types import Types
from .vocabulary import cited, short_name, texts_of_node

ROLES: tuple[m.Role, ...] = (m.COMMAND, m.RESPONSE, m.DATA)

#: Keys that only commands may have.
COMMAND_KEYS = ("affects", "alternatives", "functions", "responses", "silent_when", "sent_by", "timeout")


@dataclass
class Families:
    types: Types
    problems: Problems
    silences: dict[str, Node] = field(default_factory=dict)  # `silent_when` of a command, by its full name
    changes: list[Node] = field(default_factory=list)  # commands that state what they change
    alternatives: list[Node] = field(default_factory=list)  # names of commands that replace others

    def resolve(self, nodes: list[Node]) -> tuple[m.Family, ...]:
        families: dict[str, m.Family] = {}
        for node in sorted(nodes, key=_first):
            name = node["name"].value
            if name in families:
                where = elsewhere(families[name])
                self.problems.add(node["name"].position, f"two sets are called '{name}', {where}; rename one")
                continue
            families[name] = self.family(node)
        self.types.unused()
        homes = {name: name for name in families}
        for s in (s for x in families.values() for s in x.sets):
            if homes.setdefault(s.name, s.family) != s.family:
                where = elsewhere(families[homes[s.name]])
                self.problems.add(s.position, f"two sets are called '{s.name}', {where}; rename one")
        self.related([f for x in families.values() for f in x.fields], homes)
        return self.silenced(sorted(families.values(), key=lambda x: x.number))

    def family(self, node: Node) -> m.Family:
        name = node["name"].value
        sets = self.sets(node)
        kind = self.meant(node, sets[0])
        sets = tuple(replace(s, kind=kind) for s in sets) if kind != sets[0].kind else sets
        fields: list[m.Field] = []
        for entry in node.get("fields") or ():
            fields += self.field(entry, name, kind, sets, "sets" in node)
        fields = self.shared(node, fields)
        order = {m.COMMAND: 0, m.DATA: 0, m.RESPONSE: 1}
        fields.sort(key=lambda f: (order[f.role], f.descriptor, -_constants(f)))  # the most specific layout first
        return m.Family(
            name, kind, node["title"].value, node["description"].value, sets, self.types.of(name), tuple(fields),
            self.cited(name) if "set" in node else (), self.named(node, kind),
            texts_of_node(node, "uncertain"), node.position,
        )  # fmt: skip

    def meant(self, node: Node, first: m.Set) -> m.Kind:
        """Returns the kind of a set. If all its fields are of the other kind, reports the set instead of each field."""
        entries = [*(node.get("fields") or ()), *(node.get("named") or ())]
        commands = first.kind == "command"
        wrong, others = (m.DATA, (m.COMMAND, m.RESPONSE)) if commands else (m.COMMAND, (m.DATA,))
        roles = {role for entry in entries for role in ROLES if role in entry}
        if wrong not in roles or roles & {*others}:
            return first.kind
        kind: m.Kind = "command" if wrong == m.COMMAND else "data"
        if "set" not in node and commands:
            return kind  # reported: such a set is not part of a family
        number = node["set"] if "set" in node else next(n["set"] for _, n in node["sets"].items())
        content, numbers = ("commands", "0x01 to 0x7F") if wrong == m.COMMAND else ("data fields", "0x80 to 0xFE")
        self.problems.add(
            number.position,
            f"0x{first.number:02X} is a {first.kind} set, but all fields of '{node['name'].value}' are {content}; "
            f"use {numbers}, or begin its fields with '{m.DATA if wrong == m.COMMAND else m.COMMAND}: 0x..'",
        )
        return kind

    def sets(self, node: Node) -> tuple[m.Set, ...]:
        """Returns the descriptor sets of a family: the one with its name, or those in `sets`."""
        family = node["name"].value
        if "sets" in node and "set" in node:
            self.problems.add(node.keys["set"], "a family has 'sets', not 'set'; remove 'set'")
        if "sets" not in node:
            return (self.set(node, node["set"].value, family, family, node.position),)
        sets: list[m.Set] = []
        for name, entry in node["sets"].items():
            s = self.set(entry, entry["set"].value, name, family, node["sets"].keys[name])
            sets.append(s)
            if s.kind != "data":
                self.problems.add(entry["set"].position, f"'{name}' is a {s.kind} set; only data sets share fields")
        return tuple(sorted(sets, key=lambda s: s.number))

    def set(self, node: Node, number: int, name: str, family: str, place: m.Position) -> m.Set:
        kind: m.Kind = "command" if number in m.COMMAND_SETS else "data" if number in m.DATA_SETS else "shared"
        return m.Set(
            number, name, kind, node["title"].value, node["description"].value, family,
            self.cited(name), texts_of_node(node, "uncertain"), self.types.needs(node),
            place,
        )  # fmt: skip

    def cited(self, name: str, heading: str | None = None) -> tuple[m.Source, ...]:
        """Returns the sources of what has this name."""
        return cited(name, self.types.vocabulary, self.problems, heading)

    def field(self, node: Node, family: str, kind: m.Kind, sets: tuple[m.Set, ...], several: bool) -> list[m.Field]:
        """Resolves a command with its responses, or a data field."""
        role: m.Role = m.COMMAND if kind == "command" else m.DATA
        wrong = m.DATA if role == m.COMMAND else m.COMMAND
        if role not in node or wrong in node:
            place = node.keys.get(wrong, node.position)
            self.problems.add(place, f"a field of the {kind} set '{family}' must begin with '{role}: 0x..'")
            return []
        for key in COMMAND_KEYS:
            if role == m.DATA and key in node:
                self.problems.add(node.keys[key], f"a {role} field has no '{key}'; remove it")
        letters = node.scalar("functions", "") if role == m.COMMAND else ""
        functions = self.types.vocabulary.letters(letters)
        unknown = sorted(set(letters) - {f.letter for f in functions})
        if unknown:
            every = "".join(f.letter for f in self.types.vocabulary.functions)
            self.problems.add(node["functions"].position, f"no function has the letter {unknown[0]}; known: {every}")
            letters = "".join(c for c in letters if c not in unknown)
        record = self.types.record(
            list(node.get("parameters") or ()), family, letters, whole=node, unknown="".join(unknown)
        )
        (occurrences, cited), affects = self.places(node, sets, several), texts_of_node(node, "affects")
        words = tuple(w.value for w in self.types.vocabulary.keywords.entries_of(f"{family}.{node['name'].value}"))
        command = m.Field(
            family=family, occurrences=occurrences, name=node["name"].value, descriptor=node[role].value, role=role,
            title=_title(node), description=node["description"].value,
            parameters=record.parameters,
            min_size=record.min_size, max_size=record.max_size,
            sources=cited,
            functions=functions, everywhere=m.DATA_SETS if kind == "shared" else None,
            affects=tuple(x for x in affects if x[-1] != "?"),
            may_affect=tuple(x[:-1] for x in affects if x[-1] == "?"),
            alternatives=texts_of_node(node, "alternatives"), timeout=node.scalar("timeout"),
            advanced=node.scalar("advanced", False), deprecated=node.scalar("deprecated"),
            sent_by=node.scalar("sent_by", "host"), also=texts_of_node(node, "also"), keywords=words,
            needs=self.types.needs(node),
            notes=texts_of_node(node, "notes"), uncertain=texts_of_node(node, "uncertain"),
            short=short_name(node, node["name"].value, self.problems), position=node.position,
        )  # fmt: skip
        if role == m.COMMAND and affects:
            self.changes.append(node)
        if role == m.COMMAND:
            self.alternatives += node.get("alternatives") or ()
        if role == m.COMMAND and "silent_when" in node:
            self.silences[command.full_name] = node["silent_when"]
        responses, names = [], []
        for entry in node.get("responses") or ():
            made = self.response(entry, node, command)
            if made is not None:
                responses.append(made)
            if made is not None or _shares(entry):
                names.append(made.name if made else entry["response"].value)
        specific = {r.name: _constants(r) for r in responses}
        names.sort(key=lambda name: -specific.get(name, 0))  # like their fields: the most specific layout first
        return [replace(command, responses=tuple(names)), *responses]

    def places(
        self, node: Node, sets: tuple[m.Set, ...], several: bool
    ) -> tuple[tuple[m.Occurrence, ...], tuple[m.Source, ...]]:
        """Returns the sets of a field, all of its family or those that it lists, with its sources in each; and the
        sources of the field itself: those that are about it, or else about all fields of its sets."""
        listed = list(node.get("in") or ())
        if listed and not several:
            self.problems.add(node.keys["in"], "only a family of several sets has 'in'; remove it")
        set_names = [s.name for s in sets]
        for entry in listed if several else ():
            if entry.value not in set_names:
                near = nearest(entry.value, set_names)
                self.problems.add(entry.position, f"the family has no set '{entry.value}'{near}")
        names = {entry.value for entry in listed} & {*set_names} or {*set_names}
        own: list[m.Source] = []
        occurrences: list[m.Occurrence] = []
        for s in sets:
            if s.name in names:
                cited = self.cited(f"{s.name}.{node['name'].value}", _heading(node, s.number))
                own += cited
                every = self.cited(f"{s.name}.*") if several else ()
                occurrences.append(m.Occurrence(s.number, s.name, _title(node), cited or every, position=node.position))
        return tuple(occurrences), tuple(dict.fromkeys(own or [x for o in occurrences for x in o.sources]))

    def response(self, node: Node, owner: Node, command: m.Field) -> m.Field | None:
        if _shares(node):
            for key in set(node.value) - {"response"}:
                self.problems.add(node.keys[key], f"the response of another command has no '{key}' here; remove it")
            return None
        listed = node.get("parameters")
        described = listed is not None and isinstance(listed.value, dict)
        plain = listed is not None and (described or listed.value == "as_command")
        if listed is not None and isinstance(listed.value, str) and not plain:
            self.problems.add(listed.position, f"'parameters' must be a list or as_command, not '{listed.value}'")
            return None
        nodes = list((owner.get("parameters") or ()) if plain else (listed or ()))
        if listed is not None and described:
            nodes = self.described(listed, nodes, command)
        record = self.types.record(nodes, command.family, plain=plain, whole=node)
        name = node.scalar("name", f"{command.name}_response")
        lengths = self.lengths(f"{command.family}.{name}", command)
        usual = f"{command.short}_response" if command.short and "name" not in node else None
        title = node.scalar("title", f"{command.title} response")
        cited = tuple(
            replace(s, length=str(lengths[s.manual].value), position=lengths[s.manual].position)
            if s.manual in lengths
            else replace(s, length=None)
            for s in command.sources
        )
        return m.Field(
            family=command.family, occurrences=tuple(
                replace(o, title=title, sources=cited, position=node.position) for o in command.occurrences
            ), name=name,
            descriptor=node["response"].value, role=m.RESPONSE,
            title=title,
            description=node.scalar("description", ""),
            parameters=record.parameters,
            min_size=record.min_size, max_size=record.max_size,
            sources=cited,
            command=command.name, devices=self.devices(node.get("devices")),
            when=self.conditions(node.get("when"), command),
            also=(*(f"{name}_response" for name in command.also if "name" not in node), *texts_of_node(node, "also")),
            notes=texts_of_node(node, "notes"), uncertain=texts_of_node(node, "uncertain"),
            short=short_name(node, name, self.problems) or usual, position=node.position,
        )  # fmt: skip

    def lengths(self, name: str, command: m.Field) -> dict[str, Node]:
        """Returns the length of a response that each manual prints."""
        manuals, lengths = [s.manual for s in command.sources], {}
        for entry in self.types.vocabulary.evidence.entries_of(name):
            manual = entry["manual"]
            if manual.value not in manuals:
                message = f"the command does not cite the manual '{manual.value}'{nearest(manual.value, manuals)}"
                self.problems.add(manual.position, message)
            elif "section" in entry or "length" not in entry:
                message = f"a source of '{name}' needs a length only; its section is that of the command"
                self.problems.add(entry.position, message)
            else:
                lengths[manual.value] = entry["length"]
        return lengths

    def described(self, own: Node, nodes: list[Node], command: m.Field) -> list[Node]:
        """Returns the parameters of a command for its response, which describes some of them itself."""
        nodes = list(self.types.included(nodes, command.family))
        names = [n["name"].value for n in nodes]
        for name in own.value:
            if name not in names:
                self.problems.add(own.keys[name], f"the command has no parameter '{name}'{nearest(name, names)}")
        return [
            Node({**n.value, "description": own[name]}, n.position, n.keys) if (name := n["name"].value) in own else n
            for n in nodes
        ]

    def devices(self, node: Node | None) -> tuple[str, ...]:
        """Resolves the devices that send a layout."""
        ids = self.types.vocabulary.devices
        for entry in node or ():
            if entry.value not in ids:
                self.problems.add(entry.position, f"unknown device '{entry.value}'{nearest(entry.value, ids)}")
        return tuple(node.plain()) if node else ()

    # ----------------------------------------------------------------------- conditions

    def conditions(self, node: Node | None, command: m.Field) -> tuple[m.Condition, ...]:
        """Resolves conditions: parameters of a command, and the values that they must have."""
        if node is None:
            return ()
        conditions = (self.condition(name, node.keys[name], entry, command) for name, entry in node.items())
        return tuple(c for c in conditions if c is not None)

    def condition(self, name: str, place: m.Position, entry: Node, command: m.Field) -> m.Condition | None:
        parameter = next((p for p in command.parameters if p.name == name), None)
        if parameter is None:
            near = nearest(name, [p.name for p in command.parameters])
            self.problems.add(place, f"the command has no parameter '{name}'{near}")
            return None
        value = entry.value
        if isinstance(value, str) and isinstance(parameter.element, m.Enum):
            enum_value = parameter.element.by_name(value)
            if enum_value is not None:
                return m.Condition(name, enum_value.value, value)
            near = nearest(value, [v.name for v in parameter.element.values])
            self.problems.add(entry.position, f"'{parameter.element.name}' has no value '{value}'{near}")
        elif isinstance(value, (bool, int)):
            return m.Condition(name, int(value), str(value).lower())
        else:
            wanted = "a whole number, true, false, or the name of a value of its enumeration"
            self.problems.add(entry.position, f"'{name}' must be {wanted}")
        return None

    # ----------------------------------------------------------------------- relations

    def related(self, fields: Sequence[m.Field], sets: Collection[str]) -> None:
        """Checks that all that commands and bits relate to exists, and that commands name what they change once."""
        names = {name: f.role for f in fields for name in f.names}
        data = [name for name, role in names.items() if role == m.DATA]
        for node in self.changes:
            listed: set[str] = set()
            for entry in sorted(node["affects"], key=lambda entry: entry.value[-1] == "?"):
                changed = entry.value.rstrip("?")
                if changed not in sets and changed not in data:
                    near = nearest(changed, data if "." in changed else sets)
                    self.problems.add(entry.position, f"no data field or set '{changed}'{near}")
                elif changed in listed or changed.partition(".")[0] in listed:
                    self.problems.add(entry.position, f"the command already lists '{changed}' as changed; remove it")
                listed.add(changed)
        for entry in self.alternatives:
            if names.get(entry.value) != m.COMMAND:
                near = nearest(entry.value, [name for name, role in names.items() if role == m.COMMAND])
                self.problems.add(entry.position, f"no command '{entry.value}'{near}")
        for entry in self.types.concerned:
            if names.get(entry.value) not in (m.COMMAND, m.DATA):
                near = nearest(entry.value, [name for name, role in names.items() if role != m.RESPONSE])
                self.problems.add(entry.position, f"no command or data field '{entry.value}'{near}")

    def silenced(self, families: list[m.Family]) -> tuple[m.Family, ...]:
        """Adds the conditions that suppress acknowledges, which may be settings of other commands."""
        commands = {f.full_name: f for x in families for f in x.fields if f.role == m.COMMAND}
        changed: dict[str, m.Field] = {}
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
            changed[name] = replace(commands[name], silent_when=tuple(own), silenced_by=tuple(others))
        return tuple(replace(x, fields=tuple(changed.get(f.full_name, f) for f in x.fields)) for x in families)

    def shared(self, node: Node, fields: list[m.Field]) -> list[m.Field]:
        """Reports and drops each name of a shared response that is not one of this set."""
        names = [f.name for f in fields if f.role == m.RESPONSE]
        for entry in node.get("fields") or ():
            for response in entry.get("responses") or ():
                name = response["response"].value
                if _shares(response) and name not in names:
                    place = response["response"].position
                    self.problems.add(place, f"no command of this set has the response '{name}'{nearest(name, names)}")
        return [replace(f, responses=tuple(name for name in f.responses if name in names)) for f in fields]

    def named(self, node: Node, kind: m.Kind) -> tuple[m.Named, ...]:
        """Resolves the descriptors without a layout."""
        named: list[m.Named] = []
        for entry in node.get("named") or ():
            roles: list[m.Role] = [r for r in ROLES if r in entry]
            if len(roles) != 1 or (roles == [m.DATA]) != (kind != "command"):
                wanted = "'command: 0x..' or 'response: 0x..'" if kind == "command" else "'data: 0x..'"
                self.problems.add(entry.position, f"a named descriptor of a {kind} set must have {wanted}")
                continue
            named.append(
                m.Named(
                    entry[roles[0]].value, roles[0], entry["name"].value, _title(entry),
                    self.cited(f"{node['name'].value}.{entry['name'].value}", _heading(entry, _first(node))),
                    entry.position,
                )
            )  # fmt: skip
        return tuple(sorted(named, key=lambda x: (x.role == m.RESPONSE, x.descriptor)))


def _shares(response: Node) -> bool:
    """True for a response that names that of another command, in place of its descriptor."""
    return isinstance(response["response"].value, str)


def _title(node: Node) -> str:
    """Returns the title of a field in headings; by default its name in words."""
    return str(node.scalar("title", node["name"].value.replace("_", " ").capitalize()))


def _heading(node: Node, number: int) -> str:
    """Returns the heading that most sources use for a field: "Ping (0x01,0x01)"."""
    descriptor = next((node[role].value for role in ROLES if role in node), 0)
    return f"{_title(node)} (0x{number:02X},0x{descriptor:02X})"


def _first(node: Node) -> int:
    """Returns the lowest number of the sets of a file."""
    entries = [entry for _, entry in node["sets"].items()] if "sets" in node else [node]
    return min(int(entry["set"].value) for entry in entries)


def _constants(f: m.Field) -> int:
    return sum(p.kind == "constant" for p in f.always)
