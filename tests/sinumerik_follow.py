"""What comes after a table was loaded: what the control exports is held against the plan, a test is
taken; and the same where somebody slipped. The exit codes must be right.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

from backup_cases_sinumerik import NAMES, Case
from sinumerik_container import Packing
from sinumerik_judge import Outcome, Run, control_before, measure, rows_of, targets_of
from virtual_sinumerik import Register, VirtualSinumerik, assignments


def exported(case: Case, after: VirtualSinumerik) -> dict[str, str]:
    """The control's own files as it exports them with these registers, in the form in which they
    were given; what stood in no file stands before the end of the tables or of the machine data.
    """
    texts = {"MD.INI": case.md, "AX_EEC.INI": case.eec}
    if case.cec is not None:
        texts["NC_CEC.INI"] = case.cec
    elif any(name.startswith(("AN_CEC", "SN_CEC")) for name, _ in after.registers):
        texts["NC_CEC.INI"] = "CHANDATA(1)\nM17\n"
    base = VirtualSinumerik(names=dict(after.names))
    for text in texts.values():
        base.load(text, protected=False)
    changed = {
        register: value.text
        for register, value in after.registers.items()
        if register not in base.registers or base.registers[register].text != value.text
    }
    left = dict(changed)
    for name, text in texts.items():
        lines = text.split("\n")
        for n, line in enumerate(lines):
            found = _registers(after, line)
            if len(found) == 1 and found[0] in changed:
                lines[n] = _value(line, changed[found[0]])
                left.pop(found[0], None)
        texts[name] = "\n".join(lines)
    for register, value in left.items():
        name = (
            "AX_EEC.INI"
            if register[0].startswith("AA_")
            else "NC_CEC.INI"
            if register[0].startswith("AN_")
            else "MD.INI"
        )
        at = texts[name].rfind("M17")
        at = texts[name].rfind("M30") if at < 0 else at
        shown = f"({value})" if register[0].endswith("PUT_AXIS") else value
        index = f"[{','.join(register[1])}]" if register[1] else ""
        texts[name] = f"{texts[name][:at]}${register[0]}{index}={shown}\n{texts[name][at:]}"
    if case.packing is not None:
        packing = case.packing if type(case.packing) is not Packing else Packing()
        return {"backup.arc": packing.packed(texts).decode("latin-1")}
    return texts


def _registers(control: VirtualSinumerik, text: str) -> list[Register]:
    return [
        (name, tuple(control.axis(token) for token in index))
        for (name, index), _ in assignments(text)
    ]


def _value(line: str, value: str) -> str:
    """The line with another value, without its checksum."""
    line = re.sub(r" '[0-9A-Fa-f]{4}(?=\r?$)", "", line)
    return re.sub(
        r"=(\s*)(\(?)[^\s;()]+(\)?)", lambda m: f"={m[1]}{m[2]}{value}{m[3]}", line, count=1
    )


def follow(outcome: Outcome, folder: Path, run: Run) -> dict[str, object]:
    """``compare`` and ``verify`` behind a job that was written, with and without slips; what is
    wrong goes into the harms of the outcome. Returns the verdict of ``verify``.
    """
    case, after = outcome.case, outcome.loaded
    if after is None or case.files is not None or case.none or outcome.harms:
        return {}
    before = control_before(case)
    rng = np.random.default_rng([232, case.seed])

    def compare(what: str, texts: dict[str, str], expected: int) -> None:
        place = folder / f"loaded-{what}"
        place.mkdir()
        for name, text in texts.items():
            (place / name).write_bytes(text.encode("latin-1"))
        plan = str(folder / "out" / "plan.json")
        files = [str(path) for path in sorted(place.iterdir())]
        code, message = run(["compare", plan, "--loaded", *files])
        if code != expected:
            outcome.harms.append(
                f"compare of {what}: exit {code}, not {expected}: {message.strip()[-400:]}"
            )

    whole = exported(case, after)
    compare("right", whole, 0)
    prefilled(outcome, folder, run)
    slip = int(rng.integers(3))
    e, axis = str(case.system), case.axis
    if slip == 0:
        compare("nothing loaded", exported(case, before), 1)
    elif slip == 1:
        point = next(
            (r for r in sorted(after.registers) if r[0] == "AA_ENC_COMP" and r[1][-1] != axis), None
        )
        if point is not None and point[1][-1] != case.gantry:
            compare("a neighbour's point", exported(case, _with(after, point, "0.077")), 1)
    else:
        switch = ("MA_ENC_COMP_ENABLE", (e, axis))
        acts = np.ptp(after.correction(axis, np.linspace(*case.travel, 50), 1)) > 1e-3 * case.unit
        if not case.written_tables and acts:
            compare("switched off", exported(case, _with(after, switch, "0")), 1)
    return verify(outcome, folder, run, before, rng)


def prefilled(outcome: Outcome, folder: Path, run: Run) -> None:
    """``new`` fills in what the control's own files say of the axis."""
    case = outcome.case
    files = [str(folder / "control" / name) for name in case.given()]
    options = [
        word
        for key, value in case.options.items()
        if key in {"units", "cec_sign"}
        for word in ("--option", f"{key}={value}")
    ]
    job = folder / "new.yaml"
    code, message = run(
        ["new", "--from", *files, "--format", case.format, *options, "--out", str(job)]
    )
    if code != 0:
        outcome.harms.append(f"new: exit {code}: {message.strip()[-300:]}")
        return
    text = job.read_text(encoding="utf-8")
    addresses = {case.axis, case.address, NAMES[case.axis]}
    blocks = re.split(r"^  (?=\S)", text.partition("axes:")[2], flags=re.MULTILINE)
    own = [
        block
        for block in blocks
        if (found := re.search(r'address: "?(\w+)', block)) and found[1] in addresses
    ]
    eec = control_before(case).value("MA_ENC_COMP_ENABLE", str(case.system), case.axis)
    if not own and not (eec and case.nonzero and case.active is None):
        return  # nothing acts on it
    if len(own) != 1:
        outcome.harms.append(f"new: {len(own)} axes with the address of {case.axis}")
        return
    kind, system = "rotary" if case.rotary else "linear", case.system + 1
    if f"kind: {kind}" not in own[0]:
        outcome.harms.append(f"new: {case.axis} is {kind}: {own[0][:200]}")
    said = re.search(r"encoder: \{\"?system\"?: (\d)", own[0])
    if said is not None and int(said[1]) != system and case.job_system is None:
        outcome.harms.append(f"new: measuring system {said[1]}, not {system}")
    if case.modulo and not re.search(r"modulo: 360(\.0)?\b", own[0]):
        outcome.harms.append(f"new: {case.axis} is endless: {own[0][:300]}")


def _with(control: VirtualSinumerik, register: Register, text: str) -> VirtualSinumerik:
    other = control.copy()
    index = f"[{','.join(register[1])}]"
    other.load(f"${register[0]}{index}={text}", protected=False)
    return other


def verify(
    outcome: Outcome, folder: Path, run: Run, before: VirtualSinumerik, rng: np.random.Generator
) -> dict[str, object]:
    """A test taken with the table loaded is never called not active, one without it never loaded."""
    case, after, error = outcome.case, outcome.loaded, outcome.error
    assert after is not None
    assert error is not None
    told: dict[str, object] = {}
    slipped = bool(rng.random() < 0.4)
    targets = targets_of(case, rng, outcome.count)
    readings = measure(before if slipped else after, case, error, targets, rng)
    (folder / "after.csv").write_text(rows_of(case, readings, targets))
    out = folder / "verified"
    code, message = run(
        [
            "verify",
            str(folder / "job.yaml"),
            "--after",
            str(folder / "after.csv"),
            "--plan",
            str(folder / "out"),
            "--out",
            str(out),
        ]
    )
    found = out / "verification.json"
    if code not in {0, 1} or not found.is_file():
        outcome.harms.append(f"verify: exit {code}: {message.strip()[-400:]}")
        return told
    document = json.loads(found.read_text(encoding="utf-8"))
    verdicts = re.findall(r'"verdict": "(loaded|not_active)"', json.dumps(document))
    told["loading"] = verdicts[0] if verdicts else "undecided"
    told["slipped"] = slipped
    told["verify"] = code
    told["verdict"] = document.get("verdict")
    wrong = "loaded" if slipped else "not_active"
    if wrong in verdicts:
        outcome.harms.append(f"verify says {wrong}, exit {code}")
    if slipped and code == 0:
        outcome.harms.append("verify: exit 0, though nothing was loaded")
    return told
