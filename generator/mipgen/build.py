"""From a model to the files of several targets, all in memory."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from . import naming, parallel, render
from .discovery import Source
from .model import Model
from .problems import Problem, Problems, SpecError


@dataclass(frozen=True, slots=True)
class Output:
    """The files that one target makes of a model, or the names that prevent it."""

    name: str
    title: str
    files: dict[str, bytes]
    problems: list[Problem]


def check_names(model: Model, sources: Sequence[Source]) -> None:
    """Raises SpecError if two things of the model get the same name in one of the languages, or one too long a name."""
    found = parallel.each(lambda source: _unfit(model, source), sources)
    _raise([problem for problems in found for problem in problems])


def make(model: Model, sources: Sequence[Source]) -> list[Output]:
    """The output of each target, each made in its own process."""

    def one(source: Source) -> Output:
        problems = _unfit(model, source)
        files = {} if problems else render.render(source, model)
        return Output(source.name, source.load().TITLE, files, problems)

    from . import templating  # noqa: F401 (Jinja and targets are imported once, and not in each process)

    first = sorted(sources, key=lambda source: not getattr(source.load(), "LONG", False))
    made = {output.name: output for output in parallel.each(one, first)}
    _raise([found for output in made.values() for found in output.problems])
    return [made[source.name] for source in sources]


def _unfit(model: Model, source: Source) -> list[Problem]:
    problems = Problems()
    target = source.load()
    naming.judge(source.name, target.identifiers(model), getattr(target, "MAX_IDENTIFIER", None), problems)
    return problems.sorted()


def _raise(problems: list[Problem]) -> None:
    if problems:
        raise SpecError(sorted(set(problems)))
