"""A target for Atheris: Python must answer as the generator's own interpreter of the model does.

Inputs are those of parser.c and fields.c; `make fuzz TARGETS="python-parser python-fields"` runs it.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import atheris  # type: ignore[import-not-found]

TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS.parent / p) for p in ("generator", "generated/python", "tests", "tests/python", "tests/fuzz")]

with atheris.instrument_imports(include=["mip_protocol"]):
    import driver

import support  # noqa: E402
from mipgen.lower import codec  # noqa: E402

PAYLOAD = 0x80


def request(source: str, data: bytes) -> dict[str, Any] | None:
    """The request for an input of parser.c or fields.c; None if it is too short."""
    if source == "parser":
        return {"op": "parse", "stream": data[2:].hex(), "chunk": data[0] % 128 or 1000} if len(data) > 2 else None
    if len(data) < 4 or data[1] in (0, 255):
        return None
    payload = data[4:] if data[0] & PAYLOAD else bytes((len(data[4:]) % 254 + 2, data[2])) + data[4:]
    head = b"ue" + bytes((data[1], len(payload[:255]))) + payload[:255]
    return {"op": "decode", "packet": (head + codec.checksum(head)).hex()}


def main() -> None:
    source = sys.argv.pop(1)
    model = support.model("real")

    def check(data: bytes) -> None:
        asked = request(source, data)
        if asked is not None:
            given, wanted = driver.answer(asked), support.expected(model, asked)
            assert given == wanted, f"{asked}: {given}, not {wanted}"

    atheris.Setup(sys.argv, check)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
