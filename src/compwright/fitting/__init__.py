"""Fit the table that a control can hold best under its limits, with a proof of optimality. Only
this room imports a solver.
"""
