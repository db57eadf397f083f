"""Empty frames in the place of figures: painting is two thirds of the time of a run."""

from __future__ import annotations

import pytest

from compwright.reporting import axis_report, circles, verify_report

FRAME = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"></svg>'


def _frame(*_: object, **__: object) -> bytes:
    return FRAME


def unpaint(patch: pytest.MonkeyPatch) -> None:
    """Let the figures that stand in pages be empty frames."""
    for plot in ("positioning_plot", "before_after_plot"):
        for page in (axis_report, verify_report):
            patch.setattr(page, plot, _frame)
    for plot in ("table_plot", "estimate_plot"):
        patch.setattr(axis_report, plot, _frame)
    patch.setattr(circles, "polar_figure", _frame)
