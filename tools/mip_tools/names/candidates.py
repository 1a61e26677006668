"""Names that complete a word of a command line."""

from __future__ import annotations

from collections.abc import Iterable

from ..binding import DEVICES, FAMILIES, FIELDS, SETS, Command, registry
from .occurrence import every
from .typed import constructor_functions


def device_ids() -> list[str]:
    """Returns the ids of all devices."""
    return list(DEVICES)


def field_names(only_commands: bool) -> list[str]:
    """Returns the names of all sets and fields, or of all commands."""
    names: list[str] = []
    for name, row in FIELDS.items():
        if not only_commands or row[2] == "command":
            several = name.partition(".")[0] in FAMILIES.values()
            names += [occurrence.name for occurrence in every(registry.by_name(name))] if several else [name]
    return names if only_commands else [*(set_names[0] for set_names in SETS.values()), *names]


def functions_of(words: Iterable[str]) -> list[str]:
    """Returns the functions of the command among these words."""
    for word in words:
        if word in FIELDS and issubclass(kind := registry.by_name(word), Command):
            return constructor_functions(kind)
    return []
