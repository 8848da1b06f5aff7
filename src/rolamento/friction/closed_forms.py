"""Spin and rolling slip in closed form, contact by contact, for the models that add them."""

from __future__ import annotations

import numpy as np

from rolamento.friction.heathcote import rolling_moment
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.spin import spin_moment
from rolamento.friction.torque import ContactLoss
from rolamento.kinematics import BallMotion
from rolamento.numerics import BoolArray, FloatArray


def spin_loss(balls: LoadedBalls, motion: BallMotion, mu: FloatArray) -> ContactLoss:
    """Loss by spin of every contact at a unit relative speed of the rings; N·m."""
    return _where_loaded(
        balls,
        spin_moment(balls.inner, mu) * np.abs(motion.inner_spin),
        spin_moment(balls.outer, mu) * np.abs(motion.outer_spin),
    )


def rolling_slip_loss(
    balls: LoadedBalls,
    motion: BallMotion,
    mu: FloatArray,
    *,
    at_inner: BoolArray | bool = True,
    at_outer: BoolArray | bool = True,
) -> ContactLoss:
    """Loss by Heathcote slip, likewise; at_inner, at_outer: at which contacts it is counted."""
    return _where_loaded(
        balls,
        np.where(at_inner, rolling_moment(balls.inner, mu) * np.abs(motion.inner_roll), 0.0),
        np.where(at_outer, rolling_moment(balls.outer, mu) * np.abs(motion.outer_roll), 0.0),
    )


def _where_loaded(balls: LoadedBalls, inner: FloatArray, outer: FloatArray) -> ContactLoss:
    loaded = balls.loaded
    return ContactLoss(np.where(loaded, inner, 0.0), np.where(loaded, outer, 0.0))
