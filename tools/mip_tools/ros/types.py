"""Encodes standard messages with the types of the package rosbags."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Any

from ..binding import MissingExtra
from ..errors import Failure
from . import cdr


class Types:
    """The message types of a ROS 2 release."""

    def __init__(self) -> None:
        try:
            typesys: Any = import_module("rosbags.typesys")
        except ImportError:
            raise Failure(f"{MissingExtra('rosbags', 'ros')}; MCAP with JSON needs only mcap") from None
        self.store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
        self._layout = cache(self._layout_of)

    def rows(self, name: str, count: int, values: Mapping[str, Any], texts: Mapping[str, str]) -> list[bytes]:
        """Encodes messages of a type whose length depends only on texts. Values that are left out are zero or empty.

        `values`: path, such as `pose.pose.position.x` -> the values of all messages; `texts` are the same in each.
        """
        layout = self._layout(name, tuple(texts.items()))
        assert layout is not None
        return layout.messages(count, values)

    def _layout_of(self, name: str, texts: tuple[tuple[str, str], ...]) -> cdr.Layout | None:
        return cdr.cdr_layout(self.store.fielddefs, name, dict(texts))
