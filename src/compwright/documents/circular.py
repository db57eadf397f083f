"""The entry of a circular test in the JSON of ``evaluate``, with deviations in µm."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final

import numpy as np

from compwright.documents.evaluation import uncertainty_document
from compwright.documents.findings import finding_documents
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularEffect, CircularResult, CircularRun, Diagnosis
from compwright.records.correction_need import correction_need
from compwright.records.rounding import OUTSIDE
from compwright.words.sentences import SentenceText

#: Digits after the decimal point: takes away the noise of binary numbers and the last bits of the
#: fit, keeps every real digit.
_DIGITS: Final = OUTSIDE
#: Decimals of fitted deviations, µm, and of correlations: processors differ in a fit by up to 1e-9.
_FITTED: Final = 4
_SENSES: Final = ("ccw", "cw")
#: Values without an effect of their own, because they sum up causes.
_NOT_RANKED: Final = ("lobes_2", "lobes_3", "positional_tolerance")
#: Units of the causes that several circles show together; lags are in ms.
_UNITS: Final = {"squareness": "um/m", "scale_error": "um/m", "backlash": "um"}


def circular_document(result: CircularResult) -> dict[str, Any]:
    """Return one circular result as an entry of ``results``; null for undefined parameters.

    ``centre`` and ``mean_radius_deviation`` are null for a direction that was not measured.
    ``diagnosis``, ``plain``, ``correlation`` and ``fitted`` are null if no diagnosis was made.
    ``correlation``: rows of the correlation matrix, in the order of ``correlation_names``.

    Some further keys:

    - ``set_up``: centre of the circle in the machine, mm.
    - ``minimum_zone``: its centre, µm, and its radii minus the nominal radius, µm.
    - ``runs``: angles, deg, and deviations, µm, as measured and in the measured order.
    - ``fitted``: for each run, the deviations computed from the diagnosed causes, µm, at equally
      spaced samples. ``residuals``: measured minus computed deviation, µm.
    - ``residual``: root mean square of the residuals, µm. ``correlation_length``: their correlation
      length, samples.
    """
    test = result.test
    findings = (*result.findings, *(result.diagnosis.findings if result.diagnosis else ()))
    return {
        "kind": "circular",
        "name": test.name,
        "sources": [{"file": source.file, "sha256": source.sha256} for source in test.sources],
        "plane": test.plane,
        "axes": list(test.axes),
        "nominal_radius": float(test.nominal_radius),
        "feed": _number(test.feed),
        "set_up": (
            None if test.centre is None else [float(coordinate) for coordinate in test.centre]
        ),
        "standard": result.standard,
        "unit": "um",
        "arc": {"start": float(test.arc[0]), "extent": float(test.arc[1])},
        "calibrated": test.calibrated,
        "parameters": {name: _micrometres(value) for name, value in result.parameters.items()},
        "uncertainty": uncertainty_document(result.uncertainty, MICROMETRES_PER_MILLIMETRE),
        "centre": {name: _point(result.centres.get(name)) for name in (*_SENSES, "common")},
        "mean_radius_deviation": {
            name: _micrometres(result.mean_radius_deviation.get(name)) for name in _SENSES
        },
        "minimum_zone": _zones(result),
        **_diagnosis(result.diagnosis),
        "vendor": _plain(test.vendor),
        "not_applicable": {
            **result.not_applicable,
            **{
                name: SentenceText(reason)
                for name, reason in (result.diagnosis.not_given if result.diagnosis else {}).items()
            },
        },
        "header": dict(test.header),
        "runs": [_run(run) for run in test.runs],
        "findings": finding_documents(findings),
    }


def machine_document(
    stated: Mapping[str, str | None],
    circles: Sequence[str],
    values: Mapping[str, Mapping[str, tuple[float, float]]],
    contradictions: Sequence[tuple[str, Sequence[tuple[str, str, float, float]]]],
    findings: Iterable[Finding],
) -> dict[str, Any]:
    """Return the error causes (such as squareness) that the circular tests of one machine show
    together, and the causes on which the tests contradict each other. ``stated``: name and serial
    number of the machine.

    - ``circles``: names of the tests.
    - ``values``: value and standard error of each cause by axis or plane.
    - ``contradictions``: each cause with its tests; for each test its name, the axis or plane,
      value and standard error.
    """
    return {
        **stated,
        "circles": list(circles),
        "causes": {
            cause: {
                of: {
                    "value": _number(value),
                    "std_error": _number(error),
                    "unit": _UNITS.get(cause, "ms"),
                    **_correction(cause, value, error),
                }
                for of, (value, error) in found.items()
            }
            for cause, found in values.items()
        },
        "contradictions": [
            {
                "cause": cause,
                "circles": [
                    {
                        "name": name,
                        "of": of,
                        "value": _number(value),
                        "std_error": _number(error),
                        "unit": _UNITS.get(cause, "ms"),
                    }
                    for name, of, value, error in seen
                ],
            }
            for cause, seen in contradictions
        ],
        "findings": finding_documents(findings),
    }


def _correction(cause: str, value: float, error: float) -> dict[str, str]:
    """Return, as one key of the JSON, whether `run` corrects the squareness of a plane, by the rule
    of `correction_need`; no key for any other cause.
    """
    return {"correction": correction_need(value, error)} if cause == "squareness" else {}


def _number(value: float, factor: float = 1.0) -> float | None:
    """Return a number for JSON, or None if it is not finite."""
    return (
        round(float(value) * factor, _DIGITS) + 0.0 if np.isfinite(value) else None
    )  # no minus zero


def _micrometres(value: float | None) -> float | None:
    """Return a length in mm converted to µm."""
    return None if value is None else _number(value, MICROMETRES_PER_MILLIMETRE)


def _point(point: tuple[float, float] | None) -> list[float | None] | None:
    return None if point is None else [_micrometres(coordinate) for coordinate in point]


def _zones(result: CircularResult) -> dict[str, Any]:
    nominal = result.test.nominal_radius
    return {
        name: {
            "centre": _point(result.zone_centres[name]),
            "inner": _micrometres(inner - nominal),
            "outer": _micrometres(outer - nominal),
        }
        for name, (inner, outer) in result.zone_radii.items()
    }


def _diagnosis(diagnosis: Diagnosis | None) -> dict[str, Any]:
    if diagnosis is None:
        return {"diagnosis": None, "plain": None, "correlation": None, "fitted": None}
    not_given = diagnosis.not_given
    return {
        "diagnosis": {
            name: _effect(effect, given=True)
            | _correction(name, effect.value, effect.std_error)
            | (dict.fromkeys(("effect", "share")) if name in _NOT_RANKED else {})
            | ({"share": None} if _is_part(name, diagnosis) else {})
            if name not in not_given
            else _effect(effect, given=False)
            for name, effect in diagnosis.effects.items()
        }
        | {name: _absent(name) for name in not_given if name not in diagnosis.effects},
        "plain": {
            name: None if name in not_given else _number(value)
            for name, value in diagnosis.plain.items()
        },
        "correlation": [_numbers(row, _FITTED) for row in diagnosis.correlation],
        "correlation_names": list(diagnosis.names),
        "residual": _micrometres(diagnosis.residual),
        "correlation_length": _number(diagnosis.correlation_length),
        "fitted": [
            {
                "direction": run.sense,
                "number": run.number,
                "angles": _numbers(run.angles),
                "deviations": _numbers(run.deviations * MICROMETRES_PER_MILLIMETRE, _FITTED),
                "residuals": _numbers(run.residuals * MICROMETRES_PER_MILLIMETRE, _FITTED),
            }
            for run in diagnosis.fitted
        ],
    }


def _is_part(name: str, diagnosis: Diagnosis) -> bool:
    """Return whether the effect of a value is in that of another cause: the scale of one axis, the
    difference of the lost motions, or one end of an axis that has a value for both.
    """
    whole, at_end, _ = name.partition("_at_")
    found = at_end and whole in diagnosis.effects and whole not in diagnosis.not_given
    return bool(found) or name.startswith("scale_error") or name == "backlash_mismatch"


def _absent(name: str) -> dict[str, Any]:
    """Return the JSON entry of an error cause that a circular test cannot show: only its unit is
    not null.
    """
    unit = "um/m" if name.startswith("scale_error") else "um"
    return {"value": None, "std_error": None, "unit": unit, "effect": None, "share": None}


def _effect(effect: CircularEffect, *, given: bool) -> dict[str, Any]:
    """Return the JSON entry of an error cause (such as lost motion) in a circular test. If the
    cause has no value (``given`` False), only its standard error and unit are not null.
    """
    entry: dict[str, Any] = {
        "value": _number(effect.value) if given else None,
        "std_error": _number(effect.std_error),
        "unit": effect.unit,
        "effect": _number(effect.effect) if given else None,
        "share": _number(effect.share) if given else None,
    }
    if not given:
        return {**entry, "std_error": entry["std_error"] or None, **dict.fromkeys(effect.more)}
    low = {} if effect.low is None else {"low": _number(effect.low)}
    more = {name: None if value is None else _number(value) for name, value in effect.more.items()}
    axis = {"axis": effect.axis} if "frequency" in more else {}
    return {**entry, **low, **more, **axis}


def _plain(value: object) -> Any:
    """Return the results that the instrument's software printed, as values that JSON allows.

    Numbers stay as they are. Values that JSON does not allow become text or null.
    """
    if isinstance(value, Mapping):
        return {str(key): _plain(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    if isinstance(value, float):
        return float(value) if np.isfinite(value) else None
    return value if value is None or isinstance(value, bool | int | str) else str(value)


def _run(run: CircularRun) -> dict[str, Any]:
    return {
        "direction": run.sense,
        "number": run.number,
        "angles": _numbers(run.angles),
        "deviations": _numbers(run.deviations * MICROMETRES_PER_MILLIMETRE),
    }


def _numbers(values: FloatArray, digits: int = _DIGITS) -> list[float | None]:
    """Return a list of numbers for JSON, with None in place of each number that is not finite."""
    if not np.all(np.isfinite(values)):
        return [_number(value) for value in values.tolist()]
    rounded: list[float | None] = (np.round(values, digits) + 0.0).tolist()
    return rounded
