"""The next command to type, as the last line of ``run`` and ``verify``."""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

#: Stands for the folder with the files that were saved from the control after loading.
READ_BACK = "READ_BACK"
_AFTER = "AFTER_FILE"
#: How the names of entry sheets begin.
_SHEETS: Final = ("entry_", "cross_", "straightness_")
#: Findings that make the test of a circle after loading itself doubtful.
_UNTRUSTED: Final = {"CW-V021", "CW-V024", "CW-V025", "CW-V026", "CW-V029", "CW-V032"}
#: What shells read inside of double quotes.
_ODD: Final = re.compile(r'["$`\\!%]')


def after_run(outcome: Any, job: Path, out: Path, *, apart: bool) -> str:
    """Return the last line of ``run``: the next step, with the command to type. ``apart``: whether
    the results are in a folder other than the default one of the job.

    ``job``: the job file. ``out``: the folder of its results.
    """
    again = _command("run", job, *(("--out", out) if apart else ()), "--force")
    if outcome.no_tables:
        return f"Next: state what is in the control (states: as_found), then type: {again}"
    if outcome.prediction["doubts"]:
        return (
            "Next: load nothing yet. Check the doubts above first, or acknowledge them in the"
            f" job, then type: {again}"
        )
    card = out / "card" / "card.html"
    if any(path.is_relative_to(out / "tables") for path in outcome.files):
        return (
            f"Next: do the steps of {card}, save the control's files to {READ_BACK}, then type: "
            + _command("compare", out, "--loaded", READ_BACK)
        )
    if any(path.name.startswith(_SHEETS) for path in outcome.files):
        return f"Next: do the steps of {card}, measure again, then type: " + _command(
            "verify", job, "--after", _AFTER, *(("--plan", out) if apart else ())
        )
    return f"Next: there is nothing to load; the reasons are above and in {out / 'report.html'}"


def after_verify(
    outcome: Any,
    job: Path,
    out: Path,
    after: Sequence[str],
    *,
    plan: Path,
    given: Sequence[object],
    read_back: bool,
) -> str:
    """Return the last line of ``verify``: the next step, with the command to type. ``given``: the
    options with paths, which are repeated in that command.

    ``after``: the tests after loading. ``plan``: the plan that was used. ``read_back``: whether the
    files read back from the control were given.
    """
    document = outcome.document
    then, folder = document.get("next") or {}, out / "next"
    tables = any(path.is_relative_to(folder / "tables") for path in outcome.files)
    verdicts = {name: axis["loading"]["verdict"] for name, axis in document["axes"].items()}
    open_ = ("state", "loaded", "undecided")  # of these, nothing above names a fault to correct
    faulty = [name for name, verdict in verdicts.items() if verdict not in open_]
    first = f"correct what is named above for {', '.join(faulty)}, " if faulty else ""
    if tables or any(axis["table"] for axis in then.get("axes", {}).values()):
        return (
            f"Next: {first}do the steps of {folder / 'card' / 'card.html'}, save the control's"
            f" files to {READ_BACK}, then type: "
            + _command("compare", folder, "--loaded", READ_BACK)
        )
    if document["verdict"] == "good":
        return f"Next: keep the folder {out}. To see the years, type: " + _command("history", out)
    again = [word for file in after for word in ("--after", file)]
    loaded = ("--loaded", READ_BACK) if read_back else ()
    axes, circles = document["axes"].values(), document["circles"].values()
    planes = [circle["squareness"] for circle in circles if circle["squareness"]]
    active = all(axis["loading"]["verdict"] == "loaded" for axis in axes) and all(
        plane["active"] for plane in planes
    )
    found = {finding["code"] for part in (document, *circles) for finding in part["findings"]}
    own = {finding["code"] for axis in axes for finding in axis["findings"]}
    codes = found | own
    wrong = codes & {"CW-V011", "CW-S087"}
    proven = wrong or {*verdicts.values()} - {"loaded", "undecided"}
    doubtful = [] if proven else sorted(_UNTRUSTED & found)
    lacking = doubtful or (sorted({"CW-V023", "CW-V034"} & found) if active else [])
    if lacking:
        good = () if own & _UNTRUSTED else outcome.of_axes
        open_circles = _circles_of(lacking, document)
        circled = (
            file
            for name, files in outcome.of_circles.items()
            if name not in open_circles
            for file in files
        )
        kept = [word for file in (*good, *circled) for word in ("--after", file)]
        return f"Next: {_what_to_measure(lacking, check=bool(doubtful))}, then type: " + (
            _command("verify", job, *kept, "--after", _AFTER, *given, *loaded, "--force")
        )
    compare = _command("compare", plan, "--loaded", READ_BACK)
    if not read_back:
        return f"Next: save the control's files to {READ_BACK}, then type: {compare}"
    if wrong:
        return (
            "Next: load what differs from the plan or is missing, save the control's files to"
            f" {READ_BACK}, then type: {compare}"
        )
    if "CW-V033" in codes:
        return f"Next: save all of the control's files to {READ_BACK} again, then type: {compare}"
    again_run = _command(
        "run", job, "--out", plan.parent if plan.suffix == ".json" else plan, "--force"
    )
    if "CW-S088" in codes:
        return (
            "Next: check on the control the coupling that CW-S088 names; if it is right, state it"
            f" in the job (gantry) with the files read back (states), then type: {again_run}"
        )
    idle = [name for name, verdict in verdicts.items() if verdict == "state"]
    if idle:
        return (
            f"Next: {first}state what was active in the first test of {', '.join(idle)} (states),"
            f" then type: {again_run}"
        )
    if not then and active and not document["doubts"]:
        return "Next: the table is active, but not enough. To correct again, type: " + _command(
            "verify", job, *again, *given, "--loaded", READ_BACK, "--update", "--force"
        )
    return "Next: correct what is named above, measure again, then type: " + _command(
        "verify", job, "--after", _AFTER, *given, "--loaded", READ_BACK, "--force"
    )


def _circles_of(codes: Sequence[str], document: Mapping[str, Any]) -> set[str]:
    """Return the names of the circles to which a finding with one of the ``codes`` belongs."""
    return {
        name
        for finding in document["findings"]
        if finding["code"] in codes
        for name in (
            finding.get("values", {}).get("circle", ""),
            *finding.get("values", {}).get("circles", ()),
        )
    } | {
        name
        for name, circle in document["circles"].items()
        if any(finding["code"] in codes for finding in circle["findings"])
    }


def _what_to_measure(codes: Sequence[str], *, check: bool) -> str:
    """Return the step for the findings with these ``codes``; ``check``: a test is doubtful."""
    names, s = (codes[0], "s") if len(codes) == 1 else (f"the findings {' and '.join(codes)}", "")
    if check:
        return f"check the test after loading as {names} say{s}, or measure it again"
    return f"measure what {names} name{s}"


def _command(*words: object) -> str:
    """Return a command line, quoted so that it works on Linux, macOS and Windows."""
    texts = (word.as_posix() if isinstance(word, Path) else str(word) for word in words)
    return " ".join(["compwright", *map(_quoted, texts)])


def _quoted(text: str) -> str:
    whole = shlex.quote(text)
    if whole == text or _ODD.search(text):
        return whole
    return f'"{text}"'  # cmd.exe takes single quotes as letters
