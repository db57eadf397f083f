"""A pair of which the one table stands in the control's own file: the card has both files loaded
before MD32710 = 1, which protects the values (Function Manual Extended Functions 03/2013, CEC).
"""

from __future__ import annotations

import pytest

from card_files import named_in_card
from compwright.formats.families.axis_pairs import refusal
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile
from compwright.words.sentences import in_language
from format_samples import SIEMENS, axis_of

OPTIONS = {"cec": "available", "cec_tables": (9, 10), "cec_sign": "error"}
NEW = ControlFile("AX1_CEC.INI", b"$AN_CEC[10,0]=0.001\n$AN_CEC[10,1]=0.002\nM17\n")
SWITCHES = ControlFile("MD.INI", b"N41300 $SN_CEC_TABLE_ENABLE[9]=1\nM17\n")


@pytest.mark.parametrize(
    ("row", "called"),
    [
        (b"$AN_CEC[9,0]=0.001\n", "AX1_CEC.INI, then your own patched NC_CEC.INI"),
        (b"$AN_CEC[2,0]=0.001\n", "AX1_CEC.INI"),
        (b"$AN_CEC[99,0]=0.001\n", "AX1_CEC.INI"),
    ],
    ids=["of the pair", "another table", "another table that begins alike"],
)
def test_every_file_with_values_of_the_pair_is_loaded_with_the_table(
    row: bytes, called: str
) -> None:
    own = ControlFile("NC_CEC.INI", row + b"M17\n")
    names = named_in_card(control_format(SIEMENS, OPTIONS), axis_of("AX1"), [SWITCHES, own, NEW])
    assert names.get("file_3", "AX1_CEC.INI") == called


def test_the_place_in_a_refusal_is_in_the_language_of_the_page() -> None:
    fault = Fault(message="a", file="own.ini", place="line 52", hint="b")
    assert refusal([fault]) == "own.ini: line 52: a. Next: b"
    assert in_language(refusal([fault]), "de") == "own.ini: Zeile 52: a. Weiter: b"
    nowhere = Fault(message="a", place="option cec", hint="b")
    assert refusal([nowhere]) == "a. Next: b"
