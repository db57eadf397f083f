"""Sections of a definition whose entries the code reads by name; a missing one is a fault of the
definition.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeVar

from compwright.foundations.errors import Fault, InputError

_T = TypeVar("_T")


class Required(dict[str, _T]):
    """A section by name. Reading a missing entry raises InputError with its key path; ``get`` and
    ``in`` do not.
    """

    def __init__(
        self,
        entries: Mapping[str, _T] | Iterable[tuple[str, _T]] = (),
        *,
        section: str = "",
        file: str = "",
    ) -> None:
        super().__init__(entries)
        self._section, self._file = section, file

    def __missing__(self, name: str) -> _T:
        """Raise InputError."""
        raise InputError(
            Fault(
                message="the definition lacks an entry that files of this shape need",
                file=self._file,
                place=f"{self._section}.{name}",
                expected="an entry",
                found="none",
                hint=f"add `{name}` to the section `{self._section}` of the definition",
            )
        )
