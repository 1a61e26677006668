"""Overlays: folders that add sets, fields, types and devices to a specification without changing its files.

An overlay has the same subfolders as a specification. A set or device file that begins with `extend: NAME` adds
to an existing set or device; `overlay.yaml` adds units and frames. A device file that extends another may also belong
to the specification itself.
"""

from __future__ import annotations

from dataclasses import replace

from .nodes import Document, Node
from .problems import Problems, nearest

#: Kind of extension -> the kind that it extends, the key with the name of the extended thing, and the keys it may add.
EXTENSIONS = {
    "set_extension": ("set", "name", ("types", "parts", "fields", "named")),
    "device_extension": (
        "device",
        "device",
        ("also", "sources", "supports", "evidence", "functions", "deprecated", "firmware", "base_rates", "ports",
         "limits", "notes", "varies", "incomplete", "uncertain"),
    ),
}  # fmt: skip

#: Extensions that a specification itself may contain: the data that a device reports is a separate file.
WITHIN = ("device_extension",)


def lay(documents: list[Document], over: list[Document], problems: Problems) -> list[Document]:
    """Combines the documents of a specification with those of one overlay."""
    laid = list(documents)
    for document in over:
        if document.kind == "overlay":
            laid = [_with_words(d, document.root, problems) if d.kind == "protocol" else d for d in laid]
        elif document.kind not in EXTENSIONS:
            laid.append(document)
    for document in over:  # last, since an overlay may extend its own sets
        if document.kind in EXTENSIONS:
            laid = _extended(laid, document, problems)
    return laid


def _with_words(protocol: Document, overlay: Node, problems: Problems) -> Document:
    """Adds units and frames to the protocol."""
    value = dict(protocol.root.value)
    for key, more in overlay.items():
        value[key] = _joined(value[key], more, problems)
    return replace(protocol, root=replace(protocol.root, value=value))


def _extended(documents: list[Document], extension: Document, problems: Problems) -> list[Document]:
    kind, key, parts = EXTENSIONS[extension.kind]
    name = extension.root["extend"]
    names = [d.root[key].value for d in documents if d.kind == kind]
    if name.value not in names:
        problems.add(name.position, f"no {kind} '{name.value}' to extend{nearest(name.value, names)}")
        return documents
    return [
        replace(d, root=_with_parts(d.root, extension.root, parts, problems))
        if d.kind == kind and d.root[key].value == name.value
        else d
        for d in documents
    ]


def _with_parts(root: Node, extension: Node, parts: tuple[str, ...], problems: Problems) -> Node:
    value, keys = dict(root.value), dict(root.keys)
    for part in parts:
        if part in extension:
            keys.setdefault(part, extension.keys[part])
            join = AGAIN.get(part, _joined)
            value[part] = join(value[part], extension[part], problems) if part in value else extension[part]
    return replace(root, value=value, keys=keys)


def _joined(base: Node, more: Node, problems: Problems) -> Node:
    """Joins two nodes: concatenates lists, and merges mappings, whose lists with the same key are concatenated."""
    if isinstance(base.value, list):
        return replace(base, value=[*base.value, *more.value])
    value, keys = dict(base.value), dict(base.keys)
    for key, node in more.items():
        if key not in value:
            value[key], keys[key] = node, more.keys[key]
        elif isinstance(node.value, list) and isinstance(value[key].value, list):
            value[key] = _joined(value[key], node, problems)
        else:
            place = value[key].position
            problems.add(more.keys[key], f"'{key}' is already given at {place}; an extension can only add")
    return replace(base, value=value, keys=keys)


def _joined_rates(base: Node, more: Node, problems: Problems) -> Node:
    """Joins base rates. A rate may be repeated, and an unknown one (`~`) changes nothing."""
    new = {key: node for key, node in more.items() if key not in base or node.value not in (None, base[key].value)}
    kept = {key: node for key, node in base.items() if key not in new or node.value is not None}
    return _joined(replace(base, value=kept), replace(more, value=new), problems)


def _joined_ports(base: Node, more: Node, problems: Problems) -> Node:
    """Joins ports. A port may be repeated."""
    by_name = {port["name"].value: port for port in base}
    new = []
    for port in more:
        earlier = by_name.get(port["name"].value)
        if earlier is None:
            new.append(port)
        elif earlier.plain() != port.plain():
            name = port["name"].value
            problems.add(
                port.position, f"the port '{name}' differs from its definition at {earlier.position}; make them equal"
            )
    return replace(base, value=[*base.value, *new])


#: Keys that may repeat existing entries, because a device reports everything it knows.
AGAIN = {"base_rates": _joined_rates, "ports": _joined_ports}
