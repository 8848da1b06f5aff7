"""Pages: a record becomes a `Document`, one page a file; no medium is known here."""
