"""The target data form: three files of real machines, and each way in which entries can be missing
or disagree.
"""

from __future__ import annotations

import csv

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest
from next_steps import without_hint
from one_test import read_positioning
from places import REAL, needs_shared

COMPLETE = """# exported
UNIT=mm
CYCLES=2
POSITIONS=2
DEC=5
TGT_DATA[1]=-5
TGT_DATA[2]=.5
REF_DATA_FWD[1,1]=-5.002
REF_DATA_FWD[2,1]=.503
REF_DATA_FWD[1,2]=-5.001
REF_DATA_FWD[2,2]=.504
REF_DATA_BWD[1,1]=-4.999
REF_DATA_BWD[2,1]=.5005
REF_DATA_BWD[1,2]=-4.998
REF_DATA_BWD[2,2]=.501
"""


def read(text: str) -> PositioningTest:
    return read_positioning(text.encode(), "x.dat")


def faults(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        read(text)
    return [without_hint(line) for line in str(caught.value).split("\n")]


def one_fault(text: str) -> str:
    lines = faults(text)
    assert len(lines) == 1, lines
    return lines[0]


def real(name: str) -> PositioningTest:
    return read_positioning((REAL / "positioning" / name).read_bytes(), name)


@needs_shared
@pytest.mark.parametrize(
    ("name", "targets"), [("ess_b02_x", 9), ("ess_muts_y_ild50", 5), ("psi_test_fat_sat", 5)]
)
def test_real_files_give_the_parameters_computed_from_the_definitions(
    name: str, targets: int
) -> None:
    test = real(f"{name}.dat")
    assert test.name == name
    assert test.positive.shape == test.negative.shape == (targets, 5)
    assert np.isfinite(test.positive).all()
    assert np.isfinite(test.negative).all()
    lines = (REAL / "positioning" / "expected.csv").read_text(encoding="utf-8").splitlines()[1:]
    (expected,) = [row for row in csv.DictReader(lines) if row["dataset"] == f"{name}.dat"]
    up, down = test.positive.mean(axis=1), test.negative.mean(axis=1)
    s_up, s_down = test.positive.std(axis=1, ddof=1), test.negative.std(axis=1, ddof=1)
    computed = {
        "B": np.abs(up - down).max(),
        "B_avg": (up - down).mean(),
        "E_fwd": np.ptp(up),
        "E_bwd": np.ptp(down),
        "E": np.ptp(np.concatenate([up, down])),
        "M": np.ptp((up + down) / 2),
        "R_fwd": 4 * s_up.max(),
        "R_bwd": 4 * s_down.max(),
        "A_fwd": (up + 2 * s_up).max() - (up - 2 * s_up).min(),
    }
    for key, value in computed.items():
        assert value == pytest.approx(float(expected[key]), abs=0.6e-6), (
            key
        )  # mm: half of the sixth decimal, and float noise


@needs_shared
def test_cycle_means_of_a_real_file() -> None:
    # Facts on this file: cycle means -10.0 to -14.7 um forward and 16.3 to 9.7 um backward (one
    # decimal: 0.05 um).
    test = real("ess_b02_x.dat")
    assert test.positive[:, 0].mean() * 1000 == pytest.approx(-10.0, abs=0.05)
    assert test.positive[:, 4].mean() * 1000 == pytest.approx(-14.7, abs=0.05)
    assert test.negative[:, 0].mean() * 1000 == pytest.approx(16.3, abs=0.05)
    assert test.negative[:, 4].mean() * 1000 == pytest.approx(9.7, abs=0.05)
    # One reading by eye: REF_DATA_BWD[9,5]=20.0405726224096368 at TGT_DATA[9]=20 (mm, double
    # precision at 20).
    assert test.negative[8, 4] == pytest.approx(0.0405726224096368, abs=1e-14)
    assert test.targets[0] == -20.0
    assert test.header["TGT_SET_PV"] == "TARGET_DU:X-PosCmd"
    assert test.header["DEC"] == "5"
    assert test.header["UNIT"] == "mm"
    assert "unit" not in test.header
    assert "Source: GitHub" in test.header["comment"]


def test_small_file() -> None:
    test = read(COMPLETE)
    np.testing.assert_array_equal(test.targets, [-5.0, 0.5])
    np.testing.assert_allclose(
        test.positive * 1000, [[-2.0, -1.0], [3.0, 4.0]], atol=1e-11
    )  # um, doubles at 5 mm
    np.testing.assert_allclose(test.negative * 1000, [[1.0, 2.0], [0.5, 1.0]], atol=1e-11)
    assert test.runs_positive == (1, 2)
    assert {finding.code for finding in test.findings} == {"CW-R001", "CW-R002", "CW-R003"}


@pytest.mark.parametrize(
    ("unit", "factor", "kind"),
    [
        ("mm", 1.0, AxisKind.LINEAR),
        ("um", 1e-3, AxisKind.LINEAR),
        ("deg", 1.0, AxisKind.ROTARY),
        ("degrees", 1.0, AxisKind.ROTARY),
        ("arcsec", 1 / 3600, AxisKind.ROTARY),
    ],
)
def test_the_unit_is_that_of_targets_and_readings(unit: str, factor: float, kind: AxisKind) -> None:
    test = read(COMPLETE.replace("UNIT=mm", f"UNIT={unit}"))
    assert test.kind is kind
    np.testing.assert_allclose(test.targets, np.array([-5.0, 0.5]) * factor, rtol=1e-15)
    np.testing.assert_allclose(
        test.positive[:, 0], np.array([-0.002, 0.003]) * factor, rtol=1e-12
    )  # doubles at 5 mm


def test_keys_in_comments_and_absent_keys() -> None:
    bare = "".join(
        line + "\n"
        for line in COMPLETE.splitlines()
        if not line.startswith(("UNIT", "CYCLES", "POSITIONS", "DEC"))
    )
    test = read("# axis: X\n# cycle: step\n#   UNIT   : Unit for measurements\n" + bare)
    assert (test.axis, test.cycle, test.kind) == ("X", "step", AxisKind.LINEAR)
    (assumed,) = [finding.message for finding in test.findings if finding.code == "CW-R001"]
    assert assumed.endswith("BWD: in direction -; unit: mm.")


def test_targets_listed_from_high_to_low() -> None:
    text = (
        COMPLETE.replace("TGT_DATA[1]=-5\n", "TGT_DATA[1]=5\n")
        .replace("=-5.", "=5.")
        .replace("=-4.", "=4.")
    )
    assert "CW-R014" in {finding.code for finding in read(text).findings}


def test_one_direction_only() -> None:
    text = "".join(line + "\n" for line in COMPLETE.splitlines() if "BWD" not in line)
    test = read(text)
    assert test.negative.shape == (2, 0)
    (doubt,) = (one for one in test.findings if one.code == "CW-R053")
    assert "only direction REF_DATA_FWD" in doubt.message
    assert "CW-R053" not in {one.code for one in read(COMPLETE).findings}


def without(entry: str) -> str:
    return "".join(line + "\n" for line in COMPLETE.splitlines() if not line.startswith(entry))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (without("REF_DATA_BWD[2,1]"), "x.dat: entries are missing; expected REF_DATA_BWD[2,1]"),
        (without("REF_DATA_BWD[1,2]"), "x.dat: entries are missing; expected REF_DATA_BWD[1,2]"),
        (without("TGT_DATA[1]"), "x.dat: entries are missing; expected TGT_DATA[1]"),
        (
            COMPLETE + "TGT_DATA[2]=1\n",
            (
                "line 16, TGT_DATA[2] is given twice; expected each index once, found the first in"
                " line 7"
            ),
        ),
        (COMPLETE + "REF_DATA_FWD[2,2]=1\n", "line 16, REF_DATA_FWD[2,2] is given twice"),
        (COMPLETE + "UNIT=um\n", "line 16, UNIT is given twice"),
        (
            COMPLETE.replace("CYCLES=2", "CYCLES=5"),
            "line 3, CYCLES is not the highest cycle of the readings; expected 2",
        ),
        (
            COMPLETE.replace("POSITIONS=2", "POSITIONS=3"),
            "line 4, POSITIONS is not the highest index of TGT_DATA; expected 2",
        ),
        (
            COMPLETE.replace("CYCLES=2", "CYCLES=two"),
            "line 3, CYCLES is not a whole number of at least 1",
        ),
        (COMPLETE.replace("UNIT=mm", "UNIT=steps"), "line 2, UNIT names an unknown unit"),
        (COMPLETE.replace("=.503", "=nan"), "line 9, REF_DATA_FWD[2,1] is not a finite number"),
        (COMPLETE.replace("=.503", "="), "line 9, REF_DATA_FWD[2,1] is empty"),
        (COMPLETE.replace("=.503", "=0,503"), "line 9, REF_DATA_FWD[2,1]: decimal marks are mixed"),
        (
            COMPLETE.replace("TGT_DATA[1]=-5", "TGT_DATA[1]=five"),
            "line 6, TGT_DATA[1] is not a number",
        ),
        (
            COMPLETE + "REF_DATA_FWD[3,1]=1\n",
            (
                "line 16, REF_DATA_FWD[3,1] is a reading at a target that the file does not "
                "contain; expected a target index up to 2"
            ),
        ),
        (
            COMPLETE + "REF_DATA_FWD[1]=1\n",
            "line 16 has wrong indices; expected REF_DATA_FWD[target,cycle]",
        ),
        (COMPLETE + "TGT_DATA[0]=1\n", "line 16 has wrong indices"),
        (COMPLETE + "TGT_DATA=1\n", "line 16 has wrong indices"),
        (COMPLETE + "done\n", "line 16 is not KEY=value"),
        (COMPLETE.replace("TGT_DATA[2]=.5", "TGT_DATA[2]=-5.0"), "a reading is given twice"),
        ("UNIT=mm\nTGT_DATA[1]=0\n", "contains no readings"),
    ],
)
def test_faults(text: str, words: str) -> None:
    assert words in faults(text)[0]


def test_a_huge_index_neither_hangs_nor_floods() -> None:
    line = one_fault("TGT_DATA[1]=0\nREF_DATA_FWD[1,999999999]=0.5\n")
    assert line.endswith("REF_DATA_FWD[1,10] and 999999988 more")
    assert (
        "and 999999988 more"
        in faults("TGT_DATA[999999999]=0.5\nREF_DATA_FWD[999999999,1]=0.5\n")[0]
    )
