"""Write what a verification with the verdict ``good`` proves about a real machine, in the form of
keys of a job and of a control definition.

The user copies the keys: the job and the definition themselves are not changed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from compwright.documents.proof_lines import proven_lines
from compwright.documents.verification import VerifiedAxis
from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.foundations import storage
from compwright.records.axis import Direction, FloatArray
from compwright.verification.proven_facts import ProvenAxis, proven_axis, sign_odds
from compwright.workflow.verify.next_round import Verified

FOLDER: Final = "proven"
_FILL_IN: Final = "fill in"


def proven_files(
    found: Verified, document: Mapping[str, Any], results: Sequence[Path], loaded: Sequence[Path]
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Return files that state which facts a verification proves, and messages for the user.
    ``results``: the folders of the run and of the verification; ``loaded``: the files that were
    read back.

    If a good verification proves nothing about a machine, there are no files, and a message gives
    the reason.
    """
    if document["verdict"] != "good" or not found.axes or not loaded:
        return {}, ()
    lacking = next(_lacking(found, results, loaded), None)
    if lacking is not None:
        return {}, (f"nothing is proven of the control: {lacking}",)
    axes = [_proven(found, name) for name in found.axes]
    plan, definition = found.plan, found.control.definition
    serial = plan.machine.get("serial", "")
    name = ", ".join(filter(None, (plan.machine.get("name"), plan.machine.get("type"))))
    entry = {
        "control": f"{definition.title}; software version: {_FILL_IN}",
        "machine": name or _FILL_IN,
        "date": _dates(found) or _FILL_IN,
        "how": _how(found, axes),
    }
    heading = [
        *_summary(axes),
        f'Put what no file says in the place of "{_FILL_IN}".',
    ]
    own = {**entry, "machine": f"{entry['machine']}, {serial}" if serial else entry["machine"]}
    return {
        f"{FOLDER}/for_the_job.yaml": proven_lines(
            own, ["For the job file, next to its other keys.", *heading], 2
        ),
        f"{FOLDER}/for_the_definition_{definition.id}.yaml": proven_lines(
            entry,
            [f"For the definition {definition.id}, in the place of its key proven.", *heading],
            2,
        ),
    }, (
        f"what this machine proves of the control is in {FOLDER}/: add for_the_job.yaml to the job",
    )


def _lacking(found: Verified, results: Sequence[Path], loaded: Sequence[Path]) -> Iterator[str]:
    """Yield each reason why a verification, although its verdict is ``good``, proves nothing about
    a real machine. ``results``: the folders of the run and of the verification; ``loaded``: the
    files that were read back.
    """
    roots = {storage.resolved(folder) for folder in results}
    if any(roots & {path, *path.parents} for path in map(storage.resolved, loaded)):
        yield "--loaded names files of the result folder, not what was read back"
    for name, axis in found.axes.items():
        codes = {finding.code for finding in axis.findings}
        if axis.loading["verdict"] != "loaded" or "CW-V010" not in codes:
            yield f"axis {name} was not read back as planned"
        if found.plan.axes[name].fitted is None:
            yield f"the plan contains no table for axis {name}"
    headers = [
        result.test.header for axis in found.axes.values() for result in (axis.before, axis.after)
    ]
    if any("simulated" in map(str.lower, header) for header in headers):
        yield "a simulated test is not a test of a machine"


def _proven(found: Verified, name: str) -> ProvenAxis:
    planned, axis = found.plan.axes[name], found.axes[name]
    fitted, active = planned.fitted, planned.active
    new = 0.0 if fitted is None else fitted.compensation.backlash
    old = 0.0 if active is None else active.backlash
    return proven_axis(
        name,
        axis.loading,
        _sign_odds(axis),
        others=len(found.plan.axes) > 1,
        backlash=abs(new - old) > 0.0,
        two_curves=fitted is not None and fitted.mode == "bidirectional",
    )


def _sign_odds(axis: VerifiedAxis) -> float:
    """Return the odds that the sign of the table is right, from tests before and after loading."""
    targets = axis.after.test.targets
    curves = []
    for direction, expected in (
        (Direction.POSITIVE, axis.expected.positive),
        (Direction.NEGATIVE, axis.expected.negative),
    ):
        after = axis.after.test.readings(direction)
        before = axis.before.test.readings(direction)
        if after.any() and before.any():
            curves.append(
                (
                    expected,
                    _between(axis, direction, targets),
                    mean_deviation(axis.after.test.deviations(direction)),
                )
            )
    counts = count_readings(axis.after.test.deviations(Direction.POSITIVE))
    if not counts.any():
        counts = count_readings(axis.after.test.deviations(Direction.NEGATIVE))
    return sign_odds(curves, axis.expected.s / np.sqrt(np.maximum(counts, 1.0)))


def _between(axis: VerifiedAxis, direction: Direction, targets: FloatArray) -> FloatArray:
    """Return the means of the test before, interpolated at the targets of the test after."""
    test = axis.before.test
    means = mean_deviation(test.deviations(direction))
    known = np.isfinite(means)
    order = np.argsort(test.targets[known])
    found: FloatArray = np.interp(targets, test.targets[known][order], means[known][order])
    return found


def _dates(found: Verified) -> str:
    dates = [
        text
        for axis in found.axes.values()
        for key, text in axis.after.test.header.items()
        if key.lower() == "date"
    ]
    return ", ".join(dict.fromkeys(dates))


def _how(found: Verified, axes: Sequence[ProvenAxis]) -> str:
    values = []
    for one in axes:
        axis = found.axes[one.axis]
        before, after = (result.parameters.get("A") for result in (axis.before, axis.after))
        if before is not None and after is not None:
            factor, unit = (1e3, "um") if axis.after.test.kind.unit == "mm" else (3600.0, "arcsec")
            values.append(f"{one.axis} A {before * factor:.1f} -> {after * factor:.1f} {unit}")
    assumed = [
        f"{entry.fact} {entry.value}"
        for entry in found.plan.assumed
        if "unconfirmed" in entry.evidence
    ]
    by = f"; under {', '.join(dict.fromkeys(assumed))}" if assumed else ""
    text = "; ".join([", ".join(values), *_summary(axes)])
    return f"compwright verify: good, read back as written; {text}{by}"


def _summary(axes: Sequence[ProvenAxis]) -> list[str]:
    """Return two lines of text: the facts that the tests prove, and those that they do not."""
    proven = dict.fromkeys(fact for one in axes for fact in one.proven)
    left = dict.fromkeys(fact for one in axes for fact in one.unproven if fact not in proven)
    return [
        f"proven: form of the files (read back as written), {', '.join(proven) or 'nothing else'}",
        f"not proven: {', '.join(left) or 'nothing of these'}",
    ]
