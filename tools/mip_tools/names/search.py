"""Searches the specification for words: fields that have more of them, rarer ones, or in their names, come first.

A word also stands for words that begin with it, and for its synonyms. The search of the site,
`tools/workbench/rank.mjs`, also knows forms of words, questions and typing errors.
"""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Sequence
from functools import cache

from ..binding import KEYWORDS, SETS, SYNONYMS, Command, Response, info, registry
from .occurrence import Occurrence

#: Weights of a word in names, in keywords, in the name of the set, in parameters, in descriptions.
_WEIGHTS = (6.0, 5.0, 2.0, 1.5, 1.0)
#: What a longer word, or a synonym, counts of that.
_LIKE = 0.7
#: Results with less than this part of the best score are left out.
_LEAST = 1 / 4


def all_fields() -> list[Occurrence]:
    """Returns all fields of the specification."""
    return [Occurrence(*pair) for pair in registry.all_types()]


def ranked(fields: Sequence[Occurrence], text: str) -> list[Occurrence]:
    """Returns the fields that have words of a text, the best first; before them, those of its numbers.

    A response is found by its number only; its words find its command.
    """
    numbers = {int(number) for number in re.findall(r"(?<![\w.,])\d{4,5}(?![\w.,])", text)}  # MSCL: "command (3399)"
    numbers |= {int(a + b, 16) for a, b in re.findall(r"(?i)\b0x([0-9a-f]{2})[\s,]*(?:0x)?([0-9a-f]{2})\b", text)}
    numbered = [f for f in fields if f.set << 8 | f.kind.DESCRIPTOR in numbers]
    words = set(_words(re.sub(r"(?<=[a-z0-9])(?=[A-Z][a-z])", " ", text)))  # PpsSource
    scores: dict[Occurrence, float] = defaultdict(float)
    for word in words:
        found = _having(word)
        for field, weight in found.items():
            scores[field] += weight * math.log(len(_index()) / len(found))
    for field in scores:
        title = _words(info(field.kind).title)
        scores[field] *= 1 + sum(word in words for word in title) / len(title)
    best = max((scores.get(f, 0) for f in fields), default=0)
    others = [f for f in fields if scores.get(f, 0) > best * _LEAST and f not in numbered]
    return numbered + sorted(others, key=lambda f: -scores[f])


def finds_any(text: str) -> bool:
    """Does a search find any field?"""
    return bool(ranked(all_fields(), text))


@cache
def _having(word: str) -> dict[Occurrence, float]:
    """Returns the fields that have a word, with its weight in the best place."""
    alike = {other for group in SYNONYMS if word in group for other in group}
    root = re.sub(r"(?<=..[^s])s$", "", word)  # of a plural

    def weight(own: set[str]) -> float:
        if word in own or root in own:
            return 1
        return _LIKE if alike & own or any(other.startswith(root) for other in own if len(root) > 2) else 0

    weights = {f: max(w * weight(own) for w, own in zip(_WEIGHTS, texts)) for f, texts in _index().items()}
    return {field: best for field, best in weights.items() if best}


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z0-9]+", text.lower())


@cache
def _index() -> dict[Occurrence, list[set[str]]]:
    """Returns the words of each field that is searched, a set for each weight."""
    searched = [field for field in all_fields() if not (issubclass(field.kind, Response) and field.kind.COMMANDS)]
    return {field: [set(_words(text)) for text in _texts(field)] for field in searched}


def _texts(field: Occurrence) -> list[str]:
    """Returns what is searched, one text for each weight."""
    about = info(field.kind)
    names = [field.name.split(".")[-1], about.title, *about.also]
    kinds = [field.kind, *(field.kind.RESPONSES if issubclass(field.kind, Command) else ())]
    parameters = [p for kind in kinds for p in info(kind).parameters]
    types = {one for p in parameters for one in (p.type, *(v.changes.get("type") for v in p.variants))}
    values = [str(name).lower() for one in types for name in getattr(one, "__members__", ())]
    texts = [info(kind).text for kind in kinds] + [p.text for p in parameters]
    parts = (names, KEYWORDS.get(about.name, ()), SETS.get(field.set, ()), [p.name for p in parameters] + values, texts)
    return [" ".join(part) for part in parts]
