"""`python -m rolamento` is the command line."""

from rolamento.cli import main

main()
