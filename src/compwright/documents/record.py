"""The file ``record.json``: inputs, software, decisions and results of a result folder.

Its schema is ``compwright/record/1``. It contains only the dates that the measurement files state,
so that the same input gives the same bytes.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, replace
from typing import Any

from compwright.documents.json_text import AS_WRITTEN, read_json, to_json
from compwright.documents.record_reading import faults_of_record
from compwright.documents.recorded_test import PARAMETERS, Errors, measured_test
from compwright.foundations.errors import InputError, raise_all
from compwright.foundations.provenance import fingerprint
from compwright.foundations.utf8 import encoded
from compwright.records.input_record import RecordedInput

SCHEMA = "compwright/record/1"
RECORD = "record.json"
#: Where the copies of what ``verify`` was given lie.
COPIES_OF_VERIFY = "inputs/verify/"
#: The last entry of a record: the SHA-256 of all others.
_SEAL = "sha256"
#: In its place once an edited record was completed: it stays one that was edited.
_EDITED = "edited"


def definition_entry(definition_id: str, data: Any, files: Iterable[str], *, own: bool) -> Any:
    """Return a record's entry on the control definition: id, SHA-256 of the definition ``data``,
    file names, and whether it is the user's own.
    """
    text = json.dumps(data, sort_keys=True, ensure_ascii=False, default=str)
    return {
        "id": definition_id,
        "sha256": fingerprint(encoded(text)),
        "files": sorted(set(files)),
        "own": own,
    }


def run_record(
    about: Mapping[str, Any],
    inputs: Sequence[RecordedInput],
    files: Mapping[str, bytes],
    *,
    evaluation: Mapping[str, Any],
    prediction: Mapping[str, Any],
    measured_in: Mapping[str, str],
    errors: Errors,
) -> dict[str, Any]:
    """Return the record of a run (``record.json``): inputs, software, decisions and results.
    ``about``: the entries on software, machine, control and rules.

    ``files``: all files that the run writes, by name. ``evaluation``, ``prediction``: the documents
    of the run. ``measured_in``, ``errors``: see `measured_test`.
    """
    plan = files.get("plan.json")
    return {
        "schema": SCHEMA,
        **about,
        "inputs": [asdict(entry) for entry in inputs],
        "plan": None if plan is None else {"file": "plan.json", "sha256": fingerprint(plan)},
        "files": files_listed(files),
        "tests": [
            measured_test(result, "before", measured_in, errors) for result in evaluation["results"]
        ],
        "decisions": {
            "axes": {name: _decided(axis) for name, axis in prediction["axes"].items()},
            **_of_circles(prediction["circles"]),
        },
        "doubts": list(prediction["doubts"]),
        "verification": None,
    }


def planned_record(
    about: Mapping[str, Any], plan: str, evaluation: Mapping[str, Any], errors: Errors
) -> dict[str, Any]:
    """Return a record made from the plan of a run whose record file is missing. ``about``: the
    entries on software, machine, control and rules; ``plan``: the SHA-256 of the plan.
    """
    return {
        "schema": SCHEMA,
        **about,
        "inputs": [],
        "plan": {"file": "plan.json", "sha256": plan},
        "files": [],
        "tests": [measured_test(result, "before", {}, errors) for result in evaluation["results"]],
        "decisions": {"axes": {}},
        "doubts": [],
        "verification": None,
    }


def elsewhere(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return a run's record for use in another folder; it lists no files, as these are only in the
    run's folder.
    """
    inputs = [{**entry, "copy": None} for entry in record["inputs"]]
    return {**record, "inputs": inputs, "files": []}


def files_listed(files: Mapping[str, bytes]) -> list[dict[str, Any]]:
    """Return hash and size of the files in a result folder, by relative name."""
    return [
        {
            "file": encoded(name).decode("utf-8"),
            "sha256": fingerprint(content),
            "size": len(content),
        }
        for name, content in sorted(files.items())
    ]


def _decided(axis: Mapping[str, Any]) -> dict[str, Any]:
    predicted = axis.get("predicted") or {}
    return {
        "table": "written" if axis["table"] is not None else "none",
        "judged": axis.get("judged"),
        "predicted": {name: predicted[name] for name in PARAMETERS if name in predicted},
        "accept": dict(axis["accept"]),
        "limits": list(axis["limits"]),
    }


def _of_circles(circles: Mapping[str, Any]) -> dict[str, Any]:
    """Return the record's entry ``circles``: the decisions on circular tests with limits; empty if
    no test has limits.
    """
    limited = {
        name: {"accept": dict(circle["accept"])}
        for name, circle in circles.items()
        if circle["accept"]
    }
    return {"circles": limited} if limited else {}


def verified_record(
    record: Mapping[str, Any],
    inputs: Sequence[RecordedInput],
    files: Mapping[str, bytes],
    *,
    verification: Mapping[str, Any],
    evaluation: Mapping[str, Any],
    version: str,
    errors: Errors,
) -> dict[str, Any]:
    """Return the record of a run with a verification, in place of an earlier verification.

    ``record``: the record of the run. ``inputs``, ``files``: all files that ``verify`` reads and
    writes. ``verification``: the document of ``verify``. ``evaluation``: the document of the tests
    after loading. ``errors``: see `measured_test`.
    """
    before = [entry for entry in record["tests"] if entry["taken"] == "before"]
    after = [measured_test(result, "after", {}, errors) for result in evaluation["results"]]
    listed = {entry["file"]: entry for entry in record["files"] if entry.get("by") != "verify"}
    own = {entry["file"]: {**entry, "by": "verify"} for entry in files_listed(files)}
    axes = {name: _verified(axis) for name, axis in verification["axes"].items()}
    circles = {
        name: circle["squareness"]
        for name, circle in verification["circles"].items()
        if circle["squareness"] is not None
    }
    return {
        **record,
        _SEAL: None if is_as_written(record) else _EDITED,
        "inputs": [
            *(entry for entry in record["inputs"] if entry["by"] != "verify"),
            *(asdict(entry) for entry in inputs),
        ],
        "files": [listed[name] for name in sorted(listed.keys() - own.keys())]
        + [own[name] for name in sorted(own)],
        "tests": [*before, *after],
        "verification": {
            "version": version,
            "verdict": verification["verdict"],
            "read_back": any(entry.role == "loaded" for entry in inputs),
            "axes": axes,
            "squareness": circles,
            **_of_circles(verification["circles"]),
            "doubts": list(verification["doubts"]),
        },
    }


def kept_verification(record: Mapping[str, Any], earlier: Mapping[str, Any]) -> dict[str, Any]:
    """Return the record of a repeated run, with the earlier verification if the plan is the same.

    If the plan is different, or the earlier record was edited, only the copies of the measurements
    after loading are kept, because they may exist nowhere else.
    """
    of_verify = [entry for entry in earlier["files"] if entry.get("by") == "verify"]
    own = {entry["file"] for entry in record["files"]}
    if not _goes_on(record, earlier):
        of_verify = [entry for entry in of_verify if entry["file"].startswith(COPIES_OF_VERIFY)]
        kept = [entry for entry in of_verify if entry["file"] not in own]
        return {**record, "files": [*record["files"], *kept]}
    given = [entry for entry in earlier["inputs"] if entry["by"] == "verify"]
    return {
        **record,
        "inputs": [*record["inputs"], *given],
        "files": [*record["files"], *(each for each in of_verify if each["file"] not in own)],
        "tests": [
            *record["tests"],
            *(entry for entry in earlier["tests"] if entry["taken"] == "after"),
        ],
        "verification": earlier.get("verification"),
    }


def _goes_on(record: Mapping[str, Any], earlier: Mapping[str, Any]) -> bool:
    """Return whether the verification in an ``earlier`` record is one of the run of ``record``."""
    return is_as_written(earlier) and _planned(earlier) == _planned(record)


def _planned(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return the entries of a result folder's record that follow from the plan; leave out those
    that depend on where and when the files were written.
    """
    apart = ("version", "plan", "files", "inputs", "tests", "verification", _SEAL)
    return {
        **{key: value for key, value in record.items() if key not in apart},
        "tests": [entry for entry in record["tests"] if entry["taken"] == "before"],
        "tables": {
            entry["file"]: entry["sha256"]
            for entry in record["files"]
            if entry["file"].startswith("tables/")
        },
        "inputs": [
            (entry["role"], entry["of"], entry["sha256"])
            for entry in record["inputs"]
            if entry["by"] == "run" and entry["role"] != "job"
        ],
    }


def outdated_verification(record: Mapping[str, Any], earlier: Mapping[str, Any]) -> dict[str, str]:
    """Return the SHA-256 of the verification files in the ``earlier`` record, by relative name, if
    its plan differs from that of ``record``; else empty.
    """
    if _goes_on(record, earlier):
        return {}
    return {
        str(entry["file"]): str(entry["sha256"])
        for entry in earlier["files"]
        if entry.get("by") == "verify" and not entry["file"].startswith(COPIES_OF_VERIFY)
    }


def _verified(axis: Mapping[str, Any]) -> dict[str, Any]:
    return {
        "unit": axis["unit"],
        **{
            what: {name: axis[what][name] for name in PARAMETERS if name in axis[what]}
            for what in ("before", "predicted", "after")
        },
        "loading": dict(axis["loading"]),
        "accept": dict(axis["accept"]),
        "read_back": _read_back(axis["findings"]),
    }


def _read_back(findings: Iterable[Mapping[str, str]]) -> str:
    """Return the result of reading back: ``equal`` to the plan, ``other`` (different), or ``none``
    (not read back).
    """
    codes = {finding["code"] for finding in findings}
    return "other" if "CW-V011" in codes else "equal" if "CW-V010" in codes else "none"


def record_bytes(record: Mapping[str, Any]) -> bytes:
    """Return the content of ``record.json``: the record, with the SHA-256 of its entries as the
    last one.
    """
    seal = _EDITED if record.get(_SEAL) == _EDITED else _seal(record)
    return to_json({**_unsealed(record), _SEAL: seal}).encode()


def is_as_written(record: Mapping[str, Any]) -> bool:
    """Return whether no entry of a record was changed after it was written. A record without a
    SHA-256 is of an older version, and counts as unchanged.
    """
    return record.get(_SEAL) in (None, _seal(record))


def _seal(record: Mapping[str, Any]) -> str:
    return fingerprint(to_json(_unsealed(record)).encode())


def _unsealed(record: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in record.items() if key != _SEAL}


def read_record(content: bytes, file: str) -> dict[str, Any]:
    """Return the record in a file. Raises InputError with every invalid key."""
    data = read_json(content, file, SCHEMA, "record", f"{RECORD} of a run")
    faults = [replace(fault.in_file(file), hint=AS_WRITTEN) for fault in faults_of_record(data)]
    raise_all(InputError, faults)
    return data


def is_record(content: bytes) -> bool:
    """Return whether the bytes are a record of the present schema."""
    try:
        read_record(content, RECORD)
    except InputError:
        return False
    return True


def copied_by_record(content: bytes) -> dict[str, str]:
    """Return the SHA-256 of the copied inputs listed in an earlier record, by relative name."""
    try:
        listed = json.loads(content)["inputs"]
        return {str(entry["copy"]): str(entry["sha256"]) for entry in listed if entry["copy"]}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}


def listed_in_record(content: bytes) -> dict[str, str]:
    """Return the SHA-256 of the files listed in an earlier record, by relative name."""
    try:
        listed = json.loads(content)["files"]
        return {str(entry["file"]): str(entry["sha256"]) for entry in listed}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}
