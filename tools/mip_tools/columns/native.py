"""The innermost loops in compiled code, which platform wheels contain, and which
`python setup.py build_ext --inplace` compiles in a source tree.

They return the same results as `scan` and `walk`, which are used if they are missing.
"""

from __future__ import annotations

import ctypes
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np

Array: TypeAlias = "np.ndarray[Any, Any]"

_KINDS = 1024  # as in kernel.c
_SMALLEST = 6  # bytes of a packet
_SHORTEST = 2  # bytes of a field


class Fields(NamedTuple):
    """Fields of one set, descriptor and length."""

    set: int
    descriptor: int
    length: int  # of the data
    packet: Array  # numbers of the packets in the piece
    offset: Array  # of the data in the payload


class Kernel:
    """The functions of the compiled code. All of them release the interpreter lock."""

    def __init__(self, path: Path) -> None:
        """Loads the library. Raises OSError if this fails, AttributeError if it is another library."""
        loaded = ctypes.CDLL(str(path))
        place, number = ctypes.c_void_p, ctypes.c_int64

        def function(name: str, result: Any, *arguments: Any) -> Any:
            call = getattr(loaded, name)
            call.restype, call.argtypes = result, arguments
            return call

        self._packets = function("mip_packets", number, place, number, number, number, number, place, place)
        self._fields = function("mip_fields", number, place, place, number, number, *[place] * 5)
        self._sort = function("mip_sort", None, place, place, place, number, place, place, place)
        self._gather = function("mip_gather", None, *[place] * 4, number, number, number, place)

    def packets(self, data: Array, first: int, limit: int, length: int, overlap: bool) -> tuple[Array, Array]:
        """Returns the beginnings and ends of packets that begin in `first` … `limit`; with `overlap`, of everything
        that looks like one."""
        most = max(0, limit - first) // (2 if overlap else _SMALLEST) + 1
        at, end = np.empty(most, np.int32), np.empty(most, np.int32)
        count = self._packets(_at(data), first, limit, length, overlap, _at(at), _at(end))
        return at[:count].copy(), end[:count].copy()

    def fields(self, data: Array, at: Array) -> list[Fields] | None:
        """Finds the fields of packets; None if there are too many different ones."""
        keys, counts = np.empty(_KINDS, np.uint32), np.empty(_KINDS, np.int64)
        room = len(data) // _SHORTEST
        in_log: list[Array] = [np.empty(room, np.uint16), np.empty(room, np.int32), np.empty(room, np.uint8)]
        places = [_at(array) for array in in_log]
        kinds = self._fields(_at(data), _at(at), len(at), room, _at(keys), _at(counts), *places)
        if kinds < 0:
            return None
        ends = np.cumsum(counts[:kinds])
        begins = ends - counts[:kinds]
        bounds = zip(keys[:kinds].tolist(), begins.tolist(), ends.tolist())
        total = int(counts[:kinds].sum())
        packet, offset = np.empty(total, np.int32), np.empty(total, np.uint8)
        self._sort(*places, total, _at(begins), _at(packet), _at(offset))
        return [Fields(key >> 16, key >> 8 & 255, (key & 255) - 2, packet[a:b], offset[a:b]) for key, a, b in bounds]

    def gather(self, data: Array, at: Array, packet: Array, offset: Array, item: int, rows: Array) -> None:
        """Copies the bytes of each field to a row, and reverses the bytes of each item of `item` bytes."""
        packet = packet.astype(np.int32, copy=False)
        places = (_at(data), _at(at), _at(packet), _at(offset))
        self._gather(*places, len(rows), rows.shape[1], item, _at(rows))


def _at(array: Array) -> int:
    """Returns the address of an array."""
    return int(array.ctypes.data)


def load_kernel(folder: Path = Path(__file__).parent) -> Kernel | None:
    """Loads the compiled code, if it exists and was built for this machine."""
    for suffix in EXTENSION_SUFFIXES:
        path = folder / f"_kernel{suffix}"
        try:
            if path.exists():
                return Kernel(path)
        except (OSError, AttributeError):
            continue
    return None


#: None: NumPy does everything.
kernel: Kernel | None = load_kernel()


def compiled() -> bool:
    """Is compiled code in use for the innermost loops? Platform wheels of mip-tools have it, the pure one does not."""
    return kernel is not None
