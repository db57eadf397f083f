"""What the test after loading proves, and the next round."""
