"""The words that a definition may use: names of quantities, field types, rules and limits."""

from __future__ import annotations

from typing import Literal, get_args

from compwright.records.verification import LoadingName

#: Version of the schema; a definition that names another one is refused.
SCHEMA_VERSION = 2

#: The quantities that a definition may bind: lengths and angles, choices between few values, and
#: what is taken as it stands.
MEASURES = (
    "value",
    "value_positive",
    "value_negative",
    "node_position",
    "table_start",
    "table_end",
    "table_spacing",
    "backlash",
    "slope",
    "cross_value",
    "cross_start",
    "cross_end",
    "cross_spacing",
)
CHOICES = (
    "repeats",
    "enabled",
    "table_form",
    "length_unit",
    "unit_word",
    "angle_unit",
    "rotary",
    "bidirectional",
    "diameter",
    "absolute_encoder",
    "compensation_off",
    "modulo",
    "cross_repeats",
    "cross_table_enabled",
    "cross_axis_enabled",
    "cross_metric",
)
PLAIN = (
    "max_points",
    "table_file",
    "reference_number",
    "first_number",
    "last_number",
    "magnification",
    "turn",
    "negative_first",
    "negative_offset",
    "backlash_rapid",
    "backlash_factor",
    "axis_name",
    "reference_coordinate",
    "axis_letters",
    "axis_order",
    "joint_count",
    "servo_period",
    "max_velocity",
    "max_acceleration",
    "home_offset",
    "home_search_velocity",
    "home_latch_velocity",
    "home_index",
    "home_index_kept",
    "home_absolute",
    "limit_low",
    "limit_high",
    "machine_axis",
    "channel_axis",
    "channel_machine_axis",
    "inch_length",
    "unit_mask",
    "encoders",
    "gantry_type",
    "modulo_range",
    "modulo_start",
    "temperature_type",
    "temperature_slope",
    "dynamic_backlash",
    "cross_input",
    "cross_output",
    "cross_direction",
    "cross_multiplier",
    "cross_weight",
    "cross_max_sum",
    "cross_max_points",
    "cross_type",
    "cross_input_ncu",
    "cross_output_ncu",
    "cross_first_added",
    "cross_second_added",
    "cross_other",
)
#: What a control has or has not as a whole: tables by which one axis corrects another, or itself in
#: one direction only.
CROSS = tuple(name for name in (*MEASURES, *CHOICES, *PLAIN) if name.startswith("cross_"))

#: The verdicts of `verify` and `compare` of which a definition says what to look at on the control:
#: not those of the measurement, nor those with an existing table, whose sentence says what to do.
_OF_NO_CONTROL = frozenset({"thermal", "measurement", "undecided", "increment", "on_top", "state"})
LOOKED_AT: tuple[LoadingName, ...] = tuple(
    name for name in get_args(LoadingName) if name not in _OF_NO_CONTROL
)

AddressType = Literal["integer", "name"]
Case = Literal["ignored", "kept"]
FieldType = Literal[
    "integer",
    "signed",
    "point_number",
    "bit",
    "key",
    "decimal",
    "decimal_ex",
    "real",
    "name",
    "label",
    "word",
    "text",
    "truth",
    "system_word",
]
Rest = Literal["none", "after_blank", "anything"]
Pairing = Literal["none", "two_columns"]
Sign = Literal["position", "error", "correction", "actual_position", "lost_motion", "half_each_way"]
Repeated = Literal["first", "last", "same"]
Say = Literal["nothing", "assumed", "warning"]
Predicate = Literal[
    "min_points",
    "max_points",
    "points_reserved",
    "line_length",
    "line_length_read",
    "no_backlash_beside_table",
    "no_endless_axis",
    "no_patching",
    "only_patching",
    "max_number",
    "max_magnification",
    "feed_per_spacing",
    "spacing_per_step",
    "cross_tables",
    "cross_points",
]
#: When a file belongs to the set: always, with one table for both directions, with one for each,
#: for cross-axis tables.
When = Literal["always", "one_curve", "two_curves", "cross"]
#: What a table of an axis that is programmed in diameter counts in.
DiameterTables = Literal["radius", "unconfirmed"]
OptionType = Literal["integer", "number", "choice", "text", "integers"]
#: Parameters in addition to the table on a control: read; other parameters under the same numbers,
#: which are ignored; or unknown.
Here = Literal["read", "another", "unknown"]
