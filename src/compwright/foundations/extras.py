"""Libraries of the optional extras, imported only when a command needs them."""

from __future__ import annotations

import importlib
import sys
from typing import Any, Final

from compwright.foundations.errors import Fault, UsageError

#: What installs each extra, whether compwright came from a checkout, a wheel or an index.
_PACKAGES: Final = {
    "report": "jinja2 matplotlib",
    "pdf": "jinja2 matplotlib typst~=0.15.2",
    "excel": "openpyxl",
    "pandas": "pandas",
}


def installing(extra: str) -> str:
    """Return the command that installs the libraries of an ``extra``, as a next step."""
    return (
        f"install what the extra {extra} needs:"
        f' "{sys.executable}" -m pip install {_PACKAGES[extra]}'
    )


def need(module: str, extra: str = "report", purpose: str = "plots and reports") -> Any:
    """Return the imported module. Raises UsageError if it is not installed."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise UsageError(
            Fault(message=f"{purpose} need the package {package}", hint=installing(extra))
        ) from error


def installed_version(package: str) -> str:
    """Return the version of an installed package, or "not installed"."""
    metadata = importlib.import_module("importlib.metadata")  # slow to load: only where it is asked
    try:
        return str(metadata.version(package))
    except metadata.PackageNotFoundError:
        return "not installed"
