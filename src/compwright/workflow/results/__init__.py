"""The output of commands: results, card, record, terminal text."""
