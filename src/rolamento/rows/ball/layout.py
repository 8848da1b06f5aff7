"""The layout of the solver's arrays: what stands in which row.

A case is a column of `COLUMN` numbers in SI units (and from `LONG` on more, where the stiffness
needs longer polynomials), of which the vector kernels read `PARAMETERS`. Ring
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

# --- a case -----------------------------------------------------------------------------------
OUTER_LENGTH: Final = 0  # L_o = (f_o - 1/2) D
INNER_LENGTH: Final = 1  # L_i
AXIAL_OFFSET: Final = 2  # A1 of the unloaded bearing
RADIAL_OFFSET: Final = 3  # A2
GAMMA: Final = 4  # gamma' = D / d_m
CENTRIFUGAL: Final = 5  # m d_m / 2, or 0 where switched off
GYROSCOPIC: Final = 6  # m d_m / 10, or 0
INNER_SPEED: Final = 7
OUTER_SPEED: Final = 8
FRICTION_ARM: Final = 9  # f_i D / R_i
LAMBDA_INNER: Final = 10  # the inner race's part of the gyroscopic moment under outer control
COS_FIRST: Final = 11  # azimuth of the first ball
SIN_FIRST: Final = 12
ARM: Final = 13  # R_i
ONE_SIDED: Final = 14  # 1 where only contact angles above zero are supported
BALL_DIAMETER: Final = 15
OUTER_STIFFNESS: Final = 16  # seven coefficients of K_o in cos a
INNER_STIFFNESS: Final = 23
SERIES_STIFFNESS: Final = 30  # of both contacts in series at one angle
APPLIED: Final = 37  # five loads: fx, fy, fz, my / R_i, mz / R_i
IMPOSED: Final = 42  # five displacements: x, y, z, ry R_i, rz R_i
FREE: Final = 47  # five flags: 1 where the load is given, 0 where the displacement is
HOLD_RATE: Final = 52  # the inner ring holds a ball by the grip Q_i rate + offset, between 0 and 1
HOLD_OFFSET: Final = 53
OWN_ORBIT: Final = 54  # 1 where a ball that is held has an orbit of its own, 0 in a rigid cage
CAGE_WEIGHT: Final = 55  # load by which the cage keeps to the nominal speed
NOMINAL_ORBIT: Final = 56  # its speed where no ball drives it
INNER_EDGE: Final = 57  # cosine of the angle at which a groove ends at its shoulder
OUTER_EDGE: Final = 58
OUTER_SHARE: Final = 59  # of the outer contact in the approach of both
INERTIA_APPROACH: Final = 60  # approach of both contacts under F_c of the nominal orbit alone
PARAMETERS: Final = 61
TERMS: Final = 61  # coefficients that K takes: COEFFICIENTS, or more from LONG on
MODULUS: Final = 62  # E', which the kernels do not read: the contacts' ellipses need it
COLUMN: Final = 63  # the whole column of a case
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
SUMS: Final = ASTRAY + 1 - REACTION  # all of these, over the balls
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


def long_polynomial(row: int) -> int:
    """Where the longer form of a polynomial begins, by the row of the short one."""
    return LONG + (row - OUTER_STIFFNESS) // COEFFICIENTS * MOST_TERMS


def lanes(row: int) -> np.uintp:
    """Start of a row in a lane workspace; unsigned, so that no index can wrap around."""
    return np.uintp(row * LANES)
