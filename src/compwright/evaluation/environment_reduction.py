"""Correction of laser readings for air and material temperature, with an environment record.

Air: an instrument that assumes the refractive index n0 displays p for a length p n0 / n. Here n is
the index of the air (`compwright.evaluation.air`), and p is counted from the zero of the display.

Expansion: ISO 230-2:1997 and 2006, 3.1, as in `compwright.evaluation.expansion`, with the
temperature at the time of each reading.

Arrays of readings in this module are (m, n): first the columns of readings in +, then those in -.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from typing import Final

import numpy as np

from compwright.evaluation.air import ciddor, edlen
from compwright.evaluation.expansion import (
    expansion_finding,
    instrument_compensated_air,
    refuse_reduced,
    refuse_rotary,
    rise_findings,
)
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.conditions import Thermal
from compwright.records.environment import AIR, MATERIAL, Environment, EnvironmentRecord
from compwright.records.positioning import PositioningTest

_EQUATIONS: Final = {"ciddor": ciddor, "edlen": edlen}
#: A gap in the record is named where it is this many times the usual distance of its rows.
_GAP: Final = 5.0
_PER_MILLION: Final = 1e6
#: µm/m: below this the lowest and the highest rate print alike.
_SAME_RATE: Final = 0.001
#: µm over the targets: below this it does not matter when a reading was taken.
_SMALL: Final = 0.5


def reduce_by_record(
    test: PositioningTest,
    environment: Environment,
    thermal: Thermal | None,
    zero: float,
    *,
    own_temperature: bool,
) -> PositioningTest:
    """Return ``test`` corrected for air and thermal expansion with the environment record.
    ``zero``: position at which the display was zeroed, mm; ``own_temperature``: the material
    temperature in ``thermal`` is stated by the test itself.

    Positions are machine coordinates. Each reading is corrected for the refractive index of the air
    at its time. If ``thermal`` is given, it is corrected for the differential expansion too.
    Readings without times are corrected with the mean of the record. Their material temperature is
    taken from the record only if the test states none. If the record has no columns of the air,
    only the expansion is corrected.

    Findings: CW-T024 and CW-T028 state the corrections. CW-T029: changes of air, expansion and the
    rest during the test. CW-T038: a gap in the record. CW-T039: readings without times.

    Raises UsageError for a rotary axis. Raises InputError if the instrument already made the
    correction, if required times are missing or have a form different from the record, and if the
    record does not cover the test.
    """
    refuse_rotary(test)
    if thermal is None and not environment.record.has_air:
        return replace(test, times=None)
    if environment.record.has_air:
        _refuse_compensated_air(test)
    if thermal is not None:
        refuse_reduced(test)
    split = test.positive.shape[1]
    readings = np.hstack([test.positive, test.negative])
    times = _times(test, environment)
    at = _at(environment.record, times, readings)
    findings = [] if times is None else list(_gap(environment.record, times))
    light, expansion = np.zeros_like(readings), np.zeros_like(readings)
    if environment.record.has_air:
        index, counted = _index(environment, at), _counted(environment)
        light = (test.targets[:, np.newaxis] + readings - zero) * (1.0 - counted / index)
        findings.append(_light_finding(environment, at, 1.0 - counted / index, zero))
    if thermal is not None:
        T_m = np.full_like(readings, thermal.T_m)
        if MATERIAL in at and not (times is None and own_temperature):
            T_m = at[MATERIAL]
            thermal = replace(thermal, T_m=float(np.nanmean(T_m)), rise_m=0.0)
        slope = thermal.slope + 1e-6 * thermal.alpha_m * (T_m - thermal.T_m)
        expansion = (test.targets[:, np.newaxis] - thermal.x_fix) * slope
        findings += [expansion_finding(thermal), *rise_findings(test, thermal)]
    removed = light + expansion
    if times is None:
        findings += _untimed(environment, test, None if own_temperature else thermal)
    else:
        unused = thermal is None and MATERIAL in at
        findings += _changes(times, split, light, expansion, readings - removed, unused=unused)
    return replace(
        test,
        positive=test.positive - removed[:, :split],
        negative=test.negative - removed[:, split:],
        findings=(*test.findings, *findings),
        times=None,
        thermal=thermal,
        removed=(removed[:, :split], removed[:, split:]),
    )


def _refuse_compensated_air(test: PositioningTest) -> None:
    stated = test.header.get("compensated_for", "")
    if instrument_compensated_air(stated):
        raise InputError(
            Fault(
                message=(
                    "the instrument already compensated for the air, so its effect would be removed"
                    " twice"
                ),
                file=_file(test),
                place="compensated_for",
                expected="no key `compensated_for`, or one that names only the material",
                found=stated,
                hint=(
                    f"remove the columns {', '.join(AIR)} from the environment record, or"
                    " correct `compensated_for` in the file"
                ),
            )
        )


def _file(test: PositioningTest) -> str:
    return test.sources[0].file if test.sources else test.name


def _times(test: PositioningTest, environment: Environment) -> FloatArray | None:
    """Return the time of each reading, or None where times are unknown and not needed."""
    record = environment.record
    if test.times is None:
        if not environment.needs_time:
            return None
        raise InputError(
            Fault(
                message="the file does not state when its readings were taken, but the "
                "environment record covers other tests too",
                file=_file(test),
                expected="a column `time` in the file",
                hint="add a column `time` to the file, with times as in the record",
            )
        )
    times = np.hstack([test.times.positive, test.times.negative])
    missing = np.isfinite(np.hstack([test.positive, test.negative])) & ~np.isfinite(times)
    if np.any(missing):
        raise InputError(
            Fault(
                message="readings in the file have no time",
                file=_file(test),
                place="column time",
                expected="a time in every row, all written in one form",
                found=(
                    f"{int(missing.sum())} of {missing.size} readings without a time, the first at "
                    f"{test.targets[int(np.argmax(missing.any(axis=1)))]:.10g} mm"
                ),
                hint="correct these cells, or remove the column",
            )
        )
    if test.times.clock != record.clock:
        raise InputError(
            Fault(
                message="the file writes times differently from the environment record",
                file=_file(test),
                place="column time",
                expected=f"a {record.clock}, as in {record.sources[0].file}",
                found=f"a {test.times.clock}",
                hint="write the times of both files in the same way",
            )
        )
    first, last = float(np.nanmin(times)), float(np.nanmax(times))
    margin = _usual_distance(record)
    if first < record.times[0] - margin or last > record.times[-1] + margin:
        raise InputError(
            Fault(
                message="the environment record does not cover the whole time of the test",
                file=", ".join(source.file for source in record.sources),
                expected=f"rows from {_shown(first, record)} to {_shown(last, record)}",
                found=f"{_shown(record.times[0], record)} to {_shown(record.times[-1], record)}",
                hint=(
                    f"add the record that covers the time of {_file(test)}: `environment: "
                    "[FILE, FILE]`, or correct the clock in one of the files"
                ),
            )
        )
    return times


def _shown(time: float, record: EnvironmentRecord) -> str:
    """Return a time as text: a number, or date and time, as in the record."""
    if record.clock == "number":
        return f"{time:.10g}"
    moment = datetime.fromtimestamp(time, UTC)
    return f"{moment:%H:%M:%S}" if record.clock == "time of day" else f"{moment:%Y-%m-%d %H:%M:%S}"


def _usual_distance(record: EnvironmentRecord) -> float:
    """Return the median time between rows of the record, or 0 if it has one row."""
    return float(np.median(np.diff(record.times))) if record.times.size > 1 else 0.0


def _at(
    record: EnvironmentRecord, times: FloatArray | None, readings: FloatArray
) -> Mapping[str, FloatArray]:
    """Return the environment values at each reading, interpolated in time; the mean of all rows if
    ``times`` is None.
    """
    if times is None:
        return {name: np.full_like(readings, value.mean()) for name, value in record.values.items()}
    return {name: np.interp(times, record.times, value) for name, value in record.values.items()}


def _index(environment: Environment, at: Mapping[str, FloatArray]) -> FloatArray:
    temperature, pressure, humidity = (at[name] for name in AIR)
    return _EQUATIONS[environment.equation](temperature, pressure, humidity)


def _counted(environment: Environment) -> float:
    """Return the refractive index of air with which the instrument computed its readings."""
    air = environment.instrument_air
    if air is None:
        return 1.0
    values = (air.air_c, air.pressure_hpa, air.humidity_percent)
    return float(
        _index(environment, {name: np.array(v) for name, v in zip(AIR, values, strict=True)})
    )


def _gap(record: EnvironmentRecord, times: FloatArray) -> Iterator[Finding]:
    """Yield a finding if the record has an unusually long gap during the test."""
    usual = _usual_distance(record)
    within = (record.times[1:] > np.nanmin(times)) & (record.times[:-1] < np.nanmax(times))
    widest = float(np.max(np.diff(record.times)[within], initial=0.0))
    if widest > _GAP * usual:
        yield Finding.of("CW-T038", "warning", gap=widest / usual, file=record.sources[0].file)


def _light_finding(
    environment: Environment, at: Mapping[str, FloatArray], rate: FloatArray, zero: float
) -> Finding:
    air = environment.instrument_air
    least, most = (_PER_MILLION * float(pick(rate)) for pick in (np.nanmin, np.nanmax))
    return Finding.of(
        "CW-T028",
        "info" if air is None or air.stated else "warning",
        least=least,
        most=most if most - least > _SAME_RATE else None,
        zero=zero,
        equation=environment.equation,
        air_c=float(np.nanmean(at["air_c"])),
        pressure_hpa=float(np.nanmean(at["pressure_hpa"])),
        humidity_percent=float(np.nanmean(at["humidity_percent"])),
        counted=_counted(environment),
        assumed=air is not None and not air.stated,
    )


def _untimed(
    environment: Environment, test: PositioningTest, thermal: Thermal | None
) -> Iterator[Finding]:
    """Yield a finding if the environment varied, which cannot be corrected for without times.

    The variation is in µm over the range of the targets. A small variation has no finding.
    ``thermal``: the expansion, if its temperature is taken from the record; else None.
    """
    record = environment.record
    varied = np.zeros_like(record.times)
    if record.has_air:
        varied = varied + _index(environment, record.values)
    if thermal is not None and MATERIAL in record.values:
        varied = varied + 1e-6 * thermal.alpha_m * record.values[MATERIAL]
    length = float(test.targets[-1] - test.targets[0])
    size = float(np.ptp(varied)) * length * MICROMETRES_PER_MILLIMETRE
    if size > _SMALL:
        yield Finding.of("CW-T039", "warning", range=size, length=length)


def _changes(
    times: FloatArray,
    split: int,
    light: FloatArray,
    expansion: FloatArray,
    rest: FloatArray,
    *,
    unused: bool,
) -> Iterator[Finding]:
    """Yield a finding about the changes of the readings during the test, µm: the change ``light``
    by the air, the change ``expansion`` by temperature, and the change ``rest`` that remains. The
    first ``split`` columns are runs in +, the others in −.

    A straight line over time is fitted to the readings of each target and direction. Its slope
    times the duration of the test is the change at the target. For air and expansion, the target
    with the largest change is reported. For the rest, the mean over the targets is reported, with
    its standard error. If a target was approached only once in each direction, there is no finding.
    ``unused``: whether the record has a temperature of the material that the job does not use.
    """
    duration = float(np.nanmax(times) - np.nanmin(times))
    centred = _centred(times, split)
    spread = np.sum(centred**2, axis=1)
    if np.any(spread == 0.0):
        return
    way = duration * MICROMETRES_PER_MILLIMETRE
    of_light, of_expansion, of_rest = (
        way * np.sum(centred * _centred(values, split), axis=1) / spread
        for values in (light, expansion, rest)
    )
    at = int(np.argmax(np.abs(of_light + of_expansion)))
    count = of_rest.size
    yield Finding.of(
        "CW-T029",
        "info",
        light=float(of_light[at]),
        expansion=float(of_expansion[at]),
        rest=float(np.mean(of_rest)),
        std_error=float(np.std(of_rest, ddof=1) / np.sqrt(count)) if count > 1 else None,
        unused=unused,
    )


def _centred(values: FloatArray, split: int) -> FloatArray:
    """Return values (m, n) minus the mean at each target and direction, 0 where missing. The first
    ``split`` columns are runs in +, the others in −.
    """
    blocks = []
    for block in (values[:, :split], values[:, split:]):
        there = np.isfinite(block)
        count = np.maximum(there.sum(axis=1, keepdims=True), 1)
        filled = np.where(there, block, 0.0)
        blocks.append(np.where(there, filled - filled.sum(axis=1, keepdims=True) / count, 0.0))
    return np.hstack(blocks)
