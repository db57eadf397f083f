"""Families of controls, one for each shape of tables: each family has a folder, and all have the
same interface (`Family`).
"""
