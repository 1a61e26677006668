"""Reads the files of a specification and checks each against its JSON Schema."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from mipgen.base.resources import MANIFEST

from . import overlay
from .nodes import Document, Node, read
from .problems import Position, Problems
from .schemas import check_schema

#: The version of the format of a specification; another version of the schemas has another.
FORMAT = 1

#: The files of a specification: kind of schema -> glob pattern relative to its folder.
LAYOUT = {
    "protocol": "protocol.yaml",
    "manual": "manuals/*.yaml",
    "types": "types/*.yaml",
    "set": "sets/*.yaml",
    "evidence": "evidence/*.yaml",
    "packets": "packets/*.yaml",
    "searches": "searches/*.yaml",
    "device": "devices/*.yaml",
    "examples": "examples/*.yaml",
    "errata": "errata/*.yaml",
    "simulation": "simulation/*.yaml",
    "guide": "guides/*.yaml",
}

#: Facts from other sources, which are compared with the specification but are not part of it.
WITNESSES = {"witness": "witness/*.yaml"}

#: Other files in the same folder, recognized by a key: rules for kinds of quantities, facts of devices, and accepted
#: differences.
BESIDE = {"rules": "rules", "models": "device_facts", "differences": "accepted"}

#: Files that contain several devices, families or manuals: the schema of such a file by the kind of the files beside
#: it, and the keys of their lists; `named` has devices known by name only.
SEVERAL = {"device": "devices", "manual": "manuals"}
PARTS = {"device": "devices", "family": "families", "named": "named", "manual": "manuals"}

#: The files of an overlay: the same, except that additions to the protocol are in `overlay.yaml`.
OVERLAY = {"overlay": "overlay.yaml", **{kind: path for kind, path in LAYOUT.items() if kind != "protocol"}}

#: What Python puts in place of bytes in a file's name that are not UTF-8.
_SURROGATE = re.compile(r"[\ud800-\udfff]")


def load(spec: Path, overlays: Sequence[Path], problems: Problems) -> list[Document]:
    """Reads all files of a specification and its overlays; adds their mistakes to `problems`."""
    if not (spec / "protocol.yaml").is_file():
        problems.add(Position(display_path(spec), 1, 1), "this is not a specification: it has no protocol.yaml")
        return []
    documents = overlay.lay([], _documents(spec, LAYOUT, False, problems), problems)
    _strays(spec, LAYOUT, problems)
    for folder in overlays:
        more = _documents(folder, OVERLAY, True, problems)
        _strays(folder, OVERLAY, problems)
        if not more and not problems:
            files = ", ".join(OVERLAY.values())
            problems.add(Position(display_path(folder), 1, 1), f"this overlay contains none of these files: {files}")
        documents = overlay.lay(documents, more, problems)
    return documents


def _documents(folder: Path, layout: dict[str, str], over: bool, problems: Problems) -> list[Document]:
    """Reads the files of a specification or overlay folder."""
    documents = []
    for kind, pattern in layout.items():
        for path in _visible(folder.glob(pattern)):
            name = path.relative_to(folder).as_posix()
            shown = re.sub(r"[^ -~]", _printable, display_path(path))
            if not name.isprintable():
                fault = "is not UTF-8 text" if _SURROGATE.search(name) else "contains an unprintable character"
                problems.add(Position(shown, 1, 1), f"the name of this file {fault}; rename it")
                continue
            if path.exists() and not path.is_file() and not path.is_dir():  # a pipe would never end
                problems.add(Position(shown, 1, 1), "this is not a file")
                continue
            root = read(path, display_path(path), problems)
            if root is None:
                continue
            of = _schema(kind, root, over)
            if kind == "protocol" and root.scalar("format", FORMAT) != FORMAT:
                message = f"the format of this specification is unknown; this mipgen reads format {FORMAT}"
                problems.add(root["format"].position, message)
                continue
            if not check_schema(of, root, problems):
                continue
            if of in SEVERAL.values():
                parts = ((part_kind, entry) for part_kind, many in PARTS.items() for entry in root.get(many) or ())
                documents += [Document(part_kind, name, entry) for part_kind, entry in parts]
            else:
                documents.append(Document(of, name, root))
    return documents


def _printable(match: re.Match[str]) -> str:
    return match[0] if match[0].isprintable() else match[0].encode("unicode_escape").decode()


def load_witnesses(folder: Path, problems: Problems) -> list[Document]:
    """Reads the witnesses of a specification, with the rules and the accepted differences."""
    documents = _documents(folder, {kind: Path(pattern).name for kind, pattern in WITNESSES.items()}, False, problems)
    if not documents and not problems:
        problems.add(Position(display_path(folder), 1, 1), "this folder contains no witnesses, that is, no .yaml files")
    return documents


def _schema(kind: str, root: Node, over: bool) -> str:
    """Returns the kind of schema for a file; extensions, and files with several devices or manuals, have their own."""
    extension = f"{kind}_extension"
    if (over or extension in overlay.WITHIN) and "extend" in root and extension in overlay.EXTENSIONS:
        return extension
    if kind == "witness" and "layouts" not in root:
        return next((of for key, of in BESIDE.items() if key in root), BESIDE["differences"])
    return SEVERAL[kind] if kind in SEVERAL and any(many in root for many in PARTS.values()) else kind


def display_path(path: Path) -> str:
    """Returns a path as a user would write it on the command line."""
    here = Path.cwd()
    absolute = path.absolute()
    return absolute.relative_to(here).as_posix() if absolute.is_relative_to(here) else str(path)


def _visible(paths: Iterable[Path]) -> list[Path]:
    """Sorts paths, without hidden files of editors and systems, such as `.#tools.yaml`."""
    return sorted(path for path in paths if path.name[0] != ".")


def _strays(spec: Path, layout: dict[str, str], problems: Problems) -> None:
    """Reports files in the wrong folder, which would be ignored silently."""
    read = {path for pattern in (*layout.values(), *WITNESSES.values()) for path in spec.glob(pattern)}
    read_ones = ", ".join(layout.values())
    made = {path.parent for path in spec.rglob(MANIFEST)}  # output, if the specification is a whole project
    for path in _visible(spec.rglob("*.*")):
        if path.suffix.lower() not in (".yaml", ".yml") or path in read:
            continue
        if not made.isdisjoint(path.parents):
            continue
        message = f"this file is ignored; only these are read: {read_ones}"
        if path == spec / LAYOUT["protocol"]:
            message = "an overlay has overlay.yaml in its place; name the specification itself first, and once"
        problems.add(Position(display_path(path), 1, 1), message)
