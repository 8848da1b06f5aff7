"""Published numbers beside those that the program gives: a use case, a request."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, ClassVar

from rolamento.tasks.case_request import Finding, FindingRequest
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input, Product
from rolamento.words import marked, speaking

__all__ = ["VerificationRequest"]


def _in_markdown(asked: Any, found: Finding) -> str:
    """Return the page of the documentation, in English."""
    from rolamento.document.markdown import markdown
    from rolamento.pages.verification import verification_page

    with speaking("en"):
        return markdown(verification_page(found.found, introduction=True))


class VerificationRequest(FindingRequest):
    """Compare the program with published numbers.

    The exit code is 1 if one fails.

    Parameters
    ----------
    source
        Only this source, such as radaelli_2013.
    """

    source: Annotated[
        tuple[str, ...],
        Input("", "list", example="radaelli_2013", separator="", metavar="NAME", at_computer=True),
    ] = ()

    counts: ClassVar = True
    waiting: ClassVar = marked("Verifying …")
    json_meaning: ClassVar = "Write all numbers as JSON"
    examples: ClassVar = "Example: verify --source radaelli_2013."
    products: ClassVar = {
        "markdown": Product(
            marked("Write a page in Markdown; - for standard output."), _in_markdown, False
        )
    }

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `Verification`."""
        from rolamento.pages.verification import summary, verification_page
        from rolamento.verification import run

        found = run(self.source, progress=lambda source, done, total: progress(done, total))
        why = "" if found.passed else summary(found)
        return Finding(
            found, partial(verification_page, found), found.to_json, None, why, found.passed
        )
