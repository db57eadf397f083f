"""Findings: remarks with stable codes, collected during a command and shown at its end.

Codes begin with a family: ``CW-R`` reading, ``CW-T`` test checks, ``CW-J`` job, ``CW-S`` state of
the control, ``CW-E`` error estimate, ``CW-F`` fit, ``CW-X`` format and export, ``CW-P`` prediction,
``CW-V`` verification. ``docs/findings.md`` lists the meaning of each code; a test compares this
list with the codes in the source.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

from compwright.words.sentences import Sentence, SentenceText, say

Severity = Literal["info", "warning", "error"]

#: What each code means for a decision, by its number without ``CW-``; ``docs/findings.md`` shows
#: the same in its column "doubt". A doubt is about a measurement or the state of a control: nothing
#: is decided about its axis until the job acknowledges it. A result (of a verification, of a circle
#: that gets worse, of who read the files) stands first as well, and cannot be acknowledged. All
#: others are remarks.
_DOUBTS: Final = """
    R007 R008 R009 R010 R011 R012 R014 R015 R032 R034 R035 R036 R050 R051 R053 R055 R056 R058
    R063 R064 T007 T011 T030 T031 T032 T033 T034 T035 T036 T037 T039 C006 C008 C013 C014 C015
    C016 S001 S002 S005 S006 S008 S018 S031 S033 S034 S038 S043 S045 S046 S052 S056 S071 E003
    E010 E011 E030 E032 D012 D013 P102 P104 P110 P136 P153 P154 P160 P161 P162 P166 P167 P168
    P169 P170 P171 P172
"""
_RESULTS: Final = """
    P131 P134 S060 S061 S087 S088 V020 V021 V022 V023 V024 V025 V026 V027 V028 V029 V032 V033 V034
    V035 V036
"""
_REMARKS: Final = """
    R001 R002 R003 R004 R005 R006 R013 R030 R031 R033 R037 R038 R039 R052 R054 R057 R059 R060
    R061 R062 T001 T002 T003 T004 T005 T006 T008 T009 T010 T012 T013 T014 T015 T016 T020 T021
    T022 T023 T024 T025 T026 T027 T028 T029 T038 T040 T041 C001 C002 C003
    C004 C005 C007 C009 C010 C011 C012
    J002 J003 J004 J020 J021 S003 S004 S007 S009 S010 S011 S012 S013 S014 S015 S016 S017 S019
    S030 S032 S035 S036 S037 S040 S041 S042 S044 S047 S048 S049 S050 S051 S053 S054 S055 S057
    S062 S070 S072 S073 S080 S081 S082 S083 S084 S085 S086 E001 E002 E004 E012 E013 E014 E015 E016
    E020 E021 E022 E023 E024 E025 E026 E027 E028 E029 E031 D001 D002 D003 D004 D005 D006
    D007 D008 D009 D010 D011 F001 F002 F003 F004 F005 F006 F007 F008 F009 F010 F011 P001 P101
    P103 P105 P106 P107 P108 P109 P111 P112 P113 P114 P115 P116 P117 P118 P119
    P120 P130 P132 P133 P135 P140 P141 P142 P143 P144 P150 P151 P152 P155 P156 P163 P164
    P165 V001 V010 V011 V012 V030 V031
"""


def _codes(numbers: str) -> frozenset[str]:
    return frozenset(f"CW-{number}" for number in numbers.split())


DOUBTS: Final = _codes(_DOUBTS)
RESULTS: Final = _codes(_RESULTS)
REMARKS: Final = _codes(_REMARKS)
#: How the doubts are headed, the same at the terminal, in reports and on the card.
DOUBTS_FIRST: Final = say("doubts.first")


@dataclass(frozen=True, slots=True)
class Finding:
    """A remark for the user, with a stable ``code`` and a ``sentence``.

    ``sentence``: its name in the catalogue with the values in it. ``axes``: the axes that it
    concerns, by name, or by address if it is about the control's files; empty for all axes.
    """

    code: str
    severity: Severity
    sentence: Sentence
    axes: tuple[str, ...] = ()

    @classmethod
    def of(
        cls, name: str, severity: Severity, /, axes: tuple[str, ...] = (), **values: object
    ) -> Finding:
        """Return a finding from the ``name`` of its sentence (such as ``CW-R053.no_end``, which
        begins with its code) and the values in the sentence.

        If a code has several sentences, a dot and a word follow the code in the name.
        """
        return cls(name.partition(".")[0], severity, say(name, **values), axes)

    @property
    def message(self) -> str:
        """The sentence in English; pages in other languages translate the sentence themselves."""
        return SentenceText(self.sentence)

    @property
    def values(self) -> Mapping[str, Any]:
        """The values that are filled into the sentence, by their names in it."""
        return dict(self.sentence.values)

    @property
    def is_doubt(self) -> bool:
        """Whether the finding blocks decisions on limits until it is resolved or acknowledged."""
        return self.code in DOUBTS and self.severity != "info"


def next_step(codes: Iterable[str]) -> Sentence | None:
    """Return the next step for doubts with the given codes, or None if none of the codes is a
    doubt's.
    """
    doubts = [code for code in dict.fromkeys(codes) if code in DOUBTS]
    return say("doubts.step", codes=doubts) if doubts else None


def doubts_of(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return those ``findings`` that are doubts or important results (not mere information), each
    once, errors first.
    """
    first = dict.fromkeys(
        finding
        for finding in findings
        if finding.code in DOUBTS | RESULTS and finding.severity != "info"
    )
    return tuple(sorted(first, key=lambda finding: finding.severity != "error"))
