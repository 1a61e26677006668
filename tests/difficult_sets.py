"""Sets that are difficult for a target: names that the language or the generated code
uses itself, arrays that serde and Default do not know, and names of every length."""

from __future__ import annotations

from functools import cache

from spec_defaults import filled

HEAD = """# yaml-language-server: $schema=../../../../../spec/schema/set.schema.json
"""

COMMANDS = """set: 0x61
name: macros_and_more
title: Awkward names
description: "Names of Rust and of the generated code: `<T>`, [x](y), a * b, \\"quoted\\"."
types:
  option:
    enum: u8
    values: {values: 0, 5_hz: 5, self: 6, none: 7, some: 8}
  result:
    bitfield: u16
    bits: {contains: 0, empty: 1, bits: 2, insert: {bit: 3-4}, is_empty: 5, from: {bit: 6-9, enum: option}, self: 10}
  some:
    struct:
      - {name: self, type: u8}
      - {name: reader, type: u8}
      - {name: option, type: option}
      - name: value
        switch: option
        cases: {values: {type: u16}, 5_hz: {}, self: {type: float}, none: {type: u8, count: 40}, some: {type: result}}
  late:
    struct: [{name: kind, type: later}, {name: rest, switch: kind, cases: {one: {type: u8}, two: {}}}]
  later: {enum: u16, values: {one: 1, two: 2}}
fields:
  - command: 0x01
    name: field
    title: Field
    description: "Everything that generated code calls something: `a`, <b>, [c]."
    functions: WRSLDA
    parameters:
      - {name: reader, type: u8, for: WRSLD}
      - {name: writer, type: u8, for: WRS}
      - {name: required, type: u8, for: WRS}
      - {name: record, type: u8, for: W}
      - {name: group, type: u8, for: W}
      - {name: between, type: u8, for: W}
      - {name: value, type: u16, count: group, for: W}
      - {name: present, type: bool, for: W}
      - {name: long, type: u8, count: 40, for: W}
      - {name: tag, type: option, for: W}
      - name: data
        for: W
        switch: tag
        cases: {values: {type: some}, 5_hz: {}, self: {type: char, count: 3}, none: {}, some: {type: late}}
    responses: [{response: 0x81, name: option_response, parameters: as_command}]
  - command: 0x02
    name: command
    title: Command
    description: Two arrays that belong together.
    parameters:
      - {name: count, type: u16, description: Of items.}
      - {name: crate, type: u8, const: 7}
      - {name: items, type: bool, count: count}
      - {name: flags, type: result}
      - {name: self, type: char}
      - {name: name, type: char, count: rest}
  - command: 0x03
    name: string
    title: String
    description: Counters around each other, all optional.
    functions: WR
    parameters:
      - {name: a, type: u8, for: W}
      - {name: b, type: u8, for: W}
      - {name: x, type: u16, count: a, for: W}
      - {name: y, type: char, count: b, for: W}
      - {name: last, type: u8, optional: true}
    responses:
      - {response: 0x83, name: string_a_response, parameters: [{name: kind, type: u8, const: 1}, {name: x, type: u8}]}
      - {response: 0x83, name: string_second, parameters: [{name: kind, type: u8, const: 2}, {name: x, type: u16}]}
      - {response: 0x84, name: self, parameters: [{name: x, type: late}]}
"""

DATA = """set: 0x8F
name: 9_lives
title: Long arrays
description: More than thirty-two elements.
fields:
  - data: 0x01
    name: long
    title: Long
    description: Long arrays of all kinds.
    parameters:
      - {name: bytes, type: u8, count: 40}
      - {name: reserved, type: u8, count: 33, reserved: 3}
      - {name: short, type: u16, count: 2, reserved: 1}
      - {name: optional, type: u8, count: 40, optional: true}
"""

LARGE = f"""set: 0x62
name: large
title: Large
description: Types with more parts than a byte counts, and a field that has nothing but constants.
types:
  many: {{enum: u16, values: {{{", ".join(f"v{i}: {i}" for i in range(300))}}}}}
  wide: {{bitfield: 32, bits: {{{", ".join(f"b{i}: {i}" for i in range(256))}}}}}
fields:
  - command: 0x01
    name: constants
    title: Constants
    description: The host sends these.
    parameters: [{{name: model, type: u16, const: 4711}}, {{name: gap, type: u8, count: 2, reserved: 0}}]
    responses: [{{response: 0x81, name: echo, parameters: [{{name: many, type: many}}, {{name: wide, type: wide}}]}}]
"""


def lengths(longest: int = 33) -> str:
    """Types and fields with names of every length, so that any generated line may become too long. As names of C must
    not, types and fields have the shorter names in C, the longer those are that follow them."""
    types, fields = [], []
    for number, size in enumerate(range(4, longest + 1), 1):
        w = "w" * size
        e, b, s, f = (f"short: {kind}_{'w' * (40 - size)}" if size > 20 else "" for kind in "ebsf")
        types.append(
            f"""
  e{w}:
    {e}
    enum: u8
    values: {{none: 0, {w}: 1, a_{w}: 2, b: 3}}
  b{w}:
    {b}
    bitfield: u32
    bits: {{{w}: 0, n_{w}: {{bit: 3-9}}, m: {{bit: 10-11, enum: e{w}}}}}
  s{w}:
    {s}
    struct:
      - {{name: a_{w}, type: u8}}
      - {{name: tag, type: e{w}}}
      - {{name: u, switch: tag, cases: {{none: {{}}, {w}: {{type: u8}}, a_{w}: {{type: float}}, b: {{type: b{w}}}}}}}"""
        )
        between = "{name: between, type: u8, for: W}" if size % 2 else "{name: q, type: double, for: W}"
        fields.append(
            f"""
  - command: {number}
    name: f{w}
    {f}
    title: T {number}
    description: D.
    functions: WRSLDA
    parameters:
      - {{name: p_{w}, type: u8, for: WRSLD}}
      - {{name: tag, type: e{w}, for: W}}
      - {{name: c_{w}, type: u8, for: W}}
      - {between}
      - {{name: l_{w}, type: u16, count: c_{w}, for: W}}
      - {{name: o_{w}, type: u8, optional: true}}
    responses:
      - response: {0x80 + number}
        parameters:
          - {{name: r_{w}, type: u16, reserved: 3}}
          - {{name: x, type: u8}}
          - {{name: s, type: s{w}}}"""
        )
    return (
        "set: 0x60\nname: lengths\ntitle: Lengths\ndescription: Names of every length.\n"
        f"types:{''.join(types)}\nfields:{''.join(fields)}\n"
    )


@cache
def files() -> dict[str, str]:
    """The set files, by name."""
    short = {"names.yaml": COMMANDS, "long.yaml": DATA, "lengths.yaml": lengths(), "large.yaml": LARGE}
    return {name: HEAD + filled(text) for name, text in short.items()}
