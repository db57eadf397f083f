"""A document as JSON text: the same document gives the same bytes, and nothing in it is NaN."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from compwright.foundations.utf8 import encoded


def to_json(document: Mapping[str, Any]) -> str:
    """Return ``document`` as JSON, indented by two blanks, with a final newline, characters as they
    are (write it as UTF-8).

    Keys keep their order; what no encoding has (a file's name that is no UTF-8) stands as its
    escape. Raises ValueError for NaN or infinity: what is not known is null in a document.
    """
    return (
        encoded(json.dumps(document, allow_nan=False, ensure_ascii=False, indent=2)).decode("utf-8")
        + "\n"
    )
