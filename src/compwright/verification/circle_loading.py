"""Decision how the table of a squareness or of a scale error was loaded, from a circular test.

The hypotheses are those of an axis (`loading_hypotheses`): a table between two axes is a curve over
its input axis, too. A circle shows two values of such a curve: the squareness or scale error that
it makes, and how much these differ between the two directions of motion of the input axis. The
rating of the hypotheses and the choice of the name are those of an axis as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import AxisKind, FloatArray
from compwright.records.circular import CircularTest
from compwright.records.verification import Candidate, LoadingVerdict
from compwright.verification.hypothesis import Hypothesis, Loading
from compwright.verification.hypothesis_rating import (
    ANY_SLOPE,
    THERMAL,
    RatedHypothesis,
    rate_hypotheses,
)
from compwright.verification.likelihood import AfterMeans, ErrorBelief
from compwright.verification.loading import CLEAR
from compwright.verification.loading_hypotheses import loading_hypotheses
from compwright.verification.loading_messages import candidate_text
from compwright.verification.loading_names import REFUSED, NamedLoading, factor_of, name_loading
from compwright.verification.measurement_cases import MeasurementCase
from compwright.words.sentences import Sentence, say

#: Angles of a circle at which tables are compared, in the middle of equal pieces.
_ANGLES: Final = 96
#: Standard deviation by which a squareness differs in two tests of a machine that another day or
#: set-up changed, and a scale error in addition to a change of temperature, µm/m.
_OTHER_DAY: Final = 1.5
#: Distance in standard errors from which a factor with a known cause is not the measured one.
_OTHER_FACTOR: Final = 3.0
#: Faults of so many kinds that one of them fits nearly every value: they are listed, never named.
_MANY: Final = ("shifted", "partial")
#: A table of which no more than this part is active is near to one that is not active.
_LEAST_FACTOR: Final = 0.1
#: Smallest standard error that is believed, µm/m: 0.01 µm over a circle of 200 mm.
_LEAST_NOISE: Final = 0.05
#: An error of the active part is not stated as less than this.
_LEAST_ERROR: Final = 0.01
_PPM: Final = 1e6


@dataclass(frozen=True, slots=True)
class TableInCircle:
    """What a full circle of ``radius`` mm shows of a table that moves the ``output`` axis by the
    position of the ``input`` axis (0: first axis of the plane, 1: second).

    ``middle``: the position (mm) of the ``input`` axis in the centre.
    """

    radius: float
    middle: float
    input: int
    output: int

    @property
    def targets(self) -> FloatArray:
        """The positions (m,) of the input axis, mm."""
        return self._places[0]

    @property
    def _theta(self) -> FloatArray:
        theta: FloatArray = 2.0 * np.pi * (np.arange(_ANGLES) + 0.5) / _ANGLES
        return theta

    @property
    def _places(self) -> tuple[FloatArray, NDArray[np.intp]]:
        unit = (np.cos(self._theta), np.sin(self._theta))[self.input]
        targets, index = np.unique(
            np.round(self.middle + self.radius * unit, 9), return_inverse=True
        )
        return targets, index.astype(np.intp)

    def weights(self) -> FloatArray:
        """Return how much the circle shows of a change of the correction at the `targets`, (2, 2,
        m) by value shown, direction + or −, and target, µm/m for 1 mm. The values are the change of
        squareness or scale error, and that in + minus that in −.
        """
        unit = np.stack([np.cos(self._theta), np.sin(self._theta)])
        # in ccw the first axis moves to − in the upper half, the second to + in the right half
        ahead = np.sign((-unit[1], unit[0])[self.input])
        both = 0.5 * np.linalg.pinv(self._even)[0] * unit[self.output]
        half = 0.5 * np.linalg.pinv(self._odd)[0] * unit[self.output] * ahead
        targets, index = self._places
        return np.stack(
            [
                [np.bincount(index, each, targets.size) for each in pair]
                for pair in ((both, both), (half, -half))
            ]
        )

    def between_directions(
        self, after: CircularTest, expected: CircularTest
    ) -> tuple[float, float] | None:
        """Return by how much more the squareness or scale error in + differs from that in − in the
        test ``after`` loading than in the ``expected`` one, with the standard error, µm/m. None
        unless both are full circles in both directions.
        """
        curves = [_odd_curve(each, self._theta) for each in (after, expected)]
        if any(each is None for each in curves):
            return None
        found, was = (each for each in curves if each is not None)
        shapes = self._odd
        values, *_ = np.linalg.lstsq(shapes, found - was, rcond=None)
        left = found - was - shapes @ values
        dof = left.size - shapes.shape[1]
        square = float(left @ left)
        together = float(np.clip(left[1:] @ left[:-1] / max(square, 1e-300), 0.0, 0.95))
        variance = square / dof * (1.0 + together) / (1.0 - together)
        inverse = np.linalg.inv(shapes.T @ shapes)[0, 0]
        return float(values[0]), float(np.sqrt(variance * inverse))

    @property
    def _sign(self) -> float:
        """Squareness > 0 is more than 90°: moving one axis to + with the other makes it less."""
        return 1.0 if self.input == self.output else -1.0

    def _radial(self, side: FloatArray | float) -> FloatArray:
        """Return the radial deviation (n,) mm of 1 µm/m, with the sign ``side`` (n,)."""
        unit = np.stack([np.cos(self._theta), np.sin(self._theta)])
        along = self._sign / _PPM * self.radius * unit[self.input]
        shape: FloatArray = side * along * unit[self.output]
        return shape

    @property
    def _even(self) -> FloatArray:
        """The shapes (n, 5) of 1 µm/m, of the set-up, and of the two other values of this kind."""
        cos, sin = np.cos(self._theta), np.sin(self._theta)
        scales = {(0, 0): (sin * sin, cos * sin), (1, 1): (cos * cos, cos * sin)}
        others = scales.get((self.input, self.output), (cos * cos, sin * sin))
        return np.column_stack([self._radial(1.0), cos, sin, *others])

    @property
    def _odd(self) -> FloatArray:
        """The shapes (n, c) of half of ccw minus cw: that of 1 µm/m, half of it in + and minus half
        in −, and those of lost motion, lateral play, servo mismatch and set-up.
        """
        cos, sin = np.cos(self._theta), np.sin(self._theta)
        side = np.sign((-sin, cos)[self.input])
        reversals = [np.sign(sin) * cos, np.sign(cos) * sin, np.abs(sin), np.abs(cos)]
        waves = [np.ones_like(cos), cos, sin, cos * sin, cos * cos]
        return np.column_stack([self._radial(0.5 * side), *reversals, *waves])


def _odd_curve(test: CircularTest, theta: FloatArray) -> FloatArray | None:
    """Return half of the deviations (n,) mm in ccw minus those in cw at the angles ``theta`` rad,
    each the mean of its piece of the circle; None unless both are there.
    """
    curves = []
    for sense in ("ccw", "cw"):
        runs = [run for run in test.runs if run.sense == sense]
        if not test.full_circle or not runs:
            return None
        turns = np.concatenate([run.angles for run in runs]) / 360.0
        piece = np.floor(np.mod(turns, 1.0) * theta.size).astype(int) % theta.size
        values = np.concatenate([run.deviations for run in runs])
        number = np.bincount(piece, minlength=theta.size)
        if not np.all(number):
            return None
        curves.append(np.bincount(piece, values, theta.size) / number)
    half: FloatArray = 0.5 * (curves[0] - curves[1])
    return half


@dataclass(frozen=True, slots=True)
class ShownValue:
    """The squareness or scale error (µm/m) that a circle after loading shows.

    ``expected``: with all tables loaded; ``before``: with the tables as they were found.
    ``std_error``: of ``value`` minus ``expected``, from the noise of both tests. ``between``: by
    how much more it differs between the directions of the input axis than expected, with its
    standard error; None if unknown.
    """

    value: float
    expected: float
    before: float
    std_error: float
    between: tuple[float, float] | None = None

    @property
    def sides(self) -> tuple[tuple[float, float], ...]:
        """``between`` if it is known."""
        return () if self.between is None else (self.between,)

    @property
    def effect(self) -> Sentence:
        """The part of the planned change that is active, as text."""
        planned = self.before - self.expected
        part, error = (self.before - self.value) / planned, self.std_error / abs(planned)
        return say("loading.effect", part=part, error=max(error, _LEAST_ERROR))


def judge_circle(
    shown: ShownValue, table: TableInCircle, loadings: Sequence[Loading]
) -> LoadingVerdict:
    """Return the verdict on how a table was loaded, from what a circle after loading shows of it.

    ``loadings``: each way in which the control may hold the table, the most probable one first:
    with the existing one in it, or in addition to it.
    """
    values, noise = np.array([(shown.value, shown.std_error), *shown.sides]).T
    noise = np.maximum(noise, _LEAST_NOISE)
    errors: FloatArray = np.hypot(noise, _OTHER_DAY)
    scale = table.input == table.output
    mean = np.array([shown.expected, 0.0])[: values.size] / errors
    # A squareness is as before or not, equally probable. No axis has the same length twice.
    draws = [np.ones_like(mean), *([] if scale else [(errors / noise) ** 2])]
    after = AfterMeans(
        targets=np.arange(mean.size, dtype=np.float64),
        kind=AxisKind.LINEAR,
        plain=np.stack([values / errors, np.full_like(mean, np.nan)]),
        mean=np.stack([_one_row(values / errors)] * len(draws)),
        precision=np.stack([_one_row(each) for each in draws]),
        columns=np.zeros((len(draws), 2, mean.size, 0)),
        sigma=1.0,
        readings=2.0,  # so that 1 is the standard error of a difference
        datum=False,
    )
    belief = ErrorBelief(
        mean=_one_row(mean),
        root=np.zeros((2, mean.size, 0)),
        blocks=np.zeros((mean.size, 2, 2)),
    )
    ways = tuple(_hypotheses(loadings, table, errors, scale=scale))
    rated, _ = rate_hypotheses(after, [MeasurementCase(belief=belief, hypotheses=ways)], None)
    names = name_loading(after, rated, None)
    fits = any(each.score <= REFUSED for each in rated)
    same = {each.verdict for each in names.candidates} & set(names.equivalent)
    most = names.candidates[0].probability if same else names.together
    best = names.best
    if most < CLEAR or names.hidden or not names.fits or best.name in _MANY:
        return _open(shown, names.candidates if fits else ())
    off = abs(best.expected[0, 0] * errors[0] - shown.value)
    free = [each for each in rated if each.name == "scaled" and each.hypothesis.free is not None]
    if best.name == "scaled" and off > _OTHER_FACTOR * shown.std_error:
        best = max(free, key=lambda each: each.log)
    return _named(shown, names, best)


def _one_row(values: FloatArray) -> FloatArray:
    """Return ``values`` (m,) as means (2, m), as of an axis that was measured in one direction."""
    return np.stack([values, np.zeros_like(values)])


def _hypotheses(
    loadings: Iterable[Loading], table: TableInCircle, errors: FloatArray, *, scale: bool
) -> Iterable[Hypothesis]:
    """Yield the hypotheses of the ``loadings`` as changes of what the circle shows with the table
    loaded, in units of the ``errors``; of a scale also that the axis is longer or shorter now.
    """
    weights = table.weights()[: errors.size] / errors[:, np.newaxis, np.newaxis]

    def seen(change: FloatArray) -> FloatArray:
        values: FloatArray = np.tensordot(weights, change, 2)
        return values

    for number, loading in enumerate(loadings):
        every = loading_hypotheses(loading, table.targets)
        planned = every[0].change
        for each in every:
            off, free = seen(each.change - planned), each.free
            pattern = None if free is None else _one_row(seen(free))
            yield replace(
                each,
                positive=off,
                negative=np.zeros_like(off),
                free=pattern,
                weight=each.weight / (1 + number),
                inner=each.inner or each.factor <= _LEAST_FACTOR,
            )
    if scale:
        nothing = np.zeros(errors.size)
        longer = nothing.copy()
        longer[0] = ANY_SLOPE * _PPM / errors[0]
        yield Hypothesis(
            name="thermal",
            positive=nothing,
            negative=nothing,
            weight=THERMAL,
            free=_one_row(longer),
        )


def _open(shown: ShownValue, candidates: Sequence[Candidate]) -> LoadingVerdict:
    """Return the verdict ``undecided`` with the names that are possible; without ``candidates``, no
    known fault explains the test.
    """
    named = [
        say(
            "loading.candidate",
            name=candidate_text(each.verdict, each.detail),
            percent=100.0 * each.probability,
            sure=each.probability >= CLEAR,
        )
        for each in candidates
    ]
    return LoadingVerdict(
        verdict="undecided",
        margin=0.0,
        sentence=say("loading.circle", effect=shown.effect, candidates=named),
        candidates=tuple(candidates),
    )


def _named(shown: ShownValue, names: NamedLoading, best: RatedHypothesis) -> LoadingVerdict:
    way, factor = best.hypothesis, factor_of(best)
    sentence = say(
        "loading.verdict",
        verdict=best.name,
        detail=way.detail,
        effect=shown.effect,
        factor=factor,
        nodes=abs(way.shift_nodes),
        direction="+" if way.shift_nodes > 0 else "-",
        open=True,  # whether a file holds the total or only the change depends on the control
    )
    return LoadingVerdict(
        verdict=best.name,
        margin=names.margin,
        sentence=sentence,
        factor=factor,
        of=way.of,
        detail=way.detail,
        candidates=names.candidates,
    )
