"""Reproducible faults between a device and its host, and a log of them."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any

from mip_tools.binding import SYNC, Parser, RawField

from . import damage, wrong
from .kinds import KINDS, Plan, parse_faults, plan
from .log import Injected, json_log

__all__ = ["Faults", "Injected", "json_log", "parse_faults"]

#: Kinds in the order in which they happen to a packet.
_DAMAGE = ("lose", "cut", "change", "double")
_INSERTED = ("noise", "nmea", "false_header", "unknown_set")


@dataclass
class _Line:
    """The state of a receiver at the end of one line."""

    free: int = 0  # when the line has sent all delayed bytes
    apart: int = 0  # when the last packet arrives that does not keep its place
    pending: bytes = b""  # bytes that may be the start of a packet
    hidden: list[bytes] = field(default_factory=list)  # the packets in these bytes
    late: list[tuple[int, bytes]] = field(default_factory=list)  # arrival times, and packets


class Faults:
    """Injects faults into the data that a device sends and receives.

    Each keyword is a kind of fault of `fault_kinds.KINDS` with its rate, a probability, or with
    (rate, amount). `script` has faults at numbered opportunities. The same seed and the same traffic result in
    the same faults; each kind of fault is independent of the others.

        faults = Faults(seed=1, lose=0.01, noise=(0.1, 32), script=["lose_answer@3"])

    Noise and false headers are inserted only between packets. A receiver that searches again after a
    false start loses no packet because of them: all packets that are not logged as damaged arrive intact,
    unless a repeated or reordered one completes a false start by chance.
    """

    def __init__(
        self,
        *,
        seed: int = 0,
        log: Callable[[Injected], None] | None = None,
        every_packet: bool = False,
        script: Iterable[str] = (),
        plans: Mapping[str, Plan] | None = None,
        **rates: float | tuple[float, float],
    ) -> None:
        """`every_packet`: log every packet that is sent, faulty or not. Raises Failure.

        `plans`: what `parse_faults` returns.
        """
        self._log = log
        self._every = every_packet
        self._plans = {**(plans or {})}
        for kind, rate in rates.items():
            self._plans[kind] = plan(kind, *rate) if isinstance(rate, tuple) else plan(kind, rate)
        for kind, exact in parse_faults(",".join(script)).items():
            self._plans[kind] = replace(self._plans.get(kind, exact), places=exact.places)
        self._always = dict(self._plans)
        self._seed = seed
        self._random: dict[str, Random] = {}
        self._chances: dict[str, int] = {}
        self._active: dict[str, list[str]] = {}
        self.add(())
        self._lines: dict[Hashable, _Line] = {}
        self._seen: dict[tuple[int, int], RawField] = {}
        self._taken = 0

    def add(self, plans: Iterable[Mapping[str, Plan]]) -> None:
        """Replaces the faults that were added before; those of the constructor remain."""
        self._plans = dict(self._always)
        for more in plans:
            self._plans.update(more)
        for kind in self._plans.keys() - self._random.keys():
            self._random[kind] = Random(f"{self._seed}:{kind}")
            self._chances[kind] = 0
        self._active = {
            chance: [k for k in KINDS if k in self._plans and KINDS[k].of == chance]
            for chance in {kind.of for kind in KINDS.values()}
        }

    # ----------------------------------------------------------------- chances

    def _strikes(self, kind: str) -> bool:
        self._chances[kind] += 1
        planned = self._plans[kind]
        by_chance = planned.rate > 0 and self._random[kind].random() < planned.rate
        return by_chance or self._chances[kind] in planned.places

    def _struck(self, chance: str) -> list[str]:
        return [kind for kind in self._active[chance] if self._strikes(kind)]

    def _most(self, kind: str) -> int:
        return int(self._plans[kind].amount)

    def _seconds(self, kind: str) -> int:
        """Returns a random duration in nanoseconds, 10 % to 100 % of the maximum."""
        most = self._plans[kind].amount
        return int(self._random[kind].uniform(0.1, 1.0) * most * 1e9)

    def tell(self, now: int, kind: str, detail: str, **more: Any) -> None:
        """Logs a fault."""
        if self._log is not None:
            self._log(Injected(now, kind, detail, **more))

    # ----------------------------------------------------------------- from the device

    def transmit(self, now: int, packet: bytes, line: Hashable = None) -> list[tuple[int, bytes]]:
        """Returns what a line transmits instead of a packet: pieces of bytes, each with a delay in ns, in order.

        Calls for one line must be in the order of their times. An NMEA sentence passes unchanged.
        """
        mip = packet[:2] == SYNC
        if self._every and mip:
            self.tell(now, "sent", "a packet is sent", packet=packet)
        struck = self._struck("packet") if mip else []
        if not struck and line not in self._lines:
            return [(0, packet)]
        at = self._lines.pop(line, None) or _Line()
        before = b""
        packets: list[bytes] = []
        for kind in _INSERTED:
            if kind in struck:
                before += self._inserted(now, kind, packets)
        body, intact = self._body(now, packet, struck)
        if intact and mip:
            packets.append(packet)
        if "double_packet" in struck:
            self.tell(now, "double_packet", "the packet arrives twice", packet=packet, added=packet)
            body += packet
            packets.append(packet)
        moved = [kind for kind in ("repeat_packet", "reorder_packet") if kind in struck and intact]
        if "reorder_packet" in moved:
            body = body[len(packet) :]
            packets.remove(packet)
        before = self._apart(now, at, before, body, packets)
        parts = self._timed(now, at, before, body, struck, packet)
        parts += [(self._moved(now, at, kind, packet), packet) for kind in moved]
        if at.pending or max(at.free, at.apart) > now:
            self._lines[line] = at
        return parts

    def forget(self, now: int, line: Hashable = None) -> None:
        """Loses the bytes in transit on a line that has been cut."""
        at = self._lines.pop(line, _Line())
        for arrival, packet in at.late:
            if arrival > now:
                text = "the packet was in transit when the line was cut"
                self.tell(now, "disconnect", text, packet=packet, damaged=True)

    def _inserted(self, now: int, kind: str, packets: list[bytes]) -> bytes:
        random = self._random[kind]
        if kind == "noise":
            made = damage.noise(self._most(kind), random)
        elif kind == "nmea":
            made = damage.make_nmea(random)
        elif kind == "false_header":
            made = damage.false_header(random)
        else:
            made = damage.unknown_packet(random)
            packets.append(made)
        self.tell(now, kind, f"{len(made)} bytes are inserted", added=made)
        return made

    def _body(self, now: int, packet: bytes, struck: list[str]) -> tuple[bytes, bool]:
        """Returns what remains of a packet, and whether it is complete."""
        if "lose_packet" in struck:
            self.tell(now, "lose_packet", "the packet is lost", packet=packet, damaged=True)
            return b"", False
        kind = next((k for k in _DAMAGE if k in struck), "")  # at most one fault damages a packet
        if not kind:
            return packet, True
        body, what = damage.damage_packet(kind, packet, self._most(kind) or 1, self._random[kind])
        self.tell(now, kind, what, packet=packet, damaged=True)
        return body, False

    def _apart(self, now: int, at: _Line, before: bytes, body: bytes, packets: list[bytes]) -> bytes:
        """Adds zeros to the bytes before a packet if they would otherwise form a packet with it by chance.

        A false start swallows the packets after it until it is complete. In one of 65536 cases, its
        checksum is correct by chance; extra bytes prevent this. In the same way, the bytes after a lost
        byte may happen to equal it.
        """
        wanted, spare = at.hidden + packets, 0
        received: list[bytes] = []
        pending = b""
        for spare in range(8):
            parser, stream = Parser(), at.pending + bytes(spare) + before + body
            received = [bytes(p) for p in parser.feed(stream)]
            pending = stream[len(stream) - parser.pending :]
            if received + damage.parsed_packets(pending) == wanted:
                break
        else:  # has not been seen
            for lost in wanted:
                self.tell(now, "noise", "bytes make up a packet", packet=lost, damaged=True)
        at.hidden, at.pending = wanted[len(received) :], pending
        if spare:
            text = f"{spare} bytes keep a false start from becoming a packet by chance"
            self.tell(now, "noise", text, added=bytes(spare))
        return bytes(spare) + before

    def _timed(
        self, now: int, at: _Line, before: bytes, body: bytes, struck: list[str], packet: bytes
    ) -> list[tuple[int, bytes]]:
        """Returns the parts of a stream with their delays. The line keeps the order: a delay affects what follows."""
        first = max(at.free - now, 0)
        if "delay_packet" in struck:
            later = self._seconds("delay_packet")
            first += later
            self.tell(now, "delay_packet", f"{later / 1e9:.3f} s late", packet=packet)
        stream = before + body
        parts = [(first, stream)]
        if "delay" in struck and len(body) > 1 and at.apart <= now + first:
            later = self._seconds("delay")
            cut = len(before) + self._random["delay"].randrange(1, len(body))
            parts = [(first, stream[:cut]), (first + later, stream[cut:])]
            text = f"{len(stream) - cut} bytes at the end arrive {later / 1e9:.3f} s late"
            self.tell(now, "delay", text, packet=packet)
        at.late = [entry for entry in at.late if entry[0] > now]
        if parts[-1][0] and packet[:2] == SYNC:
            at.late.append((now + parts[-1][0], packet))
        if parts[-1][0]:  # bytes that are due at the same time follow it
            at.free = now + parts[-1][0] + 1
        return [part for part in parts if part[1]]

    def _moved(self, now: int, at: _Line, kind: str, packet: bytes) -> int:
        """Returns when a packet arrives that does not keep its place: never in the middle of another one."""
        later = max(at.free - now, 0) + self._seconds(kind)
        at.apart = max(at.apart, now + later)
        at.late.append((now + later, packet))
        again = packet if kind == "repeat_packet" else None
        self.tell(now, kind, f"{later / 1e9:.3f} s late", packet=packet, added=again)
        return later

    def data(self, now: int, set_number: int, fields: list[RawField]) -> list[RawField]:
        """Returns the fields of a data packet, with faults."""
        for kind in self._struck("data"):
            fields = self._extended(now, kind, set_number, fields, range(len(fields)))
        return fields

    def _extended(self, now: int, kind: str, set_number: int, fields: list[RawField], places: range) -> list[RawField]:
        """Adds a field, or bytes, that the specification does not define."""
        random, fields = self._random[kind], list(fields)
        if kind.startswith("unknown"):
            added = wrong.unknown_field(set_number, fields, random)
            if added is not None:
                fields.append(added)
                text = f"a field 0x{set_number:02X},0x{added.descriptor:02X} is added"
                self.tell(now, kind, text, added=added.data)
            return fields
        extended = wrong.longer(fields, places, self._most(kind), random)
        if extended is not None:
            at, made = extended
            more = made.data[len(fields[at].data) :]
            text = f"field 0x{set_number:02X},0x{made.descriptor:02X} is {len(more)} bytes longer"
            self.tell(now, kind, text, added=more)
            fields[at] = made
        return fields

    # ----------------------------------------------------------------- answers

    def answer(self, now: int, command: RawField, answer: list[RawField]) -> tuple[int, list[RawField]]:
        """Returns the delay in ns and the fields of the answer to a command; without fields, there is no answer."""
        struck = self._struck("answer")
        if len(answer) > 1:
            struck += self._struck("response")
        response = answer[1] if len(answer) > 1 else None
        delay, fields = 0, list(answer)
        for kind in struck:
            random = self._random[kind]
            if kind == "late_answer":
                delay = self._seconds(kind)
                self.tell(now, kind, f"{delay / 1e9:.3f} s late", command=command)
            elif kind in ("unknown_field_in_answer", "longer_response"):
                if fields and (kind.startswith("unknown") or len(fields) > 1):
                    fields = self._extended(now, kind, command.set, fields, range(1, len(fields)))
            else:
                changed, what = wrong.answer(kind, command, fields, self._seen, random)
                if changed != fields:
                    self.tell(now, kind, what, command=command)
                    fields = changed
        if response is not None and self._active["response"]:
            self._seen[response.set, response.descriptor] = response
        return delay, fields

    # ----------------------------------------------------------------- to the device

    def receive(self, now: int, data: bytes) -> bytes:
        """Returns the bytes that the device receives. The faults do not depend on how the data is divided."""
        if not self._active["byte"]:
            return data
        made = bytearray()
        for byte in data:
            self._taken += 1
            out = bytes((byte,))
            for kind in self._struck("byte"):
                if kind == "command_lose":
                    out = b""
                elif kind == "command_double":
                    out += out
                elif out:
                    out = bytes((out[0] ^ self._random[kind].randrange(1, 256),)) + out[1:]
                self.tell(now, kind, f"byte {self._taken} on the way to the device")
            made += out
        return bytes(made)

    def event(self, now: int) -> str:
        """Returns a fault of the device itself, or an empty text; called every 100 ms of simulated time."""
        for kind in self._struck("tick"):
            self.tell(now, kind, KINDS[kind].description)
            return kind
        return ""
