"""The line that ends a run of the tests says what was skipped and why."""

from __future__ import annotations

from skips import skipped_line


def test_every_reason_is_named_once_with_its_count() -> None:
    reasons = ["Skipped: no backup", "no LinuxCNC", "no backup", "Skipped: no backup"]
    assert skipped_line(reasons) == "skipped: 3 (no backup); 1 (no LinuxCNC)"
    assert skipped_line([]) == ""
