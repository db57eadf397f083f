"""The XML elements of a ballbar file that compwright knows, and the meaning of their texts and
attributes.
"""

from __future__ import annotations

from typing import Final

from compwright.instruments.spans import Elements, by_key

ELEMENTS: Final = Elements(
    tags=by_key(
        {
            "name": (  # they have no text of their own
                *("TEST_DOCUMENT", "INSTRUMENT", "DYNAMIC_BALLBAR", "PLANE", "RUN_SPEC"),
                *("FEATURE_SPEC", "TOLERANCE", "AVERAGING", "ANALYSIS_SPEC", "ANALYSIS"),
                *("EQUIPMENT", "BALLBAR", "CALIBRATOR", "SOFTWARE", "RUN_RESULTS", "BALLBAR_RUN"),
            ),
            "numbers": (
                *("NOMINAL_LENGTH", "PROGRAMMED_FEEDRATE", "START_ANGLE", "END_ANGLE", "CENTRE"),
                *("OVERSHOOT_ANGLE", "TEST_RADIUS", "LOWER_LIMIT", "UPPER_LIMIT", "SAMPLE_RATE"),
                *("SPINDLE_NUMBER", "TEMP_MATERIAL_COEFFICIENT", "SCALE_FACTOR", "TEMPERATURE"),
                *("CALIBRATED_LENGTH", "EXPANSION_COEFFICIENT", "READINGS", "START_INDEX"),
                *("END_INDEX", "RUN_TEMPERATURE", "SIMULATION", "NUMBER_OF_ERRORS"),
                "NUMBER_OF_WARNINGS",
            ),
            "feature": ("FEATURE",),
            "date": ("DATE_STARTED", "DATE_COMPLETED", "LAST_CALIBRATED"),
            "axis": ("A_AXIS_NAME", "B_AXIS_NAME"),
            "sense": ("RUN_DIRECTION",),
            "product": ("MANUFACTURER", "MODEL", "AUTHOR", "TITLE"),
            "release": ("VERSION",),
            "machine": ("MACHINE_TESTED",),
            "serial number": ("SERIAL_NUMBER", "CERTIFICATE_NUMBER"),
            "operator": ("OPERATOR",),
            "program": ("NC_PROGRAM_ID",),
            "title": ("TEST_SPEC",),
            "remark": ("COMMENT",),
        }
    ),
    attributes=by_key(
        {
            "keywords": ("CALIBRATION_REQUIRED", "ENABLED", "VALID"),
            "result": ("DT", "STATUS", "LEVEL"),
            "product": ("MANUFACTURER", "MODEL"),
            "view": ("VIEW",),
            "plane": ("TEST_PLANE",),
            "release": ("VERSION",),
        }
    ),
    names={"MACHINE_TESTED": "machine", "TEST_SPEC": "title"},
)
