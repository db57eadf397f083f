"""Common foundations: errors, units, findings, provenance, storage, YAML. They import no other room
except the sentences.
"""
