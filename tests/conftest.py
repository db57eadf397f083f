"""For all tests: pages hold empty frames for figures of circles unless a module says
`pytest.mark.painted`; modules about the control's files say `pytest.mark.brief`; random cases have
fixed seeds.

Circles are looked at in the tests of the reporting room, of the examples and of the plots that
`evaluate` writes. Most of the time of a run is sampling. Where a measured axis or circle is only the
way to a control's files, the same stages run with fewer sweeps and fewer fresh tests; what the
estimate and the prediction say is tested where nothing is brief. There, and in modules that say
`pytest.mark.remembered`, the same readings are estimated once, but in tests that ask for it afresh.
Fixed seeds: a test fails every time or never; new cases are tried in ``benchmarks/``.

No power fails while tests run: nothing waits until it is on the disk. Processes that tests start
share what one of them has compiled, also where nothing is to be written beside the modules.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from inspect import unwrap

import pytest
from hypothesis import settings

from compwright.estimation import axis, circle, likelihood, model, noise, peaks, step_evidence
from compwright.foundations.processors import look_for_garbage_seldom
from compwright.planning import circles, diagnosed, fresh, misread, wanted, worth
from compwright.verification import likelihood as after_tests
from frames import unpaint
from remembered import remembered
from skips import skipped_line

#: Where estimates are asked for, and the function that remembers them: brief ones, others.
_BRIEF, _WHOLE = (
    (
        (wanted, "noise_of", noise_of),
        (after_tests, "noise_of", noise_of),
        (wanted, "estimate_axis", remembered(axis.estimate_axis)),
        (misread, "log_likelihood", remembered(likelihood.log_likelihood)),
        (diagnosed, "diagnose", remembered(circle.diagnose)),
    )
    for noise_of in (remembered(noise.noise_of), remembered(noise.noise_of))
)
_starts = model._starts

look_for_garbage_seldom()  # as every command does
settings.register_profile("suite", derandomize=True, deadline=None)
settings.load_profile("suite")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say in one line what was skipped and why."""
    reports = terminalreporter.stats.get("skipped", [])
    line = skipped_line(str(report.longrepr[2]) for report in reports)
    if line:
        terminalreporter.write_line(line)


@pytest.fixture(autouse=True, scope="session")
def powered() -> Iterator[None]:
    """Let nothing wait for the disk."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "fsync", lambda _handle: None)
        yield


@pytest.fixture(autouse=True, scope="session")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Let processes find modules compiled, as those of an installed package are."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
        folder = tmp_path_factory.getbasetemp().parent / "compiled"
        patch.setenv("PYTHONPYCACHEPREFIX", str(folder))
        yield


@pytest.fixture(autouse=True, scope="module")
def unpainted(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let the figures of circles that stand in pages be empty frames."""
    with pytest.MonkeyPatch.context() as patch:
        if not request.node.get_closest_marker("painted"):
            unpaint(patch)
        yield


@pytest.fixture(autouse=True, scope="module")
def sampled(request: pytest.FixtureRequest) -> Iterator[None]:
    """Sample less where the estimate is only the way to something else."""
    brief = request.node.get_closest_marker("brief")
    with pytest.MonkeyPatch.context() as patch:
        if brief:
            patch.setattr(noise, "_SETTLING", 8)
            for module in (noise, axis):
                patch.setattr(module, "_DRAWS", 12)
            for name in ("_DRAWS", "_FEWEST_DRAWS"):
                patch.setattr(fresh, name, 240)
            patch.setattr(fresh, "_SETS", 6)
            patch.setattr(circles, "DRAWS", 20)
            patch.setattr(worth, "_SIZES", 2)
            patch.setattr(likelihood, "_DRAWS", 4)
            # One climb to the posterior's peak, and a coarser search for jumps.
            patch.setattr(peaks, "_ITERATIONS", 8)
            patch.setattr(model, "_starts", lambda cells, prior: _starts(cells, prior)[:1])
            patch.setattr(step_evidence, "_LENGTHS", step_evidence._LENGTHS[::3])
            for name in ("_SIZES", "_LOCAL"):
                patch.setattr(step_evidence, name, 3)
        if brief or request.node.get_closest_marker("remembered"):
            for room, name, function in _BRIEF if brief else _WHOLE:
                patch.setattr(room, name, function)
        yield


@pytest.fixture
def afresh() -> Iterator[None]:
    """Let estimates be worked out although the same readings were estimated before."""
    with pytest.MonkeyPatch.context() as patch:
        for room, name, function in _WHOLE:
            patch.setattr(room, name, unwrap(function))
        yield
