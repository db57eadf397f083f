"""Make the job of the next round from the last job and the control files that were read back after
loading.

Only what changes is changed in the data of the job file. All else stays as the engineer wrote it:
axes, options, grid, uncertainty, expansion and limits.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from compwright.jobs.plain_data import default_name
from compwright.records.job import AS_FOUND

#: What stands for a round that is over: its state, and behind the names of its tests.
_ROUND = re.compile(r"round_(\d+)")
#: A job says the temperature of a test by itself, or the files of the test do.
TEMPERATURES = ("T_m", "T_d")


@dataclass(frozen=True, slots=True, kw_only=True)
class NextAxis:
    """What the job of the next round states differently for one axis, such as its tests.

    ``before``: its tests; the test after loading is the first. ``resolved``: keys of the axis that
    the last job did not give and the control's files of the last round answered. ``limited``: the
    test to which the limits apply, if it is not the first one any more.
    """

    before: Sequence[Mapping[str, Any]]
    resolved: Mapping[str, Any] = field(default_factory=dict)
    limited: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class NextRound:
    """What the job of the next round states differently from the last job.

    ``paths``: the paths of the copies of profiles, stand-still tests and the logo, by their paths
    in the last job. ``squareness``: the planes whose squareness is corrected again.
    """

    format: str
    states: Mapping[str, Any]
    axes: Mapping[str, NextAxis]
    circles: Sequence[Mapping[str, Any]] = ()
    squareness: Sequence[str] = ()
    paths: Mapping[str, str] = field(default_factory=dict)


def name_of_round(states: Sequence[str]) -> str:
    """Return the name under which the next job lists the state of the control in the last round:
    ``round_1``, or a number one higher than those in ``states``.
    """
    numbers = [number_of_round(name) or 0 for name in states]
    return f"round_{max(numbers, default=0) + 1}"


def number_of_round(state: str) -> int | None:
    """Return the number in the name of a past round, such as 1 for ``round_1``, else None."""
    found = _ROUND.fullmatch(state)
    return int(found[1]) if found else None


def test_sections(section: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the tests of an axis as mappings with the keys ``files`` (a list) and ``name``."""
    before = section.get("before", [])
    entries = before if isinstance(before, list) else [before]
    found = []
    for entry in entries:
        test = {"files": entry} if isinstance(entry, str) else dict(entry)
        files = test["files"] if isinstance(test["files"], list) else [test["files"]]
        found.append({"name": default_name(files[0]), **test, "files": files})
    return found


def earlier_test(
    section: Mapping[str, Any], files: Sequence[str], name: str, was: str, paths: Mapping[str, str]
) -> dict[str, Any]:
    """Return the section of a test of the last job, as an earlier test of the next job, with a new
    ``name``. ``was``: the new name of the state ``as_found``; ``paths``: new paths of copied files.
    """
    measured_in = str(section.get("measured_in", AS_FOUND))
    return {
        **_copied(section, files, paths),
        "name": name,
        "measured_in": was if measured_in == AS_FOUND else measured_in,
    }


def test_after(
    section: Mapping[str, Any],
    files: Sequence[str],
    temperatures: Mapping[str, Sequence[float]],
    paths: Mapping[str, str],
) -> dict[str, Any]:
    """Return the section of the test after loading for the next job. It has the keys of the
    repeated test's ``section``; new ``files``, ``temperatures`` and ``paths`` (of copied files)
    replace the old ones.
    """
    test = {**_copied(section, files, paths), "measured_in": AS_FOUND}
    own = test.get("thermal")
    if isinstance(own, dict):
        test["thermal"] = {
            key: list(temperatures[key]) if key in temperatures else value
            for key, value in own.items()
        }
    return test


def _copied(
    section: Mapping[str, Any], files: Sequence[str], paths: Mapping[str, str]
) -> dict[str, Any]:
    test = {**section, "files": list(files)}
    if "profile" in test:
        test["profile"] = paths.get(test["profile"], test["profile"])
    return test


def next_job(data: Mapping[str, Any], then: NextRound) -> dict[str, Any]:
    """Return the data of the next job, made from the ``data`` of the last job and from ``then``,
    what is different in the next job.

    Direct measurements between axes are left out. They were taken before loading, and the control
    now contains their correction. The key ``apply`` keeps only the corrections that ``then`` makes
    again.
    """
    job = {key: value for key, value in data.items() if key not in {"cross", "circles", "apply"}}
    job["controller"] = {**data["controller"], "format": then.format}
    job["states"] = dict(then.states)
    job["axes"] = {
        name: _axis(section, then.axes[name])
        for name, section in data["axes"].items()
        if name in then.axes
    }
    if "acknowledged" in job:
        job["acknowledged"] = dict(_acknowledged(job["acknowledged"], job["axes"]))
    if "environment" in job:
        copied = [then.paths.get(file, file) for file in environment_files(job["environment"])]
        of_record = job["environment"] if isinstance(job["environment"], dict) else {}
        job["environment"] = {**of_record, "files": copied}
    if "uncertainty" in job:
        job["uncertainty"] = _uncertainty(job["uncertainty"], then.paths)
    if "logo" in job.get("report", {}):
        logo = job["report"]["logo"]
        job["report"] = {**job["report"], "logo": then.paths.get(logo, logo)}
    if then.circles:
        job["circles"] = [dict(circle) for circle in then.circles]
        job |= _applied(data.get("apply", {}), then)
    return job


def _axis(section: Mapping[str, Any], then: NextAxis) -> dict[str, Any]:
    axis = {key: value for key, value in section.items() if key != "table"}
    for key, value in then.resolved.items():
        axis[key] = {**value, **axis.get(key, {})} if isinstance(value, Mapping) else value
    axis["before"] = [dict(test) for test in then.before]
    if not then.before:
        axis.pop("accept", None)
        return axis
    if then.limited is not None:
        axis["accept"] = {"test": then.limited, **axis["accept"]}
    # A grid that was chosen is in the control now, and stays.
    table = dict(section.get("table", {}))
    if table.get("spacing") == "auto":
        del table["spacing"]
    return {**axis, "table": {**table, "gain": "seen"}}


def _acknowledged(section: Mapping[str, Any], axes: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield those acknowledgements that concern axes in the next job."""
    for code, given in section.items():
        kept = [
            entry
            for entry in (given if isinstance(given, list) else [given])
            if not isinstance(entry, dict) or entry.get("axis", "") in {"", *axes}
        ]
        if kept:
            yield code, kept


def environment_files(section: Any) -> list[str]:
    """Return the files of an environment record, from any form that the job allows."""
    files = section.get("files", []) if isinstance(section, dict) else section or []
    return files if isinstance(files, list) else [files]


def _uncertainty(section: Mapping[str, Any], paths: Mapping[str, str]) -> dict[str, Any]:
    """Return the job's uncertainty section with the paths of the copied stand-still tests."""
    found = dict(section)
    if isinstance(found.get("rotary"), dict):
        found["rotary"] = _uncertainty(found["rotary"], paths)
    variation = found.get("E_VE")
    if isinstance(variation, str):
        found["E_VE"] = paths.get(variation, variation)
    elif isinstance(variation, dict):
        found["E_VE"] = {**variation, "file": paths.get(variation["file"], variation["file"])}
    return found


def _applied(section: Mapping[str, Any], then: NextRound) -> dict[str, Any]:
    """Return the key ``apply`` of the next job: the squareness of planes whose circles are
    repeated, and the source of lost motion.
    """
    planes = section.get("squareness", {})
    kept = {plane: bent for plane, bent in planes.items() if plane in then.squareness}
    found: dict[str, Any] = {"squareness": kept} if kept else {}
    if "backlash_from" in section:
        found["backlash_from"] = section["backlash_from"]
    return {"apply": found} if found else {}
