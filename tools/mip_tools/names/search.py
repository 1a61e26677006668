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
from itertools import pairwise

from ..binding import KEYWORDS, SETS, SYNONYMS, Command, Response, info, registry
from .occurrence import Occurrence, occurrence_in

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


#: What people write around the numbers of a set and a descriptor, as in `find.mjs`.
_AROUND = re.compile(r"\b(?:command|data|desc|descriptor|field|set)\b|[\s,:;/.()[\]{}=-]+")
#: 0x82 and 0x4, 82h and 4h, 82 and 4; or both together.
_SET, _DESCRIPTOR = re.compile("0x[0-9a-f]{1,2}h?|[0-9a-f]{1,2}h|[0-9a-f]{2}"), re.compile("(?:0x)?[0-9a-f]{1,2}h?")
_TOGETHER = re.compile("(?:0x)?([0-9a-f]{2})(?:0x)?([0-9a-f]{2})h?")


def numbered(text: str) -> list[Occurrence]:
    """Finds the fields of a set and a descriptor in hexadecimal: "0x0D13", "82 10", "(0x82,0x10)"; or else none."""
    words = _AROUND.sub(" ", text.lower()).split()
    together = _TOGETHER.fullmatch(words[0]) if len(words) == 1 else None
    words = list(together.groups()) if together else words
    if len(words) != 2 or not _SET.fullmatch(words[0]) or not _DESCRIPTOR.fullmatch(words[1]):
        return []
    number, descriptor = (int(word.rstrip("h"), 16) for word in words)
    return [occurrence_in(number, kind) for kind in registry.types(number, descriptor)]


def all_fields() -> list[Occurrence]:
    """Returns all fields of the specification."""
    return [Occurrence(*pair) for pair in registry.all_types()]


def ranked(fields: Sequence[Occurrence], text: str) -> list[Occurrence]:
    """Returns the fields that have words of a text, the best first; before them, those of its numbers.

    A response is found by its number only; its words find its command.
    """
    first = numbered(text)
    numbers = {int(number) for number in re.findall(r"(?<![\w.,])\d{4,5}(?![\w.,])", text)}  # MSCL: "command (3399)"
    numbers |= {int(a + b, 16) for a, b in re.findall(r"(?i)\b0x([0-9a-f]{2})[\s,]*(?:0x)?([0-9a-f]{2})\b", text)}
    first += [f for f in fields if f.set << 8 | f.kind.DESCRIPTOR in numbers and f not in first]
    first = [f for f in first if f in fields]
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
    others = [f for f in totals if totals[f] >= best * _LEAST and f not in first]
    return first + sorted(others, key=lambda f: -totals[f])


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


def missing(text: str) -> list[tuple[str, str]]:
    """Returns the words of a text that no field has, each with those that were searched for; "" for none."""
    split = re.sub(r"(?<=[a-z0-9])(?=[A-Z][a-z])", " ", text)
    words = _telling(list(dict.fromkeys(_words(split)))) if not numbered(text) else []
    joined = {word for pair in pairwise(words) if _stem("".join(pair)) in _index()[0] for word in pair}
    return [(word, " ".join(_instead(word))) for word in words if not _meant(word) and word not in joined]


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
    postings = _index()[0]
    words = _telling(words)
    for before, word, after in zip(["", *words], words, [*words[1:], ""]):
        pairs = [_stem(pair) for pair in (before + word, word + after) if pair != word]
        meant = _meant(word) | {stem: 1.0 for stem in pairs if stem in postings}
        for part in _halves(word, 4) if meant else _instead(word) or [word]:  # "offset" is not "off" and "set"
            yield meant | _meant(part)


def _halves(word: str, least: int) -> Sequence[str]:
    """Returns the two known words of which one consists, or the word."""
    halves = ((word[:at], word[at:]) for at in range(least, len(word) - least + 1))
    return next((two for two in halves if all(_stem(half) in _index()[0] for half in two)), (word,))


def _instead(word: str) -> Sequence[str]:
    """Returns the known words for which an unknown one stands; empty for none.

    A short word, from which many differ in a letter, may only lack one, or have two exchanged.
    """
    index_words = _index()[1]
    if len(word) > 5:
        near = difflib.get_close_matches(word, index_words, 1, 0.8)
    else:
        swapped = {word[:at] + word[at + 1] + word[at] + word[at + 2 :] for at in range(len(word) - 1)}
        lacks = (one for one in index_words if any(one[:at] + one[at + 1 :] == word for at in range(len(one))))
        near = [*swapped.intersection(index_words), *lacks] if len(word) > 3 else []
    if near or len(both := _halves(word, 3)) == 2:
        return near[:1] or both
    parts = (word[:cut] for cut in range(len(word) - 1, max(4, len(word) * 2 // 3), -1))
    return [part for part in parts if part in index_words][:1]


def _meant(word: str) -> dict[str, float]:
    """Returns the stems that a word stands for, with how much each counts."""
    (postings, _, synonyms), root = _index(), _stem(word)
    meant = {root: 1.0}
    if len(root) > 2:
        meant |= {stem: _LONGER for stem in postings if stem.startswith(root) and stem != root}
    meant |= {stem: _SYNONYM for stem in synonyms.get(root, ()) if stem not in meant}
    return {stem: weight for stem, weight in meant.items() if stem in postings}
