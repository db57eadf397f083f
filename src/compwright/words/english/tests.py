"""What is noticed about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Each parameter belongs to one traverse (clauses 3.2 and 5); given are those of"
        " {first:and}. Others: {others}."
    ),
    "CW-C001.other": "{direction} run {run}: G {G}",
    "CW-C001.run": "{direction} run {run}",
    "CW-C002": (
        "Only {direction} was measured: parameters of both directions do not exist, and squareness,"
        " servo mismatch and lost motion cannot be separated."
    ),
    "CW-C003": (
        "The length of the bar was not calibrated: F is not given; D and F about the least-squares"
        " centre rest on the nominal length."
    ),
    "CW-C004": (
        "The samples of {run} are {interval:3sig}° apart: spikes at the reversal points can be"
        " missed, and G, F and H come out too small."
    ),
    "CW-C005.arc": "{run} covers {covered:.5g}° of an arc of {arc:.5g}°.",
    "CW-C005.gap": "No samples of {run} from {gaps}: what the path does there is not evaluated.",
    "CW-C006.no_feed": "{feed:g} mm/min is no feed.",
    "CW-C006.time": (
        "At {feed:g} mm/min a circle of {radius:g} mm takes {seconds:3sig} s: check the unit of the"
        " feed."
    ),
    "CW-C007": (
        "{run} covers {covered:.5g}°, more than the arc of {arc:.5g}°: starting and stopping arcs"
        " seem not to be cut."
    ),
    "CW-C008": (
        "{ccw} samples ccw and {cw} cw: the common circle is drawn towards the direction with more."
    ),
    "CW-C009": "{repeated} samples of {run} repeat an angle; all of them count.",
    "CW-C010": (
        "F on an arc counts from the set-up centre (3.5 a) and contains its offset, here about"
        " {offset}; F about the least-squares centre is given as well."
    ),
    "CW-C011": (
        "The circle lies {offset} from the set-up centre. The angles were taken as commanded; if"
        " they were measured from the set-up centre, radii are off by up to {effect}. Centre better"
        " and measure again."
    ),
    "CW-C012": (
        "The ends of {run} differ by {step} at the same place: drift during the run, a moved bar,"
        " or readings of the starting arc among the samples."
    ),
    "CW-C013": "{run} is exactly zero throughout: probably it was not measured.",
    "CW-T001": (
        "The standard asks for 5 approaches to each target and direction; found {counts:and}."
    ),
    "CW-T001.count": "{count} in {direction}",
    "CW-T002.linear": (
        "{targets} targets over {length:.10g} mm are too few: at least 5 per metre and 5 in all are"
        " needed, here {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 asks for three positions in addition to 0°, 90°, 180°, 270°; there"
        " are {others}."
    ),
    "CW-T002.rotary": (
        "{targets} targets over {length:.10g}° are too few: this travel needs at least {needed}"
        " (table of target positions)."
    ),
    "CW-T003": (
        "Only the approach in {direction} was measured; parameters of both directions do not exist."
    ),
    "CW-T004": "Principal position not among the targets: {positions}.",
    "CW-T005.repeated_long": (
        "Repeated approaches over more than {limit}: the standard tests the whole length with one"
        " approach per direction, and n = 5 over {limit} in the normal working area, as two tests."
        " Evaluated as measured."
    ),
    "CW-T005.repeated_missing": (
        "The axis is longer than {limit}; in addition to this test with one approach per direction"
        " a test with n = 5 over {limit} belongs to it."
    ),
    "CW-T005.whole_missing": (
        "The axis is longer than {limit}; a test of its whole length with one approach per"
        " direction belongs to it too."
    ),
    "CW-T006.linear": (
        "The mean interval of the targets is {interval:.5g} mm; over 2 000 mm it is to be 250 mm at"
        " most."
    ),
    "CW-T006.per_turn": (
        "{targets} targets over {turns:.4g} turns: at least eight per turn are needed."
    ),
    "CW-T006.rotary": (
        "The widest interval of the targets is {interval:.5g}°; over 360° it is to be 45° at most."
    ),
    "CW-T006.turns": (
        "{length:.10g}° were measured; the standard asks for 1 800° (five turns) at most."
    ),
    "CW-T007.end": "{length} at the {end:choose|lower=lower|upper=upper} end",
    "CW-T007.outside": (
        "Targets {first} to {last} lie outside the travel {travel_start} to {travel_end}: check the"
        " offset and the sense of the positions."
    ),
    "CW-T007.uncovered": (
        "Part of the travel was not measured: {ends:and}, more than one interval of the targets."
    ),
    "CW-T008.equal": (
        "The targets are equally spaced ({interval}): a periodic error (screw pitch, scale pitch)"
        " that divides the spacing stays hidden. The standard asks for random offsets; {better}"
    ),
    "CW-T008.period": (
        "The targets hit the period of {period} always at the same phases: a periodic error of this"
        " period can stay hidden. Choose targets at varying phases (clause on target positions);"
        " {better}"
    ),
    "CW-T009": (
        "Step cycle: not for acceptance unless agreed in writing (annex of ISO 230-2). A drift D"
        " during the test puts about 0.92 D into E and M, and hardly any into R."
    ),
    "CW-T010": (
        "Readings are missing: {where:join|; } have fewer than the others; each target is evaluated"
        " with its own n."
    ),
    "CW-T010.direction": "in {direction} {fewer} of {targets} targets ({at}{more:if| ...})",
    "CW-T011.rows": (
        "Up to {targets} targets side by side are exactly zero in traverse {traverses}{more:if| and"
        " {more} more}, while the other readings scatter: probably not measured, and filled up with"
        " zeros. They are part of the result."
    ),
    "CW-T011.traverse": (
        "Traverse {run} in {direction} is exactly zero at all {targets} targets: probably not"
        " measured. It is part of the result; where the others scatter, table and prediction are"
        " made without it."
    ),
    "CW-T012": (
        "The readings drift: {how}; in runs without drift such an order has a chance of"
        " {chance:.1f} %. Warm the axis up and measure again: the drift is part of R and A."
    ),
    "CW-T012.ends": "{lower} and {upper} in {direction}",
    "CW-T012.growing": (
        "from the first run to the last, at the lower and the upper end of the travel,"
        " {drifts:join|; } (it grows along the travel, as expansion does)"
    ),
    "CW-T012.mean": "{drifts:and} from the first run to the last (mean over the targets)",
    "CW-T013.more": "{more} more runs are outliers, by less.",
    "CW-T013.run": (
        "Run {run} is {off:and} off the others (robust standard deviation of their readings:"
        " {scatter}).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Traverse {run} in {direction} is {off} off the others (robust standard deviation of their"
        " readings: {scatter}).{compared:if| {compared}}"
    ),
    "CW-T014.compared": (
        "The result with {readings:plural|the suspect reading|the {readings} suspect readings} and"
        " without: {compared}"
    ),
    "CW-T014.listed": (
        "{readings:plural|Suspect reading|Suspect readings}: {where}{more:if| and {more} more};"
        " robust standard deviation of a reading: {scatter}.{compared:if| {compared}}"
    ),
    "CW-T015": "Targets without any reading are left out: {targets}.",
    "CW-T016": (
        "Fewer than two readings per direction at {targets}: no standard deviation there."
        " Parameters that need it are not given.{others:if| Over the other targets: {others}.}"
    ),
    "CW-T020": (
        "Uncertainty: U (k = 2) from the contributors of ISO 230-2:2006, annex A, as far as the job"
        " declares them; their distributions are propagated (JCGM 101:2008), not the coefficients"
        " of the annex.{misalignment:if| A misaligned beam makes distances too short, never"
        " too long: by up to {misalignment:.2f} µm over these targets. U includes"
        " ±{counted:.2f} µm for this.}"
    ),
    "CW-T021": (
        "No uncertainty is stated for VDI/DGQ 3441: annex A of ISO 230-2 treats its own parameters"
        " only."
    ),
    "CW-T022": (
        "U_theta is given without thermal.alpha_m: {alpha_m} µm/(m K) (steel) was assumed for the"
        " machine."
    ),
    "CW-T023": (
        "U_alpha is given without thermal.T_m: the temperature is unknown, so its term is missing"
        " from U."
    ),
    "CW-T024": (
        "Referred to 20 °C ({refer_to}): {slope:+.3f} µm/m removed about {x_fix:.10g} mm, from"
        " {alpha_m:g} µm/(m K) at {T_m:g} °C for the {refer_to} and {alpha_d:g} µm/(m K) at {T_d:g}"
        " °C for the instrument."
    ),
    "CW-T025": (
        "The temperature changed from start to end of the test: {changes:and}. Over the"
        " {length:.5g} mm of the targets that is {drift:+.2f} µm from the first run to the last."
        " The expansion was removed with the mean of start and end, because the file does not say"
        " when each reading was taken: what differs from it stays in the readings as drift."
    ),
    "CW-T025.change": (
        "that of the {of:choose|scale=scale|workpiece=workpiece|instrument=instrument} by"
        " {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "E_VE is {E_VE}, the largest range of {file} within all of its {minutes:g} min. It must be"
        " as long as a positioning test: give the time of yours as duration_min where it is"
        " shorter."
    ),
    "CW-T026.within": "E_VE is {E_VE}, the largest range of {file} within {minutes:g} min.",
    "CW-T027": (
        "The stand-still test {file} shows too little of E_VE: {reasons:join|; }. Record the"
        " reading of the axis at rest, at least ten times, for as long as a test takes."
    ),
    "CW-T027.coarse": (
        "up to {minutes:g} min lie between two readings: what comes and goes is missed"
    ),
    "CW-T027.short": (
        "it lasts {minutes:g} min, and {test:if|a positioning test of the job takes {test:g} min|no"
        " positioning test is so short}: the drift of a test is larger"
    ),
    "CW-T028": (
        "The effect of the air on the laser wavelength was removed:"
        " {least:+.3f}{most:if| to {most:+.3f}|} µm/m from {zero:.10g} mm on, where the display"
        " shows 0 ({equation:choose|ciddor=Ciddor|edlen=Edlén}; air at {air_c:.4g} °C,"
        " {pressure_hpa:.6g} hPa, {humidity_percent:.3g} % on average). The display of the"
        " instrument {assumed:if|is assumed to use|uses} the refractive index"
        " {counted:.9f}"
        "{assumed:if|, air at 20 °C, 1013.25 hPa and 50 %: give `instrument_air` under"
        " `environment` where it uses another|}."
    ),
    "CW-T029": (
        "From the first to the last reading the laser wavelength changed the readings by"
        " {light:+.2f} µm and the expansion by {expansion:+.2f} µm, at the target with the largest"
        " change: both were removed. The mean over the targets still changed by {rest:+.2f}"
        "{std_error:if| ± {std_error:.2f}|} µm: drift of the machine itself, or of the set-up."
    ),
    "CW-T030.certain": "This cannot be right: {why}.",
    "CW-T030.small": (
        "All readings lie within {spread}: few machines are that good. Is the unit right?"
    ),
    "CW-T030.unit": (
        "The unit is probably {unit}, read as {read_as} ({odds:odds} to 1). The readings spread"
        " over {spread} and scatter by {scatter}; machine tools usually have values {factor:g}"
        " times {larger:if|larger|smaller}. Compare one reading with the instrument."
    ),
    "CW-T031.directions": "the runs in + and those in −",
    "CW-T031.near": (
        "Nearly the same readings: {runs:join|; }{more:if| and {more} more pairs}, while runs of"
        " this test differ by {noise}. Was one run copied and changed a little? Repeatability and"
        " noise is unknown from them."
    ),
    "CW-T031.pair": "{one} and {other} ({difference})",
    "CW-T031.runs": "runs {runs} and {more:if|{more} more|{last}} in {direction}",
    "CW-T031.same": (
        "The same readings to the last digit: {runs:join|; }{more:if| and {more} more such groups}."
        " Was one run copied, or are the readings rounded too coarsely? Repeatability and noise"
        " cannot be found from them."
    ),
    "CW-T032": (
        "The mean reversal value is +{reversal}, while lost motion gives a negative one{likely:if|:"
        " {odds:odds} to 1 that|: perhaps} the directions + and − are swapped or the sign of the"
        " deviations is turned, unless the backlash compensation is too large. A table made from"
        " swapped directions doubles the lost motion. Check at one target: with lost motion the"
        " deviation of an approach in + is the smaller one."
    ),
    "CW-T033": (
        "The targets, {first} to {last}, are whole millimetres when they are taken for inches: are"
        " they in inches?"
    ),
    "CW-T034": (
        "The same measurement as {tests}{others:if| and others}: given twice it proves nothing new."
    ),
    "CW-T035": (
        "{targets} {targets:plural|target|targets}, where the standard asks for {fewest} at least:"
        " of what lies between them nothing is known. Parameters and limits speak of"
        " {targets:plural|this target|these targets} alone."
    ),
    "CW-T036": (
        "The tests {test} and {other} contradict each other: they differ by {difference:.2f}"
        " {unit}, {what:choose|error=the error itself|reversal=the mean reversal itself} is"
        " {size:.2f} {unit}. Were sign, directions, unit, axis and state the same? Only {test}"
        " counts, {other} does not."
    ),
    "CW-T037": (
        "The tests of axes {one} and {other} show the same error: {odds:odds} to 1 that one axis"
        " was measured for both, or one file given for the other. A table made from the test of"
        " another axis makes its error larger. Which axis moved in each test?"
    ),
    "CW-T038": (
        "The record of the environment {file} has a gap during the test, {gap:2sig} times as long"
        " as its rows usually lie apart: in between, the values were taken on a straight line."
    ),
    "CW-T039": (
        "The readings do not say when they were taken: the mean of the record of the environment"
        " was used. Within the record the correction varies by {range:.2f} µm over {length:.5g} mm,"
        " and the readings may be wrong by as much. Add a column `time` to the measurement file, or"
        " give the record of the time of the test alone."
    ),
    "reason.cannot_be_formed": "cannot be formed from these readings",
    "reason.no_common_angle": "the two directions have no angle in common",
    "reason.no_reading": "no reading in the {direction} direction at {position}",
    "reason.not_calibrated": (
        "the length of the bar was not calibrated (ISO 230-4:1996, clause 4.5)"
    ),
    "reason.not_measured": "not measured in the {direction} direction",
    "reason.one_approach": "one approach per direction ({clause})",
    "reason.one_reading": (
        "only one reading in the {direction} direction at {position}, so no standard deviation"
        " there"
    ),
    "reason.undefined_1988": (
        "not defined by ISO 230-2:1988 (clauses 2 and 6: R, A and the mean reversal value)"
    ),
    "reason.undefined_1996": "not defined by ISO 230-4:1996 (clauses 3.3 to 3.5: H, G and F)",
    "reason.undefined_2005": (
        "not defined by ISO 230-4:2005, which has the bidirectional circular deviation in its place"
    ),
}
