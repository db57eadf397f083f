"""Whatever is in a job file, the answer is a job or a list of faults."""

from __future__ import annotations

import re
from typing import Any

import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import Fault, UsageError
from compwright.jobs.command_line import job_from_options
from compwright.jobs.reading import read_job
from compwright.records.job import Job
from places import PROJECT

PAGE = (PROJECT / "docs" / "job-file.md").read_text(encoding="utf-8")
EXAMPLE = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)[0]
# own text, everything as text
DATA: dict[str, Any] = yaml.load(EXAMPLE, Loader=yaml.BaseLoader)  # noqa: S506

Path = tuple[str | int, ...]


def paths_of(value: Any, path: Path = ()) -> list[Path]:
    inner = (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else ()
    )
    return [path, *(found for key, below in inner for found in paths_of(below, (*path, key)))]


ANYTHING = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from(
        ["010", "1:30", "none", "auto", "+", "-", "as_found", "X", "rotary", "1e999", 10**30, -1, 0]
    ),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.text(max_size=5) | st.sampled_from(["files", "A"]), inner, max_size=3)
    ),
    max_leaves=6,
)


def checked(content: bytes) -> None:
    """Any other exception than UsageError, and any fault without its file, fails the test."""
    job: Job | None = None
    faults: tuple[Fault, ...] = ()
    try:
        job = read_job(content, "job.yaml")
    except UsageError as error:
        faults = error.faults
    assert (job is None) == bool(faults)
    for fault in faults:
        assert fault.file == "job.yaml"
        assert fault.message
        str(fault).encode()  # can be written to a terminal
    if job is not None:
        assert all(axis.axis.travel[0] < axis.axis.travel[1] for axis in job.axes.values())


@given(st.data())
@settings(max_examples=60, deadline=None)
def test_one_value_replaced_by_anything(data: st.DataObject) -> None:
    path = data.draw(st.sampled_from(paths_of(DATA)))
    content = yaml.safe_load(EXAMPLE)
    new = data.draw(ANYTHING)
    if not path:
        content = new
    else:
        target = content
        for part in path[:-1]:
            target = target[part]
        target[path[-1]] = new
    checked(yaml.safe_dump(content, allow_unicode=True).encode("utf-8", "replace"))


@given(st.integers(0, len(EXAMPLE) - 1), st.integers(0, 20), st.text(max_size=10))
@settings(max_examples=60, deadline=None)
def test_text_cut_and_pasted(start: int, length: int, pasted: str) -> None:
    checked((EXAMPLE[:start] + pasted + EXAMPLE[start + length :]).encode("utf-8", "replace"))


@given(st.binary(max_size=60))
@settings(max_examples=100, deadline=None)
def test_bytes(content: bytes) -> None:
    checked(content)


@given(
    files=st.lists(st.text(max_size=6), max_size=3),
    travel=st.text(alphabet="0123456789.:-+e, ", max_size=10),
    axis=st.text(max_size=4),
    states=st.lists(st.sampled_from(["none", "a", "", "\0"]), max_size=3),
    options=st.lists(
        st.tuples(
            st.sampled_from(["spacing", "mode", "kind", "address", "x", "", "screw_pitch"]),
            st.text(max_size=6),
        ).map("=".join),
        max_size=4,
    ),
)
@settings(max_examples=60, deadline=None)
def test_options(
    files: list[str], travel: str, axis: str, states: list[str], options: list[str]
) -> None:
    faults: tuple[Fault, ...] = ()
    try:
        job = job_from_options(
            files, format="linuxcnc", axis=axis, travel=travel, states=states, options=options
        ).job
        assert list(job.axes) == [axis]
    except UsageError as error:
        faults = error.faults
    assert all(fault.place for fault in faults)
