"""The decision about a squareness after loading, and the name of its fault."""

from __future__ import annotations

import pytest

from compwright.verification.squareness import SquarenessCheck


@pytest.mark.parametrize(
    ("value", "decision"),
    [(40.0, "accept"), (42.5, "accept"), (37.5, "accept"), (42.6, "reject"), (37.4, "reject")],
)
def test_squareness_is_kept_within_its_uncertainty(value: float, decision: str) -> None:
    check = SquarenessCheck(value=value, expected=40.0, U=2.5, before=0.0)
    assert check.decision == decision


@pytest.mark.parametrize(
    ("value", "U", "decision"),
    [
        (None, 1.0, "undecided"),  # the test after loading does not determine it
        (1.0, 29.0, "accept"),
        (1.0, 31.0, "undecided"),  # would not show that the correction is missing
        (90.0, 31.0, "reject"),
    ],
)
def test_a_test_that_cannot_miss_a_correction_proves_nothing(
    value: float | None, U: float, decision: str
) -> None:
    check = SquarenessCheck(value=value, expected=0.0, U=U, before=60.0)
    assert check.decision == decision


@pytest.mark.parametrize(
    ("check", "found"),
    [
        # A correction that is not active lies within U by chance, if U is more than half of it.
        (SquarenessCheck(value=12.0, expected=0.0, U=13.0, before=20.0), ("undecided", False)),
        # What is accepted has no other name, however wide U is.
        (SquarenessCheck(value=1.0, expected=0.0, U=12.0, before=40.0), ("loaded", True)),
        # On top of a table that was loaded with a wrong factor there is no second one.
        (SquarenessCheck(value=40.0, expected=0.0, U=2.0, before=100.0), ("undecided", False)),
        (SquarenessCheck(value=30.0, expected=20.0, U=2.0, before=100.0), ("loaded", True)),
    ],
)
def test_only_a_correction_that_is_active_as_planned_counts_as_active(
    check: SquarenessCheck, found: tuple[str, bool]
) -> None:
    assert (check.verdict, check.active) == found


@pytest.mark.parametrize(
    ("as_planned", "step"),
    [
        (None, "Compare what is loaded with the plan."),
        (True, "check that all tables are switched on, and measure the circle again."),
        (False, "The table that was read back differs from the plan (CW-V011)."),
    ],
)
def test_what_was_read_back_as_planned_is_not_to_be_compared_again(
    as_planned: bool | None, step: str
) -> None:
    check = SquarenessCheck(
        value=20.0, expected=0.0, U=1.0, before=40.0, fault=None, as_planned=as_planned
    )
    (found,) = check.findings
    assert found.message.endswith(step)
