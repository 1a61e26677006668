"""`make fuzz TARGETS=differential-values`: the bindings of all languages give the same answers to the same requests.

The requests are those of the conformance suite. They are made of the inputs that C and Rust are fuzzed with, changed at
random: streams in pieces, and fields and payloads as packets. Those of clients are steps drawn at random.
"""

from __future__ import annotations

import json
import random
import time
from collections.abc import Callable
from typing import Any

import fuzz
from conformance.scenarios import Words, random_steps
from mipgen.lower import codec
from support import OFFERS, Driver, driver, model

LANGUAGES = ("c", "cpp", "python", "rust", "javascript")
BATCH = 4000  # requests: drivers are restarted for each batch
PAYLOAD = 0x80
Request = dict[str, Any]


def request(source: str, data: bytes) -> Request | None:
    """The request for an input of parser.c or fields.c; None if it is too short."""
    if source == "parser":
        return {"op": "parse", "stream": data[2:].hex(), "chunk": data[0] % 128 or 1000} if len(data) > 2 else None
    if len(data) < 4 or data[1] in (0, 255):
        return None
    payload = data[4:] if data[0] & PAYLOAD else bytes((len(data[4:]) % 254 + 2, data[2])) + data[4:]
    head = b"ue" + bytes((data[1], len(payload[:255]))) + payload[:255]
    return {"op": "decode", "packet": (head + codec.checksum(head)).hex()}


def changed(chance: random.Random, data: bytes, others: list[bytes], largest: int) -> bytes:
    """An input after a few random changes: bytes, pieces that are repeated or left out, pieces of another input."""
    for _ in range(chance.randrange(5)):
        at = chance.randrange(len(data) + 1)
        end = min(len(data), at + chance.randrange(1, 9))
        other = chance.choice(others)
        begin = chance.randrange(len(other) + 1)
        data = chance.choice([
            data[:at] + chance.randbytes(end - at) + data[end:],
            data[:at] + chance.choice((b"\0", b"\xff", b"\1", b"u", b"ue")) + data[end:],
            data[:at] + data[end:],
            data[:end] + data[at:],
            data[:at] + other[begin:],
        ])  # fmt: skip
    return data[:largest]


class Session:
    def __init__(self, seed: str) -> None:
        self.chance = random.Random(seed)
        self.inputs = {s: [*fuzz.begin(s), *fuzz.known(s)] for s in ("parser", "fields")}
        self.words = Words(model("real"))
        self.drivers = [driver(language, "real") for language in LANGUAGES]

    def drawn(self) -> Request:
        source = self.chance.choice(("parser", "fields", "fields", "client"))
        if source == "client":
            return {"op": "client", "steps": random_steps(self.chance, self.words)}
        inputs = self.inputs[source]
        data = changed(self.chance, self.chance.choice(inputs), inputs, fuzz.LARGEST[source])
        return request(source, data) or self.drawn()

    def run(self, seconds: float) -> int:
        """Returns the number of requests that each language has answered."""
        count, end = 0, time.monotonic() + seconds
        while time.monotonic() < end:
            asked = [self.drawn() for _ in range(BATCH)]
            different(asked, [(d, of(d, asked)) for d in self.drivers])
            count += len(asked)
        return count


def of(d: Driver, asked: list[Request]) -> list[Any]:
    """The answers of a driver, None to what it does not offer: C++ has no client."""
    given = iter(answered(d, [r for r in asked if r["op"] in OFFERS[d.language]]))
    return [next(given) if r["op"] in OFFERS[d.language] else None for r in asked]


def answered(d: Driver, asked: list[Request]) -> list[Any]:
    """The same; for a request that ends a driver, the answer states so."""
    try:
        return list(d.ask(asked))
    except AssertionError as error:
        if len(asked) == 1:
            return [{"ended": str(error)[:2000]}]
        half = len(asked) // 2
        return answered(d, asked[:half]) + answered(d, asked[half:])


def different(asked: list[Request], answers: list[tuple[Driver, list[Any]]]) -> None:
    """Fails with the first request, made small, that languages answer in different ways."""
    first, wanted = answers[0]
    for other, given in answers[1:]:
        for r, w, g in zip(asked, wanted, given, strict=True):
            if w != g and g is not None:
                small = smallest(r, lambda x, o=other: answered(first, [x]) != answered(o, [x]))  # type: ignore[misc]
                raise SystemExit("\n".join([
                    json.dumps(small), *(f"{d.language}: {json.dumps(answered(d, [small])[0])}" for d in (first, other))
                ]))  # fmt: skip


def smallest(r: Request, wrong: Callable[[Request], bool]) -> Request:
    """Less of a stream or fewer steps that are still answered in different ways."""
    key = {"parse": "stream", "client": "steps"}.get(r["op"])
    size = 64
    while key and size > 1:
        at, size = 0, size // 2
        while at < len(r[key]):
            step = size if key == "steps" else 2 * size
            fewer = r | {key: r[key][:at] + r[key][at + step :]}
            r, at = (fewer, at) if wrong(fewer) else (r, at + step)
    return r
