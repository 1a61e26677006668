"""A vendored part of the C library: folders that are left out, by hand and by `mipgen generate --without`."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from c_build import WARNINGS, builds, folder, headers, run
from mipgen import cli
from support import SPECS, need, small, uses

COMBINATIONS = ["core", "core sets", "core sets extra", "core sets cpp", "core sets extra cpp"]


def builds_in_cpp(made: Path) -> None:
    program = made / "main.cpp"
    program.write_text("".join(f'#include "{name}"\n' for name in headers(made, ".hpp")) + "int main() {}\n")
    run(need("g++"), "-std=c++17", *WARNINGS, f"-I{made}/src", "-fsyntax-only", program)


@small("each part of the real C library")
@pytest.mark.parametrize("parts", [pytest.param(x, marks=uses("g++")) if "cpp" in x else x for x in COMBINATIONS])
def test_folders_are_parts(parts: str, spec: str, tmp_path: Path) -> None:
    source, copy = folder(spec) / "src/mip", tmp_path / "src/mip"
    copy.mkdir(parents=True)
    for path in source.iterdir():
        if path.is_file():
            shutil.copyfile(path, copy / path.name)
        elif path.name in parts.split():
            shutil.copytree(path, copy / path.name)
    if "cpp" in parts:  # with the sources of the same parts without it
        builds_in_cpp(tmp_path)
    else:
        builds(tmp_path, headers(tmp_path))


# --------------------------------------------------------------------------- mipgen generate --without


def generated(out: Path, spec: str, *options: str) -> Path:
    assert cli.main(["generate", "--spec", str(SPECS[spec][0]), "--out", str(out), "--target", "c", *options]) == 0
    return out / "c"


@small("the real C library without parts")
@pytest.mark.parametrize("parts", ["extra", "cpp", "extra,cpp"])
def test_what_is_left_out_is_in_no_file(parts: str, spec: str, tmp_path: Path) -> None:
    made = generated(tmp_path, spec, "--without", parts)
    pages = [*made.rglob("*.md")]
    named = [*pages, made / "cmake/sources.cmake", *made.rglob("examples/**/*.*")]
    text = "".join(path.read_text("utf-8") for path in named)
    for name in parts.split(","):
        assert not (made / "src/mip" / name).exists()
        assert f"mip/{name}/" not in text and f"`{name}/" not in text
    for page in pages:
        links = re.findall(r"\]\(([\w./-]+)[)#]", page.read_text("utf-8"))
        assert [link for link in links if not (page.parent / link).exists()] == [], page
    assert "cpp" not in parts or not list(made.rglob("*.[hc]pp"))
    listed = (made / "cmake/sources.cmake").read_text("utf-8")
    assert listed.count(".c\n") == len(list(made.rglob("src/mip/**/*.c")))
    if parts == "extra,cpp":  # the sources without either are those without one
        builds(made, headers(made))


@uses("g++")
def test_cpp_builds_without_extra(tmp_path: Path) -> None:
    builds_in_cpp(generated(tmp_path, "invented", "--without", "extra"))


def test_a_device_has_only_its_profile(tmp_path: Path) -> None:
    made = generated(tmp_path, "real", "--device", "3dm-gx5-15", "--set", "base")
    profiles = (made / "src/mip/extra/profiles.h").read_text("utf-8")
    assert re.findall(r"struct mip_profile (mip_profile_\w+);", profiles) == ["mip_profile_gx5_15"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("c", "extra,cp"), "no selected target has the part 'cp'; c has cpp, extra"),
        (("rust", "extra"), "no selected target has the part 'extra', or any other"),
    ],
)
def test_unknown_parts_are_refused(options: tuple[str, str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    target, parts = options
    assert cli.main(["generate", "--spec", str(SPECS["invented"][0]), "--target", target, "--without", parts]) == 1
    assert message in capsys.readouterr().err
