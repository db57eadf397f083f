"""Check the keys of ``record.json``, which a user may have edited."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import PureWindowsPath
from typing import Any, Final, Literal

import numpy as np
from pydantic_core import SchemaValidator

from compwright.documents.plain_values import PLAIN
from compwright.foundations.key_faults import KeyFault
from compwright.foundations.record_schemas import RecordForm, RecordSchemas
from compwright.foundations.validation import checked
from compwright.records.axis import FloatArray
from compwright.records.input_record import InputRole


def faults_of_record(data: Mapping[str, Any]) -> list[KeyFault]:
    """Return the faults of a record (or of older documents in its place) with key paths."""
    return checked(_validator(), data)[1]


@dataclass(frozen=True, slots=True, kw_only=True)
class _File:
    file: str
    sha256: str
    by: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _RecordInput:
    role: InputRole
    of: str
    file: str
    sha256: str
    copy: str | None
    by: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Error:
    value: float
    dof: float


@dataclass(frozen=True, slots=True, kw_only=True)
class _Uncertainty:
    U: float | None
    coverage: float


@dataclass(frozen=True, slots=True, kw_only=True)
class _Squareness:
    value: float | None
    std_error: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class _Test:
    """The entries of a test in a record. ``measured_in``: the control's state, "" after loading."""

    name: str
    taken: Literal["before", "after"]
    date: str
    simulated: bool
    standard: str
    unit: str
    sources: tuple[str, ...]
    parameters: Mapping[str, float | None]
    measured_in: str
    instrument: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _AxisTest(_Test):
    kind: Literal["positioning"]
    axis: str
    axis_kind: Literal["linear", "rotary"]
    s: float | None
    std_error: Mapping[str, _Error]
    targets: FloatArray = field(default_factory=lambda: np.empty(0))
    mean_positive: FloatArray = field(default_factory=lambda: np.empty(0))
    mean_negative: FloatArray = field(default_factory=lambda: np.empty(0))
    uncertainty: Mapping[str, _Uncertainty] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class _CircularTest(_Test):
    kind: Literal["circular"]
    plane: str
    squareness: _Squareness | None


@dataclass(frozen=True, slots=True, kw_only=True)
class _Limit:
    limit: float


@dataclass(frozen=True, slots=True, kw_only=True)
class _Decided:
    accept: Mapping[str, _Limit]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Decisions:
    axes: Mapping[str, _Decided] = field(default_factory=dict)
    circles: Mapping[str, _Decided] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Loading:
    verdict: str


@dataclass(frozen=True, slots=True, kw_only=True)
class _VerifiedAxis:
    loading: _Loading
    read_back: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Verification:
    verdict: Literal["good", "bad", "undecided"]
    axes: Mapping[str, _VerifiedAxis]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Record:
    machine: Mapping[str, object]
    states: tuple[str, ...]
    inputs: tuple[_RecordInput, ...]
    files: tuple[_File, ...]
    tests: tuple[_AxisTest | _CircularTest, ...]
    verification: _Verification | None
    decisions: _Decisions = field(default_factory=_Decisions)


def _error(error: _Error) -> Iterator[str]:
    if not (error.value >= 0 and error.dof > 0):
        yield "a standard error of 0 or more, with degrees of freedom above 0"


def _inside(name: str | None) -> Iterator[str]:
    """Yield what is expected of a file's ``name`` that leads out of the result folder."""
    if name is not None and (PureWindowsPath(name).anchor or ".." in PureWindowsPath(name).parts):
        yield "a name inside the result folder"


def _uncertainty(stated: _Uncertainty) -> Iterator[str]:
    if not ((stated.U is None or stated.U >= 0) and stated.coverage > 0):
        yield "an uncertainty of 0 or more, with a coverage factor above 0"


def _squareness(found: _Squareness) -> Iterator[str]:
    if found.std_error is not None and found.std_error < 0:
        yield "a standard error of 0 or more"


def _record(record: _Record) -> Iterator[str]:
    if record.verification is None and any(test.taken == "after" for test in record.tests):
        yield "a verification, because there are tests after loading"


_ALONE: Final = RecordForm(others=True)
_FORMS: Final[Mapping[type, RecordForm]] = {
    _Record: RecordForm(others=True, absent=frozenset({"decisions"})),
    _File: RecordForm(others=True, absent=frozenset({"by"})),
    _RecordInput: RecordForm(others=True, absent=frozenset({"by"})),
    _AxisTest: RecordForm(
        others=True,
        absent=frozenset(
            {"targets", "mean_positive", "mean_negative", "uncertainty", "instrument"}
        ),
    ),
    _CircularTest: RecordForm(others=True, absent=frozenset({"instrument"})),
    _Decisions: RecordForm(others=True, absent=frozenset({"axes", "circles"})),
    _VerifiedAxis: RecordForm(others=True, absent=frozenset({"read_back"})),
    **dict.fromkeys(
        (_Error, _Uncertainty, _Squareness, _Loading, _Verification, _Limit, _Decided), _ALONE
    ),
}
_RULES: Final[Mapping[type, Callable[[Any], Iterator[str]]]] = {
    _Record: _record,
    _File: lambda entry: _inside(entry.file),
    _RecordInput: lambda entry: _inside(entry.copy),
    _Error: _error,
    _Uncertainty: _uncertainty,
    _Squareness: _squareness,
}


@cache
def _validator() -> SchemaValidator:
    return RecordSchemas(_FORMS, _RULES, PLAIN).validator(_Record)
