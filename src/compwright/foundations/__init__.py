"""Common foundations of all rooms: errors, units, findings, provenance, storage, YAML."""
