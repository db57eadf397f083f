"""What is noticed while measurement files are read."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": "Not stated in the file, assumed: {assumed:join|; }.",
    "CW-R002": "The file does not name its axis (comment line '# axis: X').",
    "CW-R003": "Measured values were turned into deviations, measured minus target.",
    "CW-R004": "The instrument already compensated for: {compensated}.",
    "CW-R005": "Columns that were left out: {columns}.",
    "CW-R006.place": "{target} in run {run}",
    "CW-R006.readings": "{missing} of {readings} readings are missing: {places}.",
    "CW-R006.rows": (
        "Rows without any reading were left out: target {targets}{more:if| and {more} more}"
        " {unit}. The results do not speak of them."
    ),
    "CW-R007": (
        "There are {positive} traverses in direction + and {negative} in direction -: one was"
        " not made, or the file was cut off."
    ),
    "CW-R008": (
        "{count} of {of} deviations are larger than 1 {unit}, the largest {largest} {unit} at"
        " target {target} {unit}: is the unit right{turn:if| or do the readings count modulo"
        " 360 deg}?"
    ),
    "CW-R009": (
        "All deviations are smaller than 0.000001 {unit}: is the unit right, and were the"
        " readings taken?"
    ),
    "CW-R010": (
        "Every deviation of run {runs} is exactly zero while others are not: some programs"
        " fill runs that were not made with zeros. Take them out if so. The result holds"
        " them; where the others scatter, table and prediction are made without them."
    ),
    "CW-R011": (
        "The deviations grow by about 1 {unit} per {unit} of target, as measured positions"
        " do: if they are measured positions, name the column measured_{unit}."
    ),
    "CW-R012": "Targets almost the same that no run has both of, perhaps one target: {targets}.",
    "CW-R012.pair": "{low:.10g} and {high}",
    "CW-R013": (
        "The key 'deviation: {deviation}' has no effect: the file gives measured values, not"
        " deviations."
    ),
    "CW-R014.forward": (
        "The positions are not listed from low to high: check at the machine which direction"
        " forward is."
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
        "{number} was read with a decimal point, but whole numbers are in the same column and"
        " no number proves the point: if it marks thousands, take it out."
    ),
    "CW-R030": (
        "The readings hold the ballbar's calibration and its temperature correction already"
        " (expansion {expansion} µm/(m K), {temperatures} °C): nothing was applied again."
    ),
    "CW-R031": (
        "The true feed, from sample rate and number of samples, is {feed:.4g} mm/min and not"
        " the programmed {programmed:.4g} mm/min: override, or an axis that did not follow."
        " The true one is used."
    ),
    "CW-R032": (
        "Run {direction} {run} has {number} {more:if|more|fewer} readings after the measured arc"
        " than before it: a reading may be doubled or lost."
    ),
    "CW-R033": "The test asks for a {sense} run, but the file holds none.",
    "CW-R034": (
        "Samples are missing in {run} from {angle:.6g} deg on, over {width:.4g} deg (samples"
        " are {step:.3g} deg apart)."
    ),
    "CW-R035": (
        "The largest deviation from the nominal radius is {largest:.4g} mm: are unit, nominal"
        " radius and set-up right?"
    ),
    "CW-R036": "Every deviation of run {runs} is zero (below 0.001 um): was it measured?",
    "CW-R037": "The bar was not calibrated for {files}: radii of the whole test do not count.",
    "CW-R038": "{files:and} were taken as the two directions of one test.",
    "CW-R039": (
        "The other direction may be in {files}, but no pair is certain: not joined. Evaluate"
        " one pair at a time, or give its files names that differ only by ccw and cw."
    ),
    "CW-R050": (
        "Left out, because a test in two directions approached them in one only: target {targets}."
    ),
    "CW-R051": (
        "The file ends without a line end after {number} (line {line}): if it was cut off"
        " while it was copied, digits are missing there, or readings after it."
    ),
    "CW-R052": "Skipped in the folder, by their endings no measurements: {files}.",
    "CW-R053.environment": (
        "The file has no section ENVIRONMENT:: after its means: it may have been cut off."
    ),
    "CW-R053.header": (
        "The file says that it has {promised} {what:choose|targets=targets|runs=runs} (key"
        " {key}) and holds {found}: it may have been cut off."
    ),
    "CW-R053.last_run": (
        "The last rows are of run {run}, which lacks {lacking} of {readings} readings while"
        " the others have all: the file may have been cut off."
    ),
    "CW-R053.last_target": (
        "The last rows are of target {target}, which lacks {lacking} of {readings} readings"
        " while the others have all: the file may have been cut off."
    ),
    "CW-R053.no_end": (
        "The file ends without EOF::, its last line is {text} (line {line}): it may have been"
        " cut off, and digits or readings may be missing. Compare with the instrument."
    ),
    "CW-R053.one_direction": (
        "Only {direction} is there. In this form all of one direction is before the other, so"
        " a file that was cut off between them reads like a test in one direction: compare"
        " with the instrument."
    ),
    "CW-R053.run_count": (
        "The file promises {promised} runs (Run-count) and holds {found}: it may have been"
        " cut off, or the test was stopped."
    ),
    "CW-R053.share": (
        "{share:.0%} of the readings are missing: the file may have been cut off, or rows"
        " were lost."
    ),
    "CW-R054": (
        "Runs left out: {runs}{more:if|, ..}. They are exactly zero throughout, as some"
        " programs fill the way back of a test in one direction."
    ),
    "CW-R055": (
        "Even runs were taken as the way back (direction {back}) by their number alone: the"
        " rows of run {run} are in the same order as those of run 1. If the test went one way"
        " only, reversal and backlash are not in it."
    ),
    "CW-R056": (
        "The file does not state the unit of its deviations; microradian was taken: the"
        " largest, {largest}, is then {arcsec} arcsec. Compare it with the instrument."
    ),
    "CW-R057": (
        "The file holds means of several runs, not readings: it is read as one run per"
        " direction, and repeatability is unknown.{way_back:if| The means of the way back are"
        " not in it: they are twice those of both directions less those of the way out.}"
    ),
    "CW-R058": (
        "The file is a compensation table made by the laser's software ({sign}), not a test:"
        " it is read as one run per direction of its errors. To make a table, use the test"
        " itself."
    ),
    "CW-R059": (
        "Rows without a number in the column {column} were left out: line {lines}{more:if|"
        " and {more} more}."
    ),
    "CW-R060": "Read{by:if| by {by}}: {readings:join|; }.",
    "CW-R061.sheets": "Sheets that were left out: {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Tests in the same file without an axis were left out: {tests}. Only {used} is used."
    ),
    "CW-R062": (
        "The file is not UTF-8 and was read as {code_page}; only comments and names of"
        " columns depend on it, no number does. Line {line} says {text}."
    ),
    "CW-R063": (
        "Lines that look like readings are outside the readings and were not read: line"
        " {lines}{more:if| and {more} more}. Compare with the instrument."
    ),
    "CW-R064": (
        "Hidden in the workbook, and read like the rest: {hidden:join|; }. Compare the number"
        " of readings with the instrument, and take out what is not of the test."
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
