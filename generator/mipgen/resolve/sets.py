"""Resolves families: descriptor sets, the fields that occur in them, and their responses."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

from .types import Types
from .vocabulary import sentences, short_name, sources

ROLES: tuple[m.Role, ...] = (m.COMMAND, m.RESPONSE, m.DATA)

#: Keys that only commands may have.
COMMAND_KEYS = ("affects", "functions", "may_affect", "responses", "silent_when", "sent_by", "timeout")
DATA_KEYS = ("max_rate",)


@dataclass
class Families:
    types: Types
    problems: Problems
    silences: dict[str, Node] = field(default_factory=dict)  # `silent_when` of a command, by its full name
    changes: list[Node] = field(default_factory=list)  # commands that state what they change

    def resolve(self, nodes: list[Node]) -> tuple[m.Family, ...]:
        families: dict[str, m.Family] = {}
        for node in sorted(nodes, key=_first):
            name = node["name"].value
            if name in families:
                self.problems.add(node["name"].position, f"two sets are called '{name}'; rename one")
                continue
            families[name] = self.family(node)
        self.types.unused()
        homes = {name: name for name in families}
        for s in (s for x in families.values() for s in x.sets):
            if homes.setdefault(s.name, s.family) != s.family:
                self.problems.add(s.position, f"two sets are called '{s.name}'; rename one")
        self.related([f for x in families.values() for f in x.fields], homes)
        return self.silenced(sorted(families.values(), key=lambda x: x.number))

    def family(self, node: Node) -> m.Family:
        name = node["name"].value
        sets = self.sets(node)
        kind = self.meant(node, sets[0])
        sets = tuple(replace(s, kind=kind) for s in sets) if kind != sets[0].kind else sets
        common = {
            name: sources(entry, self.types.vocabulary, self.problems, "every_field")
            for name, entry in (node["sets"].items() if "sets" in node else ())
            if "every_field" in entry
        }
        places = _Places("sets" in node, sets, common, self.types, self.problems)
        fields: list[m.Field] = []
        for entry in node.get("fields") or ():
            fields += self.field(entry, name, kind, places)
        fields = self.shared(node, fields)
        order = {m.COMMAND: 0, m.DATA: 0, m.RESPONSE: 1}
        fields.sort(key=lambda f: (order[f.role], f.descriptor, -_constants(f)))  # the most specific layout first
        return m.Family(
            name, kind, node["title"].value, node["description"].value, sets, self.types.of(name), tuple(fields),
            sources(node, self.types.vocabulary, self.problems), self.named(node, kind),
            sentences(node, "uncertain"), node.position,
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
        what, right = ("commands", "0x01 to 0x7F") if wrong == m.COMMAND else ("data fields", "0x80 to 0xFE")
        self.problems.add(
            number.position,
            f"0x{first.number:02X} is a {first.kind} set, but all fields of '{node['name'].value}' are {what}; "
            f"use {right}, or begin its fields with '{m.DATA if wrong == m.COMMAND else m.COMMAND}: 0x..'",
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
            sources(node, self.types.vocabulary, self.problems), sentences(node, "uncertain"), place,
        )  # fmt: skip

    def field(self, node: Node, family: str, kind: m.Kind, places: _Places) -> list[m.Field]:
        """Resolves a command with its responses, or a data field."""
        role: m.Role = m.COMMAND if kind == "command" else m.DATA
        wrong = m.DATA if role == m.COMMAND else m.COMMAND
        if role not in node or wrong in node:
            place = node.keys.get(wrong, node.position)
            self.problems.add(place, f"a field of the {kind} set '{family}' must begin with '{role}: 0x..'")
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
        record = self.types.record(
            list(node.get("parameters") or ()), family, letters, whole=node, unknown="".join(unknown)
        )
        occurrences = places.of(node)
        command = m.Field(
            family=family, occurrences=occurrences, name=node["name"].value, descriptor=node[role].value, role=role,
            title=_title(node), description=node["description"].value,
            parameters=record.parameters,
            min_size=record.min_size, max_size=record.max_size,
            sources=places.cited(node, occurrences),
            functions=functions, everywhere=m.DATA_SETS if kind == "shared" else None,
            affects=sentences(node, "affects"), may_affect=sentences(node, "may_affect"),
            max_rate=node.scalar("max_rate"), timeout=node.scalar("timeout"),
            advanced=node.scalar("advanced", False), deprecated=node.scalar("deprecated"),
            sent_by=node.scalar("sent_by", "host"), also=sentences(node, "also"), keywords=sentences(node, "keywords"),
            notes=sentences(node, "notes"), uncertain=sentences(node, "uncertain"),
            short=short_name(node, node["name"].value, self.problems), position=node.position,
        )  # fmt: skip
        if role == m.COMMAND and ("affects" in node or "may_affect" in node):
            self.changes.append(node)
        if role == m.COMMAND and "silent_when" in node:
            self.silences[command.full_name] = node["silent_when"]
        responses, names = [], []
        for entry in node.get("responses") or ():
            made = self.response(entry, node, command)
            if made is not None:
                responses.append(made)
            if made is not None or "same_as" in entry:
                names.append(made.name if made else entry["same_as"].value)
        specific = {r.name: _constants(r) for r in responses}
        names.sort(key=lambda name: -specific.get(name, 0))  # like their fields: the most specific layout first
        return [replace(command, responses=tuple(names)), *responses]

    def response(self, node: Node, owner: Node, command: m.Field) -> m.Field | None:
        if "same_as" in node:
            for key in set(node.value) - {"same_as"}:
                self.problems.add(node.keys[key], f"a response with same_as has no '{key}' of its own; remove it")
            return None
        if "response" not in node:
            self.problems.add(
                node.position,
                "a response must begin with 'response: 0x..', or 'same_as' and the name of another command's response",
            )
            return None
        listed = node.get("parameters")
        plain = listed is not None and listed.value == "as_command"
        if listed is not None and isinstance(listed.value, str) and not plain:
            self.problems.add(listed.position, f"'parameters' must be a list or as_command, not '{listed.value}'")
            return None
        nodes = list((owner.get("parameters") or ()) if plain else (listed or ()))
        nodes = self.described(node, nodes, command, plain)
        record = self.types.record(nodes, command.family, plain=plain, whole=node)
        lengths = node.get("lengths")
        for manual in lengths.value if lengths else ():
            known = [s.manual for s in command.sources]
            if manual not in known:
                assert lengths is not None
                self.problems.add(
                    lengths.keys[manual], f"the command does not cite the manual '{manual}'{nearest(manual, known)}"
                )
        name = node.scalar("name", f"{command.name}_response")
        usual = f"{command.short}_response" if command.short and "name" not in node else None
        title = node.scalar("title", f"{command.title} response")
        cited = tuple(
            replace(s, length=str(lengths[s.manual].value), position=lengths[s.manual].position)
            if lengths and s.manual in lengths
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
            also=(*(f"{name}_response" for name in command.also if "name" not in node), *sentences(node, "also")),
            notes=sentences(node, "notes"), uncertain=sentences(node, "uncertain"),
            short=short_name(node, name, self.problems) or usual, position=node.position,
        )  # fmt: skip

    def described(self, node: Node, nodes: list[Node], command: m.Field, plain: bool) -> list[Node]:
        """Returns the parameters of a response; it may describe those that it repeats from its command."""
        own = node.get("descriptions")
        if own is None:
            return nodes
        if not plain:
            place = node.keys["descriptions"]
            remedy = "give each parameter its own description"
            self.problems.add(place, f"only a response with 'parameters: as_command' may have descriptions; {remedy}")
            return nodes
        nodes = list(self.types.included(nodes, command.family))
        known = [n["name"].value for n in nodes]
        for name in own.value:
            if name not in known:
                self.problems.add(own.keys[name], f"the command has no parameter '{name}'{nearest(name, known)}")
        return [
            Node({**n.value, "description": own[name]}, n.position, n.keys) if (name := n["name"].value) in own else n
            for n in nodes
        ]

    def devices(self, node: Node | None) -> tuple[str, ...]:
        """Resolves the devices that send a layout."""
        known = self.types.vocabulary.devices
        for entry in node or ():
            if entry.value not in known:
                self.problems.add(entry.position, f"unknown device '{entry.value}'{nearest(entry.value, known)}")
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

    # ----------------------------------------------------------------------- relations

    def related(self, fields: Sequence[m.Field], sets: Collection[str]) -> None:
        """Checks that everything that commands change or bits concern exists, and that commands name it only once."""
        names = {name: f.role for f in fields for name in f.names}
        data = [name for name, role in names.items() if role == m.DATA]
        for node in self.changes:
            said: set[str] = set()
            for entry in (*(node.get("affects") or ()), *(node.get("may_affect") or ())):
                if entry.value not in sets and entry.value not in data:
                    near = nearest(entry.value, data if "." in entry.value else sets)
                    self.problems.add(entry.position, f"no data field or set '{entry.value}'{near}")
                elif entry.value in said or entry.value.partition(".")[0] in said:
                    self.problems.add(
                        entry.position, f"the command already lists '{entry.value}' as changed; remove it"
                    )
                said.add(entry.value)
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
        """Reports and drops each `same_as` that does not name a response of this set."""
        known = [f.name for f in fields if f.role == m.RESPONSE]
        for entry in node.get("fields") or ():
            for response in entry.get("responses") or ():
                name = response.scalar("same_as")
                if name is not None and name not in known:
                    place = response["same_as"].position
                    self.problems.add(place, f"no command of this set has the response '{name}'{nearest(name, known)}")
        return [replace(f, responses=tuple(name for name in f.responses if name in known)) for f in fields]

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
                    sources(entry, self.types.vocabulary, self.problems, heading=_heading(entry, _first(node))),
                    entry.position,
                )
            )  # fmt: skip
        return tuple(sorted(named, key=lambda x: (x.role == m.RESPONSE, x.descriptor)))


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


@dataclass(frozen=True, slots=True)
class _Places:
    """The sets in which the fields of a family occur: its only set, or those with `every_field` and those that a field
    lists."""

    several: bool
    sets: tuple[m.Set, ...]
    common: dict[str, tuple[m.Source, ...]]  # set -> the sources according to which all fields occur there
    types: Types
    problems: Problems

    def of(self, node: Node) -> tuple[m.Occurrence, ...]:
        """Returns the sets of a field, with the facts about it in each."""
        title, cited = _title(node), self.sources(node, node)
        own = node.get("in")
        if not self.several:
            for key in ("in", "only"):
                if key in node:
                    self.problems.add(node.keys[key], f"only a family of several sets has '{key}'; remove it")
            return self.first(title, cited, node)
        listed = dict(own.items()) if own else {}
        known = [s.name for s in self.sets]
        only = [n.value for n in node.get("only") or ()]
        named = [(name, own.keys[name]) for name in listed] if own else []
        for name, place in (*named, *((n.value, n.position) for n in node.get("only") or ())):
            if name not in known:
                self.problems.add(place, f"the family has no set '{name}'{nearest(name, known)}")
        occurrences = tuple(
            self.occurrence(title, cited, s, listed.get(s.name), node)
            for s in self.sets
            if (s.name in only if only else s.name in listed or s.name in self.common)
        )
        if not occurrences:
            if {*listed, *only} - {*known}:
                return self.first(title, cited, node)
            remedy = "list its sets in 'in', or give a set 'every_field'"
            self.problems.add(node.position, f"'{node['name'].value}' occurs in no set: {remedy}")
            return self.first(title, cited, node)
        return occurrences

    def sources(self, node: Node, field: Node, s: m.Set | None = None) -> tuple[m.Source, ...]:
        """Returns the sources that a field cites, or that it cites for one of its sets."""
        heading = _heading(field, (s or self.sets[0]).number)
        return sources(node, self.types.vocabulary, self.problems, heading=heading)

    def first(self, title: str, cited: tuple[m.Source, ...], node: Node) -> tuple[m.Occurrence, ...]:
        """Returns the only set, or the first of several as a substitute, to find further problems."""
        s = self.sets[0]
        return (m.Occurrence(s.number, s.name, title, cited, position=node.position),)

    def occurrence(
        self, title: str, cited: tuple[m.Source, ...], s: m.Set, own: Node | None, node: Node
    ) -> m.Occurrence:
        usual = self.common.get(s.name) or cited
        if own is None:
            return m.Occurrence(s.number, s.name, title, usual, position=node.position)
        stated = self.sources(own, node, s) or usual
        title = own.scalar("title", title)
        return m.Occurrence(s.number, s.name, title, stated, sentences(own, "uncertain"), own.position)

    def cited(self, node: Node, occurrences: tuple[m.Occurrence, ...]) -> tuple[m.Source, ...]:
        """Returns the sources of the field itself; if there are none, the sources for all fields of its sets."""
        own = node.get("in")
        cited = list(self.sources(node, node))
        cited += [s for o in occurrences if own and o.set_name in own for s in o.sources]
        return tuple(dict.fromkeys(cited or [s for o in occurrences for s in o.sources]))


def _constants(f: m.Field) -> int:
    return sum(p.kind == "constant" for p in f.always)
