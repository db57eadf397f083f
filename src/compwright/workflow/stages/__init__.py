"""The stages of a job: measured, wanted, fitted, written and read once, predicted."""
