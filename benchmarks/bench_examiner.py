"""Judge the statistics from outside: virtual machines, the command line, fresh tests.

The predicted bands are held against fresh tests of the same machine with the table that was made.
"""

import argparse
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from examiner_axes import (
    SCENARIOS,
    Axis,
    accuracy,
    corrections_at,
    fresh,
    judge,
    run,
    sound,
    spread_targets,
    write_job,
)

TOGETHER = 8  # axes in a job
FACTORS = (0.8, 1.1, 1.4, 2.0)


def batches(
    scenario: str, count: int, seed: int, folder: Path, *, tight: bool = False
) -> Iterator[dict[str, Any]]:
    """Make axes of one scenario, run them, and yield each one's judgement.

    `tight`: run again with limits just above the prediction, the most that it promises.
    """
    for first in range(0, count, TOGETHER):
        rng = np.random.default_rng([seed, first, sum(map(ord, scenario))])
        axes, limits = [], {}
        for number in range(first, min(first + TOGETHER, count)):
            axis = SCENARIOS[scenario](rng, number)
            axis.name = f"J{number}"
            axis.readings = axis.test(rng, axis.targets)
            best = [accuracy(axis.noise(rng, axis.runs, axis.targets)) for _ in range(200)]
            limits[axis.name] = max(0.05, FACTORS[number % 4] * float(np.quantile(best, 0.9)))
            axes.append(axis)
        place = folder / scenario / str(first)
        code, answer = run_job(place, axes, limits)
        if tight and answer:
            for name, its in answer["axes"].items():
                bands = (its[key]["A"]["p95"] for key in ("predicted", "predicted_new_targets"))
                limits[name] = 1.03 * max(bands)
            code, answer = run_job(place, axes, limits)
        if not answer:
            yield {"folder": str(place), "exit": code}
            continue
        for axis in axes:
            result = judge(axis, answer["axes"][axis.name], limits[axis.name])
            doubts = doubts_of(answer, axis.name)
            yield result | {"folder": str(place), "exit": code, "doubts": doubts}


def run_job(
    place: Path, axes: list[Axis], limits: dict[str, float], state: str = "none"
) -> tuple[int, dict[str, Any]]:
    """Run a job in a folder; return its exit code and prediction, empty if there is none."""
    job = write_job(place, axes, limits, state)
    code, said = run("run", job, "--out", place / "out", "--force")
    (place / "said.txt").write_text(said, encoding="utf-8")
    path = place / "out" / "prediction.json"
    return code, read(path) if path.exists() else {}


NO_TABLE = {
    "positions": [0.0, 1.0],
    "correction_positive": [0.0, 0.0],
    "correction_negative": [0.0, 0.0],
}
STALE = (
    "rounded",
    "fewer runs",
    "datum",
    "uncompensated",
    "uncompensated, new targets",
    "other cycle",
)


def second_test(axis: Axis, kind: str, table: dict[str, Any], rng: np.random.Generator) -> None:
    """Give the axis another test: a stale one of STALE, or an honest one with the table."""
    old, targets = axis.readings, axis.targets
    if kind in ("rounded", "fewer runs", "datum"):
        axis.readings = np.round(old + (7.3 if kind == "datum" else 0.0), 1)[
            :, : 3 if kind == "fewer runs" else None
        ]
    elif kind == "uncompensated":
        axis.readings = np.round(axis.test(rng, targets), 1)
    elif kind == "uncompensated, new targets":
        axis.targets = spread_targets(len(targets) + 2, axis.travel, rng)
        axis.readings = axis.test(rng, axis.targets)
    elif kind == "other cycle":
        order = rng.permutation(old.shape[1])
        axis.readings = np.round(old[:, order] - old.mean(), 1)
    else:
        axis.targets = (
            targets if kind == "honest" else spread_targets(len(targets), axis.travel, rng)
        )
        axis.readings = axis.test(rng, axis.targets, corrections_at(table, axis.targets))


def second_rounds(count: int, seed: int, folder: Path, scenario: str) -> Iterator[dict[str, Any]]:
    """Make tables from none, load them, and give the control another test of each axis."""
    kinds = ("honest", "honest, new targets") if scenario == "honest" else STALE
    for first in range(0, count, TOGETHER):
        rng = np.random.default_rng([seed, first, 16])
        place, axes = folder / scenario / str(first), []
        for number in range(first, min(first + TOGETHER, count)):
            axes.append(sound(rng, number))
            axes[-1].name = f"J{number}"
            axes[-1].readings = axes[-1].test(rng, axes[-1].targets)
        tables = loaded(axes, place)
        for number, axis in enumerate(axes, first):
            second_test(axis, kinds[number % len(kinds)], tables[axis.name], rng)
        limits = {axis.name: 100.0 for axis in axes}
        code, answer = run_job(place / "second", axes, limits, "[../control]")
        decisions = read(place / "second" / "out" / "record.json")["decisions"]["axes"]
        for number, axis in enumerate(axes, first):
            now, old = answer["axes"][axis.name], tables[axis.name]
            written = decisions[axis.name]["table"] == "written"
            acting = {"first": old, "second": now["table"] if written else old}
            medians = {
                key: float(np.median(fresh(axis, table, 5, new_targets=True)))
                for key, table in acting.items()
            }
            kind = kinds[number % len(kinds)]
            doubts = doubts_of(answer, axis.name)
            yield (
                {"axis": axis.name, "kind": kind, "exit": code, "written": written}
                | {"doubts": doubts, "folder": str(place)}
                | medians
            )


def loaded(axes: list[Axis], place: Path) -> dict[str, dict[str, Any]]:
    """Make the tables of axes without one and put them into `place`/control; return them."""
    _, answer = run_job(place / "first", axes, {})
    state = place / "control"
    state.mkdir(exist_ok=True)
    for path in (place / "first" / "out" / "tables" / "linuxcnc").iterdir():
        (state / path.name).write_bytes(path.read_bytes())
    return {axis.name: answer["axes"][axis.name].get("table") or NO_TABLE for axis in axes}


def read(path: Path) -> dict[str, Any]:
    """Return a JSON document."""
    document: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return document


def doubts_of(answer: dict[str, Any], axis: str) -> list[str]:
    """Return the codes of the doubts that speak of an axis."""
    name = re.compile(rf"\b{axis}\b")
    return [d["code"] for d in answer["doubts"] if name.search(d["message"])]


def share(values: list[bool] | list[float]) -> str:
    """Return a mean in percent with its standard error."""
    if not values:
        return "-"
    numbers = np.array(values, dtype=float)
    error = numbers.std(ddof=1) / np.sqrt(len(numbers)) if len(numbers) > 1 else 0.0
    return f"{100 * numbers.mean():.1f} ± {100 * error:.1f} %"


def summary(scenario: str, results: list[dict[str, Any]]) -> str:
    """Return the counts of a scenario."""
    judged = [r for r in results if "same" in r]
    accepted = [r for r in judged if r["decision"] == "accept" and not r["doubts"]]
    broken = [max(r["same"]["broken"], r["new"]["broken"]) for r in accepted]
    easy = [
        r["decision"] == "accept"
        for r in judged
        if r["limit"] and r["new"]["fresh"][2] < 0.75 * r["limit"]
    ]
    ratios = [r["new"]["ratio"] for r in judged]
    lines = [f"{scenario}: {len(judged)} axes judged, {len(results) - len(judged)} jobs without"]
    for place in ("same", "new"):
        inside, above = ([r[place][key] for r in judged] for key in ("inside", "above"))
        lines.append(f"  {place} targets: in the band {share(inside)}, above it {share(above)}")
    lines += [
        f"  limits accepted: {len(accepted)}, broken by {share(broken)} of the fresh tests",
        f"  by more than 10 % of them: {sum(b > 0.1 for b in broken)}",
        f"  limits with a third of room: {len(easy)}, accepted {share(easy)}",
        f"  mean A by that of interpolation: {np.median(ratios):.3f}, at most {max(ratios):.3f}",
        f"  doubted: {sum(bool(r['doubts']) for r in judged)}",
    ]
    return "\n".join(lines)


def second_summary(results: list[dict[str, Any]]) -> str:
    """Return the counts of second rounds by kind."""
    lines = []
    for kind in sorted({r["kind"] for r in results}):
        those = [r for r in results if r["kind"] == kind]
        worse = [r for r in those if r["written"] and r["second"] > 1.2 * r["first"]]
        lines.append(
            f"  {kind}: {len(those)}, doubted {sum(bool(r['doubts']) for r in those)}; tables that "
            f"make A larger {len(worse)}, without a doubt {sum(not r['doubts'] for r in worse)}"
        )
    return "\n".join(["second rounds:", *lines])


def main() -> None:
    """Run what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    kinds = [*SCENARIOS, "honest", "stale"]
    parser.add_argument("scenarios", nargs="*", default=kinds, help=", ".join(kinds))
    parser.add_argument("--count", type=int, default=16)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, default=Path("examiner"))
    parser.add_argument("--tight", action="store_true", help="limits just above the prediction")
    arguments = parser.parse_args()
    for scenario in arguments.scenarios:
        count, seed, out = arguments.count, arguments.seed, arguments.out
        makes = (
            second_rounds(count, seed, out, scenario) if scenario in {"honest", "stale"} else None
        )
        results = []
        for result in makes or batches(scenario, count, seed, out, tight=arguments.tight):
            results.append(result)
            with (out / f"{scenario}.jsonl").open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(result) + "\n")
        print(second_summary(results) if makes else summary(scenario, results), flush=True)


if __name__ == "__main__":
    main()
