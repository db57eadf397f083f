"""Circular tests for ``evaluate``: read, paired, evaluated and diagnosed.

Apart from ``workflow.evaluate``, which loads it only when a file is no positioning test: the way of
a positioning test stays short.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from compwright.estimation.circle import diagnose
from compwright.evaluation.circular import evaluate_circle
from compwright.foundations.errors import Fault, InputError
from compwright.instruments.circular_pairs import paired
from compwright.instruments.circular_reading import is_circular, read_circular
from compwright.records.circular import CircularResult, CircularTest, Diagnosis
from compwright.records.positioning import PositioningTest

_NOT_SEPARABLE = (
    "the samples do not tell the causes apart: no noise to judge them by, or too short an arc"
)


def read_if_circular(content: bytes, file: str) -> CircularTest | None:
    """Return the circular test in ``content``; None when it is none. Raises InputError for a
    circular test that is damaged.
    """
    return read_circular(content, file) if is_circular(content, file) else None


def pairs_joined(
    tests: Sequence[PositioningTest | CircularTest],
) -> list[PositioningTest | CircularTest]:
    """Return the tests with the two files of a circular test joined (`circular_pairs.paired`), in
    the place of the first file.
    """
    joined = paired([test for test in tests if isinstance(test, CircularTest)])
    by_source = {source: test for test in joined for source in test.sources}
    kept: dict[int, PositioningTest | CircularTest] = {}
    for test in tests:
        whole = by_source[test.sources[0]] if isinstance(test, CircularTest) else test
        kept.setdefault(id(whole), whole)
    return list(kept.values())


def evaluated_circle(test: CircularTest, standard: str) -> CircularResult:
    """Return the test evaluated to ``standard`` with its causes; without them, and with the reason,
    where they cannot be told.

    Raises InputError for a test that cannot be evaluated.
    """
    result = evaluate_circle(test, standard)
    try:
        return replace(result, diagnosis=_diagnosed(result.test))
    except InputError as error:
        reason = "; ".join(str(replace(fault, file="")) for fault in error.faults)
        return replace(result, not_applicable={**result.not_applicable, "diagnosis": reason})


def _diagnosed(test: CircularTest) -> Diagnosis:
    """Return the causes. Raises InputError where they cannot be told, as for computed samples:
    without noise nothing is judged.
    """
    with np.errstate(invalid="ignore"):  # a variance below zero is found by its root
        try:
            diagnosis = diagnose(test)
        except np.linalg.LinAlgError as error:
            raise InputError(Fault(message=_NOT_SEPARABLE)) from error
    if not all(np.isfinite(effect.std_error) for effect in diagnosis.effects.values()):
        raise InputError(Fault(message=_NOT_SEPARABLE))
    return diagnosis
