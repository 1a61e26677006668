"""Takes pictures of the reference as a site, in Chromium.

    PYTHONPATH=generator:tests python docs/pictures/pages.py SITE FOLDER

Each is at most 300 kB. Those that a README shows are committed; the others are for a look at what has changed.
"""

from __future__ import annotations

import sys
from pathlib import Path

import browser

LARGEST = 300_000  # bytes
FIELD, GUIDE = "fields/sensor/scaled_accel.html", "guides/stream_imu_data.html"
#: Name -> the page, its width, and its height if that is not 900.
PICTURES: dict[str, tuple[str, int, int]] = {
    "home": ("index.html", 1400, 900),
    "field": (FIELD, 1400, 900),
    "guide": (GUIDE, 1400, 900),
    "builder": ("tools/builder.html#3dm.message_format", 1400, 900),
    "bandwidth": ("tools/bandwidth.html#3dm-cv7-gnss-ins", 1400, 900),
    **{
        f"{name}-{width}{shade}": (address, width, height)
        for name, address in (
            ("inspector", "tools/inspector.html"),
            ("finder", "tools/finder.html#accel"),
            ("live", "tools/live.html"),
        )
        for width, height in ((390, 900), (1400, 900), (1920, 1000))
        for shade in ("", "-dark")
    },
    "home-390": ("index.html", 390, 900),
    "field-390": (FIELD, 390, 900),
    "field-1920": (FIELD, 1920, 1000),
    "home-dark": ("index.html", 1400, 900),
    "field-dark": (FIELD, 1400, 900),
    "field-print": (FIELD, 794, 1123),
    "guide-print": (GUIDE, 794, 1123),
}
FILLED = (
    "new Promise((done) => { const look = () => {"
    " const tool = document.querySelector('[data-tool]');"
    " if (!tool || tool.querySelector('input, select, textarea')) requestAnimationFrame(() => setTimeout(done, 300));"
    " else setTimeout(look, 20); }; look(); })"
)


def take(site: Path, folder: Path) -> list[Path]:
    """The pictures, in their order."""
    folder.mkdir(parents=True, exist_ok=True)
    taken = []
    with browser.page() as page:
        for name, (address, width, height) in PICTURES.items():
            page.call(
                "Emulation.setEmulatedMedia",
                media="print" if name.endswith("-print") else "screen",
                features=[{"name": "prefers-color-scheme", "value": "dark" if name.endswith("-dark") else "light"}],
            )
            page.size(width, height)
            path, _, fragment = address.partition("#")
            page.open("about:blank")
            page.open((site.resolve() / path).as_uri() + (f"#{fragment}" if fragment else ""))
            page.run(FILLED)
            taken.append(folder / f"{name}.png")
            page.screenshot(taken[-1], whole=False)
            if taken[-1].stat().st_size > LARGEST:
                sys.exit(f"{taken[-1]}: {taken[-1].stat().st_size} bytes; at most {LARGEST}")
        assert page.complaints == []
    return taken


if __name__ == "__main__":
    for path in take(Path(sys.argv[1]), Path(sys.argv[2])):
        print(path)
