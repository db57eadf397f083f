"""From results to decisions: what is wanted of a control, and what a table will change."""
