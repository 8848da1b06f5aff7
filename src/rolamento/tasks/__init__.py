"""Use cases from end to end: what command line, app and notebook call; they return records."""
