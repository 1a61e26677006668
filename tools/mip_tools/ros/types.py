"""Finds the types of messages, and encodes messages, with the package rosbags."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from ..binding import Described, Field, MissingExtra, Structure, info
from ..columns.column import Column
from ..errors import Failure
from . import cdr

PACKAGE = "mip_msgs"


class Types:
    """The message types of a ROS 2 release and, from a folder, those of mip_msgs."""

    def __init__(self, messages: Path | None = None) -> None:
        try:
            typesys: Any = import_module("rosbags.typesys")
        except ImportError:
            raise Failure(f"{MissingExtra('rosbags', 'ros')}; MCAP with JSON needs only mcap") from None
        self.store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
        self._of_field: dict[str, str] = {}
        folder = messages or installed()
        if folder is not None:
            self._add(folder / "msg" if (folder / "msg").is_dir() else folder, typesys.get_types_from_msg)
        self._layout = cache(self._layout_of)

    def _add(self, folder: Path, parse: Any) -> None:
        files = sorted(folder.glob("*.msg"))
        if not files:
            raise Failure(f"{folder} has no .msg files; name the folder of {PACKAGE} that mipgen generates")
        types: dict[str, Any] = {}
        for path in files:
            text = path.read_text("utf-8")
            name = f"{PACKAGE}/msg/{path.stem}"
            types |= parse(text, name)
            first = text.partition("\n")[0]
            self._of_field[first.lstrip("# ").partition(":")[0]] = name  # as the generator writes it
        self.store.register(types)

    def of_kind(self, kind: type[Field]) -> str | None:
        """Returns the type of a field's messages; None if there is none."""
        return self._of_field.get(kind.NAME)

    def rows(self, name: str, count: int, values: Mapping[str, Any], texts: Mapping[str, str]) -> list[bytes]:
        """Encodes messages of a type whose length depends only on texts. Values that are left out are zero or empty.

        `values`: path, such as `pose.pose.position.x` -> the values of all messages; `texts` are the same in each.
        """
        layout = self._layout(name, tuple(texts.items()))
        assert layout is not None
        return layout.messages(count, values)

    def of_column(self, name: str, column: Column[Any], frame: str) -> list[bytes] | None:
        """Encodes the messages of all rows of a column, without their times; None if their lengths vary."""
        texts = (("header.frame_id", frame),)
        layout = self._layout(name, texts)
        paths = [] if layout is None else layout.numbers()[2:]  # without the two numbers of the time
        if layout is None or len(paths) != len(column.names):
            return None
        return layout.messages(len(column), {path: column[own] for path, own in zip(paths, column)})

    def _layout_of(self, name: str, texts: tuple[tuple[str, str], ...]) -> cdr.Layout | None:
        return cdr.cdr_layout(self.store.fielddefs, name, dict(texts))

    def of_field(self, name: str, field: Field, frame: str) -> bytes:
        """Encodes the message of a field, without its time."""
        values = {"header": {"frame_id": frame}, **self._content(field, name)}
        return bytes(self.store.serialize_cdr(self._build(name, values), name, little_endian=True))

    def _build(self, name: str, values: dict[str, Any]) -> Any:
        """Makes a message with these values. Values that are left out are zero or empty."""
        made = {}
        for member, (node, detail) in self.store.fielddefs[name][1]:
            made[member] = self._value(int(node), detail, values.get(member))
        return self.store.types[name](**made)

    def _value(self, node: int, detail: Any, value: Any) -> Any:
        if node == 1:  # a number or a text
            base = detail[0]
            if base == "string":
                return value or ""
            return bool(value) if base == "bool" else value if value is not None else np.dtype(base).type(0)
        if node == 2:  # another message
            return self._build(detail, value or {})
        (inner, inside), count = detail  # an array or a sequence
        if int(inner) == 1 and inside[0] != "string":
            fixed = count if node == 3 else 0
            numbers = [0] * fixed if value is None else value
            return np.array(numbers, np.dtype("uint8" if inside[0] in ("octet", "char") else inside[0]))
        return [self._value(int(inner), inside, v) for v in value or ()]

    def _content(self, record: Described, name: str) -> dict[str, Any]:
        """Returns the values of a field for `_build`, in the order of the members of its message."""
        items: list[Any] = []
        for p in info(type(record)).members:
            value = getattr(record, p.attribute)
            if p.cases:
                alternatives = [c for c in p.cases.values() if c is not None]
                items += [[value] if value is not None and _is(record, p, c) else [] for c in alternatives]
            else:
                items.append(value)
        members = [m for m in self.store.fielddefs[name][1] if m[0] != "header"]
        return {m[0]: self._plain(v, m[1]) for m, v in zip(members, items)}

    def _plain(self, value: Any, kind: Any) -> Any:
        node, detail = int(kind[0]), kind[1]
        if node == 2 and isinstance(value, Structure):
            return self._content(value, detail)
        if node > 2:
            items = [] if value is None else list(value) if isinstance(value, (list, tuple, bytes)) else [value]
            if items and isinstance(items[0], Structure):
                return [self._plain(v, detail[0]) for v in items]
            return [w for v in items for w in (v if isinstance(v, (list, tuple)) else (v,))]
        if isinstance(value, str):
            return value.rstrip("\0")
        return value


def _is(record: Described, p: Any, case: Any) -> bool:
    """Is this the alternative of a union that its tag selects?"""
    return p.cases.get(int(getattr(record, p.tag))) is case


def installed() -> Path | None:
    """Finds the folder of mip_msgs in a sourced ROS 2 workspace."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        folder = Path(prefix, "share", PACKAGE)
        if prefix and folder.is_dir():
            return folder
    return None
