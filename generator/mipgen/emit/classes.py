"""Names for languages with a class for each field and type, and a module for each family."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from mipgen import model as m

from .naming import Identifier, pascal

#: The names inside a class: in the language, and in the specification with its position there.
Attributes = Callable[[m.Type | m.Field], Iterable[tuple[str, str, m.Position | None]]]


@dataclass(frozen=True, slots=True)
class Classes:
    module: Callable[[str], str]  # the module of a family
    legal: Callable[[str], str]  # makes a name legal for a class

    def name(self, thing: m.Type | m.Field) -> str:
        name = pascal(thing.name)
        return name if self.home(thing) == "protocol" else self.legal(name)

    def home(self, thing: m.Type | m.Field) -> str:
        """Returns the module that defines a thing."""
        if isinstance(thing, m.Field):
            return self.module(thing.family) if thing.set else "protocol"
        if thing.name == "function_selector":  # a specification cannot define this type
            return "protocol"
        return self.module(thing.owner) if thing.owner else "types"

    def qualified(self, thing: m.Type | m.Field) -> str:
        """Returns the name of a thing in a module that imports its module: `types.AckCode`."""
        return f"{self.home(thing)}.{self.name(thing)}"

    def reference(self, thing: m.Type | m.Field, where: str) -> str:
        """Returns the name of a thing in the module `where`. All modules import the names of `protocol`."""
        return self.name(thing) if self.home(thing) in (where, "protocol") else self.qualified(thing)

    def identifiers(self, model: m.Model, attributes: Attributes) -> Iterator[Identifier]:
        """Yields the classes of all modules, and the names inside them."""
        modules = [("types", model.types), *((x.name, (*x.types, *x.fields)) for x in model.families)]
        for scope, things in modules:
            for t in things:
                place = getattr(t, "position", None)
                yield Identifier(f"module {scope}", self.name(t), f"{scope}.{t.name}", place)
                for name, words, position in attributes(t):
                    yield Identifier(f"class {scope}.{t.name}", name, words, position or place)
