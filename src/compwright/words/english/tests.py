"""Sentences about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Several runs were measured, but each parameter belongs to one run (clauses 3.2 and 5)."
        " The parameters given are those of {first:and}. The other runs: {others}."
    ),
    "CW-C001.other": "{direction} run {run}: G {G}",
    "CW-C001.run": "{direction} run {run}",
    "CW-C002": (
        "Only the {direction} direction was measured. So there are no parameters of both"
        " directions, and squareness and servo mismatch cannot be separated. Measure the other"
        " direction too."
    ),
    "CW-C003": (
        "The length of the bar was not calibrated, so the radial deviation F is not given. D, and"
        " F about the least-squares centre, use the nominal length."
    ),
    "CW-C004": (
        "The samples of {run} are {interval:3sig}° apart. Short spikes at the reversal points can"
        " lie between two samples, and then G, F and H come out too small. Measure with a higher"
        " sample rate or a lower feed."
    ),
    "CW-C005.arc": "{run} covers {covered:.5g}° of an arc of {arc:.5g}°.",
    "CW-C005.gap": "No samples of {run} from {gaps}: what the path does there is not evaluated.",
    "CW-C006.no_feed": "A feed of {feed:g} mm/min is not possible: correct the feed in the file.",
    "CW-C006.time": (
        "At {feed:g} mm/min a circle of {radius:g} mm takes {seconds:3sig} s: check the unit of the"
        " feed."
    ),
    "CW-C007": (
        "{run} covers {covered:.5g}°, more than the arc of {arc:.5g}°. The samples seem to"
        " include the run-up before the arc and the overrun after it: check the settings of the"
        " export."
    ),
    "CW-C008.feed": (
        "The ccw run has {ccw} samples and the cw run {cw}. At one sample rate one direction had"
        " {share:.0f} % of the feed of the other. Squareness and servo mismatch are then mixed."
        " Check the feed override and measure both directions at one feed."
    ),
    "CW-C008.few": (
        "The ccw run has {ccw} samples and the cw run {cw}. The common circle therefore lies"
        " nearer to the direction with more samples."
    ),
    "CW-C009": (
        "{repeated} samples of {run} have the same angle as another sample. All samples are used."
    ),
    "CW-C010": (
        "On an arc, F is measured from the set-up centre (clause 3.5 a). It therefore contains"
        " the offset of this centre, here about {offset}. F about the least-squares centre is"
        " given as well."
    ),
    "CW-C011": (
        "The circle lies {offset} from the set-up centre. The angles were taken as commanded; if"
        " they were measured from the set-up centre, the radii are wrong by up to {effect}. Bring"
        " the set-up centre closer to the centre of the circle and measure again."
    ),
    "CW-C012": (
        "The radius changed by {step} from the start of {run} to its end. Either the machine"
        " drifted during the run, or the bar moved, or readings of the run-up are among the"
        " samples. Repeat the run."
    ),
    "CW-C013": (
        "Every sample of {run} is exactly zero. The run was probably not measured: measure it"
        " again."
    ),
    "CW-C014.mirrored": (
        "The deviations fit the causes of ISO 230-4 better with the angles of the cw runs"
        " mirrored ({left} rms are left, not {given}). The angles of both directions must"
        " increase from the first axis to the second. If those of cw were counted in the"
        " direction of travel, write {turn:g}° minus each of them."
    ),
    "CW-C014.turned": (
        "The deviations fit the causes of ISO 230-4 better with the angles of the cw runs turned"
        " ({left} rms are left, not {given}). The angles of both directions must begin at the first"
        " axis. If those of cw begin at another axis, add {turn:g}° to each of them."
    ),
    "CW-C015": (
        "{first} and {second} have exactly the same readings. One of them is probably a copy of the"
        " other: measure it again."
    ),
    "CW-C016.coarse": (
        "The readings of {run} have steps of {step}. Errors of this size are hidden by them, and"
        " the standard errors of the causes do not hold. Measure with a resolution of 0.1 µm, or"
        " export more decimals."
    ),
    "CW-C016.single": (
        "{count:plural|One reading|{count} readings} of {run} {count:plural|deviates|deviate}"
        " from the neighbouring readings, by up to {off} at {angle:.5g}°. A knock or dirt can"
        " be the reason. Measure the run again."
    ),
    "CW-C016.still": (
        "The reading of {run} does not change over {parts:and}, although the path there does."
        " The instrument was at the end of its range, or it stopped. Set it up nearer to the"
        " centre and measure again."
    ),
    "CW-T001": (
        "The standard asks for 5 approaches to each target and direction; found {counts:and}."
    ),
    "CW-T001.count": "{count} in {direction}",
    "CW-T002.linear": (
        "{targets} targets over {length:.10g} mm are too few. The standard asks for at least 5"
        " per metre and at least 5 in all: here {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 asks for three positions in addition to 0°, 90°, 180°, 270°; there"
        " are {others}."
    ),
    "CW-T002.rotary": (
        "{targets} targets over {length:.10g}° are too few. For this travel the standard asks for"
        " at least {needed} (its table of target positions)."
    ),
    "CW-T003": (
        "Only approaches in direction {direction} were measured, so there are no parameters of"
        " both directions. Lost motion is unknown."
    ),
    "CW-T004": (
        "The standard asks for these principal positions too, but they are not among the targets:"
        " {positions}."
    ),
    "CW-T005.repeated_long": (
        "This test repeats its approaches over more than {limit}. Here the standard asks for two"
        " tests: one of the whole length with one approach per direction, and one with five"
        " approaches per direction over {limit} of the normal working area. The test was evaluated"
        " as it was measured."
    ),
    "CW-T005.repeated_missing": (
        "The axis is longer than {limit}, and this test has one approach per direction. In addition"
        " the standard asks for a test with five approaches per direction over {limit} of the"
        " normal"
        " working area."
    ),
    "CW-T005.whole_missing": (
        "The axis is longer than {limit}. In addition the standard asks for a test of its whole"
        " length with one approach per direction."
    ),
    "CW-T006.linear": (
        "The mean interval of the targets is {interval:.5g} mm. On an axis over 2 000 mm the"
        " standard allows at most 250 mm."
    ),
    "CW-T006.per_turn": (
        "{targets} targets over {turns:.4g} turns: at least eight per turn are needed."
    ),
    "CW-T006.rotary": (
        "The widest interval of the targets is {interval:.5g}°. On an axis over 360° the standard"
        " allows at most 45°."
    ),
    "CW-T006.turns": (
        "{length:.10g}° were measured; the standard asks for 1 800° (five turns) at most."
    ),
    "CW-T007.end": "{length} at the {end:choose|lower=lower|upper=upper} end",
    "CW-T007.outside": (
        "The targets {first} to {last} lie outside the travel {travel_start} to {travel_end} of"
        " the job. Check the offset and the direction of the target positions."
    ),
    "CW-T007.uncovered": (
        "A part of the travel was not measured: {ends:and}. That is more than one interval"
        " between targets."
    ),
    "CW-T008.equal": (
        "The targets are equally spaced ({interval}). A periodic error (screw pitch, scale pitch)"
        " stays hidden if its period divides this spacing. The standard asks for random offsets;"
        " {better}"
    ),
    "CW-T008.period": (
        "All targets lie at the same phases of the period of {period}. A periodic error of this"
        " period can stay hidden. Choose targets at different phases (clause on target"
        " positions); {better}"
    ),
    "CW-T009": (
        "The test uses a step cycle, which the standard allows for acceptance only if agreed in"
        " writing (annex of ISO 230-2). If the axis drifts by D during such a test, E and M become"
        " larger by about 0.92 D, and R hardly changes."
    ),
    "CW-T010": (
        "Readings are missing: {where:join|; }. Each target is evaluated with the readings that it"
        " has."
    ),
    "CW-T010.direction": (
        "in direction {direction}, {fewer} of {targets} targets {fewer:plural|has|have} fewer"
        " readings than the others ({at}{more:if| ...})"
    ),
    "CW-T011.rows": (
        "In traverse {traverses}{more:if| and {more} more}, up to {targets} neighbouring targets"
        " are exactly zero, while the other readings scatter. Probably they were not measured and"
        " were filled up with zeros. They are part of the result: if they were not measured,"
        " remove them from the file."
    ),
    "CW-T011.traverse": (
        "Run {run} in direction {direction} is exactly zero at all {targets} targets, so it was"
        " probably not measured. The result includes it. If the other runs scatter, table and"
        " prediction are made without it."
    ),
    "CW-T012": (
        "The readings drift: {how}. Without drift, chance alone would put the readings in such an"
        " order in {chance:.1f} % of all tests. Warm the axis up and measure again, because the"
        " drift makes R and A larger."
    ),
    "CW-T012.ends": (
        "{lower} at the lower end and {upper} at the upper end of the travel in direction"
        " {direction}"
    ),
    "CW-T012.growing": (
        "{drifts:join|; } from the first run to the last (the drift grows along the travel, as"
        " thermal expansion does)"
    ),
    "CW-T012.mean": "{drifts:and} from the first run to the last (mean over the targets)",
    "CW-T013.more": (
        "{more} more {more:plural|run is an outlier|runs are outliers}, by a smaller amount."
    ),
    "CW-T013.run": (
        "Run {run} differs from the other runs by {off:and}. The readings of the other runs"
        " scatter by {scatter} (robust standard deviation).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Run {run} in direction {direction} differs from the other runs by {off}. The readings of"
        " the other runs scatter by {scatter} (robust standard deviation).{compared:if|"
        " {compared}}"
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
        "At {targets} there are fewer than two readings per direction, so there is no standard"
        " deviation. Parameters that need it are not given.{others:if| For the other targets"
        " alone: {others}.}"
    ),
    "CW-T020": (
        "The uncertainty U (k = 2) is calculated from the contributors of ISO 230-2:2006, annex"
        " A, that the job declares. Their distributions are propagated (JCGM 101:2008); the"
        " coefficients of the annex are not used.{misalignment:if| A misaligned laser beam makes"
        " distances too short, never too long: over these targets by up to {misalignment:.2f} µm."
        " U includes ±{counted:.2f} µm for this.}"
    ),
    "CW-T021": (
        "No uncertainty is stated for VDI/DGQ 3441, because annex A of ISO 230-2 covers only the"
        " parameters of ISO 230-2."
    ),
    "CW-T022": (
        "The job gives U_theta but not thermal.alpha_m, the expansion coefficient of the machine."
        " The value of steel was assumed: {alpha_m:g} µm/(m K)."
    ),
    "CW-T023": (
        "The job gives U_alpha but not thermal.T_m, the temperature of the machine. The"
        " contribution of U_alpha is therefore missing from U. Add thermal.T_m."
    ),
    "CW-T024": (
        "The readings were converted to 20 °C of the {refer_to}: {slope:+.3f} µm/m were removed,"
        " with the fixed point at {x_fix:.10g} mm. Basis: {alpha_m:g} µm/(m K) at {T_m:g} °C for"
        " the {refer_to}, {alpha_d:g} µm/(m K) at {T_d:g} °C for the instrument."
    ),
    "CW-T025": (
        "The temperature changed from start to end of the test: {changes:and}. Over the"
        " {length:.5g} mm of the targets this means {drift:+.2f} µm from the first run to the"
        " last. The file does not give the time of each reading, so the expansion at the mean"
        " temperature of start and end was removed. The remaining expansion is in the readings as"
        " drift."
    ),
    "CW-T025.change": (
        "{of:choose|scale=scale|workpiece=workpiece|instrument=instrument} {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "The environmental variation E_VE is {E_VE}: the range of the readings in {file} over the"
        " whole record of {minutes:g} min. E_VE should cover only the duration of one positioning"
        " test. If your test takes less time, give its duration in the job: `E_VE: {{file: {file},"
        " duration_min: ..}}`."
    ),
    "CW-T026.within": (
        "The environmental variation E_VE is {E_VE}: the largest range of the readings in {file}"
        " within any {minutes:g} min."
    ),
    "CW-T027": (
        "The stand-still test {file} (axis at rest) cannot show the whole environmental variation"
        " E_VE: {reasons:join|; }. Record the reading of the axis at rest, at least ten times,"
        " for as long as a positioning test takes."
    ),
    "CW-T027.coarse": (
        "up to {minutes:g} min lie between two readings, so changes in between are missed"
    ),
    "CW-T027.short": (
        "it lasts {minutes:g} min, but a positioning test {test:if|of the job takes {test:g} min|"
        "takes longer}, so the drift of a test is larger"
    ),
    "CW-T028": (
        "The effect of the air on the laser wavelength was removed: {least:+.3f}{most:if| to"
        " {most:+.3f}|} µm/m, counted from {zero:.10g} mm, where the display shows 0"
        " ({equation:choose|ciddor=Ciddor|edlen=Edlén}; air on average {air_c:.4g} °C,"
        " {pressure_hpa:.6g} hPa, {humidity_percent:.3g} % humidity). The display of the"
        " instrument {assumed:if|is assumed to use|uses} the refractive index"
        " {counted:.9f}{assumed:if| (air at 20 °C, 1013.25 hPa, 50 % humidity). If it uses"
        " another index, give `instrument_air` under `environment`|}."
    ),
    "CW-T029": (
        "At the target with the largest change, the air changed the readings by {light:+.2f} µm"
        " (laser wavelength){expansion:if| and thermal expansion by {expansion:+.2f} µm} from the"
        " first reading to the last. {expansion:if|Both were|This was} removed. The mean over the"
        " targets still changed by {rest:+.2f}{std_error:if| ± {std_error:.2f}|} µm: {unused:if|the"
        " expansion of the scale, which is not removed because the job has no `thermal`, or a drift"
        " of the machine or the set-up. To use the column material_c, add `thermal` with"
        " `alpha_m`|the machine itself or the set-up drifted}."
    ),
    "CW-T030.certain": "The readings cannot be right: {why}. Check their unit.",
    "CW-T030.small": (
        "All readings lie within {spread}. Few machines are this accurate: check the unit of"
        " the readings."
    ),
    "CW-T030.unit": (
        "The readings were read as {read_as}, but their unit is probably {unit} ({odds:odds}"
        " times as likely as {read_as}). They spread over {spread} and scatter by {scatter};"
        " machine tools usually have values {factor:g} times {larger:if|larger|smaller}. Compare"
        " one reading with the instrument."
    ),
    "CW-T031.directions": "the runs in + and those in −",
    "CW-T031.near": (
        "These runs have nearly the same readings: {runs:join|; }{more:if| and {more} more"
        " pairs}. Other runs of this test differ by {noise}. Perhaps one run was copied and"
        " slightly changed; then repeatability and noise are unknown. Measure again."
    ),
    "CW-T031.pair": "{one} and {other} ({difference})",
    "CW-T031.runs": "runs {runs} and {more:if|{more} more|{last}} in {direction}",
    "CW-T031.same": (
        "These runs have the same readings to the last digit: {runs:join|; }{more:if| and {more}"
        " more such groups}. Either one run was copied, or the readings are rounded too coarsely."
        " Repeatability and noise cannot be found from them. Measure again, or export with more"
        " digits."
    ),
    "CW-T032": (
        "The mean reversal value is +{reversal}, but lost motion makes it negative. Unless the"
        " backlash compensation is too large, the directions + and − {likely:if|are probably"
        " ({odds:odds} times as likely as not)|may be} swapped, or the sign of the deviations is"
        " reversed. A table made from swapped directions doubles the lost motion. Check at one"
        " target: with lost motion the deviation of an approach in + is the smaller one."
    ),
    "CW-T033": (
        "Taken as inches, the targets {first} to {last} are whole numbers of millimetres. Check"
        " whether the file gives them in inches."
    ),
    "CW-T034": (
        "This is the same measurement as {tests}{others:if| and others}. A measurement that is"
        " given twice proves nothing more: give it once."
    ),
    "CW-T035": (
        "The test has {targets} {targets:plural|target|targets}, but the standard asks for at"
        " least {fewest}. The error between the targets is unknown. Parameters and limits are"
        " valid for {targets:plural|this target|these targets} alone."
    ),
    "CW-T036": (
        "The tests {test} and {other} contradict each other. They differ by {difference:.2f}"
        " {unit}, and {what:choose|error=the error itself|reversal=the mean reversal itself} is"
        " {size:.2f} {unit}. Only {test} is used, {other} is not. Check that both have the same"
        " sign, directions, unit, axis and control contents."
    ),
    "CW-T037": (
        "The tests of axes {one} and {other} show the same error. It is {odds:odds} times as"
        " likely as not that the same axis was measured for both, or that one file was given for"
        " both. A table made from the test of another axis makes the error larger. Check which"
        " axis moved in each test."
    ),
    "CW-T038": (
        "The environment record {file} has a gap during the test, {gap:2sig} times as long as the"
        " usual interval between its rows. Within the gap the values were interpolated on a"
        " straight line."
    ),
    "CW-T039": (
        "The readings have no time, so the mean of the environment record was used. Within the"
        " record the correction varies by {range:.2f} µm over {length:.5g} mm, and the readings"
        " may be wrong by as much. Add a column `time` to the measurement file, or give only the"
        " part of the record that belongs to the test."
    ),
    "CW-T040": (
        "The lost motion of {file} is not one constant: it goes from {first} at {first_move} to"
        " {last} at {last_move}. One value of backlash compensation, at best {constant}, leaves up"
        " to ±{left}. Take the value at the {over:choose|distance=distance|speed=speed} that the"
        " machine works with, and look for windup and friction."
    ),
    "CW-T041": (
        "The lost motion in {file} does not visibly depend on the"
        " {over:choose|distance=distance|speed=speed}: one constant value, {constant}, leaves up"
        " to ±{left}.{few:if| So few readings cannot show whether it does: measure at eight values"
        " or more, or repeat each.|}"
    ),
    "reason.cannot_be_formed": "cannot be calculated from these readings",
    "reason.no_common_angle": "the two directions have no angle in common",
    "reason.no_reading": "no reading in the {direction} direction at {position}",
    "reason.not_calibrated": (
        "the length of the bar was not calibrated (ISO 230-4:1996, clause 4.5)"
    ),
    "reason.not_measured": "the test was not measured in the {direction} direction",
    "reason.one_approach": "the test has only one approach per direction ({clause})",
    "reason.one_reading": (
        "only one reading in the {direction} direction at {position}, so no standard deviation"
        " there"
    ),
    "reason.undefined_1988": (
        "ISO 230-2:1988 does not define this parameter, only R, A and the mean reversal value"
        " (clauses 2 and 6)"
    ),
    "reason.undefined_1996": (
        "ISO 230-4:1996 does not define this parameter, only H, G and F (clauses 3.3 to 3.5)"
    ),
    "reason.undefined_2005": (
        "ISO 230-4:2005 does not define this parameter; it has the bidirectional circular"
        " deviation instead"
    ),
}
