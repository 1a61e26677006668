"""No input makes the generator fail with anything but a list of problems."""

from __future__ import annotations

import copy
import random
from pathlib import Path
from typing import Any

import pytest
import yaml
from bad_spec_files import BASE
from mipgen.read import nodes
from mipgen.read.loader import LAYOUT
from mipgen.read.problems import Problems, SpecError
from mipgen.resolve.load import load_model
from random_values import chance as chance_of
from support import rounds

INVENTED = Path(__file__).parents[1] / "invented/spec"
#: For a longer search: NIGHTLY=1 SEED=7 pytest tests/generator/test_mutations.py
MUTATIONS = rounds(30, 3000)

ODD_VALUES: list[Any] = [
    None, True, 0, -1, 3, 255, 256, 2.5, 1e400, 1 << 70, "", "x", "rest", "u8", "0x80", "²", [], {}, [1], {"x": 1}
]  # fmt: skip

Tree = Any


def files(spec: Path) -> dict[str, Tree]:
    """Every file as plain values."""
    paths = [path for pattern in LAYOUT.values() for path in sorted(spec.glob(pattern))]
    found = {path.relative_to(spec).as_posix(): nodes.read(path, "", Problems()) for path in paths}
    return {name: root.plain() for name, root in found.items() if root is not None}


def places(tree: Tree) -> list[tuple[Tree, Any]]:
    """All (container, key) in a tree."""
    keys = list(tree) if isinstance(tree, dict) else list(range(len(tree))) if isinstance(tree, list) else []
    return [(tree, key) for key in keys] + [found for key in keys for found in places(tree[key])]


def mutate(tree: Tree, chance: random.Random, others: list[Tree]) -> str:
    """Changes one place of a tree, and says how."""
    if not places(tree):
        return "nothing"
    container, key = chance.choice(places(tree))
    kind = chance.choice(["delete", "retype", "retype", "duplicate", "move", "rename", "graft"])
    if kind == "delete":
        del container[key]
    elif kind == "retype":
        container[key] = copy.deepcopy(chance.choice(ODD_VALUES))
    elif kind == "duplicate" and isinstance(container, list):
        container.insert(key, container[key])
    elif kind == "rename" and isinstance(container, dict):
        container[chance.choice(["name", "type", "values", str(key) + "_x"])] = container.pop(key)
    else:
        source, other = chance.choice(places(tree if kind == "move" else chance.choice(others)) or [([None], 0)])
        container[key] = copy.deepcopy(source[other])
    return f"{kind} {key!r}"


class Plain(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
    """Writes no aliases."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


@pytest.mark.parametrize("spec", [BASE, INVENTED], ids=["base", "invented"])
def test_only_problems_come_out(spec: Path, tmp_path: Path) -> None:
    whole = files(spec)
    good = {name: (spec / name).read_text("utf-8") for name in whole}
    for name, text in good.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, "utf-8")
    load_model(tmp_path)
    chance = chance_of(spec.name, spec.parent.name)
    refused = 0
    for turn in range(MUTATIONS):
        trees = copy.deepcopy(whole)
        name = chance.choice(sorted(trees))
        done = [mutate(trees[name], chance, list(trees.values())) for _ in range(chance.choice([1, 1, 2]))]
        (tmp_path / name).write_text(yaml.dump(trees[name], Dumper=Plain, allow_unicode=True, sort_keys=False), "utf-8")
        try:
            load_model(tmp_path)
        except SpecError as error:
            refused += 1
            assert all(p.file.endswith(".yaml") and p.line > 0 and p.column > 0 for p in error.problems)
        except Exception as error:
            pytest.fail(f"mutation {turn} of {name} ({', '.join(done)}): {error!r}")
        (tmp_path / name).write_text(good[name], "utf-8")
    assert refused > MUTATIONS // 2


def test_a_typical_value_of_the_wrong_form(tmp_path: Path) -> None:
    """It was reported, and then a guide that shows the field failed."""
    whole = files(INVENTED)
    whole["simulation/everything.yaml"]["quantities"]["specific_force"]["typical"][1] = {"x": 1}
    for name, tree in whole.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(yaml.dump(tree, Dumper=Plain, allow_unicode=True, sort_keys=False), "utf-8")
    with pytest.raises(SpecError, match="cannot show the typical value of 'specific_force'"):
        load_model(tmp_path)


def test_only_problems_come_out_of_any_text(tmp_path: Path) -> None:
    """The same for text that is cut, spliced and sprinkled with YAML's own characters."""
    for name in files(BASE):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text((BASE / name).read_text("utf-8"), "utf-8")
    chance = chance_of("text")
    target = tmp_path / "sets/tools.yaml"
    text = target.read_text("utf-8")
    for turn in range(3 * MUTATIONS):
        at, size = chance.randrange(len(text)), chance.choice([0, 1, 1, 20])
        piece = chance.choice(
            [*"{}[],:&*!|>'\"#%@`-?\t\n\x00\u2028", "? ", "- ", "<<: ", "*a", "&a ", "!!int ", "...", "---\n"]
        )
        target.write_bytes((text[:at] + piece + text[at + size :]).encode("utf-8"))
        try:
            load_model(tmp_path)
        except SpecError:
            pass
        except Exception as error:
            pytest.fail(f"mutation {turn}: {piece!r} at {at}: {error!r}")
