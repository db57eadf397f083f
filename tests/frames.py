"""An empty frame in the place of the figure of a circle, which takes a tenth of a second."""

from __future__ import annotations

import pytest

from compwright.reporting import circle_figures, circles

FRAME = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"></svg>'


def _frame(*_: object, **__: object) -> bytes:
    return FRAME


def unpaint(patch: pytest.MonkeyPatch) -> None:
    """Let the figures of circles that stand in pages be empty frames."""
    patch.setattr(circles, "polar_figure", _frame)


def paint(patch: pytest.MonkeyPatch) -> None:
    """Let them be painted."""
    patch.setattr(circles, "polar_figure", circle_figures.polar_figure)
