"""Identifiers: the words of the specification in Python's case, with Python's own names escaped."""

from __future__ import annotations

import builtins
import re

from mipgen.base import resources
from mipgen.emit.naming import Classes, Escape, Grammar, upper
from mipgen.emit.render import language

_LANGUAGE = language("python")
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])

#: Module -> the fact that a specification must contain for its package to include the module.
NEEDS: dict[str, str] = dict(_LANGUAGE["needs"])

GRAMMAR = Grammar(r"[A-Za-z_]\w*", _KEYWORDS)

#: Scalar -> its letters for `struct`.
SCALARS: dict[str, str] = _LANGUAGE["scalars"]
#: Kind of scalar -> the type of its values.
ANNOTATIONS: dict[str, str] = _LANGUAGE["annotations"]

_constant = Escape(frozenset(), digit_prefix="N")


def _taken() -> set[str]:
    """Returns the modules that every package has, the functions that can be imported from it, and the names that are
    beside the modules of sets where those are imported."""
    files = (
        path.rpartition("/")[2] for path, _ in resources.files_in(resources.root() / "runtime/python/mip_protocol")
    )
    exported = (resources.root() / "templates/python/__init__.py.j2").read_text("utf-8").partition("__all__ = [")[2]
    modules = {name.removesuffix(".py") for name in files if name.endswith(".py")}
    return {"devices", "protocol", "types", *modules, *_LANGUAGE["devices"], *re.findall(r'"([a-z]\w*)"', exported)}


def _imported() -> set[str]:
    """Returns the classes that the modules of sets and types import."""
    texts = ((resources.root() / f"templates/python/{name}.py.j2").read_text("utf-8") for name in ("set", "types"))
    imports = re.findall(r"^from .* import (.*)$", "\n".join(texts), re.MULTILINE)
    return set(re.findall(r"\b[A-Z]\w*", " ".join(imports)))


#: A descriptor set -> its module.
module = Escape(_KEYWORDS | _taken(), digit_prefix="mip_")

legal_class = Escape(_KEYWORDS | _imported(), digit_prefix="Mip")
_classes = Classes(module, legal_class)
class_name, home, qualified, reference = _classes.name, _classes.home, _classes.qualified, _classes.reference
identifiers = _classes.identifiers

#: A parameter -> the attribute of the objects that hold it; a function -> its constructor.
member = Escape(_KEYWORDS | frozenset(_LANGUAGE["members"]), digit_prefix="n")

#: An element of a vector.
element = Escape(_KEYWORDS | frozenset(_LANGUAGE["elements"]), digit_prefix="n")

#: A number inside a bitfield -> the property that reads it.
prop = Escape(_KEYWORDS | frozenset(_LANGUAGE["bits"]), digit_prefix="n")


def constant(words: str) -> str:
    """Returns the constant for a value, a bit or a device."""
    return _constant(upper(words))


def hides_builtin(name: str) -> bool:
    """True if `from mip_protocol import name` hides a built-in name of Python."""
    return hasattr(builtins, name)
