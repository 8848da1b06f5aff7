"""What the documentation site adds to Sphinx, and the pages that it makes from the program."""
