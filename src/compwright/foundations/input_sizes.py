"""The largest size of each kind of input.

A larger file is refused before it is read, so that no input fills the memory. The largest real
files known are much smaller: a circular test 1 MB, a whole backup of a control about 20 MB, a job
30 kB.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class InputKind:
    """A kind of input file: its name in messages, largest size, and how to get the right file."""

    name: str
    most_bytes: int
    help: str = ""


#: A million readings in the longest form (target data) have 40 MB.
MEASUREMENT: Final = InputKind(
    "a measurement file", 64_000_000, "the file that the instrument wrote"
)
CONTROL: Final = InputKind(
    "a file of a control", 64_000_000, "a file that the control wrote, or loads"
)
#: A file of a control in a folder that was named: what is no statement of it is left out.
IN_FOLDER: Final = InputKind(CONTROL.name, CONTROL.most_bytes)
#: Read by people, written by hand.
_YAML: Final = 1_000_000
JOB: Final = InputKind(
    "a job file",
    _YAML,
    "the JOB.yaml that was run (a copy is in inputs/ of its results), or a new one: compwright new",
)
PROFILE: Final = InputKind(
    "a mapping profile", _YAML, "what compwright profile FILE --out P.yaml writes"
)
MACHINE: Final = InputKind(
    "a virtual machine", _YAML, "a machine.yaml as docs/simulation.md describes it"
)
DEFINITION: Final = InputKind(
    "a definition of a control",
    _YAML,
    "an id of compwright formats list, or a file as docs/formats.md describes it",
)
#: Keys and values of one: a long job has some thousand.
MOST_YAML_WORDS: Final = 40_000
MOST_YAML_LEVELS: Final = 50
#: Plan, record, prediction: they carry files of controls and every target.
JSON: Final = InputKind("a JSON file of compwright", 128_000_000)
PLAN: Final = InputKind("a plan", JSON.most_bytes, "plan.json in the results of compwright run")
#: Embedded in every report.
LOGO: Final = InputKind("a logo", 500_000, "a .png, .jpg or .svg file of the size it is printed in")
#: What is copied or compared as it is.
ANY: Final = InputKind("a file", 128_000_000)

#: Of one test: a real axis has some hundred readings, a real circle some ten thousand samples.
MOST_READINGS: Final = 2_000_000
MOST_TARGETS: Final = 100_000
#: Targets times traverses: a table with holes has more cells than readings.
MOST_CELLS: Final = 4_000_000
#: Of one number in a file of a control.
MOST_DIGITS: Final = 1000
#: Of a table of another program.
MOST_COLUMNS: Final = 1000
#: Of a workbook, known before it is read: bytes of its tables and texts when unpacked, of all else
#: that describes it (styles, names), and cells, rows and texts that it writes, empty ones too.
MOST_UNPACKED: Final = 80_000_000
MOST_UNPACKED_OTHER: Final = 8_000_000
MOST_SHEET_CELLS: Final = 1_000_000
#: The same with the gaps between cells, which a sheet does not write.
MOST_SHEET_PLACES: Final = 2_000_000
#: Of a ballbar file (XML): a real one has 80 kB, 300 elements, 6 levels, some thousand samples.
XML: Final = InputKind("an XML file", 32_000_000)
MOST_ELEMENTS: Final = 200_000
MOST_LEVELS: Final = 40
MOST_SAMPLES_OF_A_RUN: Final = 1_000_000
#: Bytes of one text of a control, alone or in an archive: the largest of a five-axis machine has
#: one million.
MOST_CONTROL_TEXT: Final = 8_000_000
#: Bytes of all texts of a control together: a whole backup of it has some 20 MB, most of them
#: programs, which are not read.
MOST_CONTROL_TEXTS: Final = 32_000_000


def in_words(size: int) -> str:
    """Return a size in bytes as text with a suitable unit: 64 MB, 1.5 MB, 900 bytes."""
    if size < 1000:
        return f"{size} bytes"
    unit, name = (1_000_000, "MB") if size >= 1_000_000 else (1000, "kB")
    return f"{size / unit:.1f}".removesuffix(".0") + f" {name}"
