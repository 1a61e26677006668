"""Draws a session in a terminal as an animated SVG: runs the commands, and shows what they answer.

    python docs/pictures/session.py OUTPUT.svg

Every line is visible without animation, so that the picture also serves where none is played.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from html import escape
from pathlib import Path

SHOWN = "localhost:5005"  # in place of the port that is free
DEVICE = "simulate 3dm-cv7-gnss-ins --motion circle:radius=20,speed=5 --speed 10 --tcp"
COMMANDS = (
    f"mip send {SHOWN} base.get_device_info",
    f"mip send {SHOWN} 3dm.message_format write filter_data 0xD3:10,ned_velocity:10,euler_angles:10",
    f"mip send {SHOWN} 3dm.data_stream_control write filter_data on",
    f"mip record {SHOWN} -o log.bin --duration 6",
    "mip info log.bin",
    "mip dump log.bin --only filter_data.ned_velocity | head -n 3",
    "mip export log.bin -o log.csv",
    "mip plot log.bin filter_data.ned_velocity.north filter_data.ned_velocity.east --together -o plot.svg",
)
ROOT = Path(__file__).resolve().parents[2]
MIP = (sys.executable, "-m", "mip_tools")
ENVIRONMENT = {**os.environ, "PYTHONPATH": os.pathsep.join((f"{ROOT}/tools", f"{ROOT}/generated/python"))}
WIDTH, LINE, MARGIN = 860, 17, 16  # pixels
PLOT_HEIGHT = 270
TYPED, READ, REST = 0.8, 0.5, 6.0  # seconds for a command, for its answer, and at the end
STYLE = """
.step > text { font: 13px ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; white-space: pre; fill: #d8dee9; }
.step > .command { fill: #a3d977; }
@media (prefers-reduced-motion: no-preference) {
  .step { animation: %(total).1fs step-end infinite; }
}
"""


MATPLOTLIB = "svg.fonttype: none\nsvg.hashsalt: session\n"  # text as text, and the same identifiers each time


def shell(command: str, port: str, folder: Path) -> list[str]:
    """The lines that a command writes; `mip` is the one of this Python."""
    program = " ".join(f"'{word}'" for word in MIP)
    line = re.sub(r"\bmip (?=[a-z]+ )", f"{program} ", command).replace(SHOWN, port)
    done = subprocess.run(line, shell=True, cwd=folder, capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode:
        sys.exit(f"{command}: exit status {done.returncode}\n{done.stderr}")
    return [text for text in done.stdout.splitlines() if text]


def session(folder: Path) -> list[tuple[str, list[str]]]:
    """Each command with its answer; the first one goes on while the others run."""
    device = subprocess.Popen((*MIP, *DEVICE.split(), "0"), stdout=subprocess.PIPE, text=True, env=ENVIRONMENT)
    try:
        assert device.stdout is not None
        port = device.stdout.readline().strip()
        return [(f"mip {DEVICE} 5005 &", []), *((c, shell(c, port, folder)) for c in COMMANDS)]
    finally:
        device.terminate()
        device.wait()


def appears(at: float, total: float, number: int) -> str:
    """Keyframes of a step, which is invisible before its time."""
    return f"@keyframes s{number} {{ 0% {{ opacity: 0; }} {100 * at / total:.2f}% {{ opacity: 1; }} }}\n"


def drawing(steps: list[tuple[str, list[str]]], plot: str) -> str:
    total = len(steps) * (TYPED + READ) + READ + REST
    rules, groups, y, at = [], [], MARGIN + LINE, 0.0

    def add(content: str) -> None:
        groups.append(f'<g class="step" style="animation-name: s{len(rules)}">{content}</g>\n')
        rules.append(appears(at, total, len(rules)))

    for command, answer in steps:
        add(f'<text class="command" x="{MARGIN}" y="{y}">$ {escape(command)}</text>')
        at, y = at + TYPED, y + LINE
        if answer:
            lines = enumerate(answer)
            add("\n".join(f'<text x="{MARGIN}" y="{y + LINE * i}">{escape(text)}</text>' for i, text in lines))
        at, y = at + READ, y + LINE * len(answer)
    head, _, rest = plot[plot.index("<svg ") :].partition(">")
    rest = re.sub(r"\s+", " ", re.sub("<metadata>.*</metadata>", "", rest, flags=re.S)).replace("> <", ">\n<").strip()
    box = re.search(r'viewBox="[^"]+"', head)
    assert box, "a plot has a view box"
    add(
        f'<svg x="{MARGIN}" y="{y}" width="{WIDTH - 2 * MARGIN}" height="{PLOT_HEIGHT}" {box.group()} '
        f'xmlns:xlink="http://www.w3.org/1999/xlink">{rest}'
    )
    height = y + PLOT_HEIGHT + MARGIN
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}">\n'
        f"<style>{STYLE % {'total': total}}{''.join(rules)}</style>\n"
        f'<rect width="{WIDTH}" height="{height}" rx="8" fill="#1e2430"/>\n{"".join(groups)}</svg>\n'
    )


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "matplotlibrc").write_text(MATPLOTLIB, "utf-8")
        steps = session(Path(folder))
        plot = (Path(folder) / "plot.svg").read_text("utf-8")
    Path(sys.argv[1]).write_text(drawing(steps, plot), "utf-8")


if __name__ == "__main__":
    main()
