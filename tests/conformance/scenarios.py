"""Sequences of steps for a command client: one for each rule, and random ones."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from random import Random
from typing import Any

from conformance.client_model import TIMEOUT, Client, Waiting, responses
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

    def response(self, command: m.Field, index: int = 0, spoiled: bool = False) -> Wire:
        f = responses(self.of, command)[index]
        data = codec.encode(f, values_of(f))
        return f.descriptor, data[:-1] if spoiled else data

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


def scenarios(of: m.Model) -> Iterator[Scenario]:
    """Name, steps, and the events in a few words."""
    w = Words(of)
    plain, setting, asking = w.plain, w.setting, w.asking
    read, write, save = ((setting, values_of(setting, letter)) for letter in "RWS")
    ok, data = w.ack, w.response(setting)
    foreign = (UNKNOWN, b"\x01\x02")

    yield ("acknowledged", [w.send(plain), receive(w.reply(ok(plain))), END], "sent 0; acknowledged 0; end [] 0")
    yield (
        "refused",
        [w.send(plain, read), receive(w.reply(ok(plain, 4), ok(setting, 200)))],
        "sent 0 1; refused 0 4; refused 1 200",
    )
    yield ("with a response", [w.send(read), receive(w.reply(ok(setting), data))], "sent 0; acknowledged 0 with data")
    yield (
        "a newer device sends more",
        [w.send(read), receive(w.reply(ok(setting), (data[0], data[1] + b"\x01\x02")))],
        "sent 0; acknowledged 0 with data",
    )
    yield (
        "an acknowledge with more bytes",
        [w.send(plain), receive(w.reply((ok(plain)[0], ok(plain)[1] + b"\xff")))],
        "sent 0; acknowledged 0",
    )
    yield (
        "time",
        [w.send(plain), time(500), w.send(plain), time(499), time(1), time(500), END],
        "sent 0; sent 1; timed_out 0; timed_out 1; end [] 0",
    )
    yield (
        "a command that takes longer",
        [w.send(w.slow), time(round(1000 * (w.slow.timeout or 0)) - 500), time(500)],
        "sent 0; timed_out 0",
    )
    yield ("too late", [w.send(plain), time(TIMEOUT), receive(w.reply(ok(plain)))], "sent 0; timed_out 0; received 1")
    yield ("nothing waits", [receive(w.reply(ok(plain)), w.data, w.reply())], "received 1; received 1; received 0")

    # The response is the field right behind the acknowledge.
    yield (
        "a foreign field in between",
        [w.send(read), receive(w.reply(ok(setting), foreign, data))],
        "sent 0; missing_response 0; received 2",
    )
    yield (
        "the response comes first",
        [w.send(read), receive(w.reply(data, ok(setting)))],
        "sent 0; missing_response 0; received 1",
    )
    yield (
        "the response in a packet of its own",
        [w.send(read), receive(w.reply(ok(setting)), w.reply(data))],
        "sent 0; missing_response 0; received 1",
    )
    yield (
        "a foreign field behind",
        [w.send(write, read), receive(w.reply(ok(setting), foreign, ok(setting), data, foreign))],
        "sent 0 1; acknowledged 0; acknowledged 1 with data; received 2",
    )
    yield (
        "a response that no command has",
        [w.send(asking), receive(w.reply(ok(asking), data))],
        "sent 0; missing_response 0; received 1",
    )
    yield (
        "a refusal has no response",
        [w.send(read), receive(w.reply(ok(setting, 3), data))],
        "sent 0; refused 0 3; received 1",
    )

    # Responses that are missing, broken, or those of another command.
    yield (
        "missing",
        [w.send(read, asking), receive(w.reply(ok(setting), ok(asking)))],
        "sent 0 1; missing_response 0; missing_response 1",
    )
    yield (
        "undecodable",
        [w.send(read, plain), receive(w.reply(ok(setting), w.response(setting, 0, True), ok(plain)))],
        "sent 0 1; undecodable 0 truncated; acknowledged 1",
    )
    yield (
        "a response for somebody else is not the write's",
        [w.send(write), receive(w.reply(ok(setting), data)), receive(w.reply(ok(setting)))],
        "sent 0; received 2; acknowledged 0",
    )
    yield (
        "the answer of the read, though that of the write is lost",
        [w.send(write, read), receive(w.reply(ok(setting), data)), time(TIMEOUT)],
        "sent 0 1; acknowledged 1 with data; timed_out 0",
    )
    yield (
        "the answer of the write, though that of the read is lost",
        [w.send(read, save), receive(w.reply(ok(setting))), receive(w.reply(ok(setting)))],
        "sent 0 1; acknowledged 1; missing_response 0",
    )
    one, two = ((w.conditional, w.asked(w.conditional, i)) for i in (0, 1))
    cond = w.conditional
    yield (
        "the response that the values select",
        [
            w.send(one),
            receive(w.reply(ok(cond), w.response(cond, 1), number=cond.set)),
            receive(w.reply(ok(cond), w.response(cond, 0), number=cond.set)),
        ],
        "sent 0; received 2; acknowledged 0 with data",
    )
    yield (
        "both responses, each for its own command",
        [
            w.send(one, two),
            receive(w.reply(ok(cond), w.response(cond, 1), ok(cond), w.response(cond, 0), number=cond.set)),
        ],
        "sent 0 1; acknowledged 1 with data; acknowledged 0 with data",
    )
    form = w.layouts
    forms = responses(w.of, form)
    second = next(i for i, r in enumerate(forms) if r.when != forms[0].when)
    short, long = ((form, w.asked(form, i)) for i in (0, second))
    yield (
        "the layout that the values select",
        [
            w.send(short),
            receive(w.reply(ok(form), w.response(form, second), number=form.set)),
            receive(w.reply(ok(form), w.response(form, 0), number=form.set)),
        ],
        "sent 0; received 2; acknowledged 0 with data",
    )
    yield (
        "both layouts, each for its own command",
        [
            w.send(short, long),
            receive(w.reply(ok(form), w.response(form, second), ok(form), w.response(form, 0), number=form.set)),
        ],
        "sent 0 1; acknowledged 1 with data; acknowledged 0 with data",
    )
    for i, f in enumerate(forms):
        descriptor, layout = w.response(form, i)
        shortest = min(r.min_size for r in forms if r.when == f.when)
        for size in range(len(layout) + 2):
            answer = (descriptor, layout[:size].ljust(size, b"\0"))
            yield (
                f"{f.name} with {size} bytes",
                [w.send((form, w.asked(form, i))), receive(w.reply(ok(form), answer, number=form.set))],
                f"sent 0; {'acknowledged 0 with data' if size >= shortest else 'undecodable 0 truncated'}",
            )
    yield (
        "a selector that nobody knows",
        [w.send((setting, values_of(setting, "R") | {"function": 99})), receive(w.reply(ok(setting)))],
        "sent 0; acknowledged 0",
    )

    # After a command without an answer, a barrier: what comes before its own answer is late.
    late = w.reply(ok(setting))
    missed = [w.send(write), time(TIMEOUT)]
    yield (
        "a late acknowledge is not that of the next command",
        [*missed, w.send(write), receive(late), receive(w.barrier(2)), receive(late)],
        "sent 0; timed_out 0; sent 1 behind 2; received 1; acknowledged 1",
    )
    yield (
        "a late refusal, a late response, and one for another command",
        [
            w.send(read, plain),
            time(TIMEOUT),
            w.send(read, plain, asking),
            receive(w.reply(ok(setting), data, ok(plain, 3))),
            receive(w.barrier(3), w.reply(ok(setting, 5), ok(plain), ok(asking), w.response(asking))),
        ],
        "sent 0 1; timed_out 0; timed_out 1; sent 2 3 4 behind 3; received 3; "
        "refused 2 5; acknowledged 3; acknowledged 4 with data",
    )
    yield (
        "once it is answered, there is no other",
        [
            *missed,
            w.send(plain),
            receive(w.barrier(2), w.reply(ok(plain))),
            w.send(read),
            receive(w.reply(ok(setting), data)),
        ],
        "sent 0; timed_out 0; sent 1 behind 2; acknowledged 1; sent 2; acknowledged 2 with data",
    )
    yield (
        "one barrier for what follows",
        [*missed, w.send(write), w.send(plain), receive(late), receive(w.barrier(2), late, w.reply(ok(plain)))],
        "sent 0; timed_out 0; sent 1 behind 2; sent 2; received 1; acknowledged 1; acknowledged 2",
    )
    yield (
        "it is not answered, though the command is",
        [*missed, w.send(write), receive(late), time(TIMEOUT), w.send(write), receive(w.barrier(3), late)],
        "sent 0; timed_out 0; sent 1 behind 2; received 1; timed_out 1; sent 2 behind 3; acknowledged 2",
    )
    yield (
        "the answer of an earlier one is late, too",
        [
            *missed,
            w.send(write),
            time(TIMEOUT),
            w.send(write),
            receive(late, w.barrier(2), late),
            receive(w.barrier(3), late),
        ],
        "sent 0; timed_out 0; sent 1 behind 2; timed_out 1; sent 2 behind 3; received 1; received 2; received 1; "
        "acknowledged 2",
    )
    yield (
        "late acknowledges of its own command do not make up its answer",
        [
            w.send(plain, plain),
            time(TIMEOUT),
            w.send(plain),
            receive(w.reply(ok(plain), ok(plain)), w.reply(ok(plain)), w.reply(ok(plain), ok(plain), ok(setting))),
            receive(w.barrier(3), w.reply(ok(plain))),
        ],
        "sent 0 1; timed_out 0; timed_out 1; sent 2 behind 3; received 2; received 1; received 3; acknowledged 2",
    )
    yield (
        "nor do those that may still come",
        [
            *missed,
            w.send(plain),
            time(TIMEOUT // 2),
            w.send(plain, plain),
            receive(w.barrier(2)),
            time(TIMEOUT // 2),
            w.send(plain),
            receive(w.reply(ok(plain), ok(plain))),
        ],
        "sent 0; timed_out 0; sent 1 behind 2; sent 2 3; timed_out 1; sent 4 behind 4; acknowledged 2; acknowledged 3",
    )
    yield (
        "a device that refuses it has answered it",
        [*missed, w.send(plain), receive(w.barrier(2, 1), w.reply(ok(plain)))],
        "sent 0; timed_out 0; sent 1 behind 2; acknowledged 1",
    )
    yield (
        "what comes with its answer spoils it",
        [*missed, w.send(plain), receive(w.reply(ok(plain), ok(plain), foreign), w.reply(ok(plain))), time(TIMEOUT)],
        "sent 0; timed_out 0; sent 1 behind 2; received 3; received 1; timed_out 1",
    )
    yield (
        "what was sent before it is not answered any more",
        [
            w.send(plain),
            time(TIMEOUT // 2),
            w.send(read),
            time(TIMEOUT // 2),
            w.send(read),
            receive(w.barrier(3), w.reply(ok(setting), data)),
        ],
        "sent 0; sent 1; timed_out 0; sent 2 behind 3; timed_out 1; acknowledged 2 with data",
    )
    yield (
        "what was sent before it is answered until then",
        [
            w.send(plain),
            time(TIMEOUT // 2),
            w.send(read),
            time(TIMEOUT // 2),
            w.send(read),
            receive(w.reply(ok(setting), data), w.barrier(3), w.reply(ok(setting), data)),
        ],
        "sent 0; sent 1; timed_out 0; sent 2 behind 3; acknowledged 1 with data; acknowledged 2 with data",
    )
    yield (
        "a further one takes the place of one that is not answered",
        [
            *missed,
            w.send(write),
            time(TIMEOUT // 2),
            w.send(plain),
            time(TIMEOUT // 2),
            w.send(write),
            receive(w.barrier(2), w.reply(ok(plain)), late),
            receive(w.barrier(4), late),
            w.send(plain),
        ],
        "sent 0; timed_out 0; sent 1 behind 2; sent 2; timed_out 1; sent 3 behind 4; received 2; received 1; "
        "received 1; timed_out 2; acknowledged 3; sent 4",
    )
    yield (
        "answered when nothing waits behind it any more",
        [
            *missed,
            w.send(write),
            time(TIMEOUT),
            receive(w.barrier(2), late),
            w.send(write),
            receive(late, w.barrier(3), late),
        ],
        "sent 0; timed_out 0; sent 1 behind 2; timed_out 1; received 1; sent 2 behind 3; received 1; acknowledged 2",
    )
    yield (
        "the sizes of barriers begin again",
        [step for _ in range(63) for step in (w.send(plain), time(TIMEOUT))],
        "sent 0; timed_out 0; " + "; ".join(f"sent {i} behind {(i - 1) % 62 + 2}; timed_out {i}" for i in range(1, 63)),
    )
    yield (
        "none before what cannot be sent",
        [*missed, w.send(*[plain] * 128), w.send(plain), receive(w.barrier(2), w.reply(ok(plain)))],
        "sent 0; timed_out 0; not_sent length; sent 1 behind 2; acknowledged 1",
    )

    # Several commands in one packet, answers in several packets.
    yield (
        "several at once",
        [w.send(plain, read, asking), receive(w.reply(ok(plain), ok(setting), data, ok(asking), w.response(asking)))],
        "sent 0 1 2; acknowledged 0; acknowledged 1 with data; acknowledged 2 with data",
    )
    yield (
        "one packet answers two packets, and one is answered by two",
        [
            w.send(plain, read),
            w.send(plain),
            receive(w.reply(ok(plain)), w.data, w.reply(ok(setting), data, ok(plain))),
        ],
        "sent 0 1; sent 2; acknowledged 0; received 1; acknowledged 1 with data; acknowledged 2",
    )
    yield (
        "equal commands in order",
        [
            w.send(plain),
            w.send(plain, plain),
            receive(w.reply(ok(plain, 1))),
            receive(w.reply(ok(plain), ok(plain, 2))),
        ],
        "sent 0; sent 1 2; refused 0 1; acknowledged 1; refused 2 2",
    )
    yield (
        "an answer that nobody waits for between others",
        [w.send(plain, read), receive(w.reply(ok(asking), w.response(asking), ok(plain), ok(setting), data))],
        "sent 0 1; acknowledged 0; acknowledged 1 with data; received 2",
    )
    yield (
        "a short acknowledge between others",
        [w.send(plain, plain), receive(w.reply(ok(plain), (ok(plain)[0], b"\x01"), ok(plain)))],
        "sent 0 1; acknowledged 0; acknowledged 1; received 1",
    )
    malformed = plain_payload(w, ok(plain), b"\x05\xf1\x01")
    yield (
        "a malformed field behind an answer",
        [w.send(plain, plain), receive(malformed)],
        "sent 0 1; acknowledged 0; received 1",
    )
    malformed = plain_payload(w, ok(setting), b"\x01")
    yield (
        "a malformed field where the response should be",
        [w.send(read), receive(malformed)],
        "sent 0; missing_response 0; received 1",
    )

    # Sets, and commands that are not answered.
    yield (
        "an acknowledge of another set",
        [
            w.send(plain),
            receive(w.reply(ok(plain), number=w.other_set), w.reply(ok(plain), number=0x80)),
            receive(w.reply(ok(plain))),
        ],
        "sent 0; received 1; received 1; acknowledged 0",
    )
    silent = next(f for f in of.fields if "A" in w.letters(f))
    yield (
        "a function without a reply",
        [
            w.send((silent, values_of(silent, "A")), (silent, values_of(silent, "W"))),
            receive(w.reply(ok(silent), number=silent.set)),
            receive(w.reply(ok(silent), number=silent.set)),
        ],
        "sent 0 1; silent 0; acknowledged 1; received 1",
    )
    told = {c.parameter: c.value for c in w.quiet.silent_when}
    yield (
        "silent if its values say so",
        [
            w.send((w.quiet, values_of(w.quiet, "", **told)), w.quiet),
            receive(w.reply(ok(w.quiet), number=w.quiet.set)),
            time(TIMEOUT),
        ],
        "sent 0 1; silent 0; acknowledged 1",
    )
    yield (
        "what cannot be sent is not waited for",
        [
            w.send(*[plain] * 128),
            {"step": "send", "set": w.other_set, "fields": w.send(plain)["fields"]},
            w.send((setting, {"function": 1})),
            w.send(*[plain] * 3),
            receive(w.reply(ok(plain))),
            END,
        ],
        "not_sent length; not_sent unknown; not_sent missing; sent 0 1 2; acknowledged 0; end [1, 2] 0",
    )

    # Noise.
    for name, noise in {
        "the beginning of a packet": LONG,
        "one sync byte": b"u",
        "two of them": b"ue",
        "NMEA": NMEA,
        "noise behind noise": LONG + b"\x80ue\x80\xf0" + LONG,
    }.items():
        for chunk in (1, 3, 1000):
            yield (
                f"{name} before an acknowledge, in pieces of {chunk}",
                [
                    w.send(plain),
                    time(TIMEOUT // 2),
                    receive(noise, w.reply(ok(plain)), w.data, chunk=chunk),
                    time(TIMEOUT // 2),
                    END,
                ],
                f"sent 0; acknowledged 0; received 1; end [] {len(noise)}",
            )
    cut = len(w.data) // 2
    yield (
        "what comes behind the noise and is not whole is not given up",
        [w.send(plain), receive(LONG, w.reply(ok(plain)), w.data[:cut]), time(TIMEOUT), receive(w.data[cut:]), END],
        f"sent 0; acknowledged 0; received 1; end [] {len(LONG)}",
    )
    yield (
        "a packet that has begun to come when a command times out is not lost",
        [w.send(plain), receive(w.data[:cut]), time(TIMEOUT), receive(w.data[cut:]), END],
        "sent 0; timed_out 0; received 1; end [] 0",
    )
    yield (
        "noise is given up when something whole is behind it, at the next time-out",
        [
            w.send(plain),
            receive(LONG, w.data[:cut]),
            time(TIMEOUT),
            w.send(plain),
            receive(w.data[cut:]),
            time(TIMEOUT),
            END,
        ],
        f"sent 0; timed_out 0; sent 1 behind 2; received 1; timed_out 1; end [] {len(LONG)}",
    )
    yield (
        "noise, and nothing behind it",
        [w.send(plain), receive(LONG, w.data), time(TIMEOUT)],
        "sent 0; received 1; timed_out 0",
    )
    for number in m.NO_SETS:
        yield (
            f"nothing waits for the rest of a packet of set {number}, which there is not",
            [w.send(plain), receive(b"ue" + bytes([number, 0xFF]), w.data), END],
            "sent 0; received 1; end [0] 4",
        )
    yield (
        "nothing is late, so nothing is given up",
        [w.send(plain), receive(LONG, w.data), time(TIMEOUT - 1)],
        "sent 0",
    )
    yield (
        "the end gives up the rest",
        [receive(LONG, w.data), END, receive(w.data), END],
        f"received 1; end [] {len(LONG)}; received 1; end [] {len(LONG)}",
    )


def plain_payload(w: Words, field: Wire, rest: bytes) -> bytes:
    """A packet with a field and bytes behind it that are no field."""
    payload = bytes((len(field[1]) + 2, field[0])) + field[1] + rest
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
