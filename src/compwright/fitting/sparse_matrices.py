"""Sparse matrices in numpy alone, so that the proof of an optimum does not depend on a solver.

Every sum is taken in the order of the entries, so that each processor gives the same result.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import FloatArray

IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SparseMatrix:
    """A sparse matrix with entries ``value`` (e,) at (``row``, ``column``), sorted by row, each
    place at most once.
    """

    shape: tuple[int, int]
    row: IntArray
    column: IntArray
    value: FloatArray

    @property
    def transposed(self) -> SparseMatrix:
        """The transposed matrix."""
        return from_entries(self.shape[::-1], self.column, self.row, self.value)

    def transposed_times(self, x: FloatArray) -> FloatArray:
        """Return the product (columns,) of the transposed matrix with the vector ``x`` (rows,)."""
        product: FloatArray = np.bincount(
            self.column, self.value * x[self.row], minlength=self.shape[1]
        ).astype(np.float64)
        return product

    def __matmul__(self, x: FloatArray) -> FloatArray:
        """Return the product (rows,) with the vector ``x`` (columns,)."""
        product: FloatArray = np.bincount(
            self.row, self.value * x[self.column], minlength=self.shape[0]
        ).astype(np.float64)
        return product

    def dense(self) -> FloatArray:
        """Return the matrix as a dense array."""
        full = np.zeros(self.shape)
        full[self.row, self.column] = self.value
        return full

    def diagonal(self) -> FloatArray:
        """Return the diagonal entries (n,)."""
        full = np.zeros(min(self.shape))
        there = self.row == self.column
        full[self.row[there]] = self.value[there]
        return full

    def upper(self) -> SparseMatrix:
        """Return the upper triangle, diagonal included."""
        kept = self.column >= self.row
        return SparseMatrix(
            shape=self.shape, row=self.row[kept], column=self.column[kept], value=self.value[kept]
        )

    def taken(self, rows: BoolArray) -> SparseMatrix:
        """Return the matrix of only those rows that are marked in ``rows``."""
        new = np.cumsum(rows) - 1
        kept = rows[self.row]
        shape = (int(np.count_nonzero(rows)), self.shape[1])
        return SparseMatrix(
            shape=shape,
            row=new[self.row[kept]],
            column=self.column[kept],
            value=self.value[kept],
        )

    def placed(self, shape: tuple[int, int], row: int = 0, column: int = 0) -> SparseMatrix:
        """Return a matrix of ``shape``: this matrix from ``row``, ``column`` on, elsewhere zero."""
        return SparseMatrix(
            shape=shape, row=self.row + row, column=self.column + column, value=self.value
        )

    def times(self, factor: float) -> SparseMatrix:
        """Return the sparse matrix multiplied by the number ``factor``."""
        return SparseMatrix(
            shape=self.shape, row=self.row, column=self.column, value=factor * self.value
        )

    def largest_in_rows(self, divisor: FloatArray) -> FloatArray:
        """Return the largest absolute entry of each row (rows,), after division by the ``divisor``
        (columns,) of its column. It is 0 in an empty row.
        """
        largest = np.zeros(self.shape[0])
        np.maximum.at(largest, self.row, np.abs(self.value) / divisor[self.column])
        return largest

    def gram(self, weights: FloatArray) -> SparseMatrix:
        """Return the product M' diag(``weights``) M (columns, columns) for this matrix M, as in
        weighted least squares (Golub and Van Loan, Matrix Computations, 4th ed. 2013, section 6.1).
        """
        weighted = self.value * weights[self.row]
        rows, columns, values = [self.column], [self.column], [weighted * self.value]
        for apart in range(1, self.row.size):
            same = self.row[apart:] == self.row[:-apart]
            if not np.any(same):
                break
            one, other = self.column[:-apart][same], self.column[apart:][same]
            product = weighted[:-apart][same] * self.value[apart:][same]
            rows += [one, other]
            columns += [other, one]
            values += [product, product]
        size = self.shape[1]
        return from_entries(
            (size, size), np.concatenate(rows), np.concatenate(columns), np.concatenate(values)
        )


def from_entries(
    shape: tuple[int, int], row: IntArray, column: IntArray, value: FloatArray
) -> SparseMatrix:
    """Return the matrix with the given entries, which can be in any order. Entries at the same
    place are added up.
    """
    places = row * shape[1] + column
    order = np.argsort(places, kind="stable")
    places = places[order]
    first = np.diff(places, prepend=-1) != 0
    total = np.bincount(np.cumsum(first) - 1, value[order])
    kept = total != 0.0
    row, column = np.divmod(places[first][kept], shape[1])
    return SparseMatrix(shape=shape, row=row, column=column, value=total[kept])


def from_dense(matrix: FloatArray) -> SparseMatrix:
    """Return the non-zero entries of ``matrix`` (r, c) as a sparse matrix."""
    row, column = np.nonzero(matrix)
    return SparseMatrix(
        shape=(matrix.shape[0], matrix.shape[1]), row=row, column=column, value=matrix[row, column]
    )


def identity(size: int) -> SparseMatrix:
    """Return the identity matrix (size, size)."""
    every = np.arange(size, dtype=np.int64)
    return SparseMatrix(shape=(size, size), row=every, column=every, value=np.ones(size))


def differences(size: int) -> SparseMatrix:
    """Return the matrix (size - 1, size) that computes the difference of each value from the one
    before it.
    """
    row = np.repeat(np.arange(size - 1, dtype=np.int64), 2)
    sides = np.tile([0, 1], size - 1)
    return SparseMatrix(
        shape=(size - 1, size), row=row, column=row + sides, value=2.0 * sides - 1.0
    )


def sum_of(matrices: Sequence[SparseMatrix]) -> SparseMatrix:
    """Return the sum of matrices of the same shape."""
    return from_entries(
        matrices[0].shape,
        np.concatenate([one.row for one in matrices]),
        np.concatenate([one.column for one in matrices]),
        np.concatenate([one.value for one in matrices]),
    )


def stack_rows(matrices: Sequence[SparseMatrix], columns: int) -> SparseMatrix:
    """Return matrices with ``columns`` columns, stacked one below the other."""
    starts = np.cumsum([0, *(one.shape[0] for one in matrices)])
    shape = (int(starts[-1]), columns)
    blocks = [one.placed(shape, int(start)) for one, start in zip(matrices, starts, strict=False)]
    none = np.empty(0, dtype=np.int64)
    return SparseMatrix(
        shape=shape,
        row=np.concatenate([none, *(one.row for one in blocks)]),
        column=np.concatenate([none, *(one.column for one in blocks)]),
        value=np.concatenate([np.empty(0), *(one.value for one in blocks)]),
    )
