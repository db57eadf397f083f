"""Prediction of the next test of an axis or circle, with its uncertainty."""
