"""Names for pages that still hand a language on; goes with the last of them."""

from rolamento.studies import names
from rolamento.words import speaking

__all__ = ["torque_model_name", "variable_name"]


def variable_name(variable: str, language: str) -> str:
    """As `rolamento.studies.names.variable_name`."""
    with speaking(language):
        return names.variable_name(variable)


def torque_model_name(model: str, language: str, *, short: bool = False) -> str:
    """As `rolamento.studies.names.torque_model_name`."""
    with speaking(language):
        return names.torque_model_name(model, short=short)
