"""Checks the words of the specification, as far as a machine can: a summary is not a question and one sentence.

    python tests/wording.py [FOLDER]

It reports style, not errors of a specification, so `make check` runs it, and `mipgen validate` does not.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import yaml

#: Keys of texts that quote a source.
QUOTED = {"section", "sections", "printed", "right", "string", "document"}
#: Keys that mark a field of a set.
FIELDS = {"command", "data", "descriptor"}
QUESTION = re.compile(r"(?:What|Where|Which|Whether|How|Why)\b")
#: Verbs that nearly always replace a better one: return, accept, require, state, contain.
VAGUE = re.compile(
    r"\b(?:gives?|says?|tells?|takes?(?! (?:effect|place|precedence|over|longer|as long|up to|\d|a few)))\b"
)
BETTER = "return, accept, require, state, contain"


def texts(node: yaml.Node, key: str = "", owner: tuple[str, ...] = ()) -> Iterator[tuple[int, str, str, set[str]]]:
    """Line, key and text of what people read, with the keys beside it."""
    match node:
        case yaml.MappingNode():
            keys = {k.value for k, _ in node.value}
            for k, v in node.value:
                yield from texts(v, k.value, tuple(sorted(keys)))
        case yaml.SequenceNode():
            for v in node.value:
                yield from texts(v, key, owner)
        case yaml.ScalarNode() if key not in QUOTED:
            yield node.start_mark.line + 1, key, " ".join(node.value.split()), set(owner)


def findings(path: Path) -> Iterator[str]:
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    for line, key, text, beside in texts(yaml.compose(path.read_text("utf-8"), loader)):
        summary = re.split(r"(?<=\w\w[.!?]) (?=[A-Z`])", text)[0]
        if key == "description" and QUESTION.match(text):
            yield f"{path}:{line}: “{summary}” is a question; name the thing, or begin with a verb"
        if key == "description" and " " in text and not re.match(r"[A-Z`\d].*[.:]$", text):
            yield f"{path}:{line}: “{text[:80]}”: begin with a capital letter, and end with a full stop"
        if key == "description" and FIELDS & beside and ";" in summary:
            yield f"{path}:{line}: “{summary}”: divide it into sentences; the first one is a summary"
        if key == "description" and "command" in beside and not re.match(r"[A-Z][a-z]+s\b", text):
            yield f"{path}:{line}: “{summary}”: a command begins with a verb: Sets, Returns, Enables"
        if " " in text and (found := VAGUE.search(text)):
            yield f"{path}:{line}: “{found[0]}” in “{text[:80]}”: write {BETTER}"


def main(folders: list[str]) -> int:
    paths = [p for folder in folders for p in sorted(Path(folder).rglob("*.yaml")) if "witness" not in p.parts]
    found = [x for path in paths for x in findings(path)]
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or ["spec"]))
