"""Typed access to one mapping of a YAML file, collecting every fault instead of stopping at the
first.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from typing import Any

from compwright.foundations.errors import Fault
from compwright.foundations.key_faults import KeyPath
from compwright.foundations.yaml_reader import YamlDocument

# mm or deg, µm or arcsec: nothing on a machine is larger, or smaller and not 0
_SMALLEST, _LARGEST = 1e-9, 1e9


class Section:
    """A mapping in the document. Every getter returns a usable value; what was wrong is in
    ``faults``, shared by all sections.
    """

    def __init__(
        self, document: YamlDocument, file: str, path: KeyPath, data: Any, faults: list[Fault]
    ) -> None:
        self.document, self.file, self.path, self.faults = document, file, path, faults
        self.data: Mapping[str, Any] = data if isinstance(data, dict) else {}
        self.known: set[str] = set()
        self.is_mapping = isinstance(data, dict)
        if not self.is_mapping:
            self.faults.append(
                self._fault((), "is not a mapping", "keys with values", _shown(data))
            )

    def has(self, key: str) -> bool:
        """Return whether ``key`` is there; it then counts as known."""
        self.known.add(key)
        return key in self.data

    def number(
        self,
        key: str,
        default: float | None = None,
        *,
        least: float | None = None,
        above: float | None = None,
    ) -> float:
        """Return a finite number of a size that means something; ``default`` None: required.
        ``least`` and ``above`` are lower limits (with, without equality).
        """
        if not self._given(key, required=default is None):
            return default if default is not None else 1.0
        value = self.data[key]
        limit = (f" of at least {least:g}" if least is not None else "") + (
            f" above {above:g}" if above is not None else ""
        )
        if (
            not _is_number(value)
            or (least is not None and value < least)
            or (above is not None and value <= above)
        ):
            self.reject(key, "is not such a number", f"a number{limit}")
            return default if default is not None else 1.0
        return float(value)

    def whole(self, key: str, default: int, *, least: int, most: int) -> int:
        """Return a whole number from ``least`` to ``most``."""
        if not self._given(key, required=False):
            return default
        value = self.data[key]
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
            self.reject(key, "is not such a number", f"a whole number from {least} to {most}")
            return default
        return value

    def numbers(
        self, key: str, *, length: int | None = None, at_least: int = 1
    ) -> tuple[float, ...]:
        """Return a required list of finite numbers, of ``length`` entries or ``at_least`` so many;
        empty when at fault.
        """
        if not self._given(key, required=True):
            return ()
        value = self.data[key]
        wanted = (
            f"a list of {length} numbers"
            if length is not None
            else f"a list of at least {at_least} numbers"
        )
        if (
            not isinstance(value, list)
            or not all(_is_number(entry) for entry in value)
            or (len(value) != length if length is not None else len(value) < at_least)
        ):
            self.reject(key, "is not such a list", wanted)
            return ()
        return tuple(float(entry) for entry in value)

    def text(self, key: str, default: str) -> str:
        """Return a text; a number is taken as written."""
        if not self._given(key, required=False):
            return default
        value = self.data[key]
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            self.reject(key, "is not a text", "a text")
            return default
        text = " ".join(str(value).split())
        if not text or not text.isprintable():
            self.reject(key, "is not a text", "a text that can be printed")
            return default
        return text

    def choice(self, key: str, choices: Sequence[str], default: str) -> str:
        """Return one of ``choices``."""
        value = self.text(key, default)
        if value not in choices:
            self.reject(key, "is not one of the choices", ", ".join(choices))
            return default
        return value

    def section(self, key: str) -> Section | None:
        """Return the mapping under ``key``, None when it is not there."""
        if not self.has(key):
            return None
        return Section(self.document, self.file, (*self.path, key), self.data[key], self.faults)

    def sections(self, key: str) -> list[Section]:
        """Return the mappings of the list under ``key``, none when it is not there."""
        if not self.has(key):
            return []
        value = self.data[key]
        if not isinstance(value, list):
            self.reject(key, "is not a list", "a list of mappings")
            return []
        return [
            Section(self.document, self.file, (*self.path, key, i), entry, self.faults)
            for i, entry in enumerate(value)
        ]

    def close(self) -> None:
        """Add a fault for every key that nobody asked for, with the nearest one that exists."""
        for key in self.data:
            if key not in self.known:
                near = difflib.get_close_matches(key, sorted(self.known), n=1)
                expected = near[0] if near else ", ".join(sorted(self.known))
                self.faults.append(self._fault((key,), "unknown key", expected, key))

    def reject(self, key: str, message: str, expected: str) -> None:
        """Add a fault for the value of ``key``."""
        self.faults.append(self._fault((key,), message, expected, _shown(self.data.get(key))))

    def _given(self, key: str, *, required: bool) -> bool:
        if self.has(key):
            return True
        if required and self.is_mapping:
            self.faults.append(self._fault((key,), "missing", "this key", ""))
        return False

    def _fault(self, path: KeyPath, message: str, expected: str, found: str) -> Fault:
        place = self.document.place((*self.path, *path))
        return Fault(message=message, file=self.file, place=place, expected=expected, found=found)


def _is_number(value: object) -> bool:
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    return value == 0 or _SMALLEST <= abs(value) <= _LARGEST  # false for nan


def _shown(value: object) -> str:
    if value is None:
        return "nothing"
    text = ascii(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
