"""Evaluation of a circular test with the causes of its deviations."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.circle import diagnose
from compwright.estimation.circle_directions import exchange_findings
from compwright.estimation.circle_findings import negative_findings
from compwright.estimation.circle_model import circle_samples
from compwright.evaluation.circular import evaluate_circle
from compwright.evaluation.circular_checks import OPEN_LEAST, open_ends
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.circular import CircularResult, CircularTest, Diagnosis

#: A drift of the radius is clear from so many standard errors.
_CLEAR: Final = 4.0


def diagnose_circle(test: CircularTest, standard: str) -> CircularResult:
    """Return the test evaluated to ``standard``, with the causes of its deviations.

    If the causes cannot be determined, the result has the reason instead. Raises InputError for a
    test that cannot be evaluated.
    """
    result = evaluate_circle(test, standard)
    try:
        diagnosis = _diagnosed(result.test)
        doubts = (
            *exchange_findings(circle_samples(result.test)),
            *negative_findings(diagnosis),
            *_drift_findings(result, diagnosis),
        )
        return replace(result, diagnosis=diagnosis, findings=(*result.findings, *doubts))
    except InputError as error:
        reason = "; ".join(str(replace(fault, file="", hint="")) for fault in error.faults)
        return replace(result, not_applicable={**result.not_applicable, "diagnosis": reason})


def _diagnosed(test: CircularTest) -> Diagnosis:
    """Return the causes of the deviations of a circular test. Raises InputError if the causes
    cannot be found, as for noise-free computed samples.
    """
    # a variance below zero is found by its root
    with np.errstate(invalid="ignore"), suppress(np.linalg.LinAlgError):
        diagnosis = diagnose(test)
        if all(np.isfinite(effect.std_error) for effect in diagnosis.effects.values()):
            return diagnosis
    raise InputError(
        Fault(
            message="the samples cannot separate the causes of deviation: the arc is too short, "
            "or the samples were smoothed or calculated, so that they have no noise",
            hint="measure a full circle in both directions, and export the samples without "
            "smoothing",
        )
    )


def _drift_findings(result: CircularResult, diagnosis: Diagnosis) -> Iterator[Finding]:
    """Yield the finding CW-C012 for each run of a full circle whose radius clearly drifts, if the
    ``result`` does not have it. Where a run begins at a reversal point, its ends differ by the lost
    motion too, and only the fit of all causes distinguishes them.
    """
    known = any(finding.code == "CW-C012" for finding in result.findings)
    if known or not result.test.full_circle:
        return
    drift = diagnosis.effects["spiral"]
    step = abs(drift.value) / MICROMETRES_PER_MILLIMETRE
    if step > OPEN_LEAST and abs(drift.value) > _CLEAR * drift.std_error:
        yield from (open_ends(run, step) for run in result.test.runs)
