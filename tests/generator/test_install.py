"""The program as people install it: from a wheel, from a source distribution, on other Pythons, in any folder."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

import pytest
from c_build import run
from mipgen import __version__
from support import ROOT, SPECS, another_python, nightly, packaging, tree

pytestmark = packaging
INVENTED, GOLDEN = SPECS["invented"]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a source distribution, and with a wheel that is made from it."""
    out = tmp_path_factory.mktemp("built")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", out, ROOT)
    return out


def wheel(built: Path) -> Path:
    return next(built.glob("*.whl"))


def environment(folder: Path, python: str = sys.executable) -> Path:
    """The bin folder of a new virtual environment with nothing in it."""
    run(python, "-m", "venv", "--without-pip", folder)
    return folder / "bin"


def install(bin_folder: Path, *what: str | Path) -> None:
    run(sys.executable, "-m", "pip", "--python", bin_folder / "python", "install", "--quiet", *what)


def borrow_libraries(bin_folder: Path) -> None:
    """Lets an environment use what is installed here, as installing all of it takes long."""
    (site,) = bin_folder.parent.glob("lib/python*/site-packages")
    here = [p for p in sys.path if p.endswith("site-packages")]
    (site / "borrowed.pth").write_text("\n".join(here))


def use(mipgen: Path, folder: Path) -> None:
    """From nothing to bindings, and the known output of a known specification."""
    folder.mkdir()
    assert run(mipgen, "--version", cwd=folder) == f"mipgen {__version__}\n"
    run(mipgen, "new", "spec", cwd=folder)
    assert run(mipgen, "validate", cwd=folder).startswith("2 sets: ")
    assert "python " in run(mipgen, "generate", cwd=folder)
    assert "generated is up to date" in run(mipgen, "check", cwd=folder)
    assert (folder / "generated/python/my_device_protocol/tools.py").is_file()
    run(mipgen, "generate", "--spec", INVENTED, "--out", folder / "out", cwd=folder)
    assert tree(folder / "out") == tree(GOLDEN)


def test_what_is_installed_works_in_any_folder(built: Path, tmp_path: Path) -> None:
    bin_folder = environment(tmp_path / "venv")
    install(bin_folder, "--no-deps", wheel(built))
    borrow_libraries(bin_folder)
    assert run(bin_folder / "python", "-c", "import mipgen; print(mipgen.__file__)").startswith(str(tmp_path))
    use(bin_folder / "mipgen", tmp_path / "work")


def test_the_wheel_holds_all_of_its_files(built: Path) -> None:
    with zipfile.ZipFile(wheel(built)) as archive:
        held = {name for name in archive.namelist() if ".dist-info/" not in name}
    parts = ("generator", "templates", "runtime", "spec/schema", "examples", "docs/parts", "LICENSE")
    listed = run("git", "ls-files", *parts, cwd=ROOT).splitlines()
    there = [name for name in listed if (ROOT / name).is_file()]
    assert held == {
        name.removeprefix("generator/") if name.startswith("generator/") else f"mipgen/data/{name}" for name in there
    }


#: The versions between the oldest and the newest one, which hardly differ from both.
BETWEEN = [pytest.param(version, marks=nightly("installed on Pythons in between")) for version in ("3.11", "3.12")]


@pytest.mark.parametrize("version", ["3.10", *BETWEEN, "3.13"])
def test_installed_on_every_python(built: Path, tmp_path: Path, version: str) -> None:
    """With all libraries from the registry, in the newest versions that the package allows; from the sources."""
    bin_folder = tmp_path / "venv/bin"
    run(another_python(version), "-m", "venv", bin_folder.parent)  # with its own pip: an older one may not know it
    run(bin_folder / "python", "-m", "pip", "install", "--quiet", next(built.glob("*.tar.gz")))
    use(bin_folder / "mipgen", tmp_path / "work")
