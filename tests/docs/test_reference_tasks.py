"""What readers want to know, and what users asked in public: two steps from the first page, and found by words."""

from __future__ import annotations

import posixpath

import pytest
from reference import LINK, manual_of, real_site, words
from searches import QUESTIONS, TASKS
from test_reference_site import searched

pytestmark = pytest.mark.xdist_group("site")  # which is built once

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


@real_site
def test_each_is_found_by_its_words() -> None:
    wanted = {query: page for query, page, _ in TASKS.values()} | {q: page for q, (page, _) in QUESTIONS.items()}
    found = searched(list(wanted))
    first = {query: (found[query] or [""])[0] for query in wanted}
    assert {q: first[q] for q, page in wanted.items() if first[q].partition("#")[0].partition("?")[0] != page} == {}
