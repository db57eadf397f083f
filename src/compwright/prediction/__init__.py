"""What the next test will show, with its uncertainty."""
