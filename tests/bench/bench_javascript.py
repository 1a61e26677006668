"""JavaScript in Node relative to hand-written loops, on a stream like a recording: see `speed.mjs`."""

from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path

from bench_columns import stream

HERE = Path(__file__).parent


def report() -> str:
    with tempfile.NamedTemporaryFile(suffix=".bin") as file:
        file.write(stream(160_000))
        file.flush()
        command = ["node", HERE / "speed.mjs", HERE.parents[1] / "generated/javascript", file.name]
        ratios = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    out = "\nJavaScript in Node: times as long as a hand-written loop with a `DataView`\n\n"
    return out + "".join(f"- {name}: {ratio:.2f}\n" for name, ratio in ratios.items())
