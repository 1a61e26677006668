"""Reads a list of changes to ignore, each with the reason:

    ignore:
      - {subject: 3dm.gyro_bias.bias, class: unit, reason: The old unit was a misprint of ours.}

Without a `class`, every change of the subject is ignored. `*` in a subject matches any text. An entry that matches no
change is an error, so that the list contains no outdated entries.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from pathlib import Path

from mipgen.model import Position
from mipgen.read.nodes import Node, read
from mipgen.read.problems import Problems, nearest

from .changes import CLASSES, Change, Report, worst

KEYS = ("subject", "class", "reason")


@dataclass(frozen=True, slots=True)
class Entry:
    subject: str
    kind: str | None
    reason: str
    position: Position

    def ignores(self, change: Change) -> bool:
        return fnmatchcase(change.subject, self.subject) and self.kind in (None, change.kind)


def entries(path: Path) -> list[Entry]:
    """Reads the entries of a list; raises SpecError with all problems."""
    problems = Problems()
    root = read(path, str(path), problems)
    problems.raise_if_any()
    assert root is not None
    listed = root.get("ignore") if isinstance(root.value, dict) and list(root.value) == ["ignore"] else None
    if listed is None or not isinstance(listed.value, list):
        problems.add(root.position, "a list of changes to ignore is a mapping with the one key 'ignore', a list")
        problems.raise_if_any()
    assert listed is not None
    valid = [entry for node in listed if (entry := _entry(node, problems)) is not None]
    problems.raise_if_any()
    return valid


def _entry(node: Node, problems: Problems) -> Entry | None:
    if not isinstance(node.value, dict):
        problems.add(node.position, "an entry has the keys 'subject' and 'reason', and perhaps 'class'")
        return None
    before = len(problems)
    for key, value in node.items():
        if key not in KEYS:
            problems.add(node.keys[key], f"unknown key '{key}'{nearest(key, KEYS)}")
        elif not isinstance(value.value, str) or not value.value.strip():
            problems.add(value.position, f"'{key}' must be text")
    for key in ("subject", "reason"):
        if key not in node:
            problems.add(node.position, f"'{key}' is missing in the entry")
    kind = node.scalar("class")
    if isinstance(kind, str) and kind not in CLASSES:
        problems.add(node["class"].position, f"unknown class '{kind}'{nearest(kind, CLASSES)}")
    if len(problems) > before:
        return None
    return Entry(node["subject"].value, kind, node["reason"].value, node.position)


def without_ignored(report: Report, listed: list[Entry]) -> Report:
    """Moves these changes to the ignored ones of the report; raises SpecError if an entry matches no change."""
    problems = Problems()
    for entry in listed:
        if not any(map(entry.ignores, report.changes)):
            what = f"the class '{entry.kind}' of '{entry.subject}'" if entry.kind else f"'{entry.subject}'"
            problems.add(entry.position, f"there is no change of {what}; remove the entry")
    problems.raise_if_any()
    reasons = [(c, next((e.reason for e in listed if e.ignores(c)), None)) for c in report.changes]
    changes = tuple(c for c, reason in reasons if reason is None)
    ignored = tuple((c, reason) for c, reason in reasons if reason is not None)
    return replace(report, verdict=worst(changes), changes=changes, ignored=ignored)
