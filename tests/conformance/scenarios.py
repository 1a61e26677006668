"""Sequences of steps for a command client: one for each rule, and random ones."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from random import Random
from typing import Any

from conformance.client_model import TIMEOUT, Client, Waiting, responses, wanted_responses
from mipgen import model as m
from mipgen.lower import codec
from random_values import field_values

Step = dict[str, Any]
Entry = tuple[m.Field, dict[str, Any]]  # a command with its values
Wire = tuple[int, bytes]  # a field of a reply: descriptor and data

NMEA = b"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n"
LONG = b"ue\x80\xff"  # noise that looks like the beginning of a long packet
UNKNOWN = 0xEE  # a descriptor that no command set defines


def values_of(f: m.Field, function: str = "", **given: int) -> dict[str, Any]:
    """Zeros, except for the function and the values given."""
    data = bytearray(f.max_size if f.role == m.COMMAND else f.min_size)
    if function:
        data[0] = next(x.value for x in f.functions if x.letter == function)
    for at, constant in f.signature:
        data[at : at + len(constant)] = constant
    return codec.decode(f, bytes(data))[0] | given


@dataclass
class Words:
    """The fields of a specification that the rules need, found by their properties."""

    of: m.Model

    def first(self, test: Callable[[m.Field], object], number: int | None = None) -> m.Field:
        fields = (f for f in self.of.fields if f.role == m.COMMAND and number in (None, f.set))
        return next(f for f in fields if test(f))

    def letters(self, f: m.Field) -> str:
        return "".join(x.letter for x in f.functions)

    @cached_property
    def plain(self) -> m.Field:
        """Neither parameters nor a response: a ping."""
        return self.first(lambda f: not f.parameters and not f.responses)

    @cached_property
    def setting(self) -> m.Field:
        return self.first(lambda f: "WRS" in self.letters(f) and len(f.responses) == 1, self.plain.set)

    @cached_property
    def asking(self) -> m.Field:
        """Asks for data, without a selector."""
        return self.first(lambda f: f.responses and not f.parameters, self.plain.set)

    @cached_property
    def conditional(self) -> m.Field:
        """Two responses of two descriptors."""
        return self.first(lambda f: len({r.descriptor for r in responses(self.of, f)}) > 1)

    @cached_property
    def layouts(self) -> m.Field:
        """Two responses of one descriptor."""
        return self.first(lambda f: len(f.responses) > len({r.descriptor for r in responses(self.of, f)}))

    @cached_property
    def quiet(self) -> m.Field:
        """Not acknowledged if its values say so."""
        return self.first(lambda f: f.silent_when)

    @cached_property
    def slow(self) -> m.Field:
        return self.first(lambda f: (f.timeout or 0) > 1)

    @cached_property
    def other_set(self) -> int:
        return next(s.number for s in self.of.sets if s.kind == "command" and s.number != self.plain.set)

    @cached_property
    def data(self) -> bytes:
        """A packet of measurements."""
        f = next(f for f in self.of.fields if f.role == m.DATA and f.set != 0xFF)
        return codec.build(self.of, f.set, [(f.descriptor, codec.encode(f, values_of(f)))])

    def response(self, command: m.Field, index: int = 0) -> Wire:
        f = responses(self.of, command)[index]
        return f.descriptor, codec.encode(f, values_of(f))

    def asked(self, command: m.Field, index: int) -> dict[str, Any]:
        """The values with which a command asks for one of its responses."""
        when = responses(self.of, command)[index].when
        return values_of(command, "R" if command.functions else "", **{c.parameter: c.value for c in when})

    # ---------------------------------------------------------------- steps

    def ack(self, command: m.Field, code: int = 0) -> Wire:
        return self.of.protocol.acknowledge.descriptor, bytes((command.descriptor, code))

    def barrier(self, size: int, code: int = 0) -> bytes:
        """The answer of a barrier."""
        return self.reply(*[self.ack(self.plain, code)] * size)

    def send(self, *commands: m.Field | Entry) -> Step:
        entries = [(c, values_of(c)) if isinstance(c, m.Field) else c for c in commands]
        fields = [{"descriptor": f.descriptor, "name": f.full_name, "values": values} for f, values in entries]
        return {"step": "send", "set": entries[0][0].set, "fields": fields}

    def reply(self, *fields: Wire, number: int | None = None) -> bytes:
        return codec.build(self.of, self.plain.set if number is None else number, list(fields))


def receive(*parts: bytes, chunk: int | None = None) -> Step:
    step: Step = {"step": "receive", "bytes": b"".join(parts).hex()}
    return step if chunk is None else {**step, "chunk": chunk}


def time(milliseconds: int) -> Step:
    return {"step": "time", "milliseconds": milliseconds}


END: Step = {"step": "end"}


def brief(event: dict[str, Any]) -> str:
    """An event in a few words, to compare with the rule."""
    match event:
        case {"event": "sent", "packet": packet, "commands": commands}:
            first = bytes.fromhex(packet)
            behind = f" behind {first[3] // 2}" if len(first) > first[3] + 6 else ""
            return f"sent {' '.join(map(str, commands))}{behind}"
        case {"event": "received", "fields": fields}:
            return f"received {len(fields)}"
        case {"event": "refused", "command": command, "code": code}:
            return f"refused {command} {code}"
        case {"event": "not_sent", "error": error}:
            return f"not_sent {error}"
        case {"event": kind, "command": command, "response": {"name": _}}:
            return f"{kind} {command} with data"
        case {"event": "undecodable", "command": command, "response": {"error": error}}:
            return f"undecodable {command} {error}"
        case {"event": "end", "waiting": waiting, "skipped": skipped}:
            return f"end {waiting} {skipped}"
        case {"event": kind, "command": command}:
            return f"{kind} {command}"
    raise AssertionError(event)


Scenario = tuple[str, list[Step], str]


#: A rule in each row: its name, the steps, and the events. Steps: `send COMMAND ...`, `receive PACKET, ...`, `time`
#: (until a command times out, or half of that, or a number of milliseconds) and `end`. A packet: its fields, that is
#: `ack:COMMAND`, `nack:COMMAND:CODE`, `data:COMMAND` (the response that it asks for), or one of `Table.field`; `in`
#: another set than that of the command; or one of `Table.packet`.
RULES = [
    ("acknowledged", "send plain; receive ack:plain; end", "sent 0; acknowledged 0; end [] 0"),
    ("refused", "send plain read; receive nack:plain:4 nack:read:200", "sent 0 1; refused 0 4; refused 1 200"),
    ("with a response", "send read; receive ack:read data:read", "sent 0; acknowledged 0 with data"),
    ("a newer device sends more", "send read; receive ack:read more:read", "sent 0; acknowledged 0 with data"),
    ("an acknowledge with more bytes", "send plain; receive ack+:plain", "sent 0; acknowledged 0"),
    (
        "time",
        "send plain; half; send plain; time 499; time 1; half; end",
        "sent 0; sent 1; timed_out 0; timed_out 1; end [] 0",
    ),
    ("too late", "send plain; time; receive ack:plain", "sent 0; timed_out 0; received 1"),
    ("nothing waits", "receive ack:plain, measured, empty", "received 1; received 1; received 0"),
    # The response is the field right behind the acknowledge.
    (
        "a foreign field in between",
        "send read; receive ack:read foreign data:read",
        "sent 0; missing_response 0; received 2",
    ),
    ("the response comes first", "send read; receive data:read ack:read", "sent 0; missing_response 0; received 1"),
    (
        "the response in a packet of its own",
        "send read; receive ack:read, data:read",
        "sent 0; missing_response 0; received 1",
    ),
    (
        "a foreign field behind",
        "send write read; receive ack:write foreign ack:read data:read foreign",
        "sent 0 1; acknowledged 0; acknowledged 1 with data; received 2",
    ),
    (
        "a response that no command has",
        "send asking; receive ack:asking data:read",
        "sent 0; missing_response 0; received 1",
    ),
    ("a refusal has no response", "send read; receive nack:read:3 data:read", "sent 0; refused 0 3; received 1"),
    # Responses that are missing, broken, or those of another command.
    ("missing", "send read asking; receive ack:read ack:asking", "sent 0 1; missing_response 0; missing_response 1"),
    (
        "undecodable",
        "send read plain; receive ack:read cut:read ack:plain",
        "sent 0 1; undecodable 0 truncated; acknowledged 1",
    ),
    (
        "a response for somebody else is not the write's",
        "send write; receive ack:read data:read; receive ack:write",
        "sent 0; received 2; acknowledged 0",
    ),
    (
        "the answer of the read, though that of the write is lost",
        "send write read; receive ack:read data:read; time",
        "sent 0 1; acknowledged 1 with data; timed_out 0",
    ),
    (
        "the answer of the write, though that of the read is lost",
        "send read save; receive ack:save; receive ack:read",
        "sent 0 1; acknowledged 1; missing_response 0",
    ),
    (
        "the response that the values select",
        "send one; receive ack:one data:two; receive ack:one data:one",
        "sent 0; received 2; acknowledged 0 with data",
    ),
    (
        "both responses, each for its own command",
        "send one two; receive ack:two data:two ack:one data:one",
        "sent 0 1; acknowledged 1 with data; acknowledged 0 with data",
    ),
    (
        "the layout that the values select",
        "send short; receive ack:short data:long; receive ack:short data:short",
        "sent 0; received 2; acknowledged 0 with data",
    ),
    (
        "both layouts, each for its own command",
        "send short long; receive ack:long data:long ack:short data:short",
        "sent 0 1; acknowledged 1 with data; acknowledged 0 with data",
    ),
    ("a selector that nobody knows", "send odd; receive ack:odd", "sent 0; acknowledged 0"),
    # After a command without an answer, a barrier: what comes before its own answer is late.
    (
        "a late acknowledge is not that of the next command",
        "send write; time; send write; receive ack:write; receive barrier:2; receive ack:write",
        "sent 0; timed_out 0; sent 1 behind 2; received 1; acknowledged 1",
    ),
    (
        "a late refusal, a late response, and one for another command",
        "send read plain; time; send read plain asking; receive ack:read data:read nack:plain:3; "
        "receive barrier:3, nack:read:5 ack:plain ack:asking data:asking",
        "sent 0 1; timed_out 0; timed_out 1; sent 2 3 4 behind 3; received 3; "
        "refused 2 5; acknowledged 3; acknowledged 4 with data",
    ),
    (
        "once it is answered, there is no other",
        "send write; time; send plain; receive barrier:2, ack:plain; send read; receive ack:read data:read",
        "sent 0; timed_out 0; sent 1 behind 2; acknowledged 1; sent 2; acknowledged 2 with data",
    ),
    (
        "one barrier for what follows",
        "send write; time; send write; send plain; receive ack:write; receive barrier:2, ack:write, ack:plain",
        "sent 0; timed_out 0; sent 1 behind 2; sent 2; received 1; acknowledged 1; acknowledged 2",
    ),
    (
        "it is not answered, though the command is",
        "send write; time; send write; receive ack:write; time; send write; receive barrier:3, ack:write",
        "sent 0; timed_out 0; sent 1 behind 2; received 1; timed_out 1; sent 2 behind 3; acknowledged 2",
    ),
    (
        "the answer of an earlier one is late, too",
        "send write; time; send write; time; send write; receive ack:write, barrier:2, ack:write; "
        "receive barrier:3, ack:write",
        "sent 0; timed_out 0; sent 1 behind 2; timed_out 1; sent 2 behind 3; received 1; received 2; received 1; "
        "acknowledged 2",
    ),
    (
        "late acknowledges of its own command do not make up its answer",
        "send plain plain; time; send plain; "
        "receive ack:plain ack:plain, ack:plain, ack:plain ack:plain ack:read; receive barrier:3, ack:plain",
        "sent 0 1; timed_out 0; timed_out 1; sent 2 behind 3; received 2; received 1; received 3; acknowledged 2",
    ),
    (
        "nor do those that may still come",
        "send write; time; send plain; half; send plain plain; receive barrier:2; half; send plain; "
        "receive ack:plain ack:plain",
        "sent 0; timed_out 0; sent 1 behind 2; sent 2 3; timed_out 1; sent 4 behind 4; acknowledged 2; acknowledged 3",
    ),
    (
        "a device that refuses it has answered it",
        "send write; time; send plain; receive barrier:2:1, ack:plain",
        "sent 0; timed_out 0; sent 1 behind 2; acknowledged 1",
    ),
    (
        "what comes with its answer spoils it",
        "send write; time; send plain; receive ack:plain ack:plain foreign, ack:plain; time",
        "sent 0; timed_out 0; sent 1 behind 2; received 3; received 1; timed_out 1",
    ),
    (
        "what was sent before it is not answered any more",
        "send plain; half; send read; half; send read; receive barrier:3, ack:read data:read",
        "sent 0; sent 1; timed_out 0; sent 2 behind 3; timed_out 1; acknowledged 2 with data",
    ),
    (
        "what was sent before it is answered until then",
        "send plain; half; send read; half; send read; receive ack:read data:read, barrier:3, ack:read data:read",
        "sent 0; sent 1; timed_out 0; sent 2 behind 3; acknowledged 1 with data; acknowledged 2 with data",
    ),
    (
        "a further one takes the place of one that is not answered",
        "send write; time; send write; half; send plain; half; send write; receive barrier:2, ack:plain, ack:write; "
        "receive barrier:4, ack:write; send plain",
        "sent 0; timed_out 0; sent 1 behind 2; sent 2; timed_out 1; sent 3 behind 4; received 2; received 1; "
        "received 1; timed_out 2; acknowledged 3; sent 4",
    ),
    (
        "answered when nothing waits behind it any more",
        "send write; time; send write; time; receive barrier:2, ack:write; send write; "
        "receive ack:write, barrier:3, ack:write",
        "sent 0; timed_out 0; sent 1 behind 2; timed_out 1; received 1; sent 2 behind 3; received 1; acknowledged 2",
    ),
    (
        "the sizes of barriers begin again",
        "; ".join(["send plain; time"] * 63),
        "sent 0; timed_out 0; " + "; ".join(f"sent {i} behind {(i - 1) % 62 + 2}; timed_out {i}" for i in range(1, 63)),
    ),
    (
        "none before what cannot be sent",
        f"send write; time; send {'plain ' * 128}; send plain; receive barrier:2, ack:plain",
        "sent 0; timed_out 0; not_sent length; sent 1 behind 2; acknowledged 1",
    ),
    # Several commands in one packet, answers in several packets.
    (
        "several at once",
        "send plain read asking; receive ack:plain ack:read data:read ack:asking data:asking",
        "sent 0 1 2; acknowledged 0; acknowledged 1 with data; acknowledged 2 with data",
    ),
    (
        "one packet answers two packets, and one is answered by two",
        "send plain read; send plain; receive ack:plain, measured, ack:read data:read ack:plain",
        "sent 0 1; sent 2; acknowledged 0; received 1; acknowledged 1 with data; acknowledged 2",
    ),
    (
        "equal commands in order",
        "send plain; send plain plain; receive nack:plain:1; receive ack:plain nack:plain:2",
        "sent 0; sent 1 2; refused 0 1; acknowledged 1; refused 2 2",
    ),
    (
        "an answer that nobody waits for between others",
        "send plain read; receive ack:asking data:asking ack:plain ack:read data:read",
        "sent 0 1; acknowledged 0; acknowledged 1 with data; received 2",
    ),
    (
        "a short acknowledge between others",
        "send plain plain; receive ack:plain ack- ack:plain",
        "sent 0 1; acknowledged 0; acknowledged 1; received 1",
    ),
    (
        "a malformed field behind an answer",
        "send plain plain; receive malformed:plain:05f101",
        "sent 0 1; acknowledged 0; received 1",
    ),
    (
        "a malformed field where the response should be",
        "send read; receive malformed:read:01",
        "sent 0; missing_response 0; received 1",
    ),
    # Sets, and commands that are not answered.
    (
        "an acknowledge of another set",
        "send plain; receive ack:plain in other, ack:plain in data; receive ack:plain",
        "sent 0; received 1; received 1; acknowledged 0",
    ),
    (
        "a function without a reply",
        "send silent spoken; receive ack:spoken; receive ack:spoken",
        "sent 0 1; silent 0; acknowledged 1; received 1",
    ),
    ("silent if its values say so", "send told quiet; receive ack:quiet; time", "sent 0 1; silent 0; acknowledged 1"),
    (
        "what cannot be sent is not waited for",
        f"send {'plain ' * 128}; send plain in other; send incomplete; send plain plain plain; receive ack:plain; end",
        "not_sent length; not_sent unknown; not_sent missing; sent 0 1 2; acknowledged 0; end [1, 2] 0",
    ),
    # Noise.
    (
        "what comes behind the noise and is not whole is not given up",
        "send plain; receive noise, ack:plain, begun; time; receive rest; end",
        f"sent 0; acknowledged 0; received 1; end [] {len(LONG)}",
    ),
    (
        "a packet that has begun to come when a command times out is not lost",
        "send plain; receive begun; time; receive rest; end",
        "sent 0; timed_out 0; received 1; end [] 0",
    ),
    (
        "noise is given up when something whole is behind it, at the next time-out",
        "send plain; receive noise, begun; time; send plain; receive rest; time; end",
        f"sent 0; timed_out 0; sent 1 behind 2; received 1; timed_out 1; end [] {len(LONG)}",
    ),
    ("noise, and nothing behind it", "send plain; receive noise, measured; time", "sent 0; received 1; timed_out 0"),
    ("nothing is late, so nothing is given up", "send plain; receive noise, measured; time 999", "sent 0"),
    (
        "the end gives up the rest",
        "receive noise, measured; end; receive measured; end",
        f"received 1; end [] {len(LONG)}; received 1; end [] {len(LONG)}",
    ),
]


@dataclass
class Table:
    """What the words of the table stand for."""

    w: Words

    @cached_property
    def commands(self) -> dict[str, Entry]:
        w = self.w
        silent = w.first(lambda f: "A" in w.letters(f))
        forms = responses(w.of, w.layouts)
        second = next(i for i, r in enumerate(forms) if r.when != forms[0].when)
        told = {c.parameter: c.value for c in w.quiet.silent_when}
        return {
            "plain": (w.plain, values_of(w.plain)),
            "asking": (w.asking, values_of(w.asking)),
            **{name: (w.setting, values_of(w.setting, name[0].upper())) for name in ("read", "write", "save")},
            "odd": (w.setting, values_of(w.setting, "R") | {"function": 99}),
            "incomplete": (w.setting, {"function": 1}),
            "one": (w.conditional, w.asked(w.conditional, 0)),
            "two": (w.conditional, w.asked(w.conditional, 1)),
            "short": (w.layouts, w.asked(w.layouts, 0)),
            "long": (w.layouts, w.asked(w.layouts, second)),
            "silent": (silent, values_of(silent, "A")),
            "spoken": (silent, values_of(silent, "W")),
            "told": (w.quiet, values_of(w.quiet, "", **told)),
            "quiet": (w.quiet, values_of(w.quiet)),
        }

    def steps(self, text: str) -> list[Step]:
        return [self.step(*step.strip().partition(" ")[::2]) for step in text.split(";")]

    def step(self, kind: str, rest: str) -> Step:
        if kind == "send":
            names, _, other = rest.partition(" in ")
            step = self.w.send(*(self.commands[name] for name in names.split()))
            return {**step, "set": self.w.other_set} if other else step
        if kind == "receive":
            return receive(*map(self.packet, rest.split(", ")))
        return END if kind == "end" else time(int(rest) if rest else TIMEOUT // 2 if kind == "half" else TIMEOUT)

    def packet(self, text: str) -> bytes:
        w, cut = self.w, len(self.w.data) // 2
        known = {"measured": w.data, "begun": w.data[:cut], "rest": w.data[cut:], "noise": LONG, "empty": w.reply()}
        kind, _, named = text.partition(":")
        if kind == "barrier":
            return w.barrier(*map(int, named.split(":")))
        if kind == "malformed":
            name, _, rest = named.partition(":")
            return malformed(w, w.ack(self.commands[name][0]), bytes.fromhex(rest))
        fields, _, where = text.partition(" in ")
        first = next((name for field in fields.split() for name in field.split(":")[1:2]), "plain")
        number = {"": self.commands[first][0].set, "other": w.other_set, "data": 0x80}[where]
        return known.get(text) or w.reply(*map(self.field, fields.split()), number=number)

    def field(self, text: str) -> Wire:
        kind, *named = text.split(":")
        command, values = self.commands[named[0]] if named else self.commands["plain"]
        ack = self.w.ack(command, int(named[1]) if kind == "nack" else 0)
        if kind in ("ack", "nack"):
            return ack
        if kind in ("ack+", "ack-"):  # with a byte more, or one less
            return ack[0], ack[1] + b"\xff" if kind == "ack+" else b"\x01"
        if kind == "foreign":
            return UNKNOWN, b"\x01\x02"
        layouts = wanted_responses(self.w.of, command, values)
        descriptor, data = self.w.response(command, responses(self.w.of, command).index(layouts[0]))
        return descriptor, {"data": data, "more": data + b"\x01\x02", "cut": data[:-1]}[kind]


def scenarios(of: m.Model) -> Iterator[Scenario]:
    """Name, steps, and the events in a few words."""
    table = Table(Words(of))
    yield from ((name, table.steps(steps), events) for name, steps, events in RULES)
    yield from layouts_of_every_size(table.w)
    yield from noise_in_pieces(table.w)
    w = table.w
    slow = round(1000 * (w.slow.timeout or 0))
    yield "a command that takes longer", [w.send(w.slow), time(slow - 500), time(500)], "sent 0; timed_out 0"
    for number in m.NO_SETS:
        yield (
            f"nothing waits for the rest of a packet of set {number}, which there is not",
            [w.send(w.plain), receive(b"ue" + bytes([number, 0xFF]), w.data), END],
            "sent 0; received 1; end [0] 4",
        )


def layouts_of_every_size(w: Words) -> Iterator[Scenario]:
    """A response may be longer than its layout, and as short as the shortest one that its command asks for."""
    form, forms = w.layouts, responses(w.of, w.layouts)
    for i, f in enumerate(forms):
        descriptor, layout = w.response(form, i)
        shortest = min(r.min_size for r in forms if r.when == f.when)
        for size in range(len(layout) + 2):
            answer = (descriptor, layout[:size].ljust(size, b"\0"))
            yield (
                f"{f.name} with {size} bytes",
                [w.send((form, w.asked(form, i))), receive(w.reply(w.ack(form), answer, number=form.set))],
                f"sent 0; {'acknowledged 0 with data' if size >= shortest else 'undecodable 0 truncated'}",
            )


def noise_in_pieces(w: Words) -> Iterator[Scenario]:
    half = time(TIMEOUT // 2)
    for noise in (LONG, b"u", b"ue", NMEA, LONG + b"\x80ue\x80\xf0" + LONG):
        for chunk in (1, 3, 1000):
            yield (
                f"{noise!r} before an acknowledge, in pieces of {chunk}",
                [w.send(w.plain), half, receive(noise, w.reply(w.ack(w.plain)), w.data, chunk=chunk), half, END],
                f"sent 0; acknowledged 0; received 1; end [] {len(noise)}",
            )


def malformed(w: Words, ack: Wire, rest: bytes) -> bytes:
    """A packet with an acknowledge and bytes behind it that are no field."""
    payload = bytes((len(ack[1]) + 2, ack[0])) + ack[1] + rest
    head = b"ue" + bytes((w.plain.set, len(payload))) + payload
    return head + codec.checksum(head)


# --------------------------------------------------------------------------- random ones


def random_steps(chance: Random, w: Words) -> list[Step]:
    """Few commands, so that a reply fits several of them, and anything else that may arrive."""
    number = chance.choice([f.set for f in w.of.fields if f.role == m.COMMAND])
    own = [f for f in w.of.fields if f.role == m.COMMAND and f.set == number]
    special = [f for f in own if len(f.responses) > 1 or f.silent_when or f.timeout]
    commands = [chance.choice(own) for _ in range(chance.randint(1, 2))]
    commands.append(chance.choice(special or own))
    client = Client(w.of)  # knows what waits
    steps = [w.send(*entries(chance, commands))]
    client.send(steps[0])
    for _ in range(chance.randint(2, 9)):
        kind = chance.randrange(10)
        if kind < 3:
            steps.append(w.send(*entries(chance, commands)))
            client.send(steps[-1])
        elif kind < 5:
            steps.append(time(125 * chance.randint(1, 12)))  # whole eighths: exact in seconds too
            client.time(steps[-1])
        else:
            waiting = list(client.waiting)
            parts = [part(chance, w, number, waiting, commands) for _ in range(chance.randint(1, 3))]
            steps.append(receive(*parts, chunk=chance.choice([1, 2, 7, 64, 1000])))
            client.receive(steps[-1])
    return [*steps, END]


def entries(chance: Random, commands: list[m.Field]) -> list[Entry]:
    chosen = [chance.choice(commands) for _ in range(chance.randint(1, 3))]
    return [(c, command_values(chance, c)) for c in chosen]


def command_values(chance: Random, command: m.Field) -> dict[str, Any]:
    """The values of every function, those that select a response, and random ones."""
    if chance.random() < 1 / 3:
        return field_values(chance, command)
    chosen = [values_of(command, f.letter) for f in command.functions] or [values_of(command)]
    chosen += [v for v in chosen if v.get("function") == 2] * 2  # reads have the most cases
    for p in command.parameters:
        if isinstance(p.element, (m.Enum, m.Scalar)) and not p.selector and p.constant is None and p.length is None:
            chosen += [{**v, p.name: n} for v in chosen[-3:] for n in (1, 2) if isinstance(v.get(p.name), int)][:8]
    return chance.choice(chosen)


def part(chance: Random, w: Words, number: int, waiting: list[Waiting], commands: list[m.Field]) -> bytes:
    """A reply, mostly to a command that waits; or data, or noise."""
    if chance.random() < 0.25:
        return chance.choice([w.data, w.data, NMEA, LONG, b"u", b"ue", b"ueue", b"ue\0\0"])
    sizes = [x.behind for x in waiting if x.behind]
    if sizes and chance.random() < 0.4:
        return w.barrier(chance.choice([*sizes, *sizes, *sizes, chance.randint(1, 5)]), chance.choice([0, 0, 3]))
    fields: list[Wire] = []
    for _ in range(chance.randint(1, 3)):
        some = chance.choice(waiting) if waiting and chance.random() < 0.8 else None
        command = some.command if some else chance.choice(commands)
        fields += reply(chance, w, command, chance.choice(some.wanted) if some and some.wanted else None)
    return w.reply(*fitting(fields), number=chance.choice([number] * 6 + [w.other_set, 0x80]))


def reply(chance: Random, w: Words, command: m.Field, wanted: m.Field | None) -> list[Wire]:
    """The right answer, or one with a fault."""
    fault = chance.choice(["none"] * 6 + ["code", "missing", "other", "cut", "cut", "between", "foreign"])
    ack = w.ack(command, chance.choice([1, 3, 200]) if fault == "code" else 0)
    known = [r for r in w.of.fields if r.role == m.RESPONSE and r.set == command.set]
    if fault == "other" or (wanted is None and chance.random() < 0.5):
        wanted = chance.choice(responses(w.of, command) or known) if known else None
    if fault == "foreign":
        short = (ack[0], ack[1][:1])
        return [chance.choice([(UNKNOWN, b"\1"), short, (command.descriptor, b"")])]
    if wanted is None or fault == "missing":
        return [ack]
    data = codec.encode(wanted, values_of(wanted) if chance.random() < 0.5 else field_values(chance, wanted))
    data = data[: chance.randrange(len(data))] if fault == "cut" and data else data
    return [ack, *([(UNKNOWN, b"")] if fault == "between" else []), (wanted.descriptor, data)]


def fitting(fields: list[Wire]) -> list[Wire]:
    """As many as a packet holds."""
    found, room = [], 255
    for field in fields:
        room -= len(field[1]) + 2
        if room >= 0:
            found.append(field)
    return found
