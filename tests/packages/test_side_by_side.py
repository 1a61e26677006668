"""The output of a user's specification has the names of its package: it is installed, built and linked beside that of
another. Both are made of one specification, so that nothing but the package can keep them apart."""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path

import pytest
from c_build import run
from mipgen import cli
from support import need, packaging

pytestmark = packaging

#: Package -> the folder of its output; `my_device` is what `mipgen new` writes.
Packages = dict[str, Path]

C = """\
#include "mip/mip.h"
#include "my_device/my_device.h"
#include <stdio.h>

int main(void) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_tools_light light;
    struct my_device_parser parser;
    struct my_device_packet packet;
    struct my_device_tools_light same;
    my_device_parser_init(&parser);
    if (mip_builder_start(&builder, buffer, sizeof buffer, MIP_TOOLS_SET) != MIP_OK ||
        mip_tools_light_encode(mip_tools_light_write(&light, MIP_TOOLS_LIGHT_MODE_ON, 7), &builder) != MIP_OK) {
        return 1;
    }
    const struct mip_packet sent = mip_builder_finish(&builder);
    const uint8_t *data = sent.bytes;
    size_t size = sent.size;
    while (my_device_parser_next(&parser, &data, &size, &packet)) {
        struct my_device_walk walk = my_device_walk_packet(&packet);
        struct my_device_field field;
        while (my_device_walk_next(&walk, &field)) {
            if (my_device_tools_light_decode(&same, &field) == MY_DEVICE_OK) {
                printf("%u %u\\n", same.mode, same.rate);
            }
        }
    }
    return 0;
}
"""


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Packages:
    folder = tmp_path_factory.mktemp("packages")
    assert cli.main(["new", str(folder / "spec")]) == 0
    made = {"my_device": folder / "own"}
    assert cli.main(["generate", "--spec", str(folder / "spec"), "--out", str(made["my_device"])]) == 0
    protocol = folder / "spec/protocol.yaml"
    text, changed = re.subn(
        "^title: .*\npackage: my_device\\b", "package: mip", protocol.read_text("utf-8"), flags=re.M
    )
    assert changed == 1
    protocol.write_text(text)
    made["mip"] = folder / "mip"
    assert cli.main(["generate", "--spec", str(folder / "spec"), "--out", str(made["mip"])]) == 0
    return made


def test_an_own_specification_says_nothing_of_others(packages: Packages) -> None:
    for path in packages["my_device"].rglob("*"):
        text = str(path.relative_to(packages["my_device"])) + (path.read_text("utf-8") if path.is_file() else "")
        found = re.findall(r"(?i).*(?:microstrain|mip-protocol|mip_protocol).*", text)
        assert not found, (path, found[0])


def test_no_name_is_left(packages: Packages) -> None:
    """What a compiler reads has no name of the package `mip`."""
    for language in ("c", "rust", "python", "kaitai", "wireshark"):
        for path in (packages["my_device"] / language).rglob("*"):
            if path.is_file() and path.name not in ("README.md", ".manifest"):
                assert not re.findall(r"\bmip_(?!tools)\w*|\bMIP_\w*", path.read_text("utf-8")), path


def test_python(packages: Packages, tmp_path: Path) -> None:
    site = tmp_path / "site"
    copies = [shutil.copytree(packages[name] / "python", tmp_path / name) for name in packages]
    run(sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--no-index",
        "--no-compile", "--disable-pip-version-check", "--target", site, *copies)  # fmt: skip
    assert {p.name.partition("-")[0] for p in site.glob("*.dist-info")} == {"mip_protocol", "my_device_protocol"}
    said = run(
        sys.executable, "-c",
        "import mip_protocol, my_device_protocol\n"
        "from mip_protocol import tools\n"
        "from my_device_protocol import tools as own\n"
        "packet = tools.Light.write(tools.LightMode.ON, 7).packet()\n"
        "(same,) = my_device_protocol.Parser().feed(bytes(packet))\n"
        "print(own.Light.find(same), my_device_protocol.registry.by_name('my_device_tools_light') is own.Light)\n"
        "print(mip_protocol.registry.by_name('mip_tools_light') is tools.Light, type(same).__module__)\n",
        PYTHONPATH=str(site),
    )  # fmt: skip
    assert said == "tools.light: function = write, mode = on, rate = 7 Hz True\n" + ("True my_device_protocol.packet\n")


def test_rust(packages: Packages, tmp_path: Path) -> None:
    import crates

    for name in packages:
        files = {
            path.relative_to(packages[name] / "rust").as_posix(): path.read_bytes()
            for path in (packages[name] / "rust").rglob("*")
            if path.is_file()
        }
        crates.write(crates.without_dependencies(files), tmp_path / name)
    crates.write(
        {
            "Cargo.toml": b'[package]\nname = "both"\nversion = "0.1.0"\nedition = "2021"\n[dependencies]\n'
            b'mip-protocol = { path = "../mip" }\nmy-device-protocol = { path = "../my_device" }\n[workspace]\n',
            "src/main.rs": b"use mip_protocol::tools::{Light, LightMode};\n"
            b"use my_device_protocol::tools as own;\n"
            b"fn main() {\n"
            b"    let packet = mip_protocol::PacketBuilder::with(&Light::write(LightMode::ON, 7)).unwrap();\n"
            b"    let same: own::Light = my_device_protocol::packets(packet.bytes()).next().unwrap()\n"
            b"        .find().unwrap().unwrap();\n"
            b'    println!("{:?} {:?}", same.mode.unwrap().0, same.rate.unwrap());\n'
            b"}\n",
        },
        tmp_path / "both",
    )
    said = run(
        need("cargo"), "run", "--quiet", "--offline", cwd=tmp_path / "both",
        CARGO_TARGET_DIR=str(tmp_path / "target"), **crates.PROFILE,
    )  # fmt: skip
    assert said.split() == ["1", "7"]


@pytest.mark.parametrize("how", ["subdirectory", "installed"])
def test_c(how: str, packages: Packages, tmp_path: Path) -> None:
    """A program with both in one source file; installed into one prefix, no file is that of both."""
    (tmp_path / "main.c").write_text(C)
    prefix = tmp_path / "prefix"
    found = ""
    for name in packages:
        if how == "subdirectory":
            found += f'add_subdirectory("{packages[name] / "c"}" {name})\n'
        else:
            found += f"find_package({name} 0.1 REQUIRED)\n"
            there = files_below(prefix)
            cmake("-S", packages[name] / "c", "-B", tmp_path / name, f"-DCMAKE_INSTALL_PREFIX={prefix}")
            run(need("cmake"), "--build", tmp_path / name)
            installed = run(need("cmake"), "--install", tmp_path / name)
            assert "Up-to-date" not in installed and files_below(prefix) > there
    (tmp_path / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.14)\nproject(main C)\n{found}"
        "add_executable(main main.c)\ntarget_link_libraries(main mip::mip my_device::my_device)\n"
    )
    cmake("-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    run(need("cmake"), "--build", tmp_path / "build")
    assert run(tmp_path / "build/main") == "1 7\n"


def cmake(*arguments: object) -> None:
    run(need("cmake"), "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={need('ninja')}", "-DCMAKE_INSTALL_LIBDIR=lib", *arguments)


def files_below(folder: Path) -> set[str]:
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}


def test_javascript(packages: Packages) -> None:
    names = [json.loads((packages[name] / "javascript/package.json").read_text())["name"] for name in packages]
    assert names == ["my-device-protocol", "mip-protocol"]


def test_what_refers_to_other_languages(packages: Packages) -> None:
    """The document and the manual use the names in those languages."""
    document = json.loads((packages["my_device"] / "json/mip.json").read_text("utf-8"))
    symbols = {f["name"]: f["symbols"] for f in document["fields"]}
    assert document["package"] == "my_device" and symbols["tools.light"] == {
        "c": "my_device_tools_light",
        "python": "my_device_protocol.tools.Light",
        "rust": "my_device_protocol::tools::Light",
        "javascript": "my-device-protocol/tools_.Light",
    }
    docs = packages["my_device"] / "markdown/docs"
    page = "".join((docs / path).read_text("utf-8") for path in ("fields/tools/light.md", "programs/tools.md"))
    for shown in ("my_device_call_tools_light_write(", "from my_device_protocol import", "use my_device_protocol::"):
        assert shown in page


def test_wireshark(packages: Packages) -> None:
    scripts = [f"-Xlua_script:{packages[name] / f'wireshark/{name}.lua'}" for name in packages]
    fields = run(need("tshark"), "-G", "fields", *scripts)
    for name in packages:
        assert f"\t{name}.tools.light.rate\t" in fields and f"\t{name}_protocol\n" in fields
