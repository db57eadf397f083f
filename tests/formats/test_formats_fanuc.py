"""FANUC in formats: what is read and written, against numbers worked by hand, the virtual control
and a line-by-line comparison.

Worked by hand from the manual's rules: number n owns the section below node n - r; totals are sums
from the reference; 3621 <= 3620 < 3622; a positive pulse is extra travel toward +.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import decode, open_control
from compwright.controls.decoded_state import DecodedState
from compwright.formats.definition.inheritance import found_in
from compwright.formats.definition.options import resolve_options
from compwright.formats.definitions import load_definition
from compwright.formats.families.increments.numbering import (
    NoRoom,
    NumberPlace,
    find_place,
    longest_gap,
)
from compwright.formats.families.shapes import control_format
from compwright.formats.text.diff import compare_files
from compwright.foundations.errors import CapacityError, CompwrightError, InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from fanuc_backup import NUMBERS, OLD_POINTS, parameters, pitch_data
from format_samples import CONTENT
from plans import ADDRESSES, random_plan, tolerance, worst_difference

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
UM = 1e-3
FANUC = ("fanuc-30i", "fanuc-0i-16i")
#: Corrections are whole counts of the detection unit: only the rounding of doubles remains. mm.
EXACT = 1e-12
DIALECTS = {"LF": "\n", "CR LF": "\r\n", "LF CR CR": "\n\r\r"}


def files(**texts: str | bytes) -> list[ControlFile]:
    return [
        ControlFile(
            name.replace("__", "."), text if isinstance(text, bytes) else text.encode("latin-1")
        )
        for name, text in texts.items()
    ]


def axis(address: str = "1", **words: Any) -> Axis:
    given: dict[str, Any] = {
        "name": "X",
        "kind": AxisKind.LINEAR,
        "travel": (-200.0, 200.0),
        **words,
    }
    return Axis(address=address, **given)


def both(
    own: Sequence[ControlFile], *axes: Axis, format_id: str = "fanuc-30i", **options: object
) -> DecodedState:
    """Read files with both readers; they have to agree."""
    return decode(
        open_control(Session(), format_id, {"detection_unit": 0.001, **options}), own, axes
    )


def table(
    steps: Sequence[int],
    totals: Sequence[float],
    negative: Sequence[float] | None = None,
    *,
    spacing: float = 50.0,
    **words: Any,
) -> AxisCompensation:
    """A table on whole spacings from the reference 0; totals in µm."""
    given: dict[str, Any] = {
        "address": "1",
        "kind": AxisKind.LINEAR,
        "interpolation": "step",
        **words,
    }
    return AxisCompensation(
        positions=np.array(steps) * spacing,
        positive=np.array(totals) * UM,
        negative=np.array(totals if negative is None else negative) * UM,
        **given,
    )


def write(
    *tables: AxisCompensation, axes: Sequence[Axis] | None = None, own: Sequence[ControlFile] = (),
    format_id: str = "fanuc-30i",
    **options: object,
) -> tuple[ControlFile, ...]:  # fmt: skip
    control = open_control(
        Session(),
        format_id,
        {"detection_unit": 0.001, **({} if own else {"first_point": 0}), **options},
    )
    chosen = list(
        axes
        or [
            axis(one.address, kind=one.kind, reference_return=one.reference_return)
            for one in tables
        ]
    )
    state = decode(control, own, chosen) if own else None
    return tuple(
        control_format(control.definition, control.options, state.state if state else None).write(
            list(tables), chosen, own
        )
    )


def refusal(*tables: AxisCompensation, **words: Any) -> str:
    with pytest.raises(CapacityError) as caught:
        write(*tables, **words)
    assert caught.value.exit_code == 4
    return str(caught.value)


def values(own: Sequence[ControlFile]) -> dict[str, str]:
    """What the files say, read by the plainest means: ``3620A1`` or ``10040`` -> text."""
    found: dict[str, str] = {}
    for file in own:
        for line in re.split(rb"[\r\n]+", file.content):
            text = line.decode().replace(" ", "")
            number = re.match(r"N0*(\d+)(?:Q\d)?", text)
            if number is None:
                continue
            groups = re.findall(r"(A\d+)?[PMI](-?[\d.]+)", text)
            found.update({f"{number[1]}{group}": value for group, value in groups})
    return found


def points(own: Sequence[ControlFile]) -> dict[int, int]:
    return {
        int(key) - 10_000: int(text)
        for key, text in values(own).items()
        if key.isdigit() and int(key) >= 10_000
    }


def numbers(own: Sequence[ControlFile], axis_number: int = 1) -> tuple[int, ...]:
    """3620, 3621, 3622."""
    said = values(own)
    return tuple(int(said[f"{number}A{axis_number}"]) for number in (3620, 3621, 3622))


# Reading: every style, one state
# ------------------------------------------------------------------------------------------

# Totals worked by hand from the increments 1 0 -2 1 | 2 1 0 -1 of the numbers 37 .. 44, reference
# 40, µm.
TOTALS = {-200: 0, -150: 1, -100: 1, -50: -1, 0: 0, 50: 2, 100: 3, 150: 3, 200: 2}
PARAMETERS = """%
N01001Q1L1P00000000
N01851Q1A1P4A2P0A3P6
N03605Q1A1P00000000A2P00000000A3P00000000
N03620Q1A1P40A2P0A3P0
N03621Q1A1P37A2P0A3P0
N03622Q1A1P44A2P0A3P0
N03623Q1A1P1A2P0A3P0
N03624Q1A1M50.0A2M0.0A3M0.0
%
"""
PITCH = (
    "%\n"
    + "".join(f"N{10_000 + number}Q0P{OLD_POINTS[number]}\n" for number in range(37, 45))
    + "%\n"
)
SHEET = (
    "# address: 1\n# value:"
    " correction\npoint,position,value,unit\n1851,,4,pulse\n3620,,40,pulse\n3621,,37,pulse\n3622,,44,pulse\n"
    "3623,,1,pulse\n3624,,50.0,mm\n3605#0,,0,\n"
    + "".join(f"{10_000 + n},,{OLD_POINTS[n]},pulse\n" for n in range(37, 45))
)
OLD_STYLE = {"Q1A": "A", "Q0P": "P", "Q1L1P": "P", "M50.0A2M0.0A3M0.0": "P50000A2P0A3P0"}


def without_q(text: str) -> str:
    for old, new in OLD_STYLE.items():
        text = text.replace(old, new)
    return text


def spaced(text: str) -> str:
    return re.sub(r"([A-Z])(-?[\d.]+)", r" \1 \2", text).replace(" N ", "N").replace("Q ", "Q")


STYLES = {
    "30i": ("fanuc-30i", files(P__TXT=PARAMETERS, Q__TXT=PITCH)),
    "one file": (
        "fanuc-30i",
        files(ALL__TXT=PARAMETERS.removesuffix("%\n") + PITCH.removeprefix("%\n")),
    ),
    "pitch data first": ("fanuc-30i", files(Q__TXT=PITCH, P__TXT=PARAMETERS)),
    "four digits": ("fanuc-30i", files(P__TXT=PARAMETERS.replace("N0", "N"), Q__TXT=PITCH)),
    "two paths": (
        "fanuc-30i",
        files(
            P__TXT=PARAMETERS.replace("L1P00000000", "L1P00000000L2P00000001").replace(
                "%\n", "%\nN00981Q1A1P1A2P1A3P1\n", 1
            ),
            Q__TXT=PITCH,
        ),
    ),
    "P for a length": (
        "fanuc-30i",
        files(P__TXT=PARAMETERS.replace("M50.0", "P50.0"), Q__TXT=PITCH),
    ),
    "no Q at the points": ("fanuc-30i", files(P__TXT=PARAMETERS, Q__TXT=PITCH.replace("Q0", ""))),
    "CNCID": (
        "fanuc-30i",
        files(P__TXT=PARAMETERS.replace("%", "%(CNCID=01234567,89ABCDEF)", 1), Q__TXT=PITCH),
    ),
    "comments": (
        "fanuc-30i",
        files(P__TXT=PARAMETERS.replace("A2P0A3P6", "(X) A2P0A3P6 (mm\xfc)"), Q__TXT=PITCH),
    ),
    "typed-entry sheet": ("fanuc-30i", files(entry_X__csv=SHEET)),
    "blanks": ("fanuc-30i", files(P__TXT=spaced(PARAMETERS), Q__TXT=spaced(PITCH))),
    "16i": ("fanuc-0i-16i", files(P__TXT=without_q(PARAMETERS), Q__TXT=without_q(PITCH))),
    "16i, 4 digits": (
        "fanuc-0i-16i",
        files(P__TXT=without_q(PARAMETERS).replace("N0", "N"), Q__TXT=without_q(PITCH)),
    ),
    "16i, blanks": (
        "fanuc-0i-16i",
        files(P__TXT=spaced(without_q(PARAMETERS)), Q__TXT=spaced(without_q(PITCH))),
    ),
    "16i, real length": (
        "fanuc-0i-16i",
        files(P__TXT=without_q(PARAMETERS).replace("P50000", "P50.0"), Q__TXT=without_q(PITCH)),
    ),
    **{
        f"{name} in the {format_id}": (
            format_id,
            files(P__TXT=text[0].replace("\n", newline), Q__TXT=text[1].replace("\n", newline)),
        )
        for name, newline in DIALECTS.items()
        for format_id, text in {
            "fanuc-30i": (PARAMETERS, PITCH),
            "fanuc-0i-16i": (without_q(PARAMETERS), without_q(PITCH)),
        }.items()
    },
}


@pytest.mark.parametrize("style", STYLES)
def test_every_style_gives_the_state_worked_by_hand(style: str) -> None:
    format_id, own = STYLES[style]
    state = both(own, axis(), format_id=format_id).state.axes["1"]
    np.testing.assert_allclose(state.positions, list(TOTALS), atol=EXACT)
    np.testing.assert_allclose(state.positive, np.array(list(TOTALS.values())) * UM, atol=EXACT)
    np.testing.assert_allclose(state.negative, state.positive, atol=0)
    assert state.backlash == pytest.approx(0.004, abs=EXACT)
    assert float(state.at(np.array([24.9, 25.1, 900.0]), DOWN) @ [1, 10, 100]) == pytest.approx(
        (-4 + 10 * (2 - 4) + 100 * (2 - 4)) * UM, abs=EXACT
    )


def test_an_interval_in_inches() -> None:
    """2 inches are 50.8 mm: by the letter I, or by P on an inch machine (1001#0)."""
    by_letter = PARAMETERS.replace("M50.0", "I2.0")
    by_machine = PARAMETERS.replace("L1P00000000", "L1P00000001").replace("M50.0", "P2.0")
    for text in (by_letter, by_machine):
        state = both(files(P__TXT=text, Q__TXT=PITCH), axis()).state.axes["1"]
        np.testing.assert_allclose(state.positions, np.arange(-4, 5) * 50.8, atol=EXACT)


def test_other_axes_of_a_backup_are_read_by_their_own_numbers() -> None:
    own = files(P__TXT=parameters(lines=50), Q__TXT=pitch_data())
    state = both(own, axis("2", name="Y")).state.axes["2"]
    # Y: reference 100, numbers 100 .. 104, magnification 2, 100 mm: increments 0 | 3 -1 2 -2 twice
    # as large, µm.
    np.testing.assert_allclose(state.positions, [-100, 0, 100, 200, 300, 400], atol=EXACT)
    np.testing.assert_allclose(state.positive, np.array([0, 0, 6, 4, 8, 4]) * UM, atol=EXACT)


def test_an_axis_that_only_other_parameters_name_is_none() -> None:
    """1852 or limits of a ninth axis (a spindle, a PMC axis) do not make a compensated axis of
    it.
    """
    own = files(
        P__TXT=PARAMETERS.replace("%\nN01001", "%\nN01852Q1A1P4A9P6\nN01320Q1A1M1.0A9M1.0\nN01001"),
        Q__TXT=PITCH,
    )
    assert set(both(own).state.axes) == {"1", "2", "3"}


def test_a_parameter_above_10000_is_no_point() -> None:
    marked = PITCH.replace("%\nN10037", "%\nN10037Q1P5\nN10500Q1P7\nN11350Q1P9\nN10037")
    own = files(P__TXT=PARAMETERS, Q__TXT=marked)
    np.testing.assert_allclose(
        both(own, axis()).state.axes["1"].positive, np.array(list(TOTALS.values())) * UM, atol=EXACT
    )
    new = points_changed(own, write(table(range(-4, 5), [0] * 9), own=own))
    assert "N10037Q1P5" in new
    assert "N10500Q1P7" in new
    old = files(
        P__TXT=without_q(PARAMETERS).replace("%\nN01001", "%\nN13600P00000000\nN12345P3\nN01001"),
        Q__TXT=without_q(PITCH),
    )
    np.testing.assert_allclose(
        both(old, axis(), format_id="fanuc-0i-16i").state.axes["1"].positive,
        np.array(list(TOTALS.values())) * UM,
        atol=EXACT,
    )


def points_changed(own: Sequence[ControlFile], new: Sequence[ControlFile]) -> list[str]:
    assert [file.name for file in new] == [file.name for file in own]
    return new[-1].content.decode().splitlines()


@pytest.mark.parametrize(
    ("what", "old", "new"),
    [
        ("plus sign", "N10041Q0P2", "N10041Q0P+2"),
        ("decimal increment", "N10041Q0P2", "N10041Q0P2.0"),
        ("semicolon", "N10041Q0P2", "N10041Q0P2;"),
        ("two values for one point", "N10041Q0P2", "N10041Q0P2\nN10041Q0P3"),
        ("point lost", "N10041Q0P2\n", ""),
        ("increment out of range", "N10041Q0P2", "N10041Q0P129"),
        ("length without a point", "M50.0", "M50"),
        ("numbers out of order", "3620Q1A1P40", "3620Q1A1P45"),
        ("beyond the array", "3622Q1A1P44", "3622Q1A1P1600"),
        ("no interval", "M50.0", "M0.0"),
        ("magnification", "3623Q1A1P1", "3623Q1A1P101"),
        ("a parameter lost", "N03620Q1A1P40A2P0A3P0\n", ""),
        ("two references", "N03621", "N03620Q1A1P41\nN03621"),
        ("a bare carriage return", "N01851", "\rN01851"),
        ("a bare carriage return behind %", "%\nN01001", "%\rN01851Q1A1P9\nN01001"),
        ("a bare carriage return among the points", "N10041", "(x)\rN10041"),
        ("backlash", "1851Q1A1P4", "1851Q1A1P10000"),
        ("two sets without their numbers", "3605Q1A1P00000000", "3605Q1A1P00000001"),
    ],
)
def test_contradictions_are_refused_with_the_line(what: str, old: str, new: str) -> None:
    assert (PARAMETERS + PITCH).count(old) >= 1
    own = files(P__TXT=PARAMETERS.replace(old, new, 1), Q__TXT=PITCH.replace(old, new, 1))
    with pytest.raises(InputError) as caught:
        both(own, axis())
    assert "line" in str(caught.value)


@pytest.mark.parametrize("cut", [b"\n%\n", b"-1\n%\n", b"P-1\n%\n"])
def test_a_file_that_ends_inside_a_record_is_refused(cut: bytes) -> None:
    """N10044Q0P-1 without what follows: the value may have had more digits."""
    whole = PITCH.encode()
    assert whole.endswith(cut)
    own = [*files(P__TXT=PARAMETERS), ControlFile("Q.TXT", whole.removesuffix(cut))]
    with pytest.raises(InputError):
        both(own, axis())
    with pytest.raises(InputError):  # the reader that writes sees it without the judge
        control_format(
            open_control(Session(), "fanuc-30i", {}).definition, {"detection_unit": 0.001}
        ).read(own, [axis()])


def test_the_sheet_s_millimetres_stay_millimetres_on_an_inch_machine() -> None:
    unit = files(UNIT__TXT="%\nN01001Q1L1P00000001\n%\n")
    state = both([*unit, *files(entry_X__csv=SHEET)], axis()).state.axes["1"]
    np.testing.assert_allclose(state.positions, list(TOTALS), atol=EXACT)


def test_pitch_data_alone_or_parameters_alone_are_contradictory() -> None:
    for own in (files(P__TXT=PARAMETERS), files(Q__TXT=PITCH)):
        with pytest.raises(InputError):
            both(own, axis())


def test_unused_axes_of_a_new_machine_are_no_contradiction() -> None:
    """Magnification 1 with 3620 = 3621 = 3622 = 0 and no interval: the axis has no section, so
    nothing acts.
    """
    text = PARAMETERS.replace("3623Q1A1P1A2P0", "3623Q1A1P1A2P1")
    assert both(files(P__TXT=text, Q__TXT=PITCH)).state.axes["2"].positions.size == 0


def test_a_machine_reference_beside_zero_is_checked_and_said() -> None:
    text = PARAMETERS.replace("N01851", "N01240Q1A1M100.0A2M0.0A3M0.0\nN01851")
    own = files(P__TXT=text, Q__TXT=PITCH)
    with pytest.raises(InputError, match="1240"):
        both(own, axis())
    state = both(own, axis(reference=100.0)).state
    np.testing.assert_allclose(
        state.axes["1"].positions, np.array(list(TOTALS)) + 100.0, atol=EXACT
    )
    assert "CW-S018" in {finding.code for finding in state.findings}


def test_a_diameter_axis_is_refused_unless_the_job_knows() -> None:
    text = PARAMETERS.replace("N01851", "N01006Q1A1P00001000A2P00000000A3P00000000\nN01851")
    own = files(P__TXT=text, Q__TXT=PITCH)
    with pytest.raises(InputError, match="diameter"):
        both(own, axis())
    state = both(own, axis(programmed="diameter")).state
    assert "CW-S019" in {finding.code for finding in state.findings}


def test_detection_units_by_axis() -> None:
    own = files(P__TXT=parameters(lines=10), Q__TXT=pitch_data())
    control = open_control(Session(), "fanuc-30i", {})
    with pytest.raises(UsageError) as caught:
        decode(control, own, [axis()])
    assert caught.value.exit_code == 2
    x, y = (
        axis(options={"detection_unit": 0.0001}),
        axis("2", name="Y", options={"detection_unit": 0.002}),
    )
    state = decode(control, own, [x, y]).state
    assert float(state.axes["1"].positive.max()) == pytest.approx(3e-4, abs=EXACT)
    assert float(state.axes["2"].positive.max()) == pytest.approx(16 * UM, abs=EXACT)


# Writing: numbers by hand
# -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("format_id", FANUC)
def test_a_fresh_table_has_the_numbers_worked_by_hand(format_id: str) -> None:
    new = write(
        table(list(range(-4, 5)), list(TOTALS.values()), backlash=4 * UM), format_id=format_id
    )
    reference, first, last = numbers(new)
    assert (first - reference, last - reference) == (-3, 4)
    assert [points(new)[number] for number in range(first, last + 1)] == [1, 0, -2, 1, 2, 1, 0, -1]
    said = values(new)
    assert (said["3623A1"], said["1851A1"], said["3624A1"]) == (
        "1",
        "4",
        "50.0" if format_id == "fanuc-30i" else "50000",
    )
    assert not any("A2" in file.content.decode() or "3605" in file.content.decode() for file in new)


def test_a_travel_that_starts_at_the_reference() -> None:
    """3621 must not lie above 3620: it is 3620 itself, with increment 0."""
    new = write(table([0, 1, 2], [0, 3, -1]))
    reference, first, last = numbers(new)
    assert (first, last) == (reference, reference + 2)
    assert [points(new)[number] for number in range(first, last + 1)] == [0, 3, -4]


def test_a_travel_that_ends_at_the_reference() -> None:
    """3622 must lie above 3620: one more number, with increment 0."""
    new = write(table([-2, -1, 0], [4, 1, 0]))
    reference, first, last = numbers(new)
    assert (first, last) == (reference - 1, reference + 1)
    assert [points(new)[number] for number in range(first, last + 1)] == [-3, -1, 0]


@pytest.mark.parametrize("output", ["step", "ramp"])
@pytest.mark.parametrize("home", [UP, DOWN])
@pytest.mark.parametrize("reference", [0.0, -850.0, 312.5])
def test_written_for_any_reference_the_judge_does_what_was_meant(
    reference: float, home: Direction, output: str
) -> None:
    rng = np.random.default_rng(5)
    steps = np.arange(-7, 4)
    totals = np.cumsum(rng.integers(-9, 10, steps.size)).astype(float)
    totals -= totals[steps == 0]
    meant = replace(
        table(
            steps.tolist(), totals.tolist(), spacing=12.5, backlash=6 * UM, reference_return=home
        ),
        positions=np.asarray(reference + steps * 12.5, dtype=np.float64),
        interpolation="step" if output == "step" else "linear",
    )
    where = axis(reference=reference, reference_return=home)
    new = write(meant, axes=[where], output=output, points_from="reference")
    judge = virtual_control(
        "fanuc-30i",
        new,
        reference_return={"1": home},
        reference={"1": reference},
        kinds={"1": AxisKind.LINEAR},
        options={"detection_unit": 0.001, "output": output},
    )
    probe = (
        reference + np.linspace(-120, 80, 1501) + 0.01
    )  # beside the middles of the sections, where the steps lie
    for side in Direction:
        np.testing.assert_allclose(
            judge.correction("1", probe, side), meant.at(probe, side), atol=EXACT
        )


def test_the_sign_of_pitch_data_is_the_user_s_to_turn() -> None:
    new = write(table([0, 1, 2], [0, 3, -1]), pitch_sign="-")
    assert [points(new)[number] for number in range(numbers(new)[1], numbers(new)[2] + 1)] == [
        0,
        -3,
        4,
    ]
    np.testing.assert_allclose(
        both(new, axis(), pitch_sign="-").state.axes["1"].positive[1:],
        np.array([0, 3, -1]) * UM,
        atol=EXACT,
    )


@pytest.mark.parametrize(
    ("increments", "limit", "expected"),
    [
        ([3, -2, 5], "7", 1),
        ([14, -8, 6], "7", 2),  # 14 / 7
        ([12, -12, 18], "7", 3),  # 18 / 7 is above 2; 3 divides all
        ([300, -150, 450], "127", 5),  # 450 / 127 is above 3; 4 does not divide 150
    ],
)
def test_the_magnification_is_the_smallest_that_divides(
    increments: list[int], limit: str, expected: int
) -> None:
    new = write(table([0, 1, 2, 3], [0, *np.cumsum(increments).tolist()]), increment_limit=limit)
    assert values(new)["3623A1"] == str(expected)
    assert [points(new)[numbers(new)[0] + k] * expected for k in (1, 2, 3)] == increments


@pytest.mark.parametrize(
    ("increments", "limit"), [([8, 1, 0], "7"), ([128, 127, 0], "127"), ([13000, 0, 0], "127")]
)
def test_increments_beyond_the_series_are_refused_with_what_would_help(
    increments: list[int], limit: str
) -> None:
    said = refusal(table([0, 1, 2, 3], [0, *np.cumsum(increments).tolist()]), increment_limit=limit)
    assert f"at most {limit}" in said
    assert "smaller spacing" in said


def test_what_the_control_cannot_hold_is_refused() -> None:
    assert "lie at the reference position" in refusal(
        replace(table([0, 1, 2], [0, 1, 2]), positions=np.array([0.0, 50.0, 101.0]))
    )
    assert "reach from the reference" in refusal(table([1, 2, 3], [0, 1, 2]))
    assert "multiple of the detection unit" in refusal(table([0, 1, 2], [0, 1.5, 2]))
    assert "zero at the reference" in refusal(table([-1, 0, 1], [0, 1, 2]))
    assert "9.999" in refusal(table([0, 1, 2], [0, 1, 2], backlash=10.0))
    assert "twice" in refusal(
        table([0, 1, 2], [0, 1, 2], [0, 2, 2], backlash=UM), own=two_sets_backup()
    )
    assert "not a multiple of 0.001 mm" in refusal(table([0, 1, 2], [0, 1, 2], spacing=12.3456))


@pytest.mark.parametrize(("format_id", "highest"), [("fanuc-30i", 1535), ("fanuc-0i-16i", 1023)])
def test_the_last_number_of_the_array_is_used_and_none_beyond(format_id: str, highest: int) -> None:
    """From 0 to ``highest`` there are highest + 1 numbers: a table from the reference on has
    highest + 1 nodes.
    """
    nodes = highest + 1
    new = write(table(list(range(nodes)), [0] * nodes, spacing=1.0), format_id=format_id)
    assert numbers(new) == (0, 0, highest)
    said = refusal(
        table(list(range(nodes + 1)), [0] * (nodes + 1), spacing=1.0), format_id=format_id
    )
    assert str(nodes) in said


def test_the_interval_that_the_feed_allows() -> None:
    """36 000 mm/min / 7500 = 4.8 mm."""
    control = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001, "max_feed": 36000})
    assert control_format(control.definition, control.options).capacity(
        axis()
    ).min_spacing == pytest.approx(4.8)
    assert "too close" in refusal(table([0, 1, 2], [0, 1, 2], spacing=4.75), max_feed=36000)
    assert write(table([0, 1, 2], [0, 1, 2], spacing=4.8), max_feed=36000)


# Into the user's own backup
# -----------------------------------------------------------------------------------------------


def backup(
    newline: str = "\n",
    *,
    lines: int = 200,
    highest: int = 1023,
    numbers: Mapping[int, Sequence[str]] = NUMBERS,
) -> list[ControlFile]:
    return files(
        CNC_PARA__TXT=parameters(newline, lines=lines, numbers=numbers),
        PITCH__TXT=pitch_data(newline, highest=highest),
    )


def with_numbers(**changes: Sequence[str]) -> dict[int, Sequence[str]]:
    return {**NUMBERS, **{int(name.removeprefix("n")): value for name, value in changes.items()}}


@pytest.mark.parametrize("ends", DIALECTS)
def test_in_a_backup_of_15000_lines_nothing_else_changes(ends: str) -> None:
    """A whole one with the line ends of a real backup, shorter ones with others."""
    newline = DIALECTS[ends]
    own = backup(newline, lines=14_000 if ends == "LF CR CR" else 1_400)
    steps = list(range(-10, 11))
    meant = table(steps, [abs(k) for k in steps], spacing=20.0, backlash=7 * UM)
    new = write(meant, own=own)
    expected = {
        b"N01851Q1A1P4": b"N01851Q1A1P7",
        b"N03621Q1A1P37": b"N03621Q1A1P31",
        b"N03622Q1A1P44": b"N03622Q1A1P50",
        b"N03624Q1A1M50.0": b"N03624Q1A1M20.0",
        **{
            f"N{10_040 + k}Q0P{OLD_POINTS.get(40 + k, 0)}".encode(): (
                f"N{10_040 + k}Q0P{-1 if k <= 0 else 1}".encode()
            )
            for k in range(-9, 11)
        },
    }
    changed = 0
    mark = newline.encode()
    for old_file, new_file in zip(own, new, strict=True):
        old_lines, new_lines = old_file.content.split(mark), new_file.content.split(mark)
        assert len(old_lines) == len(new_lines) > 1000
        for old, line in zip(old_lines, new_lines, strict=True):
            if old == line:
                continue
            head = next(start for start in expected if old.startswith(start))
            assert line == expected[head] + old[len(head) :]
            changed += 1
    assert changed == sum(old != line for old, line in expected.items())
    before, after = both(own), both(new)
    for address in ("2", "3", "4"):
        for side in Direction:
            probe = np.linspace(-500, 500, 301)
            np.testing.assert_array_equal(
                after.state.axes[address].at(probe, side), before.state.axes[address].at(probe,
                side)
            )  # fmt: skip
    np.testing.assert_allclose(after.state.axes["1"].positive, meant.positive, atol=EXACT)


def test_the_number_of_lines_that_stay() -> None:
    own = backup(lines=1_400)
    new = write(table(list(range(-4, 5)), list(TOTALS.values()), backlash=5 * UM), own=own)
    diff = compare_files(open_control(Session(), "fanuc-30i", {}).definition, own, new)
    total = sum(len(file.content.splitlines()) for file in own)
    assert [(change.entry, change.old, change.new) for change in diff.changes] == [
        ("N01851Q1A1", "4", "5")
    ]
    assert diff.untouched == total - 1


def test_missing_point_records_are_put_in_their_place_and_style() -> None:
    own = files(P__TXT=PARAMETERS, Q__TXT=PITCH.replace("Q0P", "Q0 P"))
    steps = list(range(-6, 7))
    new = write(table(steps, steps, spacing=30.0), own=own, first_point=30)
    lines = new[1].content.decode().split()
    assert lines[0] == lines[-1] == "%"
    assert re.findall(r"N(\d+)Q0 P(-?\d+)\n", new[1].content.decode()) == [
        (str(10_035 + k), "1") for k in range(12)
    ]


def test_numbers_that_are_no_longer_used_are_zero() -> None:
    own = backup()
    new = write(table([-1, 0, 1], [2, 0, 3], spacing=200.0), own=own)
    assert numbers(new) == (40, 40, 41)
    assert [points(new)[number] for number in range(36, 46)] == [0, 0, 0, 0, -2, 3, 0, 0, 0, 0]
    assert points(new)[101] == OLD_POINTS[101]


def test_a_table_that_grows_into_its_neighbour_moves_to_a_free_block() -> None:
    own = backup()
    steps = list(range(-50, 71))
    new = write(table(steps, steps, spacing=5.0), own=own)
    reference, first, last = numbers(new)
    used = {
        *range(100, 105),
        *range(200, 209),
        *range(300, 311),
    }  # Y, B, and Z whose table is switched off
    assert used.isdisjoint(range(first, last + 1))
    assert (first, last) == (reference - 49, reference + 70)
    after, before = points(new), points(own)
    assert {number: after[number] for number in used} == {number: before[number] for number in used}
    assert all(after[number] == 0 for number in range(37, 45) if not first <= number <= last)
    assert both(new).state.axes["1"].positive[-1] == pytest.approx(70 * UM)


def test_a_neighbour_that_shares_numbers_keeps_them() -> None:
    """Two axes that use the same numbers in the same way (a gantry): the new table gets numbers of
    its own.
    """
    shared = with_numbers(
        n3620=("40", "40", "300", "200"),
        n3621=("37", "37", "300", "200"),
        n3622=("44", "44", "310", "208"),
        n3623=("1", "1", "0", "1"),
        n3624=("50.0", "50.0", "50.0", "45.0"),
    )
    own = backup(numbers=shared)
    assert "CW-S014" in {finding.code for finding in both(own).state.findings}
    new = write(table(list(range(-4, 5)), [9, 8, 7, 6, 0, 5, 4, 3, 2]), own=own)
    assert {number: points(new)[number] for number in range(37, 45)} == {
        number: OLD_POINTS[number] for number in range(37, 45)
    }
    np.testing.assert_allclose(
        both(new).state.axes["2"].positive, np.array(list(TOTALS.values())) * UM, atol=EXACT
    )


def test_the_second_set_of_a_neighbour_is_never_touched() -> None:
    """Y has two sets, 100 .. 104 and 50 .. 54: X, which would grow into the second, moves."""
    own = backup(
        numbers=with_numbers(
            n3605=("00000000", "00000001", "00000000", "00000100"),
            n3626=("0", "50", "0", "0"),
            n3627=("0", "-3", "0", "0"),
        )
    )
    steps = list(range(-4, 17))
    new = write(table(steps, steps, spacing=25.0), own=own)
    _, first, last = numbers(new)
    assert set(range(50, 55)).isdisjoint(range(first, last + 1))
    before, after = both(own).state.axes["2"], both(new).state.axes["2"]
    for side in Direction:
        np.testing.assert_array_equal(after.curve(side), before.curve(side))


@pytest.mark.parametrize(
    ("first", "clear"), [(29, True), (30, False), (37, False), (44, False), (45, True)]
)
def test_two_sets_that_share_one_number_are_refused(first: int, *, clear: bool) -> None:
    """The set for + is 37 .. 44: eight numbers from 30 share its first, from 44 its last."""
    two = PARAMETERS.replace("3605Q1A1P00000000", "3605Q1A1P00000001").replace(
        "N03623", f"N03626Q1A1P{first}A2P0A3P0\nN03627Q1A1P0A2P0A3P0\nN03623"
    )
    points = {**dict.fromkeys(range(first, first + 8), 0), **OLD_POINTS}
    pitch = "".join(f"N{10_000 + number}Q0P{value}\n" for number, value in points.items())
    own = files(P__TXT=two, Q__TXT=f"%\n{pitch}%\n")
    reader = control_format(
        open_control(Session(), "fanuc-30i", {}).definition, {"detection_unit": 0.001}
    )
    if clear:
        state = reader.read(own, [axis()]).axes["1"]
        assert not np.array_equal(state.positive, state.negative)
        return
    with pytest.raises(InputError, match="the two sets overlap") as caught:
        reader.read(own, [axis()])
    assert "clear of 37 .. 44" in str(caught.value)


def test_places_against_brute_force() -> None:
    """All numbers tried one by one, for random ranges of other axes, some beyond the array."""
    rng = np.random.default_rng(4)
    for _ in range(300):
        highest, start = int(rng.integers(5, 60)), int(rng.integers(0, 5))
        used = [
            range(int(low), int(low + rng.integers(1, 9)))
            for low in rng.integers(0, 65, rng.integers(0, 5))
        ]
        free = [
            start <= number <= highest and not any(number in one for one in used)
            for number in range(80)
        ]
        runs = "".join("x" if one else " " for one in free).split()
        assert longest_gap(highest, used, start) == max(map(len, runs), default=0)
        low, high, two = -int(rng.integers(0, 8)), int(rng.integers(0, 8)), bool(rng.integers(0, 2))
        needed = (max(high, 1) - min(low + 1, 0) + 1) * (2 if two else 1)
        try:
            place = find_place(
                low, high, highest=highest, used=used, two=two, reference=None, start=start
            )
        except NoRoom:
            assert max(map(len, runs), default=0) < needed
            continue
        taken = [number for one in place.ranges for number in one]
        assert len(taken) == needed
        assert all(free[number] for number in taken)
        assert place.first == min(
            begin
            for begin in range(80)
            if all(free[begin : begin + needed]) and begin + needed <= 80
        )
        assert place.first <= place.reference < place.last


def test_an_axis_keeps_its_reference_number_where_the_table_still_fits() -> None:
    """Nodes -1 .. 5 around number 5 need 5 .. 10; nodes -1 .. 6 need 5 .. 11, which an array that
    ends at 10 does not have.
    """
    assert find_place(-1, 5, highest=10, used=[], two=False, reference=5, start=0) == NumberPlace(
        5, 5, 10
    )
    assert find_place(-1, 6, highest=10, used=[], two=False, reference=5, start=0) == NumberPlace(
        0, 0, 6
    )
    assert find_place(
        -1, 5, highest=10, used=[range(9, 10)], two=False, reference=5, start=0
    ) == NumberPlace(0, 0, 5)


def test_an_axis_that_has_to_move_stays_in_its_own_numbers() -> None:
    """Nodes -1 .. 6 need seven numbers and no longer fit around 56 in 50 .. 60; numbers from 0 on
    are free for every axis.
    """
    own = [range(50, 61)]
    found = find_place(-1, 6, highest=60, used=[], two=False, reference=56, claimed=own, start=0)
    assert found == NumberPlace(50, 50, 56)
    none = find_place(-1, 6, highest=60, used=[], two=False, reference=56, start=0)
    assert none == NumberPlace(0, 0, 6)


def test_no_room_is_refused_with_the_longest_gap() -> None:
    own = backup(highest=1535)
    # The longest row between and behind Y (100 .. 104), B (200 .. 208) and Z (300 .. 310): 311 ..
    # 1535, one section each.
    said = refusal(table(list(range(1300)), [0] * 1300, spacing=1.0), own=own)
    assert f"at most {1535 - 310 + 1}, found 1300" in said
    both_sets = table(list(range(700)), [0] * 700, [4] * 700, spacing=1.0)
    said = refusal(both_sets, own=own)
    assert "needs 1400 point numbers in a row" in said
    assert f"has {1535 - 310}" in said


def test_two_axes_at_once_do_not_meet() -> None:
    own = backup()
    x = table(list(range(-45, 46)), list(range(-45, 46)), spacing=5.0)
    y = table(list(range(31)), list(range(31)), spacing=10.0, address="2")
    new = write(x, y, axes=[axis(), axis("2", name="Y")], own=own)
    taken = [set(range(numbers(new, one)[1], numbers(new, one)[2] + 1)) for one in (1, 2)]
    assert taken[0].isdisjoint(taken[1])
    state = both(new).state
    for one, meant in (("1", x), ("2", y)):
        np.testing.assert_allclose(
            state.axes[one].at(meant.positions, UP), meant.positive, atol=EXACT
        )


def test_a_number_that_one_axis_leaves_and_another_takes_is_written_once() -> None:
    """X gives up 37 .. 39, Y (in the next block) grows down into them."""
    near = with_numbers(
        n3620=("40", "48", "300", "200"),
        n3621=("37", "47", "300", "200"),
        n3622=("44", "50", "310", "208"),
    )
    own = backup(numbers=near)
    x = table([0, 1], [0, 5], spacing=100.0)
    y = table(list(range(-6, 4)), list(range(-6, 4)), spacing=100.0, address="2")
    new = write(x, y, axes=[axis(), axis("2", name="Y")], own=own)
    state = both(new).state
    np.testing.assert_allclose(state.axes["1"].at(x.positions, UP), x.positive, atol=EXACT)
    np.testing.assert_allclose(state.axes["2"].at(y.positions, UP), y.positive, atol=EXACT)


def test_files_of_an_earlier_run_are_patched_too() -> None:
    first = write(table([0, 1, 2], [0, 3, -1], backlash=2 * UM))
    second = write(table([0, 1, 2, 3], [0, 1, 2, 4], spacing=30.0), own=first, first_point=0)
    assert [file.name for file in second] == [file.name for file in first]
    np.testing.assert_allclose(
        both(second, axis()).state.axes["1"].positive, np.array([0, 0, 1, 2, 4]) * UM, atol=EXACT
    )
    back = write(table([0, 1, 2], [0, 3, -1], backlash=2 * UM), own=second, first_point=0)
    assert {key: text for key, text in values(back).items() if text != "0"} == {
        key: text for key, text in values(first).items() if text != "0"
    }


# Two sets
# --------------------------------------------------------------------------------------------------


def two_sets_backup() -> list[ControlFile]:
    return files(
        P__TXT=PARAMETERS.replace("N03623", "N03626Q1A1P0A2P0A3P0\nN03627Q1A1P0A2P0A3P0\nN03623"),
        Q__TXT=PITCH,
    )


@pytest.mark.parametrize("home", [UP, DOWN])
def test_two_sets_written_and_read_back(home: Direction) -> None:
    own = two_sets_backup()
    steps = list(range(-4, 5))
    positive, negative = [1, 4, 2, 3, 0, -1, -2, 5, 5], [-8, -6, -7, -5, -4, -3, -6, -9, -2]
    if home is DOWN:
        positive, negative = negative, positive
    where = axis(reference_return=home)
    meant = table(steps, positive, negative, reference_return=home)
    new = write(meant, axes=[where], own=own, first_point=0)
    said = values(new)
    assert said["3605A1"] == "00000001"
    assert said["3605A2"] == said["3605A3"] == "00000000"
    assert said["1851A1"] == "0"
    assert said["3627A1"] == "-4"  # the other direction's value at the reference
    _, first, last = numbers(new)
    other = int(said["3626A1"])
    assert [points(new)[n] for n in range(first, last + 1)] == np.diff(positive).tolist()
    assert [points(new)[n] for n in range(other, other + last - first + 1)] == np.diff(
        negative
    ).tolist()
    judge = both(new, where).judge
    assert judge is not None
    for side, curve in ((UP, positive), (DOWN, negative)):
        np.testing.assert_allclose(
            judge.correction("1", meant.positions, side), np.array(curve) * UM, atol=EXACT
        )
    one = write(
        replace(meant, positive=meant.curve(home), negative=meant.curve(home)),
        axes=[where],
        own=new,
    )
    assert values(one)["3605A1"] == "00000000"  # back to one set


def test_two_sets_need_the_bit_among_the_files() -> None:
    meant = table([-1, 0, 1], [1, 0, 2], [0, -3, 1])
    for own in ((), files(P__TXT=re.sub("N03605.*\n", "", PARAMETERS), Q__TXT=PITCH)):
        said = refusal(meant, own=own)
        assert "3605#0" in said
        assert "read from the control" in said


def test_an_offset_that_3627_cannot_hold() -> None:
    """In units of 0.0001 mm 3.3 mm are 33 000: above 32 767."""
    meant = table([0, 1], [0, 0], [3300, 3300])
    assert "32767" in refusal(meant, own=two_sets_backup(), detection_unit=0.0001)


# Rotary axes
# --------------------------------------------------------------------------------------------------


def turn(totals: Sequence[float]) -> AxisCompensation:
    return replace(
        table(range(len(totals)), totals, spacing=45.0), kind=AxisKind.ROTARY, period=360.0
    )


ENDLESS: dict[str, Any] = {
    "kind": AxisKind.ROTARY,
    "travel": (0.0, 360.0),
    "modulo": 360.0,
    "name": "B",
}


def test_an_endless_axis() -> None:
    meant = turn([0, 1, -1, 0, 3, 2, 1, -1, 0])
    new = write(meant, axes=[axis(**ENDLESS)])
    reference, first, last = numbers(new)
    assert (first, last) == (reference, reference + 8)
    held = [points(new)[number] for number in range(first, last + 1)]
    assert held[1:] == [1, -2, 1, 3, -1, -1, -2, 1]
    assert held[0] == held[-1]
    assert values(new)["3625A1"] == "360.0"
    judge = both(new, axis(**ENDLESS)).judge
    assert judge is not None
    np.testing.assert_allclose(
        judge.correction("1", meant.positions - 720.0, UP), meant.positive, atol=EXACT
    )


def test_an_endless_axis_must_close() -> None:
    assert "two ends of the table of an endless axis must be equal" in refusal(
        turn([0, 1, -1, 0, 3, 2, 1, -1, 1]), axes=[axis(**ENDLESS)]
    )


def test_a_table_of_an_endless_axis_that_creeps_is_refused_when_read() -> None:
    own = backup()
    text = own[1].content.replace(b"N10208Q0P1", b"N10208Q0P2")
    crept = [own[0], ControlFile("PITCH.TXT", text)]
    with pytest.raises(InputError, match="creeps"):
        both(crept)
    with pytest.raises(InputError, match="creeps"):  # by the reader that writes, too
        control_format(
            open_control(Session(), "fanuc-30i", {}).definition, {"detection_unit": 0.001}
        ).read(crept, address="4")


# Second forms
# --------------------------------------------------------------------------------------------------


def forms(meant: AxisCompensation, where: Axis, own: Sequence[ControlFile] = (), format_id: str = "fanuc-30i", **options: object) -> list[ControlFile]:  # fmt: skip
    control = open_control(
        Session(),
        format_id,
        {"detection_unit": 0.001, **({} if own else {"first_point": 0}), **options},
    )
    state = decode(control, own, [where]).state if own else None
    return list(control_format(control.definition, control.options, state).sheets([meant], [where]))


@pytest.mark.parametrize("format_id", FANUC)
@pytest.mark.parametrize("case", ["one set", "two sets", "endless"])
def test_the_typed_sheet_says_the_same_as_the_tables(case: str, format_id: str) -> None:
    own: list[ControlFile] = []
    where, meant = axis(), table(list(range(-4, 5)), list(TOTALS.values()), backlash=4 * UM)
    if case == "two sets":
        own = two_sets_backup()
        meant = table(list(range(-4, 5)), list(TOTALS.values()), [-1, -1, -2, -3, -5, -1, 0, 1, 2])
    elif case == "endless":
        where, meant = axis(**ENDLESS), turn([0, 1, -1, 0, 3, 2, 1, -1, 0])
    if format_id == "fanuc-0i-16i":
        own = [ControlFile(file.name, without_q(file.content.decode()).encode()) for file in own]
    (sheet,) = forms(meant, where, own, format_id, first_point=0)
    assert sheet.name == f"entry_{where.name}.csv"
    read = both([sheet], where, format_id=format_id)
    assert read.judge is not None
    probe = np.linspace(-250, 250, 401) + 0.01
    for side in Direction:
        expected = read.state.axes["1"].at(probe, side)
        np.testing.assert_allclose(read.judge.correction("1", probe, side), expected, atol=EXACT)
        np.testing.assert_allclose(expected, meant.at(probe, side), atol=EXACT)


@pytest.mark.parametrize("format_id", FANUC)
def test_the_program_enters_the_same(format_id: str) -> None:
    meant = table(list(range(-4, 5)), list(TOTALS.values()), backlash=4 * UM)
    _, program = forms(meant, axis(), format_id=format_id, program="g10")
    assert program.name == "G10_1.NC"
    text = program.content.decode().split()
    assert text[2] == ("G10L52" if format_id == "fanuc-30i" else "G10L50")
    assert text[-3:] == ["G11", "M30", "%"]
    judge = virtual_control(
        format_id,
        [program],
        kinds={"1": AxisKind.LINEAR},
        reference_return={"1": UP},
        options={"detection_unit": 0.001},
    )
    probe = np.linspace(-250, 250, 401) + 0.01
    for side in Direction:
        np.testing.assert_allclose(
            judge.correction("1", probe, side), meant.at(probe, side), atol=EXACT
        )


def test_the_program_switches_to_two_sets() -> None:
    meant = table([-1, 0, 1], [1, 0, 2], [0, -3, 1])
    _, program = forms(meant, axis(), two_sets_backup(), program="g10")
    judge = virtual_control(
        "fanuc-30i",
        [program],
        kinds={"1": AxisKind.LINEAR},
        reference_return={"1": UP},
        options={"detection_unit": 0.001},
    )
    for side in Direction:
        np.testing.assert_allclose(
            judge.correction("1", meant.positions, side), meant.curve(side), atol=EXACT
        )
    own = [
        ControlFile(file.name, without_q(file.content.decode()).encode())
        for file in two_sets_backup()
    ]
    _, old = forms(meant, axis(), own, "fanuc-0i-16i", program="g10")
    assert b"(SET BIT 0 OF 3605 FOR AXIS 1 TO 1 BY HAND)" in old.content


def test_no_program_for_an_inch_machine() -> None:
    own = files(P__TXT=PARAMETERS.replace("L1P00000000", "L1P00000001"), Q__TXT=PITCH)
    with pytest.raises(UsageError, match="inch"):
        forms(table([0, 1], [0, 1], spacing=25.4), axis(), own, program="g10")


def test_an_inch_machine_keeps_the_letter_of_its_interval() -> None:
    """I is inch, P the machine's own unit, which is inch here: 38.1 mm are 1.5 inch."""
    inch = PARAMETERS.replace("L1P00000000", "L1P00000001").replace(
        "M50.0A2M0.0A3M0.0", "I2.0A2I0.0A3P4.0"
    )
    for text in (inch, inch.replace("I2.0", "P2.0")):
        own = files(P__TXT=text, Q__TXT=PITCH)
        new = write(table([-1, 0, 1], [1, 0, 2], spacing=38.1), own=own)
        assert (
            b"N03624Q1A1I1.5A2I0.0A3P4.0\n"
            if b"A1I" in own[0].content
            else b"N03624Q1A1P1.5A2I0.0A3P4.0\n"
        ) in new[0].content
        np.testing.assert_allclose(
            both(new, axis()).state.axes["1"].positions, [-38.1, 0, 38.1], atol=EXACT
        )


# Mistakes that a definition or a hand could make
# ---------------------------------------------------------------------------

MUTATIONS = {
    "reference and first number exchanged": [
        ("N#03620Q1", "N#09999Q1"),
        ("N#03621Q1", "N#03620Q1"),
        ("N#09999Q1", "N#03621Q1"),
    ],
    "first and last number exchanged": [
        ("N#03622Q1", "N#09999Q1"),
        ("N#03621Q1", "N#03622Q1"),
        ("N#09999Q1", "N#03621Q1"),
    ],
    "backlash in rapid": [
        ("N#01851Q1", "N#09999Q1"),
        ("N#01852Q1", "N#01851Q1"),
        ("N#09999Q1", "N#01852Q1"),
    ],
    "interval in µm": [("unit: {linear: mm, rotary: deg}", "unit: {linear: um, rotary: mdeg}")],
    "points marked as parameters": [('form: "N{number}Q0P{value}"', 'form: "N{number}Q2P{value}"')],
    "magnification under another number": [("N#03623Q1", "N#03628Q1")],
}
BASE = "fanuc.base.yaml"
WANTED = table(list(range(-4, 5)), list(TOTALS.values()), backlash=4 * UM)


def judged_with(base: bytes) -> float:
    """The largest difference, mm, between what was meant and what the judge makes of the files of
    the definition of the 30i, with this text of what the series have in common.
    """
    found = found_in({**CONTENT, BASE: base})
    definition = load_definition(CONTENT["fanuc-30i.yaml"], "fanuc-30i.yaml", found)
    options = resolve_options(definition, {"detection_unit": 0.001, "first_point": 0})
    new = control_format(definition, options).write([WANTED], [axis()])
    judge = virtual_control(
        "fanuc-30i",
        new,
        kinds={"1": AxisKind.LINEAR},
        reference_return={"1": UP},
        options={"detection_unit": 0.001},
    )
    probe = np.linspace(-250, 250, 401) + 0.01
    return max(
        float(np.max(np.abs(judge.correction("1", probe, side) - WANTED.at(probe, side))))
        for side in Direction
    )


def test_the_definition_as_it_is() -> None:
    assert judged_with(CONTENT[BASE]) <= EXACT


@pytest.mark.parametrize("name", MUTATIONS)
def test_a_mistake_in_the_definition_is_seen(name: str) -> None:
    text = CONTENT[BASE].decode()
    for old, new in MUTATIONS[name]:
        assert old in text
        text = text.replace(old, new)
    try:
        difference = judged_with(text.encode())
    except (CompwrightError, AssertionError):
        return  # refused by the writer or by the judge
    assert difference > 0.5 * UM


@pytest.mark.parametrize(
    ("what", "old", "new"),
    [
        ("reference number", "N03620Q1A1P40", "N03620Q1A1P41"),
        ("magnification", "N03623Q1A1P1", "N03623Q1A1P2"),
        ("sign of 1851", "N01851Q1A1P4", "N01851Q1A1P-4"),
        ("one increment", "N10041Q0P2", "N10041Q0P-2"),
        ("interval", "A1M50.0", "A1M25.0"),
    ],
)
def test_a_mistake_in_the_files_is_another_correction(what: str, old: str, new: str) -> None:
    right = both(files(P__TXT=PARAMETERS, Q__TXT=PITCH), axis()).state.axes["1"]
    wrong = both(
        files(P__TXT=PARAMETERS.replace(old, new), Q__TXT=PITCH.replace(old, new)), axis()
    ).state.axes["1"]
    assert (
        max(
            float(np.max(np.abs(right.at(right.positions, side) - wrong.at(right.positions, side))))
            for side in Direction
        )
        > UM / 2
    )


# Random plans
# --------------------------------------------------------------------------------------------------

#: Of each control; benchmarks/bench_plans.py does thousands.
PLANS = 15


@pytest.mark.parametrize("format_id", ADDRESSES)
def test_random_plans_are_held_to_the_last_quantum(format_id: str) -> None:
    written = 0
    for seed in range(PLANS):
        plan = random_plan(format_id, seed)
        if plan.table is None:
            assert plan.refused
            continue
        written += 1
        assert worst_difference(plan) <= tolerance(format_id), seed
    assert written > 0.8 * PLANS
