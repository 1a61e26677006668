"""The tools of the site, which are those of the JavaScript target."""

from __future__ import annotations

from dataclasses import dataclass

from ... import model as m

#: What the pages of the site load.
FOLDER = "docs/assets/"


@dataclass(frozen=True)
class Tool:
    """A tool that the function `mip.<name>` of the scripts puts into a page."""

    name: str
    title: str
    description: str
    option: str  # of the function: what the fragment of the address gives


TOOLS = (
    Tool(
        "inspector",
        "Packet inspector",
        "Decodes the packets in a hex dump, a log or source code: every field, value and flag, and the checksums.",
        "text",
    ),
    Tool(
        "builder",
        "Packet builder",
        "Builds a packet from a form: its bytes, the code that sends it, and the answer of the device.",
        "field",
    ),
    Tool(
        "bandwidth",
        "Bandwidth calculator",
        "Computes the bytes per second of a data stream, and the smallest baud rate for it on each port of a device.",
        "device",
    ),
    Tool(
        "finder",
        "Field finder",
        "Finds a field by its descriptor in any form, its name, a symbol in C, Python or Rust, the vendor's name, "
        "or other words. So does the search at the top of every page.",
        "text",
    ),
)


def start(tool: Tool, model: m.Model) -> str:
    """What a tool shows at first: the inspector, a packet."""
    return next((e.packet.hex(" ").upper() for e in model.examples), "") if tool.name == "inspector" else ""
