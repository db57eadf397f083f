"""Tables of two nearly equal axes that were exchanged at loading: where the test could not show it,
`verify` says so and names the read-back. Errors are straight lines with lost motion, so that the
tables are known by hand.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

X = Machine()


def verified(folder: Path, y: Machine, *, back: bool = False) -> tuple[int, dict[str, set[str]]]:
    """Plan X and Y, load both tables as planned, measure again; return what `verify` says."""
    targets = X.targets()
    axes = {"X": X, "Y": y}
    for seed, (name, axis) in enumerate(axes.items(), 1):
        text = csv_of(targets, axis.measure(targets, seed)).replace(": X", f": {name}")
        (folder / f"{name}.csv").write_text(text)
    lines = [
        f"  {name}: {{travel: [0, 800], address: {joint}, before: [{name}.csv]}}\n"
        for joint, name in enumerate(axes)
    ]
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\naxes:\n"
        + "".join(lines)
        + ("acknowledged: {CW-T037: two screws of one make}\n" if y is X else "")
    )
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    tables = folder / "job" / "tables" / "linuxcnc"
    words = ["verify", str(folder / "job.yaml")]
    for joint, (name, axis) in enumerate(axes.items()):
        rows = np.loadtxt(tables / f"joint_{joint}.comp")
        nodes, forward, reverse = rows.T  # type 0: position at which the nominal one is reached

        def active(
            x: Floats, sign: int, n: Floats = nodes, up: Floats = forward, down: Floats = reverse
        ) -> Floats:
            return np.interp(x, n, n - (up if sign > 0 else down))

        text = csv_of(targets, axis.measure(targets, 10 + joint, active))
        (folder / f"{name}2.csv").write_text(text.replace(": X", f": {name}"))
        words += ["--after", str(folder / f"{name}2.csv")]
    if back:
        (folder / "back").mkdir()
        for path in tables.iterdir():
            (folder / "back" / path.name).write_bytes(path.read_bytes())
        words += ["--loaded", str(folder / "back")]
    code = compwright([*words, "--json", str(folder / "v.json")])
    found = json.loads((folder / "v.json").read_text())
    return code, {
        name: {one["message"] for one in axis["findings"] if one["code"] == "CW-V012"}
        for name, axis in found["axes"].items()
        if axis["loading"]["verdict"] == "loaded"
    }


def test_an_exchange_that_no_test_shows_is_named(tmp_path: Path) -> None:
    code, found = verified(tmp_path, X)
    assert code == 0
    assert found.keys() == {"X", "Y"}
    for name, other in (("X", "Y"), ("Y", "X")):
        (text,) = found[name]
        assert f"would not show whether its table was exchanged with that of {other}." in text
        assert "--loaded" in text


def test_the_files_read_back_exclude_it(tmp_path: Path) -> None:
    assert verified(tmp_path, X, back=True) == (0, {"X": set(), "Y": set()})


def test_tables_that_differ_say_nothing(tmp_path: Path) -> None:
    assert verified(tmp_path, replace(X, slope=-X.slope)) == (0, {"X": set(), "Y": set()})
