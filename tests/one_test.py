"""Measurement files that hold one test."""

from __future__ import annotations

from compwright.instruments.profile import Profile
from compwright.instruments.reading import read_tests
from compwright.records.positioning import PositioningTest


def read_positioning(content: bytes, file: str, profile: Profile | None = None) -> PositioningTest:
    """Return the only test in ``content``; arguments and errors as `read_tests`."""
    (test,) = read_tests(content, file, profile)
    return test
