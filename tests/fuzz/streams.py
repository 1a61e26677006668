"""`make fuzz TARGETS=differential`: all languages find the same packets and fields in the same streams.

In each language, a small program prints what it makes of streams, as text; tests/c/fuzz/answers.c defines the form. The
streams are known inputs that are changed at random, as for the targets `…-random`. differential.py sends far fewer
requests, and also compares decoded values and clients.
"""

from __future__ import annotations

import os
import random
import subprocess
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import zip_longest
from pathlib import Path

import c_build
import fuzz
from support import SPECS, need

BATCH = 100_000  # changed inputs; programs are started for each batch
TESTS = fuzz.TESTS


class Session:
    def __init__(self, spec: str, folder: Path) -> None:
        """Builds the programs of all languages in an empty folder."""
        of = SPECS[spec][1]
        c = c_build.compiled(folder / "c", spec, "cc", TESTS / "c/fuzz/answers.c", *c_build.SANITIZED)
        rust = fuzz.build_rust("", spec, folder / "rust", "answers", fuzz.CHECKS)
        self.commands = {
            "c": [c],
            "python": ["env", f"PYTHONPATH={of}/python", need("python3"), TESTS / "python/answers.py"],
            "rust": [rust],
            "javascript": [need("node"), TESTS / "javascript/answers.mjs", of / "javascript"],
        }
        self.makers = []
        for source in ("parser", "fields"):
            name = f"{source}-invented" if spec == "invented" and source == "fields" else source
            files = (TESTS / "c/fuzz/replay.c", TESTS / "c/fuzz/streams.c")
            program, inputs = folder / f"streams-{source}", folder / f"{source}.hex"
            c_build.run(need("cc"), "-std=c99", "-O2", f"-D{source.upper()}", *files, "-o", program)
            self.makers.append([program, fuzz.hexadecimal(inputs, [*fuzz.begin(name), *fuzz.known(name)])])

    def run(self, seconds: float, chance: random.Random) -> Iterator[int]:
        """Yields the number of streams that each language has answered, for each batch."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for maker in self.makers:
                made = subprocess.run(
                    [*maker, str(BATCH), str(chance.getrandbits(63))], stdout=subprocess.PIPE, check=True
                )
                streams = made.stdout.splitlines()[:-1]  # the last one is a summary
                different(streams, self.answers(streams))
                yield len(streams)

    def answers(self, streams: list[bytes]) -> dict[str, list[bytes]]:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            given = pool.map(lambda command: answered(command, streams), self.commands.values())
            return dict(zip(self.commands, given, strict=True))


def answered(command: list[str | Path], streams: list[bytes]) -> list[bytes]:
    """The answers of a program; for a stream that ends it, the answer states so."""
    lines = b"".join(line + b"\n" for line in streams)
    done = subprocess.run(command, input=lines, capture_output=True)
    if done.returncode == 0:
        return done.stdout.splitlines()
    if len(streams) == 1:
        return [b"ended: " + done.stderr[-2000:].strip()]
    half = len(streams) // 2
    return answered(command, streams[:half]) + answered(command, streams[half:])


def different(streams: list[bytes], answers: dict[str, list[bytes]]) -> None:
    """Fails with the first stream to which not all answers are the same."""
    for stream, *given in zip_longest(streams, *answers.values(), fillvalue=b"nothing"):
        if len(set(given)) > 1:
            shown = [f"{name}: {answer.decode()}" for name, answer in zip(answers, given, strict=True)]
            raise SystemExit("\n".join([stream.decode(), *shown]))
