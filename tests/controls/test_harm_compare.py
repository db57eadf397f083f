"""`compare` on ISG lists and PMAC scripts, by the small controls of `harm_bridges`: what was loaded
otherwise is different, and what does the same is not.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from harm_bridges import TABLE, Bridge, IsgBridge, PmacBridge
from harm_columns import prepare
from harm_command import command, tables_of

pytestmark = pytest.mark.short_estimate

#: Values that the control adds or subtracts, in the files of both.
_VALUES = re.compile(r"(?<=\.pos )-?\d+|(?<=\.neg )-?\d+|(?<![\w,=#])-?\d+(?= |$)", re.MULTILINE)
_PLACES = np.arange(0.0, 600.1, 12.5)


def contents(bridge: Bridge, files: Mapping[str, str]) -> np.ndarray:
    bridge.loaded(files)
    corrections = [bridge.correction(address) for address in (bridge.lead, bridge.partner)]
    return np.array([[one(float(x), d) for x in _PLACES for d in (1, -1)] for one in corrections])


def edited(text: str, rng: np.random.Generator) -> tuple[str, str]:
    """Change one file as somebody at the control may have done."""
    values = [found for found in _VALUES.finditer(text) if found[0] != "0"]
    kind = str(rng.choice(["digit", "sign", "halves", "remark", "half"]))
    if kind == "remark":
        return kind, text.replace("\n", "\r\n")
    first = values[len(values) // 2 :] if kind == "half" else values
    chosen = [values[int(rng.integers(len(values)))]] if kind == "digit" else first
    for found in reversed(chosen):
        value = int(found[0])
        new = {"digit": value + 30, "sign": -value, "halves": value // 2, "half": 0}[kind]
        text = text[: found.start()] + str(new) + text[found.end() :]
    return kind, text


@pytest.mark.parametrize("make", [PmacBridge, IsgBridge])
def test_what_was_loaded_otherwise_is_different(make: type[Bridge], tmp_path: Path) -> None:
    bridge, rng = make(), np.random.default_rng(23)
    job = prepare(tmp_path, bridge, TABLE, "")
    assert command("run", job).code == 0
    new = {path.name: path.read_bytes().decode() for path in tables_of(tmp_path / "job")}
    old = {name: (tmp_path / name).read_bytes().decode() for name in new}
    whole = {**{path.name: path.read_text() for path in tmp_path.glob("*.lis")}, **new}
    planned = contents(bridge, whole)
    counted = {True: 0, False: 0}
    for number in range(12):
        name = sorted(new)[int(rng.integers(len(new)))]
        kind, text = ("old", old[name]) if number == 0 else edited(new[name], rng)
        folder = tmp_path / f"loaded{number}"
        folder.mkdir()
        for each, content in {**whole, name: text}.items():
            (folder / each).write_bytes(content.encode())
        same = np.allclose(contents(bridge, {**whole, name: text}), planned, rtol=0.0, atol=1e-9)
        answer = command("compare", tmp_path / "job" / "plan.json", "--loaded", folder)
        assert (answer.code == 0) is same, (number, kind, answer.first)
        counted[same] += 1
    assert min(counted.values()) > 0
