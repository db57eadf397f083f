"""Write a job file for a run that was started without one: given options, and assumed values with
reasons.

A value with a key of the job file is written under that key. An option of the control that has its
default value is written as a comment. If it were a key, it would count as known, and the results
would no longer list it as assumed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from compwright.jobs.writing import flow, word
from compwright.records.correction import Assumption
from compwright.records.job import AS_FOUND

_HEADING = (
    "The job that `compwright run` took from its command line. Correct what is wrong, and run it",
    "again: compwright run --force with the path of this file. Paths are relative to this file.",
    '`assumed`: not given. Remove the "# " in front of a key to state it.',
)
#: Keys of an axis that the options may leave out: the value that then counts, and what it means.
_OF_AXIS: tuple[tuple[str, object, str], ...] = (
    ("kind", "linear", "linear or rotary"),
    ("reference", 0, "machine coordinate of the reference position; the correction is zero there"),
    ("reference_return", "+", "direction in which the reference position is approached"),
    ("programmed", "radius", "radius or diameter: how the control counts this axis"),
)
_OF_TEST: tuple[tuple[str, object, str], ...] = (
    ("measured_in", AS_FOUND, "the entry of `states` that was active during the test"),
    ("motion", "feed", "feed or rapid: how the targets were approached"),
)
_OF_JOB: tuple[tuple[str, object, str], ...] = (
    ("standard", "iso230-2:2014", "the standard of the evaluation"),
    ("decision_rule", "simple", "simple or guarded (the limit less the uncertainty)"),
)
_OPEN = (
    "screw_pitch: 10    # not given: periods are searched in the readings; mm or deg",
    "accept: {A: 8}     # not given: the prediction is compared with no limit; µm or arcsec",
)
_OPTION = "option "


@dataclass(frozen=True, slots=True)
class _JobLine:
    """One line of a job file, and where its value comes from."""

    text: str
    source: str = ""


def assumed_of(data: Mapping[str, Any], by_files: Mapping[str, object]) -> tuple[Assumption, ...]:
    """Return the assumptions of a run without a job file: the values that it uses for keys of axis,
    test and job which the command line does not give. ``by_files``: values of axis keys from the
    control's files.
    """
    ((axis, section),) = data["axes"].items()
    left = _left_out(section, by_files)
    named = [(f"axis {axis}: {key}", value, what) for key, value, what in left]
    named += [(f"test: {key}", value, what) for key, value, what in _OF_TEST]
    named += list(_OF_JOB)
    return tuple(
        Assumption(fact, str(value), f"not given; {what}" if what else "not given")
        for fact, value, what in named
    )


def _left_out(
    section: Mapping[str, Any], by_files: Mapping[str, object]
) -> Iterator[tuple[str, object, str]]:
    for key, value, what in _OF_AXIS:
        if key not in section and not (key == "programmed" and section.get("kind") == "rotary"):
            known = key in by_files
            yield (
                key,
                by_files.get(key, value),
                f"{what}; from the control's files" if known else what,
            )


def assumed_job(
    data: Mapping[str, Any],
    options: Mapping[str, object],
    assumed: Sequence[Assumption],
    by_files: Mapping[str, object],
) -> str:
    """Return as text the job file of a run that was started without a job file.

    ``data``: the values of its command line, in the form of a job. ``options``: every option of the
    control with its final value. ``assumed``: the assumptions that the run lists. ``by_files``:
    values of axis keys from the control's files.
    """
    ((axis, section),) = data["axes"].items()
    left = [entry for entry in assumed if entry.fact.startswith(_OPTION)]
    lines = [
        *(_JobLine(f"# {line}") for line in _HEADING),
        _JobLine("compwright: 1"),
        _JobLine(
            "# machine: {name: VMC 850, serial: 1111111}", "not given; for report and history"
        ),
        _JobLine("controller:"),
        _JobLine(f"  format: {flow(data['controller']['format'])}", "--format"),
        *_options(data["controller"]["options"], left, options),
        *_states(data),
        _JobLine("axes:"),
        _JobLine(f"  {word(axis)}:", "--axis"),
        *_axis(section, axis, by_files),
        *(_JobLine(f"{key}: {flow(value)}", f"assumed: {what}") for key, value, what in _OF_JOB),
        *(
            _JobLine(f"# also assumed: {entry.fact} = {entry.value}", entry.evidence)
            for entry in [entry for entry in assumed if entry not in left]
        ),
    ]
    return "\n".join(_aligned(lines)) + "\n"


def _options(
    given: Mapping[str, object], left: Sequence[Assumption], values: Mapping[str, object]
) -> Iterator[_JobLine]:
    """Yield the control's options as lines: the ``given`` options, and as comments the assumptions
    about options that are ``left`` out, with their ``values``.
    """
    yield from [_JobLine("  options:")] if given else []
    for name, value in given.items():
        yield _JobLine(f"    {word(name)}: {flow(value)}", f"--option {name}")
    if left and not given:
        yield _JobLine("#   options:")
    for entry in left:
        name = entry.fact.removeprefix(_OPTION)
        value = values.get(name)
        shown = "" if value is None else f" {flow(value)}"
        yield _JobLine(f"#     {word(name)}:{shown}", f"assumed: {entry.value}, {entry.evidence}")


def _states(data: Mapping[str, Any]) -> Iterator[_JobLine]:
    if "states" not in data:
        yield _JobLine(
            f"# states: {{{AS_FOUND}: none}}",
            "not given: no table is written without it; the control's files, or the word none",
        )
        return
    state = data["states"][AS_FOUND]
    yield _JobLine("states:")
    if isinstance(state, Mapping):
        yield _JobLine(f"  {AS_FOUND}:", "--state: what is in the control now")
        yield from _listed("files", state["files"], 4, "--state")
        yield _JobLine(f"    active: {flow(state['active'])}", "--option active")
    elif len(state) == 1:
        yield _JobLine(f"  {AS_FOUND}: {flow(state[0])}", "--state: what is in the control now")
    else:
        yield from _listed(AS_FOUND, state, 2, "--state: what is in the control now")


def _listed(key: str, files: Sequence[str], indent: int, source: str) -> Iterator[_JobLine]:
    yield _JobLine(f"{' ' * indent}{key}:", source)
    for file in files:
        yield _JobLine(f"{' ' * indent}  - {flow(file)}")


def _option(key: str) -> str:
    """Return the command-line option that sets a key of an axis."""
    return {"encoder": "--option encoder_system", "table": "--option spacing, mode"}.get(
        key, f"--option {key}"
    )


def _axis(
    section: Mapping[str, Any], name: str, by_files: Mapping[str, object]
) -> Iterator[_JobLine]:
    yield _JobLine(f"    travel: {flow(section['travel'])}", "--travel: machine coordinates")
    if "address" not in section:
        yield _JobLine(f"    address: {flow(name)}", "assumed: the control calls the axis so too")
    for key, value in section.items():
        if key not in ("travel", "before"):
            yield _JobLine(f"    {key}: {flow(value)}", _option(key))
    for key, value, what in _left_out(section, by_files):
        yield _JobLine(f"    {key}: {flow(value)}", f"assumed: {what}")
    yield from (
        _JobLine(f"#     {line}") for line in _OPEN if line.partition(":")[0] not in section
    )
    yield _JobLine("    before:")
    (test,) = section["before"]
    if len(test["files"]) == 1:
        yield _JobLine(f"      - files: {flow(test['files'])}", "FILE: the test")
    else:
        yield _JobLine("      - files:", "FILE: the files of one test")
        for file in test["files"]:
            yield _JobLine(f"          - {flow(file)}")
    if "profile" in test:
        yield _JobLine(f"        profile: {flow(test['profile'])}", "--profile")
    for key, value, what in _OF_TEST:
        yield _JobLine(f"        {key}: {flow(value)}", f"assumed: {what}")


#: Column of the comments; a longer line has its comment two blanks behind it.
_COLUMN = 44


def _aligned(lines: Sequence[_JobLine]) -> Iterator[str]:
    for line in lines:
        yield f"{line.text:{_COLUMN}}  # {line.source}" if line.source else line.text
