"""Writes generated/keys.md, the index of all keys, from the schemas; with --check, only compares it."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).parents[1]
SCHEMAS = ROOT / "spec/schema"
PAGE = ROOT / "generated/keys.md"
LONGEST = 60

HEAD = """\
# Index of keys

All keys of the files of a specification: what each means, and an example from this specification. The
[README](../spec/README.md) explains them by subject. `make keys` writes this page from the schemas, and `make check`
compares it.
"""

#: Kind of schema -> the files that it describes.
FILES = {
    "common": ("sets/*.yaml", "types/*.yaml", "evidence/*.yaml"),
    "set": ("sets/*.yaml",),
    "types": ("types/*.yaml",),
    "protocol": ("protocol.yaml",),
    "evidence": ("evidence/*.yaml",),
    "packets": ("packets/*.yaml",),
    "searches": ("searches/*.yaml",),
    "devices": ("devices/*.yaml",),
    "device": ("devices/*.yaml",),
    "device_extension": ("devices/*.yaml",),
    "examples": ("examples/*.yaml",),
    "errata": ("errata/*.yaml",),
    "guide": ("guides/*.yaml",),
    "manual": ("manuals/*.yaml",),
    "manuals": ("manuals/*.yaml",),
    "simulation": ("simulation/*.yaml",),
    "witness": ("witness/[!adr]*.yaml",),
    "device_facts": ("witness/devices.yaml",),
    "accepted": ("witness/accepted.yaml",),
    "rules": ("witness/rules.yaml",),
}


def page() -> str:
    schemas = {path.name.removesuffix(".schema.json"): json.loads(path.read_text("utf-8")) for path in _sorted()}
    examples = _examples(schemas)
    parts = [HEAD]
    for kind, schema in schemas.items():
        rows: dict[tuple[str, str], list[str]] = {}
        for key, where, text in _keys(schema, schemas, kind):
            places = rows.setdefault((key, text), [])
            places += [where] * (where not in places)
        title = f"\n## {kind}\n\n{schema['title']}" + (f": {files}" if (files := _files(kind)) else "") + ".\n"
        parts += [title, *_shared(schema), "| key | of | meaning | example |", "|---|---|---|---|"]
        for (key, text), places in sorted(rows.items(), key=lambda row: (row[0][0], row[1])):
            uses = [examples[kind, where, key] for where in places if (kind, where, key) in examples]
            example = f"`{uses[0]}`".replace("|", "\\|") if uses else ""
            parts.append(f"| `{key}` | {', '.join(places)} | {text} | {example} |")
    return "\n".join(parts) + "\n"


def _sorted() -> list[Path]:
    """The schemas of what one writes first come first."""
    order = list(FILES)
    paths = SCHEMAS.glob("*.json")
    return sorted(paths, key=lambda p: (order.index(k) if (k := p.name.partition(".")[0]) in order else 99, p.name))


def _files(kind: str) -> str:
    return ", ".join(f"`{pattern}`" for pattern in FILES.get(kind, ()))


def _keys(node: Any, schemas: dict[str, Any], home: str, where: str = "the file") -> Iterator[tuple[str, str, str]]:
    """Yields the keys below a part of a schema: each with what it is a key of, and its meaning."""
    if isinstance(node, list):
        for item in node:
            yield from _keys(item, schemas, home, where)
    elif isinstance(node, dict):
        properties = node.get("properties", {})
        for key, value in properties.items():
            if _elsewhere(value):
                continue
            meaning = value.get("description") or _referenced(value, schemas, home).get("description", "")
            yield key, where, meaning.replace("|", "\\|")
        for key, value in properties.items():
            yield from _keys(value, schemas, home, key)
        for name, part in node.items():
            if name == "definitions":
                for holder, definition in part.items():
                    yield from _keys(definition, schemas, home, holder)
            elif name != "properties":
                yield from _keys(part, schemas, home, where)


def _elsewhere(value: dict[str, Any]) -> str:
    """Returns the kind of schema that has this key, too, with the same meaning."""
    named = re.fullmatch(r"(\w+)\.schema\.json#/properties/\w+", value.get("$ref", ""))
    return named[1] if named and len(value) == 1 else ""


def _shared(schema: dict[str, Any]) -> Iterator[str]:
    """Yields a paragraph for each list of keys that another kind has, too."""
    items = {f"In `{key}`, as": entry.get("items", {}) for key, entry in schema.get("properties", {}).items()}
    for lead, part in {"As": schema, **items}.items():
        keys: dict[str, list[str]] = {}
        for key, value in part.get("properties", {}).items():
            if other := _elsewhere(value):
                keys.setdefault(other, []).append(f"`{key}`")
        yield from (f"{lead} in [{other}](#{other}): {', '.join(names)}.\n" for other, names in keys.items())


def _referenced(value: dict[str, Any], schemas: dict[str, Any], home: str) -> Any:
    return _target(value, schemas, home)[0] if "$ref" in value else {}


def _target(value: dict[str, Any], schemas: dict[str, Any], home: str) -> tuple[Any, str, str]:
    """Returns the part of a schema that a reference names, its kind, and its name."""
    file, _, pointer = value["$ref"].partition("#")
    home = file.removesuffix(".schema.json") or home
    node = schemas[home]
    for step in filter(None, pointer.split("/")):
        node = node[step]
    return node, home, pointer.rpartition("/")[2]


#: A part of a schema: its kind, the place by which the index calls it, and the part.
Part = tuple[str, str, dict[str, Any]]


def _examples(schemas: dict[str, Any]) -> dict[tuple[str, str, str], str]:
    """Returns the first short use of each key, by kind of schema and place."""
    uses: dict[tuple[str, str, str], str] = {}
    for path in sorted((ROOT / "spec").glob("**/*.yaml")):
        text = path.read_text("utf-8")
        root = yaml.compose(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))
        kind = text.partition("schema/")[2].partition(".")[0]
        _collect(root, _alternatives([(kind, "the file", schemas[kind])], schemas), text, schemas, uses)
    return uses


def _alternatives(parts: list[Part], schemas: dict[str, Any]) -> list[Part]:
    """Follows references, and replaces choices of several parts with these."""
    found = []
    for kind, where, part in parts:
        found.append((kind, where, part))
        if "$ref" in part:
            target, home, name = _target(part, schemas, kind)
            found += _alternatives([(home, name, target)], schemas)
        choices = [choice for key in ("anyOf", "oneOf", "allOf") for choice in part.get(key, ())]
        choices += [part[key] for key in ("then", "else") if isinstance(part.get(key), dict)]
        found += _alternatives([(kind, where, choice) for choice in choices], schemas)
    return found


def _collect(node: Any, parts: list[Part], text: str, schemas: dict[str, Any], uses: dict[Any, str]) -> None:
    if isinstance(node, yaml.SequenceNode):
        inner = [(kind, where, part["items"]) for kind, where, part in parts if isinstance(part.get("items"), dict)]
        for item in node.value:
            _collect(item, _alternatives(inner, schemas), text, schemas, uses)
    elif isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            source = text[value.start_mark.index : value.end_mark.index].strip()
            example = f"{key.value}: {source}"
            short = "\n" not in source and len(source) <= LONGEST and "`" not in source
            inner = []
            for kind, where, part in parts:
                if key.value in part.get("properties", {}):
                    if short and (isinstance(value, yaml.ScalarNode) or value.flow_style):
                        uses.setdefault((kind, where, key.value), example)
                    inner.append((kind, key.value, part["properties"][key.value]))
                elif isinstance(part.get("additionalProperties"), dict):
                    inner.append((kind, where, part["additionalProperties"]))
                else:
                    inner += [(kind, where, other) for other in part.get("patternProperties", {}).values()]
            _collect(value, _alternatives(inner, schemas), text, schemas, uses)


if __name__ == "__main__":
    made = page()
    if "--check" not in sys.argv:
        PAGE.write_text(made, "utf-8")
    elif not PAGE.is_file() or PAGE.read_text("utf-8") != made:
        sys.exit(f"{PAGE.relative_to(ROOT)} is not what the schemas say; run: make keys")
