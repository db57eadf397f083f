"""The ground floor: errors, units, findings, provenance, storage, YAML. Imports nothing of the
house.
"""
