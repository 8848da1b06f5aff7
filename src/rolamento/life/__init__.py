"""Rating and fatigue life: one file a theory, one record for all of them."""
