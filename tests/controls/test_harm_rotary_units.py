"""`decode` of run's own tables of a rotary axis: never micrometres, and the size that was planned.

Where nothing beside the files says that the axis turns, no unit is named.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from harm_command import Answer, command, document, tables_of
from harm_measuring import Axis, measure, write_csv

pytestmark = pytest.mark.short_estimate

#: Format -> (address, more keys of the axis, options of the job, options of decode).
TURNING = {
    "siemens-840d-sl": ("AX4", "", "", ()),
    "siemens-828d": ("C1", "", "", ()),
    "siemens-one": ("AX4", "", "", ()),
    "fanuc-30i": ("4", "", "detection_unit: 0.0001, first_point: 100", ("detection_unit=0.0001",)),
    "fanuc-0i-16i": ("4", "", "detection_unit: 0.001, first_point: 100", ("detection_unit=0.001",)),
    "linuxcnc": ("3", "", "", ()),
    "pmac": ("4", "", "counts_per_unit: 10000", ("counts_per_unit=10000",)),
    "isg-kernel": ("4", ", axis_number: 4", "", ()),
    "heidenhain-itnc530": ("C", ", axis_number: 4", "", ()),
    "heidenhain-nck": ("C", ", axis_number: 4", "", ()),
}
TABLE = Axis(0.0, 360.0, bow=4, wave=1.5, lost=2, scatter=0.2, full_turn=True)
SWIVEL = Axis(-120.0, 120.0, slope=3, bow=2, wave=0.8, lost=2, scatter=0.2)
#: Full turns as endless axes where the control can; parts of a turn everywhere.
WAYS = {"turn": TABLE, "part": SWIVEL}


def results(folder: Path, form: str, way: str, kind: str) -> Path:
    address, more, options, _ = TURNING[form]
    axis = WAYS[way] if kind == "rotary" else Axis()
    write_csv(folder / "c.csv", "C", measure(axis, count=12), rotary=kind == "rotary")
    turn = ", modulo: 360" if way == "turn" and kind == "rotary" and form != "linuxcnc" else ""
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {form}, options: {{{options}}}}}\n"
        "states: {as_found: none}\naxes:\n"
        f"  C: {{kind: {kind}, travel: [{axis.low}, {axis.high}]{turn}, address: {address}{more}, before: [c.csv]}}\n",
        encoding="utf-8",
    )
    answer = command("run", folder / "job.yaml")
    assert answer.code == 0, answer.first
    return folder / "job"


def loadable(folder: Path) -> list[Path]:
    return tables_of(folder) or sorted((folder / "card").glob("entry_*.csv"))


def decoded(form: str, files: list[Path], *more: str) -> Answer:
    words = [word for option in (*TURNING[form][3], *more) for word in ("--option", option)]
    return command("decode", *files, "--format", form, *words, "--json", "-")


def span(rows: dict[str, list[float]]) -> float:
    values = [*rows["correction_positive"], *rows["correction_negative"]]
    return max(values) - min(values)


@pytest.mark.parametrize(
    ("form", "way"),
    [
        pytest.param(form, way, id=f"{form} {way}")
        for form in TURNING
        for way in WAYS
        if way == "turn" or "heidenhain" not in form  # which uses entries from 0 to 360 alone
    ],
)
def test_own_tables_of_a_rotary_axis(form: str, way: str, tmp_path: Path) -> None:
    folder = results(tmp_path, form, way, "rotary")
    planned = document(folder, "prediction.json")["axes"]["C"]["table"]
    assert planned["unit"] == "arcsec"
    beside = decoded(form, loadable(folder))
    assert beside.code == 0, beside.text
    (found,) = beside.json()["axes"].values()
    assert found["unit"] == "arcsec"
    assert span(found) == pytest.approx(span(planned), rel=0.02)
    away = tmp_path / "away"
    away.mkdir()
    for path in loadable(folder):
        shutil.copy(path, away)
    answer = decoded(form, sorted(away.iterdir()))
    if answer.code == 0:
        (found,) = answer.json()["axes"].values()
        assert found["unit"] in {"arcsec", None}
        if found["unit"]:
            assert span(found) == pytest.approx(span(planned), rel=0.02)
        else:
            assert answer.json()["findings"]
    else:
        assert answer.declined


@pytest.mark.parametrize("form", ["siemens-840d-sl", "linuxcnc", "pmac", "isg-kernel", "fanuc-30i"])
def test_own_tables_of_a_linear_axis_keep_their_unit(form: str, tmp_path: Path) -> None:
    folder = results(tmp_path, form, "part", "linear")
    answer = decoded(form, loadable(folder))
    assert answer.code == 0, answer.first
    (found,) = answer.json()["axes"].values()
    assert found["unit"] == "um"
    planned = document(folder, "prediction.json")["axes"]["C"]["table"]
    assert span(found) == pytest.approx(span(planned), rel=0.02)
