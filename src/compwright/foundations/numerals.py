"""Write numbers with a given number of digits, never with an exponent."""

from __future__ import annotations

from decimal import Decimal


def significant(value: float, digits: int = 2, *, signed: bool = False) -> str:
    """Return ``value`` as text with a number of significant digits: 0.00012, 5.4, 190, 1500000.

    ``digits``: their number. ``signed``: write the plus sign of a positive value.
    """
    return format(Decimal(f"{value:.{digits}g}"), "+f" if signed else "f")
