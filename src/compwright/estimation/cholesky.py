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

    Rounding can make the matrix indefinite, for example with readings without any scatter. Then a
    jitter is added to its diagonal, and increased until the factor exists (Rasmussen and Williams,
    Gaussian Processes for Machine Learning, 2006, section 3.4.3: numerical stability).

    Raises LinAlgError if the largest jitter is not enough.
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
    """Return the Cholesky factor L (n, n) of a symmetric ``matrix`` (n, n), and the vector
    inverse(L) ``values`` (n,).

    ``largest``: an upper bound of the number ``values``' inverse(``matrix``) ``values``. Both
    results come from one factorisation: ``values`` are appended to the matrix as its last row and
    column (Golub and Van Loan 2013, section 4.2.5). If rounding makes the matrix singular,
    `cholesky_factor` is used.
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

    The matrix is split into two diagonal blocks ``first`` and ``second`` and the block ``coupling``
    below the diagonal. The diagonal blocks are inverted; the block below the diagonal of the
    inverse is -inverse(second) coupling inverse(first) (Golub and Van Loan, Matrix Computations,
    4th ed. 2013, section 3.1).
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
