"""Keys of an axis that a control has no place for are named, those that act are not."""

from __future__ import annotations

import pytest

from compwright.controls.control import open_control
from compwright.controls.job_completion import keys_with_effect
from compwright.foundations.session import Session
from compwright.jobs.idle_keys import idle_keys
from compwright.jobs.reading import read_job


@pytest.mark.parametrize(
    ("control", "idle"),
    [
        ("linuxcnc", ["encoder.system: 2", "axis_number: 3"]),
        ("fanuc-30i", ["encoder.system: 2", "axis_number: 3"]),
        ("heidenhain-nck", ["encoder.system: 2", "axis_number: 3"]),
        (
            "heidenhain-itnc530",
            ["encoder.system: 2"],
        ),  # its columns and parameters have the number of the axis
        ("siemens-840d-sl", ["axis_number: 3"]),  # its lines have the index of the measuring system
    ],
)
def test_keys_without_effect_are_named(control: str, idle: list[str]) -> None:
    text = (
        f"compwright: 1\ncontroller: {{format: {control}}}\naxes:\n"
        "  X: {travel: [0, 100], before: [x.csv], encoder: {system: 2}, axis_number: 3}\n"
    )
    job = read_job(text.encode(), "job.yaml", lambda _: iter(()))
    definition = open_control(Session(), control, {}).definition
    found = idle_keys(job, **keys_with_effect(definition))
    assert [finding.message for finding in found] == [
        f"axes.X.{key} has no effect on this control ({control})" for key in idle
    ]
    assert {finding.code for finding in found} == {"CW-J020"}
