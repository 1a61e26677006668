"""Every word of the runtimes and templates, as a name of a specification: what `validate` accepts, compiles."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
import yaml
from bad_spec_files import BASE
from c_build import headers
from mipgen import model as m
from mipgen.emit import build, discovery, output, render
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import ROOT, SPECS, heavy, need, uses

ENDS = (".c", ".h", ".hpp", ".rs", ".py", ".mjs", ".mts", ".lua", ".j2")


@cache
def words(of: str = "") -> list[str]:
    """The identifiers in the runtimes and templates, or in those of one target, as a specification writes them: without
    prefix, in lower case."""
    found = set()
    folders = (ROOT / f"{folder}/{of}" for folder in ("runtime", "templates"))
    for path in (p for folder in folders for p in folder.rglob("*") if p.suffix in ENDS):
        for name in re.findall(r"[A-Za-z_]\w*", path.read_text("utf-8")):
            bare = re.sub(r"^(mip_|MIP_)", "", name).strip("_")
            snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", bare).lower()
            found.add(re.sub(r"_+", "_", snake))
    return sorted(w for w in found if re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)*", w))


@cache
def files_and_namespaces() -> list[str]:
    """The words that are names of files, and what C++ has beside the namespaces of sets, of which there are few."""
    from mipgen.targets.c import runtime

    stems = {p.name.partition(".")[0].lower() for p in (ROOT / "runtime").rglob("*") if p.is_file()}
    return sorted((stems | runtime.in_namespace() | {"mip", "con", "std", "uint8_t"}) & {*words(), "con"})


@cache
def types_of_rust() -> set[str]:
    """The words that are types, traits and variants of Rust's runtime, of which each field is one more."""
    sources = "".join(p.read_text("utf-8") for p in (ROOT / "runtime/rust").rglob("*.rs"))
    found = re.findall(r"\b(?:struct|enum|trait|type) ([A-Z]\w+)|^ +([A-Z][a-z]\w*)(?:\([^()]*\))?,$", sources, re.M)
    return {re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", a or b).lower() for a, b in found}


def groups(names: list[str], size: int) -> Iterator[tuple[int, list[str]]]:
    return ((at // size, names[at : at + size]) for at in range(0, len(names), size))


def in_set(number: int, name: str, text: str) -> str:
    return f'set: {number}\nname: "{name}"\ntitle: T {name}\ndescription: D.\n{text}\n'


def data(number: int, name: str, parameters: str = "{name: v, type: u8, description: D.}") -> str:
    head = f'{{data: {number}, name: "{name}", title: "T {name}", description: D., parameters: [\n'
    return f"  - {head}{parameters}\n  ]}}"


FIELD = "fields:\n" + data(1, "go")


def types_of_a_set(body: str) -> Callable[[list[str]], dict[str, str]]:
    def made(names: list[str]) -> dict[str, str]:
        rows = "\n".join(f'  "{n}": {body}' for n in names)
        return {"sets/own.yaml": in_set(0x81, "own", f"types:\n{rows}\n{FIELD}")}

    return made


def values(names: list[str]) -> dict[str, str]:
    rows = "\n".join(f'      "{n}": {i}' for i, n in enumerate(names))
    return {
        "types/own.yaml": f"types:\n  own:\n    enum: u16\n    description: D.\n    values:\n{rows}",
        **used(["own"]),
    }


def used(types: list[str]) -> dict[str, str]:
    """Commands and responses with parameters of these types: what is done with a value looks up names of its class."""
    text = "fields:"
    for number, some in groups(types, 20):
        rows = "\n".join(f"      - {{name: {t}, type: {t}, for: W, description: D.}}" for t in some)
        text += f"""
  - command: {number + 1}
    name: use{number}
    title: Use {number}
    description: D.
    functions: WR
    responses: [{{response: {number + 0x81}, parameters: as_command}}]
    parameters:
{rows}"""
    return {"sets/used.yaml": in_set(0x70, "used", text)}


def members(names: list[str]) -> dict[str, str]:
    text = "types:"
    for number, some in groups(names, 100):
        rows = "\n".join(f'      - {{name: "{n}", type: u16, description: D.}}' for n in some)
        text += f"\n  own{number}:\n    description: D.\n    struct:\n{rows}"
    return {"types/own.yaml": text}


def bits(names: list[str]) -> dict[str, str]:
    """Flags, and numbers of two bits: these have members of their own."""
    text, types = "types:", []
    for width in (1, 2):
        for number, some in groups(names, 60 // width):
            rows = "\n".join(f'      "{n}": {i * width}-{i * width + width - 1}' for i, n in enumerate(some))
            types.append(f"own{width}_{number}")
            text += f"\n  {types[-1]}:\n    bitfield: u64\n    description: D.\n    bits:\n{rows}"
    return {"types/own.yaml": text, **used(types)}


def elements(names: list[str]) -> dict[str, str]:
    text = "types:"
    for number, some in groups(names, 50):
        rows = ",\n".join(f'      "{n}"' for n in some)
        text += f"\n  own{number}:\n    vector: float\n    description: D.\n    elements: [\n{rows}\n    ]"
    return {"types/own.yaml": text}


def fields(names: list[str]) -> dict[str, str]:
    return {
        f"sets/own{i}.yaml": in_set(
            0x81 + i, f"own{i}", "fields:\n" + "\n".join(data(n + 1, w) for n, w in enumerate(some))
        )
        for i, some in groups(names, 200)
    }


def sets(names: list[str]) -> dict[str, str]:
    return {f"sets/own{i}.yaml": in_set(0x81 + i, n, FIELD) for i, n in enumerate(names)}


#: What a word names -> the files that have all of these words.
KINDS: dict[str, Callable[[list[str]], dict[str, str]]] = {
    "enum of a set": types_of_a_set("{enum: u8, description: D., values: {one: 1}}"),
    "struct of a set": types_of_a_set("{description: D., struct: [{name: a, type: u8, description: D.}]}"),
    "value": values,
    "bit": bits,
    "element": elements,
    "parameter": members,
    "field": fields,
    "set": sets,
}


def with_names(kind: str, names: list[str], folder: Path) -> m.Model:
    """The specification with these names, each at a line that names it."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(BASE, folder)
    for path, text in KINDS[kind](names).items():
        (folder / path).write_text(text, "utf-8")
    return load_model(folder)


def accepted(kind: str, target: str, folder: Path) -> tuple[m.Model, int]:
    """The specification with all words that are not refused; and how many are refused."""
    names = files_and_namespaces() if kind == "set" else words("rust" if target == "rust" else "")
    if (kind, target) == ("field", "rust"):  # an enumeration of all fields takes long; the types of a set have the rest
        names = sorted({*names} & types_of_rust())
    refused = 0
    for _ in range(6):
        try:
            model = with_names(kind, names, folder)
            build.check_names(model, [discovery.targets()[target]])
            return model, refused
        except SpecError as error:
            bad = set()
            for p in error.problems:
                if not Path(p.file).name.startswith("own"):  # something of the base, and the word that is like it
                    bad.update(re.findall(r"'(\w+)'", p.message))
                    continue
                lines = Path(p.file).read_text("utf-8").splitlines()
                text = next(x for x in (lines[p.line - 1], *lines[1:2]) if '"' in x)
                bad.add(re.findall(r'"(\w+)"', text)[0])
            names = [n for n in names if n not in bad]
            refused += len(bad)
    raise AssertionError(f"{kind}: each turn refuses others")


def run(*command: str | Path, cwd: Path | None = None) -> None:
    done = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True)
    errors = [line for line in done.stderr.splitlines() if "rror" in line]
    assert done.returncode == 0, "\n".join(errors[:20]) or done.stderr[-2000:]


def compile_c(made: Path) -> None:
    for source in sorted((made / "src/mip").glob("*/*.c")):
        run(need("cc"), "-std=c99", "-fsyntax-only", f"-I{made}/src", source)
    for name, end, compiler in (("all.c", ".h", ["cc", "-std=c99"]), ("all.cpp", ".hpp", ["g++", "-std=c++17"])):
        (made / name).write_text("".join(f'#include "{h}"\n' for h in headers(made, end)) + "int unused;\n")
        run(need(compiler[0]), *compiler[1:], "-fsyntax-only", f"-I{made}/src", made / name)


def import_javascript(made: Path) -> None:
    modules = [p.name for p in sorted(made.glob("*.mjs")) if p.name != "quickstart.mjs"]
    run(need("node"), "--input-type=module", "-e", "".join(f'import "{made}/{name}";\n' for name in modules), cwd=made)


def import_python(made: Path) -> None:
    program = """
import importlib, pkgutil
import mip_protocol as mip
for found in pkgutil.walk_packages(mip.__path__, "mip_protocol."):
    module = importlib.import_module(found.name)
    for kind in (k for kinds in getattr(module, "FIELDS", {}).values() for k in kinds):
        if isinstance(kind, type) and issubclass(kind, (mip.Data, mip.Response)) and kind._SIZE:
            value = kind.decode(bytes(kind._SIZE))
            value.to_dict(), value.to_text()
for name in (*mip.__all__, *dir(mip)):
    getattr(mip, name)
"""
    run(sys.executable, "-c", program, cwd=made)


def check_rust(made: Path) -> None:
    run(need("cargo"), "check", "--quiet", "--lib", "--offline", "--target-dir", made / "target", cwd=made)


@uses("g++")
@pytest.mark.parametrize("target", ["c", "python"])
@pytest.mark.parametrize("kind", ["value", "bit"])
def test_names_of_members_of_classes(kind: str, target: str, tmp_path: Path) -> None:
    """Of those of all words, the ones that the body of a class or a look-up in it uses."""
    model = with_names(kind, ["info", "int", "into", "mro", "name", "property", "self"], tmp_path / "spec")
    build.check_names(model, [discovery.targets()[target]])
    output.write(render.render(target, model), tmp_path / target)
    CHECKS[target](tmp_path / target)


#: What ends a comment or a text, or begins an expression, in a language, a manifest or a document.
HOSTILE = '*/ /* """ \\x ${x} $(x) @x@ <b> & # \' \N{SATELLITE} {{ x }}'


def with_hostile_titles(node: Any) -> Any:
    if isinstance(node, dict):
        changed = {k: f"{v} {HOSTILE}" for k, v in node.items() if k == "title" and isinstance(v, str)}
        return {k: with_hostile_titles(v) for k, v in node.items()} | changed
    return [with_hostile_titles(x) for x in node] if isinstance(node, list) else node


@uses("g++", "node")
def test_titles_have_no_syntax(tmp_path: Path) -> None:
    spec = Path(shutil.copytree(SPECS["invented"][0], tmp_path / "spec"))
    for path in spec.rglob("*.yaml"):
        document = with_hostile_titles(yaml.load(path.read_text("utf-8"), yaml.CSafeLoader))
        if path.name == "protocol.yaml":
            document["title"] = f"protocol {HOSTILE}"
        path.write_text(yaml.safe_dump(document, sort_keys=False, allow_unicode=True), "utf-8")
    model, made = load_model(spec), tmp_path / "made"
    for target in discovery.targets():  # Python's formatter reads pyproject.toml
        output.write(render.render(target, model), made / target)
    for target in ("c", "javascript", "python"):
        CHECKS[target](made / target)
    for path in (p for end in ("svg", "xml") for p in made.rglob(f"*.{end}")):
        assert ElementTree.parse(path), path
    assert HOSTILE in str(ElementTree.parse(made / "ros2/package.xml").findtext("description"))
    for name in ("c/idf_component.yml", "c/library.json", "javascript/package.json", "json/mip.json", "kaitai/mip.ksy"):
        document = yaml.load((made / name).read_text("utf-8"), yaml.CSafeLoader)
        document = document.get("meta", document)
        assert HOSTILE in document.get("description", "") + document.get("title", ""), name
    for name in ("rust/Cargo.toml", "markdown/mkdocs.yml", "python/pyproject.toml"):
        assert "\\ud8" not in (made / name).read_text("utf-8"), name
    for name in ("c/zephyr/Kconfig", "c/cmake/mip.pc.in"):
        line = next(x for x in (made / name).read_text("utf-8").splitlines() if "protocol" in x)
        assert line.count('"') in (0, 2) and not {*line} & {*"\\$@#"}


CHECKS = {"rust": check_rust, "c": compile_c, "javascript": import_javascript, "python": import_python}


@heavy("each word of the runtimes as a name")
@uses("g++", "node", "cargo")
@pytest.mark.parametrize("target", CHECKS)
@pytest.mark.parametrize("kind", KINDS)
def test_accepted_names_compile(kind: str, target: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if target == "c":  # a compiler needs no layout; Python's formatter removes imports
        monkeypatch.setattr(render.formatting, "formatted", lambda _, made, *__: dict(made))
    assert len(words()) > 3000
    model, refused = accepted(kind, target, tmp_path / "spec")
    assert refused < 400
    output.write(render.render(target, model), tmp_path / target)
    CHECKS[target](tmp_path / target)
