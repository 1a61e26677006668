"""The interface of a release as text, for each binding and the wire: a line for each symbol, member and value.

    make interface      writes interface/VERSION/ when a version is released
    make check          lists what has changed in the sources since, and checks that the version reflects it

What a binding has for a field follows from the field and the target. So the wire is complete, and so is what every
program has in common; of the rest, there is what becomes of a few fields and types that have every form (`SAMPLES`).

The lines are read from the output, whose form the formatters decide, so that finished source and the output of
templates are treated alike. Comments, bodies of functions and private names are not part of the interface.

`tests/release/test_interface.py` breaks each binding.
"""

from __future__ import annotations

import argparse
import ast
import json
import re
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "interface"


def main() -> int:
    parser = argparse.ArgumentParser(prog="make interface")
    parser.add_argument("--check", action="store_true", help="compare with what is kept, and write nothing")
    parser.add_argument("--out", type=Path, default=ROOT / "generated", help="the output of the generator")
    parser.add_argument("--kept", type=Path, default=KEPT)
    options = parser.parse_args()
    version = json.loads((options.out / "json/mip.json").read_text("utf-8"))["version"]
    if options.check:
        return check(options.out, options.kept, version)
    write(options.out, options.kept / version)
    return 0


#: Of the generated part of each binding: fields with numbers, counted lists, unions and bits, a device, an enumeration.
SAMPLES = (
    "scaled_accel", "message_format", "event_action", "comm_speed", "gps_timestamp", "gx5_15", "filter_state",
)  # fmt: skip


def write(out: Path, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, lines in interfaces(out).items():
        (folder / f"{name}.txt").write_text("\n".join([*lines, ""]), "utf-8")


def interfaces(out: Path) -> dict[str, list[str]]:
    return {"wire": sorted(set(wire(out)))} | {
        name: sorted({lasting(line) for file, line in of(out) if is_common(out, file) or is_sample(line)})
        for name, of in BINDINGS.items()
    }


def lasting(line: str) -> str:
    """The line without the version, and without the items of lists that get more with devices and clocks."""
    line = re.sub(r"(\b(?:MIP_)?VERSION(?:_NUMBER|: &str)?)[ =]+[\d.\"']+$", r"\1", line)
    return re.sub(r"(\b(?:ALL|BAUD_RATES): &[^=]*) = .*", r"\1", line)


def is_common(out: Path, file: str) -> bool:
    """Is it no file whose contents repeat for each field, type or device?"""
    sets = {s["name"] for s in model(out)["sets"]}
    parts = {re.sub(r"^mip_|(_commands|_inline|_valid)?(\..*)?$", "", part) for part in file.split("/")}
    return not parts & (sets | {"types", "devices", "profiles"})


def is_sample(line: str) -> bool:
    """Does it name a sample, in the case of any language?"""
    return any(name.replace("_", "") in line.replace("_", "").lower() for name in SAMPLES)


@cache
def model(out: Path) -> Any:
    return json.loads((out / "json/mip.json").read_text("utf-8"))


def check(out: Path, kept: Path, version: str) -> int:
    """Prints what was added and removed since the release before this version, and since this one, if its interface is
    kept; 1 if the version is too low for that."""
    releases = {numbers(folder.name): folder for folder in kept.glob("*/")}
    if releases and numbers(version) < max(releases):
        print(f"make: version {version} is lower than one in {kept.name}/", file=sys.stderr)
        return 1
    before = sorted(x for x in releases if x < numbers(version))[-1:]
    compared = [releases[x] for x in [*before, numbers(version)] if x in releases]
    now = interfaces(out) if compared else {}
    return max((since(folder, now, version) for folder in compared), default=0)


def since(release: Path, now: dict[str, list[str]], version: str) -> int:
    """Compares with one release."""
    status = 0
    for path in sorted(release.glob("*.txt")):
        before = path.read_text("utf-8").splitlines()
        gone, new = (
            [x for x in a if x not in b] for a, b in ((before, set(now[path.stem])), (now[path.stem], set(before)))
        )
        for sign, lines in (("-", gone), ("+", new)):
            for line in lines:
                print(f"{path.stem}: {sign} {line}")
        if raised(release.name, version) < (2 if gone else 1 if new else 0):
            status = 1
            print(
                f"make: {path.stem}: since {release.name}, lines of the interface gone: {len(gone)}, new: {len(new)}; "
                f"version {version} is too low for that, raise it in spec/protocol.yaml (docs/versions.md)",
                file=sys.stderr,
            )
    return status


def numbers(version: str) -> tuple[int, ...]:
    return tuple(int(x) for x in version.split("."))


def raised(old: str, new: str) -> int:
    """2 for a major version, 1 for a minor one, 0 for a patch; before 1.0.0, one number further to the right."""
    before, after = numbers(old), numbers(new)
    first = next((i for i in range(3) if after[i] != before[i]), 3)
    return max(0, 2 - first + (before[0] == 0 and first > 0))


# ------------------------------------------------------------------- the wire


def wire(out: Path) -> Iterator[str]:
    for s in model(out)["sets"]:
        yield f"set {s['name']} 0x{s['number']:02X} {s['family']}"
    for t in model(out)["types"]:
        yield f"{t['kind']} {t['name']} {t.get('scalar', '')}".rstrip()
        for value in t.get("values", []):
            yield f"{t['name']}.{value['name']} = {value['value']}"
        for bits in t.get("bits", []):
            yield f"{t['name']}.{bits['name']} = {bits['first']}..{bits['last']}{decisive(bits)}"
        yield from parameters(t)
    for f in model(out)["fields"]:
        sets = " ".join(f"0x{o['set']:02X}" for o in f.get("occurrences", [{"set": f["set"]}]))
        yield f"{f['role']} {f['name']} ({sets}, 0x{f['descriptor']:02X}){decisive(f)}"
        yield from (f"{f['name']} has the function {call['function']}" for call in f.get("calls", []))
        yield from (f"{f['name']} is sent by {device}" for device in f.get("devices", []))
        for response in f.get("responses", []):
            yield f"{f['name']} is answered by {json.dumps(response)}"
        yield from parameters(f)
    for d in model(out)["devices"]:
        yield f"device {d['id']} {d['model_number']}"
        for name in {x["field"].partition(".")[0] for x in d["supports"]}:
            yield f"{d['id']} has the set {name}"


#: The keys of a field, a parameter, a variant of one, or a bit, that decide its bytes and their meaning.
DECIDES = (
    "when",
    "silent_when",
    "silenced_by",
    "enum",
    "member",
    "elements",
    "type",
    "length",
    "counts",
    "fills",
    "tag",
    "constant",
    "optional",
    "required_for",
    "units",
    "frame",
    "valid",
)


def decisive(of: dict[str, Any]) -> str:
    return "".join(f" {key}={json.dumps(of[key])}" for key in DECIDES if key in of)


def parameters(of: dict[str, Any]) -> Iterator[str]:
    for number, p in enumerate(of.get("parameters", [])):
        parameter = f"{of['name']}[{number}] {p['name']}"
        yield f"{parameter}{decisive(p)}"
        for case in p.get("cases", []):
            yield f"{parameter} {case.get('parameter', {}).get('type', 'nothing')} if {case['tag']}"
        for variant in p.get("variants", []):
            if decisive(variant):
                yield f"{parameter}{decisive(variant)} if {variant['by']} is {variant['key']}"


# ------------------------------------------------------------------- languages with braces


def declarations(text: str) -> Iterator[tuple[str, ...]]:
    """The declarations, each after the scopes around it; the bodies of functions are left out."""
    text = re.sub(
        r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', lambda x: x[0] if x[0][0] == '"' else " ", text, flags=re.S
    )
    scopes: list[str] = []
    head, at, depth = "", 0, 0
    while at < len(text):
        c = text[at]
        at += 1
        depth += (c in "([") - (c in ")]")
        if (depth == 0 and c in "{};") or (depth == 0 and c == "," and lists(scopes)):
            head = " ".join(head.split())
            if c == "{" and SCOPE.search(head):
                of = re.compile(r"\s*([A-Z]\w*)\s+(?!\{)").match(text, at) if head.endswith("!") else None
                head += f" {of[1]}" if of else ""
                yield (*scopes, head)
                scopes.append(head)
            else:
                if c == "{":
                    at = behind(text, at)
                if head:
                    yield (*scopes, head)
                if c == "}" and scopes:
                    scopes.pop()
            head = ""
        else:
            head += c


#: The beginning of a scope whose members are compared: types and groups, not functions and values.
SCOPE = re.compile(
    r"^(export |declare |default |abstract |inline |pub |unsafe |template ?<[^{]*> |typedef |const )*"
    r'(namespace|struct|class|enum|union|trait|impl|mod|extern "C"|interface)(?!\w)(?!.*=$)|!$|^\w+: u\d+$'
)


def lists(scopes: list[str]) -> bool:
    """Do commas separate the items of this scope, as of enumerators, and of members in Rust?"""
    return bool(scopes) and bool(re.search(r"\benum\b|^pub struct|!( \w+)?$|: u\d+$", scopes[-1]))


def behind(text: str, at: int) -> int:
    """Returns the position after the brace that closes the block in which the text begins."""
    depth = 1
    while depth and at < len(text):
        depth += (text[at] == "{") - (text[at] == "}")
        at += 1
    return at


def joined(scopes: tuple[str, ...]) -> str:
    return ": ".join(scopes)


def files(folder: Path, pattern: str) -> Iterator[tuple[str, str]]:
    for path in sorted(folder.rglob(pattern)):
        yield path.relative_to(folder).as_posix(), path.read_text("utf-8")


MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+(?:\([^)]*\))?)((?:\\\n|[^\n])*)", re.M)


def c(out: Path) -> Iterator[tuple[str, str]]:
    for folder in (out / "c/src", out / "c/ports"):
        for name, text in files(folder, "*.h"):
            if name == "open.h":
                continue  # of the sources beside it
            text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
            for macro, value in MACRO.findall(text):
                if not macro.endswith("_H"):
                    yield name, " ".join(f"#define {macro} {value}".replace("\\\n", " ").split())
            text = re.sub(r"^[ \t]*#(?:\\\n|[^\n])*", "", text, flags=re.M)
            for scopes in declarations(text):
                line = re.sub(r"\b(MIP_API|MIP_CHECKED|MIP_ENUM_\d+|static|inline) ?", "", joined(scopes))
                yield name, line.removeprefix('extern "C": ')


def cpp(out: Path) -> Iterator[tuple[str, str]]:
    for name, text in files(out / "c/src", "*.hpp"):
        text = re.sub(r"^[ \t]*#(?:\\\n|[^\n])*", "", text, flags=re.M)
        text = re.sub(r"^(MIP_[A-Z_]+\([^()]*\))$", r"\1;", text, flags=re.M)
        hidden = {"namespace detail", "namespace internal"}
        yield from ((name, joined(x)) for x in declarations(text) if not hidden & set(x))


def rust(out: Path) -> Iterator[tuple[str, str]]:
    for name, text in files(out / "rust/src", "*.rs"):
        if name.startswith("macros/"):
            continue
        text = re.sub(r"(?<![\w'])'(?:\\.|[^'\\])'", "' '", text)
        text = text.replace("#[macro_export]\nmacro_rules!", "pub macro_rules!")
        text = re.sub(r"#!?\[(?:[^\[\]]|\[[^\]]*\])*\]", "", text)
        text = text.partition("\n#[cfg(test)]")[0]
        # What a macro writes once for blocking and asynchronous devices.
        text = re.sub(r"^macro_rules! (\w+) \{\s*\(.*\) => \{\s*\$\(\$of\)\* \{", r"impl \1 {", text, flags=re.M)
        yield from ((name, f"{name.removesuffix('.rs')} {joined(x)}") for x in declarations(text) if seen(*x))


def seen(*scopes: str) -> bool:
    """Are an item of Rust and everything around it public?"""
    *outer, last = scopes
    if (outer and not seen(*outer)) or "pub(" in last:
        return False
    within = outer[-1] if outer else ""
    if " for " in within:
        return False  # the methods of the trait
    if re.match(r"pub (unsafe )?(trait|enum)\b|\w+!( \w+)?$|\w+: u\d+$", within):
        return True
    return bool(re.match(r"pub |impl\b|(?!macro_rules)\w+!", last))


def javascript(out: Path) -> Iterator[tuple[str, str]]:
    for name, text in files(out / "javascript", "*.d.mts"):
        yield from (
            (name, f"{name.removesuffix('.d.mts')} {joined(x)}")
            for x in declarations(text)
            if not x[0].startswith("import ")
        )


# ------------------------------------------------------------------- Python


def python(out: Path) -> Iterator[tuple[str, str]]:
    package = out / "python"
    for name, text in files(package, "*.py"):
        module = name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        if (not re.search(r"(^|\.)_", module) and "." in module) or "/__init__" in name:
            yield from ((name, line) for line in members(module, ast.parse(text).body))


def members(owner: str, body: list[ast.stmt]) -> Iterator[str]:
    for node in body:
        match node:
            case ast.ClassDef(name=name, bases=bases) if not name.startswith("_"):
                yield f"class {owner}.{name}({', '.join(map(ast.unparse, bases))})"
                yield from members(f"{owner}.{name}", node.body)
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) if public(name):
                returned = f" -> {ast.unparse(node.returns)}" if node.returns else ""
                marks = "".join(f"@{ast.unparse(d)} " for d in node.decorator_list)
                yield f"{marks}def {owner}.{name}({ast.unparse(node.args)}){returned}"
            case ast.AnnAssign(target=ast.Name(id=name)) if public(name):
                yield f"{owner}.{name}: {ast.unparse(node.annotation)}"
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant() as value) if public(name):
                yield f"{owner}.{name} = {ast.unparse(value)}"
            case ast.Assign(targets=[ast.Name(id=name)]) if public(name):
                yield f"{owner}.{name}"


def public(name: str) -> bool:
    return not name.startswith("_") or (
        name.startswith("__") and name not in ("__slots__", "__match_args__", "__all__")
    )


#: Of each binding, the file and the text of each line.
BINDINGS: dict[str, Callable[[Path], Iterator[tuple[str, str]]]] = {
    "c": c, "cpp": cpp, "javascript": javascript, "python": python, "rust": rust,
}  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())
