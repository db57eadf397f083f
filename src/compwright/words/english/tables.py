"""What the fit of a table says."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "The table leaves {uncovered:g} {unit} of the travel uncovered,"
        " {side:choose|below=below|above=above} {end:g} {unit}: there the end value is held"
    ),
    "CW-F001.step": (
        "The table leaves {uncovered:g} {unit} of the travel uncovered,"
        " {side:choose|below=below|above=above} {end:g} {unit}: there the table gives nothing: a"
        " step of {step}"
    ),
    "CW-F002": (
        "{finest:if|The finest spacing that {allowed:if|this control allows|is chosen"
        " automatically} here, {spacing} ({points} points),|The spacing of {spacing}} cannot hold"
        " an error of period {periods:g} {unit}: {left_out:if|it is left out of the table, {whole}"
        " rms|{share:if|of {whole} rms it leaves {left} ({share:.0%})|it leaves nothing of it}}. A"
        " third of the period holds it: {needed_spacing:g} {unit}, {needed_points} points over the"
        " travel{most_points:if|; this control has {most_points}}"
    ),
    "CW-F003": (
        "The reference position ({reference:g} {unit}) lies outside the table ({start:g} to {end:g}"
        " {unit}): there the control applies {held:if|its end value, which is therefore"
        " zero|nothing}, and the error between them is not corrected"
    ),
    "CW-F004": "The control holds too few points for this error: {left} rms remain between them",
    "CW-F005": "The control cannot correct the reversal with one table: {left} rms remain",
    "CW-F006.grid": (
        "The table reaches up to {beyond:g} {unit} beyond the travel: its points lie at round"
        " positions, or where other columns of the same table need them"
    ),
    "CW-F006.reference": (
        "The control counts from the reference position ({reference:g} {unit}), which lies outside"
        " the travel: {extra} of the table's {nodes_size} points lie beyond the travel"
    ),
    "CW-F007": "The error exceeds the control's value range: {left} rms remain",
    "CW-F008": "The error is steeper than the control's largest increment: {left} rms remain",
    "CW-F009.compared": (
        "Magnification {magnification} is set in place of {before}: it leaves {left:if|{left}"
        " rms|nothing}. Magnification {before} (increments of {increments} times {step}) would"
        " leave at least {at_least} rms"
    ),
    "CW-F009.smallest": (
        "Magnification {magnification}, the smallest, is enough: increments of {increments}"
        " times {step} leave {left:if|{left} rms|nothing}"
    ),
    "CW-F010": (
        "The job asks for the least {goal}. The table of least expected square is used instead:"
        " {why:choose|slope=this control holds one slope and no table|increments=this control holds"
        " whole increments only|no_gain=rounded to whole increments, the table for {goal} shows no"
        " gain in tests}"
    ),
    "CW-F011": (
        "The existing grid stays although its points are {spacing:g} {unit} apart: {reason}; the"
        " control has run with it. table.spacing: auto chooses a spacing that is large enough"
    ),
    "mode.one_asked": "One table and one reversal value, as the job asks",
    "mode.one_constant": (
        "One table and a constant between the directions: what is wanted does not vary more (log"
        " odds {odds:.1f}, strong from {strong:g} on)"
    ),
    "mode.one_drift": (
        "One table and one reversal value: the reversal changes along the travel by about what the"
        " drift within each run would show with a constant play"
    ),
    "mode.one_held": (
        "One table and one reversal value: the control holds one table for both directions"
    ),
    "mode.one_unless_asked": (
        "One table and one reversal value: two tables only where the job asks for them (mode:"
        " bidirectional)"
    ),
    "mode.slope": "One slope and one reversal value: the control holds no table",
    "mode.two_asked": "Two tables, as the job asks",
    "mode.two_cost": "Two tables: a constant between the directions would cost {cost} rms",
    "mode.two_vary": (
        "Two tables: the reversal varies with position (log odds {odds:.1f}, strong from {strong:g}"
        " on)"
    ),
}
