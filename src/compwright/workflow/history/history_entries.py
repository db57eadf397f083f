"""Read the tests of a result folder as entries of a history."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from compwright.foundations.dates import day_of
from compwright.foundations.provenance import fingerprint
from compwright.foundations.utf8 import encoded, shown_path
from compwright.jobs.next_job import number_of_round
from compwright.records.history import HistoryEntry
from compwright.workflow.history.result_folders import ResultFolder

#: Placeholder that ``new`` writes for a name.
_NOT_GIVEN = "not given"


def entries_of(folder: ResultFolder) -> list[HistoryEntry]:
    """Return the tests of a result folder as entries of a history."""
    return list(_entries(folder))


def _entries(folder: ResultFolder) -> Iterator[HistoryEntry]:
    record = folder.record
    machine = {key: _named(record["machine"].get(key)) for key in ("name", "serial")}
    verification = record["verification"] or {}
    for number, test in enumerate(sorted(record["tests"], key=_round)):
        circular = test["kind"] == "circular"
        date = _text(test["date"])
        table, files_hash = _active_compensation(record, test, _of_axes(verification, test))
        yield HistoryEntry(
            folder=shown_path(folder.path),
            number=number,
            machine=machine["name"],
            serial=machine["serial"],
            what=_text(test["plane"] if circular else test["axis"]),
            kind="circular" if circular else "positioning",
            rotary=not circular and test["axis_kind"] == "rotary",
            test=_text(test["name"]),
            taken="after" if test["taken"] == "after" else "before",
            date=date,
            day=day_of(date),
            unit=str(test["unit"]),
            standard=str(test["standard"]),
            values=_values(test),
            errors=_errors(test),
            declared={
                _text(name): (float(stated["U"]), float(stated["coverage"]))
                for name, stated in test.get("uncertainty", {}).items()
                if stated["U"] is not None
            },
            targets=_numbers(test, "targets"),
            means=(_numbers(test, "mean_positive"), _numbers(test, "mean_negative")),
            table=table,
            acting=files_hash,
            verdict=str(verification["verdict"]) if test["taken"] == "after" else "",
            sources=tuple(str(source) for source in test["sources"]),
            simulated=bool(test["simulated"]),
            instrument=_text(test.get("instrument", "")),
            limits=_limits(record, test),
        )


def _round(test: Mapping[str, Any]) -> tuple[bool, int]:
    """Return a sort key that orders tests by their round of compensation, earlier rounds first."""
    state = str(test.get("measured_in", ""))
    over = number_of_round(state) if test["taken"] == "before" else None
    return over is None, over or 0


def _named(value: object) -> str:
    text = "" if value is None else _text(value).strip()
    return "" if text.lower() == _NOT_GIVEN else text


def _text(value: object) -> str:
    """Return a value as text that can be written as UTF-8, because a record edited by hand can
    contain invalid characters.
    """
    return encoded(str(value)).decode()


def _values(test: Mapping[str, Any]) -> dict[str, float]:
    found = dict(test["parameters"])
    if test["kind"] == "circular":
        found["squareness"] = (test["squareness"] or {}).get("value")
    else:
        found["s"] = test["s"]
    return {_text(name): float(value) for name, value in found.items() if value is not None}


def _numbers(test: Mapping[str, Any], key: str) -> tuple[float, ...]:
    return tuple(float(value) for value in test.get(key, ()))


def _limits(record: Mapping[str, Any], test: Mapping[str, Any]) -> dict[str, float]:
    """Return, by parameter, the limits that the job states for the axis or the circle of a test."""
    kind, name = ("circles", "name") if test["kind"] == "circular" else ("axes", "axis")
    decided = record.get("decisions", {}).get(kind, {}).get(test[name], {})
    return {
        _text(parameter): float(entry["limit"])
        for parameter, entry in decided.get("accept", {}).items()
    }


def _errors(test: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    if test["kind"] != "circular":
        return {
            _text(name): (float(error["value"]), float(error["dof"]))
            for name, error in test["std_error"].items()
        }
    error = (test["squareness"] or {}).get("std_error")
    return {} if error is None else {"squareness": (float(error), 1e9)}


def _of_axes(verification: Mapping[str, Any], test: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Return the verification results of the axis of a positioning test; for a circular test, those
    of all axes in the verification.
    """
    axes = verification.get("axes", {})
    if test["kind"] == "circular":
        return list(axes.values())
    return [axes[test["axis"]]] if test["axis"] in axes else []


def _active_compensation(
    record: Mapping[str, Any], test: Mapping[str, Any], verified: Sequence[Mapping[str, Any]]
) -> tuple[str, str]:
    """Return which compensation was active in a test, and the SHA-256 of the control's files that
    contain it; "" if unknown.
    """
    if test["taken"] == "after":
        tables = [
            str(entry["sha256"])
            for entry in record["files"]
            if str(entry["file"]).startswith("tables/")
        ]
        verdicts = [str(axis["loading"]["verdict"]) for axis in verified]
        there = all(
            verdict == "loaded" or (verdict == "undecided" and axis.get("read_back") == "equal")
            for verdict, axis in zip(verdicts, verified, strict=True)
        )
        alike = set(verdicts)
        word = alike.pop() if len(alike) == 1 else "as planned"
        return word, _joined(tables) if there and verified and tables else ""
    state = str(test["measured_in"])
    if state not in record["states"]:
        return "not given", ""
    files = [
        str(entry["sha256"])
        for entry in record["inputs"]
        if entry["role"] == "state" and entry["of"] == state
    ]
    return ("as found", _joined(files)) if files else ("none", "none")


def _joined(digests: list[str]) -> str:
    return fingerprint(" ".join(sorted(digests)).encode("ascii"))
