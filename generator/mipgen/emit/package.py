"""Package names, which distinguish the output of one specification from the output of another.

Templates and runtimes are written for the package `mip`, so that they are ordinary source. The output of a
specification with another `package` is the same with the names of that package: `probe_parser_init` instead of
`mip_parser_init`, `probe_protocol` for `mip_protocol`. `resolve` prevents conflicts with names of the specification.

`tests/packages` builds and links two packages side by side.
"""

from __future__ import annotations

import re
from collections.abc import Callable

#: Names in source: `mip_parser`, `MIP_OK`, `-DMIP_SHARED`, `mip_protocol`, `mip-protocol`, `mip/core.h`. The programs
#: in tools/ work with any package and keep their names. Each alternative begins with a letter, for which `re` searches
#: ten times as fast as for a condition on what is before it.
_NAMES = (
    r"m(?:(?<=\bm)|(?<=-Dm))ip(?:_(?!(?:tools|simulator)\b)|-(?=protocol\b)|(?=/(?:\w+/)?\w+\.h\b|::mip\b))|m(?<=mip::m)ip\b"
    r"|M(?:(?<=\bM)|(?<=-DM))IP_(?!PACKAGE\b|WORKBENCH\b)"
)
#: The name alone as the name of a library or a module: `-lmip`, `libmip`, `mipConfig.cmake`, `CONFIG_MIP`.
_ALONE = (
    r"m(?:(?<=\bm)|(?<=-Im)|(?<=-lm)|(?<=\blibm))ip(?!-tools\b)(?=\b|Config|Targets)"
    r"|M(?<=\bM)ip\b|M(?<=CONFIG_M)IP\b"
)

_IN_SOURCE = re.compile(_NAMES)
_EVERYWHERE = re.compile(f"{_NAMES}|{_ALONE}")


def in_source(text: str, package: str) -> str:
    """
    >>> in_source("mip_protocol.mip_3dm, mip-protocol, MIP_OK, <mip/core.h>, mip_tools, mip_simulator, mip send", "a_b")
    'a_b_protocol.a_b_3dm, a-b-protocol, A_B_OK, <a_b/core.h>, mip_tools, mip_simulator, mip send'
    """
    return _IN_SOURCE.sub(_for(package), text)


def everywhere(text: str, package: str) -> str:
    """
    >>> everywhere("mip::mip, -lmip, libmip.a, mipConfig, from mip import Mip, CONFIG_MIP, MIP packets", "a_b")
    'a_b::a_b, -la_b, liba_b.a, a_bConfig, from a_b import AB, CONFIG_A_B, MIP packets'
    """
    return _EVERYWHERE.sub(_for(package), text)


def _for(package: str) -> Callable[[re.Match[str]], str]:
    forms = {"mip": package, "mip_": f"{package}_", "mip-": f"{package.replace('_', '-')}-"}
    forms |= {"MIP": package.upper(), "MIP_": f"{package.upper()}_"}
    forms["Mip"] = "".join(word.capitalize() for word in package.split("_"))
    return lambda match: forms[match[0]]
