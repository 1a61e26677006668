"""The workflows on GitHub: actionlint accepts them, and only jobs that publish may write."""

from __future__ import annotations

import importlib
import re
import subprocess
import sys

import yaml
from support import BUILD, ROOT, nightly

sys.path.insert(0, str(ROOT / "tools/release"))
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))


@nightly("actionlint, which needs Go")
def test_actionlint_finds_nothing() -> None:
    tool = BUILD / "tools/bin/actionlint"
    done = subprocess.run([tool, *WORKFLOWS], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_only_jobs_that_publish_may_do_more_than_read() -> None:
    for path in WORKFLOWS:
        workflow = yaml.safe_load(path.read_text("utf-8"))
        assert "write" not in workflow["permissions"].values() or path.name == "pages.yml"
        for name, job in workflow["jobs"].items():
            if "write" in job.get("permissions", {}).values():
                assert path.name == "release.yml", (path.name, name)


def test_registries_follow_one_another() -> None:
    """What can be undone comes first: each job needs the one before it."""
    jobs = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text("utf-8"))["jobs"]
    order = ["draft", *importlib.import_module("publish").REGISTRIES, "github"]
    assert [jobs[later]["needs"] for later in order[1:]] == order[:-1]


def test_actions_of_others_are_pinned() -> None:
    used = [line for path in WORKFLOWS for line in path.read_text("utf-8").splitlines() if "uses: " in line]
    others = [line.partition("uses: ")[2] for line in used if "uses: actions/" not in line]
    assert others
    assert [name for name in others if not re.fullmatch(r"\S+@[0-9a-f]{40}  # v[0-9.]+", name)] == []
