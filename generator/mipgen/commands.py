"""What the commands do. Each loads what it needs when it needs it, so that a short one is quick."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import discovery, resources, stamp
from .errors import Failure

if TYPE_CHECKING:
    from .build import Output
    from .discovery import Source
    from .model import Model


def validate(options: Namespace) -> int:
    sources, key = _asked(options)
    known = stamp.remembered(key, None)
    if known is not None:
        print(known["summary"])
        return 0
    from . import build

    model = _load(options.spec)
    build.check_names(model, sources)
    print(_summary(model))
    _remember(options, key, model, [])
    return 0


def generate(options: Namespace) -> int:
    sources, key = _asked(options)
    known = stamp.remembered(key, options.out)
    if known is not None:
        print(known["summary"])
        rows = [(name, made["title"], len(made["files"]), 0) for name, made in known["targets"].items()]
    else:
        from . import build, render

        model = _load(options.spec)
        outputs = build.make(model, sources)
        print(_summary(model))
        rows = [(o.name, o.title, len(o.files), len(render.write(o.files, options.out / o.name))) for o in outputs]
        _remember(options, key, model, outputs)
    for name, title, files, changed in rows:
        print(f"{name:10} {files:4} files, {changed} changed  ({title})")
    others = discovery.sources(options.target_path).keys() - {source.name for source in sources}
    rest = f"left out: {', '.join(sorted(others))}" if others else "nothing was left out"
    print(f"{options.out}: {sum(r[2] for r in rows)} files, {sum(r[3] for r in rows)} changed; {rest}")
    return 0


def check(options: Namespace) -> int:
    from . import build, render

    sources, _ = _asked(options)
    model = _load(options.spec)
    outputs = build.make(model, sources)
    print(_summary(model))
    found = 0
    for output in outputs:
        for difference in render.compare(output.files, options.out / output.name):
            place = options.out / output.name / difference.path
            print(f"{place}: error: {difference.what}; run 'mipgen generate'", file=sys.stderr)
            found += 1
    if not found:
        print(f"{options.out} is what the specification gives")
    return 1 if found else 0


def _asked(options: Namespace) -> tuple[list[Source], str | None]:
    """The targets that are asked for, and a key of all that their output follows from."""
    if not (options.spec / "protocol.yaml").is_file():
        raise Failure(
            "there is no specification here: protocol.yaml is missing; "
            "name its folder with --spec, or write one to start from with 'mipgen new FOLDER'",
            str(options.spec),
        )
    sources = discovery.chosen(options.targets, options.target_path)
    if any(source.module for source in sources):
        return sources, None  # what the module of a user looks at is unknown
    return sources, stamp.key([options.spec, *options.target_path], options.run, *(source.name for source in sources))


def _load(spec: Path) -> Model:
    from .resolve import load_model

    return load_model(spec)


def _remember(options: Namespace, key: str | None, model: Model, outputs: list[Output]) -> None:
    if key == _asked(options)[1]:  # nothing was changed meanwhile
        stamp.remember(key, _summary(model), {output.name: (output.title, output.files) for output in outputs})


def _summary(model: Model) -> str:
    from .model import RESPONSE

    responses = sum(f.role == RESPONSE for f in model.fields)
    return (
        f"{len(model.sets)} sets: {len(model.fields) - responses} commands and data fields, {responses} responses; "
        f"{len(model.devices)} devices, {len(model.examples)} examples, {len(model.errata)} errata"
    )


def audit_manuals(options: Namespace) -> int:
    from . import audit
    from .problems import nearest

    model = _load(options.spec)
    known = [x.id for x in model.protocol.manuals]
    findings = []
    for argument in options.manual:
        manual, _, file = argument.partition("=")
        if manual not in known:
            print(f"mipgen: unknown manual '{manual}'{nearest(manual, known)}", file=sys.stderr)
            return 2
        if not Path(file).is_file():
            print(f"mipgen: '{argument}': no such file; write --manual {manual}=FILE", file=sys.stderr)
            return 2
        findings += audit.audit(model, manual, Path(file))
    print("".join(f"{f}\n" for f in findings), end="")
    print(f"{len(findings)} findings")
    return 1 if findings else 0


# --------------------------------------------------------------------------- around them


def new(options: Namespace) -> int:
    """Writes a specification that validates; into a folder that holds nothing yet."""
    folder: Path = options.folder
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise Failure("there is something here already; name a folder that is new, or empty", str(folder))
    schemas = resources.root() / "spec/schema"
    for path, file in (*resources.files(resources.package() / "new"), *resources.files(schemas, "schema/")):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(file.read_bytes())
    named = "" if folder == Path("spec") else f" --spec {folder}"
    print(f"{folder} is a small specification; begin with {folder / 'protocol.yaml'}, then: mipgen generate{named}")
    return 0


def targets(options: Namespace) -> int:
    for source in discovery.chosen(None, options.target_path):
        own = "" if source.ours else f"  [{source.folders[0]}]"
        print(source.name if options.names else f"{source.name:10} {source.load().TITLE}{own}")
    return 0


def completion(options: Namespace) -> int:
    import shtab

    from . import cli

    parser = cli.parser()
    for action in _actions(parser):
        if action.type is Path:
            action.complete = shtab.DIRECTORY
        elif action.dest == "targets":
            action.complete = shtab.cmd("mipgen targets --names")
    print(shtab.complete(parser, options.shell))
    return 0


def _actions(parser: Any) -> Iterator[Any]:
    """All arguments of a parser and of its commands."""
    for action in parser._actions:
        yield action
        if isinstance(action.choices, dict):
            for command in action.choices.values():
                yield from _actions(command)
