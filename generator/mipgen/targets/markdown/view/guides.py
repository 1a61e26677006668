"""Guides: their packets, the replies, the data that follows, and the programs that do the same."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from mipgen import model as m
from mipgen.facts import describe
from mipgen.facts.sample_values import GivenValues
from mipgen.lower import codec
from mipgen.model import guides

from ..places import GUIDE_PROGRAMS, Page, guide_picture
from ..snippets import Named, Program, of_sequence, shown
from ..text import code, inline, table
from .base import View
from .devices import Section, base_rate, hertz
from .examples import packet_ruler

#: Bits that a UART sends for each byte.
BITS = 10


class Guide(View[guides.Guide]):
    @property
    def sequences(self) -> list[Sequence]:
        return [Sequence(self.page, x, self.of) for x in self.of.sequences]

    @property
    def picture(self) -> str:
        """The picture below the answer; empty if there is none."""
        picture = self.of.picture
        return self.page.picture(guide_picture(self.of), inline(picture.shows)) if picture else ""

    @property
    def questions(self) -> list[tuple[guides.Question, list[str]]]:
        """The questions, each with links to the related guides and fields."""
        return [(question, self._links(question.see)) for question in self.of.questions]

    @property
    def migration(self) -> Migration | None:
        return Migration(self.page, self.of.migration) if self.of.migration else None

    @property
    def tables(self) -> list[Section]:
        """Tables of facts about all devices."""
        tables = {"base_rates": ("Base rates", self._base_rates), "baud_rates": ("Baud rates", self._baud_rates)}
        return [Section(title, write()) for title, write in map(tables.__getitem__, self.of.tables)]

    def _base_rates(self) -> str:
        model, link = self.model, self.page.link
        devices = [d for d in model.devices if any(r.hertz for r in d.base_rates)]
        sets = [s for s in model.sets if any(r.set.number == s.number for d in devices for r in d.base_rates)]
        rows = [[link(d), *(base_rate(d, s) for s in sets)] for d in devices]
        return table(rows, ["Device", *map(link, sets)])

    def _baud_rates(self) -> str:
        rows = [
            [self.page.link(d), inline(p.name), ", ".join(map(str, p.baud_rates))]
            for d in self.model.devices
            for p in d.ports
            if p.baud_rates
        ]
        return table(rows, ["Device", "Port", "Baud rates"])

    @property
    def see(self) -> list[str]:
        return self._links(self.of.see)

    def _links(self, names: Iterable[str]) -> list[str]:
        """Returns links to guides, then to fields."""
        by_name = {g.name: g for g in self.model.guides}
        fields = [self.model.field(name) for name in names if name not in by_name]
        return [self.page.link(x) for x in (*(by_name[name] for name in names if name in by_name), *fields) if x]


# --------------------------------------------------------------------------- sequences


@dataclass(frozen=True)
class Sequence(View[guides.Sequence]):
    guide: guides.Guide

    @cached_property
    def steps(self) -> list[Step]:
        return [Step(self.page, step, self.of.devices[0]) for step in self.of.steps]

    @property
    def bytes(self) -> str:
        """All packets of the sequence, byte by byte, and their replies."""
        rows = [
            [str(i), s.command, " ".join(filter(None, (s.reply, s.certainty))) or "none"]
            for i, s in enumerate(self.steps, 1)
        ]
        return table(rows, ["Step", "Send", "Reply"])

    @property
    def others(self) -> str:
        """Where the programs in other languages are."""
        return self.page.others(GUIDE_PROGRAMS, self.name)

    @property
    def number(self) -> int:
        return self.guide.sequences.index(self.of) + 1

    @property
    def streams(self) -> list[Stream]:
        return [stream for step in self.steps for stream in step.streams]

    @property
    def fields(self) -> list[m.Field]:
        """The data fields that the sequence starts; their pages contain programs that read them."""
        return list({x.field.full_name: x.field for s in self.of.streams for x in s.fields}.values())

    @property
    def rates(self) -> list[str]:
        """The rate of each stream, on each device."""
        rates = {
            f"{inline(d.title)}, {self.page.link(s.set)}: {hertz(r)} / {s.rate:g} Hz = decimation {r.hertz / s.rate:g}"
            for d in self.of.devices
            for s in self.of.streams
            for r in d.base_rates
            if s.rate and r.set.number == s.set.number and r.hertz
        }
        return sorted(rates)

    @property
    def bandwidth(self) -> str:
        """The load of the streams on a UART."""
        streams = [(s.rate, len(s.packet)) for s in self.of.streams if s.rate]
        if not streams:
            return ""
        each = [f"{_number(rate)} × {length}" for rate, length in streams]
        whole = sum(rate * length for rate, length in streams)
        device = self.of.devices[0]
        port = next((p for p in device.ports if p.baud_rates), None)
        baud = min((rate for rate in port.baud_rates if rate >= whole * BITS), default=None) if port else None
        advice = f" On {inline(port.name)} of the {inline(device.title)}, use {baud} or more." if port and baud else ""
        return (
            f"{' + '.join(each)} = {_number(whole)} bytes per second, which needs {_number(whole * BITS)} baud.{advice}"
        )

    @property
    def notes(self) -> list[str]:
        """The author's notes, and why a device is only believed to support the fields of the sequence."""
        used = self.of.used
        doubts = [
            f"{self.page.link(s.field)} is {s.evidence.answer} on the {self.page.link(d)}. "
            f"{self.page.markdown(describe.evidence(s.evidence, self.model))}"
            for d in self.of.devices
            for s in d.supports
            if not s.certain and s.field.full_name in used
        ]
        return [*map(self.page.prose, self.of.notes), *doubts]

    @property
    def named_program(self) -> Named:
        """The sequence as a program."""
        steps = [(s.of.command, GivenValues(self.model, s.call, s.of.values, s.of.host)) for s in self.steps]
        return of_sequence(self.name, steps)

    @property
    def program(self) -> Program:
        return shown(self.page.index.samples, self.named_program)

    @property
    def name(self) -> str:
        """The name of its programs."""
        return f"{self.guide.name}_{self.number}" if len(self.guide.sequences) > 1 else self.guide.name


def _number(value: float) -> str:
    return f"{value:,.6g}" if value < 1e6 else f"{value:,.0f}"


# --------------------------------------------------------------------------- steps

Role = Literal["command", "reply", "data"]


@dataclass(frozen=True)
class Step(View[guides.Step]):
    device: m.Device

    @property
    def call(self) -> m.Call:
        function = self.of.values.get("function")
        return next(x for x in self.of.command.calls if (x.function.value if x.function else None) == function)

    @property
    def function(self) -> m.Function | None:
        return self.call.function

    @property
    def title(self) -> str:
        title = self.of.command.title
        return inline(f"{title}, {self.function.name}" if self.function else title)

    @property
    def host(self) -> str:
        """What a program then does besides commands."""
        return self.page.prose(self.of.host[0].lower() + self.of.host[1:]) if self.of.host else ""

    @property
    def command(self) -> str:
        """Each byte of the command."""
        return _explained(self.page, "command", self.of.packet, [(self.of.command, self.of.values)], self.device)

    @property
    def reply(self) -> str:
        """Each byte of the reply; empty if there is none."""
        if not self.of.answer:
            return ""
        ack = self.model.protocol.acknowledge
        fields = [(ack, codec.decode(ack, bytes([self.of.command.descriptor, 0]))[0])]
        fields += [(self.of.response.field, self.of.response.values)] if self.of.response else []
        return _explained(self.page, "reply", self.of.answer, fields, self.device)

    @property
    def certainty(self) -> str:
        """Which values of the response are certain after the steps before it."""
        if self.of.response is None:
            return ""
        names = {p.name for p in self.of.response.field.parameters if not p.derived}
        certain = [code(name) for name in self.of.response.stated if name in names]
        if len(certain) == len(names):
            return "Always these values."
        return f"Fixed: {', '.join(certain)}; the rest is an example." if certain else "An example."

    @property
    def streams(self) -> list[Stream]:
        return [Stream(self.page, x, self.device) for x in self.of.data]


@dataclass(frozen=True)
class Stream(View[guides.Stream]):
    device: m.Device

    @property
    def sentence(self) -> str:
        """The rate of the data packets, and their contents."""
        *others, last = [self.page.link(x.field) for x in self.of.fields]
        fields = f"{', '.join(others)} and {last}" if others else last
        packet = f"a packet of {self.page.link(self.of.set)} with {fields}"
        if self.of.rate is not None:
            return f"The device sends {packet} at {describe.number(self.of.rate)} Hz."
        if self.of.on_event:
            return f"{inline(f'At {self.of.on_event}')}, the device sends {packet}."
        return f"The device then sends {packet}."

    @property
    def bytes(self) -> str:
        """Each byte of a data packet."""
        fields = [(x.field, x.values) for x in self.of.fields]
        return _explained(self.page, "data", self.of.packet, fields, self.device)


def _explained(
    page: Page, role: Role, packet: bytes, fields: Iterable[tuple[m.Field, codec.Values]], device: m.Device
) -> str:
    parts = tuple(
        m.ExampleField(f.full_name, f.descriptor, codec.encode(f, values), values, 0, None) for f, values in fields
    )
    return packet_ruler(page, m.Example("", "", "", "", role, None, None, packet, parts, "", device=device))


# --------------------------------------------------------------------------- migration


class Migration(View[guides.Migration]):
    @property
    def titles(self) -> list[str]:
        return [inline(self.of.before.title), inline(self.of.after.title)]

    @property
    def changes(self) -> str:
        """The replacements of the fields that the new device lacks."""
        page = self.page
        rows = [
            [page.links(x.fields), page.links(x.by) or "nothing", page.prose(x.note) if x.note else ""]
            for x in self.of.changes
        ]
        return table(rows, [*self.titles, "What is different"])

    @property
    def meanings(self) -> str:
        """The parameters that both devices support, but with different meanings."""
        common = {f.full_name for f in self._common}
        variants = [{v.path: v for v in d.variants} for d in (self.of.before, self.of.after)]
        rows = []
        for path in dict.fromkeys([*variants[0], *variants[1]]):
            v = variants[0].get(path) or variants[1][path]
            of_commands = [f"{x.full_name}.{v.parameter.name}" for x in self.model.commands(v.field)]
            # a row describes both a command and its response
            if v.field.full_name in common and not any(x in each for x in of_commands for each in variants):
                readings = [self._reading(each.get(path), v) for each in variants]
                rows.append([self.page.link(v.field), code(v.parameter.name), *readings])
        return table(rows, ["Field", "Parameter", *self.titles])

    def _reading(self, v: m.DeviceVariant | None, other: m.DeviceVariant) -> str:
        """States the meaning of a parameter on a device: the usual one unless the device differs."""
        model, describing = self.model, describe.variant_text if v else describe.usual_text
        v = v or other
        return self.page.markdown(describing(v.variant, v.parameter, v.field, model))

    @cached_property
    def _common(self) -> list[m.Field]:
        """The fields that both devices certainly support: commands, data and responses."""
        wanted = {self.of.before.id, self.of.after.id}
        return [f for f in self.model.fields if wanted <= {d.id for d in self.model.devices_of(f)}]

    @property
    def refused(self) -> str:
        """The commands of both devices for which the new device accepts fewer functions."""
        accepted = [{s.field.full_name: s.functions for s in d.supports} for d in (self.of.before, self.of.after)]
        rows = []
        for f in self._common:
            before, after = (each.get(f.full_name, ()) for each in accepted)
            lost = [x for x in before if x not in after]
            if lost:
                rows.append([self.page.link(f), ", ".join(f"{code(x.name)} ({x.value})" for x in lost)])
        return table(rows, ["Command", "Functions"])

    @property
    def added(self) -> list[str]:
        """The new fields, a line for each set."""
        old = {s.field.full_name for s in self.of.before.supports}
        lines = []
        for s in self.model.sets:
            new = [x.field for x in self.of.after.certain if x.set == s.number and x.field.full_name not in old]
            if new:
                lines.append(f"{self.page.link(s)}: {', '.join(self.page.link(f, inline(f.title)) for f in new)}")
        return lines
