"""Where the tests find things outside the project."""

from __future__ import annotations

from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[1]
SHARED = PROJECT.parent / "shared"
STANDARD_TABLES = SHARED / "data" / "standards"
REAL = SHARED / "data" / "real"

needs_shared = pytest.mark.skipif(
    not SHARED.is_dir(), reason="the shared reference data are not beside the project"
)
