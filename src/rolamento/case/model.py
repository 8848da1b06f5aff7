"""Which of the rival models to use, and which effects to leave out."""

from typing import Annotated, Any, Final, Literal, Self

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from rolamento.case.quantity import Count, Quantity
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["CageKind", "Mesh", "Model", "RacewayControl", "RollerContact", "Traction"]

RacewayControl = Literal["outer", "inner", "jones", "none", "friction"]
CageKind = Literal["loose", "rigid", "none"]
Mesh = Literal["coarse", "fine"]
Traction = Literal["coulomb", "film"]
RollerContact = Literal["slices", "coupled"]
MOST_COUPLED: Final = 301
"""The time that coupled slices take grows with the third power of their number."""
_OF_ROLLERS: Final = ("roller_contact", "slices")


class Model(Record):
    """Choices of the physical model.

    Parameters
    ----------
    raceway_control
        Which race the ball rolls on without spin: ``"outer"``; ``"inner"``;
        ``"jones"``, where Jones's criterion decides ball by ball; ``"none"``, where
        both races share the gyroscopic moment; ``"friction"``, where nothing is assumed
        and the friction at both contacts decides (it takes the friction coefficient of
        the case's lubricant).
    cage
        What drives a ball that the inner ring does not hold: ``"loose"``, pockets with play: a
        ball that the inner ring presses on has an orbit of its own, and the cage, with the mean of
        those, takes the others along; ``"rigid"``, pockets without play: all balls orbit with the
        cage; ``"none"``: raceway control alone, even where the inner ring does not touch the ball.
        Under friction control the cage is rigid.
    centrifugal_force
        Whether the balls feel their centrifugal force.
    gyroscopic_moment
        Whether the balls feel their gyroscopic moment.

    cage_drag
        Under friction control, the torque that holds the cage back, in N·m.
    mesh
        Under friction control, how finely the contact ellipse is divided: ``"fine"`` or
        ``"coarse"``, up to twice as fast and good to some 2 % in how the balls turn.

    traction
        Under friction control, what resists slip: ``"coulomb"``, friction that does not depend on
        the speed of slip; ``"film"``, the shear of the lubricant film, limited by the same
        coefficient.
    film_in_contact
        Under friction control, whether the thickness of the film enters the geometry: it
        presses ball and groove further in.

    roller_contact
        How a roller's line of contact carries: ``"slices"``, each by itself, as in ISO/TS 16281;
        ``"coupled"``, as parts of one elastic half-space, which finds the peaks at the edges.
    slices
        Into how many slices a roller is divided; odd, 5 to 1001, coupled to 301. Lives of rollers
        depend on it, and are compared at the same number only.

    Raises
    ------
    InputError
        If a choice is not known.
    """

    raceway_control: RacewayControl = Field("outer", examples=["outer"])
    cage: CageKind = Field("loose", examples=["rigid"])
    centrifugal_force: bool = Field(True, strict=True, examples=[True])
    gyroscopic_moment: bool = Field(True, strict=True, examples=[True])
    cage_drag: Annotated[
        float, Quantity("moment", at_least="0 N m", at_most="1e6 N m", varies=True)
    ] = Field(0.0, examples=["5 N mm"])
    mesh: Mesh = Field("fine", examples=["fine"])
    traction: Traction = Field("coulomb", examples=["film"])
    film_in_contact: bool = Field(False, strict=True, examples=[True])
    roller_contact: RollerContact = Field("slices", examples=["coupled"])
    slices: Annotated[int, Field(strict=True, ge=5, le=1001), Count] = Field(35, examples=[35])

    @model_validator(mode="after")
    def _slices_in_reason(self) -> Self:
        if self.slices % 2 == 0:
            raise InputError(
                said("must be odd: one slice stands in the middle of the roller"),
                field="slices",
                value=self.slices,
                example="slices = 35",
            )
        if self.roller_contact == "coupled" and self.slices > MOST_COUPLED:
            raise InputError(
                said('must be at most {most} with roller_contact = "coupled"', most=MOST_COUPLED),
                field="slices",
                value=self.slices,
                example="slices = 101",
            )
        return self

    @model_serializer(mode="wrap")
    def _without_what_balls_lack(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Write what is of rollers only where it is given."""
        fields: dict[str, Any] = handler(self)
        unsaid = {name for name in _OF_ROLLERS if name not in self.model_fields_set}
        return {name: value for name, value in fields.items() if name not in unsaid}

    @property
    def film_field(self) -> str | None:
        """The field that has the film take part in the balance of the balls; None of none."""
        if self.traction == "film":
            return "model.traction"
        return "model.film_in_contact" if self.film_in_contact else None
