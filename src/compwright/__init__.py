"""compwright: evaluate positioning and circular tests, fit compensation tables, predict and verify.

The functions of the library:

- `read` reads test files and returns tests.
- `evaluate` returns the results of tests by a standard.
- `estimate` returns the error of an axis with its uncertainty.
- `load_job` reads a job file. `plan` computes its tables, a prediction and findings.
- `verify` and `compare` check the compensation after loading.
- `decode` shows what a control does with its files.
- `simulate` returns tests of a virtual machine.

No function prints. Files are written only on request, for example by `JobPlan.write`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from compwright.foundations.errors import (
        CapacityError,
        CompwrightError,
        InputError,
        StorageError,
        UsageError,
    )
    from compwright.library.calls import (
        compare,
        decode,
        estimate,
        evaluate,
        load_job,
        plan,
        read,
        simulate,
        verify,
    )
    from compwright.records.circular import CircularTest
    from compwright.records.positioning import PositioningTest

__version__ = "0.1.0"
__all__ = [
    "CapacityError",
    "CircularTest",
    "CompwrightError",
    "InputError",
    "PositioningTest",
    "StorageError",
    "UsageError",
    "compare",
    "decode",
    "estimate",
    "evaluate",
    "load_job",
    "plan",
    "read",
    "simulate",
    "verify",
]


def __getattr__(name: str) -> object:
    """Return a public name, loaded when it is first used: most scripts need few of them."""
    if name not in __all__:
        raise AttributeError(f"module 'compwright' has no attribute {name!r}")
    rooms = {"CircularTest": "records.circular", "PositioningTest": "records.positioning"}
    room = "foundations.errors" if name.endswith("Error") else rooms.get(name, "library.calls")
    return getattr(import_module(f"compwright.{room}"), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
