"""The command clients of all languages against one plain model of what a client must do."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest
from conformance.scenarios import END, Step, Words, brief, random_steps, scenarios
from random_values import chance
from support import SPECS, differences, driver, each_of_the_small_one, expected, model, offering, rounds


def request(steps: list[Step]) -> dict[str, Any]:
    return {"op": "client", "steps": steps}


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_the_model_keeps_every_rule(spec: str) -> None:
    for name, steps, events in scenarios(model(spec)):
        answer = expected(model(spec), request(steps))
        assert "; ".join(brief(e) for e in answer["events"]) == events, name


@each_of_the_small_one("client")
def test_every_rule(language: str, spec: str) -> None:
    compare(language, spec, [steps for _, steps, _ in scenarios(model(spec))])


@each_of_the_small_one("client")
def test_random_steps(language: str, spec: str) -> None:
    requests = [request(steps) for steps in drawn(spec)]
    kinds = {e["event"] for answer in events(spec, json.dumps(requests)) for e in answer["events"]}
    assert kinds >= {"sent", "silent", "acknowledged", "refused", "timed_out", "missing_response", "undecodable",
                     "received", "end"}  # fmt: skip
    compare(language, spec, drawn(spec))


@cache
def drawn(spec: str) -> list[list[Step]]:
    numbers, words = chance("client", spec), Words(model(spec))
    return [random_steps(numbers, words) for _ in range(rounds(150, 3000))]


def compare(language: str, spec: str, cases: list[list[Step]]) -> None:
    requests = [request(steps) for steps in cases]
    wanted = events(spec, json.dumps(requests))
    answers = driver(language, spec).ask(requests)
    for r, w, a in zip(requests, wanted, answers, strict=True):
        if w != a:
            small = smallest(language, spec, r["steps"])
            again = request(small)
            pytest.fail(differences([again], [expected(model(spec), again)], driver(language, spec).ask([again])))


@cache
def events(spec: str, requests: str) -> list[dict[str, Any]]:
    """The same for every language."""
    return [expected(model(spec), r) for r in json.loads(requests)]


def smallest(language: str, spec: str, steps: list[Step]) -> list[Step]:
    """Fewer steps that are still answered wrongly."""
    at = 0
    while at < len(steps):
        fewer = steps[:at] + steps[at + 1 :]
        wrong = driver(language, spec).ask([request(fewer)]) != [expected(model(spec), request(fewer))]
        steps, at = (fewer, at) if wrong else (steps, at + 1)
    return steps


@pytest.mark.parametrize("language", offering("client"))
def test_what_is_no_step_is_refused(language: str) -> None:
    wrong: list[Any] = [
        None, 7, "end", {}, {"step": "wait"}, {"step": 1}, {"step": "receive"}, {"step": "receive", "bytes": "7"},
        {"step": "receive", "bytes": "xx"}, {"step": "receive", "bytes": "75", "chunk": 0},
        {"step": "receive", "bytes": "75", "chunk": -1}, {"step": "time"}, {"step": "time", "milliseconds": -1},
        {"step": "time", "milliseconds": "1"}, {"step": "send"}, {"step": "send", "set": 1},
        {"step": "send", "set": 1, "fields": []}, {"step": "send", "set": 0, "fields": []},
        {"step": "send", "set": 1, "fields": [1]}, {"step": "send", "set": 1, "fields": [{"descriptor": 1, "raw": ""}]},
    ]  # fmt: skip
    requests: list[Any] = [request([END, step]) for step in wrong] + [{"op": "client"}, request({})]  # type: ignore[arg-type]
    assert driver(language, "invented").ask(requests) == [{"error": "request"}] * len(requests)
