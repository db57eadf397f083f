"""Foundations of all packages: errors, units, findings, provenance, storage, YAML."""
