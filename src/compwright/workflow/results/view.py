"""The data for the reports: the documents of a run or a verification, and the curves of the
figures, in µm or arcsec.
"""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from compwright import __version__
from compwright.controls.control import Control
from compwright.controls.decoded_state import DecodedState
from compwright.documents.circular import circular_document
from compwright.documents.evaluation import evaluation_document
from compwright.documents.findings import finding_documents
from compwright.foundations.units import outside_factor, outside_unit
from compwright.planning.axis_work import AxisWork
from compwright.prediction.active_corrections import difference
from compwright.records.axis import Direction
from compwright.records.circular import CircularResult
from compwright.records.job import Job
from compwright.records.result import PositioningResult
from compwright.words.sentences import ControlText, say
from compwright.workflow.results.test_facts import (
    report_document,
    stated_of_axes,
    stated_of_circles,
)
from compwright.workflow.run.prediction_stage import after_loading

JOB = "job.yaml"


def evaluations(
    tests: Sequence[PositioningResult], circles: Sequence[CircularResult]
) -> dict[str, Any]:
    """Return the evaluation document of positioning and circular tests."""
    document = evaluation_document(tests)
    return {
        **document,
        "results": [*document["results"], *(circular_document(circle) for circle in circles)],
    }


def run_view(
    job: Job,
    control: Control,
    works: Mapping[str, AxisWork],
    loaded: DecodedState | None,
    *,
    stated: bool,
    state_files: Sequence[str],
    **documents: Any,
) -> dict[str, Any]:
    """Return the data for the report of a run, including its ``documents`` by name. ``stated``:
    whether the present contents of the control are known; ``state_files``: the names of the files
    with these contents.
    """
    state: str | list[str] | None = None
    if stated:
        state = list(state_files) or "none"
    axes = list(works) or list(job.axes)
    return {
        "title": say("report.compensation", axes=axes if len(axes) < 6 else (), count=len(axes)),
        "machine": dict(job.machine),
        "format": {"id": control.id, "title": ControlText(control.definition.title, {})},
        "axes": {name: {**axis_view(work, loaded), "state": state} for name, work in works.items()},
        "version": __version__,
        **_paper(job, ["run"]),
        **documents,
    }


def _paper(job: Job, command: Sequence[str], options: Sequence[str] = ()) -> dict[str, Any]:
    """Return the head of a printed report, with the command line that makes the report again."""
    return {
        "language": job.report.language,
        "report": report_document(job),
        "stated": {"axes": stated_of_axes(job), "circles": stated_of_circles(job)},
        "command": shlex.join(["compwright", *command, Path(job.file).name or JOB, *options]),
    }


def axis_view(work: AxisWork, loaded: DecodedState | None) -> dict[str, Any]:
    """Return the report data of one axis: its estimated error, its wanted total correction, its
    fitted table, and its prediction. ``loaded``: the corrections that are active after loading.
    """
    planned = work.planned
    estimate, wanted, fitted = planned.estimate, planned.wanted, planned.fitted
    factor = outside_factor(planned.axis.kind.unit)

    def scaled(values: Any) -> list[float]:
        return [float(value) for value in values * factor]

    return {
        "address": planned.axis.address,
        "kind": planned.axis.kind.value,
        "unit": outside_unit(planned.axis.kind.unit),
        "position_unit": planned.axis.kind.unit,
        "estimate": {
            "positions": estimate.positions.tolist(),
            "mean_positive": scaled(estimate.mean_positive),
            "mean_negative": scaled(estimate.mean_negative),
            "std_positive": scaled(estimate.std_positive),
            "std_negative": scaled(estimate.std_negative),
        },
        "wanted": (
            None
            if wanted is None
            else {
                "positions": wanted.positions.tolist(),
                "positive": scaled(wanted.positive),
                "negative": scaled(wanted.negative),
            }
        ),
        "mode": fitted.mode if fitted else None,
        "mode_reason": fitted.mode_reason if fitted else None,
        "certificate": dict(fitted.certificate) if fitted else {},
        "refused": str(work.refused or ""),
        "predicted_targets": expected_targets(work, loaded),
        "findings": finding_documents(work.findings),
    }


def expected_targets(work: AxisWork, loaded: DecodedState | None) -> dict[str, Any]:
    """Return, as data for the report (µm or arcsec), the mean deviations expected in a new test at
    the same targets, and the expected scatter s of a single reading. ``loaded``: the corrections
    that are active after loading.
    """
    test = work.results[0].test
    factor = outside_factor(test.kind.unit)
    change = difference(after_loading(work, loaded), work.active)
    estimate = work.estimate_at(test.targets)
    measured = {direction: bool(test.readings(direction).any()) for direction in Direction}
    expected = {
        direction: (
            ((estimate.mean(direction) + change(test.targets, direction)) * factor).tolist()
            if measured[direction]
            else []
        )
        for direction in Direction
    }
    return {
        "positions": test.targets.tolist(),
        "positive": expected[Direction.POSITIVE],
        "negative": expected[Direction.NEGATIVE],
        "s": estimate.noise * factor,
    }


def verify_view(
    job: Job,
    control: Control,
    axes: Mapping[str, Mapping[str, Any]],
    options: Sequence[str],
    **documents: Any,
) -> dict[str, Any]:
    """Return the data for the report of a verification.

    ``axes``: those of the verification document. ``options``: the words of the command line.
    """
    return {
        "title": say(
            "report.verification",
            axes=list(axes)
            or [
                say("report.circle", plane=name, name="")
                for name in documents["verification"]["circles"]
            ],
        ),
        "machine": dict(job.machine),
        "format": {"id": control.id, "title": ControlText(control.definition.title, {})},
        "axes": {
            name: {"unit": axis["unit"], "predicted_targets": axis["expected"]}
            for name, axis in axes.items()
        },
        "version": __version__,
        **_paper(job, ["verify"], options),
        **documents,
    }
