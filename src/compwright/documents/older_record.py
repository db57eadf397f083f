"""Make a record for a result folder that has no record, because an older version of compwright
wrote the folder.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from typing import Any

from compwright.documents.record import SCHEMA
from compwright.documents.recorded_test import PARAMETERS, Errors, measured_test
from compwright.foundations.provenance import fingerprint


def older_record(
    evaluation: Mapping[str, Any] | None,
    plan: Mapping[str, Any] | None,
    verification: Mapping[str, Any] | None,
    errors: Errors,
) -> dict[str, Any]:
    """Return a record made from older documents. None: the result folder has no such document.

    ``errors``: the function that returns standard errors (see `measured_test`). The record cannot
    show whether the files of the folder were changed. Raises KeyError, TypeError, ValueError or
    AttributeError for documents that violate their schema.
    """
    plan = plan or {}
    results = (evaluation or {}).get("results", ())
    return {
        "schema": SCHEMA,
        "version": plan.get("version", ""),
        "machine": dict(plan.get("machine", {})),
        "inputs": list(_inputs(plan)),
        "states": sorted(plan.get("states", {})),
        "files": [
            {"file": name, "sha256": digest}
            for name, digest in plan.get("results", {}).items()
            if name.startswith("tables/")
        ],
        "tests": [
            *(measured_test(result, "before", _measured_in(plan), errors) for result in results),
            *_after(verification, evaluation),
        ],
        "verification": verification,
    }


def _inputs(plan: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return a record's ``inputs``: the control files that a plan contains, by the state to which
    they belong.
    """
    return [
        {
            "role": "state",
            "of": name,
            "file": file["name"],
            "sha256": fingerprint(base64.b64decode(file["base64"])),
            "copy": None,
        }
        for name, files in plan.get("states", {}).items()
        for file in files
    ]


def _measured_in(plan: Mapping[str, Any]) -> dict[str, str]:
    axes = {
        f"{name} {test['name']}": str(test["measured_in"])
        for name, axis in plan.get("axes", {}).items()
        for test in axis["tests"]
    }
    circles = {name: entry["measured_in"] for name, entry in plan.get("circles", {}).items()}
    return axes | circles


def _after(
    verification: Mapping[str, Any] | None, evaluation: Mapping[str, Any] | None
) -> list[dict[str, Any]]:
    """Return a record's tests after loading, made from a verification, which contains only their
    parameters (no readings).
    """
    if verification is None:
        return []
    before = {
        (result.get("axis"), result["name"]): result
        for result in (evaluation or {}).get("results", ())
    }
    return [
        {
            "kind": "positioning",
            "name": axis["test"],
            "taken": "after",
            "date": "",
            "simulated": False,
            "standard": before.get((name, axis["test"]), {}).get("standard", ""),
            "unit": axis["unit"],
            "sources": [],
            "axis": name,
            "axis_kind": "rotary" if axis["unit"] == "arcsec" else "linear",
            "targets": list(axis["expected"]["positions"]),
            "parameters": {key: axis["after"][key] for key in PARAMETERS if key in axis["after"]},
            "uncertainty": {},
            "s": None,
            "std_error": {},
            "measured_in": "",
        }
        for name, axis in verification["axes"].items()
    ]
