"""Explains why a text is not YAML, at the position that its author must correct.

The parser stops where it cannot continue, which may be far below the mistake: an unclosed quote extends to the next
quote.
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import yaml

from . import spelling

LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class Fault(NamedTuple):
    """A fault, with its line and column, which count from 0."""

    line: int
    column: int
    message: str


#: Message of the parser -> remedy. {c}: the character at which it stopped, {line}: the line where a block begins.
_REMEDIES = {
    "cannot start any token": "a text cannot begin with {c}; put it in quotes",
    "did not find expected comment or line break": "a text cannot begin with | or >; put it in quotes",
    "did not find expected node content": "a value is missing before '{c}'; write it, or put text in quotes",
    "did not find expected ',' or": "a comma is missing here, or quotes around a text that contains ',' or ': '",
    "block sequence entries are not allowed": "a list begins on the line below its key",
    "found unknown escape character": "an unknown escape; write '\\\\' for a backslash, or use single quotes",
    "did not find expected '-' indicator":
        "this line is neither an item nor a key of the list that begins on line {line}; check '- ' and indentation",
    "did not find expected key":
        "this line is not a key of the mapping that begins on line {line}; check its indentation",
}  # fmt: skip

_UNCLOSED_QUOTE = "the quote that opens here is not closed on this line; close it, or remove it"

_OPENING = (yaml.FlowSequenceStartToken, yaml.FlowMappingStartToken)
_CLOSING = {yaml.FlowSequenceEndToken: _OPENING[0], yaml.FlowMappingEndToken: _OPENING[1]}

#: What may follow a quoted text: the end of its line, a comment, or the rest of a bracket.
_BEHIND_QUOTE = re.compile(r"[ \t]*(?:$|[,\]}\r]|[ \t]#)", re.MULTILINE)
_BEHIND_KEY = re.compile(r"[ \t]*:")

_KEY = r" *(?:- +)*[\w.-]+"

#: Characters used instead of a space, or of a quote at the beginning of a text.
_MISLEADING = re.compile("[\u00a0\u2002-\u200b\u202f\u3000]|(?<=[ \\[{,])[\u201c\u201d\u201e\u2018\u2019\u201a]")

_INDENTED = re.compile(" *[\u00a0\u2002-\u200b\u202f\u3000]")


def explain(text: str, error: yaml.MarkedYAMLError) -> Fault:
    text = text.removeprefix("\ufeff")
    explained = _explain(text, error)
    misleading = "".join(_MISLEADING.findall(_line(text, explained.line)))
    return explained._replace(message=explained.message + spelling.strange(misleading))


def _explain(text: str, error: yaml.MarkedYAMLError) -> Fault:
    mark: Any = error.problem_mark or error.context_mark
    began: Any = error.context_mark or mark
    problem = str(error.problem or error.context)
    stop = text[mark.index : mark.index + 1]
    for number, line in enumerate(text.splitlines()[: mark.line + 1]):
        if sign := _INDENTED.match(line):
            return Fault(number, sign.end() - 1, "a character that only looks like a space; indent with spaces")
    if stop == "\t":
        return _fault(mark, "a tab; indent with spaces")
    if "unexpected end of stream" in problem:
        return _fault(began, _UNCLOSED_QUOTE)
    if unbalanced := _unbalanced(text, mark.index, began.index):
        return unbalanced
    if "could not find expected ':'" in problem:
        return _fault(began, "a key without its colon; write 'key: value', with a space after the colon")
    if "mapping values are not allowed" in problem or "expected <document start>" in problem:
        return _misplaced_colon(text, mark)
    if sign := re.search(r"[ \[{]([*&!])\S* *$", _line(text, mark.line)[: mark.column]):
        return _fault(mark, f"a text cannot begin with {sign[1]}; put it in quotes")
    remedies = (remedy for words, remedy in _REMEDIES.items() if words in problem)
    return _fault(mark, next(remedies, problem).format(c=stop, line=began.line + 1))


def _fault(mark: Any, message: str) -> Fault:
    return Fault(mark.line, mark.column, message)


def _line(text: str, number: int) -> str:
    lines = text.splitlines()
    return lines[number] if 0 <= number < len(lines) else ""


def _unbalanced(text: str, end: int, began: int) -> Fault | None:
    """Finds the first quote or bracket up to `end` that is not closed, or that closes nothing.

    `began`: the beginning of the mapping or list that the parser could not finish.
    """
    opened: list[Any] = []
    try:
        for token in yaml.scan(text, Loader=LOADER):
            mark = token.start_mark
            if isinstance(token, yaml.ScalarToken) and token.style in ("'", '"') and mark.index <= end:
                behind, one_line = token.end_mark.index, mark.line == token.end_mark.line
                if _BEHIND_QUOTE.match(text, behind) or (one_line and (opened or _BEHIND_KEY.match(text, behind))):
                    continue
                if one_line:
                    return _fault(token.end_mark, "text after the closing quote; include it in the quotes")
                return _fault(mark, _UNCLOSED_QUOTE)
            if isinstance(token, _OPENING):
                opened.append(token)
            elif isinstance(token, tuple(_CLOSING)):
                sign = text[mark.index]
                if not opened:
                    return _fault(mark, f"'{sign}' closes nothing; remove it")
                if not isinstance(opened[-1], _CLOSING[type(token)]):
                    place = f"'{sign}' on line {mark.line + 1}, column {mark.column + 1}"
                    return _unclosed(text, opened[-1], f" before the {place}")
                opened.pop()
    except yaml.YAMLError:  # the scan stopped in the middle, where other brackets may be open
        opened = [bracket for bracket in opened if bracket.start_mark.index == began]
    return _unclosed(text, opened[-1]) if opened else None


def _unclosed(text: str, bracket: Any, where: str = "") -> Fault:
    mark = bracket.start_mark
    return _fault(mark, f"the '{text[mark.index]}' that opens here is not closed{where}")


def _misplaced_colon(text: str, mark: Any) -> Fault:
    """Explains a colon where no key can be: in a text, below a line without a colon, or on a line indented too far."""
    if mark.column and not re.fullmatch(_KEY, _line(text, mark.line)[: mark.column]):
        return _fault(mark, "a text that contains ': ' must be in quotes")
    above = mark.line - 1
    while above > 0 and _line(text, above).lstrip()[:1] in ("", "#"):
        above -= 1
    line = _line(text, above)
    column = len(line) - len(line.lstrip())
    if re.match(_KEY + r":[^ \t]", line):
        return Fault(above, column, "a space is missing after the colon")
    if re.fullmatch(_KEY + " *", line):
        return Fault(above, column, "a key without its colon; write 'key: value'")
    if ":" in line:
        return _fault(mark, "this line is indented further than the keys above it; indent them alike")
    return _fault(mark, "the line above lacks the colon after its key, or belongs in quotes together with this one")
