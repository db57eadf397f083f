"""Judge the test after loading, and prepare the next round."""
