"""Evaluation of a circular test with the causes of its deviations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.estimation.circle import diagnose
from compwright.evaluation.circular import evaluate_circle
from compwright.foundations.errors import Fault, InputError
from compwright.records.circular import CircularResult, CircularTest, Diagnosis

_NOT_SEPARABLE = (
    "the samples cannot separate the causes of deviation: they have no noise, or the arc is too"
    " short"
)


def diagnose_circle(test: CircularTest, standard: str) -> CircularResult:
    """Return the test evaluated to ``standard``, with the causes of its deviations.

    Where the causes cannot be determined, without them and with the reason. Raises InputError for a
    test that cannot be evaluated.
    """
    result = evaluate_circle(test, standard)
    try:
        return replace(result, diagnosis=_diagnosed(result.test))
    except InputError as error:
        reason = "; ".join(str(replace(fault, file="", hint="")) for fault in error.faults)
        return replace(result, not_applicable={**result.not_applicable, "diagnosis": reason})


def _diagnosed(test: CircularTest) -> Diagnosis:
    """Return the causes of a circular test. Raises InputError where they cannot be found, as for
    noise-free computed samples.
    """
    with np.errstate(invalid="ignore"):  # a variance below zero is found by its root
        try:
            diagnosis = diagnose(test)
        except np.linalg.LinAlgError as error:
            raise InputError(
                Fault(message=_NOT_SEPARABLE, hint="measure a full circle in both directions")
            ) from error
    if not all(np.isfinite(effect.std_error) for effect in diagnosis.effects.values()):
        raise InputError(
            Fault(message=_NOT_SEPARABLE, hint="measure a full circle in both directions")
        )
    return diagnosis
