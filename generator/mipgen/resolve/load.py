"""Builds the model from the nodes: resolves all references and computes all sizes."""

from __future__ import annotations

import gc
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from mipgen import model as m
from mipgen.base import resources
from mipgen.facts import references
from mipgen.read import loader
from mipgen.read.nodes import Document, Node
from mipgen.read.problems import Problems, nearest

from . import beside, checks, devices, evidence, frames, guides, simulation
from .meaning import unknown_unit
from .sets import Families
from .types import Types
from .vocabulary import Vocabulary, sources_of_node


def load_model(spec: Path, *overlays: Path) -> m.Model:
    """Loads, resolves and checks a specification with its overlays; raises SpecError with all problems.

    Examples and errata are checked only if the definitions are correct; otherwise they would seem wrong.
    """
    collecting = gc.isenabled()
    gc.disable()  # a model contains no garbage; searching for it takes a quarter of the time
    try:
        return _loaded(spec, overlays)
    finally:
        if collecting:
            gc.enable()


def _loaded(spec: Path, overlays: Sequence[Path]) -> m.Model:
    problems = Problems()
    documents = loader.load(spec, overlays, problems)
    problems.raise_if_any()
    model = resolve(documents, problems)
    problems.raise_if_any()
    protocol = next(d.root for d in documents if d.kind == "protocol")
    return replace(model, programs=_programs()) if protocol.scalar("programs", False) else model


def _programs() -> tuple[tuple[str, str], ...]:
    """Returns the example programs and the parts of READMEs that come with this program, by file name."""
    files = (f for folder in resources.PROGRAMS for f in resources.files_in(resources.root() / folder))
    return tuple((name, file.read_text("utf-8")) for name, file in files)


def resolve(documents: Sequence[Document], problems: Problems) -> m.Model:
    """Builds the model of the documents; adds their mistakes to `problems`."""
    roots = {kind: [d.root for d in documents if d.kind == kind] for kind in (*loader.LAYOUT, "family", "named")}
    types, model = definitions(roots, problems)
    checks.check_definitions(model, problems)
    sound = not problems
    model = devices.resolve(roots["device"], roots["family"], model, types, problems)
    model = replace(model, named=devices.known_by_name(roots["named"], model, problems))
    if sound:
        manuals = types.vocabulary.manuals
        examples = evidence.examples(roots["examples"], model, problems)
        errata = evidence.errata(roots["errata"], manuals, problems)
        model = replace(model, examples=examples, errata=errata)
        checks.check_evidence(model, problems)
        simulated = simulation.resolve(roots["simulation"], model, problems)
        model = replace(model, simulation=simulated)
        model = replace(model, guides=guides.resolve(roots["guide"], model, types.vocabulary, problems))
        references.check_references((root for several in roots.values() for root in several), model, problems)
    return model


def definitions(roots: dict[str, list[Node]], problems: Problems) -> tuple[Types, m.Model]:
    """Resolves the protocol, the types and the sets."""
    root = roots["protocol"][0]
    beside.with_typical(roots["types"], roots["set"], roots["packets"], problems)
    functions = _functions(root["functions"], problems)
    manuals = _manuals(roots["manual"], problems)
    words = Vocabulary(
        units=_units(root["units"], problems),
        frames={name: _names(n.get("elements")) for name, n in root["frames"].items()},
        manuals={x.id: x for x in manuals},
        devices={d["device"].value for d in roots["device"]},
        functions=functions,
        selector=_selector(functions),
        evidence=beside.Lists(roots["evidence"], "sources", problems),
        keywords=beside.Lists(roots["searches"], "keywords", problems),
    )
    types = Types(words, problems, marked=beside.marked_by_bits((*roots["types"], *roots["set"])))
    for node in roots["types"]:
        types.define(None, node["types"])
    for node in roots["set"]:
        types.define(node["name"].value, node.get("types"))
        types.parts[node["name"].value] = dict(node["parts"].value) if "parts" in node else {}
    shared = types.of(None)
    protocol = _protocol(root, types, functions, problems)
    families = Families(types, problems).resolve(roots["set"])
    words.evidence.unused("set, type, field or response")
    words.keywords.unused("command or data field")
    model = m.Model(protocol, shared, families)
    if "barrier" in root:
        model = replace(model, protocol=replace(protocol, barrier=_barrier(root["barrier"], model, problems)))
    return types, model


# --------------------------------------------------------------------------- protocol


def _functions(node: Node, problems: Problems) -> tuple[m.Function, ...]:
    functions: list[m.Function] = []
    for name, n in node.items():
        letter, value = n["letter"], n["value"]
        for other in functions:
            if other.letter == letter.value:
                problems.add(letter.position, f"'{other.name}' already has the letter {letter.value}; choose another")
            if other.value == value.value:
                problems.add(value.position, f"'{other.name}' already has the value {value.value}; choose another")
        like = n.get("like")
        if like is not None and like.value not in node:
            problems.add(like.position, f"unknown function '{like.value}'{nearest(like.value, node.value)}")
        functions.append(
            m.Function(
                name,
                letter.value,
                value.value,
                reply=n.scalar("reply", True),
                responds=n.scalar("responds", False),
                sets=n.scalar("sets", False),
                like=like.value if like else None,
                description=n["description"].value,
                position=node.keys[name],
            )
        )
    return tuple(sorted(functions, key=lambda f: f.value))


def _selector(functions: Iterable[m.Function]) -> m.Enum:
    values = tuple(m.EnumValue(f.name, f.value, f.description, position=f.position) for f in functions)
    return m.Enum("function_selector", m.SCALARS["u8"], values, "The operation that a settings command requests.", None)


def _is_command_and_code(parameters: tuple[m.Parameter, ...]) -> bool:
    """Is it the acknowledge that all clients read? They know it by two bytes at fixed places."""
    if [p.kind for p in parameters] != ["scalar", "scalar"]:
        return False
    command, code = parameters
    return command.size == code.size == 1 and not command.named and isinstance(code.element, m.Enum)


def _protocol(root: Node, types: Types, functions: tuple[m.Function, ...], problems: Problems) -> m.Protocol:
    node = root["acknowledge"]
    record = types.record(list(node["parameters"]), None)
    codes = [p.element for p in record.parameters if isinstance(p.element, m.Enum)]
    if len(codes) != 1:
        problems.add(node.keys["parameters"], "the acknowledge field needs exactly one enumeration: the code")
        codes.append(types.vocabulary.selector)  # as a substitute, to find further problems
    elif not _is_command_and_code(record.parameters):
        problems.add(
            node.keys["parameters"],
            "the acknowledge field needs two parameters of one byte: the command's descriptor, a u8, and the code",
        )
    cited = sources_of_node(node, types.vocabulary, problems)
    acknowledge = m.Field(
        family="protocol", occurrences=(m.Occurrence(0, "protocol", node["title"].value, cited),),
        everywhere=m.COMMAND_SETS, name=node["name"].value, descriptor=node["descriptor"].value, role=m.RESPONSE,
        title=node["title"].value, description=node["description"].value, parameters=record.parameters,
        min_size=record.min_size, max_size=record.max_size,
        sources=cited, position=node.position,
    )  # fmt: skip
    first, second = root["sync"].plain()
    return m.Protocol(
        name=root["name"].value,
        title=root.scalar("title", f"{root['name'].value} protocol"),
        package=root.scalar("package", m.OWN_PACKAGE),
        keywords=_names(root.get("keywords")),
        position=(root.get("package") or root["name"]).position,
        version=root["version"].value,
        sync=(first, second),
        max_payload=root["max_payload"].value,
        functions=functions,
        acknowledge=acknowledge,
        ack_code=codes[0],
        function_selector=types.vocabulary.selector,
        units=_words(root["units"], types.vocabulary.units, problems),
        frames=frames.resolve(root["frames"], types.vocabulary, problems),
        manuals=tuple(types.vocabulary.manuals.values()),
        notes=tuple(
            m.Chapter(n["title"].value, tuple(n["text"].plain()), sources_of_node(n, types.vocabulary, problems))
            for n in root.get("notes") or ()
        ),
        vocabulary=_vocabulary(root.get("vocabulary")),
        synonyms=tuple(tuple(group.plain()) for group in root.get("synonyms") or ()),
        clocks=_clocks(root.get("clocks")),
        session=_session(root.get("session")),
        repository=root.scalar("repository", ""),
        leap_seconds=tuple(sorted(root["leap_seconds"].plain().items())) if "leap_seconds" in root else (),
    )


def _manuals(nodes: list[Node], problems: Problems) -> list[m.Manual]:
    """Resolves the manuals, in the order of their document numbers."""
    manuals: dict[str, m.Manual] = {}
    for node in nodes:
        name = node["manual"].value
        if name in manuals:
            problems.add(node["manual"].position, f"the manual '{name}' is defined twice; rename one")
        sections = tuple(node["sections"].plain()) if "sections" in node else ()
        manuals[name] = m.Manual(
            name, node["title"].value, node["document"].value, node["lengths"].value, sections,
            node.scalar("kind", "manual"),
        )  # fmt: skip
    return sorted(manuals.values(), key=lambda x: (x.document, x.id))


def _clocks(node: Node | None) -> tuple[m.Clock, ...]:
    return tuple(
        m.Clock(
            name, n["title"].value, n.scalar("description", ""), n.scalar("epoch"), tuple(n["timestamps"].plain()),
            n["timestamps"].position,
        )
        for name, n in node.items()
    ) if node else ()  # fmt: skip


def _session(node: Node | None) -> m.Session | None:
    if node is None:
        return None
    return m.Session(
        **{name: node[name].value for name in node.keys if name not in ("model_numbers", "descriptors", "older")},
        model_numbers=tuple(node["model_numbers"].plain()),
        descriptors=tuple(node["descriptors"].plain()) if "descriptors" in node else (),
        older=tuple(
            m.Older(name, **{key: n[key].value for key in n.keys}, position=n.position)
            for name, n in (node["older"].items() if "older" in node else ())
        ),
        position=node.position,
    )


def _barrier(node: Node, model: m.Model, problems: Problems) -> tuple[int, int]:
    """Returns set and descriptor of the barrier's command, which a partial specification keeps even if it lacks the
    command."""
    f = model.field(node.value)
    if f is None or f.role != m.COMMAND:
        names = {x.full_name for x in model.fields if x.role == m.COMMAND}
        problems.add(node.position, f"no command '{node.value}'{nearest(node.value, names)}")
    elif f.parameters or f.responses:
        problems.add(node.position, f"'{f.full_name}' has parameters or a response; choose a command with neither")
    else:
        return f.set, f.descriptor
    return 0, 0


def _vocabulary(node: Node | None) -> tuple[m.Usage, ...]:
    return tuple(m.Usage(word, tuple(x.plain()), node.keys[word]) for word, x in node.items()) if node else ()


def _units(node: Node, problems: Problems) -> dict[str, m.Unit]:
    """Returns the units by key. Output shows their symbols only, which therefore must differ."""
    units: dict[str, m.Unit] = {}
    keys: dict[str, str] = {}
    for key, n in node.items():
        units[key] = m.Unit(key, n.scalar("symbol", key))
        other = keys.setdefault(units[key].symbol, key)
        if other != key:
            position = (n.get("symbol") or n).position
            problems.add(position, f"'{units[key].symbol}' is also the symbol of the unit '{other}'; write another")
    return units


def _words(node: Node, units: Mapping[str, m.Unit], problems: Problems) -> tuple[m.Word, ...]:
    return tuple(
        m.Word(
            symbol=units[key].symbol,
            title=n["title"].value,
            description=n.scalar("description", ""),
            plural=n.scalar("plural", ""),
            numbered=n.scalar("numbered", False),
            key=key,
            equals=_equal(n["equals"], units, problems) if "equals" in n else None,
        )
        for key, n in node.items()
    )


def _equal(node: Node, units: Mapping[str, m.Unit], problems: Problems) -> tuple[str, float]:
    """Resolves `equals` of a unit: another unit, and the factor."""
    ((other, n),) = node.items()
    if other not in units:
        problems.add(node.keys[other], unknown_unit(other, units))
    return other, n.value


def _names(node: Node | None) -> tuple[str, ...]:
    return tuple(node.plain()) if node else ()
