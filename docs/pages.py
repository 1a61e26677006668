"""Makes the pages of the project part of the site: documents, the READMEs of tools and libraries, the help of `mip`.

python docs/pages.py FOLDER: writes them there, with links that hold on the site, and `pages.json` with titles and
sections, in the order of the contents. Links to files that are not pages become text.
"""

from __future__ import annotations

import json
import posixpath
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
MANUAL = "generated/markdown/docs/"
#: Section -> the path of each page in the project -> its title.
SECTIONS = {
    "Tools": {
        "tools/README.md": "Overview",
        "docs/mip.md": "The program mip",
        "build/commands.md": "Commands and options",
        "docs/columns.md": "Logs as columns and tables",
        "docs/doctor.md": "Find faults in a log or a device",
        "docs/stream.md": "Stream data, Foxglove",
        "docs/robots.md": "MCAP, ROS bags and ROS 2",
        "docs/fleet.md": "Many logs as one data set",
        "docs/settings.md": "Copy and compare settings",
        "docs/simulate.md": "Simulate a device",
        "docs/simulate-reference.md": "Simulator reference",
        "generated/wireshark/README.md": "Wireshark",
        "tools/workbench/README.md": "Workbench in the browser",
    },
    "Libraries": {
        "generated/c/README.md": "C and C++",
        "generated/c/docs/packets.md": "C: packets and fields",
        "generated/c/docs/commands.md": "C: commands",
        "generated/c/docs/cpp.md": "C++17",
        "generated/c/docs/threads.md": "C: interrupts, threads and DMA",
        "generated/c/docs/building.md": "C: build systems",
        "generated/c/docs/measurements.md": "C: memory, size and speed",
        "generated/python/README.md": "Python",
        "generated/rust/README.md": "Rust",
        "generated/javascript/README.md": "JavaScript",
        "generated/ros2/README.md": "ROS 2 messages",
        "generated/kaitai/README.md": "Kaitai Struct",
        "generated/json/README.md": "JSON model",
        "docs/vendor.md": "Vendor a library",
        "docs/versions.md": "Versions and compatibility",
        "docs/status.md": "Status: what is measured and tested",
    },
    "Specification": {
        "spec/README.md": "The specification language",
        "generated/keys.md": "Keys of the language",
        "docs/specifications.md": "Your own fields and protocols",
        "docs/new-language.md": "Generate another language",
        "docs/contribute-a-device.md": "Contribute a device",
        "docs/architecture.md": "Architecture",
        "docs/conformance.md": "Conformance",
        "docs/proofs.md": "Proofs",
        "docs/site.md": "About this site",
    },
}
_LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
_FENCE = re.compile(r"(^```[\s\S]*?^```|^(?: {4}.*\n)+)", re.M)


def name_of(path: str) -> str:
    """The name of a page in the folder.

    >>> name_of("generated/c/README.md"), name_of("generated/c/docs/cpp.md"), name_of("docs/mip.md")
    ('c.md', 'c-cpp.md', 'mip.md')
    """
    parts = path.removesuffix(".md").split("/")
    if "/docs/" in path:
        return f"{parts[-3]}-{parts[-1]}.md"
    return f"{parts[-2] if parts[-1] == 'README' else parts[-1]}.md"


def linked(text: str, path: str, names: dict[str, str]) -> str:
    """The text of a page with the links of the site; code, fenced or indented, stays as it is.

    >>> text = "[a](mip.md#b) [c](../LICENSE) [d](../generated/markdown/docs/units.md)"
    >>> linked(text, "docs/x.md", {"docs/mip.md": "mip.md"})
    '[a](mip.md#b) c [d](../units.md)'
    >>> linked("```text\\n[a](b.md)\\n```\\n\\n    [c](b.md)\\n\\n[d](b.md)\\n", "docs/x.md", {"docs/b.md": "e.md"})
    '```text\\n[a](b.md)\\n```\\n\\n    [c](b.md)\\n\\n[d](e.md)\\n'
    """

    def link(match: re.Match[str]) -> str:
        picture, label, target = match.groups()
        if re.match(r"#|[a-z]+:", target):
            return match[0]
        file, _, anchor = target.partition("#")
        wanted = posixpath.normpath(posixpath.join(posixpath.dirname(path), file))
        wanted = wanted if Path(ROOT, wanted).suffix or picture else f"{wanted}/README.md"
        at = f"#{anchor}" if anchor else ""
        if wanted in names:
            return f"[{label}]({names[wanted]}{at})"
        if wanted == "generated/markdown/README.md":
            return f"[{label}](../index.md)"
        if wanted.startswith(MANUAL):
            return f"[{label}](../{wanted.removeprefix(MANUAL)}{at})"
        return "" if picture else label

    parts = _FENCE.split(text)
    return "".join(part if i % 2 else _LINK.sub(link, part) for i, part in enumerate(parts))


def commands() -> str:
    """The help of `mip` and of each command, as a page."""

    def help_of(*words: str) -> str:
        line = [sys.executable, "-m", "mip_tools", *words, "--help"]
        environment = {"PYTHONPATH": f"{ROOT}/tools:{ROOT}/generated/python", "COLUMNS": "100", "NO_COLOR": "1"}
        return subprocess.run(line, env=environment, capture_output=True, text=True, check=True).stdout

    whole = help_of()
    names = re.findall(r"^ {2}([a-z][a-z-]*) ", whole, re.M)
    sections = [f"## {name}\n\n```text\n{help_of(name)}```\n" for name in names]
    return "\n".join(["# Commands and options\n", f"```text\n{whole}```\n", *sections])


def main(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    names = {path: name_of(path) for pages in SECTIONS.values() for path in pages}
    assert len(set(names.values())) == len(names), "two pages have the same name"
    for path, name in names.items():
        text = commands() if path == "build/commands.md" else (ROOT / path).read_text("utf-8")
        text = re.sub(r"^<details>", '<details markdown="1">', linked(text, path, names), flags=re.M)
        (folder / name).write_text(text, "utf-8")
    contents = {title: {names[path]: page for path, page in pages.items()} for title, pages in SECTIONS.items()}
    (folder / "pages.json").write_text(json.dumps(contents), "utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
