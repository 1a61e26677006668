"""Notes the data that is read for a result, so that it is made again only if that data has changed.

Watched attributes of a class note each read. A result that is kept, by `kept` or in a `Memo`, is kept together with
what was read for it: using the result counts as reading that, too.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import Any, Generic, TypeVar, overload

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Earlier:
    """The reads noted for a result of an earlier run, as numbers that only the users of such results can interpret."""

    __slots__ = ("read",)

    def __init__(self, read: frozenset[int]) -> None:
        self.read = read


#: A read attribute: the identity of its object, which must live as long as the read, and its name.
Read = tuple[int, str] | Earlier

_log: set[Read] = set()


def during(make: Callable[..., Value], *arguments: Any) -> tuple[Value, frozenset[Read]]:
    """Computes a result; returns it, and the data that was read for it."""
    global _log
    outer, _log = _log, set()
    try:
        value = make(*arguments)
    finally:
        inner, _log = _log, outer
        outer |= inner
    return value, frozenset(inner)


def note(read: frozenset[int]) -> None:
    """Notes that a result of an earlier run is used, for which `read` was read."""
    _log.add(Earlier(read))


def watch(cls: type, names: Iterable[str]) -> None:
    """Starts to watch the attributes with these names; the class may have slots or not."""
    for name in names:
        setattr(cls, name, _Slot(name, cls.__dict__[name]) if hasattr(cls, "__slots__") else _Attribute(name))


def unnoticed(cls: type, names: list[str]) -> Callable[[Any], tuple[Any, ...]]:
    """Returns a function that reads attributes of an object of a watched class without noting the reads."""
    if not hasattr(cls, "__slots__"):
        return lambda owner: tuple([owner.__dict__[name] for name in names])
    slots = [cls.__dict__[name].get for name in names]
    return lambda owner: tuple([get(owner) for get in slots])


class _Attribute:
    """A watched attribute in the `__dict__` of its object."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __get__(self, owner: Any, cls: type | None = None) -> Any:
        if owner is None:
            return self
        _log.add((id(owner), self.name))
        return owner.__dict__[self.name]

    def __set__(self, owner: Any, value: Any) -> None:
        owner.__dict__[self.name] = value


class _Slot:
    """A watched attribute of a class with slots."""

    def __init__(self, name: str, slot: Any) -> None:
        self.name = name
        self.get, self.set = slot.__get__, slot.__set__

    def __get__(self, owner: Any, cls: type | None = None) -> Any:
        if owner is None:
            return self
        _log.add((id(owner), self.name))
        return self.get(owner)

    def __set__(self, owner: Any, value: Any) -> None:
        self.set(owner, value)


class Memo(Generic[Key, Value]):
    """Results by key, each computed once."""

    def __init__(self) -> None:
        self._known: dict[Key, tuple[Value, frozenset[Read]]] = {}

    def get(self, key: Key, make: Callable[..., Value], *arguments: Any) -> Value:
        known = self._known.get(key)
        if known is None:
            known = self._known[key] = during(make, *arguments)
        _log.update(known[1])
        return known[0]


class kept(Generic[Value]):
    """A property that is computed once, as with functools.cached_property; the object must have a `__dict__`."""

    def __init__(self, make: Callable[[Any], Value]) -> None:
        self.make = make
        self.__doc__ = make.__doc__
        self.key = f"{make.__name__} and what was read for it"

    @overload
    def __get__(self, owner: None, cls: type) -> kept[Value]: ...
    @overload
    def __get__(self, owner: object, cls: type) -> Value: ...
    def __get__(self, owner: Any, cls: Any = None) -> Any:
        if owner is None:
            return self
        known = owner.__dict__.get(self.key)
        if known is None:
            known = owner.__dict__[self.key] = during(self.make, owner)
        _log.update(known[1])
        return known[0]
