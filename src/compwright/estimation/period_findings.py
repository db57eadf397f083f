"""What a search for periods found, in words for the user: what to look for, and with which odds
(odds: Kass and Raftery, J. Am. Stat. Assoc. 90, 1995).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from compwright.estimation.period_models import PeriodSearch
from compwright.estimation.usual_periods import USUAL_PERIODS
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.targets import told_targets

#: A period is a usual one within this part of it.
_NEAR = 0.004
#: A period is the spacing of nodes within this part of it, as well as few targets tell it.
_AS_SPACED = 0.02
#: Periods of less probability stand in the prediction alone: of nothing that is there some are
#: always left at a few per cent.
_SAID = 0.2


def period_findings(
    search: PeriodSearch,
    targets: FloatArray,
    kind: AxisKind,
    known: Sequence[float],
    fitted: Sequence[float],
    nodes: Sequence[float] = (),
) -> list[Finding]:
    """Return what the search at the ``targets`` (m,) says: periods that were found (CW-E012), such
    as cannot be told apart (CW-E013), that nothing was found or could be (CW-E014), and which of
    the ``known`` periods (mm or deg) are not among the ``fitted`` because the data do not tell them
    (CW-E015). ``nodes``: of a table that acted, mm or deg.
    """
    unit = kind.unit
    found: list[Finding] = []
    grouped = {period for group in search.sure for period in group}
    told = [
        each for each in search.found if each.period not in grouped and each.probability >= _SAID
    ]
    found += [
        Finding(
            "CW-E012",
            "info",
            f"The error repeats every {each.period:.5g} {unit} (probability"
            f" {100 * each.probability:.0f} %, {_odds(each.probability)}):"
            f" {meaning(each.period, kind)}.{_of_nodes(each.period, nodes, unit)} It counts in the"
            " estimate and the prediction with that probability",
        )
        for each in told
        if each.named
    ]
    open_ = ", ".join(
        f"{each.period:.5g} {unit} ({100 * each.probability:.0f} %)"
        for each in told
        if not each.named
    )
    if open_:
        message = (
            f"The error may repeat every {open_}: these targets do not settle it, and each counts"
            " with its probability. More targets at random offsets would tell"
        )
        found.append(Finding("CW-E012", "info", message))
    low, high = float(targets[0]), float(targets[-1])
    for group in search.sure:
        named = ", ".join(f"{period:.4g}" for period in sorted(group, reverse=True)[:8])
        more = f" and {len(group) - 8} others" if len(group) > 8 else ""
        found.append(
            Finding(
                "CW-E013",
                "warning",
                f"The error repeats, but these targets cannot tell with which period: {named}"
                f"{more} {unit} look the same there. None is certainly taken out, and a test at"
                f" other targets may show all of it;"
                f" {told_targets(low, high, targets.size, unit)}",
            )
        )
    if not told and not search.sure and not known:
        found.append(Finding("CW-E014", "info", _nothing(search, targets, unit)))
    found += _left_out(known, fitted, unit)
    return found


def unseen_findings(
    unseen: Sequence[float], found: Sequence[float], kind: AxisKind
) -> list[Finding]:
    """Return the known periods (mm or deg) that the readings do not show while they show the
    ``found`` ones (CW-E016): the period may be told wrong.
    """
    if not unseen or not found:
        return []
    unit = kind.unit
    told, instead = (" and ".join(f"{one:.5g}" for one in each) for each in (unseen, found))
    message = (
        f"The readings show no error that repeats every {told} {unit}, as the job says"
        f" (screw_pitch), but one that repeats every {instead} {unit}: is the pitch right? Both"
        " stay in the estimate; a wrong one does no harm there, but the grid is chosen for it"
    )
    return [Finding("CW-E016", "warning", message)]


def _nothing(search: PeriodSearch, targets: FloatArray, unit: str) -> str:
    intervals = np.diff(targets)
    if search.curve is None:
        return (
            f"Too few targets ({targets.size}) to look for a periodic error: eight at random"
            " offsets show some, more are better"
        )
    if np.ptp(intervals) <= 1e-3 * np.mean(intervals):
        return (
            "No period was found, but equal spacing hides those that divide it"
            f" ({np.mean(intervals):.4g} {unit}); the targets that CW-T008 proposes would show them"
        )
    probability = sum(model.probability for model in search.models if not model.periods)
    hidden = 1.0 - probability
    chance = "of less than 1 %" if hidden < 0.01 else f"of {100 * hidden:.0f} %"
    return (
        "No screw pitch or other period is given, and none was found: there is"
        f" a chance {chance} that the error repeats with a period that these targets hardly show"
    )


def _left_out(known: Sequence[float], fitted: Sequence[float], unit: str) -> list[Finding]:
    if len(fitted) == len(known) or not fitted:
        return []
    named = ", ".join(f"{period:g}" for period in fitted)
    message = (
        f"Of {len(known)} known periods the readings tell {len(fitted)}: {named} {unit}; the others"
        " are not fitted"
    )
    return [Finding("CW-E015", "info", message)]


def _of_nodes(period: float, nodes: Sequence[float], unit: str) -> str:
    """Return what a period says that is also the spacing of the nodes of a table that acted."""
    spacing = float(np.median(np.diff(nodes))) if len(nodes) > 2 else 0.0
    if abs(period - spacing) > _AS_SPACED * period:
        return ""
    return (
        f" The nodes of the table in the control are also {spacing:.5g} {unit} apart: a table that"
        " was not active as its files say leaves an error that looks like this; check first that it"
        " was."
    )


def _odds(probability: float) -> str:
    if probability > 0.999:
        return "odds above 1000 to 1"
    if probability >= 0.5:
        return f"odds {significant(probability / (1.0 - probability))} to 1"
    return f"odds 1 to {significant((1.0 - probability) / probability)}"


def meaning(period: float, kind: AxisKind) -> str:
    """Return what makes an error of this ``period`` (mm or deg), in words: what to look for."""
    unit = kind.unit
    once, twice = (
        ", or ".join(
            each.reason
            for each in USUAL_PERIODS[kind]
            if abs(each.size - times * period) <= _NEAR * times * period
            and not each.reason.startswith("half ")
        )
        for times in (1, 2)
    )
    words = []
    if once:
        words.append(f"look for what turns or repeats once in {period:.5g} {unit}: {once}")
    if twice:
        begin = "or for" if once else "look for"
        words.append(f"{begin} what does so twice in {2.0 * period:.5g} {unit}: {twice}")
    if words:
        return "; ".join(words)
    if kind is AxisKind.ROTARY:
        return (
            f"no usual division ({360.0 / period:.4g} in a turn): look for the turn of the worm or"
            " of the motor through its gear, and the pitch of the scale"
        )
    return (
        "no usual lead: look for the turn of the motor through a belt or gear, half of it, the"
        " pitch of the scale or rack, a pair of magnets"
    )
