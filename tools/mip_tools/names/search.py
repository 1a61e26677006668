"""Searches the specification for words: fields that have more of them, rarer ones, or in their names, come first.

The ranking is BM25F (Robertson and Zaragoza, 2009), as in the search of the site (`tools/workbench/rank.mjs`). A word
also stands for words that begin with it, for its synonyms, and for two words written as one. If nothing has it, it
stands for the nearest known word, or for the two that it consists of.
"""

from __future__ import annotations

import difflib
import math
import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cache

from ..binding import KEYWORDS, SETS, SYNONYMS, info, registry
from .occurrence import Occurrence

#: Weights of a word in names and keywords, in the name of the set, in parameters, in descriptions.
_WEIGHTS = (6, 2, 1.5, 1)
_SATURATION = 1.2
_BY_LENGTH = 0.6
_SYNONYM = 0.6
_LONGER = 0.7
#: Results with less than this part of the best score are left out.
_LEAST = 1 / 8
#: Words of questions that do not describe their subject, as in `rank.mjs`.
FILLING = frozenset(
    re.findall(
        "[a-z]+",
        """
        a about am an and any are as at be by can cannot could did do does doesn don for from get got had has have
        how i if in into is it its just like me mean means much my need no not of on one only or our please set
        should so still t than that the their then there they this to use using want was way we what when where
        which while who why will with without work works would you your
        """,
    )
)


def all_fields() -> list[Occurrence]:
    """Returns all fields of the specification."""
    return [Occurrence(*pair) for pair in registry.all_types()]


def ranked(fields: Sequence[Occurrence], text: str) -> list[Occurrence]:
    """Returns the fields that have words of a text, the best first."""
    postings = _index()[0]
    scores: dict[Occurrence, float] = defaultdict(float)
    covered: dict[Occurrence, float] = defaultdict(float)
    whole, count = 0.0, len(all_fields())
    for meant in _parts(list(dict.fromkeys(_words(text)))):
        amounts: dict[Occurrence, float] = defaultdict(float)
        for root, weight in meant.items():
            for field, amount in postings[root].items():
                amounts[field] += weight * amount
        rarity = math.log(1 + (count - len(amounts) + 0.5) / (len(amounts) + 0.5))
        whole += rarity
        for field, amount in amounts.items():
            scores[field] += rarity * amount / (_SATURATION + amount)
            covered[field] += rarity
    totals = {field: scores[field] * (covered[field] / whole) ** 2 for field in fields if field in scores}
    best = max(totals.values(), default=0)
    return sorted((f for f in totals if totals[f] >= best * _LEAST), key=lambda f: -totals[f])


def finds_any(text: str) -> bool:
    """Does a search find any field?"""
    return bool(ranked(all_fields(), text))


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z0-9]+", text.lower())


def _stem(word: str) -> str:
    """Removes the endings in which forms of a word differ.

    >>> {_stem(word) for word in ("calibrate", "calibrated", "calibration", "calibrations")}
    {'calibr'}
    """
    if len(word) < 4 or re.search("[0-9]", word):
        return word
    plain = re.sub(r"(?<!s)s$", "", re.sub(r"(ies|y)$", "i", word))
    return re.sub(r"(at(ions?|e[ds]?|ing|ors?)|ions?|ing|ed|es|e)$", "", plain) if len(plain) > 4 else plain


def _texts(field: Occurrence) -> tuple[str, str, str, str]:
    """Returns what is searched, one text for each weight."""
    about = info(field.kind)
    names = [field.name.split(".")[-1], about.title, *about.also, *KEYWORDS.get(about.name, ())]
    parameters = about.parameters
    texts = [about.text, *(p.text for p in parameters)]
    return " ".join(names), " ".join(SETS.get(field.set, ())), " ".join(p.name for p in parameters), " ".join(texts)


@cache
def _index() -> tuple[dict[str, dict[Occurrence, float]], list[str], dict[str, set[str]]]:
    """Returns stem -> field -> how much of it, all words, and stem -> stems of its synonyms."""
    split = {field: [_words(text) for text in _texts(field)] for field in all_fields()}
    means = [sum(len(texts[i]) for texts in split.values()) / len(split) or 1 for i in range(len(_WEIGHTS))]
    postings: dict[str, dict[Occurrence, float]] = defaultdict(lambda: defaultdict(float))
    for field, texts in split.items():
        for weight, mean, some in zip(_WEIGHTS, means, texts, strict=True):
            for word in set(some):
                postings[_stem(word)][field] += weight / (1 - _BY_LENGTH + _BY_LENGTH * len(some) / mean)
    synonyms: dict[str, set[str]] = defaultdict(set)
    for group in SYNONYMS:
        roots = {_stem(word) for word in group}
        for root in roots:
            synonyms[root] |= roots
    return dict(postings), sorted({word for texts in split.values() for some in texts for word in some}), synonyms


def _parts(words: list[str]) -> Iterator[dict[str, float]]:
    """Yields the stems that each word of a query stands for."""
    postings, index_words, _ = _index()
    words = [word for word in words if word not in FILLING] or words
    for before, word, after in zip(["", *words], words, [*words[1:], ""]):
        pairs = [_stem(pair) for pair in (before + word, word + after) if pair != word]
        meant = _meant(word) | {stem: 1.0 for stem in pairs if stem in postings}
        near = [] if meant else difflib.get_close_matches(word, index_words, 1, 0.8)
        least = 4 if meant else 3  # letters of each half: "offset" is not "off" and "set"
        halves = ((word[:at], word[at:]) for at in range(least, len(word) - least + 1))
        both = next((two for two in halves if all(_stem(half) in postings for half in two)), ())
        for part in near or both or [word]:
            yield meant | _meant(part)


def _meant(word: str) -> dict[str, float]:
    """Returns the stems that a word stands for, with how much each counts."""
    (postings, _, synonyms), root = _index(), _stem(word)
    meant = dict.fromkeys(synonyms.get(root, ()), _SYNONYM)
    if len(root) > 2:
        meant |= dict.fromkeys((stem for stem in postings if stem.startswith(root)), _LONGER)
    return {stem: weight for stem, weight in (meant | {root: 1.0}).items() if stem in postings}
