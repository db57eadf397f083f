"""SINUMERIK 828D, 840D powerline and ONE: the files of the 840D sl, with limits and evidence of their
own.
"""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from compwright.formats.families.pairs.axis_pairs import write_cross
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import AxisKind
from compwright.records.correction import CrossCompensation, Evidence
from damage import facts
from format_samples import DEFINITIONS, axis_of, codes, files
from sinumerik_archive import cec_lines

SMALL = DEFINITIONS["siemens-828d"]
RELATIVES = ("siemens-840d-pl", "siemens-one")
CEC: dict[str, object] = {"cec": "available", "cec_tables": [6, 7], "cec_sign": "error"}
EEC = (
    "$AA_ENC_COMP[0,0,AX1]=0.003\n$AA_ENC_COMP[0,1,AX1]=0.001\n"
    "$AA_ENC_COMP_STEP[0,AX1]=800\n$AA_ENC_COMP_MIN[0,AX1]=0\n$AA_ENC_COMP_MAX[0,AX1]=800\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n"
)


def bow(points: int) -> CrossCompensation:
    values = np.linspace(0.0, 0.001, points).round(6)
    return CrossCompensation(
        input="AX1",
        output="AX2",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=np.arange(points, dtype=np.float64),
        positive=values,
        negative=values,
    )


def test_the_828d_has_eight_tables_of_two_hundred_points_and_nothing_to_reserve() -> None:
    """Extended Functions 03/2013, page 264."""
    control = control_format(SMALL, CEC)
    capacity = control.capacity(axis_of("AX1"))
    assert capacity.max_points == 200
    assert not [note for note in capacity.assumed if "MD18342" in note.fact]
    assert control_format(SMALL, {**CEC, "points": 1000}).capacity(axis_of("AX1")).max_points == 200
    with pytest.raises(UsageError, match=r"8 CEC tables.*indices from 0 to 7.*8"):
        control_format(SMALL, {**CEC, "cec_tables": [7, 8]}).capacity(axis_of("AX1"))
    assert write_cross(control, [bow(200)])
    with pytest.raises(CapacityError, match=r"more points than.*200"):
        write_cross(control, [bow(201)])


def test_a_table_that_the_828d_cannot_have_is_of_another_control() -> None:
    def read(
        index: int, points: int, pair: tuple[str, str] = ("AX2", "AX1"), **options: object
    ) -> set[str]:
        text = EEC + cec_lines(index, *pair, 0, 1, [0.001] * points) + "M17\n"
        given = files(A__INI=text)
        control = control_format(SMALL, {"cec_sign": "error", **options})
        return codes(control.read(given, [axis_of("AX1")]))

    assert "CW-S050" not in read(7, 200)
    assert "CW-S050" in read(8, 200)
    assert "CW-S050" in read(7, 201)
    with pytest.raises(InputError, match="8 tables only"):
        control_format(SMALL, {"cec_sign": "error"}).read(
            files(A__INI=EEC + cec_lines(8, "AX1", "AX1", 0, 1, [0.001] * 10) + "M17\n")
        )


@pytest.mark.parametrize("name", RELATIVES)
def test_what_no_page_says_of_a_relative_is_not_confirmed(name: str) -> None:
    definition, known = DEFINITIONS[name], DEFINITIONS["siemens-840d-sl"]
    for quantity in ("value", "backlash"):
        assert known.bindings[quantity].evidence.state == "confirmed"
        assert definition.bindings[quantity].evidence.state == "inferred"
    assert definition.options["cec_sign"].evidence.state == "inferred"
    assert definition.layout.evidence.state in get_args(Evidence)[1:]
    assert not definition.proven


@pytest.mark.parametrize("name", RELATIVES)
def test_a_relative_differs_in_words_alone(name: str) -> None:
    """Tests that run a whole job for each control leave it out (``DISTINCT``)."""
    assert facts(DEFINITIONS[name].text.data) == facts(DEFINITIONS["siemens-840d-sl"].text.data)


@pytest.mark.parametrize("name", ["siemens-828d", *RELATIVES])
def test_a_relative_reads_and_writes_as_the_840d_sl_does(name: str) -> None:
    text = (
        EEC + cec_lines(3, "AX1", "AX1", 0, 100, [0, 0.001, 0]) + "$MA_BACKLASH[0,AX1]=0.002\nM17\n"
    )
    given, axis = files(A__INI=text), axis_of("AX1")
    made = []
    for definition in (DEFINITIONS["siemens-840d-sl"], DEFINITIONS[name]):
        state = control_format(definition, {"cec_sign": "error"}).read(given, [axis])
        control = control_format(definition, {"cec_sign": "error", "cec_tables": [3]}, state)
        found = state.axes["AX1"]
        made.append((found.others[0].positive.tolist(), control.write([found], [axis], given)))
    assert made[0] == made[1]
