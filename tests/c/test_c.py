"""The C library as its users see it: compilers, constructors, accessors, client, linking."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import difficult_sets
import pytest
from c_build import FIRMWARE, HERE, SANITIZED, WARNINGS, archive, compiled, folder, headers, include, pages, run
from mipgen import cli
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.resolve.load import load_model
from mipgen.targets.c import direct, literals, members, names, runtime
from spec_defaults import filled
from support import ROOT, SPECS, heavy, model, need, sent, small, uses

COMPILERS = ("cc", pytest.param("clang", marks=heavy("clang")))
CPP = pytest.param("g++", marks=heavy("g++"))

both = pytest.mark.parametrize("spec", sorted(SPECS))
compilers = pytest.mark.parametrize("compiler", COMPILERS)


def written(path: Path, of: m.Model, checks: list[str], before: str = "") -> Path:
    """A program that makes these checks, with the headers of all families and of all tables; `before`: what they use.

    A compiler takes much longer for one long function than for many.
    """
    headers = [*(names.module(x.name) for x in of.families), "protocol"]
    headers += [f"extra/{name}" for name in ("registry", "reflect", "names", "profiles")]
    headers += [f"{names.module(x.name)}_inline" for x in of.families if any(map(direct.is_direct, x.fields))]
    headers.append("protocol_inline")
    includes = "".join(f'#include "mip/{name}.h"\n' for name in headers)
    parts = ["\n    ".join(checks[at : at + 20]) for at in range(0, len(checks), 20)]
    functions = "".join(f"static void checks_{i}(void) {{\n    {part}\n}}\n" for i, part in enumerate(parts))
    calls = "".join(f"    checks_{i}();\n" for i in range(len(parts)))
    main = f"int main(void) {{\n{calls}    return 0;\n}}\n"
    path.write_text(f'#include "check.h"\n{includes}{before}{functions}{main}')
    return path


def build(tmp: Path, compiler: str, spec: str, source: Path) -> Path:
    return compiled(tmp / source.stem, spec, compiler, source, *SANITIZED)


def unsanitized(tmp: Path, compiler: str, spec: str, source: Path) -> Path:
    """A program that only looks at constants: with the sanitizers, compiling it would take three times as long."""
    made = tmp / f"{source.stem}.o"
    run(need(compiler), "-std=c99", *WARNINGS, include(spec), f"-I{HERE}/unit", "-c", source, "-o", made)
    return compiled(tmp / source.stem, spec, compiler, made, *SANITIZED)


# --------------------------------------------------------------------------- sources


@small("headers of the real C library, one by one")
@pytest.mark.parametrize("compiler", ["cc", CPP])
def test_each_header_stands_alone(compiler: str, spec: str, tmp_path: Path) -> None:
    for header in (folder(spec) / "src/mip").rglob("*.h"):
        program = tmp_path / f"{header.stem}.{'cpp' if compiler == 'g++' else 'c'}"
        line = f'#include "{header.relative_to(folder(spec) / "src").as_posix()}"\n'
        program.write_text(f"{line}{line}int unused;\n")
    run(need(compiler), *WARNINGS, include(spec), "-fsyntax-only", *tmp_path.iterdir())


@both
@pytest.mark.parametrize("compiler", ["cc", CPP])
def test_all_headers_at_once(compiler: str, spec: str, tmp_path: Path) -> None:
    """mip/mip.h includes all but those in folders, and compiles as C99 and as C++11; the others compile with it."""
    wanted = {p.name for p in (folder(spec) / "src/mip").glob("*.h")} - {"mip.h"}
    assert set(re.findall('#include "mip/(.*)"', (folder(spec) / "src/mip/mip.h").read_text("utf-8"))) == wanted
    program = tmp_path / f"all.{'cpp' if compiler == 'g++' else 'c'}"
    program.write_text("".join(f'#include "{h}"\n' for h in ["mip/mip.h", *headers(folder(spec))]) + "int unused;\n")
    language = "-std=c++11" if compiler == "g++" else "-std=c99"
    run(need(compiler), language, *WARNINGS, include(spec), "-fsyntax-only", program)


@both
def test_only_the_promised_headers(spec: str) -> None:
    allowed = {"<stdbool.h>", "<stddef.h>", "<stdint.h>", "<string.h>"}
    for path in folder(spec).rglob("src/mip/**/*.[ch]"):
        text = path.read_text("utf-8")
        if path.name == "export.h":  # the only place for attributes, for each compiler that has them
            text = text.replace("__attribute__", "")
        vectors = {"<emmintrin.h>"} if path.name == "checksum.h" else set()  # a header of compilers
        assert set(re.findall(r"#include (<.*>)", text)) <= allowed | vectors, path
        assert not re.search(r"\b(malloc|calloc|realloc|free|printf|abort|assert)\(|__attribute__|#pragma", text), path
        # Members have a fixed width, except the outcome of a call.
        assert not re.search(r"^ +enum (?!mip_outcome )\w+ \w+(\[\d+\])?;", text, re.M), path


def test_files_of_two_versions_do_not_mix(tmp_path: Path) -> None:
    shutil.copytree(folder("invented") / "src", tmp_path / "src")
    constants = tmp_path / "src/mip/constants.h"
    constants.write_text(re.sub(r"(#define MIP_VERSION_NUMBER) \d+", r"\1 1", constants.read_text()))
    (tmp_path / "user.c").write_text('#include "mip/tools.h"\n')
    done = subprocess.run(
        [need("cc"), f"-I{tmp_path}/src", "-fsyntax-only", str(tmp_path / "user.c")],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode != 0 and "have different versions" in done.stderr


def test_names_of_the_core_are_taken() -> None:
    """Every macro, type, constant and function of the headers that are the same for all specifications, as the compiler
    lists them, and every name that a program finds in the namespace of C++."""
    source = folder("real") / "src"
    include = [f"-include{name}" for name in headers(ROOT / "runtime/c")]
    text = run(need("cc"), "-std=c99", "-E", "-dD", f"-I{source}", *include, "-x", "c",
               "/dev/null")  # fmt: skip
    parts = re.split(r"^# \d+ ", text, flags=re.M)
    own = [p.partition("\n")[2] for p in parts if re.match(rf'"{source}/mip/(?!types|protocol)', p)]
    found = set(re.findall(r"\bmip_\w+", " ".join(own))) - {"mip_ack_code"}
    found |= set(re.findall(r"^#define (MIP_\w+) \S", "\n".join(own), re.M))
    assert len(found) > 200 and found - set(runtime.runtime_names()) == set()
    assert {"to_string", "basic_result", "print_to", "detail", "layout", "outcome"} <= runtime.in_namespace()
    assert not {"value", "data", "type", "Response", "count"} & runtime.in_namespace()


#: Names that platforms define as macros with arguments.
FUNCTIONS = """abs bit bitClear bitRead bitSet bitWrite check check_noerr constrain container_of degrees highByte
    interrupts isfinite isinf isnan likely lowByte major makedev map max min minor noInterrupts radians require
    require_noerr round signbit sq str swap unlikely verify xstr T_ N_ ARRAY_SIZE BIT BIT_MASK CONTAINER_OF F LOG
    UNUSED RGB MIN MAX ALIGN ASSERT SWAP"""
#: Names that they define as macros without arguments.
OBJECTS = """far i386 interface linux near nil pascal small st_atime sun unix ADC1 Above ALWAYS API Always B0 B1 Below
    BITS BOOL BUFSIZ BUSY Bool CHANGE CLOCK CONST DEBUG DEFAULT DEG_TO_RAD DELETE DISABLE DISPLAY DMA DOMAIN ENABLE EOF
    ERROR EXPORT EXTERNAL FAIL FALLING FALSE FATAL GPIO GPIOA HIGH HUGE_VAL I IDLE IN INFINITY INFO INLINE INPUT
    INTERNAL IO LOW MASK M_E M_PI NAN NIL NO NO_ERROR NONE Never None OK OPTIONAL OUT OUTPUT OVERFLOW PACKED PASS PI
    PLOSS PORTA PORTB RAD_TO_DEG READ READY RESET RISING RTC SERIAL SET SHIFT SING SPI1 STATIC STRICT Status Success
    THIS TIM1 TIMEOUT TLOSS TRACE TRUE UART UNDERFLOW USART1 Unsorted VOID WARN WDT WRITE YES GetMessage SendMessage
    GetObject DrawText GetCurrentTime Yield _A _B _C _L _N _P _S _U _X _Y"""


@pytest.mark.parametrize(
    ("compiler", "header"), [("cc", "mip.h"), pytest.param("g++", "cpp/mip.hpp", marks=uses("g++"))]
)
def test_headers_do_not_use_names_of_macros(compiler: str, header: str, tmp_path: Path) -> None:
    """Of platforms: Arduino, Windows, macOS, X11, Linux, C libraries."""
    functions, objects = FUNCTIONS.split(), OBJECTS.split()
    assert len(functions) + len(objects) >= 130
    needed = "iterator new optional ostream string_view type_traits"
    needed = "string stdbool stddef stdint" if header == "mip.h" else needed
    text = "".join(f"#include <{name}{'.h' if header == 'mip.h' else ''}>\n" for name in needed.split())
    text += "".join(f"#undef {name}\n#define {name}(...) @ {name}\n" for name in functions)
    text += "".join(f"#undef {name}\n#define {name} @ {name}\n" for name in objects)
    program = tmp_path / ("program.c" if header == "mip.h" else "program.cpp")
    more = "line.h" if header == "mip.h" else "extra/ostream.hpp"
    program.write_text(f'{text}#include "mip/{header}"\n#include "mip/{more}"\nint unused;\n')
    assert (folder("real") / "src/mip" / header).exists()
    includes = (include("real"), f"-I{folder('real')}/ports")
    run(need(compiler), "-std=c99" if header == "mip.h" else "-std=c++17", *includes, "-fsyntax-only", program)


# --------------------------------------------------------------------------- constructors


def sample(p: m.Parameter, values: dict[str, Any], case: int) -> Any:
    """A value that differs from zero; `case`: which alternative of unions and enumerations."""
    if p.struct:
        return record(p.struct.parameters, p.struct.parameters, case)
    if p.union:
        chosen = (c.parameter for c in p.cases if c.parameter and c.tag.value == values[p.union.tag])
        return {q.name: sample(q, {}, case) for q in chosen}
    if p.kind == "bits":
        return list(range(1, p.size + 1))
    if p.kind == "text":
        return "Text of a device"[: p.count or 5].ljust(p.count or 5, "x")
    if p.kind == "array":
        return [sample(p.item, {}, case + i) for i in range(p.count or 2)]
    if isinstance(p.named, m.Enum):
        return p.named.values[case % len(p.named.values)].value
    return {4: "0x3fc00000", 8: "0x3ff8000000000000"}[p.size] if p.scalar.kind == "float" else 1 + case


def record(some: Iterable[m.Parameter], parameters: tuple[m.Parameter, ...], case: int) -> dict[str, Any]:
    """Values of some of the parameters of a record."""
    values: dict[str, Any] = {}
    for p in some:
        if p.constant is None:
            values[p.name] = 2 if p.counts else sample(p, values, case)
    for p in parameters:
        if p.name in values and isinstance(p.element, m.Scalar) and p.element.kind == "char" and p.counts is None:
            for q in parameters:
                if q.counts == p.name:
                    values[q.name] = len(values[p.name])
        if p.name in values and p.reserved is not None:
            values[p.name] = sent(p)
    return values


def constructed(of: m.Model) -> Iterator[tuple[m.Field, Any, dict[str, Any]]]:
    """Every constructor with values for its arguments."""
    for f in of.fields:
        for made in members.constructors(f):
            required = f.required(made.function.value if made.function else None)
            there = (*f.always, *(p for g in f.groups if g.last <= required for p in g.parameters))
            cases = max([len(p.cases) for p in f.parameters] + [1])
            for case in range(cases):
                values = record(there, f.parameters, case)
                if made.function:
                    values["function"] = made.function.value
                yield f, made, values


def given(p: m.Parameter) -> str:
    """A member of the structure `x` as an argument of a constructor."""
    name = names.member(p.name)
    if p.length == "rest":
        return f"x.{name}_count, x.{name}"
    pointer = p.element is None or (p.length is None and names.is_struct(p.element))
    return f"&x.{name}" if pointer else f"x.{name}"


# --------------------------------------------------------------------------- direct decoders


def direct_check(f: m.Field, of: m.Model) -> str:
    """Random data of every length, and of other fields, by the table and directly: the same result, the same bytes."""
    last = f.max_size + 2  # another layout of the descriptor may be longer
    decodes = range(f.min_size, last + 1)[: max(0, of.sizes(f).stop - f.min_size)]
    name = names.field_name(f)
    return f"""for (size_t size = 0; size <= {last}U; size++) {{
        struct {name} a, b;
        struct mip_field field = random_field(size, 0x{f.set:02X}, 0x{f.descriptor:02X});
        memset(&a, 0x55, sizeof(a));
        memset(&b, 0xAA, sizeof(b));
        const mip_error error = {name}_decode(&a, &field);
        CHECK({name}_decode_inline(&b, &field) == error && memcmp(&a, &b, sizeof(a)) == 0);
        CHECK((error == MIP_OK) == (size >= {decodes.start} && size < {decodes.stop}));
        memset(&b, 0xAA, sizeof(b));
        if (error != MIP_OK) {{
            CHECK({name}_decode_inline(&b, &field) == error && memcmp(&a, &b, sizeof(a)) == 0);
            continue;
        }}
        for (size_t capacity = 6; capacity < MIP_MAX_PACKET; capacity += 1 + capacity / 30) {{
            uint8_t first[MIP_MAX_PACKET] = {{0}}, second[MIP_MAX_PACKET] = {{0}};
            struct mip_builder p, q;
            const uint8_t set = 0x{ {0: 1, 0xFF: 0x80}.get(f.set, f.set):02X};
            CHECK(mip_builder_start(&p, first, capacity, set) == MIP_OK);
            CHECK(mip_builder_start(&q, second, capacity, set) == MIP_OK);
            while ({name}_encode(&a, &p) == MIP_OK) {{
                CHECK({name}_encode_inline(&a, &q) == MIP_OK && p.length == q.length);
            }}
            CHECK({name}_encode_inline(&a, &q) == MIP_ERROR_LENGTH && p.length == q.length);
            CHECK(memcmp(first, second, p.length) == 0);
            CHECK(p.length == 4 || memcmp(first + 6, field.data, {f.min_size}) == 0);
        }}
    }}
"""


RANDOM_FIELD = """
static struct mip_field random_field(size_t size, uint8_t set, uint8_t descriptor) {
    static uint8_t data[MIP_MAX_FIELD_DATA];
    static uint32_t state = 1;
    for (size_t i = 0; i < size; i++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        data[i] = (uint8_t)(state >> 24);
    }
    const struct mip_field field = {data, (uint8_t)size, set == 0 ? 1 : set, descriptor};
    return field;
}
"""


@small("programs of the real C library")
@compilers
def test_every_direct_decoder(compiler: str, spec: str, tmp_path: Path) -> None:
    of = model(spec)
    fields = [f for f in (of.protocol.acknowledge, *of.fields) if direct.is_direct(f)]
    never_varies = [f for f in of.fields if f.min_size == f.max_size > 0]
    never_varies = [f for f in never_varies if not any(p.constant is not None for p in f.parameters)]
    assert len(fields) >= len(never_varies) > 0
    program = written(tmp_path / "direct.c", of, [direct_check(f, of) for f in fields], RANDOM_FIELD)
    run(build(tmp_path, compiler, spec, program))


@small("programs of the real C library")
def test_every_constructor(spec: str, tmp_path: Path) -> None:
    """Builds the shortest form that the reference builds from the same values."""
    of, body = model(spec), []
    for f, made, values in constructed(of):
        name, data = names.field_name(f), codec.encode(f, values).hex()
        arguments = ", ".join(given(p) for p in made.parameters)
        body.append(f"""{{
        struct {name} x;
        struct mip_field field = field_of(0x{f.set:02X}, {names.macro(name)}_DESCRIPTOR, "{data}");
        CHECK({name}_decode(&x, &field) == MIP_OK);
        struct {name} v;
        CHECK({name}_{made.name}({", ".join(["&v", *filter(None, [arguments])])}) == &v);
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0x{f.set:02X}) == MIP_OK);
        CHECK({name}_encode(&v, &b) == MIP_OK && strcmp(only_field(&b), "{data}") == 0);
    }}
""")
    commands = [f for f in of.fields if f.role == m.COMMAND]
    wanted = sum(len(f.functions) or any(p.constant is None for p in f.parameters) for f in commands)
    assert len(body) >= wanted > len(commands) / 2
    variables = "static uint8_t buffer[MIP_MAX_PACKET];\nstatic struct mip_builder b;\n"
    run(build(tmp_path, "cc", spec, written(tmp_path / "constructors.c", of, body, variables)))


def answered(of: m.Model) -> Iterator[tuple[m.Field, m.Field, dict[str, Any]]]:
    """Every command whose response contains what a write needs, with that response and values for both."""
    for f, made, values in constructed(of):
        if made.function and made.function.name == "write" and len(of.responses(f)) == 1:
            response = of.responses(f)[0]
            same = {p.name for p in response.parameters if p.constant is None} >= {p.name for p in made.parameters}
            if same and made.parameters and response.command == f.name:
                yield f, response, values


@small("programs of the real C library")
def test_what_was_read_is_written_back(spec: str, tmp_path: Path) -> None:
    """From a response of the reference, the command that the reference encodes from the same values."""
    of, body = model(spec), []
    for f, response, values in answered(of):
        name, r = names.field_name(f), names.field_name(response)
        read = {**record(response.parameters, response.parameters, 0), **values}
        data = codec.encode(response, {p.name: read[p.name] for p in response.parameters if p.name in read}).hex()
        body.append(f"""{{
        struct {r} r;
        struct {name} v;
        struct mip_field field = field_of(0x{f.set:02X}, {names.macro(r)}_DESCRIPTOR, "{data}");
        CHECK({r}_decode(&r, &field) == MIP_OK);
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0x{f.set:02X}) == MIP_OK);
        CHECK({name}_encode({name}_write_from(&v, &r), &b) == MIP_OK);
        CHECK(strcmp(only_field(&b), "{codec.encode(f, values).hex()}") == 0);
    }}
""")
    assert len(body) >= (80 if spec == "real" else 1)
    variables = "static uint8_t buffer[MIP_MAX_PACKET];\nstatic struct mip_builder b;\n"
    run(build(tmp_path, "cc", spec, written(tmp_path / "written.c", of, body, variables)))


# --------------------------------------------------------------------------- bitfields


def bitfields(of: m.Model) -> list[m.Bitfield]:
    return [t for t in of.all_types if isinstance(t, m.Bitfield)]


def accessor_checks(t: m.Bitfield) -> Iterator[str]:
    """Sets, clears and reads every bit, from all zeros and from all ones."""
    name, ones = names.type_name(t), (1 << 8 * t.size) - 1
    for b in t.bits:
        if t.scalar:
            c = names.constant(t, b)
            start = f"{name} f = ({name})UINT64_C"
            for end, before, after in (("set", 0, b.mask), ("set", ones, ones), ("clear", ones, ones & ~b.mask)):
                has = "" if after & b.mask else "!"
                yield (
                    f"{{ {start}({before}); mip_{end}_{8 * t.size}(&f, {c}); "
                    f"CHECK(f == UINT64_C({after}) && {has}mip_has(f, {c})); }}"
                )
            if b.width > 1:  # all of the bits, not any
                yield f"{{ {start}({ones & ~(1 << b.last)}); CHECK(!mip_has(f, {c}) && (f & {c}) != 0); }}"
        if t.scalar and not members.has_accessor(b, t):
            continue
        most = (1 << b.width) - 1
        for start in (0, ones):
            for value in {0, 1, most, most >> 1}:
                result = start & ~b.mask | value << b.first
                shown = f"UINT64_C({value})"
                if t.scalar:
                    put, take = (names.accessor(t, verb, b) for verb in ("set", "get"))
                    kind = members.bits_type(b)
                    yield (
                        f"{{ {name} f = (({name})UINT64_C({start})); {put}(&f, ({kind}){shown}); "
                        f"CHECK(f == UINT64_C({result}) && {take}(f) == {shown}); }}"
                    )
                else:
                    expected = ", ".join(str(x) for x in result.to_bytes(t.size, "little"))
                    c = names.constant(t, b)
                    yield (
                        f"{{ struct {name} f; static const uint8_t e[] = {{{expected}}}; memset(&f, {start & 255}, "
                        f"sizeof(f)); mip_set_bits(f.bytes, {c}, {shown}); "
                        f"CHECK(memcmp(f.bytes, e, sizeof(e)) == 0 && mip_get_bits(f.bytes, {c}) == {shown}); }}"
                    )


@small("programs of the real C library")
@compilers
def test_every_bit(compiler: str, spec: str, tmp_path: Path) -> None:
    of = model(spec)
    checks = [check for t in bitfields(of) for check in accessor_checks(t)]
    assert len(checks) > 2 * sum(len(t.bits) for t in bitfields(of)) - 1
    run(unsanitized(tmp_path, compiler, spec, written(tmp_path / "bits.c", of, checks)))


@small("programs of the real C library")
def test_every_constant(spec: str, tmp_path: Path) -> None:
    of = model(spec)
    types = [of.protocol.function_selector, *of.all_types]
    checks = [
        f"{{ {'enum ' + names.type_name(t) if names.is_enum(t) else names.c_type(t)} e = {names.constant(t, v)}; "
        f"CHECK((uint64_t)e == UINT64_C({v.value})); "
        f'CHECK(strcmp({names.type_name(t)}_name(e), "{v.name}") == 0); }}'
        for t in types
        if isinstance(t, m.Enum)
        for v in t.values
    ]
    for f in of.fields:
        name = names.macro(names.field_name(f))
        checks.append(f"CHECK({name}_DESCRIPTOR == {f.descriptor});")
    checks += [f"CHECK({names.macro(f'mip_{s.name}')}_SET == {s.number});" for s in of.sets]
    run(unsanitized(tmp_path, "cc", spec, written(tmp_path / "constants.c", of, checks)))


# --------------------------------------------------------------------------- tables


def device_checks(d: m.Device, of: m.Model) -> Iterator[str]:
    name = f"mip_profile_{d.name}"
    yield f'CHECK(mip_profile_find("{d.id}") == &{name} && {name}.model_number == {d.model_number or 0});'
    yield f"CHECK({name}.field_count == {len(d.supports)} && {name}.rate_count == {len(d.base_rates)});"
    for text in (d.title, *d.also):
        yield f'CHECK(mip_profile_find("{text}") == &{name});'
    if d.model_number is not None:
        yield f"CHECK(mip_profile_by_model({d.model_number}) == &{name});"
    yield f'CHECK({name}.generation == {d.generation or 0} && strcmp({name}.manual, "{d.manual or ""}") == 0);'
    yield f"CHECK({name}.also_count == {len(d.also)} && {name}.incomplete_count == {len(d.incomplete)});"
    for i, text in enumerate(d.incomplete):
        yield f"CHECK(strcmp({name}.incomplete[{i}], {literals.string(text)}) == 0);"
    yield f"CHECK({name}.refused_count == {len(d.refuses)});"
    for s in (*d.supports, *d.refuses):
        found = f"mip_profile_find_field(&{name}, {s.set}, {s.field.descriptor})"
        answer = f"MIP_SUPPORT_{s.evidence.answer.upper()}"
        yield f"CHECK(mip_profile_support(&{name}, {s.set}, {s.field.descriptor}) == {answer});"
        why = literals.string(describe.why(s.evidence, of))
        yield f"CHECK({found}->evidence->answer == {answer} && strcmp({found}->evidence->why, {why}) == 0);"
        yield f'CHECK(strcmp({found}->functions, "{m.letters(s.functions)}") == 0);'
    for r in d.base_rates:
        yield f"CHECK(!(mip_profile_base_rate(&{name}, {r.set.number}) < {r.hertz}));"
        yield f"CHECK(!(mip_profile_base_rate(&{name}, {r.set.number}) > {r.hertz}));"
    for s in d.supports:
        firmware = f"mip_profile_firmware_of(&{name}, {s.set}, {s.field.descriptor})"
        yield f'CHECK(strcmp({firmware}, "{s.firmware}") == 0);' if s.firmware else f"CHECK({firmware} == NULL);"
    readings = [v for v in d.variants if v.variant.type is not None]
    yield f"CHECK({name}.reading_count == {len(readings)});"
    for v in readings:
        assert v.variant.type is not None
        yield f'CHECK(strcmp(mip_profile_reading_of(&{name}, "{v.path}"), "{v.variant.type.full_name}") == 0);'


@small("programs of the real C library")
def test_every_row_of_the_tables(spec: str, tmp_path: Path) -> None:
    """Links and device profiles, each against the specification; of parameters, test_c_print.py sees every row."""
    of = model(spec)
    every = [of.protocol.acknowledge, *of.fields]
    checks = [f"CHECK(mip_reflection_count == {len(every)} && mip_registry_size == {len(every)});"]
    for f in of.fields:
        links = of.responses(f) if f.role == m.COMMAND else of.commands(f)
        entry = f'mip_registry_by_name("{f.name_in(f.set)}", NULL)'
        checks.append(f"CHECK({entry}->link_count == {len(links)});")
        for i, other in enumerate(links):
            checks.append(f"CHECK(mip_registry_link({entry}, {i})->codec == &{names.field_name(other)}_codec);")
    checks += [check for d in of.devices for check in device_checks(d, of)]
    run(unsanitized(tmp_path, "cc", spec, written(tmp_path / "tables.c", of, checks)))


# --------------------------------------------------------------------------- sets


def packet_sets(f: m.Field) -> list[tuple[int, m.Occurrence]]:
    """Descriptor sets of packets with a field, and where it occurs."""
    return [(s, next((o for o in f.occurrences if o.set == s), f.occurrences[0])) for s in f.sets]


@small("programs of the real C library")
def test_every_field_in_each_of_its_sets(spec: str, tmp_path: Path) -> None:
    """Its key there; and that it is decoded and encoded directly in these sets only, as by the table in the
    conformance suite."""
    of = model(spec)
    every = [of.protocol.acknowledge, *of.fields]
    checks = []
    for f in every:
        name, sets = names.field_name(f), packet_sets(f)
        for s, _ in sets if f.everywhere is None else (sets[0], sets[-1]):
            key = f"{names.macro(name)}({s})" if len(f.occurrences) > 1 else names.macro(name)
            at = f"{{NULL, 0, {s}, {f.descriptor}}}"
            checks.append(f"{{ const struct mip_field at = {at}; CHECK({key} == mip_field_key(&at)); }}")
        if direct.is_direct(f):
            checks.append(f"""for (unsigned set = 1; set < 0xFF; set++) {{
        static const uint8_t sets[] = {{{", ".join(str(s) for s, _ in sets)}}};
        static struct {name} v;
        static const uint8_t data[MIP_MAX_FIELD_DATA] = {{0}};
        uint8_t buffer[MIP_MAX_PACKET];
        struct mip_builder b;
        const struct mip_field field = {{data, sizeof(data), (uint8_t)set, {f.descriptor}}};
        const bool right = memchr(sets, (int)set, sizeof(sets)) != NULL;
        CHECK(mip_codec_belongs(&{name}_codec, (uint8_t)set) == right);
        CHECK(({name}_decode_inline(&v, &field) == MIP_ERROR_SET) == !right);
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), (uint8_t)set) == MIP_OK);
        CHECK({name}_encode_inline(&v, &b) == (right ? MIP_OK : MIP_ERROR_SET));
    }}""")
    assert sum(len(f.occurrences) > 1 for f in every) >= 10
    run(build(tmp_path, "cc", spec, written(tmp_path / "sets.c", of, checks)))


# --------------------------------------------------------------------------- linking


def symbols(program: Path) -> set[str]:
    return {line.split()[-1] for line in run(need("nm"), "--defined-only", program).splitlines()}


def test_a_small_program_stays_small(tmp_path: Path) -> None:
    program = tmp_path / "small"
    library = archive("invented", "cc", *FIRMWARE, "-O2")
    command = [need("cc"), *FIRMWARE, include("invented"), HERE / "unit/small.c", library, "-o", program]
    # Any linker takes only the objects that are needed: no registry, no tables, no client, no other sets.
    run(*command)
    found = {name for name in symbols(program) if "mip" in name}
    objects = ("mip_measurements_", "mip_parser_", "mip_walk_", "mip_packet_", "mip_builder_", "mip_checksum",
               "mip_codec_", "mip_decode", "mip_encode", "mip_program", "mip_layout", "mip_move",
               "mip_copy", "mip_field_", "mip_get_bits", "mip_set_bits",
               "mip_set_has", "mip_sum", "mip_version", "mip_widen", "mip_narrow")  # fmt: skip
    assert {n for n in found if not n.startswith(objects)} == set()
    # One that removes uncalled functions leaves out the interpreter of other layouts, too.
    run(*command, "-Wl,--gc-sections")
    assert {n for n in symbols(program) if n.startswith("mip_")} <= {  # compilers inline some of them
        "mip_checksum", "mip_codec_belongs", "mip_codec_matches", "mip_decode", "mip_decode_same", "mip_parser_init",
        "mip_measurements_accel_codec", "mip_parser_examine", "mip_parser_next", "mip_set_has",
    }  # fmt: skip


def test_readme_shows_programs_that_run(tmp_path: Path) -> None:
    blocks = re.findall(r"```c\n(.*?)```", pages("real"), re.S)
    example = (folder("real") / "quickstart.c").read_text("utf-8").partition("*/\n")[2].rstrip()
    first, blocks = blocks[0].rstrip(), blocks[1:]  # the first one runs in test_c_ports
    assert (folder("real") / "examples/stream.c").read_text("utf-8").partition("*/\n")[2].rstrip() == first
    assert blocks[0].rstrip() == example and len(blocks) == 11
    outside = (
        "uint32_t milliseconds(void);\nvoid transmit(const uint8_t *bytes, size_t size);\n"
        "size_t ring_end(void);\nsize_t receive(uint8_t *bytes, size_t size);\n"
        "void handle(const struct mip_packet *packet);\n"
        "void plot(int receiver, double latitude, double longitude);\n"
        "void show(const float accel[3], uint32_t arrived);\nvoid report(const char *outcome, const char *reason);\n"
    )
    for i, block in enumerate(blocks[1:], 1):  # functions, for which some compilers require prototypes
        includes, _, code = block.rpartition("#include")
        header, _, rest = code.partition("\n")
        prototypes = "".join(
            f"{head};\n" for head in re.findall(r"^(\w[^;{}#]*\)) \{", rest, re.M) if "static" not in head
        )
        program = tmp_path / f"block_{i}.c"
        program.write_text(f"{includes}#include{header}\n{outside}{prototypes}{rest}")
        run(need("cc"), "-std=c99", *WARNINGS, "-Wmissing-prototypes", include("real"), "-fsyntax-only", program)


def long_names(folder: Path) -> set[str]:
    """The identifiers that are the same in the characters that C99 compares."""
    found = set()
    for path in sorted((folder / "src/mip").rglob("*.[ch]")):
        code = re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\])*"', "", path.read_text("utf-8"), flags=re.S)
        found |= set(re.findall(rf"\b[A-Za-z_]\w{{{names.GRAMMAR.longest},}}", code))
    begins = Counter(name[: names.GRAMMAR.longest] for name in found)
    return {name for name in found if begins[name[: names.GRAMMAR.longest]] > 1}


@both
def test_names_are_as_long_as_c_permits(spec: str) -> None:
    assert long_names(folder(spec)) == set()


#: What neither specification has: layouts that only their sizes tell apart, an enumeration that a compiler makes
#: smaller than it is on the wire, and parameters with the names of arguments of generated functions.
RARE = """set: 0x6E
name: rare
title: Rare
description: D.
types:
  wide: {enum: u16, values: {one: 1, two: 2}}
  some: {bitfield: u8, bits: {one: 0}}
fields:
  - command: 0x01
    name: state
    title: State
    description: D.
    parameters: [{name: wanted, type: wide}]
    responses:
      - {response: 0x81, name: state_old, parameters: [{name: a, type: u8}]}
      - {response: 0x81, name: state_new, parameters: [{name: a, type: u8}, {name: b, type: u16}]}
  - command: 0x02
    name: names
    title: Names
    description: D.
    functions: WR
    parameters:
      - {name: command, type: u8, for: WR}
      - {name: device, type: u8, for: W}
      - {name: response, type: u16, count: device, for: W}
      - {name: value, type: char, count: 4, for: W}
      - {name: number, type: some, for: W}
    responses: [{response: 0x82, name: response, parameters: as_command}]
"""
RARE_CHECKS = [
    "{ struct mip_rare_state s; mip_rare_state_make(&s, 0x0102); CHECK(s.wanted == 0x0102); }",
    """{
        struct mip_rare_names made;
        const uint16_t numbers[] = {7, 8};
        mip_rare_names_write(&made, 5, 2, numbers, "text", 1);
        CHECK(made.command == 5 && made.device == 2 && made.response[1] == 8 && strcmp(made.value, "text") == 0);
    }""",
]


@pytest.mark.parametrize("compiler", ["cc", CPP])
def test_awkward_names_and_rare_shapes(compiler: str, tmp_path: Path) -> None:
    """Keywords as names, text and arrays to the end in commands, very long names, and RARE."""
    spec = tmp_path / "spec"
    shutil.copytree(ROOT / "tests/invented/spec", spec)
    for name, text in {**difficult_sets.files(), "rare.yaml": filled(RARE)}.items():
        (spec / "sets" / name).write_text(text, "utf-8")
    assert cli.main(["generate", "--spec", str(spec), "--out", str(tmp_path / "out"), "--target", "c"]) == 0
    where, of = tmp_path / "out/c", load_model(spec)
    assert long_names(where) == set()
    checks = [direct_check(of.field(f"rare.{name}"), of) for name in ("state_old", "state_new")]
    headers = "".join(f'#include "mip/{p.name}"\n' for p in sorted((where / "src/mip").glob("*_commands.h")))
    program = written(tmp_path / "rare.c", of, [*checks, *RARE_CHECKS], headers + RANDOM_FIELD)
    sources = [program, *sorted((where / "src/mip").glob("*/*.c"))]
    if compiler == "g++":
        run(need("g++"), "-std=c++11", "-x", "c++", *WARNINGS, f"-I{where}/src", "-fsyntax-only", *sources[1:])
        program.with_suffix(".cpp").write_text('#include "mip/cpp/rare_commands.hpp"\n')
        run(need("g++"), "-std=c++17", *WARNINGS, f"-I{where}/src", "-fsyntax-only", program.with_suffix(".cpp"))
    else:
        run(need("cc"), "-std=c99", "-fshort-enums", *WARNINGS, f"-I{where}/src", f"-I{HERE}/unit", *sources,
            "-o", tmp_path / "rare")  # fmt: skip
        run(tmp_path / "rare")
