"""Double-row cylindrical roller bearings with a cage, of machine-tool spindles: NN and NNU."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from rolamento.types import cylindrical
from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final[BearingType] = replace(
    cylindrical.TYPE,
    key="double_row_cylindrical",
    name=marked("double-row cylindrical roller bearing"),
    called="double_row_cylindrical zweireihiges_zylinderrollenlager nn nnu",
    rows=2,
    rated_together=True,
    class_table_of_tapered_bore="cylindrical_tapered",
    normal_class_of_tapered_bore="CC",
    # two rows side by side bear hardly any; no figure at hand
    usual_misalignment=None,
    usual_misalignment_of_wide=None,
)
