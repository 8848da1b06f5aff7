"""The layout of the solver's arrays: what stands in which row.

A case is a column of `COLUMN` numbers in SI units (and from `LONG` on more, where the stiffness
needs longer polynomials), of which the vector kernels read `PARAMETERS`. The first `DUTY` of them
are its own; the others are the bearing's, and stand once for all cases of one bearing. Ring
rotations and moments are carried as arm times angle (m) and moment over arm (N), with the arm R_i
of the inner groove's centres, so that the ring's equations have one unit. The vector kernels work
on `LANES` cases at a time: a row is a run of `LANES` numbers, and `lanes(row)` says where it
starts.
"""

from __future__ import annotations

from typing import Final

import numpy as np

LANES: Final = 16
COEFFICIENTS: Final = 7
DEGREES_OF_FREEDOM: Final = 5
SHIFTS: Final = 3  # of those, before the tilts

# --- a case: its duty -------------------------------------------------------------------------
APPLIED: Final = 0  # five loads: fx, fy, fz, my / R_i, mz / R_i
IMPOSED: Final = 5  # five displacements: x, y, z, ry R_i, rz R_i
FREE: Final = 10  # five flags: 1 where the load is given, 0 where the displacement is
INNER_SPEED: Final = 15  # from here on what a row needs that is held by others
OUTER_SPEED: Final = 16
COS_FIRST: Final = 17  # azimuth of the first ball
SIN_FIRST: Final = 18
NOMINAL_ORBIT: Final = 19  # the cage's speed where no ball drives it
CAGE_WEIGHT: Final = 20  # load by which the cage keeps to that
HOLD_RATE: Final = 21  # the inner ring holds a ball by the grip Q_i rate + offset, between 0 and 1
INERTIA_APPROACH: Final = 22  # approach of both contacts under F_c of the nominal orbit alone
DUTY: Final = 23
# --- its bearing, and how that is modelled ----------------------------------------------------
OUTER_LENGTH: Final = DUTY  # L_o = (f_o - 1/2) D
INNER_LENGTH: Final = DUTY + 1  # L_i
AXIAL_OFFSET: Final = DUTY + 2  # A1 of the unloaded bearing
RADIAL_OFFSET: Final = DUTY + 3  # A2
GAMMA: Final = DUTY + 4  # gamma' = D / d_m
CENTRIFUGAL: Final = DUTY + 5  # m d_m / 2, or 0 where switched off
GYROSCOPIC: Final = DUTY + 6  # m d_m / 10, or 0
FRICTION_ARM: Final = DUTY + 7  # f_i D / R_i
LAMBDA_INNER: Final = DUTY + 8  # the inner race's part of the gyroscopic moment, outer control
ARM: Final = DUTY + 9  # R_i
ONE_SIDED: Final = DUTY + 10  # 1 where only contact angles above zero are supported
BALL_DIAMETER: Final = DUTY + 11
HOLD_OFFSET: Final = DUTY + 12  # see HOLD_RATE
OWN_ORBIT: Final = DUTY + 13  # 1 where a ball that is held has its own orbit, 0 in a rigid cage
INNER_EDGE: Final = DUTY + 14  # cosine of the angle at which a groove ends at its shoulder
OUTER_EDGE: Final = DUTY + 15
OUTER_SHARE: Final = DUTY + 16  # of the outer contact in the approach of both
OUTER_STIFFNESS: Final = DUTY + 17  # seven coefficients of K_o in cos a
INNER_STIFFNESS: Final = OUTER_STIFFNESS + COEFFICIENTS
SERIES_STIFFNESS: Final = INNER_STIFFNESS + COEFFICIENTS  # of both contacts in series at one angle
TERMS: Final = SERIES_STIFFNESS + COEFFICIENTS  # that K takes: COEFFICIENTS, or more from LONG on
PARAMETERS: Final = TERMS + 1
MODULUS: Final = PARAMETERS  # E', which the kernels do not read: the contacts' ellipses need it
COLUMN: Final = PARAMETERS + 1  # the whole column of a case
LONG: Final = COLUMN  # where seven do not do: K_o, K_i and both in series again, longer
MOST_TERMS: Final = 28

# --- the ring's workspace: the case's parameters, then ----------------------------------------
DISPLACEMENT: Final = PARAMETERS
CAGE: Final = DISPLACEMENT + 5  # its speed
STEP: Final = CAGE + 1
CAGE_STEP: Final = STEP + 5
REACTION: Final = CAGE_STEP + 1  # the balls' forces on the ring
MATRIX: Final = REACTION + 5  # their derivatives by the ring's displacement, 5 x 5
BY_CAGE: Final = MATRIX + 25  # and by the cage's speed
LAG: Final = BY_CAGE + 5  # what the cage is behind its drive: sum of Q_i (ω_own - ω)
LAG_BY_RING: Final = LAG + 1  # its derivatives by the ring's displacement
LAG_BY_CAGE: Final = LAG_BY_RING + 5
FAULT: Final = LAG_BY_CAGE + 1  # greatest residual of a ball beyond what is allowed
NOW: Final = FAULT + 1  # the balls' forces on the ring before any step
LAG_NOW: Final = NOW + 5
PULL: Final = LAG_NOW + 1  # sum of h Q_i
HEAVIEST: Final = PULL + 1  # greatest scale of a ball's own loads
UNSOUND: Final = HEAVIEST + 1  # above zero where a ball stands or bears as none can
REGROUPED: Final = UNSOUND + 1  # above zero where a ball leaves the inner groove or comes back
DOUBTFUL: Final = REGROUPED + 1  # above zero where a ball's residual is worse than the ring's
ASTRAY: Final = DOUBTFUL + 1  # above zero where a ball has left the place where it can be
PRESSED: Final = ASTRAY + 1  # sum of Q_i
SUMS: Final = PRESSED + 1 - REACTION  # all of these, over the balls
UNBALANCED: Final = REACTION + SUMS  # the ring's greatest unbalanced load, over its loads
LOADED: Final = UNBALANCED + 1  # the greatest of its loads
BEHIND: Final = LOADED + 1  # what the cage is behind its drive, over the rings' speeds
STEPS: Final = BEHIND + 1  # taken
CAUTION: Final = STEPS + 1  # 1 where the cage and late steps are held back, 0 where nothing is
SETTLED: Final = CAUTION + 1  # above zero where all is at rest, NaN where it is lost
RING_ROWS: Final = SETTLED + 1

# --- a ball's workspace -----------------------------------------------------------------------
COS: Final = 0
SIN: Final = 1
SIGMA: Final = 2  # +1 outer race control, -1 inner
POSITION: Final = 3  # X1, X2
FOLLOW: Final = 5  # dX = q + W dA + z dω; once it is taken, X before it in the first two
ERROR: Final = FOLLOW  # where nothing follows, as it is judged: size of its residual
SCALE: Final = FOLLOW + 1  # and the greatest of its own loads
OFF: Final = FOLLOW + 8  # 0 on the inner groove, far where the ball is off it and nothing presses
LOST_WAY: Final = OFF + 1  # above zero where it has left the place where it can be
BALL_ROWS: Final = LOST_WAY + 1
# of one that is settled by itself (`abreast`):
KEPT: Final = BALL_ROWS  # its place so far, X1, X2
ONWARD: Final = KEPT + 2  # Newton's step from there
MISS: Final = ONWARD + 2  # the residual there
PART: Final = MISS + 1  # of the step that is tried
TRIED: Final = PART + 1  # how often it was shortened
TAKEN: Final = TRIED + 1  # steps
FATE: Final = TAKEN + 1  # whether it has settled
SETTLING_ROWS: Final = FATE + 1
# --- how a ball touches (`ball.touching`) ------------------------------------------------------
INNER_CONTACT: Final = 0  # sin a, cos a, da/dt, approach, Q, dQ/d|y|, dQ/da
OUTER_CONTACT: Final = INNER_CONTACT + 7
OWN_SPEED: Final = OUTER_CONTACT + 7  # of its own orbit, and its derivatives by a_i, a_o
TOUCH_ROWS: Final = OWN_SPEED + 3


def long_polynomial(row: int) -> int:
    """Where the longer form of a polynomial begins, by the row of the short one."""
    return LONG + (row - OUTER_STIFFNESS) // COEFFICIENTS * MOST_TERMS


def lanes(row: int) -> np.uintp:
    """Start of a row in a lane workspace; unsigned, so that no index can wrap around."""
    return np.uintp(row * LANES)
