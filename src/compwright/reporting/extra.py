"""Plots and pages need the optional extra ``report`` (matplotlib, jinja2); it is imported only when
one is asked for.
"""

from __future__ import annotations

import importlib
from typing import Any

from compwright.foundations.errors import Fault, UsageError


def need(module: str) -> Any:
    """Return the module of that name. Raises UsageError when the extra ``report`` is not
    installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise UsageError(
            Fault(
                message="plots and reports need the report extra: pip install compwright[report]",
                expected=f"the package {module.partition('.')[0]}",
                found=str(error),
            )
        ) from error
