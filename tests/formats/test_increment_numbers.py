"""Point numbers of whole steps by section: two sets of one axis, and sets that meet those of
another.

By hand from the manual's rules: the set for travel in + is 3621 .. 3622, that for travel in - has
the same count and begins at 3626. The setting of the control's own report A-77810E: reference 23,
numbers 20 .. 27, second set from 30 (so 30 .. 37), interval 10.000 mm, 3627 = -4.
"""

from __future__ import annotations

import pytest

from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import decode, open_control
from compwright.controls.decoded_state import DecodedState
from compwright.formats.families.increments.increment_facts import IncrementFacts, increments_of
from compwright.formats.families.increments.numbering import (
    NoRoom,
    NumberPlace,
    find_place,
    used_numbers,
)
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.facts import AxisFacts

SAMPLE = IncrementFacts(
    reference_number=23, first_number=20, last_number=27, negative_first=30, two_sets=True
)
#: The highest point number of the 30i series.
HIGHEST = 1535


def backup(second: int = 30, other: tuple[int, int, int] = (0, 0, 0)) -> list[ControlFile]:
    """The sample setting on axis 1; ``other``: 3620, 3621 and 3622 of axis 2, which has one set.

    Point n holds n % 7 - 3.
    """
    reference, first, last = other
    lines = [
        "N01001Q1L1P00000000",
        "N01851Q1A1P0A2P0",
        "N03605Q1A1P00000001A2P00000000",
        f"N03620Q1A1P23A2P{reference}",
        f"N03621Q1A1P20A2P{first}",
        f"N03622Q1A1P27A2P{last}",
        "N03623Q1A1P1A2P1",
        "N03624Q1A1M10.0A2M10.0",
        f"N03626Q1A1P{second}A2P0",
        "N03627Q1A1P-4A2P0",
    ]
    points = [f"N{10_000 + number}Q0P{number % 7 - 3}" for number in range(HIGHEST + 1)]
    return [
        ControlFile(name, "\n".join(["%", *text, "%", ""]).encode())
        for name, text in (("P.TXT", lines), ("Q.TXT", points))
    ]


def axis(address: str, name: str) -> Axis:
    return Axis(name=name, address=address, kind=AxisKind.LINEAR, travel=(-40.0, 40.0))


def read(own: list[ControlFile], *axes: Axis) -> DecodedState:
    """Read by both readers, which have to agree."""
    control = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001})
    return decode(control, own, axes or (axis("1", "X"),))


def test_the_sample_setting_of_the_control_s_own_report() -> None:
    state = read(backup()).state
    assert increments_of(state.facts_of("1")).claimed == (range(20, 28), range(30, 38))
    table = state.axes["1"]
    # sections 20 .. 23 below the reference, 24 .. 27 above it: nodes from -40 to 40
    assert table.positions.tolist() == [10.0 * step for step in range(-4, 5)]
    at_home = table.positions == 0
    assert table.curve(Direction.POSITIVE)[at_home] == pytest.approx(0.0)
    assert table.curve(Direction.NEGATIVE)[at_home] == pytest.approx(-0.004)  # 3627
    # number 34 is that of the set for travel in - with which 24 goes: 34 % 7 - 3 = 3
    beside = table.curve(Direction.NEGATIVE)[table.positions == 10.0]
    assert beside == pytest.approx(-0.004 + 0.003)


def test_the_numbers_that_an_axis_has_are_none_of_those_that_all_share() -> None:
    """A set of eight numbers has nine nodes; of all other numbers each seventh alone holds nothing
    (17, 24, 31 ..).
    """
    form = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001}).format
    capacity = form.in_state(read(backup()).state).capacity(axis("1", "X"))
    assert (capacity.own_points, capacity.shared_points) == (9, 1)


@pytest.mark.parametrize(
    "second",
    [
        28,  # begins behind the last of the set for travel in +
        12,  # 12 .. 19: ends before its first
        0,  # 0 .. 7: the lowest numbers of the control
        HIGHEST - 7,  # its highest
    ],
)
def test_a_second_set_clear_of_the_first_is_read(second: int) -> None:
    claimed = increments_of(read(backup(second)).state.facts_of("1")).claimed
    assert claimed == (range(20, 28), range(second, second + 8))


@pytest.mark.parametrize(
    ("second", "why"),
    [
        (27, "the two sets overlap"),  # begins where the first ends
        (13, "the two sets overlap"),  # 13 .. 20 ends where the first begins
        (20, "the two sets overlap"),
        (-1, "leaves the control's numbers"),
        (HIGHEST - 6, "leaves the control's numbers"),
    ],
)
def test_a_second_set_that_meets_the_first_or_leaves_the_numbers(second: int, why: str) -> None:
    with pytest.raises(InputError) as caught:
        read(backup(second))
    (fault,) = (each for each in caught.value.faults if why in each.message)
    assert (fault.file, fault.found) == ("P.TXT", f"{second} .. {second + 7}")
    assert "3626" in fault.message


@pytest.mark.parametrize(
    ("other", "shared"),
    [
        ((39, 37, 42), "37 to 37"),  # begins at the last of the second set
        ((39, 38, 42), ""),
        ((29, 28, 30), "30 to 30"),  # ends at the first of the second set
        ((29, 28, 29), ""),  # just fits between the two sets
        ((28, 27, 29), "27 to 27"),  # begins at the last of the first set
        ((19, 18, 20), "20 to 20"),  # ends at the first of the first set
        ((18, 17, 19), ""),
    ],
)
def test_numbers_shared_with_another_axis_are_told(
    other: tuple[int, int, int], shared: str
) -> None:
    """Both readers tell it, and agree on what the control does with numbers that serve two axes."""
    own, axes = backup(other=other), (axis("1", "X"), axis("2", "Y"))
    control = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001})
    findings = control.format.read(own, axes).findings
    told = [finding.message for finding in findings if finding.code == "CW-S014"]
    assert [shared in message for message in told] == ([True] if shared else [])
    read(own, *axes)
    judge = virtual_control("fanuc-30i", own, options={"detection_unit": 0.001})
    notes = [note for note in judge.notes if "uses the same points" in note]
    assert [f"points {shared[:2]}" in note for note in notes] == ([True] if shared else [])


@pytest.mark.parametrize(
    ("facts", "claimed"),
    [
        (IncrementFacts(), ()),
        (IncrementFacts(reference_number=5, first_number=5, last_number=5), ()),
        (IncrementFacts(first_number=6, last_number=5), ()),
        # a full turn that leaves the reference's own number out: 300 is kept for the axis too
        (
            IncrementFacts(reference_number=300, first_number=301, last_number=312),
            (range(300, 313),),
        ),
        # 3626 without the bit is a leftover
        (IncrementFacts(first_number=20, last_number=27, negative_first=30), (range(20, 28),)),
        # the bit without 3626 claims nothing more
        (IncrementFacts(first_number=20, last_number=27, two_sets=True), (range(20, 28),)),
    ],
)
def test_the_numbers_that_an_axis_claims(facts: IncrementFacts, claimed: tuple[range, ...]) -> None:
    assert facts.claimed == claimed


def test_numbers_in_use_are_all_but_one_s_own() -> None:
    """Data at 27, 28 and 38 belong to nobody by name: 27 is the axis' own, the others keep theirs."""
    other = IncrementFacts(reference_number=101, first_number=100, last_number=103)
    state = ControlState(
        format="fanuc-30i",
        axes={},
        facts={"1": AxisFacts(of_family=SAMPLE), "2": AxisFacts(of_family=other)},
        reserved=frozenset({27, 28, 37, 38}),
    )
    assert used_numbers(state, ["1"]) == [range(100, 104), range(28, 29), range(38, 39)]
    both = [range(20, 28), range(30, 38)]
    assert [one for one in used_numbers(state, ["2"]) if len(one) > 1] == both
    assert used_numbers(ControlState(format="fanuc-30i", axes={}), ["1"]) == []


def place(*used: range, highest: int = HIGHEST, reference: int | None = 23) -> NumberPlace:
    """Where the sample's table goes: nodes -4 .. 4, so eight numbers, twice."""
    return find_place(-4, 4, highest=highest, used=used, two=True, reference=reference, start=0)


def test_two_sets_keep_their_reference_up_to_their_last_number() -> None:
    """20 .. 27 and 28 .. 35; numbers 19 and 36 may belong to others, 20 and 35 may not."""
    kept = place(range(12, 20), range(36, 40))
    assert kept.ranges == (range(20, 28), range(28, 36))
    for taken in (range(12, 21), range(35, 40), range(27, 28), range(28, 29)):
        moved = place(taken)
        assert all(number not in taken for each in moved.ranges for number in each)
        assert moved.ranges != kept.ranges


def test_two_sets_need_room_for_both() -> None:
    """Sixteen numbers, 0 .. 15, hold eight twice; fifteen do not."""
    assert place(highest=15, reference=None).ranges == (range(8), range(8, 16))
    assert place(range(16, 99), highest=98, reference=None).first == 0
    with pytest.raises(NoRoom, match="16 point numbers"):
        place(highest=14, reference=None)
    with pytest.raises(NoRoom, match="15"):
        place(range(15, 99), highest=98, reference=None)


def test_a_reference_too_low_for_the_table_is_not_kept() -> None:
    """Reference 2 would put the first section at number -1."""
    assert place(reference=2).reference == 3
    assert place(reference=3).reference == 3


def test_a_number_that_a_neighbour_shares_is_not_cleared() -> None:
    """X goes back to one set of its own: 30 .. 36 become 0, 37 is Y's first and keeps its value."""
    own = backup(other=(39, 37, 42))
    control = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001})
    state = control.format.read(own, (axis("1", "X"), axis("2", "Y")))
    found = state.axes["1"]
    one = AxisCompensation(
        address="1",
        kind=AxisKind.LINEAR,
        positions=found.positions,
        positive=found.positive,
        negative=found.positive,
        interpolation="step",
    )
    written = control.format.in_state(state).write([one], [axis("1", "X")], own)
    lines = b"".join(file.content for file in written).decode().split()
    values = {line[1:6]: line.split("P")[1] for line in lines if "Q0P" in line}
    assert [values[f"{10_000 + number}"] for number in range(30, 37)] == ["0"] * 7
    assert values["10037"] == str(37 % 7 - 3)
