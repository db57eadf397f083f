"""Controls that somebody loads: jobs for them, what ``decode`` says they then do, and their written
files loaded otherwise than they were meant.

The patterns of the files are written here from the pages of the makers, not by the package.
Positions in mm (deg), corrections (2, m) in µm (arcsec) for arrival in + and in -.
"""

from __future__ import annotations

import importlib
import io
import json
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Files = dict[str, bytes]


@dataclass(frozen=True, kw_only=True)
class Form:
    """How the numbers of an axis stand in its files; {a} is its address, {n} its name.

    ``columns``: a pattern for the values of each curve; ``file``: in which; ``backlash``,
    ``backlash_file`` likewise. ``blocks``: the part of the text that has the values of each curve,
    where they have no name of their own. ``increments``: values are steps from node to node, whole
    ones.
    """

    file: str
    columns: tuple[str, ...]
    decimals: int
    backlash: str = ""
    backlash_file: str = ""
    blocks: tuple[str, ...] = ()
    increments: bool = False


@dataclass(frozen=True, kw_only=True)
class Control:
    """A control and how it names the axes X, Y, Z, C."""

    format: str
    addresses: Mapping[str, str]
    options: Mapping[str, Any] = field(default_factory=dict)
    form: Form | None = None
    two_curves: bool = False
    endless: bool = True

    @property
    def increments(self) -> bool:
        """Whether the table holds steps, not totals."""
        return bool(self.form and self.form.increments)

    @property
    def repeats(self) -> bool:
        """Whether the rows are counted from the reference, and begin again behind the last one."""
        return self.form is PMAC


NUMBERS = dict(zip("XYZC", "1234", strict=True))
LETTERS = {name: name for name in "XYZC"}
SINUMERIK = Form(
    file="{a}_EEC.INI",
    columns=(r"\$AA_ENC_COMP\[0,\d+,{a}\]=(\S+)",),
    decimals=6,
    backlash=r"\$MA_BACKLASH\[0,{a}\]=(\S+)",
    backlash_file="{a}_MD.INI",
)
FANUC = Form(
    file="PITCH_{a}.TXT",
    columns=(r"(?m)^N1\d{{4}}(?:Q0)?P(-?\d+)",),
    decimals=0,
    backlash=r"N0?1851(?:Q1)?A{a}P(-?\d+)",
    backlash_file="PARAM_{a}.TXT",
    increments=True,
)
SHEET = Form(
    file="entry_{n}.csv",
    columns=(r"(?m)^\d+,[^,\n]*,([^,\n]+),(?:mm|deg)$",),
    decimals=4,
    backlash=r"(?m)^(?:MP710|backLash),,([^,\n]+),",
    backlash_file="entry_{n}.csv",
)
LINUXCNC = Form(
    file="joint_{a}.comp",
    columns=(r"(?m)^\S+ (\S+) \S+$", r"(?m)^\S+ \S+ (\S+)$"),
    decimals=7,
)
ISG = Form(
    file="achskw{a}.lis",
    columns=(r"\]\.pos\s+(-?\d+)", r"\]\.neg\s+(-?\d+)"),
    decimals=0,
)
#: Entry i of n is at i/n of the length from motor zero, over which the table repeats; 1/16 count.
_ENTRIES = r"#{{a}} DEFINE {kind} \d+,(?:#{{a}}D,)?\d+\s((?:\s*-?\d+)+)"
PMAC = Form(
    file="compensation.pmc",
    columns=(r"(-?\d+)", r"(-?\d+)"),
    blocks=(_ENTRIES.format(kind="COMP"), _ENTRIES.format(kind="BLCOMP")),
    decimals=0,
    backlash=r"I{a}86=(-?\d+)",
    backlash_file="compensation.pmc",
)

_UNIT = {"detection_unit": 0.001}
CONTROLS: dict[str, Control] = {
    control.format: control
    for control in (
        *(
            Control(
                format=name, addresses={k: f"AX{v}" for k, v in NUMBERS.items()}, form=SINUMERIK
            )
            for name in ("siemens-840d-sl", "siemens-828d", "siemens-840d-pl", "siemens-one")
        ),
        *(
            Control(format=name, addresses=NUMBERS, options=_UNIT, form=FANUC)
            for name in ("fanuc-30i", "fanuc-0i-f", "fanuc-0i-d", "fanuc-0i-16i")
        ),
        Control(
            format="linuxcnc",
            addresses=dict(zip("XYZC", "0123", strict=True)),
            form=LINUXCNC,
            two_curves=True,
            endless=False,
        ),
        Control(format="heidenhain-itnc530", addresses=LETTERS, form=SHEET),
        Control(format="heidenhain-nck", addresses=LETTERS, form=SHEET),
        Control(format="isg-kernel", addresses=NUMBERS, form=ISG, two_curves=True),
        Control(
            format="pmac",
            addresses=NUMBERS,
            options={"counts_per_unit": 62500.0},
            form=PMAC,
            two_curves=True,
        ),
    )
}


def said(*words: str) -> tuple[int, bytes, str]:
    """Run a command in this process: exit code, standard output, standard error."""
    from compwright.cli import run

    buffer, words_said = io.BytesIO(), io.StringIO()
    with io.TextIOWrapper(buffer, encoding="utf-8") as answer:
        with redirect_stdout(answer), redirect_stderr(words_said):
            code = run(list(words))
        answer.flush()
        return code, buffer.getvalue(), words_said.getvalue()


def without_reports() -> None:
    """Let no command draw a report: nobody reads it here."""
    importlib.import_module("osqp")  # which wants it, too
    sys.modules["jinja2"] = None  # type: ignore[assignment]


def option_words(options: Mapping[str, Any]) -> list[str]:
    """Return options for the command line."""
    return [word for key, value in options.items() for word in ("--option", f"{key}={value}")]


class Loaded:
    """What a control does with a folder of files: as ``decode`` says, for PMAC as its manual says
    (which knows values that ``decode`` refuses). ``rotary``: the axes whose numbers are degrees,
    also where the files do not say so.
    """

    def __init__(self, control: Control, folder: Path, rotary: frozenset[str]) -> None:
        """Nothing is read before it is asked for."""
        self.control, self.folder, self.rotary = control, folder, rotary

    def _decoded(self, *words: str) -> Mapping[str, Any]:
        command = ["decode", str(self.folder), "--format", self.control.format, *words]
        code, answer, why = said(*command, *option_words(self.control.options), "--json", "-")
        if code:
            raise ValueError(f"decode ends with {code}: {why.strip()}")
        axes: Mapping[str, Any] = json.loads(answer)["axes"]
        return axes

    def _curves(self, name: str, *words: str) -> tuple[Floats, Floats]:
        axes = self._decoded("--axis", self.control.addresses[name], *words)
        axis = axes[self.control.addresses[name]]
        both = [axis["correction_positive"], axis["correction_negative"]]
        # 0.001 deg, not mm; without a file that says so, the unit is unknown
        factor = 3.6 if name in self.rotary and axis["unit"] != "arcsec" else 1.0
        return np.array(axis["positions"], dtype=float), factor * np.array(both, dtype=float)

    def points(self, name: str) -> tuple[Floats, Floats]:
        """Positions (k,) and corrections (2, k) at the nodes."""
        if not self.control.repeats:
            return self._curves(name)
        columns, length = self.rows(name)
        places = np.linspace(0.0, length, columns.shape[1])
        return places, self._by_script(name, places)

    def at(self, name: str, x: Floats) -> Floats:
        """Corrections (2, m) at positions ``x``."""
        if self.control.repeats:
            return self._by_script(name, x)
        places = ",".join(f"{value:.9g}" for value in x)
        return self._curves(name, "--at", places)[1]

    def rows(self, name: str) -> tuple[Floats, float]:
        """Entries of COMP and BLCOMP (2, n + 1), from the 0 at motor zero on, and the length."""
        text = self._text()
        heads = re.search(rf"#{self.control.addresses[name]} DEFINE COMP (\d+),\D*\d*D,(\d+)", text)
        if heads is None:
            raise ValueError(f"no table of {name}")
        entries = np.zeros((2, int(heads[1]) + 1))
        for row, column in enumerate(_columns(PMAC, self.control, text, name)):
            entries[row, 1:] = [float(match[1]) for match in column]
        return entries, float(heads[2]) / float(self.control.options["counts_per_unit"])

    def _by_script(self, name: str, x: Floats) -> Floats:
        """COMP is added in both directions; Ixx86 and BLCOMP are subtracted towards -, unless the
        take-up rate Ixx85 is 0.
        """
        (ahead, lost), length = self.rows(name)
        address, text = self.control.addresses[name], self._text()
        constant, rate = (
            float(found[1]) if (found := re.search(rf"I{address}{number}=(-?\d+)", text)) else 0.0
            for number in (86, 85)
        )
        where = np.mod(x / length, 1.0) * (ahead.size - 1)
        index = np.arange(ahead.size)
        positive = np.interp(where, index, ahead)
        reversal = (constant + np.interp(where, index, lost)) * (rate > 0)
        unit = 1000.0 / 16.0 / float(self.control.options["counts_per_unit"])
        factor = unit * (3.6 if name in self.rotary else 1.0)
        return factor * np.stack([positive, positive - reversal])

    def _text(self) -> str:
        return "".join(content.decode("latin-1") for content in files_of(self.folder).values())


# ---- the files, loaded otherwise


def files_of(folder: Path) -> Files:
    """Return the files of a folder."""
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir()) if path.is_file()}


def write_files(folder: Path, files: Mapping[str, bytes]) -> Path:
    """Write them into a folder of their own."""
    folder.mkdir(parents=True)
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder


Change = Callable[[Floats], Floats]


def with_values(control: Control, files: Files, name: str, change: Change) -> Files:
    """Return the files with every table value of an axis changed: ``change`` is handed the values
    (curves, k) in the order of the file, in the file's own unit.
    """
    form, words = _form(control), {"a": control.addresses[name], "n": name}
    file = form.file.format(**words)
    text = files[file].decode("latin-1")
    columns = _columns(form, control, text, name)
    values = np.array([[float(match[1]) for match in column] for column in columns])
    if not values.size:
        raise ValueError(f"no values of {name} in {file}")
    base = np.zeros(values.shape[1])
    if control.format == "linuxcnc":  # rows hold actual positions: the nominal one less correction
        base = np.array([float(line.split()[0]) for line in text.splitlines()])
    changed = base + change(values - base)
    places = sorted(  # the columns may be in one row: all at once, in the order of the file
        zip(chain.from_iterable(columns), changed.ravel().tolist(), strict=True),
        key=lambda one: one[0].start(),
    )
    matches, numbers = zip(*places, strict=True)
    text = _replaced(text, matches, np.array(numbers), form.decimals)
    return {**files, file: text.encode("latin-1")}


def _columns(form: Form, control: Control, text: str, name: str) -> list[list[re.Match[str]]]:
    """Where the values of each curve are in a text; curves that are not there are left out."""
    words = {"a": control.addresses[name], "n": name}
    columns = []
    for number, column in enumerate(form.columns):
        span = (0, len(text))
        if form.blocks:
            block = re.search(form.blocks[number].format(**words), text)
            if block is None:
                continue
            span = block.span(1)
        columns.append(list(re.compile(column.format(**words)).finditer(text, *span)))
    return columns


def with_backlash(control: Control, files: Files, name: str, factor: float) -> Files:
    """Return the files with the backlash value of an axis times ``factor``."""
    form, words = _form(control), {"a": control.addresses[name], "n": name}
    if not form.backlash:
        raise ValueError("the table holds the reversal itself")
    file = form.backlash_file.format(**words)
    text = files[file].decode("latin-1")
    found = list(re.finditer(form.backlash.format(**words), text))
    if len(found) != 1:
        raise ValueError(f"no backlash value of {name} in {file}")
    numbers = np.array([float(found[0][1]) * factor])
    return {**files, file: _replaced(text, found, numbers, form.decimals).encode("latin-1")}


def with_file_of(control: Control, files: Files, name: str, other: str) -> Files:
    """Return the files with the table of axis ``name`` replaced by the whole one of ``other``."""
    form = _form(control)
    one, two = ({"a": control.addresses[n], "n": n} for n in (name, other))
    text = files[form.file.format(**two)].decode("latin-1")
    if form is SINUMERIK:
        text = text.replace(f",{two['a']}]", f",{one['a']}]")
    elif form is SHEET:
        text = re.sub(r"(?m)^# axis: .*$", f"# axis: {name}", text)
        text = re.sub(r"(?m)^# address: .*$", f"# address: {one['a']}", text)
    elif form is not LINUXCNC:
        raise ValueError("the numbers of this control are common to all axes")
    return {**files, form.file.format(**one): text.encode("latin-1")}


def _form(control: Control) -> Form:
    if control.form is None:
        raise ValueError("the files of this control are not changed here")
    return control.form


def _replaced(text: str, matches: Sequence[re.Match[str]], values: Floats, decimals: int) -> str:
    parts, last = [], 0
    for match, value in zip(matches, values, strict=True):
        parts += [text[last : match.start(1)], f"{round(value, decimals):.{decimals}f}"]
        last = match.end(1)
    return "".join([*parts, text[last:]])
