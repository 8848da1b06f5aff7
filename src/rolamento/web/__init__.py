"""The browser app and the HTTP API: they parse, call a task, show a page."""
