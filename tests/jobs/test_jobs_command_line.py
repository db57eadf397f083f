"""``compwright run FILE... --format ...`` without a job file."""

from __future__ import annotations

import re
from collections.abc import Sequence

import pytest

from compwright.foundations.errors import UsageError
from compwright.jobs.command_line import job_from_options
from compwright.jobs.reading import read_job
from compwright.records.axis import AxisKind, Direction
from compwright.records.job import NONE_STATE, Job
from next_steps import without_hint


def from_options(
    files: Sequence[str] = ("runs/x.csv",),
    axis: str = "X",
    travel: str = "-850:0",
    states: Sequence[str] = (),
    options: Sequence[str] = (),
) -> Job:
    return job_from_options(
        files, format="fanuc-30i", axis=axis, travel=travel, states=states, options=options
    ).job


def faults_of(**words: object) -> list[str]:
    with pytest.raises(UsageError) as caught:
        from_options(**words)  # type: ignore[arg-type]
    return [str(fault) for fault in caught.value.faults]


def test_same_as_the_job_file_that_says_the_same() -> None:
    by_file = read_job(
        b"""
compwright: 1
controller: {format: fanuc-30i, options: {detection_unit: "0.001"}}
states: {as_found: [control/P.TXT, control/Q.TXT]}
axes:
  B:
    kind: rotary
    travel: [-30, 110.5]
    before: {files: [runs/b1.csv, runs/b2.csv]}
    address: 4
    axis_number: 3
    reference: -0.5
    reference_return: "-"
    encoder: {system: 2}
    screw_pitch: [2, 4.5]
    table: {spacing: 10, mode: single}
""",
        "",
    )
    by_options = from_options(
        files=["runs/b1.csv", "runs/b2.csv"],
        axis="B",
        travel="-30:110.5",
        states=["control/P.TXT", "control/Q.TXT"],
        options=[
            *(
                "address=4",
                "kind=rotary",
                "reference=-0.5",
                "reference_return=-",
                "encoder_system=2",
                "screw_pitch=2,4.5",
            ),
            *("spacing=10", "mode=single", "detection_unit=0.001", "axis_number=3"),
        ],
    )
    assert by_options == by_file


def test_defaults() -> None:
    job = from_options()
    (test,) = job.axes["X"].before
    assert (job.axes["X"].axis.travel, job.axes["X"].axis.kind) == ((-850.0, 0.0), AxisKind.LINEAR)
    assert job.axes["X"].axis.reference_return is Direction.POSITIVE
    assert (test.name, test.files, test.measured_in) == ("x", ("runs/x.csv",), "as_found")
    assert (job.states, job.options, job.axes["X"].table.spacing) == ({}, {}, None)


def test_several_files_are_one_test_named_after_the_first() -> None:
    (test,) = from_options(files=["a/first.csv", "b/second.csv"]).axes["X"].before
    assert (test.name, test.files) == ("first", ("a/first.csv", "b/second.csv"))


def test_states() -> None:
    assert from_options(states=["none"]).states == {"as_found": NONE_STATE}
    assert from_options(states=["a", "b"]).states == {"as_found": ("a", "b")}


def test_values_of_controller_options_stay_text() -> None:
    assert from_options(options=["a=1", "b=", "c=x=y", "spacing=auto"]).options == {
        "a": "1",
        "b": "",
        "c": "x=y",
    }


@pytest.mark.parametrize(
    "travel", ["", "0", "0:", "0:1:2", "1:0", "a:b", "0:1e999", "0:nan", "0:0", "0,5:1"]
)
def test_travel_is_two_numbers_in_order(travel: str) -> None:
    (line,) = faults_of(travel=travel)
    assert without_hint(line).startswith("--travel: the value of `--travel` must look like 0:800 ")
    assert line.endswith("such as `--travel 0:800` or `--travel=-800:0`")
    assert f"; found {travel!r}." in line


@pytest.mark.parametrize(
    ("words", "start"),
    [
        ({"files": []}, "FILE: "),
        ({"files": ["a", "a"]}, "FILE is given twice"),
        ({"axis": "../x"}, "--axis: "),
        ({"states": ["none", "a"]}, "--state: "),
        ({"states": [""]}, "--state: "),
        ({"options": ["spacing"]}, "--option: the value of `--option` must look like KEY=VALUE"),
        ({"options": ["=1"]}, "--option: the value of `--option` must look like KEY=VALUE"),
        ({"options": ["a=1", "a=2"]}, "--option a: `--option` is given twice"),
        ({"options": ["spacing=0"]}, "--option spacing: "),
        ({"options": ["mode=both"]}, "--option mode: "),
        ({"options": ["kind=round"]}, "--option kind: "),
        ({"options": ["reference=zero"]}, "--option reference: "),
        ({"options": ["reference_return=up"]}, "--option reference_return: "),
        ({"options": ["encoder_system=3"]}, "--option encoder_system: "),
        ({"options": ["screw_pitch=10,-5"]}, "--option screw_pitch: "),
        ({"options": ["address="]}, "--option address: "),
    ],
)
def test_faults_name_their_option(words: dict[str, object], start: str) -> None:
    (fault,) = faults_of(**words)
    assert re.match(re.escape(start).removesuffix(r":\ ") + "[: ]", fault) or fault.startswith(
        start
    )


def test_all_faults_at_once() -> None:
    faults = faults_of(travel="0", options=["mode=x", "spacing=y", "z"])
    assert sorted(re.split(r": | is ", fault)[0] for fault in faults) == [
        "--option",
        "--option mode",
        "--option spacing",
        "--travel",
    ]
