"""Read the header of a ``.b5r`` file, and the results printed by the vendor's software."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from compwright.instruments.b5r_fields import finite
from compwright.instruments.safe_xml import Element
from compwright.records.circular import CircularRun

_UNITS: Final[Mapping[str, str]] = {
    "UT_LENGTH_MM": "mm",
    "UT_LENGTH_UM": "um",
    "UT_FEEDRATE": "mm/min",
    "UT_SQUARENESS": "um/m",
    "UT_SERVO_MISMATCH": "ms",
    "UT_SCALE_ERROR": "ppm",
    "UT_ANGLE": "deg",
    "UT_RANKING": "rank",
    "UT_PERCENT": "%",
}
BAR: Final = ("TEST_SPEC", "INSTRUMENT", "DYNAMIC_BALLBAR")
#: Key of the header -> path below TEST_DOCUMENT; what a file does not hold is left out.
_HEADER: Final[Mapping[str, tuple[str, ...]]] = {
    "operator": ("OPERATOR",),
    "comment": ("COMMENT",),
    "date": ("DATE_STARTED",),
    "date_completed": ("DATE_COMPLETED",),
    "ballbar_serial": ("EQUIPMENT", "BALLBAR", "SERIAL_NUMBER"),
    "ballbar_certificate": ("EQUIPMENT", "BALLBAR", "CERTIFICATE_NUMBER"),
    "ballbar_last_calibrated": ("EQUIPMENT", "BALLBAR", "LAST_CALIBRATED"),
    "calibrator_serial": ("EQUIPMENT", "CALIBRATOR", "SERIAL_NUMBER"),
    "calibrated_length_mm": ("EQUIPMENT", "CALIBRATOR", "CALIBRATED_LENGTH"),
    "calibrator_temperature_c": ("EQUIPMENT", "CALIBRATOR", "TEMPERATURE"),
    "software": ("EQUIPMENT", "SOFTWARE", "TITLE"),
    "software_version": ("EQUIPMENT", "SOFTWARE", "VERSION"),
    "programmed_feed_mm_min": (*BAR, "PROGRAMMED_FEEDRATE"),
    "overshoot_deg": (*BAR, "OVERSHOOT_ANGLE"),
    "centre": (*BAR, "CENTRE"),
    "nc_program": (*BAR, "NC_PROGRAM_ID"),
    "expansion_um_m_k": (*BAR, "TEMP_MATERIAL_COEFFICIENT"),
}


def header_of(root: Element, elements: Sequence[Element]) -> dict[str, str]:
    """Return the facts about test, machine and instrument in a ballbar file, by compwright's names
    of the facts.
    """
    header = {
        key: " ".join(found.text.split())
        for key, path in _HEADER.items()
        if (found := root.first(*path)) and found.text
    }
    for key, path, attribute in (
        ("test", ("TEST_SPEC",), "NAME"),
        ("machine", ("MACHINE_TESTED",), "NAME"),
        ("instrument", ("TEST_SPEC", "INSTRUMENT"), "MODEL"),
        ("view", (*BAR, "PLANE"), "VIEW"),
    ):
        found = root.first(*path)
        if found is not None and found.attributes.get(attribute):
            header[key] = found.attributes[attribute]
    for key, tag in (("run_temperature_c", "RUN_TEMPERATURE"), ("sample_rate_hz", "SAMPLE_RATE")):
        texts = [found.text for element in elements if (found := element.first(tag)) and found.text]
        if texts:
            header[key] = ", ".join(dict.fromkeys(texts))
    return header


def vendor_results(
    root: Element, elements: Sequence[Element], runs: Sequence[CircularRun]
) -> dict[str, object]:
    """Return the results that the vendor's software printed: those of each run, and those of each
    analysis.

    The first key is a run (``ccw``, ``cw``, ``ccw 2``) or an analysis (name and version), the
    second the name of the result.
    """
    groups = [
        *(
            (run.sense if run.number == 1 else f"{run.sense} {run.number}", e)
            for run, e in zip(runs, elements, strict=True)
        ),
        *(
            (" ".join(filter(None, map(e.attributes.get, ("NAME", "version")))), e)
            for e in root.all("ANALYSIS")
        ),
    ]
    vendor: dict[str, object] = {}
    for key, element in groups:
        features = {
            feature.attributes.get("NAME", ""): _feature(feature)
            for feature in element.all("FEATURE")
        }
        if features and key:
            vendor[key] = features
    return vendor


def _feature(feature: Element) -> dict[str, object]:
    unit = feature.attributes.get("DT", "")
    value = finite(feature.text)
    printed: dict[str, object] = {
        "value": feature.text if value is None else value,
        "unit": _UNITS.get(unit, unit),
    }
    if feature.attributes.get("VALID", "True").lower() != "true":
        printed["valid"] = False
    return printed
