"""Matrices of few entries against numpy's full ones, and tables of thousands of nodes."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from compwright.fitting.fit import fit_table
from compwright.fitting.sparse_matrices import (
    SparseMatrix,
    differences,
    from_dense,
    from_entries,
    identity,
    stack_rows,
    sum_of,
)
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest

UM = 1e-3


def some(seed: int, rows: int = 7, columns: int = 5) -> SparseMatrix:
    """About a third of the places hold something; the third row is empty."""
    rng = np.random.default_rng(seed)
    full = rng.standard_normal((rows, columns)) * (rng.random((rows, columns)) < 0.35)
    full[2] = 0.0
    return from_dense(full)


def test_entries_come_back_row_by_row() -> None:
    matrix = some(1)
    assert_array_equal(from_dense(matrix.dense()).dense(), matrix.dense())
    assert np.all(np.diff(matrix.row * 5 + matrix.column) > 0)
    assert matrix.value.size == np.count_nonzero(matrix.dense())


def test_products_and_transposed() -> None:
    matrix, x = some(2), np.arange(1.0, 6.0)
    assert_allclose(matrix @ x, matrix.dense() @ x, rtol=0, atol=1e-14)
    assert_array_equal(matrix.transposed.dense(), matrix.dense().T)
    assert (some(2, 4, 4) @ np.ones(4)).shape == (4,)
    assert (matrix.times(0.0) @ x).tolist() == [0.0] * 7


@pytest.mark.parametrize("seed", range(5))
def test_the_normal_equations_are_those_of_the_full_matrix(seed: int) -> None:
    matrix, weights = some(seed), np.linspace(0.5, 2.0, 7)
    full = matrix.dense()
    gram = matrix.gram(weights)
    assert_allclose(gram.dense(), full.T @ np.diag(weights) @ full, rtol=0, atol=1e-14)
    assert_array_equal(gram.dense(), gram.dense().T)  # to the last bit
    assert_array_equal(gram.upper().dense(), np.triu(gram.dense()))
    assert_array_equal(gram.diagonal(), np.diag(gram.dense()))


def test_rows_taken_placed_stacked_and_summed() -> None:
    one, other = some(3), some(4)
    marked = np.array([True, False, True, True, False, False, True])
    assert_array_equal(one.taken(marked).dense(), one.dense()[marked])
    wide = np.zeros((9, 8))
    wide[1:8, 2:7] = one.dense()
    assert_array_equal(one.placed((9, 8), 1, 2).dense(), wide)
    assert_array_equal(stack_rows([one, other], 5).dense(), np.vstack([one.dense(), other.dense()]))
    assert stack_rows([], 5).dense().shape == (0, 5)
    assert_array_equal(sum_of([one, other]).dense(), one.dense() + other.dense())
    twice = from_entries(
        (1, 2), np.array([0, 0, 0]), np.array([1, 1, 0]), np.array([2.0, 3.0, 0.0])
    )
    assert twice.dense().tolist() == [[0.0, 5.0]]
    assert twice.value.tolist() == [5.0]  # a zero is no entry
    assert identity(3).times(2.0).dense().tolist() == (2.0 * np.eye(3)).tolist()
    assert_array_equal(differences(4).dense(), np.diff(np.eye(4), axis=0))


def test_the_largest_of_each_row() -> None:
    matrix, divisor = some(5), np.array([1.0, 2.0, 0.5, 4.0, 1.0])
    assert_array_equal(
        matrix.largest_in_rows(divisor), np.max(np.abs(matrix.dense()) / divisor, axis=1)
    )


@pytest.mark.parametrize("mode", ["single", "bidirectional"])
@pytest.mark.parametrize("reach", [np.inf, 0.012])
def test_four_thousand_nodes_take_no_matrix_of_all_with_all(mode: str, reach: float) -> None:
    """A full matrix of 4001 x 4001 numbers alone would take 128 MB. What is wanted is a straight
    line of 10 µm/m through zero over 4 m: where the range allows it, each node holds it to half a
    quantum, beyond that the range.
    """
    where = np.linspace(0.0, 4000.0, 2001)
    line = 1e-5 * where
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=where,
        positive=line,
        negative=line,
        reference=0.0,
        reference_return=Direction.POSITIVE,
        noise=0.5 * UM,
        reversal_log_odds=0.0,
        periods=(),
    )
    capacity = Capacity(
        format="many",
        spacing="equidistant",
        position_quantum=0.001,
        quantum=0.01 * UM,
        value_range=(-reach, reach),
        max_points=5000,
        curves=2,
        backlash_quantum=None,
    )
    request = TableRequest(spacing=1.0, mode=mode)  # type: ignore[arg-type]
    fit_table(wanted, replace(capacity, max_points=None), TableRequest(), address="0")  # loads all
    tracemalloc.start()
    table = fit_table(wanted, capacity, request, address="0").compensation
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 40e6  # bytes
    assert table.positions.size == 4001
    held = np.minimum(1e-5 * table.positions, reach)
    assert_allclose(table.positive, held, rtol=0, atol=0.02 * UM)
