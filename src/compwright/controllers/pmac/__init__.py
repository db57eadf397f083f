"""The virtual control of this maker."""
