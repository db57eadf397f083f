"""compwright: evaluate positioning tests, fit, export, predict and verify axis compensation
tables.
"""

__version__ = "0.1.0"
