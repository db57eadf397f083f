"""What a command writes and shows: results, card, record, answers."""
