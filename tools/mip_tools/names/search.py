"""Searches the specification for words: fields that have more of them, rarer ones, or in their names, come first.

The ranking is BM25F (Robertson and Zaragoza, 2009), as in the search of the site (`tools/workbench/rank.mjs`). A word
also stands for words that begin with it, for its synonyms, and for two words written as one. If nothing has it, it
stands for the nearest known word, for the one with which it begins, or for the two that it consists of.
"""

from __future__ import annotations

import difflib
import math
import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cache

from ..binding import KEYWORDS, SETS, SYNONYMS, Command, Response, info, registry
from .occurrence import Occurrence

#: Weights of a word in names, in keywords, in the name of the set, in parameters, in descriptions.
_WEIGHTS = (6, 5, 2, 1.5, 1)
_SATURATION = 2
_BY_LENGTH = 0.4
_SYNONYM = 0.7
_LONGER = 0.7
#: Results with less than this part of the best score are left out.
_LEAST = 1 / 8
#: Words of questions that do not describe their subject, as in `rank.mjs`.
FILLING = frozenset(
    re.findall(
        "[a-z]+",
        """
        a about again also always am an and any anyone are as at be between by can cannot correctly could couple
        did do does doesn don during every for from get getting go goes got had has have help how i if in
        instead into is issue issues it its just keep keeps know like make makes me mean means much my need
        never no not of on one only or our please possible problem problems properly put question really same
        set several should show shows so some somehow something sometimes still t than that the their then there
        they this to trouble try trying use using want was way we what when where which while who why will with
        within without work works would you your
        """,
    )
)


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
    text = re.sub(r"(?<=[a-z0-9])(?=[A-Z][a-z])", " ", text)  # PpsSource
    scores: dict[Occurrence, float] = defaultdict(float)
    covered: dict[Occurrence, float] = defaultdict(float)
    parts = list(_parts(list(dict.fromkeys(_words(text)))))
    whole = 0.0
    for meant in parts:
        having = _having(meant)
        whole += max((rarity for _, rarity in having.values()), default=math.log(1 + len(_searched())))
        for field, (score, rarity) in having.items():
            scores[field] += score
            covered[field] += rarity
    stems = {stem for meant in parts for stem, weight in meant.items() if weight == 1}
    totals = {
        field: scores[field] * (covered[field] / whole) * (1 + _share_of(field, stems, len(parts)))
        for field in fields
        if field in scores
    }
    best = max(totals.values(), default=0)
    others = [f for f in totals if totals[f] >= best * _LEAST and f not in numbered]
    return numbered + sorted(others, key=lambda f: -totals[f])


def _having(meant: dict[str, float]) -> dict[Occurrence, tuple[float, float]]:
    """Returns the fields that have one of the stems: how much of it, and how rare it is; the best of a field counts."""
    postings, count = _index()[0], len(_searched())
    rarities = {stem: math.log(1 + (count - len(postings[stem]) + 0.5) / (len(postings[stem]) + 0.5)) for stem in meant}
    most = next((rarities[stem] for stem, weight in meant.items() if weight == 1), math.inf)
    found: dict[Occurrence, tuple[float, float]] = defaultdict(lambda: (0.0, 0.0))
    for stem, weight in meant.items():
        rarity = min(rarities[stem], most)
        for field, amount in postings[stem].items():
            score, before = found[field]
            found[field] = max(score, weight * rarity * amount / (_SATURATION + amount)), max(rarity, before)
    return found


def _share_of(field: Occurrence, stems: set[str], count: int) -> float:
    """Returns how well a field's title, or a keyword of which all words are asked for, is what was asked for, from 0 to
    1: how much of it is in the query, and it of the `count` words of the query."""
    about = info(field.kind)
    shares = []
    for i, phrase in enumerate((about.title, *KEYWORDS.get(about.name, ()))):
        words = [_stem(word) for word in _telling(_words(phrase))]
        common = sum(one in stems for one in words)
        if i == 0 or common == len(words):
            shares.append(common / len(words) * math.sqrt(min(1, common / count)))
    return max(shares)


def finds_any(text: str) -> bool:
    """Does a search find any field?"""
    return bool(ranked(all_fields(), text))


def _words(text: str) -> list[str]:
    return re.findall(r"\d+\.\d+|[a-z0-9]+", text.lower())


def _stem(word: str) -> str:
    """Removes the endings in which forms of a word differ.

    >>> {_stem(word) for word in ("calibrate", "calibrated", "calibration", "calibrations")}
    {'calibr'}
    >>> {_stem(word) for word in ("stopping", "stopped", "stops")}, _stem("manually"), _stem("measurement")
    ({'stop'}, 'manual', 'measur')
    >>> _stem("biases") == _stem("bias")
    True
    """
    if len(word) < 4 or re.search("[0-9]", word):
        return word
    plain = re.sub(r"(?<!s)s$", "", re.sub(r"(ies|ied|y)$", "i", word))
    if len(plain) < 5:
        return plain
    endings = r"((?<=.{4})(li|ness|able)|(?<=.{5})e?ment|at(ions?|e[ds]?|ing|ors?)|ions?|ing|ed|es|e)$"
    root = re.sub(endings, "", plain)
    return re.sub(r"(?<!s)s$", "", re.sub(r"([bdgmnprt])\1$", r"\1", root)) if root != plain else root


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


def _searched() -> list[Occurrence]:
    return [field for field in all_fields() if not (issubclass(field.kind, Response) and field.kind.COMMANDS)]


@cache
def _index() -> tuple[dict[str, dict[Occurrence, float]], list[str], dict[str, set[str]]]:
    """Returns stem -> field -> how much of it, all words, and stem -> stems of its synonyms."""
    split = {field: [_words(text) for text in _texts(field)] for field in _searched()}
    lengths = [[len(texts[i]) for texts in split.values() if texts[i]] for i in range(len(_WEIGHTS))]
    means = [sum(some) / len(some) if some else 1 for some in lengths]
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


def _telling(words: list[str]) -> list[str]:
    """Returns the words that describe the subject, or all words if none do."""
    return [word for word in words if word not in FILLING] or words


def _parts(words: list[str]) -> Iterator[dict[str, float]]:
    """Yields the stems that each word of a query stands for."""
    postings, index_words, _ = _index()
    words = _telling(words)
    for before, word, after in zip(["", *words], words, [*words[1:], ""]):
        pairs = [_stem(pair) for pair in (before + word, word + after) if pair != word]
        meant = _meant(word) | {stem: 1.0 for stem in pairs if stem in postings}
        near = [] if meant else difflib.get_close_matches(word, index_words, 1, 0.8)
        least = 4 if meant else 3  # letters of each half: "offset" is not "off" and "set"
        halves = ((word[:at], word[at:]) for at in range(least, len(word) - least + 1))
        both = next((two for two in halves if all(_stem(half) in postings for half in two)), ())
        parts = (word[:cut] for cut in range(len(word) - 1, max(3, len(word) * 2 // 3), -1))
        beginning = [] if meant or near or both else [part for part in parts if part in index_words][:1]
        for part in near or both or beginning or [word]:
            yield meant | _meant(part)


def _meant(word: str) -> dict[str, float]:
    """Returns the stems that a word stands for, with how much each counts."""
    (postings, _, synonyms), root = _index(), _stem(word)
    meant = {root: 1.0}
    if len(root) > 2:
        meant |= {stem: _LONGER for stem in postings if stem.startswith(root) and stem != root}
    meant |= {stem: _SYNONYM for stem in synonyms.get(root, ()) if stem not in meant}
    return {stem: weight for stem, weight in meant.items() if stem in postings}
