"""The comments of the headers state all that the specification says about each item."""

from __future__ import annotations

import html
import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from c_build import folder
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.c import calls, members, names
from mipgen.targets.c.comments import ELSEWHERE, EVIDENCE, Comments, reference
from support import ROOT, SPECS, heavy, model, need

both = pytest.mark.parametrize("spec", sorted(SPECS))

TOKEN = re.compile(
    r"/\*\*(?P<doc>.*?)\*/|/\*.*?\*/"
    r"|^\#define\s+(?P<macro>\w+)[^\n\\]*(?:\\\n[^\n]*)?|^\#[^\n]*"
    r"|^ +(?P<constant>MIP_\w+)(?: = \d+)?,?$"
    r"|(?:struct|union|enum)\s*(?:MIP_WORD )?(?P<opened>\w*)\s*(?:MIP_ENUM_\d+ )?\{"
    r"|(?P<closed>\})|(?P<statement>[^;{}/#]+);",
    re.S | re.M,
)


def plain(text: str) -> str:
    """The text of a comment, without markers and line breaks."""
    return " ".join(re.sub(r"^\s*\* ?", "", text, flags=re.M).split())


def documented(text: str) -> dict[str, str]:
    """Each comment of a header, by the name that it precedes: `mip_x`, `mip_x.member`, `MIP_X`."""
    text = text.replace("\\\n", " ")
    text = re.sub(r'extern "C" \{|^#ifdef __cplusplus\n\}', "", text, flags=re.M)
    text = re.sub(
        r"^((?:(?:MIP_CHECKED )?static inline|MIP_INLINE|MIP_QUICK) [^{]*)\{.*?^\}", r"\1;", text, flags=re.M | re.S
    )
    found: dict[str, str] = {}
    scopes: list[str] = []
    doc = ""
    for token in TOKEN.finditer(text):
        if token["doc"] is not None:
            doc = plain(token["doc"])
            continue
        if token["macro"] or token["constant"]:
            found.setdefault(token["macro"] or token["constant"], doc)
        elif token["opened"] is not None:
            # An anonymous one: its members are those of the outer one.
            scopes.append(token["opened"] or (scopes[-1] if scopes else ""))
            found.setdefault(token["opened"], doc)
        elif token["closed"]:
            scopes.pop()
        elif token["statement"] and (name := declared(token["statement"])) and not is_forward(token["statement"]):
            found.setdefault(f"{scopes[-1]}.{name}" if scopes else name, doc)
        doc = ""
    assert not scopes
    return found


def is_forward(statement: str) -> bool:
    """A structure that is only declared: its comment is where its members are."""
    return re.fullmatch(r"\s*(?:struct|union) \w+\s*", statement) is not None


def declared(statement: str) -> str:
    """The name that a declaration declares: the one before its parameters or brackets."""
    pointer = re.search(r"\(\*(\w+)\)", statement)
    if pointer:
        return pointer[1]
    words = re.split(r"[(\[]", statement)[0].split()
    return words[-1].lstrip("*") if words else ""


@cache
def comments(spec: str) -> dict[str, str]:
    found: dict[str, str] = {}
    source = SPECS[spec][1] / "c/src"
    for path in sorted(source.rglob("*.h")):
        if not (ROOT / "runtime/c/src" / path.relative_to(source)).exists():
            found |= documented(path.read_text("utf-8"))
    return found


def said(facts: Iterable[describe.Fact]) -> list[str]:
    return [plain(describe.say(f.sentence, reference)) for f in facts]


def in_full(thing: m.Field | m.Type | m.EnumValue | m.Bits) -> list[str]:
    """The whole name of a thing that has a shorter one in C."""
    name = thing.full_name if isinstance(thing, m.Field) else thing.name
    return [f"Full name: {name}."] if getattr(thing, "short", None) else []


def prose(text: str, of: m.Model) -> str:
    """A text of the specification, with names of C for the fields that it names."""
    return describe.say(describe.prose(text, of), reference)


# --------------------------------------------------------------------------- what must be told of each thing


def wanted(of: m.Model) -> Iterator[tuple[str, list[str]]]:
    """The name that a comment precedes, and the texts that it must contain."""
    for f in (of.protocol.acknowledge, *of.fields):
        name = names.field_name(f)
        facts = [x for x in describe.in_code(f, of) if x.topic not in EVIDENCE]
        yield name, [f.title, prose(f.description, of), *said(facts), *describe.sources(f)]
        one = f.set and len(f.occurrences) == 1
        place = f"(0x{f.set:02X},0x{f.descriptor:02X})" if one else f"0x{f.descriptor:02X}"
        yield name, [f"{f.role} {place}.", *in_full(f)]
        yield from of_record(f, of)
        yield from of_arguments(f, of)
    for t in (of.protocol.function_selector, *of.all_types):
        if not isinstance(t, m.Vector):
            told = [prose(t.description, of), *said(describe.type_facts(t, of)), *describe.sources(t), *in_full(t)]
            whole = not isinstance(t, m.Enum) or names.is_enum(t)  # one that C cannot have is only constants
            yield names.type_name(t) if whole else names.constant(t, t.values[0]), told
        if isinstance(t, m.Struct):
            yield from of_record(t, of)
        elif isinstance(t, m.Enum):
            for v in t.values:
                yield names.constant(t, v), [prose(v.description, of), *said(describe.value(v, of)), *in_full(v)]
        elif isinstance(t, m.Bitfield):
            for b in t.bits:
                told = [prose(b.description, of), *said(describe.bits(b, of)), *in_full(b)]
                yield names.constant(t, b), told
                if members.has_accessor(b, t):
                    yield names.accessor(t, "get", b), told
    for d in of.devices:
        told = [d.title, prose(d.description, of), *said(describe.device(d, of)), *describe.sources(d)]
        yield f"mip_profile_{d.name}", told
    for x in of.families:
        for s in x.sets if len(x.sets) > 1 else ():
            told = [s.title, prose(s.description, of), *said(describe.uncertain(s, of))]
            yield names.set_constant(s), told


def of_arguments(f: m.Field, of: m.Model) -> Iterator[tuple[str, list[str]]]:
    """The units and ranges of each argument of a function, where a caller looks for them."""
    for name, given in [(c.name, c.parameters) for c in calls.calls(f, of)] if f.role == m.COMMAND else []:
        for p in given:
            told = [prose(p.description, of), *said(describe.parameter(p, f, of))]
            yield name, [f"- {names.argument_name(p.name)}:", *told]


def of_record(record: m.Field | m.Struct, of: m.Model) -> Iterator[tuple[str, list[str]]]:
    name = names.symbol(record)
    for p in record.parameters:
        told = [prose(p.description, of), *said(describe.parameter(p, record, of))]
        told += said(describe.case(c, p, record) for c in p.cases if c.parameter is None)
        if p not in members.stored(record):
            yield name, [f"- {p.name}:", *told]
            continue
        yield f"{name}.{names.member(p.name)}", told
        for c in p.cases:
            if c.parameter is not None:
                told = [prose(c.parameter.description or c.tag.description, of)]
                told += said([describe.case(c, p, record), *describe.parameter(c.parameter, record, of)])
                yield f"{names.union_name(p, names.union_owner(p, record, of))}.{names.member(c.parameter.name)}", told


@both
def test_every_fact_is_told(spec: str) -> None:
    of, found = model(spec), comments(spec)
    things = list(wanted(of))
    assert len(things) > 3 * len(of.fields)
    missing = [
        f"{name}: {text}"
        for name, texts in things
        for text in map(plain, texts)
        if name not in found or text not in found[name]
    ]
    assert not missing, "\n".join(missing[:20])


@both
def test_links_of_pages_lead_to_files(spec: str) -> None:
    """Of the examples, a library of other fields has none."""
    pages = [*folder(spec).rglob("*.md")]
    links = {
        page.parent / x for page in pages for x in re.findall(r"\]\((?!\w+:|#)([^)#\s]+)[)#]", page.read_text("utf-8"))
    }
    assert links and not [str(x) for x in links if not x.exists()]


@both
def test_headers_leave_what_is_not_certain_to_the_profiles(spec: str) -> None:
    """The devices that support a field would take more lines than all else; each file says where to find them."""
    of = model(spec)
    assert not [name for name, text in comments(spec).items() if "likely or assumed on" in text or "Confirmed" in text]
    for x in of.families:
        text = (SPECS[spec][1] / f"c/src/mip/{names.module(x.name)}.h").read_text("utf-8")
        assert ELSEWHERE in plain(text.partition("*/")[0])


@both
def test_everything_has_a_comment(spec: str) -> None:
    """Every function, structure, member, macro and value of every header; guards apart, and what every field has."""
    fields = [names.field_name(f) for f in (model(spec).protocol.acknowledge, *model(spec).fields)]
    common = {"MIP_FIELD", "MIP_FILL", "MIP_SEND", "MIP_CALL", "MIP_CALL_FOR", "MIP_CALL_WITH"}
    common |= {"MIP_COMMAND_REPLIES", "MIP_VALUE_NAME"}
    common |= {names.macro(f"{name}{end}") for name in fields for end in ("", "_descriptor")}
    common |= {f"{name}_{verb}_inline" for name in fields for verb in ("decode", "encode")}
    headers = sorted((SPECS[spec][1] / "c/src").rglob("*.h"))
    bare, count = [], 0
    for path in headers:
        found = documented(path.read_text("utf-8"))
        count += len(found)
        guard = re.compile(r"MIP_\w+_H")
        bare += [
            f"{path.name}: {name}"
            for name, doc in found.items()
            if not doc and not guard.fullmatch(name) and name not in common
        ]
    assert not bare, "\n".join(bare[:20])
    assert len(headers) > 20 and count > 10 * len(model(spec).fields)


@both
@heavy("doxygen")
def test_doxygen_has_nothing_to_complain_of(spec: str, tmp_path: Path) -> None:
    folder = tmp_path / "c"
    shutil.copytree(SPECS[spec][1] / "c", folder)
    done = subprocess.run([need("doxygen")], cwd=folder, capture_output=True, text=True)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    groups = (folder / "html/modules.html").read_text("utf-8")  # the main page is the README
    for x in model(spec).families:
        if x.fields:
            numbers = ", ".join(f"0x{s.number:02X}" for s in x.sets)
            assert html.escape(f"{x.title} ({numbers})") in groups
    assert "Add it to your project" in (folder / "html/index.html").read_text("utf-8")
    page = (folder / "html/core_8h.html").read_text("utf-8")
    assert all(name in page for name in ("mip_parser_flush", "mip_get_16", "MIP_ERROR_TRUNCATED"))


# --------------------------------------------------------------------------- how it is told


def test_words_of_c() -> None:
    """References are names of C."""
    found = comments("invented")
    assert found["mip_tools_settings.mode"] == (
        "What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read and apply. "
        "On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated."
    )
    assert "x: MIP_STATE_FLAGS_READY in valid_flags, y:" in found["mip_measurements_accel.scaled_accel"]
    assert found["mip_tools_status"].endswith(
        "Parameters without a member, on the wire only: - model: The model that the layouts belong to. Always 4711. "
        "- guide: Status"
    )
    assert "Deprecated: use mip_measurements_numbers instead." in found["mip_measurements_health"]
    gust = found["mip_measurements_gust"]
    assert (
        "mip_measurements_breeze has the same place." in gust and "see enum mip_mode and enum mip_tools_shape." in gust
    )
    ping = model("real").field("base.ping")
    assert reference(describe.Ref(ping, "base.ping")) == "mip_base_ping"


def test_the_text_of_a_family_and_its_sets() -> None:
    of = model("invented")
    tools = next(x for x in of.families if x.name == "tools")
    x = replace(tools, description="As `tools.ping`.", uncertain=("How `mode` is.",))
    told = ["@file", "Tools (0x01). As mip_tools_ping. Uncertain: How enum mip_mode is."]
    assert Comments(of).family(x) == [*told, ELSEWHERE]
    assert Comments(of).family(replace(x, fields=())) == [*told, ELSEWHERE]
    assert Comments(of).set(x.sets[0], x) == ["Descriptor set of these fields."]
    several = next(x for x in of.families if x.name == "measurements")
    assert Comments(of).family(several)[1].startswith("Measurements. ")
    assert Comments(of).set(several.sets[2], several) == [
        "Descriptor set: Copied measurements. All the fields of another set. Uncertain: Which device sends it."
    ]
    assert "Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET." in comments("invented")["mip_measurements_radio"]
