"""The sizes, stack and complexity in the documentation are those that `make bench README=1` would write."""

from __future__ import annotations

import sys

from support import ROOT, heavy, need

sys.path.append(str(ROOT / "tests/bench"))
import bench_c


@heavy("arm-none-eabi-gcc")
def test_the_table_of_sources() -> None:
    need("arm-none-eabi-gcc")
    made, committed = bench_c.by_source().splitlines(), bench_c.BY_SOURCE.read_text("utf-8").splitlines()
    if made[0] == committed[0]:
        assert made == committed
    else:  # another compiler has other sizes; the complexity is that of the sources
        assert [(row.split("|")[1:2], row.split("|")[-2:]) for row in made[2:]] == [
            (row.split("|")[1:2], row.split("|")[-2:]) for row in committed[2:]
        ]
    assert "\n".join(committed) in (ROOT / "generated/c/docs/measurements.md").read_text("utf-8")


def test_how_complexity_is_counted() -> None:
    source = "int a(int b) {\n    return b;\n}\nint c(int d) {\n    if (d && d > 1) { /* if */\n    }\n"
    source += "    return d ? 1 : 2;\n}\n"
    assert bench_c.complexity(source) == (4, "c")
    sources = {p.stem: p.read_text("utf-8") for p in bench_c.SOURCES.glob("mip/*/*.c") if p.stem in bench_c.PARTS}
    larger = {name for name, text in sources.items() if bench_c.complexity(text)[0] > 10}
    assert larger == {"codec", "program", "client"}  # whose functions the README names
