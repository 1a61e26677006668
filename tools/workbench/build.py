"""Builds the tools for the browser as pages that open from disk.

    python3 build.py PACKAGE FOLDER

PACKAGE is a codec that mipgen generated, such as `generated/javascript`, of any specification. Browsers load no modules
from disk, so the tools, the codec and the model of the specification become one classic script, `workbench.js`, which
defines one global object, `mip`, with the exports of `index.mjs`. FOLDER gets that script, the style sheets, a page for
each tool, and `fields.js`, with which a page searches fields: a quarter of the size, because its model has names and
descriptions only. It defines `mipFields`.
"""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path
from string import Template
from typing import Any

HERE = Path(__file__).resolve().parent

#: The pages, by the function that fills them.
TOOLS = {
    "bandwidth": "Bandwidth calculator",
    "builder": "Packet builder",
    "finder": "Field finder",
    "inspector": "Packet inspector",
    "live": "Live device",
}

#: The name by which the tools import the package with the codec, whatever its own name is.
CODEC = "mip-protocol"


class Failure(Exception):
    """A mistake that the user can correct."""


# The forms of statements that modules use; Biome writes each at the beginning of a line.
_IMPORT = re.compile(
    r'^import (?:\{(?P<names>[^}]*)\}|\* as (?P<all>\w+)|(?P<default>\w+)) from "(?P<source>[^"]+)";$', re.M
)
_FORWARD = re.compile(r'^export (?:\{(?P<names>[^}]*)\}|\*) from "(?P<source>[^"]+)";$', re.M)
_DECLARED = re.compile(r"^export (?=(?:async )?(?:const|class|function\*?) (?P<name>\w+))", re.M)
_DEFAULT = re.compile(r"^export default ", re.M)
_OTHER = re.compile(r"^(?:import|export)\b.*", re.M)


class Bundle:
    """Modules as functions, each after those that it imports. The exports of a module are in `modules`, by its path."""

    def __init__(self, package: Path) -> None:
        self.package = package.resolve()
        try:
            self.exports = json.loads((self.package / "package.json").read_text("utf-8"))["exports"]
        except FileNotFoundError:
            raise Failure(f"{package} has no package.json; generate the target javascript first") from None
        self.functions: dict[str, str] = {}

    def text(self, module: str, name: str, about: str) -> str:
        last = self.add(HERE / module, ())
        functions = "\n\n".join(self.functions.values())
        return (
            f"// The MIP workbench: {about} as one script, built from modules. MIT licence.\n"
            f'(() => {{\n"use strict";\nconst modules = {{}};\n\n{functions}\n\nglobalThis.{name} = {last};\n}})();\n'
        )

    def add(self, path: Path, importers: tuple[Path, ...]) -> str:
        """Adds a module and what it imports; returns the expression for its exports."""
        home, name = (HERE, "workbench") if path.is_relative_to(HERE) else (self.package, CODEC)
        key = f"{name}/{path.relative_to(home).as_posix()}"
        if path in importers:
            raise Failure(f"{path} imports itself through {importers[-1]}")
        if key not in self.functions:
            function = self.function(path, (*importers, path))  # adds first what it imports
            self.functions[key] = f"modules[{json.dumps(key)}] = {function};"
        return f"modules[{json.dumps(key)}]"

    def function(self, path: Path, importers: tuple[Path, ...]) -> str:
        exported: list[str] = []

        def imported(match: re.Match[str]) -> str:
            source = self.add(self.resolved(match["source"], path), importers)
            if match["all"]:
                return f"const {match['all']} = {source};"
            names = f"default: {match['default']}" if match["default"] else ", ".join(_pairs(match["names"], "{}: {}"))
            return f"const {{ {names} }} = {source};"

        def forwarded(match: re.Match[str]) -> str:
            source = self.add(self.resolved(match["source"], path), importers)
            all_ = match["names"] is None
            exported.extend([f"...{source}"] if all_ else _pairs(match["names"], f"{{1}}: {source}.{{0}}"))
            return ""

        def declared(match: re.Match[str]) -> str:
            exported.append(match["name"])
            return ""

        def default(_: re.Match[str]) -> str:
            exported.append("default: default_")
            return "const default_ = "

        text = path.read_text("utf-8")
        if other := next((m for m in _OTHER.finditer(text) if not _known(text, m.start())), None):
            line = text.count("\n", 0, other.start()) + 1
            raise Failure(f"{path}:{line}: error: a statement that cannot be bundled: {other[0]}")
        for pattern, change in (_IMPORT, imported), (_FORWARD, forwarded), (_DECLARED, declared), (_DEFAULT, default):
            text = pattern.sub(change, text)
        return f"(() => {{\n{text}\nreturn {{ {', '.join(exported)} }};\n}})()"

    def resolved(self, source: str, importer: Path) -> Path:
        """The file of a module that another one imports."""
        name, _, rest = source.partition("/")
        if name.startswith("."):
            found = (importer.parent / source).resolve()
        elif name == CODEC and f"./{rest}".rstrip("/") in self.exports:
            found = (self.package / self.exports[f"./{rest}".rstrip("/")]["default"]).resolve()
        else:
            raise Failure(f"{importer}: error: {source} is not in the codec at {self.package}")
        if not found.is_file():
            raise Failure(f"{importer}: error: {found} is missing")
        return found


def _known(text: str, place: int) -> bool:
    return any(pattern.match(text, place) for pattern in (_IMPORT, _FORWARD, _DECLARED, _DEFAULT))


def _pairs(names: str, form: str) -> list[str]:
    """Formats each name in a list such as `a, b as c`: `{0}` is the name before `as`, `{1}` the one after it."""
    found = (name.strip().partition(" as ") for name in names.split(",") if name.strip())
    return [form.format(there, here or there) for there, _, here in found]


#: The keys of each part of the model that the search reads.
_READ = {
    "model": ("format", "packet", "scalars", "acknowledge", "ack_code", "function_selector", "functions", "vocabulary",
              "synonyms"),
    "field": ("set", "name", "descriptor", "role", "title", "description", "command", "responses", "keywords",
              "symbols", "also", "deprecated", "occurrences"),
    "type": ("name", "kind", "symbols"),
    "part": ("name", "short", "value", "description"),
    "parameter": ("name", "type", "description"),
    "set": ("number", "title"),
    "device": ("id", "title", "also", "model_number"),
}  # fmt: skip


def searched(model: dict[str, Any]) -> dict[str, Any]:
    """The part of a model that `find.mjs` reads, and for each device the numbers of its fields."""

    def some(kind: str, of: dict[str, Any], **more: Any) -> dict[str, Any]:
        return {key: of[key] for key in _READ[kind] if key in of} | {key: value for key, value in more.items() if value}

    def symbols(of: dict[str, Any]) -> dict[str, str]:
        """The symbols to search. Those of Rust have the same letters and digits as those of Python."""
        found = {re.sub(r"\W|_", "", symbol): (language, symbol) for language, symbol in of.get("symbols", {}).items()}
        return dict(found.values())

    def parameter(of: dict[str, Any]) -> dict[str, Any]:
        variants = [{"type": one["type"]} for one in of.get("variants", ()) if "type" in one]
        cases = [{"parameter": parameter(one["parameter"])} for one in of.get("cases", ()) if one.get("parameter")]
        return some("parameter", of, variants=variants, cases=cases)

    def parameters(of: dict[str, Any]) -> list[dict[str, Any]]:
        return [parameter(one) for one in of.get("parameters", ())]

    types = []
    for of in model["types"]:
        parts = {key: [some("part", one) for one in of.get(key, ())] for key in ("values", "bits")}
        types.append(some("type", of, symbols=symbols(of), parameters=parameters(of), **parts))
    fields = [
        some("field", of, symbols=symbols(of)) | {"parameters": parameters(of), "sources": []} for of in model["fields"]
    ]
    sets = [some("set", of) for of in model["sets"]]
    numbers = {place["name"]: i for i, of in enumerate(model["fields"]) for place in [of, *of.get("occurrences", ())]}
    devices = [some("device", of, **_supported(of, numbers)) for of in model.get("devices", ())]
    return some("model", model, types=types, sets=sets, fields=fields, devices=devices)


def _supported(device: dict[str, Any], numbers: dict[str, int]) -> dict[str, list[int]]:
    """The numbers of the fields that a device has for certain, likely, as is assumed, and not."""
    answers: dict[str, set[int]] = {answer: set() for answer in ("yes", "likely", "assumed", "no")}
    for one in device["supports"]:
        answers[device["evidence"][one["evidence"]]["answer"]].add(numbers[one["field"]])
    return {answer: sorted(found) for answer, found in answers.items()}


def build(package: Path, folder: Path) -> list[Path]:
    """Writes the workbench; returns its pages."""
    tools, fields = Bundle(package), Bundle(package)
    model = json.loads(
        (package / "model.mjs").read_text("utf-8").removeprefix("export default ").rstrip().removesuffix(";")
    )
    page = Template((HERE / "page.html").read_text("utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "workbench.js").write_text(tools.text("index.mjs", "mip", "tools, codec and model"), "utf-8")
    part = json.dumps(searched(model), ensure_ascii=False, separators=(",", ":"))
    script = fields.text("fields.mjs", "mipFields", "the search for fields")
    (folder / "fields.js").write_text(f"{script}mipFields.model = {part};\n", "utf-8")
    for style in sorted(HERE.glob("*.css")):
        shutil.copy(style, folder)
    pages = [folder / f"{name}.html" for name in TOOLS]
    for path, (name, title) in zip(pages, TOOLS.items(), strict=True):
        path.write_text(page.substitute(name=name, title=title, links=_links(name)), "utf-8")
    return pages


def _links(here: str) -> str:
    current = {here: ' aria-current="page"'}
    lines = (f'            <a href="{name}.html"{current.get(name, "")}>{title}</a>' for name, title in TOOLS.items())
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    if len(arguments) != 2:
        print("usage: build.py PACKAGE FOLDER", file=sys.stderr)
        return 2
    try:
        pages = build(Path(arguments[0]), Path(arguments[1]))
    except Failure as failure:
        print(f"build.py: {failure}", file=sys.stderr)
        return 1
    for path in pages:
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
