"""Immutable results of the library, with values and units in ``repr``, ``to_dict`` and ``plot``.

Each holds the document that the command line writes as JSON, so that both give the same values.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.extras import need
from compwright.foundations.session import Session
from compwright.foundations.units import outside_factor, outside_unit
from compwright.library.argument_names import in_argument_names
from compwright.records.axis import Direction, FloatArray

if TYPE_CHECKING:  # for names alone: the library starts without the estimation and the formats
    from numpy.typing import ArrayLike

    from compwright.controls.decoded_state import DecodedState
    from compwright.estimation.axis import AxisPosterior
    from compwright.records.job import Job
    from compwright.workflow.commands.run import PlannedJob

#: Approach direction: the sign of the motion that arrives at the position.
Approach = Literal["+", "-"]

#: Parameters that a ``repr`` shows, as far as the test has them.
_SHOWN = ("A", "E", "R", "B", "M", "P", "Pa", "G_ccw", "G_cw", "G_bidirectional")


def _micro(unit: str) -> str:
    return "µm" if unit == "um" else unit


def _listed(values: Mapping[str, float | None], unit: str) -> str:
    known = {name: values[name] for name in _SHOWN if values.get(name) is not None}
    return ", ".join(f"{name} {value:.2f} {_micro(unit)}" for name, value in known.items())


def _copied(value: Any) -> Any:
    """Return a copy of plain data; numbers in one piece, because a circle has 100 000 of them."""
    if isinstance(value, dict):
        return {key: _copied(each) for key, each in value.items()}
    if isinstance(value, list):
        numbers = set(map(type, value)) == {float}
        return value.copy() if numbers else [_copied(each) for each in value]
    return deepcopy(value)


@dataclass(frozen=True, slots=True, repr=False)
class DocumentResult:
    """A result of a command, with its JSON document, whose keys state the units."""

    _document: Mapping[str, Any]

    def to_dict(self) -> dict[str, Any]:
        """Return the JSON document of the command line as plain data that you may change."""
        return {key: _copied(value) for key, value in self._document.items()}

    @property
    def findings(self) -> list[dict[str, Any]]:
        """The findings, each with ``code``, ``severity`` (info, warning, error) and ``message``."""
        return deepcopy(list(self._document.get("findings", [])))


@dataclass(frozen=True, slots=True, repr=False)
class Evaluation(DocumentResult):
    """The result of evaluating one test to its standard. ``evaluation["A"]`` is a parameter in
    `unit`.
    """

    def __repr__(self) -> str:
        """Return the test, its standard and its parameters with unit."""
        about = f"{self.name!r}, {self._document['standard']}"
        return f"Evaluation({about}: {_listed(self.parameters, self.unit)})"

    def __getitem__(self, name: str) -> float | None:
        """Return a parameter in `unit`, or None if the standard does not define it for the test.

        Raises KeyError for a name that is not a parameter of this kind of test.
        """
        return self.parameters[name]

    @property
    def name(self) -> str:
        """The name of the test."""
        return str(self._document["name"])

    @property
    def unit(self) -> str:
        """The unit of the parameters: um or arcsec."""
        return str(self._document["unit"])

    @property
    def parameters(self) -> dict[str, float | None]:
        """Parameters by the standard's name, in `unit`."""
        return dict(self._document["parameters"])

    @property
    def diagnosis(self) -> dict[str, Any]:
        """The error causes that a circular test shows, each with its value, ``std_error`` and unit.

        It is empty for a positioning test.
        """
        return deepcopy(dict(self._document.get("diagnosis") or {}))

    def to_frame(self) -> Any:
        """Return the targets of a positioning test as a pandas table, one row per target.

        Positions are in mm or deg, deviations in `unit`. Raises UsageError for a circular test, and
        if pandas is not installed.
        """
        targets = self._document.get("targets")
        if targets is None:
            raise UsageError(
                Fault(
                    message="a circular test has no target positions to list",
                    hint="use `to_dict()`",
                )
            )
        pandas = need("pandas", "pandas", "tables of a script")
        return pandas.DataFrame([dict(target) for target in targets])

    def plot(self, ax: Any = None) -> Any:
        """Draw the means of both directions into matplotlib axes. Returns the axes.

        ``ax``: the axes to draw into; default: new axes. Raises UsageError if matplotlib is not
        installed, and for a circular test.
        """
        from compwright.reporting.charts import result_chart, title_of
        from compwright.reporting.panels import draw_on_axes

        if self._document["kind"] != "positioning":
            raise UsageError(
                Fault(
                    message="`plot` does not draw circular tests",
                    hint="give a positioning test, or use the command `compwright evaluate FILE "
                    "--plot circle.svg`",
                )
            )
        chart = result_chart(self._document)
        chart.title = title_of(self._document)
        return draw_on_axes(ax, chart)


@dataclass(frozen=True, slots=True, repr=False)
class EstimatedError:
    """The error of an axis (measured minus target) with its uncertainty at any position.

    ``unit``: um or arcsec. Positions are in mm or deg, machine coordinates. The error is known
    except for a constant, because the zero of the instrument is arbitrary.
    """

    axis: str
    unit: str
    measured: tuple[float, float]
    _posterior: AxisPosterior

    def __repr__(self) -> str:
        """Return the axis, the measured range and the largest error with unit."""
        where = np.linspace(*self.measured, 201)
        largest = max(np.ptp(self.mean(where, "+")), np.ptp(self.mean(where, "-")))
        low, high = self.measured
        return (
            f"EstimatedError(axis {self.axis}, {low:g} to {high:g}:"
            f" range {largest:.2f} {_micro(self.unit)})"
        )

    def mean(self, positions: ArrayLike, approach: Approach) -> FloatArray:
        """Return the expected error at ``positions`` (k,), in `unit`."""
        return self._at(positions, approach)[0]

    def std(self, positions: ArrayLike, approach: Approach) -> FloatArray:
        """Return the standard uncertainty of the error at ``positions`` (k,), in `unit`."""
        return self._at(positions, approach)[1]

    @property
    def periods(self) -> list[dict[str, Any]]:
        """Periodic errors: ``period`` (mm or deg), ``probability`` and ``source`` (stated by the
        job, or found).
        """
        return [
            {"period": one.period, "probability": one.probability, "source": one.source}
            for one in self._posterior.periods
        ]

    def to_dict(self, points: int = 201) -> dict[str, Any]:
        """Return the mean and the standard uncertainty of the error at ``points`` evenly spaced
        positions, by direction.
        """
        where = np.linspace(*self.measured, points)
        curves = {
            f"{what}_{name}": getattr(self, what)(where, approach).tolist()
            for what in ("mean", "std")
            for name, approach in (("positive", "+"), ("negative", "-"))
        }
        return {"axis": self.axis, "unit": self.unit, "positions": where.tolist(), **curves}

    def plot(self, ax: Any = None) -> Any:
        """Draw the error ± 2 standard uncertainties into matplotlib axes. Returns the axes.

        ``ax``: the axes to draw into; default: new axes. Raises UsageError if matplotlib is not
        installed.
        """
        from compwright.reporting.charts import estimate_chart
        from compwright.reporting.panels import draw_on_axes

        return draw_on_axes(ax, estimate_chart(self.to_dict(), {"unit": self.unit}))

    def _at(self, positions: ArrayLike, approach: Approach) -> tuple[FloatArray, FloatArray]:
        where = np.atleast_1d(np.asarray(positions, dtype=np.float64))
        unique, back = np.unique(where, return_inverse=True)
        summary = self._posterior.summary(unique)
        factor = outside_factor(summary.kind.unit)
        mean, std = (
            (summary.mean_positive, summary.std_positive)
            if Direction(approach) is Direction.POSITIVE
            else (summary.mean_negative, summary.std_negative)
        )
        return mean[back] * factor, std[back] * factor


@dataclass(frozen=True, slots=True, repr=False)
class LoadedJob:
    """A job that was read and checked, with the folder ``out`` for its results."""

    path: Path
    out: Path
    record: Job

    def __repr__(self) -> str:
        """Return the file, the control and the axes."""
        return f"LoadedJob({str(self.path)!r}, {self.control}: axes {', '.join(self.axes)})"

    @property
    def control(self) -> str:
        """The id of the control, as ``compwright formats list`` shows it."""
        return self.record.format

    @property
    def axes(self) -> tuple[str, ...]:
        """The names of the axes."""
        return tuple(self.record.axes)


@dataclass(frozen=True, slots=True, repr=False)
class JobPlan(DocumentResult):
    """The tables and the prediction of a job, before `write` stores them on the disk.

    ``exit_code``: that of ``compwright run`` for the same job. 0: every limit is predicted to be
    met, and nothing is in doubt. 1: otherwise. 2: no table is made, because the state of the
    control is not given.
    """

    job: LoadedJob
    exit_code: int
    _planned: PlannedJob = field(repr=False)

    def __repr__(self) -> str:
        """Return each axis with its accuracy A, and each circle with its circular deviation G, as
        measured before and as predicted.
        """
        return f"JobPlan({self.job.control}: {'; '.join(self._lines())})"

    def _lines(self) -> Iterator[str]:
        axes, circles = self.prediction, self._document["circles"]
        for name, each in (*axes.items(), *circles.items()):
            letter, key = ("A", "A") if name in axes else ("G", "G_bidirectional")
            before, predicted = each["before"].get(key), each["predicted"].get(key)
            unit = "µm" if letter == "G" else _micro((each.get("table") or {}).get("unit", ""))
            if before is None or predicted is None:
                yield name
                continue
            yield (
                f"{name} {letter} {before:.2f} -> {predicted['median']:.2f}"
                f" ({predicted['p05']:.2f} to {predicted['p95']:.2f}) {unit}"
            ).rstrip()

    @property
    def prediction(self) -> dict[str, Any]:
        """The prediction by axis as in ``prediction.json``: the parameters ``before`` and
        ``predicted`` after loading.
        """
        return deepcopy(dict(self._document["axes"]))

    @property
    def evaluation(self) -> dict[str, Any]:
        """The evaluation of the tests before compensation, as in ``evaluation.json``."""
        return deepcopy(dict(self._planned.results.evaluation))

    @property
    def findings(self) -> list[dict[str, Any]]:
        """The findings, each with ``code``, ``severity`` and ``message``."""
        return self._planned.finding_documents()

    @property
    def tables(self) -> dict[str, bytes]:
        """The contents of the files that the control loads, by name; empty without a table."""
        folder = f"tables/{self.job.control}/"
        return {
            name.removeprefix(folder): content
            for name, content in self._planned.results.files.items()
            if name.startswith(folder)
        }

    @in_argument_names
    def write(self, folder: str | Path | None = None, *, force: bool = False) -> list[Path]:
        """Write all files that ``compwright run`` writes; if that fails, write no file. Returns the
        paths.

        ``folder``: the folder of the results; default: that of the job. ``force``: replace an
        earlier result. Raises StorageError if files exist already or cannot be written.
        """
        from compwright.workflow.commands.run import write_planned

        out = self.job.out if folder is None else Path(folder)
        session = Session()
        return list(write_planned(session, self._planned, out, force=force).files)


@dataclass(frozen=True, slots=True, repr=False)
class Verification(DocumentResult):
    """The result of tests after loading, compared with the plan."""

    def __repr__(self) -> str:
        """Return the verdict, and for each axis whether the table is active, then the circles."""
        parts = [
            f"{name} {axis['loading']['verdict']}" for name, axis in self._document["axes"].items()
        ]
        parts += [f"circle {name}" for name in self._document["circles"]]
        return f"Verification({self.verdict}: {', '.join(parts)})"

    @property
    def verdict(self) -> str:
        """The verdict: ``good``, ``bad`` or ``undecided``."""
        return str(self._document["verdict"])


@dataclass(frozen=True, slots=True, repr=False)
class Comparison(DocumentResult):
    """The comparison of the control's files with a plan."""

    def __repr__(self) -> str:
        """Return the verdict, and for each axis the differences."""
        axes = ", ".join(
            f"{name} {axis['verdict']}" for name, axis in self._document["axes"].items()
        )
        return f"Comparison({self.verdict}: {axes})"

    @property
    def verdict(self) -> str:
        """The verdict: ``same``, ``different`` or ``undecided``."""
        return str(self._document["verdict"])


@dataclass(frozen=True, slots=True, repr=False)
class DecodedFiles(DocumentResult):
    """The decoded files of a control; ``decoded["X"]`` is the correction of the axis X."""

    _state: DecodedState
    _unknown: Sequence[str]

    def __repr__(self) -> str:
        """Return each axis with the range of its correction and the unit, as text."""
        parts = []
        for address, axis in self._document["axes"].items():
            values = [*axis["correction_positive"], *axis["correction_negative"], 0.0]
            parts.append(
                f"{address} {min(values):+.2f} to {max(values):+.2f} {_micro(axis['unit'] or '')}"
            )
        return f"DecodedFiles({', '.join(parts).rstrip()})"

    def __getitem__(self, address: str) -> AxisCorrection:
        """Return the correction of the axis with this address. Raises KeyError."""
        axis = self._state.state.axes[address]
        unit = None if address in self._unknown else outside_unit(axis.kind.unit)
        return AxisCorrection(address, unit, outside_factor(axis.kind.unit), self._state)

    def __iter__(self) -> Iterator[str]:
        """Iterate over the addresses of the axes."""
        return iter(self._document["axes"])

    def __len__(self) -> int:
        """Return the number of axes."""
        return len(self._document["axes"])


@dataclass(frozen=True, slots=True, repr=False)
class AxisCorrection:
    """The correction that the control adds to an axis, by position and approach.

    ``unit``: um or arcsec. It is None if the files do not show whether the axis is linear or
    rotary; values are then in thousandths of the unit of its positions.
    """

    address: str
    unit: str | None
    _factor: float
    _state: DecodedState

    def __repr__(self) -> str:
        """Return the axis and its unit."""
        return f"AxisCorrection({self.address}, {_micro(self.unit or 'unit unknown')})"

    def __call__(self, positions: ArrayLike, approach: Approach) -> FloatArray:
        """Return the correction at ``positions`` (k,), mm or deg, for an approach direction."""
        from compwright.controls.decoded_state import judged_values

        where = np.atleast_1d(np.asarray(positions, dtype=np.float64))
        correction: FloatArray = (
            judged_values(self._state, self.address, where, Direction(approach)) * self._factor
        )
        return correction
