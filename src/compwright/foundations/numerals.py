"""Numbers in sentences: a given number of digits, never an exponent."""

from __future__ import annotations

from decimal import Decimal


def significant(value: float, digits: int = 2, *, signed: bool = False) -> str:
    """Return ``value`` to so many significant digits, written out: 0.00012, 5.4, 190, 1500000;
    ``signed``: with its plus.
    """
    return format(Decimal(f"{value:.{digits}g}"), "+f" if signed else "f")
