"""Tables for the simulated device."""

from __future__ import annotations

from ... import meaning
from ... import model as m
from ...simulated import Behavior, Value


def given(x: Value | Behavior) -> str:
    """The arguments of the class of the same name in Python, without those that say nothing."""
    if isinstance(x, Value):
        shown: dict[str, object] = {
            "quantity": x.quantity, "factor": x.factor if x.factor != 1 else None, "names": x.names, "bits": x.bits,
        }  # fmt: skip
        found = {k: v for k, v in shown.items() if v}
        found |= {k: v for k, v in (("number", x.number), ("text", x.text)) if v is not None}
    else:
        found = {
            "effect": x.effect,
            "arguments": dict(x.arguments),
            "all": dict(x.all),
            "instances": dict(x.instances),
            "translate": {name: dict(pairs) for name, pairs in x.translate},
            "setting": x.setting,
            "key": dict(x.key),
            "initial": dict(x.initial),
            "answers": dict(x.answers),
        }
    return ", ".join(f"{k}={v!r}" for k, v in found.items() if v or v == 0)


def differences(d: m.Device) -> dict[str, str]:
    """Parameters that differ on a device -> the arguments of `Difference`."""
    found = {}
    for v in d.variants:
        x = v.variant
        said: dict[str, object] = {
            "default": meaning.in_numbers(x.default, v.parameter.element),
            "minimum": x.minimum,
            "maximum": x.maximum,
            "constant": x.constant,
        }
        shown = [f"{k}={value!r}" for k, value in said.items() if value is not None]
        numbers = sorted(o.value for o in x.only if isinstance(o, m.EnumValue))
        if numbers:
            shown.append(f"values=frozenset({{{', '.join(map(str, numbers))}}})")
        if shown:
            found[v.path] = ", ".join(shown)
    return found
