"""Extracts facts from the vendor's first SDK, in C: the layouts of commands and responses that no later source
contains.

A structure in its headers is the data of a field, member by member; the inputs and outputs of a C function are a
command and its response. The comment before a C function lists the command's function selectors and the output
arguments. Anything else, such as an array with a computed length, is skipped. Only facts are extracted, in the format
of `spec/witness`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from os.path import commonprefix
from pathlib import Path
from typing import Any

from . import sdk

NAME = "sdk_2014"
LIBRARY = Path("MIPSDK/C/Library")

_SOURCE = {"name": "MIP SDK of 2014", "repository": "github.com/ros-drivers/microstrain_mips"}

#: Descriptor sets, by their names in descriptor constants: MIP_3DM_CMD_..., MIP_AHRS_DATA_...
_COMMANDS = {"3DM": 0x0C, "FILTER": 0x0D, "SYSTEM": 0x7F}
_DATA = {"AHRS": 0x80, "GPS": 0x81, "FILTER": 0x82}
_SCALARS = ("u8", "u16", "u32", "u64", "s8", "s16", "s32", "float", "double")
_LETTERS = "WRSLD"  # of functions 1 to 5

#: Units, by the ending of a member's name.
_UNITS = {"ms": "ms", "us": "us", "degc": "degC"}

_DEFINE = re.compile(r"^#define +(\w+)\s+(0x[0-9A-Fa-f]+|\d+)", re.MULTILINE)
_STRUCT = re.compile(r"((?://[^\n]*\n|#define [^\n]*\n|\s)*)typedef struct \w+\s*\{([^}]*)\}\s*(\w+);")
_MEMBER = re.compile(r"(\w+)\s+(\w[^;]*);")
_RETURNED = re.compile(r"returned in MIP_REPLY_DESC_3DM_(\w+) field")
_FUNCTION = re.compile(r"((?://[^\n]*\n|\s)*)^u16 (mip_\w+)\(([^)]*)\)\s*\{(.*?)^\}", re.MULTILINE | re.DOTALL)
_ARGUMENT = re.compile(r"(\w+)\s*(\*?)\s*(\w+)$")
_SELECTORS = re.compile(r"Possible \\c function_selector values:(.*?)(?:Possible|may be NULL|$)", re.DOTALL)


def is_working_copy(folder: Path) -> bool:
    return (folder / LIBRARY).is_dir()


def extract(folder: Path) -> dict[str, Any]:
    """Returns the facts of the SDK in a folder that contains MIPSDK."""
    headers = "\n".join(_text(path) for path in sorted((folder / LIBRARY / "Include").glob("*.h")))
    sources = "\n".join(_text(path) for path in sorted((folder / LIBRARY / "Source").glob("*.c")))
    numbers = {name: int(value, 0) for name, value in _DEFINE.findall(headers)}
    structs = {name: list(_members(body)) for _, body, name in _STRUCT.findall(headers)}
    layouts = [
        *_commands(sources, numbers, structs),
        *_statuses(headers, numbers, structs),
        *_data(numbers, structs),
    ]
    return {
        "source": _SOURCE | sdk.revision(folder),
        "partial": True,
        "units": {unit: [word] for word, unit in _UNITS.items()},
        "layouts": sorted(layouts, key=lambda x: (x["key"], x["role"], x["name"])),
        "constants": dict(_groups(headers)),
    }


def _text(path: Path) -> str:
    return path.read_text("utf-8", errors="replace").replace("\r", "")


def _members(body: str) -> Iterator[dict[str, Any]]:
    """Yields the members of a structure. Commas separate names, brackets contain array sizes."""
    for scalar, names in _MEMBER.findall(re.sub(r"//[^\n]*", "", body)):
        for name in names.split(","):
            sizes = [int(n) for n in re.findall(r"\[(\d+)\]", name)]
            yield _parameter(name.partition("[")[0].strip(), scalar) | _counted(sizes)


def _parameter(name: str, scalar: str) -> dict[str, Any]:
    end = name.rpartition("_")[2]
    return {"label": name, "type": scalar, **({"unit": end} if end in _UNITS else {})}


def _counted(sizes: list[int]) -> dict[str, Any]:
    count = 1
    for size in sizes:
        count *= size
    return {"count": count} if sizes else {}


def _key(set_number: int, descriptor: int) -> str:
    return f"0x{set_number:02X},0x{descriptor:02X}"


def _known(parameters: list[dict[str, Any]]) -> bool:
    return all(p["type"] in _SCALARS for p in parameters)


def _commands(text: str, numbers: dict[str, int], structs: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for about, name, arguments, body in _FUNCTION.findall(text):
        sent = re.search(r"\bMIP_(3DM|FILTER|SYSTEM)_CMD_\w+", body)
        parts = _parts(about, arguments, structs)
        if sent is None or sent[0] not in numbers or parts is None:
            continue
        given, returned = parts
        of = _COMMANDS[sent[1]]
        functions = _functions(about) if "function_selector" in arguments else ""
        layout = {"key": _key(of, numbers[sent[0]]), "role": "command", "name": name}
        yield layout | ({"functions": functions} if functions else {}) | {"parameters": given}
        answer = re.search(rf"\bMIP_{sent[1]}_REPLY_\w+", body)
        if returned is not None and answer and answer[0] in numbers:
            yield {"key": _key(of, numbers[answer[0]]), "role": "response", "name": name, "parameters": returned}


def _parts(about: str, arguments: str, structs: dict[str, Any]) -> tuple[list[Any], list[Any] | None] | None:
    """Returns the values that a function sends, and the values that it returns, which are None if they differ between
    devices. The whole result is None if only the code shows the number of values."""
    given: list[dict[str, Any]] = []
    returned: list[dict[str, Any]] = []
    if re.search(r"u8 ?\* ?raw_data, u16 num_bytes$", arguments):
        return [_parameter("raw_data", "u8") | {"count": "rest"}], []
    settings = "function_selector" in arguments
    for argument in arguments.split(",")[1:]:
        part = _ARGUMENT.match(argument.strip())
        scalar, pointer, word = part.groups() if part else ("", "", "")
        if word.startswith("response_"):
            return given, None
        several = word.startswith("num_") or (pointer and scalar in ("float", "double"))
        parameters = structs.get(scalar) or [_parameter(word, scalar)]
        if word == "function_selector":
            continue
        if several or not _known(parameters):
            return None
        directions = _directions(about, word)
        given += parameters if "in" in directions else []
        returned += parameters if "out" in directions or settings else []
    return given, returned


def _directions(about: str, word: str) -> str:
    match = re.search(rf"@param \[([a-z,]+)\][^\n]*\b{word}\b", about)
    return match[1] if match else "in"


def _functions(about: str) -> str:
    listed = _SELECTORS.search(about)
    numbers = {int(n, 16) for n in re.findall(r"\\li 0x(0[1-5]) -", listed[1])} if listed else set[int]()
    return "".join(letter for number, letter in enumerate(_LETTERS, 1) if number in numbers)


def _statuses(headers: str, numbers: dict[str, int], structs: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yields the structures that are the data of a response, according to the comments before them."""
    for about, _, name in _STRUCT.findall(headers):
        returned = _RETURNED.search(about)
        if returned and _known(structs[name]):
            key = _key(_COMMANDS["3DM"], numbers[f"MIP_3DM_REPLY_{returned[1]}"])
            yield {"key": key, "role": "response", "name": name, "parameters": structs[name]}


def _data(numbers: dict[str, int], structs: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yields the structures whose names consist of the same words as a data descriptor, in any order."""
    words = {_words(name): name for name in structs}
    for define, number in numbers.items():
        of, _, word = define.removeprefix("MIP_").partition("_DATA_")
        name = words.get(_words(f"mip_{of}_{word}")) if of in _DATA else None
        if name and _known(structs[name]):
            yield {"key": _key(_DATA[of], number), "role": "data", "name": name, "parameters": structs[name]}


def _groups(headers: str) -> Iterator[tuple[str, dict[str, int]]]:
    """Yields the values of each enumeration: consecutive constants whose names have a common prefix."""
    for block in re.split(r"\n(?:\s*\n)+|\n//[^\n]*", headers):
        numbers = {name: int(value, 0) for name, value in _DEFINE.findall(block)}
        # The longest common prefix, up to its last underscore; compared by character, because names are not paths.
        common = commonprefix(list(numbers)).rpartition("_")[0]  # noqa: RUF071
        if len(numbers) > 1 and re.fullmatch(r"MIP_(3DM|FILTER)_(?!CMD|REPLY|DATA).+", common):
            yield common, {name.removeprefix(common)[1:]: value for name, value in numbers.items()}


def _words(name: str) -> tuple[str, ...]:
    plain = name.lower().replace("time_stamp", "timestamp").replace("1pps", "pps").replace("temperature", "temp")
    return tuple(sorted(plain.split("_")))
