"""The places of sets and field descriptors in the commands that list data, and commands that replace others."""

from __future__ import annotations

#: Set and descriptor of a command -> its lists; see `rejected.Listing`.
LISTS: dict[tuple[int, int], tuple[tuple[int, ...], ...]] = {
    (0x0C, 0x01): ((128, 0, 1, 2, 3, -1, -1, -1, 0),),
    (0x0C, 0x02): ((129, 0, 1, 2, 3, 83, -1, -1, 0),),
    (0x0C, 0x03): ((130, 0, 1, 2, 3, -1, -1, -1, 0),),
    (0x0C, 0x08): ((128, 0, 1, 2, 3, -1, 1, -1, 0),),
    (0x0C, 0x09): ((129, 0, 1, 2, 3, 82, 1, -1, 0),),
    (0x0C, 0x0A): ((130, 0, 1, 2, 3, -1, 1, -1, 0),),
    (0x0C, 0x0D): ((-1, 0, 2, 3, 1, -1, -1, -1, 0),),
    (0x0C, 0x0E): ((-1, 0, -1, -1, 1, -1, -1, -1, 0),),
    (0x0C, 0x0F): ((-1, 1, 2, 3, 3, -1, 1, -1, 0),),
    (0x0C, 0x11): ((-1, 1, -1, -1, 1, -1, -1, -1, 0),),
    (0x0C, 0x2E): ((-1, 3, -1, 4, 1, -1, -1, 2, 2),),
    (0x0C, 0x2F): ((-1, 4, 7, 8, 1, 12, -1, 3, 2),),
    (0x0C, 0x50): ((128, 0, -1, 1, 1, -1, -1, -1, 0),),
    (0x0C, 0x54): ((-1, 1, -1, 2, 1, -1, -1, -1, 0),),
}

#: Set and descriptor of a command -> those of the commands that do the same on devices that lack it.
ALTERNATIVES: dict[tuple[int, int], tuple[tuple[int, int], ...]] = {
    (0x01, 0x09): ((0x0C, 0x40),),
    (0x0C, 0x40): ((0x01, 0x09),),
}
