"""A SINUMERIK with several active axes, some under work: the card is followed on a control that
protects the tables of all axes whose MD32700 is 1.

Some controls skip a protected line, some stop the file there. Either way the axis under work ends
with what was planned, and its neighbours do what they did.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from harm_command import card_of, command, tables_of
from harm_exports import CROSS, Held, X, Y, Z, acts, added, file, holding, judge, prepare, separate
from harm_following import follow
from harm_measuring import Axis, measure, write_csv
from places import REAL, needs_shared

pytestmark = pytest.mark.short_estimate

ARCHIVE = REAL / "siemens" / "dmu_840d_sl.arc"


#: Files of the control -> the axes under work.
CASES: dict[str, tuple[dict[str, str], list[Held]]] = {
    "first of three": (separate(X, Y, Z), [X]),
    "middle of three": (separate(X, Y, Z), [Y]),
    "last of three": (separate(X, Y, Z), [Z]),
    "last and first of three": (separate(X, Y, Z), [Z, X]),
    "all of three": (separate(X, Y, Z), [X, Y, Z]),
    "everything in one file": (
        {"NC.INI": file(X.data(), Y.data(), Z.data(), X.table(), Y.table(), Z.table())},
        [Y],
    ),
    "axis by axis in one file": (
        {"NC.INI": file(Z.data(), Z.table(), X.data(), X.table(), Y.data(), Y.table())},
        [X],
    ),
    "a file for each axis": (
        {f"{a.address}_EEC.INI": file(a.table()) for a in (X, Y, Z)}
        | {"MD.INI": file(X.data(), Y.data(), Z.data())},
        [Y],
    ),
    "one file, one axis each": (
        {f"{a.address}.INI": file(a.data(), a.table()) for a in (X, Y, Z)},
        [Z],
    ),
    "second measuring systems": (
        separate(*(two := [Held(a.address, a.slope, system=1) for a in (X, Y, Z)])),
        [two[1]],
    ),
    "a neighbour that is off": (separate(X, Held("AX2", 9.0, on=0), Z), [Z]),
    "the axis itself is off": (separate(X, Y, (off := Held("AX3", 9.0, on=0))), [off]),
    "a table between two neighbours": (
        separate(X, Y, Z)
        | {
            "NC_CEC.INI": file(CROSS),
            "SD.INI": file(["N32710 $MA_CEC_ENABLE[AX3]=1", "N41300 $SN_CEC_TABLE_ENABLE[0]=1"]),
        },
        [X],
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_the_axis_is_loaded_and_its_neighbours_keep_what_they_have(
    case: str, tmp_path: Path
) -> None:
    files, axes = CASES[case]
    answer = command("run", prepare(tmp_path, files, axes, ""))
    assert answer.code == 0, answer.first
    judge(tmp_path, files, axes)


@pytest.mark.parametrize("case", ["middle of three", "last of three", "everything in one file"])
def test_patched_files_name_every_switch(case: str, tmp_path: Path) -> None:
    """Whoever asks for the patched files gets a card with which they can be loaded."""
    files, axes = CASES[case]
    answer = command("run", prepare(tmp_path, files, axes, ", options: {files: patched}"))
    assert answer.code == 0, answer.first
    judge(tmp_path, files, axes)


@pytest.mark.parametrize("case", ["middle of three", "everything in one file"])
def test_the_way_back_brings_the_old_values_back(case: str, tmp_path: Path) -> None:
    files, axes = CASES[case]
    answer = command("run", prepare(tmp_path, files, axes, ""))
    assert answer.code == 0, answer.first
    results = tmp_path / "job"
    written = {path.name: path.read_text(encoding="utf-8") for path in tables_of(results)}
    back = {
        path.name: path.read_text(encoding="utf-8")
        for path in (results / "rollback").rglob("BACK_*")
    }
    card = card_of(results)
    for stops in (False, True):
        control = holding(files, stops=stops)
        old = dict(control.memory)
        follow(card, written, control)
        assert control.memory != old
        way = card[card.index("## Way back") :].split("\n## ", 2)[0].split("- [ ]")[1]
        for axis in axes:
            control.write(f"$MA_ENC_COMP_ENABLE[{axis.system},{axis.address}]", 0.0)
        control.reset()
        for name in re.findall(r"\bBACK_\w+\.INI\b", way):
            assert control.load(back[name])
        control.reset()
        assert control.memory == old


def member(name: str) -> str:
    """Give a text member of the real archive."""
    data = ARCHIVE.read_bytes()
    at = data.index(b"METRIC", data.index(name.encode()))
    return data[at : data.index(b"\0", at)].decode("latin-1")


@needs_shared
@pytest.mark.parametrize("address", ["AX4", "AX5"])
def test_the_real_export_of_five_axes(address: str, tmp_path: Path) -> None:
    """AX_EEC.INI as the control wrote it, five active axes; a rotary axis is under work."""
    data = ARCHIVE.read_bytes().decode("latin-1")
    keys = "BACKLASH|ENC_COMP_ENABLE|MM_ENC_COMP_MAX_POINTS|IS_ROT_AX|ROT_IS_MODULO|NUM_ENCS|GANTRY_AXIS_TYPE"
    rows = re.findall(rf"^(?:N\d+ )?\$MA_(?:{keys})\[[^\]]*AX[1-5]\]=.*$", data, re.MULTILINE)
    kept = list(dict.fromkeys(re.findall(rf"N\d+ \$MA_(?:{keys})\[(?:\d,)?AX[1-5]\]=[\d.]+", data)))
    assert rows
    files = {"AX_EEC.INI": member("_N_AX_EEC_INI"), "MD.INI": file(kept)}
    low, high = (0.0, 360.0) if address == "AX4" else (-120.0, 120.0)
    machine = Axis(
        low,
        high,
        slope=0.0 if address == "AX4" else 4.0,
        bow=5.0,
        wave=2.0,
        lost=2.0,
        full_turn=address == "AX4",
    )
    control = holding(files, stops=False)
    write_csv(
        tmp_path / "r.csv",
        "R",
        measure(machine, added(control, address, 1), count=12),
        rotary=True,
    )
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    turn = ", modulo: 360" if address == "AX4" else ""
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl}\n"
        "states: {as_found: [AX_EEC.INI, MD.INI]}\naxes:\n"
        f"  R: {{kind: rotary, travel: [{low}, {high}]{turn}, address: {address}, before: [r.csv]}}\n",
        encoding="utf-8",
    )
    answer = command("run", tmp_path / "job.yaml")
    assert answer.code == 0, answer.first
    written = {path.name: path.read_text() for path in tables_of(tmp_path / "job")}
    for stops in (False, True):
        control = holding(files, stops=stops)
        mine = [Held(address, 0.0)]
        before, others = (
            measure(machine, added(control, address, 1), seed=8).A(),
            acts(control, mine),
        )
        assert not follow(card_of(tmp_path / "job"), written, control)
        assert not control.alarms
        assert acts(control, mine) == others
        after = measure(machine, added(control, address, 1), seed=9).A()
        assert after < 0.7 * before
