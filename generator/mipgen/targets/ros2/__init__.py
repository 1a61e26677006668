"""ROS 2: a package with a message for each data field."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.facts import describe

from . import members, names


def fields(model: m.Model) -> list[m.Field]:
    """Returns the fields that have messages."""
    return [f for f in model.fields if f.role == m.DATA]


def files(model: m.Model) -> Iterator[File]:
    data = fields(model)
    records: list[m.Field | m.Struct] = [*members.nested(data), *data]
    made = sorted(map(names.message, records))
    for name in ("package.xml", "CMakeLists.txt", "README.md"):
        yield File(name, f"{name}.j2", {"messages": made, "shown": data[0] if data else None})
    for record in records:
        known = {"record": record, "header": isinstance(record, m.Field)}
        yield File(f"msg/{names.message(record)}.msg", "message.msg.j2", known, record)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    def prose(words: str) -> str:
        return describe.say(describe.prose(words, model), members.named)

    def lines(record: m.Record) -> list[members.Member]:
        return members.of_record(record, model)

    return {"message": names.message, "prose": prose, "members": lines}


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in names.PACKAGES:
        yield Identifier("the packages", name, f"{name} of ROS 2", None)
    yield Identifier("the packages", "mip_msgs", "the package", model.protocol.position)
    data = fields(model)
    records: list[m.Field | m.Struct] = [*members.nested(data), *data]
    for record in records:
        name = names.message(record)
        what = record.full_name if isinstance(record, m.Field) else record.name
        yield Identifier("mip_msgs", name, what, record.position)
        for p in members.of_record(record, model):
            yield Identifier(f"the message {name}", p.name, p.name, record.position)
            for text in p.constants:
                constant = text.split()[1].partition("=")[0]
                yield Identifier(f"the message {name}", constant, f"{p.name}: {constant}", record.position)


TARGET = Target(
    title="ROS 2, package mip_msgs",
    files=files,
    filters=filters,
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
)
