"""What is noticed about a control's files, in them and between two sets of them."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-S001": "{file}: the last line has no line end; check that the file is complete",
    "CW-S002": "{file}: no {mark} at the end; check that the file is complete",
    "CW-S003": (
        "{label}: {quantity} is given several times; the {rule} value counts: {value} ({where})"
    ),
    "CW-S004.not_zero": (
        "{label}: {values} values behind the end of the table ({first} to {last}) are not"
        " used by the control, {not_zero} of them not zero: an older, longer table, unless"
        " its end or its spacing is wrong"
    ),
    "CW-S004.zero": "{label}: {values} values behind the end of the table are zero and not used",
    "CW-S005": (
        "{label}: {quantity} is not in the files; counted as {value}. If the control has"
        " another value, that one was active in the tests, and what is written or shown is"
        " wrong by the difference: look it up at the control, or add the file that says it"
    ),
    "CW-S006": "axis {axis}: several measuring systems hold a table; system {system} is shown",
    "CW-S007": "{label}: {switch}; it corrects nothing",
    "CW-S008": "{label}: no file holds a table; counted as none",
    "CW-S009": (
        "{label}: {what} is ignored by the control: it {why:choose|table=has a table|rotary=is a"
        " rotary axis}"
    ),
    "CW-S010": "axis {axis} is taken as {address} of the control: check it, or give its address",
    "CW-S011": (
        "{label} ({input} on {output}) is left alone: {why}; {active:if|it is active on"
        " {output} over {input}, the same before and after|it is switched off}"
    ),
    "CW-S012.assignments": (
        "{file} is not named by the active line of assignments: it is not active"
    ),
    "CW-S012.no_axis": "{file} is not named by any axis: the control does not load it",
    "CW-S012.no_table": (
        "{files}{more:if| and {more} more}: no table, and named by no axis: the control does"
        " not load it as one"
    ),
    "CW-S012.not_given": (
        "{file}, active for the motion of {axis}, was not given: what it does to other axes"
        " is not known"
    ),
    "CW-S012.start_up_list": (
        "{file} is not named by the start-up list: the control does not load it"
    ),
    "CW-S013": "{file}, line {line}: read, although no manual shows this form ({lines} lines)",
    "CW-S014": (
        "axes {addresses:and} share the point numbers {first} to {last}: a change for one"
        " would change the other, so a new table gets numbers of its own"
    ),
    "CW-S015": (
        "{label}: cutting feed and rapid have different backlash values ({feed} and {rapid};"
        " {why}): what is shown here is {rapid_shown:if|rapid traverse, 1852|cutting feed,"
        " 1851}; a new table changes both values alike, so that their difference stays"
    ),
    "CW-S016": "{label}: point {first} should hold the same value as point {last} ({value:g})",
    "CW-S017": (
        "axis {axis}: the table of {file} ends its turn with another value than it began with"
    ),
    "CW-S018": (
        "{label}: the reference position is not machine zero (1240); the points are counted"
        " from the position {reference:g} (reference), which is unconfirmed: check the"
        " correction at two positions"
    ),
    "CW-S019": (
        "{label}: diameter programming (1006#3): positions, interval and corrections are"
        " taken in radius (unconfirmed); wrong by 2 is the usual fault, so check one position"
        " after loading"
    ),
    "CW-S030": "axis {partner} does not do the same as {leading}, with which it forms a gantry",
    "CW-S031.gantry": (
        "axes {axis} and {other} hold the same table: are they a gantry? Then name {other} in"
        " the job (gantry), so that both get the new one; a table on one of them alone racks"
        " the bridge"
    ),
    "CW-S031.single": (
        "axes {axis} and {other} hold the same table; the control's files say that axis"
        " {axis} is in no gantry"
    ),
    "CW-S032": "{label}: values and grid are all zero, which means no table",
    "CW-S033.ends": "{label} is endless, but its table does not repeat: it ends at both sides",
    "CW-S033.repeats": (
        "{label}: its table repeats every {period:g}, but the job gives no modulo; a new"
        " table will have ends"
    ),
    "CW-S034": "{label} is switched off in the files ({switches}); it corrects nothing",
    "CW-S035": (
        "axis {axis}: the job says that it moves alone; {parameter} can couple it with"
        " another axis. Keep that coupling off in every test, and load the tables of both"
        " axes before it is used again"
    ),
    "CW-S036": (
        "Axis {gantry} gets {table:choose|same=the same total|change=the same change to its"
        " own total} as axis {axis}, as the job says. The corrections of both differ by up to"
        " {after:.2f} {unit} afterwards, {before:.2f} {unit} before; the difference changes by"
        " at most {moved:.2f} {unit} at any position"
    ),
    "CW-S037": (
        "axis {axis}: axis {follows} follows it as a drive, without a position of its own"
        " ({parameter}): the table of axis {axis} serves both"
    ),
    "CW-S038": (
        "Axes {axis} and {gantry} move apart by up to {moved:.2f} {unit} (limit {limit:.2f}"
        " {unit}); axis {axis} gains {gain:.2f} {unit}. Their grids do not fit together. Give"
        " both axes the same grid in the control, or say table: same"
    ),
    "CW-S040": (
        "{label}: {bits} = 1 ({value}): in use on real machines, meaning not confirmed"
        " (perhaps interpolated compensation: then give the option output: ramp); it is left"
        " as it is"
    ),
    "CW-S041": (
        "{label}: on a full turn {own} is {first}, that is {zero} + 1, where the manual has"
        " {own} = {zero}. The points {first} to {last} are read as its sections; point"
        " {reference} stays reserved for the axis"
    ),
    "CW-S042": "axis {axis} is odd and left alone, with all its point numbers: {reasons:join|; }",
    "CW-S043": "{label}: {systems}; check the detection unit",
    "CW-S044": (
        "{label}: the reference return is towards {files} by 1006#5, towards {job} in the"
        " job; with one set of data it only moves the zero by the backlash, so the job is"
        " followed; two sets are refused until they agree"
    ),
    "CW-S045": (
        "{label}: {outside:g} {unit} of the travel lie outside its limits of {low:g} to"
        " {high:g} ({parameters}): are travel and targets in machine coordinates?"
    ),
    "CW-S046": (
        "{file}: its points are not equally spaced ({least:.10g} to {most:.10g}), which the"
        " control asks for; read as they are, never written so"
    ),
    "CW-S047": (
        "{label}: smooth backlash compensation divides 1851 into stages ({parameters}): it is"
        " left as it is, and shapes the {reach:g} {unit} behind a reversal at most"
        " (unconfirmed); a target nearer to one, in a test or in a part, sees another value"
        " than 1851"
    ),
    "CW-S048": "{label}: {function}",
    "CW-S049.none": (
        "{suggested}. The job names no screw pitch, so this period is searched first in the"
        " readings. If it is right, add screw_pitch: {lead:g} to the axis"
    ),
    "CW-S049.other": (
        "{suggested}; the job names {periods:g} instead, which is followed: check it at the screw"
    ),
    "CW-S049.suggested": (
        "{label}: the control's files suggest a period of {lead:g} {unit}, one turn of the"
        " motor ({evidence})"
    ),
    "CW-S050.cec": (
        "{label} ({input} on {output}) is left alone: {why}; {active:if|it is active on"
        " {output} over {input}, the same before and after|it is switched off}"
    ),
    "CW-S050.list": "{label} is left as it is and not shown: {why}",
    "CW-S050.sum": (
        "CEC tables {tables} on {output} are left alone: their sum is {low:g} to {high:g},"
        " and MD32720 $MA_CEC_MAX_SUM limits it to {limit:g}; they are active, the same"
        " before and after"
    ),
    "CW-S051": (
        "the tables between axes ({pairs}) are left as they are and not shown: the sign of"
        " CEC values is unknown; give the option cec_sign after the check on the card"
    ),
    "CW-S052": (
        "axis {axis}: the job names measuring system {number}, but the files switch"
        " compensation on for system {other} (MD32700): make sure that system {number} is in"
        " use"
    ),
    "CW-S053": (
        "axis {axis}: in addition to its table is active: {functions:join|; }. It is left as"
        " it is, and counts as active alike during the test and afterwards"
    ),
    "CW-S054": (
        "CEC tables {tables} are left alone: all their values are 0, on a grid that cannot be"
        " read; they correct nothing"
    ),
    "CW-S055": (
        "CEC tables are shown as corrections. By Siemens' manual (Extended Functions 03/2009,"
        " page 372) a positive value moves the axis in -, which is the opposite: give the"
        " option cec_sign after the check on the card"
    ),
    "CW-S056": (
        "axis {axis}: {period:if|its table repeats every {period:g}, but the job gives no"
        " modulo; a new table will have ends|it is endless, but its table does not repeat: it"
        " ends at both sides}"
    ),
    "CW-S057": (
        "{format}: no page says what the parameters {parameters} are on this series ({place};"
        " other series have units, paths or further compensation there): they are not"
        " counted, not compared with the job and left as they are. Look them up in the"
        " control's own manual: what compensates among them cancels only as long as the grid"
        " stays"
    ),
    "CW-F011.feed": (
        "at {feed:g} {unit}/min ({of:choose|option=option max_feed|rapid=rapid traverse 1420}) the"
        " control needs at least {least:g}: feed / {rule} ({evidence})"
    ),
    "CW-S060": (
        "Read back, not independently judged: only your own definition of {definition} says"
        " what its files do. A sign or a unit that is wrong in it is wrong in all of this."
        " Prove it on the machine, at one position and from both sides, before the whole"
        " table is active{expectation:if|. The corrections worked by hand are those of"
        " {expectation}: none was worked out for {definition}}"
    ),
    "CW-S061": (
        "{what}: {carried} is used as it is in the plan; to use another definition, run the job"
        " again"
    ),
    "CW-S062": "the control format {name} is taken for {definition}: {title}",
    "CW-S070": (
        "{file}: programs in it load or switch compensation when somebody runs them:"
        " {programs}; they were not run here, and what counts is the archive's own data"
    ),
    "CW-S071": (
        "{file}: its decimal commas are read as points; the control takes no such file: it is"
        " a listing, and may not be what the control holds"
    ),
    "CW-S072": (
        "{file}: the contents of the archive are not verified: nothing in its container says"
        " whether a value was changed after the export. Before you load, compare the three"
        " values per axis on the card with the control"
    ),
    "CW-S073": (
        "{file}: not carried out in the control, by the job (active: no). None of its tables and"
        " backlash values counts as loaded"
    ),
    "CW-S080": (
        "{files}: what the control makes of {what} is unknown, so only the entries are"
        " compared ({faults})"
    ),
    "CW-S081": "{files}: corrections are those of one reader alone; the second one says: {why}",
    "CW-S082": "{files}: no data of the control in {idle}",
    "CW-S083.new": (
        "{new} values that compensate were in no file of the plan, and were not looked at"
    ),
    "CW-S083.not_read": "{missing} values that compensate were not read back, and not looked at",
    "CW-S084": (
        "{files}: in the folder that was given, no line is a statement of {format}; left out"
    ),
    "CW-S085": (
        "{path} is what run wrote, not what was read back: nothing here says what is in the"
        " control; save it from the control and give that"
    ),
    "CW-S086": (
        "No file says whether {number:plural|axis {names} is|axes {names} are} linear or"
        " rotary. The unit of the corrections is unknown: thousandths of a mm (µm) or of a"
        " degree (3.6 arcsec). Give --option kind=linear or --option kind=rotary."
    ),
}
