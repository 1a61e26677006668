"""Writes the report of `mip doctor` as a self-contained page: findings, and a timeline of all sets as SVG."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from ..text import show
from ..text.clocks import stamp
from ..text.numbers import hertz
from .examined import Examined
from .findings import Finding, event_line

_COLOURS = {
    "line damage": "#c0392b",
    "overload": "#d68910",
    "pause": "#7f8c8d",
    "reset": "#8e44ad",
    "clock step": "#2471a3",
    "changed format": "#148f77",
}
_OTHER = "#555555"
_WIDTH, _LEFT, _ROW = 960, 150, 26

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; color: #222 }
h1 { font-size: 1.4rem } h2 { font-size: 1.1rem; margin-top: 2rem }
li { margin: .4rem 0 } li ul { color: #555 } code { background: #f2f2f2 } table { border-collapse: collapse }
td, th { padding: .15rem .8rem .15rem 0; text-align: left } td + td { text-align: right }
@media (prefers-color-scheme: dark) { body { background: #1b1b1b; color: #ddd } code { background: #333 } }
"""


def page(name: str, examined: Examined, findings: Sequence[Finding]) -> str:
    """Writes an HTML page that needs no other file."""
    body = "\n".join(_body(name, examined, findings))
    title = escape(f"mip doctor: {name}")
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{_STYLE}</style></head>\n<body>\n{body}\n</body></html>\n"
    )


def _body(name: str, examined: Examined, findings: Sequence[Finding]) -> Iterator[str]:
    yield f"<h1>{escape(name)}</h1>"
    yield f"<p>{examined.size} bytes, {examined.packets} packets</p>"
    yield "<h2>Findings</h2>"
    yield "<ul>" if findings else "<p>Nothing is wrong.</p>"
    for f in findings:
        inner = "".join(f"<li>{escape(text)}</li>" for text in f.details)
        more = f"<br>{escape(f.remedy)}" if f.remedy else ""
        yield f"<li><b>{escape(f.cause)}</b>: {escape(f.text)}{more}{f'<ul>{inner}</ul>' if inner else ''}</li>"
    if findings:
        yield "</ul>"
    if examined.spans and examined.clock:
        yield "<h2>Timeline</h2>"
        yield from _timeline(examined)
    yield "<h2>Rates</h2><table><tr><th>field</th><th>Hz</th></tr>"
    for key, rate in sorted(examined.rates.items()):
        yield f"<tr><td>{escape(show.set_name(key[0]))}: {escape(examined.names[key])}</td><td>{hertz(rate)}</td></tr>"
    yield "</table>"


def _timeline(examined: Examined) -> Iterator[str]:
    times = [t for spans in examined.spans.values() for span in spans for t in span]
    times += [e.time for e in examined.events if e.time is not None]
    first, last = min(times), max(times)

    def x(time: int) -> float:
        return round(_LEFT + (_WIDTH - _LEFT - 10) * (time - first) / max(last - first, 1), 1)

    rows = sorted(examined.spans)
    height = _ROW * (len(rows) + 2)
    yield f'<svg viewBox="0 0 {_WIDTH} {height}" width="100%" role="img" aria-label="timeline" font-size="12">'
    for i, number in enumerate(rows):
        y = _ROW * i + 6
        yield f'<text x="0" y="{y + 11}" fill="currentColor">{escape(show.set_name(number))}</text>'
        for begin, end in examined.spans[number]:
            width = max(x(end) - x(begin), 1)
            yield f'<rect x="{x(begin)}" y="{y}" width="{width:.1f}" height="14" fill="#8fb8de"/>'
    for e in examined.events:
        if e.time is not None:
            colour = _COLOURS.get(e.cause, _OTHER)
            where = f'x1="{x(e.time)}" x2="{x(e.time)}" y1="2" y2="{_ROW * len(rows)}"'
            title = f"<title>{escape(f'{e.cause}: {event_line(e, examined)}')}</title>"
            yield f'<line {where} stroke="{colour}" stroke-width="2">{title}</line>'
    assert examined.clock is not None
    y = _ROW * (len(rows) + 1) - 8
    yield f'<text x="{_LEFT}" y="{y}" fill="currentColor">{escape(stamp(examined.clock, first, 3))}</text>'
    until = escape(stamp(examined.clock, last, 3))
    yield f'<text x="{_WIDTH - 10}" y="{y}" text-anchor="end" fill="currentColor">{until}</text>'
    at = _LEFT
    for cause in dict.fromkeys(e.cause for e in examined.events):
        yield f'<text x="{at}" y="{y + 18}" fill="{_COLOURS.get(cause, _OTHER)}">{cause}</text>'
        at += 8 * len(cause) + 20
    yield "</svg>"
