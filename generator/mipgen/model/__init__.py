"""The resolved model of MIP: all references are resolved and all sizes computed.

Frozen dataclasses describe the protocol, independently of languages and files. `resolve` builds them,
targets and templates read them. Names are lower-case words joined by underscores, as in the specification;
`emit.naming` converts them to each language's case. Languages that limit the length of identifiers use `short`
instead of a name, if there is one.

Guides and the simulation are in their own modules.
"""

from mipgen.read.problems import Position

from .devices import (
    COUNTED,
    EVIDENCE,
    SUPPORTED,
    Answer,
    Device,
    DeviceVariant,
    Evidence,
    Hardware,
    Limit,
    NamedDevice,
    Note,
    Port,
    ProtocolFirmware,
    Rate,
    Support,
    strength,
    worded,
)
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
from .parameters import DEVICE, REST, Case, Group, Parameter, Shape, Shown, Union, Variant, optional_groups
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
    State,
    Struct,
    Type,
    Unit,
    Vector,
    letters,
    named_parts,
    structs,
    unit_symbols,
)
