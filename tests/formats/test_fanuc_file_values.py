"""Every parameter of a FANUC that acts is known as one that acts, in the numbers of its series.

The numbers: a real backup's own list (software D4G3) for straightness, three-dimensional and cyclic
compensation; FANUC A-78868E p3, p6 (2003) for the cyclic table; the definition of the 15i for its
grid, which no page confirms.
"""

from __future__ import annotations

import pytest

from compwright.formats.families.shapes import control_format
from compwright.formats.text.file_values import FileValue, changes
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS

FANUC = ("fanuc-30i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-0i-16i", "fanuc-15i")


def file_values(control: str, *lines: str) -> dict[str, FileValue]:
    text = "\n".join(("%", *lines, "%", "")).encode()
    family = control_format(DEFINITIONS[control], {})
    return {
        one.name: one
        for one in family.listing.file_values(
            family.definition, [ControlFile("P.TXT", text)], ()
        ).values()
    }


@pytest.mark.parametrize("control", FANUC)
@pytest.mark.parametrize(
    ("number", "word"),
    [
        (1004, "increment"),
        (1820, "detection unit"),
        (1850, "grid shift"),
        (1851, "backlash"),
        (3602, "pitch error"),
        (5711, "straightness"),
        (5799, "straightness"),
        (5861, "inclination"),
    ],
)
def test_what_acts_is_known(control: str, number: int, word: str) -> None:
    (one,) = file_values(control, f"N{number:05d}A1P1").values()
    assert one.relevant
    assert word in one.meaning


@pytest.mark.parametrize(
    ("number", "word"),
    [
        (13301, "straightness"),
        (13380, "straightness"),
        (13399, "straightness"),
        (10800, "three-dimensional"),
        (10814, "three-dimensional"),
        (14985, "cyclic"),
        (14988, "cyclic"),
        (3620, "reference"),
        (3624, "interval"),
        (3625, "turn"),
        (3626, "travel in -"),
    ],
)
def test_what_acts_on_the_later_series_is_known(number: int, word: str) -> None:
    (one,) = file_values("fanuc-30i", f"N{number:05d}Q1A1P1").values()
    assert (one.relevant, one.axis) == (True, "1")
    assert word in one.meaning


@pytest.mark.parametrize(
    ("number", "word"),
    [
        (5420, "reference"),
        (5421, "first"),
        (5422, "last"),
        (5423, "magnification"),
        (5424, "interval"),
        (5425, "turn"),
    ],
)
def test_the_grid_of_a_15i_has_its_own_numbers(number: int, word: str) -> None:
    (one,) = file_values("fanuc-15i", f"N{number:05d}A1P1").values()
    assert one.relevant
    assert word in one.meaning
    (other,) = file_values("fanuc-30i", f"N{number:05d}Q1A1P1").values()
    assert (other.relevant, other.meaning) == (False, "")


def test_the_grid_of_a_30i_is_none_on_a_15i() -> None:
    for number in (3620, 3621, 3622, 3623, 3624, 3625):
        (one,) = file_values("fanuc-15i", f"N{number:05d}A1P1").values()
        assert (one.relevant, one.meaning) == (False, "")


@pytest.mark.parametrize("control", FANUC)
@pytest.mark.parametrize(
    ("number", "word"),
    [(1020, "letter"), (1025, "letter"), (1026, "letter"), (1320, "limit"), (1420, "rapid")],
)
def test_a_letter_a_limit_and_a_rate_compensate_nothing(
    control: str, number: int, word: str
) -> None:
    (one,) = file_values(control, f"N{number:05d}A1P1").values()
    assert not one.relevant
    assert word in one.meaning


def test_a_large_number_of_an_axis_is_no_point_without_q() -> None:
    """The old series write neither Q1 nor Q0: what names an axis is a parameter (F11, F21)."""
    line = "N14985 A1 P {} A2 P 0"
    old, new = (file_values("fanuc-0i-16i", line.format(value), "N10040P2") for value in (0, 10))
    assert old["N14985A1"].text == "0"
    assert "cyclic" in old["N14985A1"].meaning
    (change,) = changes(old, new)
    assert change.new is not None
    assert (change.entry.name, change.new.text) == ("N14985A1", "10")
    assert (old["N10040"].text, old["N10040"].group) == (
        "2",
        "point of the pitch error compensation",
    )
