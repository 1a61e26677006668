"""The names that the runtime defines, read from its own source."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from mipgen.base import resources

#: Headers and sources that are generated for every specification.
_GENERATED = (
    *("connect", "constants", "mip", "names", "profiles", "protocol", "reflection", "registry", "rejected"),
    *("timestamps", "types"),
)
#: Types that a specification defines itself, and that the runtime uses.
_OF_THE_SPECIFICATION = {"mip_ack_code"}

_COMMENTS = re.compile(r"/\*.*?\*/|//[^\n]*|#include[^\n]*|\{[#%].*?[#%]\}", re.DOTALL)


@cache
def runtime_names() -> tuple[str, ...]:
    """Returns the names with the prefix of the library: `mip_parser_init`, `MIP_OK`."""
    identifiers: set[str] = set()
    templates = {f"{name}.h": (resources.root() / f"templates/c/{name}.h.j2") for name in _GENERATED}
    headers = {name: file for name, file in templates.items() if file.is_file()} | _runtime(".h")
    for name, file in headers.items():
        text = _COMMENTS.sub("", file.read_text("utf-8"))
        guard = name.rpartition("/")[2].upper().replace(".", "_")
        identifiers |= set(re.findall(r"\bmip_\w+\b(?!\{\{)", text))
        identifiers |= set(re.findall(r"^(?: *#define| {3,4}) (MIP_\w+)\b(?!\{\{)", text, re.MULTILINE)) - {
            f"MIP_{guard}"
        }
    return tuple(sorted(identifiers - _OF_THE_SPECIFICATION))


@cache
def modules() -> frozenset[str]:
    """Returns the headers and sources that exist for every specification, without the ends of their names."""
    return frozenset({*_GENERATED, *(path.split("/")[-1].partition(".")[0] for path in _runtime("") if "src/" in path)})


@cache
def in_namespace() -> frozenset[str]:
    """Returns the names in the namespace `mip` of C++."""
    identifiers: set[str] = set()
    for file in _runtime(".hpp").values():
        text = file.read_text("utf-8")
        for inside in re.findall(r"^namespace mip \{$(.*?)^\} // namespace mip$", text, re.DOTALL | re.MULTILINE):
            identifiers |= set(_declared(inside))
    return frozenset(identifiers)


def _declared(text: str) -> Iterator[str]:
    """
    >>> sorted(_declared("template <class T> struct a { int m; };\\ninline b c(int d) {\\n}\\nusing e = ::f;\\n"))
    ['a', 'c', 'e']
    >>> sorted(_declared("namespace g {\\nint h;\\n}\\ntemplate <class T> inline constexpr int i = j<T>::k;"))
    ['g', 'i']
    """
    text = re.sub(r"^ *#(?:[^\n]*\\\n)*[^\n]*", "", _COMMENTS.sub("", text), flags=re.MULTILINE)
    for inner, instead in ((r"\{[^{}]*\}", ";"), (r"\([^()]*\)", " = "), (r"<[^<>]*>", "")):
        while (shorter := re.sub(inner, instead, text)) != text:
            text = shorter
    for statement in text.split(";"):
        head = statement.partition("=")[0]
        if not re.search(r"\boperator\b", head) and (words := re.findall(r"\w+", head.partition(" : ")[0])):
            yield words[-1]


def _runtime(end: str) -> dict[str, Path]:
    """Returns the files of the runtime whose names end like this, by path."""
    every = resources.files_in(resources.root() / "runtime/c")
    return {path: file for path, file in every if path.endswith(end)}
