"""What a run shows: card, view, answers."""
