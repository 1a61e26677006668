"""ROS 2: a package with a message for each data field.

Standard messages are in `mip_tools.ros`. Tests: `tests/ros2`, `tests/tools/cli/test_robots.py`.
"""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target

from . import names
from .view import data_fields, messages


def files(model: m.Model) -> Iterator[File]:
    made, shown = model.derived(messages), next(iter(data_fields(model)), None)
    example = (shown.full_name, names.message(shown)) if shown else None
    for name in ("package.xml", "CMakeLists.txt", "README.md"):
        yield File(name, f"{name}.j2", {"messages": sorted(x.name for x in made), "example": example})
    for x in made:
        yield File(f"msg/{x.name}.msg", "message.msg.j2", {"message": x}, x.record)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in names.PACKAGES:
        yield Identifier("the packages", name, f"{name} of ROS 2", None)
    yield Identifier("the packages", "mip_msgs", "the package", model.protocol.position)
    for x in model.derived(messages):
        what = x.record.full_name if isinstance(x.record, m.Field) else x.record.name
        yield Identifier("mip_msgs", x.name, what, x.record.position)
        for member in x.members:
            yield Identifier(f"the message {x.name}", member.name, member.name, x.record.position)
            for _, constant, _ in (x for _, constants in member.constants for x in constants):
                what = f"{member.name}: {constant}"
                yield Identifier(f"the message {x.name}", constant, what, x.record.position)


TARGET = Target(
    title="ROS 2, package mip_msgs",
    files=files,
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
)
