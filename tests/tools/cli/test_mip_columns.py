"""`mip export` without what it does not need, and `mip plot`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from program import ENVIRONMENT, log, mip, run
from support import later

np, pa, pq, pyplot = (later(name) for name in ("numpy", "pyarrow", "pyarrow.parquet", "matplotlib.pyplot"))


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "log.bin").write_bytes(b"noise" + log() + b"\x75\x65\x80")
    return tmp_path / "log.bin"


@pytest.mark.parametrize("form", ["csv", "jsonl", "parquet"])
def test_no_export_imports_pandas(form: str, path: Path) -> None:
    """`pyarrow.array` does so where pandas is installed, which takes longer than most exports."""
    program = "import sys; from mip_tools.__main__ import main; main(sys.argv[1:]); sys.exit('pandas' in sys.modules)"
    words = ["export", path, "-o", path.with_suffix(f".{form}"), "--names"]
    assert subprocess.run([sys.executable, "-c", program, *words], env=ENVIRONMENT).returncode == 0


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["export", "log.bin", "-o", "t.parquet"], "export: numpy is missing; pip install numpy"),
        (["plot", "log.bin", "sensor", "-o", "t.png"], "plot: matplotlib is missing; pip install matplotlib"),
    ],
)
def test_missing_extras(words: list[str], error: str, path: Path) -> None:
    words = [str(path.with_name(w)) if w in ("log.bin", "t.parquet", "t.png") else w for w in words]
    code, out, said = mip(*words, extras=False)
    assert (code, out) == (1, "") and said.startswith(f"mip {error}") and said.count("\n") == 1
    assert [p.name for p in path.parent.iterdir()] == ["log.bin"]


# --------------------------------------------------------------------------- plot


def test_a_picture(path: Path, tmp_path: Path) -> None:
    words = ("sensor.scaled_accel", "filter_data.llh_position.ellipsoid_height")
    assert mip("plot", path, *words, "-o", tmp_path / "t.png") == (0, "", "")
    red, green, blue, _ = np.moveaxis(pyplot.imread(tmp_path / "t.png"), 2, 0)
    assert red.shape[1] == 1200
    # The first three colours of matplotlib, perhaps blended with white; blue is also the second diagram.
    for more, less in ((blue, red), (red, blue), (green, np.maximum(red, blue))):
        assert (more - less > 0.24).any()
    assert mip("plot", path, "sensor.scaled_accel.z", "--together", "-o", tmp_path / "t.svg")[0] == 0
    text = (tmp_path / "t.svg").read_text()
    assert text.startswith("<?xml") and text.count("#2ca02c") == 0


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("sensor.scaled_accel", "no window can be opened here; write an image with -o FILE.png"),
        ("sensor.scaled_accel -o t.gif", "'.gif' is not a known format; name a file that ends in .png, .svg or .pdf"),
        ("sensor.scaled_accel.w -o t.png", "sensor.scaled_accel has no element 'w'; it has x, y, z"),
        ("sensor.scaled_accel.scaled_accel.w -o t.png", "sensor.scaled_accel has no element 'w'; it has x, "),
        ("base.ping -o t.png", "base.ping is not a data field; `mip info` lists the fields of a log"),
        ("gnss_2.llh_position -o t.png", "log.bin has no gnss_2.llh_position; `mip info` lists its fields"),
        ("sensor.scaled -o t.png", "'sensor.scaled' is not a field; did you mean "),
    ],
)
def test_errors_of_plots(
    words: str, error: str, path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(path.parent)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    code, out, said = run(capsys, "plot", "log.bin", *words.split())
    status = 1 if "no window" in error or "log.bin has no" in error else 2
    assert (code, out) == (status, "") and said.startswith(f"mip plot: {error}") and said.count("\n") == 1, said
    assert [p.name for p in path.parent.iterdir()] == ["log.bin"]
