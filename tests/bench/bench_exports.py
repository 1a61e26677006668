"""`mip export` beside the columns and pandas doing the same: `python tests/bench/bench_exports.py LOG`.

Each runs in a process of its own; the least CPU time of several runs counts.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[2]
RUNS = 3
ENVIRONMENT = {**os.environ, "PYTHONPATH": f"{ROOT / 'tools'}{os.pathsep}{ROOT / 'generated/python'}"}
FIELDS = ("sensor.scaled_accel", "sensor.scaled_gyro", "sensor.scaled_mag", "filter_data.euler_angles")

READ = f"import sys, mip_tools; frame = mip_tools.read_log(sys.argv[1]).frame({list(FIELDS)})\n"
#: Format -> the code that writes the frame to a file.
API = {
    "parquet": "import pyarrow as pa, pyarrow.parquet as pq; pq.write_table(pa.Table.from_pandas(frame), sys.argv[2])",
    "arrow": "import pyarrow as pa; t = pa.Table.from_pandas(frame)\n"
    "with pa.OSFile(sys.argv[2], 'wb') as f, pa.ipc.new_file(f, t.schema) as w: w.write_table(t)",
    "npz": "import numpy as np; np.savez(sys.argv[2], **{name: frame[name].to_numpy() for name in frame})",
    "csv": "frame.to_csv(sys.argv[2])",
    "jsonl": "frame.to_json(sys.argv[2], orient='records', lines=True)",
}


def seconds(words: list[str], out: Path) -> float:
    """The CPU time of a process."""
    out.unlink(missing_ok=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *words], env=ENVIRONMENT, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main(log: str) -> None:
    size = Path(log).stat().st_size / 1e6
    print(f"{'':8} {'export':>8} {'API':>8} {'ratio':>6}   of {size:.1f} MB")
    with TemporaryDirectory() as folder:
        for form, code in API.items():
            out = Path(folder, f"out.{form}")
            tool = ["-m", "mip_tools", "export", log, *FIELDS, "-o", str(out)]
            ours = min(seconds(tool, out) for _ in range(RUNS))
            theirs = min(seconds(["-c", READ + code, log, str(out)], out) for _ in range(RUNS))
            print(f"{form:8} {ours:6.2f} s {theirs:6.2f} s {ours / theirs:6.2f}")


if __name__ == "__main__":
    main(sys.argv[1])
