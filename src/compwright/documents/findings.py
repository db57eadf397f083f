"""Findings as JSON, for documents and for plans."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from compwright.foundations.findings import Finding
from compwright.words.sentences import Amount, Sentence, say


def finding_documents(findings: Iterable[Finding]) -> list[dict[str, Any]]:
    """Return the findings for JSON, equal findings once: code, severity, English text, and the
    values in the text.
    """
    return [
        {
            "code": finding.code,
            "severity": finding.severity,
            "message": finding.message,
            "values": finding.sentence.outside(),
        }
        for finding in dict.fromkeys(findings)
    ]


def planned_finding(finding: Finding) -> dict[str, Any]:
    """Return a finding as plain data for a plan, from which `read_sentence` can restore its
    translatable text.
    """
    return {**asdict(finding), "message": finding.message}


def read_sentence(written: object, message: str) -> Sentence:
    """Return the text of a finding in a plan as a `Sentence`, which can be translated; if this
    version does not know it, as the English ``message``.
    """
    try:
        sentence = _value(written)
        if isinstance(sentence, Sentence) and str(sentence) == message:
            return sentence
    except (KeyError, TypeError, ValueError, IndexError, AttributeError):
        pass  # of another version, or edited
    return say("as_written", text=message)


def _value(written: Any) -> Any:
    if isinstance(written, list):
        return tuple(map(_value, written))
    if not isinstance(written, Mapping):
        return written
    if "name" in written:
        values = tuple((str(key), _value(value)) for key, value in written["values"])
        return Sentence(str(written["name"]), values)
    return Amount(**written)
