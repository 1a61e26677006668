"""Overlays: folders that add sets, fields, types and devices to a specification without changing its files.

An overlay has the subfolders of a specification. A set file or a device file that begins with `extend: NAME` adds
to an existing set or device; `overlay.yaml` adds units and frames.
"""

from __future__ import annotations

from dataclasses import replace

from .documents import Document
from .nodes import Node
from .problems import Problems, nearest

#: Kind of an extension -> kind of what it extends, the key that names that, and what may be added to it.
EXTENSIONS = {
    "set_extension": ("set", "name", ("types", "parts", "fields", "named")),
    "device_extension": (
        "device",
        "device",
        ("also", "sources", "supports", "evidence", "functions", "deprecated", "firmware", "base_rates", "ports",
         "limits", "notes", "varies", "incomplete", "uncertain"),
    ),
}  # fmt: skip


def lay(documents: list[Document], over: list[Document], problems: Problems) -> list[Document]:
    """The documents of a specification with those of one overlay."""
    found = list(documents)
    for document in over:
        if document.kind == "overlay":
            found = [_with_words(d, document.root, problems) if d.kind == "protocol" else d for d in found]
        elif document.kind not in EXTENSIONS:
            found.append(document)
    for document in over:  # after everything new: an overlay may extend its own sets
        if document.kind in EXTENSIONS:
            found = _extended(found, document, problems)
    return found


def _with_words(protocol: Document, overlay: Node, problems: Problems) -> Document:
    """The protocol with more units and frames."""
    value = dict(protocol.root.value)
    for key, more in overlay.items():
        value[key] = _joined(value[key], more, problems)
    return replace(protocol, root=replace(protocol.root, value=value))


def _extended(documents: list[Document], extension: Document, problems: Problems) -> list[Document]:
    kind, key, parts = EXTENSIONS[extension.kind]
    name = extension.root["extend"]
    known = [d.root[key].value for d in documents if d.kind == kind]
    if name.value not in known:
        problems.add(name.position, f"no {kind} '{name.value}' to extend{nearest(name.value, known)}")
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
            value[part] = _joined(value[part], extension[part], problems) if part in value else extension[part]
    return replace(root, value=value, keys=keys)


def _joined(base: Node, more: Node, problems: Problems) -> Node:
    """Lists one after the other; mappings with the keys of both, and lists below one key joined."""
    if isinstance(base.value, list):
        return replace(base, value=[*base.value, *more.value])
    value, keys = dict(base.value), dict(base.keys)
    for key, node in more.items():
        if key not in value:
            value[key], keys[key] = node, more.keys[key]
        elif isinstance(node.value, list) and isinstance(value[key].value, list):
            value[key] = _joined(value[key], node, problems)
        else:
            problems.add(more.keys[key], f"'{key}' is already given at {value[key].position}; an overlay can only add")
    return replace(base, value=value, keys=keys)
