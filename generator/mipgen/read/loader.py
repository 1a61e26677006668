"""Reads the files of a specification and checks each against its JSON Schema."""

from __future__ import annotations

import functools
import pickle
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from mipgen.base import cache, fingerprint
from mipgen.base.resources import MANIFEST

from . import overlay, schemas
from .nodes import Document, Node, read
from .position import Position
from .problems import Problems, close, nearest
from .spelling import strange

#: Words that other YAML parsers read as true and false.
BOOLEANS = {**dict.fromkeys(("true", "yes", "on", "y"), "true"), **dict.fromkeys(("false", "no", "off", "n"), "false")}

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
    """Reads the files of a specification or overlay folder. Files that were valid before come from the cache."""
    documents, valid = [], {}
    for kind, pattern in layout.items():
        for path in _visible(folder.glob(pattern)):
            name = path.relative_to(folder).as_posix()
            content_key = _key(path, kind, over)
            data = cache.get("nodes", content_key) if content_key else None
            if data is not None:
                of, root = pickle.loads(data)
            else:
                root = read(path, display_path(path), problems)
                if root is None:
                    continue
                of = _schema(kind, root, over)
                if kind == "protocol" and root.scalar("format", FORMAT) != FORMAT:
                    message = f"the format of this specification is unknown; this mipgen reads format {FORMAT}"
                    problems.add(root["format"].position, message)
                    continue
                before = len(problems)
                if not _valid(of, root, problems):
                    continue
                if content_key and len(problems) == before:
                    valid[content_key] = pickle.dumps((of, root), 5)
            if of in SEVERAL.values():
                parts = ((part_kind, entry) for part_kind, many in PARTS.items() for entry in root.get(many) or ())
                documents += [Document(part_kind, name, entry) for part_kind, entry in parts]
            else:
                documents.append(Document(of, name, root))
    cache.put("nodes", valid)
    return documents


def load_witnesses(folder: Path, problems: Problems) -> list[Document]:
    """Reads the witnesses of a specification, with the rules and the accepted differences."""
    documents = _documents(folder, {kind: Path(pattern).name for kind, pattern in WITNESSES.items()}, False, problems)
    if not documents and not problems:
        problems.add(Position(display_path(folder), 1, 1), "this folder contains no witnesses, that is, no .yaml files")
    return documents


def _key(path: Path, kind: str, over: bool) -> str:
    """Returns the cache key for the nodes of a file, whose positions contain the path as shown. Empty if unreadable."""
    try:
        return cache.key(fingerprint.program(), kind, str(over), display_path(path), path.read_bytes())
    except OSError:
        return ""


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
        problems.add(Position(display_path(path), 1, 1), f"this file is ignored; only these are read: {read_ones}")


def _matches(_: Any, pattern: str, value: Any, schema: Any) -> Iterator[Any]:
    import jsonschema

    if isinstance(value, str) and not schemas.pattern(pattern).search(value):
        yield jsonschema.ValidationError(f"{value!r} does not match {pattern!r}")


@functools.cache
def _validators() -> dict[str, Any]:
    """Builds a validator for each kind of file, which names all mistakes. Their library is slow to import."""
    import jsonschema
    import referencing
    from referencing.jsonschema import DRAFT7

    types = jsonschema.Draft7Validator.TYPE_CHECKER.redefine("integer", lambda _, value: schemas.is_integer(value))
    extend: Any = jsonschema.validators.extend
    validator = extend(jsonschema.Draft7Validator, {"pattern": _matches}, type_checker=types)
    # With "$schema", the library would use its own validator for references instead of this one.
    files = {
        name: {key: rule for key, rule in schema.items() if key != "$schema"}
        for name, schema in schemas.schema_files().items()
    }
    registry: referencing.Registry[Any] = referencing.Registry().with_resources(
        (schema["$id"], DRAFT7.create_resource(schema)) for schema in files.values()
    )
    return {name.removesuffix(schemas.SUFFIX): validator(schema, registry=registry) for name, schema in files.items()}


# --------------------------------------------------------------------------- schema errors in words


def _valid(kind: str, root: Node, problems: Problems) -> bool:
    """Validates a file against its schema, and adds its mistakes to `problems`; True if there are none."""
    if schemas.fits_schema(kind, root):
        return True
    errors = list(_validators()[kind].iter_errors(root.plain()))
    for error in errors:
        path = list(error.absolute_path)
        for extra, message in error_messages(error, "the file"):
            problems.add(root.at([*path, *extra]) if extra else root.value_at(path), message)
    return not errors


_ALONE = "; write only the number if the name needs no description"


def error_messages(error: Any, root: str) -> Iterator[tuple[list[str | int], str]]:
    """Words a schema error and its remedy; each message has the path of the key in question, if there is one."""
    instance, schema, rule = error.instance, error.schema, error.validator_value
    inside = _inside(list(error.absolute_path), root)
    if "propertyNames" in error.absolute_schema_path:
        yield [instance], f"the name '{instance}' must be {_form(schema) or rule}{strange(instance)}"
    elif error.validator == "additionalProperties":
        properties = schema.get("properties", {})
        for key in sorted(set(instance) - set(properties)):
            rest = "; if it ends the text before it, put the whole text in quotes"
            yield [key], f"unknown key '{key}'{rest if instance[key] is None else nearest(key, properties)}"
    elif error.validator == "required":
        for key in rule:
            if key not in instance:
                alone = _ALONE if key == "description" and "integer" in schema.get("type", ()) else ""
                yield [], f"'{key}' is missing in {inside}{alone}"
    else:
        yield [], f"{inside}{_fault_of_value(error)}"


#: The bounds of a number.
_BOUNDS = {"minimum": "at least", "exclusiveMinimum": "more than", "maximum": "at most"}


def _fault_of_value(error: Any) -> str:
    """Words the fault of a value; the text continues the name of its key."""
    instance, schema, rule = error.instance, error.schema, error.validator_value
    match error.validator:
        case "type":
            kinds = [rule] if isinstance(rule, str) else rule
            wanted = _form(schema) or _kinds(kinds)
            return f" must be {wanted}, not {_shown(instance)}{_instead(instance, kinds)}"
        case "enum":
            choices = [str(x) for x in rule]
            return f" must be {' or '.join(choices)}, not {_shown(instance)}{close(str(instance), choices)}"
        case "const":
            return f" must be {_shown(rule)}, or be omitted, not {_shown(instance)}"
        case "pattern":
            return f" must be {_form(schema) or rule}, not {_shown(instance)}{strange(instance)}"
        case "minimum" | "exclusiveMinimum" | "maximum":
            return f" must be {_BOUNDS[error.validator]} {rule}, not {_shown(instance)}"
        case "minItems" | "minProperties" | "minLength":
            return " must not be empty" if rule == 1 else f" must have at least {rule} items"
        case "maxItems" | "maxProperties":
            return f" must have at most {rule} item{'s' if rule != 1 else ''}"
        case _:
            return f": {error.message}"


def _inside(path: list[str | int], root: str) -> str:
    """Returns the subject of an error: a key, or an item of a list."""
    key = next((f"'{p}'" for p in reversed(path) if isinstance(p, str)), root)
    return f"item {path[-1] + 1} of {key}" if path and isinstance(path[-1], int) else key


def _instead(value: Any, kinds: list[str]) -> str:
    """Returns the remedy for a value of the wrong kind, if it is obvious.

    >>> _instead("yes", ["boolean"]), _instead(7, ["string"]), _instead("8C", ["integer"]), _instead("−3", ["integer"])
    ('; write true', '; put it in quotes', '; write 0x8C', "; '−' is a minus sign (U+2212), write '-'")
    >>> _instead({}, ["array"]), _instead([], ["object"]), _instead("fast", ["integer"])
    ("; begin each item with '- '", "; write 'key: value', without '- '", '')
    """
    match value:
        case bool() | int() | float() if "string" in kinds:
            return "; put it in quotes"
        case dict() if "array" in kinds:
            return "; begin each item with '- '"
        case list() if "object" in kinds:
            return "; write 'key: value', without '- '"
        case str() if "boolean" in kinds and value.casefold() in BOOLEANS:
            return f"; write {BOOLEANS[value.casefold()]}"
        case str() if {"integer", "number"}.intersection(kinds):
            return f"; write 0x{value}" if re.fullmatch("[0-9A-Fa-f]{2}", value) else strange(value)
        case _:
            return ""


def _form(schema: Any) -> str | None:
    """Returns the form of a value: the description of its definition. A description that ends with a full stop belongs
    to a property, and states its purpose instead."""
    words = str(schema.get("description", "."))
    return None if words.endswith(".") else words


def _kinds(kinds: list[str]) -> str:
    words = {
        "object": "a mapping",
        "array": "a list",
        "string": "text",
        "integer": "a whole number",
        "number": "a number",
        "boolean": "true or false",
        "null": "empty",
    }
    return " or ".join(words[k] for k in kinds)


def _shown(value: Any) -> str:
    match value:
        case None:
            return "nothing"
        case bool():
            return str(value).lower()
        case dict():
            return "a mapping"
        case list():
            return "a list"
        case str() if len(value) > 60:
            return repr(value[:60] + "…")
        case _:
            return repr(value)
