"""A FANUC backup as a control gives it: thousands of parameters, three linear axes and a rotary
one, old tables in place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

#: Old increments of the axes by point number: X from 37 to 44 (reference 40), Y from 100 to 104
#: (reference 100).
OLD_POINTS: dict[int, int] = {
    37: 1, 38: 0, 39: -2, 40: 1, 41: 2, 42: 1, 43: 0, 44: -1,
    100: 0, 101: 3, 102: -1, 103: 2, 104: -2,
    200: 1, 201: 1, 202: -2, 203: 1, 204: 3, 205: -1, 206: -1, 207: -2, 208: 1,
}  # fmt: skip
NUMBERS = {
    1851: ("4", "2", "6", "0"),
    1852: ("4", "2", "6", "0"),
    3605: ("00000000", "00000000", "00000000", "00000100"),
    3620: ("40", "100", "300", "200"),
    3621: ("37", "100", "300", "200"),
    3622: ("44", "104", "310", "208"),
    3623: ("1", "2", "0", "1"),
    3624: ("50.0", "100.0", "50.0", "45.0"),
    3625: ("0.0", "0.0", "0.0", "360.0"),
    3626: ("0", "0", "0", "0"),
    3627: ("0", "0", "0", "0"),
    1006: ("00000000", "00000000", "00000000", "00000001"),
    1020: ("88", "89", "90", "66"),
    1320: ("210.0", "410.0", "5.0", "99999.0"),
    1321: ("-210.0", "-10.0", "-500.0", "-99999.0"),
    1815: ("00110000", "00110000", "00110000", "00000000"),
}


def parameters(
    newline: str = "\n",
    *,
    lines: int = 14_000,
    q: bool = True,
    numbers: Mapping[int, Sequence[str]] = NUMBERS,
    digits: int = 5,
) -> str:
    """Parameters in ascending order with ``lines`` filler lines that no reader of compensation may
    touch.

    None of them is a parameter that acts on an axis or says its unit."""
    mark = "Q1" if q else ""
    rows: dict[int, str] = {}
    for number, values in numbers.items():
        key = "M" if number in (3624, 3625, 1320, 1321) else "P"
        groups = "".join(
            f"A{axis}{'P' if axis == 4 and key == 'M' else key}{value}"
            for axis, value in enumerate(values, start=1)
        )
        rows[number] = f"N{number:0{digits}d}{mark}{groups}"
    rows[1001] = f"N{1001:0{digits}d}{mark}P00000000"
    rows[1800] = f"N{1800:0{digits}d}{mark}P00000000"
    meant = {
        981,
        1004,
        1240,
        1013,
        1260,
        1420,
        1820,
        1821,
        1025,
        1026,
        *range(1846, 1850),
        3602,
        *range(5711, 5800),
        *range(5861, 5875),
        1023,
        1817,
        *range(5660, 5668),
        *range(8180, 8213),
        8311,
        8312,
    }
    taken = {*rows, *meant, *range(10_000, 20_000)}
    free = (number for number in range(1, 30_000) if number not in taken)
    for _ in range(lines):
        number = next(free)
        rows[number] = f"N{number:0{digits}d}{mark}" + (
            "A1P0A2P-1A3P17A4P0" if number % 3 else "P00010010"
        )
    text = [rows[number] for number in sorted(rows)]
    return newline.join(["%(CNCID=01234567,89ABCDEF)", *text, "%", ""])


def pitch_data(
    newline: str = "\n", *, highest: int = 1023, record: str = "N{number}Q0P{value}"
) -> str:
    """Every point of the array, zero where no axis has one."""
    rows = [
        record.format(number=10_000 + number, value=OLD_POINTS.get(number, 0))
        for number in range(highest + 1)
    ]
    return newline.join(["%", *rows, "%", ""])
