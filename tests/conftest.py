"""For all tests: pages hold empty frames for figures of circles unless a module or a test says
`pytest.mark.real_pages`; those about the control's files say `pytest.mark.short_estimate`; random
cases have fixed seeds.

Circles are looked at in the tests of the reporting room, of the examples and of the plots that
`evaluate` writes. Where a measured axis or circle is only the way to a control's files, the same
stages run with fewer sweeps and fewer fresh tests, no period and no other sign of the readings is
looked for, the report is an empty frame, and no file is tried alone for the card (frames.py); what
the estimate and the prediction say is tested where nothing is brief. Commands estimate the same readings and fit the same table once, but in tests that
ask for it afresh. Fixed seeds: a test fails every time or never; new cases are tried in
``benchmarks/``.

No power fails while tests run: nothing waits until it is on the disk. Processes that tests start
share what one of them has compiled, also where nothing is to be written beside the modules.
"""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from dataclasses import replace
from functools import wraps
from inspect import unwrap
from typing import Any, Final

import pytest
from hypothesis import settings

from cached_results import cached
from compwright.estimation import (
    axis,
    circle,
    circle_directions,
    circle_reversal,
    hidden_periods,
    likelihood,
    model,
    noise,
    period_models,
    posterior_peaks,
    step_evidence,
)
from compwright.evaluation.circular import evaluate_circle
from compwright.fitting import fit
from compwright.foundations.processors import look_for_garbage_seldom
from compwright.planning import (
    circle_diagnosis,
    circles,
    point_count_tradeoff,
    reading_interpretations,
    sign_and_unit_doubts,
    simulated_repeat_tests,
    tables,
    wanted_correction,
)
from compwright.records.circular import CircularResult, CircularTest
from compwright.verification import likelihood as after_tests
from frames import frame
from skips import skipped_line


def _first_start(cells: Any, prior: Any, starts: Any = model._starts) -> Any:
    return starts(cells, prior)[:1]


def _no_search(*_: object, **__: object) -> period_models.PeriodSearch:
    return period_models.NO_SEARCH


def _none_hidden(*_: object) -> hidden_periods.HiddenPeriods:
    return hidden_periods.HiddenPeriods(())


def _no_doubts(*_: object) -> tuple[()]:
    return ()


#: Room, name, and what it is where a test is brief; elsewhere it is as it stands.
_SAMPLING: Final = (
    (noise, "_SETTLING", 4),
    (noise, "_DRAWS", 8),
    (axis, "_DRAWS", 8),
    (circle_reversal, "_FORGOTTEN", 2),
    (circle_reversal, "_SWEEPS", 10),
    (simulated_repeat_tests, "_DRAWS", 160),
    (simulated_repeat_tests, "_FEWEST_DRAWS", 160),
    (simulated_repeat_tests, "_SETS", 2),
    (circles, "DRAWS", 5),
    (point_count_tradeoff, "_SIZES", 0),
    # No periods are looked for, none may be hidden, and every test is read as it is stated.
    (axis, "search_periods", _no_search),
    (axis, "hidden_periods", _none_hidden),
    (sign_and_unit_doubts, "misreading_doubts", _no_doubts),
    # One climb to the posterior's peak, and a coarser search for jumps.
    (posterior_peaks, "_ITERATIONS", 8),
    (model, "_starts", _first_start),
    (step_evidence, "_LENGTHS", step_evidence._LENGTHS[::3]),
    (step_evidence, "_SIZES", 3),
    (step_evidence, "_LOCAL", 3),
)
_WHOLE: Final = tuple(getattr(room, name) for room, name, _ in _SAMPLING)
_evaluated_circle = cached(evaluate_circle)


@wraps(evaluate_circle)
def _evaluate_circle_once(test: CircularTest, standard: str) -> CircularResult:
    return replace(_evaluated_circle(test, standard), test=test)  # from whichever file


_EXCHANGE_ODDS: Final = cached(circle_directions.exchange_odds)
#: Where estimates are asked for, and the function that caches them: brief ones, others.
_BRIEF_ESTIMATES, _WHOLE_ESTIMATES = (
    (
        (wanted_correction, "infer_noise", infer_noise),
        (after_tests, "infer_noise", infer_noise),
        (wanted_correction, "estimate_axis", cached(axis.estimate_axis)),
        (sign_and_unit_doubts, "log_likelihood", cached(likelihood.log_likelihood)),
        (reading_interpretations, "smooth_part", cached(likelihood.smooth_part)),
        (circle_diagnosis, "evaluate_circle", _evaluate_circle_once),
        (circle_diagnosis, "diagnose", cached(circle.diagnose)),
        (circle_directions, "exchange_odds", _EXCHANGE_ODDS),
        (tables, "fit_table", cached(fit.fit_table)),
    )
    for infer_noise in (cached(noise.infer_noise), cached(noise.infer_noise))
)

look_for_garbage_seldom()  # as every command does
settings.register_profile("suite", derandomize=True, deadline=None)
settings.load_profile("suite")


def pytest_collection_finish() -> None:
    """Let no search for garbage go through the thousands of tests, which stay until the end."""
    gc.collect()
    gc.freeze()


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
def of_module(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let tests of a module sample and make pages as its marks say."""
    with pytest.MonkeyPatch.context() as patch:
        _shorten(patch, request.node, brief=_has(request.node, "short_estimate"))
        yield


@pytest.fixture(autouse=True)
def of_test(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let one test sample and make pages as its own marks say: a fixture of the module does not see
    them.
    """
    test = request.node
    marks = {mark.name for mark in test.own_markers}
    with pytest.MonkeyPatch.context() as patch:
        if marks & {"short_estimate", "full_estimate", "real_pages"}:
            brief = _has(test, "short_estimate") and "full_estimate" not in marks
            _shorten(patch, test, brief=brief)
        yield


def _has(node: pytest.Item | pytest.Collector, mark: str) -> bool:
    return node.get_closest_marker(mark) is not None


def _shorten(
    patch: pytest.MonkeyPatch, node: pytest.Item | pytest.Collector, *, brief: bool
) -> None:
    """Estimate the same readings once; where ``brief``, sample less and make fewer pages."""
    frame(patch, real=_has(node, "real_pages"), brief=brief)
    for (room, name, less), whole in zip(_SAMPLING, _WHOLE, strict=True):
        patch.setattr(room, name, less if brief else whole)
    for room, name, function in _BRIEF_ESTIMATES if brief else _WHOLE_ESTIMATES:
        patch.setattr(room, name, function)


@pytest.fixture
def afresh() -> Iterator[None]:
    """Let estimates be worked out although the same readings were estimated before."""
    with pytest.MonkeyPatch.context() as patch:
        for room, name, function in _WHOLE_ESTIMATES:
            patch.setattr(room, name, unwrap(function))
        yield
