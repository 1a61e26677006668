"""Makes the files of several targets from a model, in memory."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from mipgen.base import parallel
from mipgen.model import Model
from mipgen.read.problems import Problem, Problems, SpecError

from . import naming, render
from .discovery import Source


@dataclass(frozen=True, slots=True)
class Output:
    """The files that a target makes from a model, or the names that prevent it."""

    name: str
    title: str
    files: dict[str, bytes]
    problems: list[Problem]


def check_names(model: Model, sources: Sequence[Source]) -> None:
    """Raises SpecError if two things in the model get the same name in a language, or a name is too long."""
    problems = parallel.each(lambda source: name_problems(model, source), sources)
    _raise([problem for each in problems for problem in each])


def make(model: Model, sources: Sequence[Source]) -> list[Output]:
    """Makes the output of each target, in its own process."""

    def make_each(group: Sequence[Source]) -> list[Output]:
        return [make_one(source) for source in group]

    def make_one(source: Source) -> Output:
        problems = name_problems(model, source)
        files = {} if problems else render.render(source, model)
        target = source.load()
        rename = target.renaming(model.protocol.package)
        return Output(source.name, rename(target.title) if rename else target.title, files, problems)

    from . import templating  # noqa: F401 (imports Jinja and targets once, instead of in each process)

    groups: dict[str, list[Source]] = {}
    for source in sorted(sources, key=lambda source: not source.load().slow):
        groups.setdefault(source.load().beside or source.name, []).append(source)
    made = {output.name: output for outputs in parallel.each(make_each, list(groups.values())) for output in outputs}
    _raise([problem for output in made.values() for problem in output.problems])
    return [made[source.name] for source in sources]


def name_problems(model: Model, source: Source) -> list[Problem]:
    """Returns the problems of the names and paths that a target makes."""
    problems = Problems()
    target = source.load()
    identifiers, paths = target.identifiers(model), render.paths(source, model)
    rename = target.renaming(model.protocol.package)
    if rename is not None:
        identifiers = (replace(i, name=rename(i.name)) for i in identifiers)
        paths = (replace(i, name=rename(i.name)) for i in paths)
    naming.judge(source.name, identifiers, target.grammar, problems)
    naming.judge_paths(source.name, paths, problems)
    return problems.sorted()


def _raise(problems: list[Problem]) -> None:
    if problems:
        raise SpecError(sorted(set(problems)))
