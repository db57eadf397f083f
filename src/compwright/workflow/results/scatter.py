"""Standard errors of the parameters of a positioning test, computed from the readings in the test's
JSON document.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from compwright.evaluation.standard_errors import slope_error, standard_errors


def errors_of(result: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """Return standard error and degrees of freedom of each parameter of a positioning result."""
    positive, negative = (
        np.array(
            [
                [np.nan if value is None else value for value in target[f"deviations_{direction}"]]
                for target in result["targets"]
            ],
            dtype=np.float64,
        ).reshape(len(result["targets"]), -1)
        for direction in ("positive", "negative")
    )
    errors = standard_errors(positive, negative, result["coverage"])
    found = {name: (error.value, error.dof) for name, error in errors.items()}
    positions = np.array([target["position"] for target in result["targets"]], dtype=np.float64)
    slope = slope_error(positions, positive, negative) if result["axis_kind"] == "linear" else None
    if slope is not None:
        found["slope"] = (1000.0 * slope.value, slope.dof)
    return found
