"""Finds the files of an earlier run that are still up to date, because nothing that was read to make them has changed.

While something is made, `base.reads` notes which parts of the model, and which details of its objects, are read. The
next run finds the same objects by their index in a walk over the model, as long as that part of the model has the same
shape: its content without details. Nothing is declared by hand, and a file is up to date only if its bytes have not
changed. Inside a file that is made again, a `piece` of its text is kept in the same way.
"""

from __future__ import annotations

import hashlib
import io
import pickle
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from itertools import repeat
from operator import attrgetter
from pathlib import Path
from typing import Any, TypeVar

from mipgen import model as m
from mipgen.base import cache, fingerprint, reads
from mipgen.base.reads import Read
from mipgen.model import details

from . import output
from .output import Made, Same, digest

Value = TypeVar("Value")

#: A number that encodes a part of the model, the index of an object in the walk over it, and a detail.
Address = int
_PART, _PLACE = 26, 6  # the shifts of the first two; all fit into 31 bits, which are fast to store
_WHOLE = (1 << _PART) - 1  # instead of object and detail: the shape of the part

#: Results other than files: the check of names, and the list of files. No file has such a path.
NAMES = "/names"
PLAN = "/plan"


#: Class -> detail of its objects -> number of the detail.
_NAMES = {cls: details.names(cls) for cls in details.CLASSES}
_NUMBERS = {name: i for i, name in enumerate(sorted({name for names in _NAMES.values() for name in names}))}


class _Addresses(dict[Read, Address | None]):
    """Read -> its address; None if the object is computed and not part of the model."""

    def __init__(self, slices: Slices) -> None:
        self.model = id(slices.model)
        self.places = slices.places
        self.parts = slices.parts

    def __missing__(self, read: Read) -> Address | None:
        assert not isinstance(read, reads.Earlier)
        owner, name = read
        if owner == self.model:
            address: Address | None = self.parts[name].number << _PART | _WHOLE
        else:
            place = self.places.get(owner)
            address = None if place is None else place | _NUMBERS[name]
        self[read] = address
        return address


class Part:
    """A part of the model: its shape, and its objects with details, in the order of the walk."""

    def __init__(self, number: int) -> None:
        self.number = number
        self.shape = ""
        self.objects: list[Any] = []
        self.details: list[tuple[Any, ...]] = []


def _plain(value: Any) -> Any:
    """Reduces positions to files, because no output contains line numbers; writes numbers as text, because 1 == 1.0."""
    return value.file if value.__class__ is m.Position else (repr(value),)


class Slices:
    """The results of the last run for a specification, a folder and options."""

    def __init__(self, model: m.Model, out: Path, options: str) -> None:
        self.model = model
        self.out = out
        self.key = cache.key(fingerprint.program(), str(out.absolute()), options)
        self.places: dict[int, Address] = {}  # of an object, by its identity
        self.parts: dict[str, Part] = {}
        self.addresses = _Addresses(self)
        reducers = {cls: self._reducer(cls) for cls in details.CLASSES}
        for name in (f.name for f in fields(model)):
            self.parts[name] = self.part = part = Part(len(self.parts))
            written = io.BytesIO()
            pickler = pickle.Pickler(written, 5)
            pickler.dispatch_table = reducers
            pickler.dump(getattr(model, name))
            part.shape = hashlib.sha256(written.getbuffer()).hexdigest()
        self._state = pickle.dumps({name: (part.shape, part.details) for name, part in self.parts.items()}, 5)
        self.now = digest(self._state)
        before = cache.get("slices", self.key)
        self.before = digest(before) if before is not None else b""
        #: The addresses that have changed; for a part whose shape changed, only the address of the part.
        self.changed = self._changed(pickle.loads(before)) if before is not None else set()
        self.reshaped = {a >> _PART for a in self.changed if a & _WHOLE == _WHOLE}

    def _reducer(self, cls: type) -> Callable[[Any], tuple[Any, ...]]:
        """Reduces an object to a piece of the shape. An object of an earlier part is represented by its name."""
        names, places = _NAMES[cls], self.places
        read = reads.unnoticed(cls, names)
        contents = attrgetter("__class__.__name__", *(f.name for f in fields(cls) if f.name not in names))

        def reduce(thing: Any) -> tuple[Any, ...]:
            part = self.part
            here = part.number << _PART | len(part.objects) << _PLACE
            place = places.setdefault(id(thing), here)
            if place != here and place >> _PART != part.number:
                return str, (f"{cls.__name__} {getattr(thing, 'full_name', getattr(thing, 'name', ''))}",)
            if cls is m.Parameter:
                item = thing
                while item.several:
                    item = item.item  # it has the details of its parameter
                    places[id(item)] = place
            if names:
                part.objects.append(thing)
                values = [x if x is None or x.__class__ is str else _plain(x) for x in read(thing)]
                part.details.append(tuple(values))
            return tuple, ((contents(thing),),)

        return reduce

    def _changed(self, before: dict[str, tuple[str, list[tuple[Any, ...]]]]) -> set[Address]:
        changed: set[Address] = set()
        for name, part in self.parts.items():
            shape, old = before[name]
            if shape != part.shape:
                changed.add(part.number << _PART | _WHOLE)
                continue
            for place, (was, now) in enumerate(zip(old, part.details, strict=True)):
                if was != now:
                    base = part.number << _PART | place << _PLACE
                    names = _NAMES[type(part.objects[place])]
                    changed |= {base | _NUMBERS[name] for name, a, b in zip(names, was, now, strict=True) if a != b}
        return changed

    def of(self, target: str) -> Anew:
        return Slice(self, target)

    def noted(self, read: Iterable[Read]) -> set[Address]:
        """Returns the addresses of the parts of the model that were read."""
        earlier = [r.read for r in read if isinstance(r, reads.Earlier)]
        now = set(map(self.addresses.__getitem__, (r for r in read if r.__class__ is tuple)))
        return {a for a in now if a is not None}.union(*earlier)

    def differ(self, read: Iterable[Address]) -> bool:
        """True if any of this has changed since the last run."""
        shapes = self.reshaped
        return not self.changed.isdisjoint(read) or (bool(shapes) and any(a >> _PART in shapes for a in read))

    def keep(self) -> None:
        """Stores the state for the next run, once all targets have stored theirs."""
        cache.put("slices", {self.key: self._state})


class Anew:
    """A run of one target without an earlier run."""

    def unchanged(self, what: str) -> bool:
        """True if it was made in the last run, from the same input."""
        return False

    def right(self, path: str) -> Same | None:
        """Returns a file of the last run, if it would be the same now."""
        return None

    def all_right(self) -> dict[str, Made] | None:
        """Returns all files of the last run, if all would be the same now."""
        return None

    def make(self, what: str, how: Callable[..., Value], *arguments: Any) -> Value:
        """Makes something again, and notes what is read."""
        return how(*arguments)

    def keep(self, files: Mapping[str, Made]) -> None:
        """Stores the results for the next run."""


#: A text made from an object of the model, and the addresses of all that was read.
Piece = tuple[str, frozenset[Address]]


class Pieces:
    """The pieces of a file, of the last run and of this one."""

    def __init__(self, slices: Slices, data: bytes | None) -> None:
        self.slices = slices
        self.before: dict[str, Piece] = pickle.loads(data) if data is not None else {}
        self.now: dict[str, Piece] = {}

    def text(self, name: str, place: Address, make: Callable[..., str], *arguments: object) -> str:
        known = self.before.get(name)
        if known is not None and not (self.slices.differ(known[1]) or self.slices.differ((place,))):
            reads.note(known[1])
        else:
            text, read = reads.during(make, *arguments)
            known = text, frozenset(self.slices.noted(read))
        self.now[name] = known
        return known[0]


#: The pieces of the file that is being made; None inside a piece.
_pieces: Pieces | None = None


def piece(name: str, make: Callable[..., str], thing: object, *constants: str) -> str:
    """Makes a text that depends only on an object of the model, and on what is read of the model to make it. If it is
    part of a file that is made again, the text of the last run is used again unless any of this has changed. `name`
    distinguishes it from other texts of the same object in a file."""
    global _pieces
    pieces, _pieces = _pieces, None
    try:
        place = pieces.slices.places.get(id(thing)) if pieces else None
        if pieces is None or place is None:
            return make(thing, *constants)
        return pieces.text(f"{name} {place}", place, make, thing, *constants)
    finally:
        _pieces = pieces


class Slice(Anew):
    """The last run and this run of one target."""

    def __init__(self, slices: Slices, target: str) -> None:
        self.slices = slices
        self.folder = slices.out / target
        self.key = cache.key(slices.key, target)
        self._readers = cache.key(slices.key, target, "readers")
        self.digests: dict[str, bytes] = {}  # of the files of the last run
        self.readers: dict[Address, frozenset[str]] = {}  # address -> what was made from what it stands for
        self.pieces: dict[str, bytes] = {}  # the digests of the pieces of a file
        self.stored = b""  # the digest of the readers, which change rarely and have a separate entry
        self.read: dict[str, set[Address]] = {}  # by what is made in this run
        data = cache.get("slices", self.key)
        readers = cache.get("slices", self._readers)
        if data is not None and readers is not None:
            of, digests, self.stored, pieces = pickle.loads(data)
            if of == slices.before and self.stored == digest(readers):
                self.digests, self.readers, self.pieces = digests, pickle.loads(readers), pieces
        parts = slices.reshaped
        affected = [what for a, what in self.readers.items() if a >> _PART in parts] if parts else []
        affected += [self.readers[a] for a in slices.changed if a in self.readers]
        self.stale = frozenset[str]().union(*affected)

    def unchanged(self, what: str) -> bool:
        return what in self.digests and what not in self.stale

    def right(self, path: str) -> Same | None:
        if not (self.unchanged(path) and self.unchanged(PLAN)):
            return None
        same = Same(self.digests[path], self.folder / path)
        try:
            return same if digest(output.content(same)) == same.digest else None
        except OSError:
            return None

    def all_right(self) -> dict[str, Made] | None:
        files: dict[str, Made] = {}
        for path in self.digests.keys() - {NAMES, PLAN}:
            data = self.right(path)
            if data is None:
                return None
            files[path] = data
        return files or None

    def make(self, what: str, how: Callable[..., Value], *arguments: Any) -> Value:
        global _pieces
        _pieces = pieces = Pieces(self.slices, self._stored(what))
        try:
            made, read = reads.during(how, *arguments)
        finally:
            _pieces = None
        self.read[what] = self.slices.noted(read)
        self.pieces.pop(what, None)
        if pieces.now:
            data = pickle.dumps(pieces.now, 5)
            self.pieces[what] = digest(data)
            cache.put("slices", {self._place(what): data})
        return made

    def _place(self, what: str) -> str:
        return cache.key(self.slices.key, self.folder.name, "pieces", what)

    def _stored(self, what: str) -> bytes | None:
        """Returns the stored pieces of a file, if they are still those of the file."""
        if what not in self.pieces or not self.unchanged(PLAN):
            return None
        data = cache.get("slices", self._place(what))
        return data if data is not None and digest(data) == self.pieces[what] else None

    def keep(self, files: Mapping[str, Made]) -> None:
        digests = {NAMES: b"", PLAN: b"", **{path: digest(data) for path, data in files.items()}}
        readers, nobody = self.readers, frozenset[str]()
        known = all(
            read <= readers.keys() and all(map(frozenset.__contains__, map(readers.__getitem__, read), repeat(what)))
            for what, read in self.read.items()
        )
        if not known or digests.keys() != self.digests.keys():  # otherwise, reads that no longer happen do no harm
            again = self.read.keys() | (self.digests.keys() - digests.keys())
            readers = {a: what - again for a, what in readers.items()}
            for what, read in self.read.items():
                for a in read:
                    readers[a] = readers.get(a, nobody) | {what}
            same: dict[frozenset[str], frozenset[str]] = {}  # shares equal objects, so that less is stored
            readers = {a: same.setdefault(what, what) for a, what in readers.items() if what}
            data = pickle.dumps(readers, 5)
            cache.put("slices", {self._readers: data})
            self.stored = digest(data)
        pieces = {path: of for path, of in self.pieces.items() if path in digests}
        cache.put("slices", {self.key: pickle.dumps((self.slices.now, digests, self.stored, pieces), 5)})
