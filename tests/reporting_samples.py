"""Hand-made documents for the tests of `reporting`, and the printed tables of the standards with
their printed parameters.
"""

from __future__ import annotations

import csv
import math
import random
import re
import statistics
from collections.abc import Sequence
from typing import Any

from places import STANDARD_TABLES

Readings = Sequence[Sequence[float | None]]


def positioning(
    positions: Sequence[float],
    positive: Readings | None,
    negative: Readings | None,
    parameters: dict[str, float | None],
    *,
    unit: str = "um",
    coverage: float = 2.0,
    standard: str = "iso230-2:2014",
    name: str = "x_before",
    axis: str = "X",
) -> dict[str, Any]:
    """An entry of an evaluation document; per-target statistics crudely from the readings,
    parameters as given.
    """
    targets = []
    for index, position in enumerate(positions):
        entry: dict[str, Any] = {"position": position}
        for key, readings in (("positive", positive), ("negative", negative)):
            values = [value for value in (readings[index] if readings else []) if value is not None]
            entry[f"n_{key}"] = len(values)
            entry[f"mean_{key}"] = statistics.fmean(values) if values else None
            entry[f"s_{key}"] = statistics.stdev(values) if len(values) > 1 else None
            entry[f"R_{key}"] = 2 * coverage * entry[f"s_{key}"] if len(values) > 1 else None
            entry[f"deviations_{key}"] = list(readings[index]) if readings else []
        both = entry["mean_positive"] is not None and entry["mean_negative"] is not None
        entry["reversal"] = entry["mean_positive"] - entry["mean_negative"] if both else None
        entry["mean"] = (entry["mean_positive"] + entry["mean_negative"]) / 2 if both else None
        entry["R"] = None
        targets.append(entry)
    return {
        "kind": "positioning",
        "name": name,
        "sources": [{"file": f"runs/{name}.csv", "sha256": "a3f1" * 16}],
        "axis": axis,
        "axis_kind": "linear" if unit == "um" else "rotary",
        "standard": standard,
        "cycle": "standard",
        "position_unit": "mm" if unit == "um" else "deg",
        "unit": unit,
        "coverage": coverage,
        "n_targets": len(positions),
        "n_runs": {
            "positive": len(positive[0]) if positive else 0,
            "negative": len(negative[0]) if negative else 0,
        },
        "parameters": parameters,
        "at": {"R": 1408.462, "B": 175.077} if parameters.get("R") is not None else {},
        "uncertainty": None,
        "targets": targets,
        "not_applicable": {
            key: "one approach per direction (clause 5.2)"
            for key, value in parameters.items()
            if value is None
        },
        "findings": [],
    }


def printed_table(year: int) -> dict[str, Any]:
    """Table 2 of ISO 230-2:1988 or 1997 with the parameters that the document prints (µm)."""
    with (STANDARD_TABLES / f"iso-230-2-{year}-table-2.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    positions = sorted({float(row["target_mm"]) for row in rows})
    sides = {
        sign: [
            [
                float(r["deviation_um"])
                for r in rows
                if float(r["target_mm"]) == p and r["direction"] == sign
            ]
            for p in positions
        ]
        for sign in "+-"
    }
    printed: dict[int, dict[str, float | None]] = {
        1988: {"A": 18.03, "R": 13.49, "R_positive": 11.84, "R_negative": 9.9, "B_mean": -1.53,
        "E": None, "M": None, "B": None},
        1997: {
            "A": 9.6, "A_positive": 6.1, "A_negative": 5.7, "E": 7.7, "E_positive": 3.9, "E_negative": 4.0, "M": 4.0,
            "R": 6.5, "R_positive": 2.9, "R_negative": 2.5, "B": 4.1, "B_mean": -3.7,
        },
    }  # fmt: skip
    return positioning(
        positions, sides["+"], sides["-"], printed[year],
        coverage=3.0 if year == 1988 else 2.0, standard=f"iso230-2:{year}", name=f"table_2_{year}",
    )  # fmt: skip


def made_up(
    amplitude: float = 12.0, reversal: float = -6.0, *, seed: int = 4, **more: Any
) -> dict[str, Any]:
    """A screw axis from -850 to 0 mm, n = 5, with lost motion. The parameters are round numbers put
    in by hand.
    """
    generator = random.Random(seed)  # noqa: S311  not for secrets
    positions = [round(-835.0 + 81.7 * index + generator.uniform(-8, 8), 3) for index in range(11)]

    def readings(offset: float) -> list[list[float]]:
        return [
            [
                round(
                    amplitude * math.sin(p / 260) + 0.012 * p + offset + generator.gauss(0, 0.7), 2
                )
                for _ in range(5)
            ]
            for p in positions
        ]

    parameters: dict[str, float | None] = {
        "A": 31.42, "A_positive": 25.9, "A_negative": 26.1, "E": 28.77, "E_positive": 23.4, "E_negative": 23.6, "M": 22.8,
        "R": 9.31, "R_positive": 3.61, "R_negative": 3.27, "B": 6.84, "B_mean": -6.02,
    }  # fmt: skip
    parameters.update(more.pop("parameters", {}))
    return positioning(
        positions, readings(reversal / 2), readings(-reversal / 2), parameters, **more
    )


def quantiles(median: float, low: float, high: float) -> dict[str, float]:
    return {"median": median, "p05": low, "p95": high}


def run_view() -> dict[str, Any]:
    """A view of two axes: one with limits and a table in both directions, one rotary, measured in
    one direction.
    """
    x = made_up()
    x["uncertainty"] = {
        "A": {"U": 1.9, "coverage": 2},
        "E": {"U": 1.7, "coverage": 2},
        "B": {"U": 0.4, "coverage": 2},
    }
    c = positioning(
        [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0],
        [[1.1, 2.0], [2.0, None], [3.0, 3.5], [2.0, 1.0], [0.0, 0.1], [-2.0, -2.4], [-4.0, -4.1],
        [-1.0, -1.2], [0.5, 0.7]],
        None,
        {"A": None, "A_positive": 9.13, "E": None, "E_positive": 7.52, "R": None,
        "R_positive": 3.24, "M": None, "B": None},
        unit="arcsec", axis="C", name="c_before",
    )  # fmt: skip
    nodes = [-850.0 + 50.0 * index for index in range(18)]
    dense = [-850.0 + 5.0 * index for index in range(171)]

    def wanted(position: float, offset: float) -> float:
        return -(12.0 * math.sin(position / 260.0) + 0.012 * position + offset) - 3.0

    before = {key: value for key, value in x["parameters"].items() if value is not None}
    predicted = {
        "A": quantiles(4.12, 3.47, 5.03), "A_positive": quantiles(3.6, 3.0, 4.4), "E": quantiles(1.93, 1.42, 2.61),
        "M": quantiles(1.2, 0.8, 1.9), "R": quantiles(3.91, 3.2, 4.9), "B": quantiles(0.82, 0.41, 1.31),
        "B_mean": quantiles(0.02, -0.61, 0.63),
    }  # fmt: skip
    new = {
        key: quantiles(value["median"] + 0.77, value["p05"] + 0.5, value["p95"] + 1.0)
        for key, value in predicted.items()
    }
    test = {
        "name": "x_before",
        "before": before,
        "predicted": predicted,
        "predicted_new_targets": new,
    }
    rotary = {
        "name": "c_before",
        "before": {"A_positive": 9.13, "E_positive": 7.52},
        "predicted": {"A_positive": quantiles(4.1, 3.3, 5.2)},
    }
    return {
        "title": "VMC 850, axes X and C",
        "machine": {
            "machine": "VMC 850",
            "serial number": "1111111",
            "type": "vertical machining centre",
        },
        "format": {"id": "fanuc-30i", "title": "FANUC Series 30i"},
        "version": "0.1.0",
        "no_tables": None,
        "evaluation": {"schema": "compwright/evaluation/1", "results": [x, c], "errors": []},
        "prediction": {
            "schema": "compwright/prediction/1",
            "format": "fanuc-30i",
            "axes": {
                "X": {
                    "tests": [test],
                    **{key: test[key] for key in ("before", "predicted", "predicted_new_targets")},
                    "table": {
                        "positions": nodes,
                        "correction_positive": [float(round(wanted(node, -3.0))) for node in nodes],
                        "correction_negative": [float(round(wanted(node, 3.0))) for node in nodes],
                        "unit": "um",
                    },
                    "quantum": 1.0,
                    "limits": [
                        {"cause": "noise", "value": 2.45, "unit": "um"},
                        {"cause": "quantum", "value": 0.4, "unit": "um", "rms": 0.297},
                        {"cause": "number of points", "value": -0.02, "unit": "um", "rms": 0.115},
                    ],
                    "limited": {"parameter": "A", "now": 24.6, "then": 4.89, "least": 3.9},
                    "points_worth": [
                        {
                            "points": points,
                            "spacing": 850.0 / (points - 1),
                            "median": median,
                            "p05": 0.8 * median,
                            "p95": 1.3 * median,
                            "written": points == 18,
                            "there": points == 6,
                        }
                        for points, median in ((2, 16.0), (6, 8.0), (18, 4.89), (86, 4.8))
                    ],
                    "accept": {
                        "A": {"limit": 8.0, "decision": "accept"},
                        "E": {"limit": 2.0, "decision": "undecided"},
                        "B": {"limit": 0.3, "decision": "reject"},
                    },
                },
                "C": {
                    "tests": [rotary],
                    "before": rotary["before"],
                    "predicted": rotary["predicted"],
                    "predicted_new_targets": None,
                    "table": None,
                    "quantum": None,
                    "limits": [],
                    "limited": None,
                    "accept": {},
                },
            },
        },
        "axes": {
            "X": {
                "address": "1",
                "kind": "linear",
                "unit": "um",
                "estimate": {
                    "positions": dense,
                    "mean_positive": [-wanted(p, -3.0) - 3.0 for p in dense],
                    "mean_negative": [-wanted(p, 3.0) - 3.0 for p in dense],
                    "std_positive": [0.45 for _ in dense],
                    "std_negative": [0.45 for _ in dense],
                },
                "wanted": {
                    "positions": dense,
                    "positive": [wanted(p, -3.0) for p in dense],
                    "negative": [wanted(p, 3.0) for p in dense],
                },
                "mode": "bidirectional",
                "mode_reason": "The reversal varies over the travel by more than its uncertainty.",
                "certificate": {
                    "primal_feasibility_mm": 0.0,
                    "dual_feasibility": 1.2e-13,
                    "stationarity": 3.1e-12,
                },
                "state": ["CNC-PARA.TXT", "PITCH.TXT"],
                "predicted_targets": {
                    "positions": [target["position"] for target in x["targets"]],
                    "positive": [0.4 * math.sin(index) for index in range(11)],
                    "negative": [-0.5 + 0.4 * math.cos(index) for index in range(11)],
                    "s": 0.71,
                },
                "findings": [
                    {
                        "code": "CW-E003",
                        "severity": "info",
                        "message": "No screw pitch was given: a periodic error is not estimated.",
                    },
                    {
                        "code": "CW-T005",
                        "severity": "warning",
                        "message": "The readings drift by 1.2 µm over the five traverses.",
                    },
                ],
            },
            "C": {
                "address": "4",
                "kind": "rotary",
                "unit": "arcsec",
                "estimate": None,
                "wanted": None,
                "mode": None,
                "mode_reason": None,
                "certificate": {},
                "state": None,
                "predicted_targets": {
                    "positions": [0.0, 90.0, 180.0],
                    "positive": [1.0, 3.0, 0.0],
                    "negative": None,
                    "s": 0.4,
                },
                "findings": [],
            },
        },
        "assumed": [
            {
                "fact": "detection unit",
                "value": "0.001 mm",
                "evidence": "confirmed: given in the job",
            },
            {
                "fact": "sign of a pitch error value",
                "value": "added to the command",
                "evidence": "unconfirmed: B-64490EN 5.2 does not say",
            },
            {
                "fact": "compensation is active",
                "value": "yes",
                "evidence": "inferred from bit 0 of parameter 3602",
            },
        ],
        "findings": [
            {
                "code": "CW-S001",
                "severity": "warning",
                "message": "The state of axis C was not said.",
            }
        ],
        "files": [
            "plan.json",
            "evaluation.json",
            "prediction.json",
            "tables/fanuc-30i/PITCH.TXT",
            "card/card.html",
            "card/card.md",
        ],
    }


def verify_view() -> dict[str, Any]:
    run = run_view()
    after = made_up(
        0.8, -0.5, seed=9, name="x_after", parameters={"A": 4.43, "E": 2.21, "R": 3.94, "B": 1.17}
    )
    for target in after["targets"]:  # the slope is compensated
        for key in ("positive", "negative"):
            target[f"mean_{key}"] -= 0.012 * target["position"]
            target[f"deviations_{key}"] = [
                round(value - 0.012 * target["position"], 2)
                for value in target[f"deviations_{key}"]
            ]
    x = run["prediction"]["axes"]["X"]
    return {
        "title": "VMC 850 after loading",
        "machine": run["machine"],
        "format": run["format"],
        "version": "0.1.0",
        "verification": {
            "schema": "compwright/verification/1",
            "axes": {
                "X": {
                    "before": x["before"],
                    "predicted": x["predicted"],
                    "after": after["parameters"],
                    "loading": {
                        "verdict": "loaded",
                        "equivalent": ["thermal"],
                        "factor": 1.0,
                        "shift_nodes": 0,
                        "margin": 41.2,
                        "message": (
                            "The test after loading agrees with the table as it was written."
                        ),
                    },
                    "accept": {
                        "A": {"limit": 8.0, "value": 4.43, "U": 1.9, "decision": "accept"},
                        "E": {"limit": 2.0, "value": 2.21, "U": 1.7, "decision": "undecided"},
                    },
                }
            },
            "circles": {},
            "verdict": "undecided",
            "headline": "Undecided: the tests do not tell",
        },
        "evaluation_before": {"results": [run["evaluation"]["results"][0]], "errors": []},
        "evaluation_after": {
            "results": [after],
            "errors": [{"file": "runs/broken.csv", "message": "line 3: not a number"}],
        },
        "axes": {"X": {"unit": "um", "predicted_targets": run["axes"]["X"]["predicted_targets"]}},
        "findings": [],
    }


def sample_card() -> dict[str, Any]:
    """A card with every kind of entry."""
    return {
        "title": "Commissioning card: VMC 850",
        "machine": {"machine": "VMC 850", "serial number": "1111111"},
        "format": {"id": "fanuc-30i", "title": "FANUC Series 30i"},
        "axes": [
            {
                "name": "X",
                "address": "1",
                "unit": "um",
                "rows": [
                    {"quantity": "3620 number of the reference point", "old": 0, "new": 17},
                    {"quantity": "3621 smallest number", "old": 0, "new": 0},
                    {"quantity": "3624 interval, mm", "old": None, "new": 50.0},
                    {"quantity": "1851 backlash, detection units", "old": 4, "new": -2},
                ],
                "quick_check": [
                    {
                        "position": -800.0,
                        "direction": "+",
                        "adds": 10.0,
                        "expected": 0.31,
                        "stop": 8.0,
                    },
                    {
                        "position": -50.5,
                        "direction": "-",
                        "adds": -3.0,
                        "expected": -0.62,
                        "stop": "8 µm either way",
                    },
                ],
                "points_needed": 18,
                "fixed_positions": [{"name": "tool change", "position": -20.0, "moves": 1.2}],
            }
        ],
        "steps": [
            {
                "title": "Save what is in the control",
                "text": "Punch out the parameters and the pitch error data to a card.",
                "evidence": "confirmed: B-64484EN 8.1",
            },
            {
                "title": "Load the pitch error file",
                "text": (
                    "EDIT mode, parameter write enabled, F INPUT, N READ.\nThen power off and on."
                ),
                "evidence": "unconfirmed: the line form N1nnnnQ0P was not seen in a manual",
            },
            {
                "title": "Set the parameters",
                "text": "3620 = ‹reference number›, 3624 = ‹spacing›.",
                "evidence": "confirmed",
                "heads": ["axis", "reference number", "spacing"],
                "rows": [["X", "17", "50"], ["Y", "40", "25"]],
            },
            {
                "title": "Return the axis to its reference",
                "text": "Slowly, with a hand on the feed override.",
                "evidence": "",
            },
        ],
        "unconfirmed": [
            (
                "The sign of a pitch error value: do the quick check at one position before the whole"
                " travel."
            )
        ],
        "assumed": [
            {
                "fact": "detection unit",
                "value": "0.001 mm",
                "evidence": "confirmed: given in the job",
            },
            {"fact": "sign", "value": "added", "evidence": "unconfirmed"},
        ],
        "restore": [
            "Load rollback/fanuc-30i/PITCH.TXT in the same way.",
            "Power off and on; return all axes to their references.",
        ],
        "files": ["tables/fanuc-30i/PITCH.TXT", "rollback/fanuc-30i/PITCH.TXT"],
        "proven": "Not yet proven on a real machine.",
    }


#: Frequent words of English that no German, French or Russian text has.
_ONLY_ENGLISH = re.compile(
    r"\b(?:the|is|are|of|and|not|with|for|from|by|what|which|must|says?|to)\b"
)


def english_words(page: bytes, *names: str) -> list[str]:
    """English words on a page with the text around them. Names in code and quoted messages of a
    control stay as they are; so do the given ``names``.
    """
    text = re.sub(r"<(head|code).*?</\1>", "", page.decode("utf-8"), flags=re.DOTALL)
    text = re.sub(r"&#39;[^&]*&#39;|<[^>]+>", " ", text)
    for name in names:
        text = text.replace(name, "")
    return [text[word.start() - 40 : word.end() + 40] for word in _ONLY_ENGLISH.finditer(text)]
