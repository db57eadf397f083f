"""Summarise many tests: how many there are, how large each parameter is on each axis, how often
each finding occurs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from statistics import median
from typing import Any, Final

#: What stands for a test where one number has to: the first of these that it has. Accuracy A,
#: positional uncertainty P (VDI), circular deviation G.
_SIZES: Final = ("A", "P", "G_bidirectional", "G_ccw", "G_cw", "A_positive", "A_negative")
_SEVERITIES: Final = ("error", "warning", "info")


def summary_document(document: Mapping[str, Any]) -> dict[str, Any]:
    """Return the summary of an evaluation document.

    - ``tests``, ``files``, ``unread``: number of tests, of files read and of files with an error.
    - ``groups``: one entry for each kind of test, axis (or plane of a circle) and unit, with the
      number of ``tests`` and ``sizes``.
    - ``sizes`` of a group: for each parameter the number of ``tests``, the ``smallest``, ``median``
      and ``largest`` value, and the ``file`` of the largest. Each test is counted with only one
      parameter.
    - ``findings``: ``code``, ``severity``, number of ``tests`` and first ``file`` of each finding.
      Severe findings come first, then frequent ones.
    """
    results = document["results"]
    return {
        "tests": len(results),
        "files": len({source["file"] for result in results for source in result["sources"]}),
        "unread": len({error["file"] for error in document["errors"]}),
        "groups": [
            _group(key, some) for key, some in sorted(_grouped(results).items(), key=_axes_first)
        ],
        "findings": _findings(results),
    }


def _grouped(
    results: Iterable[Mapping[str, Any]],
) -> dict[tuple[str, str, str], list[Mapping[str, Any]]]:
    groups: dict[tuple[str, str, str], list[Mapping[str, Any]]] = {}
    for result in results:
        axis = result["plane"] if result["kind"] == "circular" else result["axis"]
        groups.setdefault((result["kind"], axis, result["unit"]), []).append(result)
    return groups


def _axes_first(group: tuple[tuple[str, str, str], object]) -> tuple[bool, str, str]:
    (kind, axis, unit), _ = group
    return kind == "circular", axis, unit


def _group(key: tuple[str, str, str], results: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    kind, axis, unit = key
    sizes: dict[str, list[tuple[float, str]]] = {}
    for result in results:
        parameters = result["parameters"]
        name = next((name for name in _SIZES if parameters.get(name) is not None), None)
        if name is not None:
            sizes.setdefault(name, []).append((parameters[name], first_file(result)))
    return {
        "kind": kind,
        "axis": axis,
        "unit": unit,
        "tests": len(results),
        "sizes": {name: _size(values) for name, values in sizes.items()},
    }


def _size(values: Sequence[tuple[float, str]]) -> dict[str, Any]:
    numbers = [value for value, _ in values]
    largest = max(numbers)
    return {
        "tests": len(numbers),
        "smallest": min(numbers),
        "median": median(numbers),
        "largest": largest,
        "file": next(file for value, file in values if value == largest),
    }


def _findings(results: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    found: dict[tuple[str, str], dict[str, Any]] = {}
    for result in results:
        for key in dict.fromkeys((one["severity"], one["code"]) for one in result["findings"]):
            severity, code = key
            entry = found.setdefault(
                key,
                {"code": code, "severity": severity, "tests": 0, "file": first_file(result)},
            )
            entry["tests"] += 1
    return sorted(
        found.values(),
        key=lambda entry: (_SEVERITIES.index(entry["severity"]), -entry["tests"], entry["code"]),
    )


def first_file(result: Mapping[str, Any]) -> str:
    """Return the first file of a test, or the name of the test if no file is known."""
    return str(result["sources"][0]["file"] if result["sources"] else result["name"])
