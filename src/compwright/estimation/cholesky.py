"""Cholesky factors of symmetric matrices, computed with numpy alone. numpy has no solver for
triangular matrices.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: From this size on a triangle is split: the general inverse of a larger one takes much longer.
_SMALL: Final = 48


def cholesky_factor(matrix: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return a symmetric ``matrix`` (n, n), made positive definite, and its lower Cholesky factor.

    Where rounding has left it indefinite (readings without any scatter), a jitter as large as is
    needed is added to its diagonal first (Rasmussen and Williams, Gaussian Processes for Machine
    Learning, 2006, section 3.4.3: numerical stability).

    Raises LinAlgError where that is not enough.
    """
    for exponent in range(-15, -3):
        try:
            return matrix, np.asarray(np.linalg.cholesky(matrix), dtype=np.float64)
        except np.linalg.LinAlgError:
            more = 10.0**exponent * float(np.max(np.diag(matrix)))
            matrix = matrix + more * np.eye(matrix.shape[0])
    return matrix, np.asarray(np.linalg.cholesky(matrix), dtype=np.float64)


def factor_and_solve(
    matrix: FloatArray, values: FloatArray, largest: float
) -> tuple[FloatArray, FloatArray]:
    """Return the Cholesky factor L (n, n) of a symmetric ``matrix`` (n, n), and inverse(L)
    ``values`` (n,). ``largest``: an upper bound of values' inverse(matrix) values.

    Both come from one factorisation: ``values`` are appended to the matrix as its last row and
    column (Golub and Van Loan 2013, section 4.2.5). A matrix that is singular by rounding is
    treated as in `cholesky_factor`.
    """
    size = values.size
    bordered = np.empty((size + 1, size + 1))
    bordered[:size, :size] = matrix
    bordered[size, :size] = bordered[:size, size] = values
    bordered[size, size] = 1.0 + 2.0 * largest
    try:
        factor = np.asarray(np.linalg.cholesky(bordered), dtype=np.float64)
    except np.linalg.LinAlgError:
        factor = cholesky_factor(matrix)[1]
        return factor, np.asarray(np.linalg.solve(factor, values), dtype=np.float64)
    return factor[:size, :size], factor[size, :size]


def inverse_triangle(factor: FloatArray) -> FloatArray:
    """Return the inverse (n, n) of a lower triangular matrix ``factor`` (n, n). Raises LinAlgError
    for a zero on the diagonal.

    The halves are inverted, and what couples them is -inverse(second) coupling inverse(first)
    (Golub and Van Loan, Matrix Computations, 4th ed. 2013, section 3.1).
    """
    size = factor.shape[0]
    if size <= _SMALL:
        return np.asarray(np.linalg.inv(factor), dtype=np.float64)
    half = size // 2
    inverse = np.zeros_like(factor)
    first = inverse[:half, :half] = inverse_triangle(factor[:half, :half])
    second = inverse[half:, half:] = inverse_triangle(factor[half:, half:])
    inverse[half:, :half] = -second @ (factor[half:, :half] @ first)
    return inverse
