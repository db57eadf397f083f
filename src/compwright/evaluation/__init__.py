"""Evaluation of positioning tests: ISO 230-2, GOST 27843, VDI/DGQ 3441, test checks, uncertainty,
decisions.

Deviations in mm or deg inside; findings speak of µm or arcsec.
"""
