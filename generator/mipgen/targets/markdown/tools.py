"""The tools of the workbench that have a page in the reference."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Tool:
    """A tool that the function `mip.<name>` of the workbench adds to a page of the site."""

    name: str
    title: str
    description: str
    command: str = ""  # of `mip`, which does the same


TOOLS = (
    Tool(
        "inspector",
        "Packet inspector",
        "Decodes the packets in pasted bytes, a hex dump, a log or source code: every field, value and flag, and the "
        "checksums.",
        "mip dump 7565...",
    ),
    Tool(
        "builder",
        "Packet builder",
        "Builds a packet from a form: its bytes, the code that sends it, and the device's reply.",
    ),
    Tool(
        "bandwidth",
        "Bandwidth calculator",
        "Computes the bytes per second of a data stream, and the smallest baud rate for it on each port of a device.",
    ),
    Tool(
        "finder",
        "Field finder",
        "Finds a field by its descriptor in any form, its name, a symbol in C, Python or Rust, the vendor's name, "
        "or other words. So does the search at the top of every page.",
    ),
    Tool(
        "live",
        "Live device",
        "Connects to a device at a serial port, or to one that `mip serve` shares: plots and numbers, attitude, "
        "commands and recordings.",
    ),
)
