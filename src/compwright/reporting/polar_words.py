"""Words of the picture of a circular test: of its title, runs, centre and zones. Results as in
`polar`.
"""

from __future__ import annotations

from typing import Final

from compwright.reporting.charts import Document
from compwright.reporting.numbers import MISSING, number, plain, standard_text

_TURN: Final = 360.0


def title(result: Document) -> str:
    """Return plane, name and standard of a circular test as one line."""
    parts = [
        f"Circle {result['plane']}",
        _one_line(str(result.get("name") or ""), 50),
        standard_text(result.get("standard", "")),
    ]
    return "   ".join(part for part in parts if part)


def setting(result: Document) -> str:
    """Return radius, feed and arc."""
    arc, feed = result["arc"], result.get("feed")
    parts = [
        f"R {plain(result['nominal_radius'])} mm",
        f"{feed:.5g} mm/min" if isinstance(feed, int | float) else "",
        "" if arc["extent"] >= _TURN else f"arc {arc['extent']:.4g}° from {arc['start']:.4g}°",
    ]
    return ", ".join(part for part in parts if part)


def _one_line(text: str, most: int) -> str:
    line = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return line if len(line) <= most else f"{line[: most - 1]}…"


def run_text(key: str, result: Document) -> str:
    """Return the numbers of one direction: G, and F where it is given, else F about the
    least-squares centre.
    """
    values = result["parameters"]
    given = values.get(f"F_max_{key}") is not None
    kind = "" if given else "_lsc"
    name = (
        "F"
        if given and result["arc"]["extent"] >= _TURN
        else "F (set-up centre)"
        if given
        else "F (own centre)"
    )
    highest, lowest = values.get(f"F_max_{key}{kind}"), values.get(f"F_min_{key}{kind}")
    return (
        f"{key}: G {number(values.get(f'G_{key}'))}, {name} {signed(highest)} / {signed(lowest)} µm"
    )


def signed(value: float | None) -> str:
    """Return a number with its sign, for the eye."""
    if value is None:
        return MISSING
    return f"+{number(value)}" if value >= 0.005 else number(value)


def centre_text(name: str, centre: tuple[float, float], result: Document) -> str:
    """Return which centre the picture is laid about, with its place, µm."""
    axes = result["axes"]
    kind = {"common": "common least-squares centre", "set-up": "set-up centre"}.get(
        name, f"least-squares centre of {name}"
    )
    hysteresis = result["parameters"].get("H")  # it is taken about the common centre
    told = "" if hysteresis is None else f"; H {number(hysteresis)} µm"
    return f"{kind}: {axes[0]} {number(centre[0], 1)}, {axes[1]} {number(centre[1], 1)} µm{told}"


def zone_text(key: str, values: Document) -> str:
    """Return G of the zone that is drawn, and beside it what belongs to both directions."""
    both = key == "both"
    name = "G_bidirectional" if both else f"G_{key}"
    told = f"minimum zone{' of both' if both else f', {key}'}: G {number(values.get(name))} µm"
    return f"{told}; D {signed(values['D'])} µm" if both and values.get("D") is not None else told


def grouped(value: float) -> str:
    """Return a whole number in groups of three digits."""
    return f"{value:,.0f}".replace(",", " ")
