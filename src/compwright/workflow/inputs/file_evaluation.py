"""Evaluate measurement files one by one, so that parallel processes can share the work.

A file is passed with its content, because only the first process reads files. The result has the
entry for the JSON document, and the values by which the tests of a folder are compared.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, cast

from compwright.documents.evaluation import in_short, result_document
from compwright.evaluation.standards import evaluate
from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.own_faults import own_fault
from compwright.instruments.other_files import is_circular
from compwright.instruments.profile import Profile
from compwright.instruments.text_input import read_lines
from compwright.records.positioning import PositioningTest

if TYPE_CHECKING:  # positioning tests, the common case, start without the circular records
    from compwright.records.circular import CircularResult, CircularTest


#: The entry of a test in the document.
Entry = dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class EvaluationRequest:
    """The settings for all evaluations: the standards, the formula for the scatter s of repeated
    readings, and the mapping profile.

    ``whole``: whether the entries of the result contain targets and readings.
    """

    positioning: str
    circular: str
    spread: str
    profile: Profile | None
    whole: bool


@dataclass(frozen=True, slots=True)
class FileToEvaluate:
    """A file with its displayed name and its contents, or the reason why it could not be read."""

    file: str
    content: bytes = b""
    faults: tuple[Fault, ...] = ()


@dataclass(frozen=True, slots=True)
class Evaluated:
    """An evaluated test, and the test's entry in the JSON document of the evaluation."""

    entry: dict[str, Any]
    test: PositioningTest | None = None
    circle: CircularResult | None = None


#: Why a fault was noted: a file cannot be read, a test cannot be evaluated, the method asked for
#: does not fit the test, compwright itself is at fault.
Why = Literal["unread", "refused", "unfit", "own"]


@dataclass(frozen=True, slots=True)
class Noted:
    """A fault of a file or of one of its tests. ``why``: the kind of fault, such as ``unread``."""

    why: Why
    fault: Fault


@dataclass(frozen=True, slots=True)
class FileTests:
    """The tests in one file, and its faults.

    Positioning tests are evaluated. Circular tests are not evaluated yet, because two files may
    contain one direction each of the same test.
    """

    tests: tuple[Evaluated | CircularTest, ...] = ()
    noted: tuple[Noted, ...] = ()


@dataclass(frozen=True, slots=True)
class FilesEvaluator:
    """A function that evaluates a file by the settings ``request``, also in another process."""

    request: EvaluationRequest

    def __call__(self, given: FileToEvaluate) -> FileTests:
        """Return the evaluated tests of a file, together with the faults of the file and of its
        tests.
        """
        if given.faults:
            return FileTests(noted=tuple(Noted("unread", fault) for fault in given.faults))
        try:
            tests = tests_in(given.content, given.file, self.request.profile)
        except Exception as error:  # noqa: BLE001 - the other files are evaluated all the same
            entry_of = self._two_columns(given) if isinstance(error, InputError) else None
            if entry_of is None:
                return FileTests(noted=_noted(error, given.file, "unread"))
            return self._of_two_columns(given, entry_of)
        parts = [self._of(test) for test in tests]
        return FileTests(
            tuple(test for part in parts for test in part.tests),
            tuple(noted for part in parts for noted in part.noted),
        )

    def _two_columns(self, given: FileToEvaluate) -> Callable[[FileToEvaluate], Entry] | None:
        """Return the function that evaluates this file if it is a stand-still test or a table of
        lost motion, else None.
        """
        from compwright.instruments.drift_csv import is_drift, is_lost_motion

        if self.request.profile is not None:
            return None
        try:
            lines = read_lines(given.content, given.file)
        except InputError:
            return None
        if is_drift(lines):
            return _stand_still
        return _lost_motion if is_lost_motion(lines) else None

    def _of_two_columns(
        self, given: FileToEvaluate, entry_of: Callable[[FileToEvaluate], Entry]
    ) -> FileTests:
        try:
            entry = entry_of(given)
        except Exception as error:  # noqa: BLE001 - the other files are evaluated all the same
            return FileTests(noted=_noted(error, given.file, "unread"))
        return FileTests((Evaluated(_kept(entry, self.request)),))

    def _of(self, test: PositioningTest | CircularTest) -> FileTests:
        if not isinstance(test, PositioningTest):
            return FileTests((test,))
        spread = cast("Literal['std', 'range']", self.request.spread)
        try:
            entry = result_document(evaluate(test, self.request.positioning, spread=spread))
        except Exception as error:  # noqa: BLE001 - as above
            return FileTests(noted=_noted(error, test.sources[0].file, "refused"))
        bare = replace(test, header={}, findings=())
        return FileTests((Evaluated(_kept(entry, self.request), bare),))


@dataclass(frozen=True, slots=True)
class CirclesEvaluator:
    """A function that evaluates and diagnoses a circular test by the settings ``request``."""

    request: EvaluationRequest

    def __call__(self, test: CircularTest) -> FileTests:
        """Evaluate and diagnose a circular test, and return the result, or the faults if this
        fails.
        """
        from compwright.documents.circular import circular_document
        from compwright.planning.circle_diagnosis import diagnose_circle

        try:
            result = diagnose_circle(test, self.request.circular)
            entry = circular_document(result)
        except Exception as error:  # noqa: BLE001 - the other tests are evaluated all the same
            return FileTests(noted=_noted(error, test.sources[0].file, "refused"))
        causes = result.diagnosis
        bare = replace(
            result,
            test=replace(result.test, runs=(), vendor={}),
            diagnosis=None if causes is None else replace(causes, fitted=(), fresh=tuple),
        )
        return FileTests((Evaluated(_kept(entry, self.request), circle=bare),))


def _stand_still(given: FileToEvaluate) -> Entry:
    from compwright.documents.standstill import stand_still_document
    from compwright.evaluation.environmental_variation import environmental_variation
    from compwright.instruments.drift_csv import read_drift

    drift = read_drift(given.content, given.file)
    return stand_still_document(drift, *environmental_variation(drift, None))


def _lost_motion(given: FileToEvaluate) -> Entry:
    from compwright.documents.standstill import lost_motion_document
    from compwright.evaluation.lost_motion import lost_motion_result
    from compwright.instruments.drift_csv import read_lost_motion

    test = read_lost_motion(given.content, given.file)
    found = lost_motion_result(test)
    return lost_motion_document(
        test, found.constant, found.left, depends=found.depends, findings=found.findings
    )


def ready() -> None:
    """Do nothing. A new process calls this function, so that it imports the module in advance."""


def _kept(entry: dict[str, Any], request: EvaluationRequest) -> dict[str, Any]:
    return entry if request.whole else in_short(entry)


def _noted(error: Exception, file: str, why: Why) -> tuple[Noted, ...]:
    if isinstance(error, InputError):
        return tuple(Noted(why, fault.in_file(file)) for fault in error.faults)
    if isinstance(error, UsageError):  # the method does not fit this test; it may fit the others
        return tuple(Noted("unfit", fault.in_file(file)) for fault in error.faults)
    return (Noted("own", own_fault(error, file)),)


def tests_in(
    content: bytes, file: str, profile: Profile | None
) -> Sequence[PositioningTest | CircularTest]:
    """Return the tests of any kind in a file's contents. Raises InputError."""
    circular = is_circular(content, file)
    if profile is not None or not circular:
        from compwright.instruments.reading import read_tests  # a circular test loads no other form

        try:
            return read_tests(content, file, profile)
        except InputError as error:
            # without the frames, which hold the lines of the file
            refused = InputError(*error.faults)
        if not circular:
            raise refused
    from compwright.instruments.circular_reading import (
        read_circular,
    )  # only now: the way of a positioning test stays short

    return (read_circular(content, file),)
