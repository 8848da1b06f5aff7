"""The browser app: a server on this machine, its HTTP API, and the page that it serves.

Only `rolamento.cli.browser` imports this package; it calls use cases of `rolamento.tasks` and shows
pages of `rolamento.pages`, as the command line does.
"""
