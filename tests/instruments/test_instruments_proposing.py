"""Profiles that are proposed: what headers and numbers prove, in six languages, and what stays
open.
"""

from __future__ import annotations

import numpy as np
import pytest
import yaml

from compwright.foundations.errors import InputError, UsageError
from compwright.instruments.profile_of_file import Proposed, proposed_profile
from compwright.instruments.profile_reading import read_profile
from laser_files import laser_file
from one_test import read_positioning
from places import REAL, needs_shared

ROWS = [("0", "{out}", "0.4"), ("100", "{out}", "2.1"), ("200", "{out}", "3.4")]
BACK = [("0", "{back}", "-2.9"), ("100", "{back}", "-0.8"), ("200", "{back}", "1.2")]
#: Header (target, direction, run, deviation), words of the directions, and whether they are signs.
LANGUAGES = {
    "en": (("Target (mm)", "Direction", "Run", "Deviation (um)"), ("up", "down"), True),
    "de": (("Soll [mm]", "Richtung", "Lauf", "Abweichung [µm]"), ("hin", "zurück"), False),
    "fr": (("Consigne (mm)", "Sens", "Cycle", "Écart (µm)"), ("aller", "retour"), False),
    "ru": (("Позиция, мм", "Направление", "Проход", "Отклонение, мкм"), ("вверх", "вниз"), True),
    "it": (("Quota [mm]", "Verso", "Corsa", "Errore [µm]"), ("andata", "ritorno"), False),
    "es": (("Posición (mm)", "Sentido", "Ciclo", "Desviación (µm)"), ("subida", "bajada"), True),
}
FALLING = BACK[::-1]


def table(
    language: str, back: list[tuple[str, str, str]], *, decimal: str = ",", encoding: str = "utf-8"
) -> bytes:
    header, (out, home), _ = LANGUAGES[language]
    lines = [";".join(header)]
    for target, word, value in ROWS + back:
        direction = word.format(out=out, back=home)
        lines.append(f"{target};{direction};1;{value}".replace(".", decimal))
    return "\r\n".join([*lines, ""]).encode(encoding)


def keys(proposed: Proposed) -> dict[str, object]:
    found = yaml.safe_load(proposed.text)
    assert isinstance(found, dict)
    return found


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("decimal", [",", "."])
def test_headers_of_six_languages(language: str, decimal: str) -> None:
    header, words, signs = LANGUAGES[language]
    proposed = proposed_profile(table(language, BACK, decimal=decimal), "x.csv")
    found = keys(proposed)
    assert (found["target"], found["target_unit"]) == (header[0], "mm")
    assert (found["direction"], found["run"]) == (header[1], header[2])
    assert (found["value"], found["unit"], found["value_is"]) == (header[3], "um", "deviation")
    assert (found["decimal"], found["delimiter"]) == (
        {",": "comma", ".": "point"}[decimal],
        "semicolon",
    )
    # up and down are signs; forward and back are none while both stand in the same order
    meant = {words[0]: "+", words[1]: "-"} if signs else dict.fromkeys(words)
    assert found["directions"] == meant
    assert found["sign"] is None
    assert any(line.startswith("sign: ") for line in proposed.open)
    with pytest.raises(UsageError, match="'sign' is empty and must be filled in"):
        read_profile(proposed.text.encode(), "P.yaml")


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_order_of_the_rows_proves_the_directions(language: str) -> None:
    words = LANGUAGES[language][1]
    proposed = proposed_profile(table(language, FALLING), "x.csv")
    assert keys(proposed)["directions"] == {words[0]: "+", words[1]: "-"}


@pytest.mark.parametrize(
    ("language", "encoding"),
    [("de", "cp1252"), ("fr", "cp1252"), ("es", "cp1252"), ("ru", "cp1251"), ("ru", "utf-16")],
)
def test_code_pages(language: str, encoding: str) -> None:
    content = table(language, FALLING, encoding=encoding)
    proposed = proposed_profile(content, "x.csv")
    assert keys(proposed)["encoding"] == encoding
    text = proposed.text.replace("\nsign:", "\nsign: measured minus target")
    test = read_positioning(content, "x.csv", read_profile(text.encode(), "P.yaml"))
    assert test.positive[:, 0] * 1000 == pytest.approx([0.4, 2.1, 3.4], rel=1e-15)
    assert test.negative[:, 0] * 1000 == pytest.approx([-2.9, -0.8, 1.2], rel=1e-15)


def test_plain_ascii_names_no_encoding() -> None:
    content = b"sep=;\nTarget [mm];Deviation [um]\n0;0,4\n100;2,1\n"
    found = keys(proposed_profile(content, "x.csv"))
    assert (found["encoding"], found["header_line"]) == (None, 2)


def test_worked_rows_with_an_answer() -> None:
    proposed = proposed_profile(table("en", BACK), "x.csv")
    assert proposed.worked[0] == "if the sign is 'measured minus target':"
    assert (
        "line 4: at 200 mm, approached from below, the axis went 3.4 µm too far" in proposed.worked
    )
    assert "line 5: at 0 mm, approached from above, the axis went 2.9 µm too far" in proposed.worked


@pytest.mark.parametrize("factor", [1, -1])
def test_three_columns_prove_the_sign(factor: int) -> None:
    lines = ["Soll [mm];Ist [mm];Abweichung [µm];Richtung"]
    for target, off in (("0", 0.4), ("100", 2.1), ("200", -3.4)):
        measured = f"{float(target) + off / 1000:.4f}"
        lines.append(f"{target};{measured};{factor * off};+".replace(".", ","))
    found = keys(proposed_profile("\n".join(lines).encode(), "x.csv"))
    assert found["value"] == "Abweichung [µm]"
    assert found["sign"] == ("measured minus target" if factor > 0 else "target minus measured")


def test_a_header_that_says_the_sign() -> None:
    content = "Soll [mm];Abweichung Soll-Ist [µm];Richtung\n0;0,4;+\n100;2,1;+\n".encode()
    assert keys(proposed_profile(content, "x.csv"))["sign"] == "target minus measured"


def test_one_column_per_traverse() -> None:
    text = "Axis X;;;;\nUnit: um;;;;\nTarget [mm];+1;-1;2 ↑;2 ↓\n0;0,4;-2,9;0,5;-3,1\n"
    text += "100;2,1;-1,6;2,4;-1,2\n"
    found = keys(proposed_profile(text.encode(), "x.csv"))
    assert (found["layout"], found["unit"]) == ("wide", "um")
    assert found["traverses"] == {"+1": "+1", "-1": "-1", "2 ↑": "+2", "2 ↓": "-2"}


def test_forward_and_reverse_stay_open() -> None:
    text = "Target [mm],Run 1 Fwd [um],Run 1 Rev [um]\n0,0.4,-2.9\n100,2.1,-1.6\n"
    proposed = proposed_profile(text.encode(), "x.csv")
    assert keys(proposed)["traverses"] == {"Run 1 Fwd [um]": None, "Run 1 Rev [um]": None}
    assert "'Run 1 Fwd [um]' is +" in proposed.worked[0]


def test_rows_in_the_order_of_time() -> None:
    text = "Soll [mm]\tFehler [µm]\n0\t0.4\n100\t2.1\n100\t-0.8\n0\t-2.9\n"
    found = keys(proposed_profile(text.encode(), "x.csv"))
    assert found["direction_from"] == "order"
    rising = "Soll [mm]\tFehler [µm]\n0\t0.4\n100\t2.1\n200\t2.8\n"
    assert keys(proposed_profile(rising.encode(), "x.csv"))["direction_from"] is None


def test_numbers_without_names() -> None:
    proposed = proposed_profile(b"0\t0.4\n100\t2.1\n200\t2.8\n", "x.csv")
    found = keys(proposed)
    assert found["header_line"] == 0
    assert {"unit", "sign", "target_unit"} <= {line.partition(":")[0] for line in proposed.open}


def test_mixed_decimal_marks_stay_open() -> None:
    content = "Soll [mm];Abweichung [µm]\n0;1.381\n100;1,380\n200;1,1\n".encode()
    proposed = proposed_profile(content, "x.csv")
    assert keys(proposed)["decimal"] is None
    assert any("1 numbers have a point and 2 a comma" in line for line in proposed.open)


def test_files_that_need_none() -> None:
    for content in (
        b"target_mm,direction,run,deviation_um\n0,+,1,1\n",
        b"TGT_DATA[1]=0\n",
    ):
        with pytest.raises(UsageError, match="needs no profile"):
            proposed_profile(content, "x.csv")
    with pytest.raises(InputError, match="no table of numbers"):
        proposed_profile(b"Hello\nworld\n", "x.csv")


def test_a_file_that_only_lacks_its_unit() -> None:
    content = laser_file(["0", "10"], {(1, 1): "0", (1, 2): "0.01"}, file_type="rta").encode()
    text = proposed_profile(content, "b.rta").text.replace("\nunit:", "\nunit: mrad")
    test = read_positioning(content, "b.rta", read_profile(text.encode(), "P.yaml"))
    assert test.positive[1, 0] * 3600 == pytest.approx(10 * 0.2062648062, rel=1e-9)


@pytest.mark.parametrize(
    ("line", "axis"), [("Achse;Y1;;", "Y1"), ("Axis: X", "X"), ("an axis at ESS", None)]
)
def test_the_axis_above_a_table(line: str, axis: str | None) -> None:
    content = f"{line}\nSoll [mm];Abweichung [µm]\n0;0,4\n100;2,1\n".encode()
    proposed = proposed_profile(content, "x.csv")
    text = proposed.text.replace("\nsign:", "\nsign: measured minus target")
    text = text.replace("\ndirection_from:", '\ndirection_from: "+"')
    # not in the profile, which is made for one file and used for others: each file says it
    assert keys(proposed)["axis"] is None
    test = read_positioning(content, "x.csv", read_profile(text.encode(), "P.yaml"))
    assert test.axis == (axis or "")


@needs_shared
def test_a_real_log_of_a_rotary_axis() -> None:
    """Tank axis of ESS before its collision: reversal of 49 to 75 arcsec by position, published."""
    content = (REAL / "rotary" / "ess_tank_axis_repeatability.csv").read_bytes()
    before = b"\n".join(line for line in content.splitlines() if not line.startswith(b"2021-07"))
    proposed = proposed_profile(before, "tank.csv")
    found = keys(proposed)
    assert (found["target"], found["target_unit"]) == ("target_deg", "deg")
    assert (found["direction"], found["directions"]) == ("approach", {"+": "+", "-": "-"})
    assert (found["run"], found["axis"], found["value"]) == ("repeat", None, None)
    text = proposed.text
    for key, value in (("value", "encoder_deg"), ("value_is", "measured"), ("unit", "deg")):
        text = text.replace(f"\n{key}:  #", f"\n{key}: {value}  #")
    test = read_positioning(before, "tank.csv", read_profile(text.encode(), "P.yaml"))
    assert (test.positive.shape, test.negative.shape) == ((6, 6), (6, 6))
    reversal = np.abs(test.positive.mean(axis=1) - test.negative.mean(axis=1)) * 3600
    assert reversal.min() == pytest.approx(49, abs=0.5)
    assert reversal.max() == pytest.approx(75, abs=0.5)
    # both days in one file are two tests: a reading that comes twice is no repetition
    with pytest.raises(InputError, match="a reading is given twice"):
        read_positioning(content, "tank.csv", read_profile(text.encode(), "P.yaml"))


def test_the_number_of_a_row_is_no_run() -> None:
    lines = ["Nr;Soll [mm];Richtung;Abweichung [µm]"]
    for run in range(3):
        for direction, targets in (("auf", (0, 100, 200)), ("ab", (200, 100, 0))):
            lines += [f"{len(lines) + i};{x};{direction};{run},5" for i, x in enumerate(targets)]
    assert keys(proposed_profile("\n".join(lines).encode(), "x.csv"))["run"] is None
