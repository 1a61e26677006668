"""What a command client must do, plain and short, on the generator's reference codec.

The drivers of all languages are compared with it: the steps of a `client` request in, its events out.
docs/conformance.md describes both.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import support
from mipgen import model as m
from mipgen.lower import codec

Event = dict[str, Any]
TIMEOUT = 1000  # milliseconds, unless a command is known to take longer
BARRIERS = 62  # sizes: 2 to 63 commands, whose acknowledges still fit into one packet


@dataclass
class Waiting:
    """A command that waits for an answer."""

    number: int
    command: m.Field
    wanted: list[m.Field]  # the response that it asks for, in each of its layouts
    deadline: int
    behind: int  # the size of a barrier that must be answered first; 0: none


@dataclass
class Client:
    of: m.Model
    now: int = 0
    count: int = 0  # of commands sent
    waiting: list[Waiting] = field(default_factory=list)
    missed: int = 0  # commands without an answer, since a barrier was answered
    behind: int = 0  # the size of the last barrier, until it is answered
    acknowledged: int = 0  # commands of barriers
    opened: dict[int, int] = field(default_factory=dict)  # how many events there were when a command could be answered
    buffer: bytes = b""
    skipped: int = 0
    events: list[Event] = field(default_factory=list)

    def happens(self, event: str, **what: Any) -> None:
        self.events.append({"event": event, **what})

    # ---------------------------------------------------------------- steps

    def send(self, step: dict[str, Any]) -> None:
        commands = [self.command(step["set"], f) for f in step["fields"]]
        answer = support.expected_encode(self.of, step) if all(commands) else {"error": "unknown"}
        if "error" in answer:
            self.happens("not_sent", error=answer["error"])
            return
        numbers = list(range(self.count, self.count + len(commands)))
        self.count += len(commands)
        self.happens("sent", packet=self.barrier().hex() + answer["packet"], commands=numbers)
        for number, command, f in zip(numbers, commands, step["fields"], strict=True):
            assert command is not None
            if is_silent(command, f["values"]):
                self.happens("silent", command=number)
            else:
                wanted = wanted_responses(self.of, command, f["values"])
                allowed = max(TIMEOUT, round(1000 * (command.timeout or 0)))
                if not self.behind:
                    self.opened[number] = len(self.events)
                self.waiting.append(Waiting(number, command, wanted, self.now + allowed, self.behind))

    def barrier(self) -> bytes:
        """After a command without an answer: a packet whose reply is unmistakable by its number of acknowledges."""
        number, descriptor = self.of.protocol.barrier
        if not number or not self.missed or self.behind == self.missed + 1:
            return b""
        for _ in self.waiting:
            self.miss()
        self.behind = self.missed + 1
        return codec.build(self.of, number, [(descriptor, b"")] * self.behind)

    def miss(self) -> None:
        self.missed = self.missed % BARRIERS + 1

    def passes(self, packet: bytes) -> bool:
        """Is it the reply to the last barrier? As replies are in order, commands before it will not be answered."""
        number, descriptor = self.of.protocol.barrier
        fields = list(walk(packet))
        acknowledges = all(d == self.of.protocol.acknowledge.descriptor and len(data) == 2 for d, data in fields)
        if packet[2] != number or not fields or not acknowledges or any(data[0] != descriptor for _, data in fields):
            return False
        if self.behind != len(fields):
            return False
        while self.waiting and self.waiting[0].behind != self.behind:
            self.happens("timed_out", command=self.waiting.pop(0).number)
        if self.missed + 1 == self.behind:
            self.missed = 0
        self.behind = 0
        self.acknowledged += len(fields)
        for w in self.waiting:
            w.behind = 0
            self.opened[w.number] = len(self.events)
        return True

    def command(self, number: int, entry: dict[str, Any]) -> m.Field | None:
        known = self.of.candidates(number, entry["descriptor"])
        return next((f for f in known if f.full_name == entry["name"] and f.role == m.COMMAND), None)

    def receive(self, step: dict[str, Any]) -> None:
        data = bytes.fromhex(step["bytes"])
        chunk = step.get("chunk", len(data) or 1)
        for at in range(0, len(data), chunk):
            self.buffer += data[at : at + chunk]
            self.take_packets()
            self.poll()

    def time(self, step: dict[str, Any]) -> None:
        self.now += step["milliseconds"]
        self.poll()

    def end(self, step: dict[str, Any]) -> None:
        while self.buffer:
            self.skip()
            self.take_packets()
        self.poll()
        self.happens("end", waiting=[w.number for w in self.waiting], skipped=self.skipped)

    def poll(self) -> None:
        """Before a command times out, skips noise that holds back whole packets; the start of a packet is kept."""
        while any(w.deadline <= self.now for w in self.waiting):
            noise = next((at for at in range(1, len(self.buffer)) if whole(self.buffer[at:])), 0)
            if not noise:
                break
            self.buffer = self.buffer[noise:]
            self.skipped += noise
            self.take_packets()
        for w in [w for w in self.waiting if w.deadline <= self.now]:
            self.waiting.remove(w)
            self.miss()
            self.happens("timed_out", command=w.number)

    # ---------------------------------------------------------------- packets

    def skip(self) -> None:
        self.buffer = self.buffer[1:]
        self.skipped += 1

    def take_packets(self) -> None:
        """The packets that are complete, up to a candidate that needs more bytes."""
        while self.buffer:
            b = self.buffer
            size = b[3] + 6 if len(b) > 3 else 6
            false = not b"ue".startswith(b[:2]) or (len(b) > 2 and b[2] in m.NO_SETS)
            if not false and len(b) < size:
                return
            if false or codec.checksum(b[: size - 2]) != b[size - 2 : size]:
                self.skip()
            else:
                self.buffer = b[size:]
                self.packet(b[:size])

    def packet(self, packet: bytes) -> None:
        if self.passes(packet):
            return
        fields = list(walk(packet))
        others: list[Event] = []
        answered = False
        while fields:
            descriptor, data = fields.pop(0)
            if descriptor is None:
                others.append({"error": "field_length"})
                continue
            behind = fields[0] if fields and fields[0][0] is not None else None
            answer = self.answer(packet[2], descriptor, data, behind)
            if answer is None:
                others.append(support.expected_field(self.of, packet[2], descriptor, data))
                continue
            self.events.append(answer)
            answered = True
            if "response" in answer:
                fields.pop(0)
        if others or not answered:
            self.happens("received", set=packet[2], fields=others)

    def answer(self, number: int, descriptor: int, data: bytes, behind: Any) -> Event | None:
        """The event that an acknowledge field and the field behind it cause."""
        ack = self.of.protocol.acknowledge
        if number >= 0x80 or descriptor != ack.descriptor or len(data) < 2:
            return None
        answered, code = data[0], data[1]
        waiting = [w for w in self.waiting if not w.behind]
        asked = [w for w in waiting if w.command.set == number and w.command.descriptor == answered]
        bare = [w for w in asked if not behind or behind[0] not in descriptors(self.of, w.command)]
        if code != 0:
            return self.done(asked[0], "refused", code=code) if asked else None
        for w in asked:
            if w in bare and not w.wanted:
                return self.done(w, "acknowledged")
            for layout in w.wanted if w not in bare else ():
                if layout.descriptor != behind[0] or not fits(self.of, layout, behind[1]):
                    continue
                response = decoded(layout, behind[1])
                if response.get("error") != "constant":  # the data has another layout
                    return self.done(w, "undecodable" if "error" in response else "acknowledged", response=response)
        return self.done(bare[0], "missing_response") if bare else None

    def done(self, w: Waiting, event: str, **what: Any) -> Event:
        self.waiting.remove(w)
        return {"event": event, "command": w.number, **what}


# --------------------------------------------------------------------------- facts of the model


def is_silent(command: m.Field, values: dict[str, Any]) -> bool:
    function = next((f for f in command.functions if f.value == values["function"]), None)
    conditions = command.silent_when
    told = bool(conditions) and all(c.holds(values.get(c.parameter)) for c in conditions)
    return told or (function is not None and not function.reply)


def responses(of: m.Model, command: m.Field) -> list[m.Field]:
    found = [of.field(f"{command.family}.{name}") for name in command.responses]
    return [f for f in found if f is not None]


def descriptors(of: m.Model, command: m.Field) -> set[int]:
    return {r.descriptor for r in responses(of, command)}


def wanted_responses(of: m.Model, command: m.Field, values: dict[str, Any]) -> list[m.Field]:
    """The response that a command asks for with its values, in each of its layouts."""
    if command.functions and not any(f.responds and f.value == values["function"] for f in command.functions):
        return []
    conditions = {f.full_name: f.when if f.command == command.name else () for f in responses(of, command)}
    for found in conditions.values():
        if all(c.holds(values.get(c.parameter)) for c in found):
            return [f for f in responses(of, command) if conditions[f.full_name] == found]
    return []


def fits(of: m.Model, layout: m.Field, data: bytes) -> bool:
    """Can the data have this layout of its descriptor, as far as it reaches?"""
    constants = (constant.startswith(data[at : at + len(constant)]) for at, constant in layout.signature)
    return len(of.layouts(layout)) == 1 or (len(data) in of.sizes(layout) and all(constants))


def decoded(response: m.Field, data: bytes) -> dict[str, Any]:
    """A response as a `decode` request shows it."""
    shown: dict[str, Any] = {"descriptor": response.descriptor}
    try:
        values, trailing = codec.decode(response, data)
    except codec.CodecError as error:
        return {**shown, "error": error.kind, "raw": data.hex()}
    return {**shown, "name": response.full_name, "role": response.role, "values": values, "trailing": trailing}


def whole(data: bytes) -> bool:
    """Does it begin with a packet?"""
    size = data[3] + 6 if len(data) > 3 else 6
    begins = data[:2] == b"ue" and len(data) >= size and data[2] not in m.NO_SETS
    return begins and codec.checksum(data[: size - 2]) == data[size - 2 : size]


def walk(packet: bytes) -> Iterator[tuple[int | None, bytes]]:
    """The fields of a packet; None ends them where one is malformed."""
    payload = packet[4:-2]
    while payload:
        length = payload[0]
        if length < 2 or length > len(payload):
            yield None, b""
            return
        yield payload[1], payload[2:length]
        payload = payload[length:]


def expected_client(of: m.Model, request: dict[str, Any]) -> dict[str, Any]:
    client = Client(of)
    steps = {"send": client.send, "receive": client.receive, "time": client.time, "end": client.end}
    for step in request["steps"]:
        steps[step["step"]](step)
    return {"events": client.events}
