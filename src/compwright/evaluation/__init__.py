"""Evaluation of positioning tests: ISO 230-2, GOST 27843, VDI/DGQ 3441, test checks, uncertainty,
decisions.

Deviations are in mm or deg; findings state them in µm or arcsec.
"""
