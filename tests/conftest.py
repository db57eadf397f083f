"""For all tests: pages hold empty frames for figures unless a module says `pytest.mark.painted`;
random cases have fixed seeds.

Painting is two thirds of the time of a run. Figures are looked at in the tests of the reporting
room, of the examples and of the plots that `evaluate` writes. Fixed seeds: a test fails every time
or never; new cases are tried in ``benchmarks/``.
"""

from __future__ import annotations

import pytest
from hypothesis import settings

from frames import unpaint

settings.register_profile("suite", derandomize=True, deadline=None)
settings.load_profile("suite")


@pytest.fixture(autouse=True)
def unpainted(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the figures that stand in pages be empty frames."""
    if request.node.get_closest_marker("painted"):
        return
    unpaint(monkeypatch)
