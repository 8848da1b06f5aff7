"""Figures: functions that take records and Axes, and return the Axes. No physics here."""
