"""Friction of ball bearings: slip inside the contacts, torque, power and heat.

From the inside out: `slip` (velocity at every point of a contact), `ellipse_mesh` and `traction`
(integrals of friction), `minimum_power` (how a ball moves where friction alone decides); a file a
model: `jones_full`, `jones_control`, `jones_simplified`, `harris_1971`, `todd` for dry and
boundary friction at low speed, `hysteresis`, `rolling_resistance`, and `palmgren`, `skf` for
lubricated machine bearings; `regime` (which of them holds) and `summary` (all of it).
"""

from rolamento.friction.loaded_balls import LoadedBalls, loaded_balls
from rolamento.friction.machine import MachineBearing
from rolamento.friction.regime import ModelVerdict
from rolamento.friction.summary import Friction, friction
from rolamento.friction.torque import ContactLoss, Torque

__all__ = [
    "ContactLoss",
    "Friction",
    "LoadedBalls",
    "MachineBearing",
    "ModelVerdict",
    "Torque",
    "friction",
    "loaded_balls",
]
