"""Texts in the figure of a circular test: title, runs, centre and zones."""

from __future__ import annotations

from typing import Final

from compwright.reporting.charts import Document
from compwright.reporting.numbers import MISSING, number, plain, standard_text
from compwright.words.sentences import NumberText, Sentence, say

_TURN: Final = 360.0


def title(result: Document) -> Sentence:
    """Return plane, name and standard of a circular test as one line."""
    parts: list[str | Sentence] = [
        say("report.circle", plane=result["plane"], name=""),
        _one_line(str(result.get("name") or ""), 50),
        standard_text(result.get("standard", "")),
    ]
    return say("chart.line", parts=[part for part in parts if part], unit="")


def setting(result: Document) -> Sentence:
    """Return radius, feed and arc of a circular test as text."""
    arc, feed = result["arc"], result.get("feed")
    whole = arc["extent"] >= _TURN
    return say(
        "circle.setting",
        radius=plain(result["nominal_radius"]),
        feed=feed if isinstance(feed, int | float) else None,
        extent=0 if whole else arc["extent"],
        start=arc["start"],
    )


def _one_line(text: str, most: int) -> str:
    line = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return line if len(line) <= most else f"{line[: most - 1]}…"


def run_text(key: str, result: Document) -> Sentence:
    """Return circular deviation G and radial deviation F of one direction as text."""
    values = result["parameters"]
    given = values.get(f"F_max_{key}") is not None
    kind = "" if given else "_lsc"
    highest, lowest = values.get(f"F_max_{key}{kind}"), values.get(f"F_min_{key}{kind}")
    return say(
        "circle.run",
        sense=key,
        G=number(values.get(f"G_{key}")),
        centre=(
            ""
            if given and result["arc"]["extent"] >= _TURN
            else say("circle.about", centre="set_up" if given else "own")
        ),
        highest=signed(highest),
        lowest=signed(lowest),
    )


def signed(value: float | None) -> str:
    """Return a number with its sign, as text."""
    if value is None:
        return MISSING
    return NumberText(f"+{number(value)}") if value >= 0.005 else number(value)


def centre_text(name: str, centre: tuple[float, float], result: Document) -> Sentence:
    """Return name and position (µm) of the centre about which the figure is drawn, as text."""
    axes = result["axes"]
    hysteresis = result["parameters"].get("H")  # it is taken about the common centre
    return say(
        "circle.centre",
        name=name,
        first=axes[0],
        second=axes[1],
        x=number(centre[0], 1),
        y=number(centre[1], 1),
        H="" if hysteresis is None else number(hysteresis),
    )


def zone_text(key: str, values: Document) -> Sentence:
    """Return the circular deviation G of the drawn minimum zone as text."""
    both = key == "both"
    name = "G_bidirectional" if both else f"G_{key}"
    return say(
        "circle.zone",
        sense=key,
        G=number(values.get(name)),
        D=signed(values["D"]) if both and values.get("D") is not None else "",
    )


def grouped(value: float) -> str:
    """Return a whole number in groups of three digits."""
    return f"{value:,.0f}".replace(",", " ")
