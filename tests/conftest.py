"""For all tests: figures inside pages are built but not painted, unless a test module says `pytest.mark.painted`.

Painting is the plotting library's work and two thirds of the time of a run. What is painted is looked at in the tests of the
reporting room, of the examples and of the plots that `evaluate` writes.
"""

from __future__ import annotations

from typing import Any

import pytest

from compwright.reporting import panels, plots, polar

_FRAME = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"></svg>'


@pytest.fixture(autouse=True)
def unpainted(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the figures that stand in pages be empty frames."""
    if request.node.get_closest_marker("painted"):
        return

    def frame(figure: Any, kind: panels.PlotFormat) -> bytes:
        return _FRAME if kind == "svg" else panels.render(figure, kind)

    monkeypatch.setattr(plots, "render", frame)
    monkeypatch.setattr(polar, "render", frame)
