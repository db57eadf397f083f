"""What the files of a SINUMERIK enter: the line METRIC or INCH says the unit of the machine's
numbers, not a value of one file; each variable of a table is called what it is.

The line: MD10260, $MN_CONVERT_SCALING_SYSTEM (Siemens' help texts of the machine data). The tables:
FB2 03/2013, 6FC5397-1BP40-3BA1, p245, p249 and p252 (MULT_BY_TABLE = 2 names the table of index 1);
help text of $AN_CEC_TYPE (1: cylinder error compensation).
"""

from __future__ import annotations

import pytest

from compwright.formats.families.shapes import control_format
from compwright.formats.text.file_values import FileValue, FileValueChange, changes
from compwright.records.correction import ControlFile
from format_samples import SIEMENS

FAMILY = control_format(SIEMENS, {})


def file_values(**files: str) -> dict[str, FileValue]:
    texts = [ControlFile(f"{name}.INI", text.encode()) for name, text in files.items()]
    return dict(FAMILY.listing.file_values(FAMILY.definition, texts, ()))


def differing(old: dict[str, FileValue], new: dict[str, FileValue]) -> list[FileValueChange]:
    return list(changes(old, new))


A, B = "$MA_BACKLASH[0,AX1]=0.01\n", "$MA_BACKLASH[0,AX2]=0.02\n"


@pytest.mark.parametrize("unit", ["METRIC", "INCH"])
def test_one_more_file_in_the_same_unit_is_no_difference(unit: str) -> None:
    old = file_values(A=f"{unit}\n{A}{B}")
    new = file_values(A=f"{unit}\n{A}{B}", BACK=f" {unit.lower()} \n{B}")
    assert differing(old, new) == []
    assert differing(old, file_values(ONE=f"{unit}\n{A}", TWO=f"{unit}\n{B}")) == []


def test_another_unit_is_one_difference() -> None:
    old = file_values(A=f"METRIC\n{A}", B=f"METRIC\n{B}")
    (change,) = differing(old, file_values(A=f"INCH\n{A}", B=f"INCH\n{B}"))
    assert (change.entry.relevant, change.entry.text) == (True, "INCH")
    assert change.old is not None
    assert change.old.text == "METRIC"


def test_a_file_in_another_unit_than_the_rest_is_one_by_its_name() -> None:
    rest = {"A": f"METRIC\n{A}", "B": f"METRIC\n{B}"}
    for turned in (rest, dict(reversed(rest.items()))):
        (change,) = differing(file_values(**rest), file_values(ODD=f"INCH\n{A}", **turned))
        assert (change.old, change.entry.text, change.entry.relevant) == (None, "INCH", True)
        assert change.entry.name.startswith("ODD.INI")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("$AN_CEC[0,3]=1", "CEC: value"),
        ("$AN_CEC_TYPE[0]=1", "kind"),
        ("$AN_CEC_IS_MODULO[0]=1", "repeats"),
        ("$AN_CEC_MULT_BY_TABLE[0]=2", "number - 1"),
        ("$AN_CEC_SOMETHING[0]=2", "CEC"),
        ("$AA_ENC_COMP[0,3,AX1]=1", "EEC: value"),
        ("$AA_ENC_COMP_SOMETHING[0,AX1]=1", "EEC"),
        ("$SN_CEC_0[1]=1", "SD41320"),
        ("$SN_CEC_TABLE_ENABLE[1]=1", "SD41300"),
    ],
)
def test_a_variable_is_called_what_it_is(line: str, words: str) -> None:
    (one,) = file_values(A=line + "\n").values()
    assert one.relevant
    assert words in one.meaning
    assert ("value" in one.meaning) == (words.endswith("value"))
