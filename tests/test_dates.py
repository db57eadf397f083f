"""Dates of instruments: read where they mean one day only."""

from __future__ import annotations

import pytest

from compwright.foundations.dates import day_of


@pytest.mark.parametrize(
    ("text", "day"),
    [
        ("2026-03-14", "2026-03-14"),
        ("2026-03-14T07:05:09Z", "2026-03-14 07:05:09"),
        ("2026/3/4 7:05", "2026-03-04 07:05:00"),
        ("20251206-071745", "2025-12-06 07:17:45"),  # a ballbar's
        ("14.03.2026", "2026-03-14"),
        ("4. 3. 2026, 16:20", "2026-03-04 16:20:00"),
        ("14 Mar 2026", "2026-03-14"),
        ("March 14, 2026 10:00", "2026-03-14 10:00:00"),
        ("03/14/2026", "2026-03-14"),
        ("14/03/2026", "2026-03-14"),
        ("04/04/2026", "2026-04-04"),
        ("03/04/2026", ""),  # March or April
        ("2026-02-30", ""),
        ("last spring", ""),
        ("14 Foo 2026", ""),
        ("", ""),
    ],
)
def test_a_day_is_read_only_one_way(text: str, day: str) -> None:
    assert day_of(text) == day
