"""The data that packages exchange: immutable records that state their unit, direction and sign.

In all records, positions and deviations are in mm (linear) or deg (rotary). A deviation is measured
minus target. A correction is what the control adds to the command.
"""
