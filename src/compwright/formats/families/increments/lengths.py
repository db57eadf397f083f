"""Lengths in the form used in the files of a control with increments by section."""

from __future__ import annotations

from decimal import Decimal

from compwright.formats.families.increments.axis_values import INCH


def length_text(value: Decimal, *, inch: bool = False, whole: bool = False) -> str:
    """Return a length, mm or deg, in the form of the control's own files: with a decimal point and
    at least one decimal (``50.0``), or ``whole`` in thousandths, of an inch in ten thousandths.
    """
    if inch:
        value /= INCH
    if whole:
        return str(int(value / Decimal("0.0001" if inch else "0.001")))
    text = f"{value.normalize():f}"
    return text if "." in text else f"{text}.0"
