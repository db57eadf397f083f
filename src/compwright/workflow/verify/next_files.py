"""The input files of the next round: its job, and copies of all files that it names."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from compwright.controls.definitions import files_of_definition
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import JOB as JOB_FILE
from compwright.foundations.session import Session
from compwright.foundations.yaml_reader import read_yaml
from compwright.instruments.circular_reading import read_circular
from compwright.jobs.next_job import (
    TEMPERATURES,
    NextAxis,
    NextRound,
    earlier_test,
    environment_files,
    name_of_round,
    next_job,
    test_after,
    test_sections,
)
from compwright.jobs.writing import data_text
from compwright.records.correction import ControlFile
from compwright.records.job import AS_FOUND, Job
from compwright.records.plan import Plan
from compwright.records.positioning import PositioningTest
from compwright.verification.proof import AfterTest
from compwright.workflow.inputs.measurement_files import measurement_files

JOB = "job.yaml"
#: Folders of the next round that hold nothing but its inputs.
STATES, MEASUREMENTS, DEFINITION = "control", "measurements", "definition"
_HEADING = (
    "The next round, written by compwright verify --update. It stands alone: all that it names is",
    "a copy in this folder. as_found is what was read back from the control after loading; the",
    "tests after loading come first, those before count with them, each without the compensation",
    "that was active in it.",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Looped:
    """The results of this round that become inputs of the next round.

    - ``axes``: the tests after loading of the axes that may be corrected further. ``other_axes``:
      further axes of circles.
    - ``files``: the present files of the control. ``active``: whether their tables were active, as
      measured.
    - ``circles``: the files of circles after loading, by name. ``squareness``: planes that may be
      corrected further.
    """

    axes: Mapping[str, AfterTest]
    files: Sequence[ControlFile]
    active: bool | None = None
    other_axes: Sequence[str] = ()
    circles: Mapping[str, Sequence[Path]] = field(default_factory=dict)
    squareness: Sequence[str] = ()


@dataclass(slots=True)
class _Copies:
    """The contents of copied files by their names in the next round's folder."""

    files: dict[str, bytes] = field(default_factory=dict)

    def add(self, folder: str, name: str, content: bytes) -> str:
        """Add a copy of a file, and return its name."""
        plain = PurePosixPath("".join(each if _writable(each) else "_" for each in name) or "_")
        taken = {each.casefold() for each in self.files}
        number, found = 1, f"{folder}/{plain}"
        while found.casefold() in taken:
            number += 1
            found = f"{folder}/{plain.stem}_{number}{plain.suffix}"
        self.files[found] = content
        return found


def _writable(character: str) -> bool:
    return character.isprintable() and character not in '/\\:*?"<>|'


def _folder(*names: str) -> str:
    """Return names as a path of nested folders, with ``_`` in place of special characters."""
    plain = (re.sub(r"[^\w+-]", "_", name) or "_" for name in names)
    return "/".join(plain)


def next_files(session: Session, job: Job, plan: Plan, then: Looped) -> dict[str, bytes]:
    """Return every input of the next round by its relative name, the job first. ``then``: the
    results of this round that become inputs.

    Raises InputError if a measurement of the last round no longer exists.
    """
    file = Path(job.file)
    data = read_yaml(storage.read_bytes(session, file, JOB_FILE), job.file).data
    copies = _Copies()
    was = name_of_round([*job.states, *plan.states])
    paths = _files_with_tests(session, data, file.parent, copies)
    round_ = NextRound(
        format=_definition(data["controller"]["format"], plan, copies),
        states=_states(job, plan, then, was, copies),
        axes={
            **{
                name: _axis(session, data["axes"][name], job, after, was, paths, copies)
                for name, after in then.axes.items()
            },
            # Axes that keep what is in the control, and that circles speak of.
            **{
                name: NextAxis(before=(), resolved=_resolved(data["axes"][name], job, name))
                for name in then.other_axes
            },
        },
        circles=_circles(session, job, plan, then, was, copies),
        squareness=then.squareness,
        paths=paths,
    )
    return {JOB: data_text(next_job(data, round_), _HEADING).encode(), **copies.files}


def _states(job: Job, plan: Plan, then: Looped, was: str, copies: _Copies) -> dict[str, Any]:
    """Return the states of the control for the next job: the present one (from ``then``, the
    results of this round), the one before loading (now called ``was``), and all older ones.
    """
    found: dict[str, Any] = {AS_FOUND: _state(then.files, AS_FOUND, copies, active=then.active)}
    for name, files in plan.states.items():
        now = was if name == AS_FOUND else name
        found[now] = _state(files, now, copies, active=job.active.get(name))
    return found


def _state(files: Sequence[ControlFile], name: str, copies: _Copies, *, active: bool | None) -> Any:
    if not files:
        return "none"
    folder = f"{STATES}/{_folder(name)}"
    listed = [copies.add(folder, file.name, file.raw) for file in files]
    if active is None:
        return listed
    return {"files": listed, "active": "yes" if active else "no"}


def _axis(
    session: Session,
    section: Mapping[str, Any],
    job: Job,
    after: AfterTest,
    was: str,
    paths: Mapping[str, str],
    copies: _Copies,
) -> NextAxis:
    """Return the keys of an axis for the next job, in which its test after loading is the new test
    before loading. ``was``: the next job's name for the state before loading; ``paths``: the paths
    of copied profiles by their paths in the job.
    """
    sections = test_sections(section)
    names = [str(each["name"]) for each in sections]
    old = f"{after.repeats}_{was}"
    while old in names:
        old += "_"
    tests: list[Mapping[str, Any]] = []
    for each, name in zip(sections, names, strict=True):
        now = old if name == after.repeats else name
        folder = f"{MEASUREMENTS}/{_folder(after.axis, now)}"
        files = [storage.named_from(Path(job.file).parent, text) for text in each["files"]]
        tests.append(earlier_test(each, _measured(session, files, folder, copies), now, was, paths))
    repeated = sections[names.index(after.repeats)]
    folder = f"{MEASUREMENTS}/{_folder(after.axis, after.repeats)}"
    first = test_after(
        repeated, _measured(session, after.files, folder, copies), _temperatures(after.test), paths
    )
    if after.profile is not None:
        content = storage.read_bytes(session, after.profile)
        first["profile"] = copies.add(MEASUREMENTS, after.profile.name, content)
    limits = section.get("accept")
    moved = limits is not None and "test" not in limits and names[0] != after.repeats
    return NextAxis(
        before=[first, *tests],
        resolved=_resolved(section, job, after.axis),
        limited=names[0] if moved else None,
    )


def _measured(session: Session, paths: Iterable[Path], folder: str, copies: _Copies) -> list[str]:
    """Return copies of measurement files. From a folder only the measurements are copied."""
    found = [path for given in paths for path in measurement_files(session, given).files]
    return [copies.add(folder, path.name, storage.read_bytes(session, path)) for path in found]


def _temperatures(test: PositioningTest) -> dict[str, tuple[float, float]]:
    """Return the temperatures (°C) at the start and at the end of a test that were used to remove
    thermal expansion from it.
    """
    thermal = test.thermal
    if thermal is None:
        return {}
    means, rises = (thermal.T_m, thermal.T_d), (thermal.rise_m, thermal.rise_d)
    return {
        name: (mean - rise / 2.0, mean + rise / 2.0)
        for name, mean, rise in zip(TEMPERATURES, means, rises, strict=True)
    }


def _resolved(section: Mapping[str, Any], job: Job, name: str) -> dict[str, Any]:
    """Return those job keys of an axis (such as ``address``) whose values the control's files had
    supplied because the job did not state them.
    """
    axis = job.axes[name].axis
    found: dict[str, Any] = {}
    if str(section.get("address", name)) != axis.address:
        found["address"] = axis.address
    if axis.options:
        found["options"] = dict(axis.options)
    if axis.encoder.stated and "system" not in section.get("encoder", {}):
        found["encoder"] = {"system": axis.encoder.system}
    if axis.zero_at_reference:
        found["reference"] = axis.reference
        found["reference_return"] = axis.reference_return.value
    return found


def _circles(
    session: Session, job: Job, plan: Plan, then: Looped, was: str, copies: _Copies
) -> list[dict[str, Any]]:
    """Return the circular tests for the next job: those after loading (from ``then``, the results
    of this round), and earlier ones that were not repeated.

    If a correction between axes is in no file of the control, it was not active in the earlier
    circles, so these are left out.
    """
    unseen = [entry.pair for entry in plan.cross if not entry.written]
    found = []
    for request in job.circles:
        axes = frozenset(plan.circles[request.name].test.axes)
        again = then.circles.get(request.name)
        if not axes <= {*then.axes, *then.other_axes} or (again is None and axes in unseen):
            continue
        state = was if request.measured_in == AS_FOUND else request.measured_in
        files = (
            [storage.named_from(Path(job.file).parent, text) for text in request.files]
            if again is None
            else list(again)
        )
        found.append(
            {
                **_runs(session, files, f"{MEASUREMENTS}/{_folder(request.name)}", copies),
                "name": request.name,
                "measured_in": state if again is None else AS_FOUND,
                **({} if request.centre is None else {"centre": list(request.centre)}),
                **({} if request.accept is None else {"accept": dict(request.accept.limits)}),
            }
        )
    return found


def _runs(session: Session, paths: Iterable[Path], folder: str, copies: _Copies) -> dict[str, str]:
    """Return the copied files of a circular test: one file, or one for each direction."""
    files = [path for given in paths for path in measurement_files(session, given).files]
    contents = [storage.read_bytes(session, path) for path in files]
    names = [
        copies.add(folder, path.name, content)
        for path, content in zip(files, contents, strict=True)
    ]
    if len(names) == 1:
        return {"file": names[0]}
    senses = [
        {run.sense for run in read_circular(content, str(path)).runs}
        for path, content in zip(files, contents, strict=True)
    ]
    if sorted(map(sorted, senses)) != [["ccw"], ["cw"]]:
        raise InputError(
            Fault(
                message="the job of the next correction round needs one file with both directions "
                "of a circle, or one file for each direction; these files are neither",
                file=", ".join(map(str, files)),
                expected="one file with ccw and cw, or a ccw file and a cw file",
                hint="give the circle in such files with `--after`, or leave `--update` out",
            )
        )
    return {next(iter(sense)): name for sense, name in zip(senses, names, strict=True)}


def _files_with_tests(
    session: Session, data: Mapping[str, Any], folder: Path, copies: _Copies
) -> dict[str, str]:
    """Return the paths of copied profiles, stand-still tests, environment records and logo."""
    tests = [test for axis in data["axes"].values() for test in test_sections(axis)]
    named = [test["profile"] for test in tests if "profile" in test]
    logo = data.get("report", {}).get("logo")
    named += [logo] if isinstance(logo, str) else []
    named += environment_files(data.get("environment"))
    of_job = data.get("uncertainty", {})
    for section in (of_job, of_job.get("rotary", {})):
        variation = section.get("E_VE")
        text = variation.get("file") if isinstance(variation, dict) else variation
        named += [text] if isinstance(text, str) else []
    return {
        text: copies.add(
            MEASUREMENTS,
            PureWindowsPath(text).name,
            storage.read_bytes(session, storage.named_from(folder, text)),
        )
        for text in dict.fromkeys(named)
    }


def _definition(name: str, plan: Plan, copies: _Copies) -> str:
    """Return the control's id, or the copied path of the user's own control definition.

    Raises InputError if that definition extends another one that is outside of its folder.
    """
    if not plan.definition:
        return name
    carried = files_of_definition(plan.definition)
    copies.files |= {f"{DEFINITION}/{listed}": content for listed, content in carried.items()}
    return f"{DEFINITION}/{next(iter(carried))}"
