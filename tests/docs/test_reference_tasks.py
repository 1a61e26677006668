"""What readers want to know, and what users asked in public, is two steps from the first page."""

from __future__ import annotations

import posixpath

import pytest
from reference import LINK, manual_of, words
from searches import QUESTIONS, TASKS

ALL = [(task, page, said) for task, (_, page, said) in TASKS.items()] + [(q, *rest) for q, rest in QUESTIONS.items()]


def linked(path: str) -> set[str]:
    """The pages to which a page of the Markdown links."""
    text, folder = manual_of("real").pages[path], posixpath.dirname(path)
    links = {link.partition("#")[0].partition("?")[0] for _, link in LINK.findall(text)}
    return {posixpath.normpath(posixpath.join(folder, link)) for link in links if link.endswith(".md")}


@pytest.mark.parametrize("home", ["README.md", "docs/index.md"])
def test_each_answer_is_two_steps_away(home: str) -> None:
    one = linked(home)
    two = one.union(*(linked(path) for path in one))
    for task, page, said in ALL:
        path = f"docs/{page.replace('.html', '.md')}"
        assert path in two, task
        assert said in words(manual_of("real").pages[path]), (task, said)
