"""PMAC scripts with tables that repeat, whose values count 1/16 of an encoder count."""
