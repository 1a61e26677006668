"""The generated package that the tools work with, and all names that they use from it.

It is `mip_protocol` unless `use`, `mip --package` or the environment variable `MIP_PACKAGE` names
another one. All other modules of the tools import what they need of a specification from this module, by
name. A module of the package is imported when one of its names is first used.

`tests/tools/test_binding.py` uses a package with two fields.
"""

from __future__ import annotations

import json
import os
import sys
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from .errors import NoBinding

USUAL = "mip_protocol"
VARIABLE = "MIP_PACKAGE"

#: The file that distinguishes a generated package from other folders.
_MARK = "reflection"

#: The argument of the last call of `use`.
_wanted: str | None = None


def use(package: str) -> None:
    """Selects the generated package by its name, its folder or the folder that contains it.

    Call this before you import any other module of the tools. Raises NoBinding.
    """
    global _wanted
    before, _wanted = _wanted, package
    if name.cache_info().currsize and _location(_named()) != name():
        message, _wanted = f"{name()} is already in use; select {package} before any other call", before
        raise NoBinding(message)
    name()


@cache
def name() -> str:
    """Returns the name of the package. Raises NoBinding with the remedy."""
    return _location(_named())


def use_argument() -> str:
    """Returns the argument of `use` that loads the same package in another process."""
    package = _named()
    return str(Path(package).resolve()) if Path(package).exists() and package != name() else package


def _named() -> str:
    return _wanted or os.environ.get(VARIABLE) or USUAL


def _location(wanted: str) -> str:
    if all(word.isidentifier() for word in wanted.split(".")) and _importable(wanted):
        if not _importable(f"{wanted}.{_MARK}"):
            raise NoBinding(f"{wanted} is not a package that mipgen has generated")
        return wanted
    if Path(wanted).is_dir():
        return _in_folder(Path(wanted).resolve())
    if wanted == USUAL:
        remedy = f"name yours with --package NAME, {VARIABLE}=NAME or mip_tools.use(NAME)"
        raise NoBinding(f"{USUAL} is not installed; install the generated Python package, or {remedy}")
    raise NoBinding(f"{wanted} is neither an installed package nor a folder; install it, or name its folder")


def _importable(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ModuleNotFoundError:
        return False


def _in_folder(folder: Path) -> str:
    """Makes a package importable, which is this folder or the only one in it; returns its name."""
    packages = [p.parent for p in (folder / f"{_MARK}.py", *sorted(folder.glob(f"*/{_MARK}.py"))) if p.is_file()]
    if len(packages) != 1:
        which = ", ".join(p.name for p in packages)
        message = f"several packages ({which}); name one" if packages else "no package that mipgen has generated"
        raise NoBinding(f"{folder} contains {message}")
    sys.path.insert(0, str(packages[0].parent))
    imported = sys.modules.get(packages[0].name)
    if imported is not None and str(packages[0]) not in map(str, imported.__path__):
        raise NoBinding(f"{packages[0]}: another package {packages[0].name} is in use")
    return packages[0].name


def module(home: str) -> ModuleType:
    """Imports a module of the package."""
    try:
        return import_module(f"{name()}.{home}")
    except ModuleNotFoundError as error:
        raise NoBinding(f"{name()} lacks {error.name}; regenerate it with the mipgen version of these tools") from None


@cache
def data(file: str) -> dict[str, Any]:
    """Reads a JSON file of the package, with facts for tools."""
    package: Any = import_module(name())  # `importlib.resources` takes a tenth of the start-up time of `mip`
    try:
        content = package.__loader__.get_data(os.path.join(package.__path__[0], file))
    except OSError:
        raise NoBinding(f"{name()} lacks {file}; regenerate it with the mipgen version of these tools") from None
    values: dict[str, Any] = json.loads(content)
    return values


#: Module of a generated package -> the names that the tools use from it.
_USED = {
    "_clocks": "CLOCKS DEVICE_CLOCK LEAP_SECONDS UNIT_KEYS",
    "_index": "FAMILIES FIELDS",
    "_scalars": "SCALARS",
    "_session": "session",
    "_sets": "MODULES SETS",
    "_words": "KEYWORDS SYNONYMS",
    "client": "Answer TimedOut",
    "codec": "OpenEnum single_from_bits single_to_bits",
    "described": "Described",
    "device": "connect open_port",
    "devices": "DEVICES identify model_number",
    "errors": "DecodeError EncodeError MipError MissingExtra NoAnswer NoSuchRate PacketError PortClosed "
    "PortError Refused UnknownName",
    "field": "Command Data Field Response Structure chosen",
    "info": "BitsInfo EnumInfo Item",
    "lookup": "device_id",
    "packet": "MAX_PAYLOAD OVERHEAD SYNC Packet PacketBuilder RawField checksum",
    "parameter": "Flag Parameter Variant meant named to_text",
    "parser": "Parser",
    "port": "READ_TIMEOUT",
    "profile": "Device Evidence Port Support",
    "protocol": "VERSION AckCode Acknowledge FunctionSelector",
    "reflection": "info items",
    "registry": "all_types types",
    "text": "shortest",
    "timestamps": "MOST REACH SECOND from_date headers moments moments_of utc",
}
#: Modules that the tools use as a whole.
_MODULES = ("lookup", "reflection", "registry", "timestamps")
_HOMES = {name: home for home, names in _USED.items() for name in names.split()}

# Type checkers take this package for any generated one.
if TYPE_CHECKING:
    from mip_protocol import lookup, reflection, registry, timestamps
    from mip_protocol._clocks import CLOCKS, DEVICE_CLOCK, LEAP_SECONDS, UNIT_KEYS
    from mip_protocol._index import FAMILIES, FIELDS
    from mip_protocol._scalars import SCALARS
    from mip_protocol._session import session
    from mip_protocol._sets import MODULES, SETS
    from mip_protocol._words import KEYWORDS, SYNONYMS
    from mip_protocol.client import Answer, TimedOut
    from mip_protocol.codec import OpenEnum, single_from_bits, single_to_bits
    from mip_protocol.described import Described
    from mip_protocol.device import Device as DeviceAtPort
    from mip_protocol.device import connect, open_port
    from mip_protocol.devices import DEVICES, identify, model_number
    from mip_protocol.errors import (
        DecodeError,
        EncodeError,
        MipError,
        MissingExtra,
        NoAnswer,
        NoSuchRate,
        PacketError,
        PortClosed,
        PortError,
        Refused,
        UnknownName,
    )
    from mip_protocol.field import Command, Data, Field, Response, Structure, chosen
    from mip_protocol.info import BitsInfo, EnumInfo, Item
    from mip_protocol.lookup import device_id
    from mip_protocol.packet import MAX_PAYLOAD, OVERHEAD, SYNC, Packet, PacketBuilder, RawField, checksum
    from mip_protocol.parameter import Flag, Parameter, Variant, meant, named, to_text
    from mip_protocol.parser import Parser
    from mip_protocol.port import READ_TIMEOUT
    from mip_protocol.profile import Device, Evidence, Port, Support
    from mip_protocol.protocol import VERSION, AckCode, Acknowledge, FunctionSelector
    from mip_protocol.reflection import info, items
    from mip_protocol.registry import all_types, types
    from mip_protocol.text import shortest
    from mip_protocol.timestamps import MOST, REACH, SECOND, from_date, headers, moments, moments_of, utc
else:

    def __getattr__(what: str) -> Any:
        if what in _MODULES:
            value = module(what)
        elif what in _HOMES:
            value = getattr(module(_HOMES[what]), what)
        else:
            raise AttributeError(f"module {__name__!r} has no attribute {what!r}")
        globals()[what] = value
        return value
