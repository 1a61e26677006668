"""What the types of `displacement` mean."""

from __future__ import annotations

from ..info import Info

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
}
