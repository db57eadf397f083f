"""JSON in and out. Only here units are converted to those of the JSON."""
