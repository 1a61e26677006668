"""The resolved model: what MIP is, with every reference followed and every size computed.

Frozen dataclasses that describe the protocol, independent of any language and of files. `resolve` builds them,
targets and templates read them. Names are words in lower case joined by underscores, as the specification gives
them; `emit.naming` turns them into each language's case. Languages that limit the length of identifiers take
`short` in place of a name, where there is one.

Guides and the simulation are read from their own modules.
"""

from mipgen.read.position import Position

from . import (
    details,
    devices,
    evidence,
    fields,
    guides,
    parameters,
    protocol,
    simulation,
    types,
)
from .devices import EVIDENCE, Answer, Device, DeviceVariant, Evidence, Limit, Note, Port, Rate, Support, strength
from .evidence import Claim, Erratum, Example, ExampleField, Manual
from .fields import (
    COMMAND,
    COMMAND_SETS,
    DATA,
    DATA_SETS,
    MAX_FIELD_DATA,
    NO_SETS,
    RESPONSE,
    SHARED_DESCRIPTORS,
    SHARED_SET,
    Call,
    Condition,
    Family,
    Field,
    Kind,
    Named,
    Occurrence,
    Record,
    Reply,
    Role,
    Set,
)
from .parameters import DEVICE, REST, Case, Group, Parameter, Shape, Shown, Union, Variant, groups
from .protocol import OWN_PACKAGE, Chapter, Clock, Conversion, Older, Protocol, Session, Usage, Word
from .specification import Model
from .types import (
    SCALARS,
    Bitfield,
    Bits,
    Enum,
    EnumValue,
    Function,
    Scalar,
    Source,
    Struct,
    Type,
    Vector,
    letters,
    structs,
)

__all__ = [
    "COMMAND",
    "COMMAND_SETS",
    "DATA",
    "DATA_SETS",
    "DEVICE",
    "EVIDENCE",
    "MAX_FIELD_DATA",
    "NO_SETS",
    "OWN_PACKAGE",
    "RESPONSE",
    "REST",
    "SCALARS",
    "SHARED_DESCRIPTORS",
    "SHARED_SET",
    "Answer",
    "Bitfield",
    "Bits",
    "Call",
    "Case",
    "Chapter",
    "Claim",
    "Clock",
    "Condition",
    "Conversion",
    "Device",
    "DeviceVariant",
    "Enum",
    "EnumValue",
    "Erratum",
    "Evidence",
    "Example",
    "ExampleField",
    "Family",
    "Field",
    "Function",
    "Group",
    "Kind",
    "Limit",
    "Manual",
    "Model",
    "Named",
    "Note",
    "Occurrence",
    "Older",
    "Parameter",
    "Port",
    "Position",
    "Protocol",
    "Rate",
    "Record",
    "Reply",
    "Role",
    "Scalar",
    "Session",
    "Set",
    "Shape",
    "Shown",
    "Source",
    "Struct",
    "Support",
    "Type",
    "Union",
    "Usage",
    "Variant",
    "Vector",
    "Word",
    "groups",
    "letters",
    "strength",
    "structs",
]

_MODULES = (devices, evidence, fields, guides, parameters, protocol, simulation, types)
details.CLASSES += details.classes(*_MODULES)
