"""JSON in and out: the one place where units change for the outside."""
