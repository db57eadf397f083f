"""Options of one FANUC axis, for facts that its files do not state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from compwright.controllers.fanuc.memory import BYTE
from compwright.controllers.fanuc.series import ControlSeries
from compwright.controllers.request import finite_number, wrong_choice
from compwright.foundations.errors import Fault

#: Additional functions that an option of their name makes counted.
OPTIONAL_FUNCTIONS = ("inclination", "cyclic", "straightness")


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """The options of one axis, such as its detection unit (mm or deg; None if unknown).

    - ``ramp``: the pulses of a section are distributed evenly over it. Else they are output in its
      middle.
    - ``pitch_sign``: sign of the pitch data, +1 or -1. ``offset_sign``: sign of 3627, +1 or -1. No
      manual page confirms these signs.
    - ``offset_magnified``: 3623 multiplies 3627.
    - ``lowest``, ``highest``: least and greatest increment that the control accepts.
    - ``counted``: the additional functions (``inclination``, ``cyclic``, ``straightness``) that are
      included in the correction. The others are left unchanged and only reported.
    - ``rapid``: the axis moves at rapid traverse, else at cutting feed.
    """

    detection_unit: float | None
    ramp: bool
    pitch_sign: int
    offset_sign: int
    offset_magnified: bool
    lowest: int
    highest: int
    counted: frozenset[str] = frozenset()
    rapid: bool = False


def read_options(
    given: Mapping[str, object], series: ControlSeries, address: str, faults: list[Fault]
) -> Options:
    """Return the options of an axis; an invalid option becomes a fault and takes its default."""

    def choice(name: str, choices: tuple[str, ...]) -> str:
        value = given.get(name, choices[0])
        if value not in choices:
            faults.extend(wrong_choice(name, value, choices, f" of axis {address}").faults)
            return choices[0]
        return str(value)

    def sign(name: str) -> int:
        return 1 if choice(name, ("+", "-")) == "+" else -1

    limit = finite_number(given.get("increment_limit", series.increment_limit))
    if limit is None or limit != int(limit) or not 1 <= limit <= BYTE[1]:
        faults.append(
            Fault(
                message=f"the option increment_limit of axis {address} has a wrong value",
                expected=f"a whole number 1 to {BYTE[1]}",
                found=repr(given.get("increment_limit")),
                hint=f"give `--option increment_limit={series.increment_limit}`, or less",
            )
        )
        limit = float(series.increment_limit)
    return Options(
        detection_unit=_detection_unit(given, address, faults),
        ramp=choice("output", ("step", "ramp")) == "ramp",
        pitch_sign=sign("pitch_sign"),
        offset_sign=sign("offset_sign"),
        offset_magnified=choice("offset_magnified", ("no", "yes")) == "yes",
        # a limit of 127 is that of the signed byte, which reaches one further downwards
        lowest=BYTE[0] if limit == BYTE[1] else -int(limit),
        highest=int(limit),
        counted=frozenset(
            name
            for name in OPTIONAL_FUNCTIONS
            if choice(name, ("absent", "available")) == "available"
        ),
        rapid=choice("motion", ("feed", "rapid")) == "rapid",
    )


def _detection_unit(given: Mapping[str, object], address: str, faults: list[Fault]) -> float | None:
    if given.get("detection_unit") is None:
        return None
    unit = finite_number(given["detection_unit"])
    if unit is None or unit <= 0.0:
        faults.append(
            Fault(
                message=f"the option detection_unit of axis {address} has a wrong value",
                expected="mm or deg per pulse, above 0",
                found=repr(given["detection_unit"]),
                hint=("give the detection unit of this control: `--option detection_unit=0.001`"),
            )
        )
        return None
    return unit
