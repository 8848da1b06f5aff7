"""How fast Rolamento is, measured beside what a user would write instead; see docs/speed.md."""
