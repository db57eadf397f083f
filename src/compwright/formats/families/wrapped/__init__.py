"""PMAC scripts with repeating tables, whose values are whole fractions of an encoder count."""
