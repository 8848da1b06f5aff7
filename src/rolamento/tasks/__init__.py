"""Use cases from end to end, which the command line, a notebook or a page calls for records."""
