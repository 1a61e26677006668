"""The workflows on GitHub: actionlint accepts them, and only jobs that publish may write."""

from __future__ import annotations

import subprocess

import yaml
from support import BUILD, ROOT, nightly

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
