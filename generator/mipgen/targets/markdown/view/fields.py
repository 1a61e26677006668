"""Fields: facts about them, their packets and replies byte by byte, and what refers to them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.model.guides import Guide

from ..offsets import length
from ..places import Page, field_page, on_page, programs_page
from ..snippets import Program, of_field, shown
from ..text import code, hexadecimal, inline, spaced, table
from .base import View, citation, length_remark, manual_link
from .examples import typical_pieces
from .frames import drawings
from .parameters import Parameters, Values, values_of

#: Facts that are in tables, and facts with sections of their own.
TABLED = ("functions", "responses")
RELATIONS = ("alternatives", "affects", "may_affect", "affected", "flags")
DEVICES = ("devices", "likely", "assumed", "refused", "deprecation", "support")
#: Longer replies are not shown beside their command, and of more values only the first ones are.
SHORT, SHOWN = 36, 3


class Field(View[m.Field]):
    """A command, a data field, or the acknowledge; `Response` is the view of a response."""

    # ----------------------------------------------------------------------- facts

    @property
    def facts(self) -> str:
        """The facts besides the description. The only command of a response is omitted, as the page begins with it."""
        above = ["commands"] if self.of.role == m.RESPONSE and len(self.model.commands(self.of)) == 1 else []
        elsewhere = (*TABLED, *RELATIONS, *DEVICES, "firmware", "note", *above)
        facts = [x for x in describe.field(self.of, self.model) if x.topic not in elsewhere]
        sentences = [(x.topic, self.page.markdown(x.sentence)) for x in facts]
        return " ".join(f"**{sentence}**" if topic == "deprecated" else sentence for topic, sentence in sentences)

    @property
    def notes(self) -> list[str]:
        return self._sentences("note") if self.of.role == m.RESPONSE else self._sentences("firmware", "note")

    @property
    def relations(self) -> list[str]:
        """The fields that the field changes, the fields that change it, and the flags that concern it."""
        return self._sentences(*RELATIONS)

    @property
    def devices(self) -> list[str]:
        """The devices that support the field, and their differences."""
        return self._sentences(*DEVICES)

    def _sentences(self, *topics: str) -> list[str]:
        return self.page.sentences(describe.topics(describe.field(self.of, self.model), *topics))

    @property
    def drawings(self) -> list[str]:
        """Pictures of the frames in which parameters are."""
        frames = {row.row.parameter.frame for row in self.parameters.rows if row.row.parameter}
        return [self.page.picture(x.path, x.words) for x in drawings(self.model) if x.name in frames]

    # ----------------------------------------------------------------------- parameters

    @cached_property
    def parameters(self) -> Parameters:
        return Parameters(self.page, self.of)

    @property
    def values(self) -> list[Values]:
        """The values and bits of the parameters of all fields on the page."""
        return values_of(self.page, on_page(self.of, self.model))

    @property
    def length(self) -> str:
        """The length of a field without a function selector."""
        (call,) = self.of.calls
        required, whole = length(call.required), length(self.of.parameters)
        return whole if required == whole else f"{required}; {whole} with all optional parameters"

    @property
    def responses(self) -> list[Response]:
        """The responses that a command defines, which are described on its page."""
        return [Response(self.page, r, self) for r in on_page(self.of, self.model)[1:]]

    # ----------------------------------------------------------------------- packets

    @property
    def forms(self) -> str:
        """The forms of a command, one for each function or just one: packets with typical values, and the replies. A
        function that no device is known to accept has no packet."""
        samples = self.page.index.samples
        rows = []
        for c in self.of.calls:
            accepted = any(x is c for x in samples.sent(self.of))
            function = [f"{code(c.function.name)} ({c.function.letter}, {c.function.value})"] if c.function else []
            rows.append([
                *function,
                code(spaced(samples.packet(self.of, c))) if accepted else "no device is known to accept it",
                self._reply(c),
                length(c.required, 3 if c.function else 2),
            ])  # fmt: skip
        return table(rows, [*(["Function"] if self.of.functions else []), "Send", "Reply", "Field length"])

    def _reply(self, c: m.Call) -> str:
        """The reply to a form of the command, with the values of a response."""
        if c.function is not None and not c.function.reply:
            return "none"
        responses = self.model.responses(self.of) if c.function is None or c.function.responds else ()
        acknowledge = "ACK or none" if self.of.silent_when or self.of.silenced_by else "ACK"
        what = ", ".join([acknowledge, *([" or ".join(map(self.page.link, responses))] if responses else [])])
        layouts = [r.layouts[0] for r in self.page.index.samples.replies(self.of, c)]
        fields = [(r.descriptor, self.page.index.samples.data(r)) for r in layouts]
        packet = self._acknowledge(self.model.protocol.ack_code.values[0].value, *fields)
        if len(packet) > SHORT:
            return what
        values = [
            f"{piece.heading} {piece.shown(self.page)}" for r in layouts for piece in typical_pieces(self.page, r)
        ]
        values = [*values[:SHOWN], *(["…"] if values[SHOWN:] else [])]
        return f"{code(spaced(packet))} {what}{': ' if values else ''}{', '.join(values)}"

    @property
    def rejected(self) -> str:
        """The packet with which a device that lacks the command rejects it; empty if all devices support it."""
        supporting = {d.id for answer in m.SUPPORTED for d in self.model.devices_of(self.of, answer)}
        failure = self.model.protocol.ack_code.values[1]
        if {d.id for d in self.model.devices} == supporting or not any(
            c.function is None or c.function.reply for c in self.of.calls
        ):
            return ""
        which = self.page.link(self.model.protocol.acknowledge, code(failure.name))
        return f"A device without this command replies {code(spaced(self._acknowledge(failure.value)))}: {which}."

    def _acknowledge(self, value: int, *responses: tuple[int, bytes]) -> bytes:
        """Builds a packet that acknowledges or rejects the command, with further fields."""
        ack = self.model.protocol.acknowledge
        return codec.build(self.model, self.of.set, [(ack.descriptor, bytes([self.of.descriptor, value])), *responses])

    @property
    def terminal(self) -> str:
        """How `mip` reads the field, or sends the command in a form without parameters."""
        name = self.of.full_name
        if self.of.role == m.DATA:
            rates = [
                r.hertz for d in self.model.devices for r in d.base_rates if r.set.number in self.of.sets and r.hertz
            ]
            hertz = describe.number(min([10, *rates]))
            stream, export = code(f"mip stream PORT {name}@{hertz}"), code(f"mip export LOG {name} -o FILE.csv")
            return f"In a terminal, {stream} streams it at {hertz} Hz, which replaces the device's message format, and \
{export} tabulates a log."
        bare = [c for c in self.page.index.samples.sent(self.of) if not any(p.constant is None for p in c.required)]
        safe = [c for c in bare if c.function is None or c.function.responds]
        words = [name, *(c.function.name for c in safe[:1] if c.function)]
        return f"In a terminal: {code(' '.join(['mip send PORT', *words]))}." if safe else ""

    @property
    def ruler(self) -> str:
        """The parts of a packet with typical values; the bytes of parameters link to the descriptions."""
        packet = self.page.index.samples.packet(self.of, self.page.index.typical(self.of))
        return self._ruler(packet)

    def _ruler(self, packet: bytes, before: bytes = b"") -> str:
        """Shows the parts of a packet that contains the field, after the bytes of an acknowledge."""
        s = self.model.set(packet[2])
        number = code(f"{packet[2]:02X}")
        parts = [code(spaced(packet[:2])), self.page.link(s, number) if s else number, code(spaced(packet[3:4]))]
        if before:
            parts.append(self.page.link(self.model.protocol.acknowledge, code(spaced(before))))
        parts.append(code(spaced(packet[4 + len(before) :][:2])))
        pieces = [piece for piece in self.parameters.pieces if piece.data]
        parts += [f"[{code(spaced(piece.data))}](#{self.of.full_name}.{piece.path})" for piece in pieces]
        return " ".join([*parts, code(spaced(packet[-2:]))])

    @property
    def program(self) -> Program:
        """A program that uses the field."""
        return shown(self.page.index.samples, of_field(self.of))

    @property
    def others(self) -> str:
        """Where the programs in other languages are."""
        return self.page.others(programs_page(self.of.family), self.of.full_name)

    # ----------------------------------------------------------------------- sources and references

    @cached_property
    def occurrences(self) -> str:
        """The sets in which the field occurs, if there are several: its name there, the devices and the sources."""
        rows = []
        for o in self.of.occurrences if len(self.of.occurrences) > 1 else ():
            of = self.model.set(o.set)
            assert of is not None
            answers = [(x, self.page.links(self.model.devices_of(self.of, x, o.set))) for x in m.SUPPORTED]
            devices = "; ".join(links if x == "yes" else f"{x}: {links}" for x, links in answers if links)
            cited = "; ".join(citation(self.page, self.of, s) for s in o.sources)
            rows.append([self.page.link(of), code(self.of.name_in(o.set)), devices, cited])
        return table(rows, ["Set", "Name", "Devices", "In the manuals"])

    @property
    def citations(self) -> list[str]:
        """The sections of the manuals, unless they are in the table of occurrences."""
        return [] if self.occurrences else super().citations

    @property
    def definition(self) -> str:
        """Where the specification defines the field: the file, and the name in it. A line number would change with
        every edit above it."""
        if self.of.position is None:
            return ""
        return f"{code('/'.join(self.of.position.file.split('/')[-2:]))}, {code(f'name: {self.of.name}')}"

    @property
    def examples(self) -> str:
        """The manuals' examples of a command or a data field, and of its responses."""
        fields = on_page(self.of, self.model)
        examples = {x.id: x for f in fields for x in self.page.index.examples(f)}
        return ", ".join(self.page.link(x, inline(x.title)) for x in examples.values())

    @property
    def guides(self) -> list[Guide]:
        """The guides that use the field in a step or in data."""
        return self.page.index.guides.get(self.of.full_name, [])

    @property
    def evidence(self) -> str:
        """What the evidence for the field consists of, in a few words."""
        answers = zip(
            ("confirmed", "likely", "assumed"),
            (len(self.model.devices_of(self.of, x)) for x in m.SUPPORTED),
            strict=True,
        )
        counts = ", ".join(f"{n} {word}" for word, n in answers if n)
        parts = {
            f"devices ({counts})": counts,
            "alternatives": self._sentences("alternatives"),
            "settings": self._sentences("affects", "may_affect", "affected"),
            "status flags": self._sentences("flags"),
            "examples": self.examples,
            "errata": self.errata or self.errata_naming,
            "sources": self.citations or self.definition,
        }
        return ", ".join(words for words, there in parts.items() if there).capitalize()

    @cached_property
    def errata(self) -> list[m.Erratum]:
        return self.page.index.errata(self.of)

    @property
    def errata_naming(self) -> list[m.Erratum]:
        """The errata whose texts mention the field, and that are not about it."""
        return self.page.index.errata_naming(self.of)

    @property
    def related(self) -> list[m.Field]:
        """The fields that share the descriptor or the response, suppress the acknowledge, or are named in the texts."""
        fields: dict[str, m.Field] = {}
        for f in self._related():
            if f.role != m.RESPONSE and f.set and field_page(f) != field_page(self.of):
                fields.setdefault(f.full_name, f)
        return sorted(fields.values(), key=lambda f: (f.set, f.descriptor, f.name))

    def _related(self) -> Iterator[m.Field]:
        model = self.model
        yield from model.layouts(self.of)
        for r in model.responses(self.of):
            yield from model.commands(r)
        yield from (f for c in self.of.silenced_by if (f := model.field(c.command or "")) is not None)
        for record in on_page(self.of, model):
            texts = [record.description, *record.notes, *(p.description for p in record.parameters)]
            texts += [note for p in record.parameters for note in p.notes]
            refs = (r for text in texts if "`" in text for r in describe.prose(text, model))
            yield from (r.thing for r in refs if isinstance(r, describe.Ref) and isinstance(r.thing, m.Field))


@dataclass(frozen=True)
class Response(Field):
    """A response on the page of the command that defines it."""

    command: Field

    @property
    def devices(self) -> list[str]:
        """The devices that support the response, unless they are those of the command, which may say more."""
        devices = self._sentences(*DEVICES)
        return [] if {*devices} <= {*self.command.devices} else devices

    @property
    def ruler(self) -> str:
        data = self.page.index.samples.data(self.of, self.page.index.typical(self.of))
        success = self.model.protocol.ack_code.values[0].value
        packet = self.command._acknowledge(success, (self.of.descriptor, data))
        return self._ruler(packet, packet[4:8])

    @cached_property
    def as_in_command(self) -> str:
        """The parameters in one sentence, if the command has the same ones."""
        return self.parameters.as_in(self.command.parameters)

    @property
    def length_remarks(self) -> list[str]:
        """The manuals that state a different length for the response, in the sections about its command."""
        remarks = [(manual_link(self.page, s), length_remark(self.page, self.of, s)) for s in self.of.sources]
        return list(dict.fromkeys(f"{manual}: {remark}" for manual, remark in remarks if remark))


# --------------------------------------------------------------------------- rows of tables

ENTRY = ["Descriptor", "Field", "Functions", "Responses"]


def entry(page: Page, f: m.Field, functions: Sequence[m.Function], d: m.Device | None = None) -> list[str]:
    """Writes a row about a field with these functions; for a device, with the responses that it sends."""
    responds = not f.functions or any(x.responds for x in functions)
    responses = (page.model.answers(f, d.id) if d else page.model.responses(f)) if responds else ()
    marks = [word for word, holds in (("advanced", f.advanced), ("deprecated", f.deprecated)) if holds]
    return [
        code(hexadecimal(f.descriptor)),
        page.link(f, inline(f.title)) + (f" ({', '.join(marks)})" if marks else ""),
        code(m.letters(functions)) if functions else "",
        ", ".join(page.link(r, code(hexadecimal(r.descriptor))) for r in responses),
    ]
