"""Sentences about the reading of measurement files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": "The file does not state the following, so it was assumed: {assumed:join|; }.",
    "CW-R002": "The file does not name its axis. Add a comment line '# axis: X'.",
    "CW-R003": (
        "The file contains measured positions. They were converted to deviations (measured minus"
        " target)."
    ),
    "CW-R004": "The instrument already compensated for: {compensated}.",
    "CW-R005": (
        "These columns were left out: {columns}."
        "{near:if| If {near} is the column {name}, rename it.}"
    ),
    "CW-R006.place": "{target} in run {run}",
    "CW-R006.readings": "{missing} of {readings} readings are missing: {places}.",
    "CW-R006.rows": (
        "Rows without any reading were left out: target {targets}{more:if| and {more} more}"
        " {unit}. The results do not cover these targets."
    ),
    "CW-R007": (
        "There are {positive} runs in direction + but {negative} in direction −. Either a run was"
        " not made, or the file was cut off: compare the file with the instrument."
    ),
    "CW-R008": (
        "{count} of {of} deviations are larger than 1 {unit}. The largest is {largest} {unit}, at"
        " target {target} {unit}. Check the unit{turn:if|, and whether the readings start again"
        " at 0 after 360 deg}."
    ),
    "CW-R009": (
        "All deviations are smaller than 0.000001 {unit}. Check the unit, and whether the axis"
        " was really measured."
    ),
    "CW-R010": (
        "Every deviation of run {runs} is exactly zero, while others are not. Some programs fill"
        " a run that was not made with zeros: if so, remove the run from the file. The result"
        " includes it. If the other runs scatter, table and prediction are made without it."
    ),
    "CW-R011": (
        "The deviations grow by about 1 {unit} per {unit} of target, as measured positions do. If"
        " they are measured positions, name their column measured_{unit}."
    ),
    "CW-R012": (
        "These targets are almost the same, and no run has readings at both: {targets}. If they"
        " are the same target, give it the same number in all rows."
    ),
    "CW-R012.pair": "{low:.10g} and {high}",
    "CW-R013": (
        "The key 'deviation: {deviation}' has no effect: the file gives measured values, not"
        " deviations."
    ),
    "CW-R014.forward": (
        "The positions are not listed from low to high: check at the machine in which direction the"
        " forward runs went."
    ),
    "CW-R014.labels": (
        "The targets are listed from high to low, and FWD was taken as the approach in"
        " direction +: check the labels."
    ),
    "CW-R014.odd_runs": (
        "The targets are listed from high to low, so odd runs were taken as approaches in"
        " direction {direction}: check it at the machine."
    ),
    "CW-R015": (
        "{number} was read with a decimal point. But the same column has whole numbers, so the"
        " point may separate thousands. If it does, remove it."
    ),
    "CW-R030": (
        "The readings already include the calibration and the temperature correction of the"
        " ballbar (expansion {expansion} µm/(m K), {temperatures} °C). Neither was applied again."
    ),
    "CW-R031": (
        "Sample rate and number of samples give a true feed of {feed:.4g} mm/min, not"
        " {programmed:.4g} mm/min as programmed. Either an override was set, or an axis did not"
        " follow. The true feed is used."
    ),
    "CW-R032": (
        "Run {direction} {run} has {number} {more:if|more|fewer} readings after the measured arc"
        " than before it. A reading may have been doubled or lost."
    ),
    "CW-R033": (
        "The file announces a {sense} run (RUN_SPEC), but contains no readings of such a run."
    ),
    "CW-R034": (
        "Samples are missing in {run} from {angle:.6g} deg on, over {width:.4g} deg (samples"
        " are {step:.3g} deg apart)."
    ),
    "CW-R034.open": (
        "{run} has no samples from {begin:.5g}° to {end:.5g}°. It is evaluated as an arc of"
        " {arc:.5g}°, not as a full circle. Either samples are missing: export all of them, or"
        " measure again. Or only this arc was run: acknowledge CW-R034 in the job."
    ),
    "CW-R035": (
        "The largest deviation from the nominal radius is {largest:.4g} mm. Check unit, nominal"
        " radius and set-up."
    ),
    "CW-R036": (
        "The deviations of {runs} from a circle are below 0.1 µm, the resolution of a ballbar."
        " Check the unit of the deviations, and whether the run was measured."
    ),
    "CW-R037": (
        "The bar was not calibrated for {files}. The absolute radius is therefore not used for any"
        " run of this test."
    ),
    "CW-R038": "{files:and} were taken as the two directions of one test.",
    "CW-R039": (
        "The other direction may be in {files}, but it is not certain which files belong"
        " together, so no files were combined. Evaluate one pair at a time, or give the files of"
        " a pair names that differ only by ccw and cw."
    ),
    "CW-R050": (
        "In this test in two directions, these targets were approached in one direction only and"
        " were left out: {targets}."
    ),
    "CW-R051": (
        "The last line ends after {number} without a line break (line {line}). The file may have"
        " been cut off while it was copied: digits or later readings may be missing. Compare with"
        " the instrument."
    ),
    "CW-R052": (
        "These files of the folder were skipped, because their endings are not those of"
        " measurement files: {files}."
    ),
    "CW-R053.environment": (
        "The section ENVIRONMENT:: is missing after the means. The file may have been cut off:"
        " compare with the instrument."
    ),
    "CW-R053.header": (
        "According to its key {key} the file has {promised}"
        " {what:choose|targets=targets|runs=runs}, but it contains {found}. It may have been cut"
        " off: compare with the instrument."
    ),
    "CW-R053.last_run": (
        "The last rows belong to run {run}, which lacks {lacking} of {readings} readings, while"
        " the other runs have all. The file may have been cut off: compare with the instrument."
    ),
    "CW-R053.last_target": (
        "The last rows belong to target {target}, which lacks {lacking} of {readings} readings,"
        " while the other targets have all. The file may have been cut off: compare with the"
        " instrument."
    ),
    "CW-R053.no_end": (
        "The end mark EOF:: is missing; the last line is {text} (line {line}). The file may have"
        " been cut off, and digits or readings may be missing. Compare with the instrument."
    ),
    "CW-R053.one_direction": (
        "The file contains only direction {direction}. In this file format, all readings of one"
        " direction come before those of the other. The second direction may therefore have been"
        " cut off: compare the file with the instrument."
    ),
    "CW-R053.run_count": (
        "According to its key Run-count the file has {promised} runs, but it contains {found}."
        " Either the file was cut off, or the test was stopped. Compare with the instrument."
    ),
    "CW-R053.share": (
        "{share:.0%} of the readings are missing. Either the file was cut off, or rows were lost."
        " Compare with the instrument."
    ),
    "CW-R054": (
        "These runs were left out, because all their values are exactly zero: {runs}{more:if|,"
        " ..}. Some programs fill the way back of a test in one direction with zeros."
    ),
    "CW-R055": (
        "Even runs were taken as the way back (direction {back}), only because their numbers are"
        " even: the rows of run {run} are in the same order as those of run 1. If all runs of the"
        " test went the same way, its reversal and backlash values are meaningless."
    ),
    "CW-R056": (
        "The file does not state the unit of its deviations, so microradian was assumed. The"
        " largest deviation, {largest}, is then {arcsec} arcsec. Compare it with the instrument."
    ),
    "CW-R057": (
        "The file contains means of several runs, not single readings. It is read as one run per"
        " direction, and repeatability is unknown.{way_back:if| The means of the way back are not"
        " in the file: they were calculated from the means of both directions (2 × mean of both"
        " directions − mean of the way out).}"
    ),
    "CW-R058": (
        "The file is a compensation table made by the laser's software ({sign:if|{sign}|sign by the"
        " profile}), not a test. It is read as one run per direction with the errors of this table."
        " To make a table, give the measurement file of the test."
    ),
    "CW-R059": (
        "Rows without a number in the column {column} were left out: line {lines}{more:if|"
        " and {more} more}."
    ),
    "CW-R060": "How the file was read{by:if| (by {by})}: {readings:join|; }.",
    "CW-R061.sheets": "Sheets that were left out: {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Tests in the same file that do not name their axis were left out: {tests}. Only {used} is"
        " used."
    ),
    "CW-R062": (
        "The file is not UTF-8 and was read as {code_page}. Line {line} then reads {text}. Only"
        " comments and names of columns depend on this, no number does."
    ),
    "CW-R063": (
        "Some lines look like readings but are outside the section of readings, so they were not"
        " read: line {lines}{more:if| and {more} more}. Compare with the instrument."
    ),
    "CW-R064": (
        "These parts of the workbook are hidden, but were read like the rest: {hidden:join|; }."
        " Compare the number of readings with the instrument. Remove what does not belong to the"
        " test."
    ),
    "CW-R064.columns": "{number} {number:plural|column|columns} ({columns})",
    "CW-R064.rows": (
        "{number} {number:plural|row|rows}, hidden or filtered out (row {rows}{more:if| and"
        " {more} more})"
    ),
    "CW-R064.sheet": "the whole sheet",
    "reading.deviation": "deviation: measured minus target",
    "reading.forward": "forward: approach in direction {direction}",
    "reading.fwd": "FWD: approach in direction +, BWD: in direction -",
    "reading.unit_mm": "unit: mm",
}
