"""The commands. Each imports modules only when needed, so that short commands are fast."""

from __future__ import annotations

import os
import shlex
import sys
from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from mipgen.base import resources
from mipgen.base.errors import Failure
from mipgen.emit import discovery, output, stamp

#: The options that select a part of a specification.
PARTS = ("devices", "sets", "fields")

if TYPE_CHECKING:
    from mipgen.emit.build import Output
    from mipgen.emit.discovery import Source
    from mipgen.model import Model


def validate(options: Namespace) -> int:
    sources, key = _asked(options)
    remembered = stamp.remembered(key, None)
    if remembered is not None:
        print(remembered["summary"])
        return 0
    from mipgen.emit import build

    model, summary = _load(options)
    build.check_names(model, sources)
    print(summary)
    _remember(options, key, summary, [])
    return 0


def generate(options: Namespace) -> int:
    sources, key = _asked(options)
    remembered = stamp.remembered(key, options.out)
    if remembered is not None:
        print(remembered["summary"])
        rows = [(name, made["title"], len(made["files"]), 0) for name, made in remembered["targets"].items()]
    else:
        from mipgen.emit import build

        _apart(options, sources)
        model, summary = _load(options)
        outputs = build.make(model, sources)
        changes = _write(options, outputs)
        print(summary)
        rows = [(o.name, o.title, len(o.files), changed) for o, changed in zip(outputs, changes, strict=True)]
        _remember(options, key, summary, outputs)
    for name, title, files, changed in rows:
        print(f"{name:10} {files:4} files, {changed} changed  ({title})")
    others = discovery.targets(options.target_path).keys() - {source.name for source in sources}
    rest = f"left out: {', '.join(sorted(others))}" if others else "nothing was left out"
    print(f"{options.out}: {sum(r[2] for r in rows)} files, {sum(r[3] for r in rows)} changed; {rest}")
    return 0


def check(options: Namespace) -> int:
    from mipgen.emit import build

    sources, _ = _asked(options)
    model, summary = _load(options)
    outputs = build.make(model, sources)
    print(summary)
    differences = [(options.out / o.name, d) for o in outputs for d in output.compare(o.files, options.out / o.name)]
    for folder, difference in differences:
        print(f"{folder / difference.path}: error: {difference.what}", file=sys.stderr)
    others = sum(d.what in output.OTHERS for _, d in differences)
    if others:
        it = "it" if others == 1 else "them"
        print(f"mipgen: {_count(others, 'file')} that mipgen did not write; move or delete {it}", file=sys.stderr)
    if len(differences) > others:
        wrong = _count(len(differences) - others, "file")
        print(f"mipgen: {wrong} to update; run: mipgen generate{_repeated_options(options)}", file=sys.stderr)
    if not differences:
        print(f"{options.out} is up to date")
    return 1 if differences else 0


def _repeated_options(options: Namespace) -> str:
    """Returns the options of this run, to repeat them in another command."""
    arguments = [("--spec", options.spec or ()), ("--out", () if options.out == Path("generated") else (options.out,))]
    arguments += [(f"--{part[:-1]}", getattr(options, part)) for part in PARTS]
    arguments += [("--target", options.targets or ()), ("--target-path", options.target_path)]
    arguments += [("--without", options.without)]
    certain = " --certain" if getattr(options, "certain", False) else ""
    return "".join(f" {option} {shlex.quote(str(value))}" for option, values in arguments for value in values) + certain


def _asked(options: Namespace) -> tuple[list[Source], str | None]:
    """Returns the selected targets, and a key of everything on which their output depends."""
    specs = _specs(options)
    without = getattr(options, "without", ())
    sources = discovery.chosen(options.targets, options.target_path, without)
    if any(source.module for source in sources):
        return sources, None  # the inputs of a user's module are unknown
    names = (source.name for source in sources)
    return sources, stamp.run_key([*specs, *options.target_path], options.run, _part(options), str(len(specs)), *names)


def _part(options: Namespace) -> str:
    """Returns the selected part of the specification, and what of targets is left out, as a text, for keys."""
    return repr([getattr(options, name, ()) for name in (*PARTS, "certain", "without")])


def _apart(options: Namespace, sources: list[Source]) -> None:
    """Raises Failure if the output folder is inside an input folder, or contains one."""
    made = {options.out / source.name: _real(options.out / source.name) for source in sources}
    read = [("--spec", path) for path in _specs(options)] + [("--target-path", path) for path in options.target_path]
    for option, path in read:
        for folder in (path, *sorted(p for p in path.glob("*") if p.is_dir())):  # any of them may be a link
            spec, real = option == "--spec", _real(folder)
            if spec and folder != path and not any(folder.glob("*.yaml")):
                continue  # a specification may be a whole project, with the output in a folder of its own
            for place, target in made.items():
                mixed = real in (target, target.parent) if spec and folder == path else target.is_relative_to(real)
                if mixed:
                    raise Failure(f"{place} lies in {folder}, which {option} names; choose another --out")
                if real.is_relative_to(target):
                    raise Failure(f"{folder}, which {option} names, lies in {place}; choose another --out")


def _real(path: Path) -> Path:
    return Path(os.path.realpath(path))  # unlike Path.resolve, it does not raise for circular links


def _write(options: Namespace, outputs: list[Output]) -> list[int]:
    """Writes all files; returns the number of changed ones for each target. A user's files are kept."""
    folders = {options.out / o.name: o.files for o in outputs}
    try:
        differences = {folder: output.compare(files, folder) for folder, files in folders.items()}
        foreign = [folder / d.path for folder, several in differences.items() for d in several if d.what == "foreign"]
        if not foreign:
            return [len(output.write(files, folder, differences[folder])) for folder, files in folders.items()]
    except OSError as error:
        raise Failure(f"cannot be written: {_reason(error)}; choose another --out", str(options.out)) from None
    listed = "".join(f"\n  {path}" for path in foreign)
    raise Failure(
        f"mipgen would replace these files, but no {resources.MANIFEST} lists them as its own; "
        f"move or delete them, or choose another --out:{listed}",
        str(options.out),
    )


def _reason(error: OSError) -> str:
    return f"{error.strerror} ({error.filename})" if error.filename else str(error.strerror or error)


def _specs(options: Namespace) -> list[Path]:
    """Returns the folder of the specification, and the folders of its overlays."""
    specs: list[Path] = options.spec or [Path("spec")]
    if not (specs[0] / "protocol.yaml").is_file():
        raise Failure(
            "there is no specification here: protocol.yaml is missing; "
            "specify its folder with --spec, or create one with 'mipgen new FOLDER'",
            str(specs[0]),
        )
    return specs


def _load(options: Namespace) -> tuple[Model, str]:
    """Loads the specification, or the selected part of it; returns it with a summary."""
    from mipgen.facts import describe
    from mipgen.resolve import subset
    from mipgen.resolve.load import load_model

    whole = load_model(*_specs(options))
    devices, sets, fields = (tuple(getattr(options, name, ())) for name in PARTS)
    asked = subset.Selection(devices, sets, fields, getattr(options, "certain", False))
    if not asked:
        return whole, _summary(whole)
    part = subset.select(whole, asked)
    summaries = [describe.summary(d) for d in whole.devices if d.id in asked.devices]
    return part, "\n".join([*summaries, subset.left_out(whole, part), _summary(part)])


def _summary(model: Model) -> str:
    from mipgen.model import COMMAND, RESPONSE

    responses = sum(f.role == RESPONSE for f in model.fields)
    commands = sum(f.role == COMMAND for f in model.fields)
    data = len(model.fields) - responses - commands
    return (
        f"{_count(len(model.sets), 'set')}: {_count(commands, 'command')}, {_count(data, 'data field')}, "
        f"{_count(responses, 'response')}; {_count(len(model.devices), 'device')}, "
        f"{_count(len(model.examples), 'example')}, {_count(len(model.errata), 'erratum', 'errata')}"
    )


def _count(number: int, singular: str, plural: str = "") -> str:
    return f"{number} {singular if number == 1 else plural or singular + 's'}"


def _remember(options: Namespace, key: str | None, summary: str, outputs: list[Output]) -> None:
    if key == _asked(options)[1]:  # the input has not changed meanwhile
        stamp.remember(key, summary, {o.name: (o.title, o.files) for o in outputs})


# --------------------------------------------------------------------------- others


def new(options: Namespace) -> int:
    """Writes a valid specification to an empty or new folder."""
    import yaml

    folder: Path = options.folder
    text = (resources.PACKAGE / "new.yaml").read_text("utf-8")
    files = {path: content.encode() for path, content in yaml.safe_load(text).items()}
    schemas = resources.files_in(resources.root() / "spec/schema", "schema/")
    try:
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise Failure("this folder is not empty; specify a new or empty folder", str(folder))
        for path, content in {**files, **{path: file.read_bytes() for path, file in schemas}}.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(content)
    except OSError as error:
        raise Failure(f"cannot be written: {_reason(error)}; choose another folder", str(folder)) from None
    named = "" if folder == Path("spec") else f" --spec {shlex.quote(str(folder))}"
    print(f"{folder} is a small specification; start with {folder / 'protocol.yaml'}, then run: mipgen generate{named}")
    return 0


def targets(options: Namespace) -> int:
    for source in discovery.chosen(None, options.target_path):
        own = "" if source.ours else f"  [{source.folders[0]}]"
        print(f"{source.name:10} {source.load().title}{own}")
    return 0
