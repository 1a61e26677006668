"""A target for Atheris: Python must answer as the generator's own interpreter of the model does.

Inputs are those of parser.c and fields.c; `make fuzz TARGETS="python-parser python-fields"` runs it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import atheris  # type: ignore[import-not-found]

TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS.parent / p) for p in ("generator", "generated/python", "tests", "tests/python", "tests/fuzz")]

with atheris.instrument_imports(include=["mip_protocol"]):
    import driver

import differential  # noqa: E402
import support  # noqa: E402


def main() -> None:
    source = sys.argv.pop(1)
    model = support.model("real")

    def check(data: bytes) -> None:
        asked = differential.request(source, data)
        if asked is not None:
            given, wanted = driver.answer(asked), support.expected(model, asked)
            assert given == wanted, f"{asked}: {given}, not {wanted}"

    atheris.Setup(sys.argv, check)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
