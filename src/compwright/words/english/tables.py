"""Sentences about the fit of a table."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "The table does not cover {uncovered:g} {unit} of the travel"
        " {side:choose|below=below|above=above} {end:g} {unit}. The control applies the end value"
        " there"
    ),
    "CW-F001.step": (
        "The table does not cover {uncovered:g} {unit} of the travel"
        " {side:choose|below=below|above=above} {end:g} {unit}. The control corrects nothing"
        " there, so the axis steps by {step} at this end"
    ),
    "CW-F002": (
        "{finest:if|{allowed:if|The finest spacing that this control allows here|The finest"
        " spacing that is chosen automatically here}, {spacing} ({points} points),|The spacing of"
        " {spacing}} is too wide for an error of period {periods:g} {unit}. {left_out:if|This"
        " error ({whole} rms) is left out of the table|{share:if|Of this error, {whole} rms, the"
        " table leaves {left} ({share:.0%})|The table leaves nothing of this error}}. The table"
        " needs a third of the period as spacing: {needed_spacing:g} {unit}, which is"
        " {needed_points} points over the travel{most_points:if|. This control has {most_points}"
        " points}"
    ),
    "CW-F003": (
        "The reference position ({reference:g} {unit}) lies outside the table ({start:g} to {end:g}"
        " {unit}). There the control applies {held:if|the end value of the table. The correction"
        " must be zero at the reference position, so this end value is zero|no correction}. The"
        " error between the reference position and the table is not corrected"
    ),
    "CW-F004": (
        "The control has too few table points for this error: {left} rms of it remain between the"
        " points"
    ),
    "CW-F005": (
        "The control has one table for both directions, which cannot correct this reversal:"
        " {left} rms of it remain"
    ),
    "CW-F006.grid": (
        "The table reaches up to {beyond:g} {unit} beyond the travel, because its points lie at"
        " round positions or where other columns of the same table need them"
    ),
    "CW-F006.reference": (
        "The control counts the table points from the reference position ({reference:g} {unit}),"
        " which lies outside the travel. Therefore {extra} of the {nodes_size} points lie beyond"
        " the travel"
    ),
    "CW-F007": (
        "The correction would exceed the largest table value that the control accepts: {left}"
        " rms of the error remain"
    ),
    "CW-F008": (
        "The error is steeper than the largest step between two table points that the control"
        " accepts: {left} rms of it remain"
    ),
    "CW-F009.compared": (
        "The magnification is set to {magnification} instead of {before}, which leaves {left:if|"
        "{left} rms|nothing} of the error. With magnification {before}, one increment would be"
        " {step}. The control stores only {increments} increments per table point, so at least"
        " {at_least} rms would be left"
    ),
    "CW-F009.smallest": (
        "Magnification {magnification}, the smallest, is enough. One increment is then {step}. The"
        " control stores {increments} increments per table point: {left:if|{left} rms|nothing} of"
        " the error is left"
    ),
    "CW-F010": (
        "The job asks for a table with the smallest {goal}. The table with the least expected"
        " squared error is used instead: {why:choose|slope=this control has one slope and no"
        " table|increments=this control stores whole increments only|no_gain=rounded to whole"
        " increments, the table for {goal} shows no gain in simulated tests}"
    ),
    "CW-F011": (
        "The new table keeps the points of the existing table, although they are only {spacing:g}"
        " {unit} apart: {reason}. The control has worked with these points so far. To get a spacing"
        " that is wide enough, set `spacing: auto` in the table of the axis"
    ),
    "mode.one_asked": "One table and one reversal value, as requested in the job",
    "mode.one_constant": (
        "One table and one constant difference between the directions: the readings do not clearly"
        " show that this difference varies along the travel (evidence, as natural logarithm of the"
        " likelihood ratio: {odds:.1f}; strong from {strong:g})"
    ),
    "mode.one_drift": (
        "One table and one reversal value: the reversal changes along the travel, but the drift"
        " within each run can cause this change alone, with a constant backlash"
    ),
    "mode.one_held": (
        "One table and one reversal value: the control has one table for both directions"
    ),
    "mode.one_unless_asked": (
        "One table and one reversal value: two tables are made only if the job requests them"
        " (`mode: bidirectional`)"
    ),
    "mode.slope": "One slope and one reversal value: the control has no table",
    "mode.two_asked": "Two tables, as requested in the job",
    "mode.two_cost": (
        "Two tables: one constant difference between the directions would leave {cost} rms more"
    ),
    "mode.two_vary": (
        "Two tables, because the reversal value varies with the position (evidence, as natural"
        " logarithm of the likelihood ratio: {odds:.1f}; strong from {strong:g})"
    ),
}
