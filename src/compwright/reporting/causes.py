"""The causes of the deviations in a circular test as text, ranked by effect, for terminal, figures
and report.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

from compwright.reporting.numbers import decimals_of_unit, number
from compwright.words.sentences import Sentence, SentenceText, say

#: A cause below this share of all effects, or below this effect (µm; half the last digit shown), is
#: named, not listed.
LEAST_SHARE: Final = 0.01
LEAST_EFFECT: Final = 0.005
#: Below this effect (µm, the resolution of a ballbar) nothing is done about a cause.
LEAST_MENDED: Final = 0.1

_UNITS: Final = {"um": "µm", "um/m": "µm/m", "ms": "ms"}
_KINDS: Final = frozenset(
    {
        "squareness", "scale_mismatch", "servo_mismatch", "radius_change", "backlash",
        "lateral_play", "reversal_spike", "cyclic", "straightness", "scale_error",
        "backlash_mismatch", "offset_change", "spiral", "master_slave", "vibration", "stick_slip",
        "lobes_2", "lobes_3", "positional_tolerance",
    }
)  # fmt: skip
#: Values that sum up causes which are listed.
_SUMMARIES: Final = ("backlash_mismatch", "lobes_2", "lobes_3", "positional_tolerance")
#: Contract name -> name that Renishaw software prints (A the first axis of the plane, B the
#: second). A cyclic error is printed for forward and backward travel.
_PRINTED: Final = {
    "squareness": "AF_SQUARENESS",
    "scale_mismatch": "AF_SCALE_MISMATCH",
    "servo_mismatch": "AF_SERVO_MISMATCH",
    "radius_change": "AF_RADIUS_CHANGE",
    "backlash": "AF_BACKLASH_{letter}_GLOBAL",
    "backlash_at_positive": "AF_BACKLASH_{letter}_POS",
    "backlash_at_negative": "AF_BACKLASH_{letter}_NEG",
    "lateral_play": "AF_LATERAL_PLAY_{letter}_GLOBAL",
    "reversal_spike_at_positive": "AF_REVERSAL_SPIKES_{letter}_POS",
    "reversal_spike_at_negative": "AF_REVERSAL_SPIKES_{letter}_NEG",
    "cyclic": "AF_CYCLIC_ERROR_{letter}_FWD AF_CYCLIC_ERROR_{letter}_REV",
    "offset_change": "AF_OFFSET_{letter}_SHIFT",
    "lateral_play_at_positive": "AF_LATERAL_PLAY_{letter}_POS",
    "lateral_play_at_negative": "AF_LATERAL_PLAY_{letter}_NEG",
    "straightness": "AF_STRAIGHTNESS_{letter}",
    "scale_error": "AF_SCALE_ERROR_{letter}",
    "positional_tolerance": "AF_POSITIONAL_TOLERANCE",
}
#: Kinds of which the software's definition is not published, so that values are not compared.
_OWN_DEFINITION: Final = ("reversal_spike", "cyclic", "offset_change", "positional_tolerance")
#: The end of the name of a second or further cyclic error of an axis: its pitch names it.
_FURTHER: Final = re.compile(r"(cyclic_(?:first|second))_\d+$")
_PARTS: Final = (
    "at_positive", "at_negative",
    "at_positive_ccw", "at_positive_cw", "at_negative_ccw", "at_negative_cw",
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleCause:
    """One cause of the deviations in a circular test: its value, the standard error, its effect
    (µm), and its share of all effects (0 to 1).

    ``parts``: its details, such as each end of a lost motion, or the scale errors of a mismatch;
    the effect of the cause includes them. ``plain``, ``printed``: the same quantity by simple
    regression and by the instrument's software; none if there is none. ``comparable``: the software
    defines it in the same way. ``pitch``: that of the software's cyclic error, mm. ``doubtful``:
    the software itself states that its value is not valid.

    ``frequency``, Hz, and ``axis``: those of a vibration; no axis if it is along the bar.
    ``period``: that of a cyclic error, mm. ``note``: the period and phase of a cyclic error, the
    frequency of a vibration, or the raw peak of a spike. ``correction``: what `run` does about a
    squareness.
    """

    name: str
    words: Sentence
    value: float
    error: float
    unit: str
    effect: float
    share: float
    low: float | None = None
    frequency: float | None = None
    axis: str | None = None
    period: float | None = None
    plain: float | None = None
    printed: tuple[float, ...] = ()
    comparable: bool = True
    pitch: float | None = None
    doubtful: bool = False
    note: Sentence | None = None
    correction: str | None = None
    parts: tuple[CircleCause, ...] = ()

    @property
    def noted_words(self) -> Sentence:
        """Return the name of the cause with its note in brackets, if it has one."""
        return say("cause.noted", cause=self.words, note=self.note) if self.note else self.words

    @property
    def short_words(self) -> Sentence:
        """Return the name of the cause with its period if it is a cyclic error."""
        if self.period is None:
            return self.words
        note = _note("cyclic", {"period": self.period})
        return say("cause.noted", cause=self.words, note=note)

    def printed_text(self, write: Callable[[float], str]) -> str:
        """Return the software's values as text, in brackets if it calls them not valid. ``write``
        returns one value as text.
        """
        text = " / ".join(write(value) for value in self.printed)
        return f"({text})" if text and self.doubtful else text

    @property
    def value_text(self) -> Sentence:
        """Return value ± standard error as text, with the decimals of the unit."""
        decimals = decimals_of_unit(self.unit)
        return say(
            "label.value_error",
            value=number(self.value, decimals),
            error=number(self.error, decimals),
        )

    @property
    def unit_text(self) -> str:
        """Return the unit of the cause as it is printed."""
        return _UNITS.get(self.unit, self.unit)

    def text(self, value: float | None) -> str:
        """Return a value in the unit of the cause as text, with that unit's number of decimals."""
        return "" if value is None else number(value, decimals_of_unit(self.unit))

    @property
    def shown(self) -> bool:
        """Whether the value is large enough for its own line in the output."""
        return self.share >= LEAST_SHARE and self.effect >= LEAST_EFFECT

    @property
    def large(self) -> bool:
        """Whether the effect is large enough to do something about the cause."""
        return self.shown and self.effect >= LEAST_MENDED

    @property
    def known(self) -> bool:
        """Whether the value is larger than twice its standard error. A vibration with a frequency
        was found, however uncertain its size is.
        """
        return self.frequency is not None or abs(self.value) > 2.0 * self.error

    @property
    def corrected(self) -> bool:
        """Whether `run` corrects the cause if the control can do so: its value is large and certain
        enough, for a squareness also by the rule of `correction_need`.
        """
        return self.large and self.known and self.correction in {None, "correct"}

    @property
    def significant(self) -> bool:
        """Whether the value of the cause, or that of one of its parts (such as one end of the
        axis), exceeds twice its standard error.
        """
        return self.known or any(part.known for part in self.parts)

    @property
    def limits(self) -> tuple[float, float]:
        """Return the effects (µm, never below 0) at the ends of the value's 95 % interval.

        The effect is taken as proportional to the value, or to that of its largest part if this is
        larger: the mean of two unlike ends of an axis may be zero. This is exact for all causes
        except cyclic errors that occur in both directions, where it is a good approximation. If the
        value is zero, both results are the effect itself; without a standard error they are 0 and
        infinity.
        """
        alike = [part for part in self.parts if part.unit == self.unit]
        largest = max((self, *alike), key=lambda part: abs(part.value))
        if math.isnan(largest.error):
            return 0.0, math.inf
        if not largest.value:
            return self.effect, self.effect
        scale = self.effect / abs(largest.value)
        spread = 1.96 * largest.error
        low = abs(largest.value) - spread if largest.low is None else largest.low
        return max(0.0, scale * low), scale * (abs(largest.value) + spread)


def machine_title(machine: Mapping[str, Any]) -> Sentence:
    """Return the heading for the common result of several circular tests of one machine."""
    named = " ".join(str(machine[key]) for key in ("machine", "serial") if machine[key])
    return say("report.machine", name=named, circles=[str(name) for name in machine["circles"]])


def ranked_causes(result: Mapping[str, Any]) -> list[CircleCause]:
    """Return the causes in a circular result, the largest effect first; no causes if the test was
    not diagnosed.

    ``result``: an entry of the evaluation document. A cause without a value is left out;
    ``not_applicable`` gives the reason.
    """
    entries, axes = _given(result), result.get("axes") or ("first", "second")
    causes = [
        replace(_cause(name, result), words=full_cause_words(name, axes))
        for name in entries
        if name not in _SUMMARIES
        # One end of an axis is its own cause if the other end is unknown.
        and (whole_cause(name) == name or whole_cause(name) not in entries)
        and not name.endswith(("_ccw", "_cw"))
    ]
    return sorted(
        causes, key=lambda cause: -cause.effect
    )  # stable: equals stay in the order of the document


def summed_causes(result: Mapping[str, Any]) -> list[CircleCause]:
    """Return those values of a circular result that summarise its causes, such as the positional
    tolerance.
    """
    return [_cause(name, result) for name in _SUMMARIES if name in _given(result)]


def _given(result: Mapping[str, Any]) -> Mapping[str, Any]:
    entries = result.get("diagnosis") or {}
    return {name: entry for name, entry in entries.items() if entry["value"] is not None}


def whole_cause(name: str) -> str:
    """Return the JSON name of the cause to which the part ``name`` belongs. The name of a whole
    cause is returned unchanged.
    """
    for part in _PARTS:
        if name.endswith(f"_{part}"):
            return name.removesuffix(f"_{part}")
    return "scale_mismatch" if name.startswith("scale_error") else name


def _cause(name: str, result: Mapping[str, Any]) -> CircleCause:
    entry = result["diagnosis"][name]
    vendor = {} if _FURTHER.match(name) else result.get("vendor") or {}
    kind, which, part = _split(name)
    letter = "A" if which == "first" else "B"
    printed, doubtful = _printed(
        _PRINTED.get(f"{kind}_{part}" if part else kind, "").format(letter=letter), vendor
    )
    pitch, _ = _printed(f"AF_CYCLIC_PITCH_{letter}" if kind == "cyclic" else "", vendor)
    return CircleCause(
        name=name,
        words=cause_words(name, result.get("axes") or ("first", "second")),
        value=_finite(entry.get("value")),
        error=_finite(entry.get("std_error"), math.nan),
        unit=str(entry.get("unit", "um")),
        effect=_finite(entry.get("effect")),
        share=_finite(entry.get("share")),
        low=entry.get("low"),
        frequency=entry.get("frequency"),
        axis=entry.get("axis"),
        period=entry.get("period"),
        plain=(result.get("plain") or {}).get(name),
        printed=printed,
        comparable=kind not in _OWN_DEFINITION,
        pitch=next(iter(pitch), None),
        doubtful=doubtful,
        note=_note(kind, entry),
        correction=entry.get("correction"),
        parts=tuple(
            _cause(other, result)
            for other in _given(result)
            if other != name and whole_cause(other) == name
        ),
    )


def _finite(value: object, otherwise: float = 0.0) -> float:
    return float(value) if isinstance(value, int | float) and math.isfinite(value) else otherwise


def _split(name: str) -> tuple[str, str, str]:
    """Return the three parts of a cause's JSON name: the kind, the axis ("first", "second" or ""),
    and the part of the cause ("" for the whole cause). The number of a further cyclic error of an
    axis is in none of them.
    """
    part = next((part for part in _PARTS if name.endswith(f"_{part}")), "")
    rest = _FURTHER.sub(r"\1", name.removesuffix(f"_{part}") if part else name)
    for which in ("first", "second"):
        if rest.endswith(f"_{which}"):
            return rest.removesuffix(f"_{which}"), which, part
    return rest, "", part


def cause_words(name: str, axes: Any) -> Sentence:
    """Return the text for a cause with the names of its axes; if ``name`` is only a part of a
    cause, return the text for this part.
    """
    kind, which, part = _split(name)
    axis = axes[("first", "second").index(which)] if which else ""
    if part:
        return say("cause.part", part=part, axis=axis)
    if kind not in _KINDS:
        return say("as_written", text=name.replace("_", " "))
    return say("cause.kind", kind=kind, first=axes[0], second=axes[1], axis=axis)


def full_cause_words(name: str, axes: Any) -> Sentence:
    """Return the complete text for a cause or its part: ``Lost motion X at X+``."""
    kind, _, part = _split(name)
    whole = name.removesuffix(f"_{part}") if part else name
    words = cause_words(whole, axes)
    if part and kind in _KINDS:
        return say("cause.whole", cause=words, part=cause_words(name, axes))
    return words


def named_in_words(value: Any, axes: Any) -> Any:
    """Return a value of a message, or a whole sentence, in which the JSON names of causes are
    replaced by their texts.
    """
    if isinstance(value, SentenceText):
        return SentenceText(named_in_words(value.sentence, axes))
    if isinstance(value, Sentence):
        named = value.name == "cause.kind"  # has its text already
        return value if named else replace(value, values=named_in_words(value.values, axes))
    if isinstance(value, tuple):
        return tuple(named_in_words(one, axes) for one in value)
    if isinstance(value, str) and "_" in value and _split(value)[0] in _KINDS:
        return full_cause_words(value, axes)
    return value


def _note(kind: str, entry: Mapping[str, Any]) -> Sentence | None:
    """Return what else the entry of a cause says, or None: see `CircleCause`."""
    peak, period, frequency = (entry.get(name) for name in ("raw_peak", "period", "frequency"))
    if peak is period is frequency is None:
        return None
    return say(
        "cause.note",
        kind=kind,
        peak=number(peak),
        period=period,
        phase=number(entry["phase"], 0) if "phase" in entry else "",
        frequency=frequency,
    )


def _printed(keys: str, vendor: Mapping[str, Any]) -> tuple[tuple[float, ...], bool]:
    """Return the values that the instrument's software printed under the ``keys``, and whether it
    calls one of them not valid.
    """
    block = next(
        (block for title, block in vendor.items() if str(title).startswith("RENISHAW_DIAGNOSTICS")),
        None,
    )
    if not isinstance(block, Mapping):
        return (), False
    entries = [
        entry
        for key in keys.split()
        if isinstance(entry := block.get(key), Mapping)
        and isinstance(entry.get("value"), int | float)
    ]
    values = tuple(float(entry["value"]) for entry in entries)
    return values, any(entry.get("valid") is False for entry in entries)


def findings_in_words(result: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the findings of a result, with JSON names of causes replaced by text."""
    axes = result.get("axes") or ("first", "second")
    return [
        {**finding, "message": named_in_words(finding["message"], axes)}
        for finding in result.get("findings") or ()
    ]
