"""Where each number of a row of rollers stands in a column of parameters; SI.

A roller is seen in its own plane (x, r). It moves by η along f⊥, across the direction f of the
rib, and turns by ω, both over the inner ring; docs/theory/rollers.md, equations (4) to (7).
"""

from __future__ import annotations

from typing import Final

ARM: Final = 0
"""Half of the pitch diameter, at the roller's middle."""
DIAMETER: Final = 1
LENGTH: Final = 2
"""Effective length of the contacts."""
OUTER_SINE: Final = 3
OUTER_COSINE: Final = 4
LEVER: Final = 5
"""R sin φ: of a contact's normal about the roller's centre, at the middle of the contact."""
INNER_SHIFT: Final = 6
"""Approach of the inner contact's middle for η = 1."""
INNER_TURN: Final = 7
"""The same for ω = 1."""
OUTER_SHIFT: Final = 8
OUTER_TURN: Final = 9
INNER_CONSTANT: Final = 10
"""K of a whole contact in Q = K δ^(10/9)."""
OUTER_CONSTANT: Final = 11
GAP: Final = 12
"""Gap of each contact without load: a quarter of the diametral clearance."""
CENTRIFUGAL: Final = 13
"""F_c of a roller (N)."""
CENTRIFUGAL_SHIFT: Final = 14
"""How far outward the roller's centre goes for η = 1."""
CENTRIFUGAL_TURN: Final = 15
MOMENT: Final = 16
"""Moment of a roller's inertia about its middle, as θ turns (N·m)."""
RIB_AHEAD: Final = 17
"""Stiffness of the pair of ribs that carries load toward +x (N/m); 0 without such ribs."""
RIB_BEHIND: Final = 18
RIB_LEVER: Final = 19
"""From the roller's axis to the middle of its contact with a rib."""
RIB_PLAY: Final = 20
"""Half of the axial play between the ribs."""
COS_FIRST: Final = 21
SIN_FIRST: Final = 22
COMPLIANCE: Final = 23
"""2/(π E′), of coupled slices (1/Pa)."""
PARAMETERS: Final = 24

FREE: Final = 24
"""Whether the load is given on a degree of freedom of the ring, else its place: five rows each."""
APPLIED: Final = 29
IMPOSED: Final = 34
COLUMN: Final = 39
