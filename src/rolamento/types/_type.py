"""What there is to know of a type of bearing, beside its tables of figures."""

from __future__ import annotations

import re
from typing import Final, Literal

from rolamento.ratings import RatedType, RollerRated
from rolamento.records import frozen
from rolamento.words import marked

BALL: Final = "ball"
ROLLER: Final = "roller"
BARREL: Final = "barrel"
ClearanceName = Literal["CN", "CC"]
"""Normal classes: of ISO 5753-1, and of rings that are not interchangeable (JIS B 1520)."""
Ribs = Literal["none", "+", "-", "both"]
"""At which ends of the rollers a ring has a rib: toward +x, toward -x, or both."""
OF_RIBS: Final = ("inner_ribs", "outer_ribs", "axial_play", "rib_height")
"""Fields that change nothing of rollers without ribs."""
OF_BALLS: Final = ("past_edge", "shoulders", "control", "orbits", "gyroscopic_slip", "rolling")
"""Notes on balls in plain grooves."""


@frozen(kw_only=True)
class BearingType:
    """A type of bearing.

    Attributes
    ----------
    key
        What catalogues and data files call it.
    name
        Within a sentence: "tapered roller bearing"; to be translated.
    called
        Words that catalogues have for it, in several languages.
    untitled
        What a case without a title is called, by what rolls in it; to be translated.
    element
        What rolls in it, as a case file has it.
    rolling
        What its element is called; to be translated.
    grooves
        ``kind`` of a bearing's record that is of such rings; None of plain ones.
    adjective
        What its kind is called, to be translated; empty without.
    row
        Module and function that make a row of many cases.
    rated
        By which formula of the standards: a `RatedType` or `RollerRated` of `rolamento.ratings`.
    in_pairs
        Whether a contact angle is what it is chosen by: angular-contact bearings, set side by side.
    rows
        Rows of rolling elements of such a bearing in a catalogue.
    rated_together
        Whether its rows have one rating.
    has_arches
        Whether a ball touches each ring on two arcs.
    conical
        Whether its rollers are cones: their angle takes the place of a clearance, they carry axial
        load one way, and lean on a rib at their large end.
    inclined
        Whether its rollers, which are no cones, stand at a contact angle.
    floats
        Whether it lets the shaft shift, but for its ribs.
    aligns
        Whether a race is a sphere, so that no ring holds a moment.
    washers
        Whether it is made for axial load: two washers face to face.
    with_cage_only
        Whether its elements are balanced as they orbit with the cage, without a criterion that
        chooses a race.
    mountable
        Whether what fits do to its play is known.
    conformity
        Of its grooves, where none is published; None for what ISO 281 supposes.
    clearance_table
        Of ISO 5753-1 for what `rolamento.clearance` takes: empty of deep-groove bearings; None
        where no class is taken.
    class_table
        From which the clearance of a designation is taken; None of one that has no class.
    class_table_of_tapered_bore
        The same of a tapered bore, where it has classes of its own.
    normal_class_of_tapered_bore
        What the class of that table is called that stands for the normal one.
    usual_letters, as_a_cage
        What stands before the number of one whose designation does not say; whether it may be a
        cage with its needles alone.
    axial_limit_of_maker
        Whether makers list e, Y and Y_0 of each.
    idle_fields
        Fields of its case file that change nothing.
    carries_axial
        Whether a first case of such a bearing has an axial load.
    usual_misalignment, usual_misalignment_of_wide
        Tilt of the rings that makers let pass under normal loads, of wide ones; rad, None where no
        source gives one.
    ribbed
        Whether makers have a permissible load of its ribs.
    described
        Sentence on its elements: count, diameter, length and pitch; to be translated, of rollers.
    notes
        Checks of `rolamento.solved.notes` on rows that are all of such types.
    """

    key: str
    name: str
    untitled: str
    called: str = ""
    element: str = BALL
    rolling: str = marked("ball")
    grooves: str | None = None
    adjective: str = ""
    row: str = "rolamento.rows.ball.row:ball_row"
    rated: RatedType | RollerRated = "radial"
    in_pairs: bool = False
    rows: int = 1
    rated_together: bool = False
    has_arches: bool = False
    conical: bool = False
    inclined: bool = False
    floats: bool = False
    aligns: bool = False
    washers: bool = False
    with_cage_only: bool = False
    mountable: bool = True
    conformity: float | None = None
    clearance_table: str | None = None
    class_table: str | None = None
    class_table_of_tapered_bore: str | None = None
    normal_class_of_tapered_bore: ClearanceName = "CN"
    usual_letters: str = ""
    as_a_cage: bool = False
    axial_limit_of_maker: bool = False
    idle_fields: tuple[str, ...] = ()
    carries_axial: bool = False
    usual_misalignment: float | None = None
    usual_misalignment_of_wide: float | None = None
    ribbed: bool = False
    described: str = ""
    notes: tuple[str, ...] = ()

    def misalignment_of(self, designation: str | None) -> float | None:
        """Return the tilt that makers let pass; the lesser one if the width is not known.

        Wide are the width series from 2 on: "NU 2210", but not "NU 210" or "NU 1010".
        """
        if self.usual_misalignment_of_wide is None:
            return self.usual_misalignment
        number = re.search(r"\d{3,}", designation or "")
        narrow = number is not None and (len(number[0]) == 3 or number[0][0] in "01")
        return self.usual_misalignment if narrow else self.usual_misalignment_of_wide

    @property
    def rolls(self) -> str:
        """``"ball"`` or ``"roller"``."""
        return BALL if self.element == BALL else ROLLER

    @property
    def is_double_row(self) -> bool:
        """Whether it is two plain rows in one bearing, as a pair of single ones side by side."""
        return self.rows > 1 and not self.aligns

    @property
    def barrels(self) -> bool:
        """Whether its rollers are barrels, whose races are arcs too."""
        return self.element == BARREL

    @property
    def straight(self) -> bool:
        """Whether its rollers are cylinders, of standard sizes between printed raceways."""
        return self.has_rollers and not self.conical and not self.barrels

    @property
    def crowned_whole(self) -> bool:
        """Whether its rollers have the standard's profile of tapered and thrust bearings."""
        return self.conical or self.washers

    @property
    def has_rollers(self) -> bool:
        """Whether rollers roll in it."""
        return self.element != BALL
