"""Fit the best table that a control can hold, with a proof of optimality. Only this package imports
a solver.
"""
