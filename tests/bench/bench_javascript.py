"""JavaScript relative to a hand-written loop in Node: `python tests/bench/bench_javascript.py`. See `speed.mjs`."""

from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path

from bench_columns import stream

HERE = Path(__file__).parent
FOLDER = HERE.parents[1] / "generated/javascript"
PACKETS = 160_000


def report() -> str:
    with tempfile.NamedTemporaryFile(suffix=".bin") as file:
        file.write(stream(PACKETS))
        file.flush()
        command = ["node", HERE / "speed.mjs", FOLDER, file.name]
        ratios = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    version = subprocess.run(["node", "--version"], capture_output=True, text=True, check=True).stdout.strip()
    out = f"\nNode {version}: a recording of 7 MB, times as long as a hand-written loop over a `DataView`\n\n"
    return out + "".join(f"- {name}: {ratio:.2f}\n" for name, ratio in ratios.items())


if __name__ == "__main__":
    print(report())
