"""The table that a control holds best under its limits, with a certificate; the only room that
imports a solver.
"""
