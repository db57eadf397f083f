"""The page of ``selftest``, to be signed: expected and obtained values."""

from __future__ import annotations

from typing import Any

from compwright.reporting import paper
from compwright.reporting.numbers import plain, unit_text
from compwright.reporting.page import render_page
from compwright.reporting.sections import Document


def selftest_report(document: Document) -> bytes:
    """Return the page of a self-test document (``compwright/selftest/1``).

    Raises UsageError if the extra ``report`` is not installed.
    """
    checks = list(document.get("checks") or ())
    wrong = sum(not check["good"] for check in checks)
    good = bool(document.get("good"))
    return render_page(
        "selftest.html",
        {
            "page_title": "Self-test of compwright",
            "title": "Self-test of compwright (installation and operational qualification)",
            "head": paper.head({}, []),
            "tone": "good" if good else "bad",
            "verdict": (
                f"All {len(checks)} values are within their limits"
                if good
                else f"{wrong} of {len(checks)} values are outside their limits"
            ),
            "facts": [
                ("compwright", plain(document.get("version"))),
                ("platform", plain(document.get("platform"))),
                ("Python", plain(document.get("python"))),
                *((str(name), plain(text)) for name, text in document["packages"].items()),
            ],
            "groups": [
                _group(name, [check for check in checks if check["group"] == name])
                for name in dict.fromkeys(check["group"] for check in checks)
            ],
            "sources": [
                {"file": name, "sha256": digest}
                for name, digest in document["reference_data"].items()
            ],
        },
    )


def _group(name: str, checks: list[Document]) -> dict[str, Any]:
    wrong = sum(not check["good"] for check in checks)
    return {
        "name": name,
        "mark": _mark(good=not wrong),
        "count": len(checks),
        "wrong": wrong,
        "source": "; ".join(dict.fromkeys(plain(check["source"]) for check in checks)),
        "rows": [_row(check) for check in checks],
    }


def _mark(*, good: bool) -> dict[str, str]:
    return {"tone": "good", "text": "✓"} if good else {"tone": "bad", "text": "✗"}


def _row(check: Document) -> dict[str, Any]:
    note = f" {check['note']}" if check["note"] else ""
    return {
        "mark": _mark(good=bool(check["good"])),
        "subject": f"{plain(check['subject'])}{note}",
        "quantity": plain(check["quantity"]),
        "values": [plain(check[key]) for key in ("expected", "obtained", "limit")],
        "unit": unit_text(check["unit"]),
    }
