"""A target that escapes nothing: names reach its language as they are."""

from mipgen.emit.target import Grammar, Identifier, Target


def files(model):
    return ()


def identifiers(model):
    for field in model.fields:
        yield Identifier(f"module {field.family}", field.name, field.full_name, field.position)
        for p in field.parameters:
            yield Identifier(f"class {field.full_name}", p.name, p.name, p.position)
    for s in model.sets:
        yield Identifier("the files", s.name, f"set {s.name}", s.position, word=False)


TARGET = Target(
    title="plain",
    files=files,
    identifiers=identifiers,
    grammar=Grammar(r"[a-z]\w*", keywords=frozenset({"go", "if"}), longest=31),
)
