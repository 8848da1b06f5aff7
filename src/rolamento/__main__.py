"""`python -m rolamento` is the command line."""

from rolamento.cli import main

if __name__ == "__main__":  # worker processes of the app load this file under another name
    main()
