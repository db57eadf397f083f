"""Files of laser software, written from the published description of their layout and not from the
readers: sections, counts, wrapped targets, runs counted by traverse.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

#: One deviation as it stands in the file, by (run, target), both from 1.
Deviations = Mapping[tuple[int, int], str]


def laser_file(
    targets: Sequence[str],
    deviations: Deviations,
    *,
    file_type: str = "rtl",
    flags: str | None = "0 0 2 0",
    descending: bool = True,
    axis: str = "X",
    runs: int | None = None,
    row_header: str = "Run Target Data:",
    machine: str = "VMC 850",
    end: bool = True,
) -> str:
    """Return a file; ``descending``: the rows of even runs stand from the last target to the
    first.
    """
    count = max((run for run, _ in deviations), default=0)
    lines = ["HEADER::", f"File type  : {file_type}", "Owner      : Linear"]
    lines += ["Version no : V20.02.02", "", "TARGET DATA::", "Filetype  : ISO"]
    lines += [f"Target-count: {len(targets)}", "Targets :"]
    lines += [" ".join(targets[at : at + 5]) + " " for at in range(0, len(targets), 5)]
    lines += [f"Flags: {flags}"] if flags is not None else []
    lines += ["", "USER-TEXT::", f"Machine: {machine}", "Serial No: 4711", "Date: 2026-03-02"]
    lines += ["By: N N", f"Axis: {axis}", "Location: hall 3", "TITLE: before", "", "RUNS::"]
    lines += [f"Run-count: {count if runs is None else runs}", "", "DEVIATIONS::", row_header]
    for run in range(1, count + 1):
        indices = [target for number, target in deviations if number == run]
        indices.sort(reverse=descending and run % 2 == 0)
        lines += [f"   {run}     {index}     {deviations[run, index]}" for index in indices]
    lines += ["", "EQUIPMENT::", "ENVIRONMENT::", "Air temp   : 20.1"]
    return "\r\n".join([*lines, "EOF::", ""] if end else lines)


def mean_file(blocks: Mapping[str, Sequence[tuple[str, str]]], *, end: bool = True) -> str:
    """Return a file of means: ``blocks`` are rows of position and mean by the words of their
    title.
    """
    lines = ["HEADER::", "USER-TEXT::", "Axis: Y", ""]
    for title, rows in blocks.items():
        lines.append(f"Position   \t{title} Avg Error")
        lines += [f"{position}\t{value}" for position, value in rows]
        lines.append("")
    return "\r\n".join([*lines, "ENVIRONMENT::", "EOF::", ""] if end else lines)


def compensation_file(
    rows: Sequence[Sequence[str]],
    *,
    columns: str = "No.   Axis position   Forward   Reverse",
    sign: str | None = "As errors",
    start: str = "-250 mm",
    end: str = "-200 mm",
    spacing: str = "25 mm",
    backlash: str = "N/A",
    kind: str = "Absolute",
    resolution: str = "1 mm",
) -> str:
    """Return a compensation text: keys without a colon, then a table, or a list without
    ``columns``.
    """
    lines = ["Test name              X-Axis Position Accuracy"]
    lines += ["Table type             Separate forward and reverse tables"]
    lines += [f"Compensation type      {kind}", f"Compensation resolution  {resolution}"]
    lines += [f"Sign convention        {sign}"] if sign is not None else []
    lines += ["Reference position     -250 mm", f"Compensation start     {start}"]
    lines += [f"Compensation end       {end}", f"Compensation spacing   {spacing}"]
    lines += [f"Backlash error         {backlash}", "Compensation output", ""]
    lines += [columns] if columns else []
    return "\r\n".join([*lines, *("   ".join(row) for row in rows), ""])
