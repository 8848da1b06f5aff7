"""Use cases from end to end: one call each, which gives records."""
