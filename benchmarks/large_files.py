"""Measurement files with as many readings as asked for, written without the package, and the
commands that read them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path

_RUNS = 10  # traverses of a tall test: five up, five down
TALL, SQUARE, FLAT = "tall", "square", "flat"  # many targets, as many traverses, 11 targets


def deviation(target: int, traverse: int) -> float:
    """Return a deviation in um that no two neighbours share."""
    return (
        8.0 * math.sin(target / 50.0)
        + (3.0 if traverse % 2 else 0.0)
        + ((target * 7919 + traverse * 104729) * 2654435761 % 2**32) / 2**32
    )


def shape_of(rows: int, shape: str = TALL) -> tuple[int, int]:
    """Return targets and traverses of a test of so many readings."""
    wide = {TALL: _RUNS, SQUARE: math.isqrt(rows), FLAT: rows // 11}[shape]
    traverses = max(2, 2 * (wide // 2))
    return max(rows // traverses, 1), traverses


def _readings(rows: int, shape: str = TALL) -> Iterator[tuple[float, str, int, float]]:
    targets, traverses = shape_of(rows, shape)
    for traverse in range(traverses):
        order = range(targets) if traverse % 2 == 0 else reversed(range(targets))
        for target in order:
            sign = "+" if traverse % 2 == 0 else "-"
            yield 0.125 * target, sign, traverse // 2 + 1, deviation(target, traverse)


def long_csv(path: Path, rows: int, shape: str = TALL) -> None:
    """Write the long form of plain CSV."""
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("# axis: X\n# cycle: standard\ntarget_mm,direction,run,deviation_um\n")
        for target, sign, run, value in _readings(rows, shape):
            out.write(f"{target:.3f},{sign},{run},{value:.3f}\n")


def wide_csv(path: Path, rows: int) -> None:
    """Write the wide form of plain CSV."""
    targets, traverses = shape_of(rows)
    names = ",".join(f"{'+-'[index % 2]}{index // 2 + 1}" for index in range(traverses))
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write(f"# axis: X\n# cycle: standard\n# unit: um\ntarget_mm,{names}\n")
        for target in range(targets):
            values = ",".join(f"{deviation(target, index):.3f}" for index in range(traverses))
            out.write(f"{0.125 * target:.3f},{values}\n")


def foreign_csv(path: Path, rows: int, shape: str = TALL) -> None:
    """Write a table of another program: German words, decimal commas, semicolons."""
    with path.open("w", encoding="cp1252", newline="\r\n") as out:
        out.write("Messprotokoll\nAchse: X\nSoll [mm];Richtung;Lauf;Abweichung (Ist - Soll) [µm]\n")
        for target, sign, run, value in _readings(rows, shape):
            text = f"{target:.3f};{'auf' if sign == '+' else 'ab'};{run};{value:.3f}\n"
            out.write(text.replace(".", ","))


def circular_csv(path: Path, rows: int) -> None:
    """Write a circle: half of the samples in each sense, a spike after each reversal."""
    each = rows // 2
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("# plane: XY\n# nominal_radius_mm: 150\n# feed_mm_min: 1000\n# calibrated: yes\n")
        out.write("direction,angle_deg,deviation_um\n")
        for sense, turn in (("ccw", 1.0), ("cw", -1.0)):
            for index in range(each):
                angle = 360.0 * (index + 0.5) / each
                value = 3.0 * math.cos(math.radians(2 * angle)) + (index * 7919 % 1009) / 1009.0
                value += 4.0 * math.exp(-0.5 * (turn * angle % 90.0))
                out.write(f"{sense},{angle:.6f},{value:.3f}\n")


def laser_runs(path: Path, rows: int, kind: str = "rtl", shape: str = TALL) -> None:
    """Write runs of laser software."""
    targets, traverses = shape_of(rows, shape)
    with path.open("w", encoding="utf-8", newline="\r\n") as out:
        out.write(f"HEADER::\nFile type  : {kind}\nVersion no : V20.02.02\n\nTARGET DATA::\n")
        out.write(f"Filetype  : ISO\nTarget-count: {targets}\nTargets :\n")
        for at in range(0, targets, 5):
            end = min(at + 5, targets)
            out.write(" ".join(f"{0.125 * index:.3f}" for index in range(at, end)) + " \n")
        out.write(f"Flags: 0 0 2 0\n\nUSER-TEXT::\nAxis: X\n\nRUNS::\nRun-count: {traverses}\n\n")
        out.write("DEVIATIONS::\nRun Target Data:\n")
        for run in range(traverses):
            order = range(targets) if run % 2 == 0 else reversed(range(targets))
            out.writelines(
                f" {run + 1} {index + 1} {deviation(index, run):.3f}\n" for index in order
            )
        out.write("\nEQUIPMENT::\nENVIRONMENT::\nEOF::\n")


def means(path: Path, rows: int) -> None:
    """Write means of laser software, half of them forward, half reverse."""
    with path.open("w", encoding="utf-8", newline="\r\n") as out:
        out.write("HEADER::\nUSER-TEXT::\nAxis: Y\n\n")
        for index, title in enumerate(("Forward Directional", "Reverse Directional")):
            out.write(f"Position   \t{title} Avg Error\n")
            for target in range(rows // 2):
                out.write(f"{0.125 * target:.3f}\t{deviation(target, index) / 1000:.6f}\n")
            out.write("\n")
        out.write("ENVIRONMENT::\nEOF::\n")


def compensation(path: Path, rows: int) -> None:
    """Write a compensation text with so many points."""
    with path.open("w", encoding="utf-8", newline="\r\n") as out:
        out.write("Test name              X\nCompensation type      Absolute\n")
        out.write("Compensation resolution  1 mm\nSign convention        As errors\n")
        out.write(f"Compensation start     0 mm\nCompensation end       {rows - 1} mm\n")
        out.write("Compensation spacing   1 mm\nBacklash error         N/A\n")
        out.write("Compensation output\n\nNo.   Axis position   Forward   Reverse\n")
        for point in range(rows):
            up, down = deviation(point, 0) / 1000, deviation(point, 1) / 1000
            out.write(f"{point + 1}  {point}  {up:.6f}  {down:.6f}\n")


def target_data(path: Path, rows: int) -> None:
    """Write target data."""
    targets, traverses = shape_of(rows)
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write(f"UNIT=mm\nCYCLES={traverses // 2}\nPOSITIONS={targets}\nDEC=5\n")
        for target in range(targets):
            out.write(f"TGT_DATA[{target + 1}]={0.125 * target:.3f}\n")
        for run in range(traverses):
            name = "REF_DATA_BWD" if run % 2 else "REF_DATA_FWD"
            for target in range(targets):
                value = 0.125 * target + deviation(target, run) / 1000
                out.write(f"{name}[{target + 1},{run // 2 + 1}]={value:.6f}\n")


def workbook(path: Path, rows: int) -> None:
    """Write an Excel workbook with the long form."""
    import openpyxl

    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("X")
    sheet.append(["target_mm", "direction", "run", "deviation_um"])
    for target, sign, run, value in _readings(rows):
        sheet.append([target, sign, run, round(value, 3)])
    book.save(path)


_PROFILE = """compwright_profile: 1
layout: long
encoding: cp1252
delimiter: semicolon
decimal: comma
header_line: 3
axis: X
target: "Soll [mm]"
target_unit: mm
value: "Abweichung (Ist - Soll) [µm]"
value_is: deviation
unit: um
sign: measured minus target
direction_from: column
direction: Richtung
directions: {auf: "+", ab: "-"}
run: Lauf
run_counts: runs
cycle: standard
"""


def _one(name: str, write: Callable[[Path, int], None]) -> Callable[[Path, int], list[str]]:
    def make(folder: Path, rows: int) -> list[str]:
        path = folder / name
        write(path, rows)
        return ["evaluate", str(path), "--json", str(folder / "answer.json")]

    return make


def _by_profile(folder: Path, rows: int) -> list[str]:
    foreign_csv(folder / "x.csv", rows)
    (folder / "p.yaml").write_text(_PROFILE, encoding="utf-8")
    return [
        *("evaluate", str(folder / "x.csv"), "--profile", str(folder / "p.yaml")),
        *("--json", str(folder / "answer.json")),
    ]


def _proposed(folder: Path, rows: int) -> list[str]:
    foreign_csv(folder / "x.csv", rows)
    return ["profile", str(folder / "x.csv"), "--out", str(folder / "p.yaml")]


#: What is measured: a command by its name, made of a folder and a number of rows.
COMMANDS: dict[str, Callable[[Path, int], list[str]]] = {
    "plain CSV, long": _one("x.csv", long_csv),
    "plain CSV, long, many runs": _one("x.csv", lambda p, n: long_csv(p, n, SQUARE)),
    "plain CSV, long, 11 targets": _one("x.csv", lambda p, n: long_csv(p, n, FLAT)),
    "plain CSV, wide": _one("x.csv", wide_csv),
    "plain CSV, circular": _one("c.csv", circular_csv),
    ".rtl": _one("x.rtl", laser_runs),
    ".rtl, many runs": _one("x.rtl", lambda p, n: laser_runs(p, n, "rtl", SQUARE)),
    ".rta": _one("x.rta", lambda p, n: laser_runs(p, n, "rta")),
    ".pos": _one("x.pos", means),
    ".ren": _one("x.ren", compensation),
    "TGT_DATA": _one("x.dat", target_data),
    "a foreign CSV by profile": _by_profile,
    "profile of a foreign CSV": _proposed,
    ".xlsx": _one("x.xlsx", workbook),
}
