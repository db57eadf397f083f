"""The deal of random jobs on variations of the real archive: what is special, how it is marked, and
in which form the control's files are given and come out.
"""

from __future__ import annotations

import re

import numpy as np

import backup_variations_sinumerik as variations
import sinumerik_archive as archive
from backup_active_sinumerik import ACTIVE
from backup_cases_sinumerik import MUST_REFUSE, Case, start, style
from sinumerik_container import Packing

# What is answerable by the facts pages and by what acts the same before and after: the mark of the
# axis' ground stands.
PROMISED = {
    "inch_control",
    "table_over_itself",
    "table_over_itself_without_a_sign",
    "backlash_factor",
    "dynamic_backlash",
    "another_axis_moves_this_one",
    "gantry_named",
    "second_gantry",
    "inch_with_builders_tables",
}
_WITHOUT_TABLES = {
    "nothing",
    "known_by_two_names",
    "renamed",
    "words_for_numbers",
    "nearly_dividing_step",
    "odd_step_of_a_neighbour",
    "stale_points_behind_the_end",
    "second_gantry",
    "backlash_factor",
    "inch_control",
    "programs_in_the_container",
    "small_files_over_the_container",
}
_GRIDLESS = {"few_points", "inch_control", "inch_with_builders_tables", "inch_said_by_the_job"}
_OPEN = {"inch_of_another_length", "units_against_the_files"}


class Whole(Packing):
    """All members of the real container, with the texts of the case in them."""

    def packed(self, texts: dict[str, str]) -> bytes:
        return archive.whole_container(texts)


def dealt(seed: int) -> Case:
    """The job of one seed."""
    rng = np.random.default_rng([842, seed])
    case = start(seed, rng)
    chosen = [special for special, n in (*variations.SPECIALS, *ACTIVE) for _ in range(n)]
    special = chosen[int(rng.integers(len(chosen)))]
    case.told.append(special.__name__)
    ground = case.mark, case.demand, case.code
    special(case, rng)
    if special.__name__ in PROMISED:
        case.mark, case.demand, case.code = ground
    if case.files is None and not case.none:
        deliver(case, rng, special.__name__)
    elif case.files is not None and rng.random() < 0.3:
        case.options["files"] = "small"
        case.told.append("small")
    relatives(case, rng, special.__name__)
    spacing(case, rng, special.__name__)
    return case


def deliver(case: Case, rng: np.random.Generator, special: str) -> None:
    """Texts that are patched, texts beside which small files come out, or the container."""
    form = str(rng.choice(["patched", "small", "container", "whole"], p=[0.35, 0.2, 0.37, 0.08]))
    if case.packing is None and form in {"patched", "small"}:
        cec = case.cec
        style(case, rng)
        if case.mark == MUST_REFUSE:
            case.cec = cec
        if form == "small" or rng.random() < 0.2:
            case.options["files"] = form
    elif case.packing is None and form == "whole" and case.cec is not None and not _inch(case):
        case.packing = Whole()
    elif case.packing is None:
        case.packing = Packing(
            version=str(rng.choice(["002", "002", "000"])),
            copies=("AX_EEC.INI",) if rng.random() < 0.3 else (),
            marks=bool(rng.random() < 0.3),
        )
    else:
        form = "container"
    case.told.append(form)


def _inch(case: Case) -> bool:
    return "IS_METRIC=0" in case.md or "INCH\n" in case.md


def relatives(case: Case, rng: np.random.Generator, special: str) -> None:
    """The 840D pl and the ONE with the same files; the 828D where no cross-axis table is ours."""
    others = ["siemens-840d-pl", "siemens-one"]
    if special in _WITHOUT_TABLES:
        others.append("siemens-828d")
    if case.format == "siemens-840d-sl" and rng.random() < 0.3:
        case.format = str(rng.choice(others))
        case.told.append(case.format)


def spacing(case: Case, rng: np.random.Generator, special: str) -> None:
    """Left out, ``auto``, or a number that fits the points reserved."""
    draw = float(rng.random())
    if special in _GRIDLESS or special in _OPEN or case.none or draw < 0.55:
        return
    if draw < 0.8:
        case.table["spacing"] = "auto"
    else:
        named = named_spacing(case, rng)
        case.table["spacing"] = f"{named:g}" if named else "auto"
    case.told.append(f"spacing {case.table['spacing']}")


def named_spacing(case: Case, rng: np.random.Generator) -> float:
    found = re.search(rf"\$MA_MM_ENC_COMP_MAX_POINTS\[{case.system},{case.axis}\]=(\d+)", case.md)
    most = min(int(found[1]) if found else 40, 40) - 1
    low, high = case.travel
    if case.modulo:
        fit = [step for step in (10, 12, 15, 18, 20, 24, 30, 36, 40, 45) if 360 / step <= most]
        return float(rng.choice(fit)) if fit else 0.0
    whole = [
        n
        for n in range(max(2, min(6, most)), most + 1)
        if round((high - low) / n, 3) * n == high - low
    ]
    return round((high - low) / int(rng.choice(whole)), 3) if whole else 0.0
