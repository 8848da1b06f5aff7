"""The equations that a result rests on: what each gives, its symbols, its source, where it holds.

A report shows those whose model was used, numbered in its own order, each symbol where it first
occurs; and the works that they come from.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Final, Literal

from rolamento.case.roller_bearing import RollerBearing
from rolamento.document import Equation, Symbol
from rolamento.records import frozen
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.tasks.report import CaseReport

__all__ = ["EQUATIONS", "REFERENCES", "Law", "equations_of", "references_of"]

Used = Callable[["CaseReport"], bool]


@frozen(kw_only=True)
class Law:
    """An equation as the program computes it.

    Attributes
    ----------
    key
        stable, for programs
    name
        what it gives; English
    latex, plain
        in mathematics, which Matplotlib sets too, and in plain characters
    symbols
        keys of `SYMBOLS`
    source
        place in the works of `references`
    references
        keys of `REFERENCES`
    used
        whether a case rests on it
    valid
        where it holds; English
    rolls
        of which elements: "ball", "roller"; empty for both
    """

    key: str
    name: str
    latex: str
    plain: str
    symbols: tuple[str, ...] = ()
    source: str = ""
    references: tuple[str, ...] = ()
    used: Used = lambda case: True
    valid: str = ""
    rolls: Literal["", "ball", "roller"] = ""

    def of(self, case: CaseReport) -> bool:
        """Whether a case rests on it."""
        return (not self.rolls or self.rolls in _rolls(case)) and self.used(case)


# --- when an equation is used ---------------------------------------------------------------------


def _rolls(case: CaseReport) -> set[str]:
    elements = {place.bearing.element for place in case.case.bearing.places}
    return {"ball" if element == "ball" else "roller" for element in elements}


def _element(name: str) -> Used:
    return lambda case: any(place.bearing.element == name for place in case.case.bearing.places)


def _line_contact(name: str) -> Used:
    return lambda case: case.case.model.roller_contact == name


def _iso_profile(case: CaseReport) -> bool:
    bearings = [place.bearing for place in case.case.bearing.places]
    return any(
        isinstance(one, RollerBearing) and one.roller_profile.kind == "iso" for one in bearings
    )


def _line_film(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        own = case.case.film
        return _film(case) and ("pan_hamrock" if own is None else own.line or "pan_hamrock") == name

    return used


def _turns(case: CaseReport) -> bool:
    return case.case.duty.inner_speed != 0.0 or case.case.duty.outer_speed != 0.0


def _by_friction(case: CaseReport) -> bool:
    return case.analysis.solved.rolling is not None


def _controlled(case: CaseReport) -> bool:
    return _turns(case) and not _by_friction(case)


def _cage(case: CaseReport) -> bool:
    return _controlled(case) and case.case.model.cage != "none"


def _centrifugal(case: CaseReport) -> bool:
    return _turns(case) and case.case.model.centrifugal_force


def _gyroscopic(case: CaseReport) -> bool:
    return _turns(case) and case.case.model.gyroscopic_moment


def _step(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        found = case.clearance
        return found is not None and any(step.name == name for step in found.steps)

    return used


def _fits(case: CaseReport) -> bool:
    return _step("shaft_fit")(case) or _step("housing_fit")(case)


def _film(case: CaseReport) -> bool:
    film = case.analysis.film
    return film is not None and film.thinnest("inner") is not None


def _thermal(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        own = case.case.film
        return _film(case) and ("murch_wilson" if own is None else own.thermal) == name

    return used


def _starved(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        own = case.case.film
        return _film(case) and own is not None and own.starvation == name

    return used


def _alpha(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        lubricant = case.case.lubricant
        if not _film(case) or lubricant is None:
            return False
        oil = lubricant.oil
        method = oil.pressure_viscosity_method or "wooster"
        return oil.pressure_viscosity is None and method == name

    return used


def _roughness(case: CaseReport) -> bool:
    return _film(case) and case.case.surface is not None


def _theory(*names: str) -> Used:
    def used(case: CaseReport) -> bool:
        life = case.analysis.life
        return life is not None and any(name in life.theories for name in names)

    return used


def _life(case: CaseReport) -> bool:
    return case.analysis.life is not None


def _rating(name: str, source: str) -> Used:
    def used(case: CaseReport) -> bool:
        life = case.analysis.life
        return life is not None and life.rating_sources[name] == source

    return used


def _radial(used: Used) -> Used:
    """Equations of bearings that are rated for radial load."""
    return lambda case: used(case) and not _is_axial(case)


def _axial(used: Used) -> Used:
    """Equations of thrust bearings."""
    return lambda case: used(case) and _is_axial(case)


def _is_axial(case: CaseReport) -> bool:
    life = case.analysis.life
    return life is not None and life.ratings.is_axial


def _edition(year: str) -> Used:
    def used(case: CaseReport) -> bool:
        life = case.analysis.life
        return life is not None and life.conditions.edition == year

    return used


def _ratio_of_oil(case: CaseReport) -> bool:
    life = case.analysis.life
    of_life = life is not None and life.conditions.viscosity is not None
    return of_life or _film(case)


def _classes(case: CaseReport) -> bool:
    life = case.analysis.life
    return (
        life is not None
        and hasattr(life.conditions.contamination, "c1")
        and (life.viscosity_ratio is not None)
    )


def _loss(name: str) -> Used:
    def used(case: CaseReport) -> bool:
        friction = case.analysis.friction
        return friction is not None and name in friction.torque_by_source

    return used


def _by_regime(case: CaseReport) -> bool:
    friction = case.analysis.friction
    return friction is not None and friction.by_regime


def _torque_model(*names: str) -> Used:
    def used(case: CaseReport) -> bool:
        friction = case.analysis.friction
        return friction is not None and any(own.model in names for own in friction.judged)

    return used


def _both(one: Used, other: Used) -> Used:
    return lambda case: one(case) and other(case)


def _frequencies(case: CaseReport) -> bool:
    return case.analysis.frequencies is not None


# --- symbols --------------------------------------------------------------------------------------

SYMBOLS: Final[Mapping[str, tuple[str, str, str]]] = {
    "D": ("D", marked("ball diameter"), "m"),
    "d_m": ("d_m", marked("pitch diameter"), "m"),
    "Z": ("Z", marked("number of balls in a row"), ""),
    "alpha": ("α", marked("contact angle under load"), "rad"),
    "alpha_0": ("α_0", marked("free contact angle"), "rad"),
    "f": ("f_i, f_o", marked("conformity of the inner and outer race: groove radius over D"), ""),
    "P_d": ("P_d", marked("diametral clearance"), "m"),
    "gamma": ("γ", marked("D cos α / d_m"), ""),
    "E_nu": ("E, ν", marked("Young's modulus and Poisson's ratio of ball and ring"), "Pa, –"),
    "E_prime": ("E'", marked("effective modulus"), "Pa"),
    "rho": ("ρ_x, ρ_y", marked("sum of curvatures along and across rolling"), "1/m"),
    "k": ("k", marked("ellipticity a/b"), ""),
    "ab": ("a, b", marked("semi-axes of the contact ellipse, across and along rolling"), "m"),
    "KE": ("K(m), E(m)", marked("complete elliptic integrals, m = 1 − 1/k²"), ""),
    "Q": ("Q", marked("contact load"), "N"),
    "delta": ("δ", marked("elastic approach"), "m"),
    "delta_star": ("δ*", marked("dimensionless approach, a function of k"), ""),
    "p_0": ("p_0", marked("maximum Hertz pressure"), "Pa"),
    "tau_max": ("τ_max", marked("maximum shear stress below the centre of the contact"), "Pa"),
    "tau_0": ("τ_0, z_0", marked("amplitude and depth of the orthogonal shear"), "Pa, m"),
    "omega": ("ω_i, ω_o", marked("speeds of the rings"), "rad/s"),
    "omega_m": ("ω_m", marked("orbital speed of a ball"), "rad/s"),
    "omega_R": ("ω_R, β", marked("speed of a ball about its own axis, and its attitude"),
                "rad/s, rad"),
    "slave": ("c, s", marked("controlling race and the other race; σ = +1 for outer control, −1 "
                             "for inner control"), ""),
    "cage": ("ω_cage, h", marked("cage speed, and degree of contact of a ball with the inner ring "
                                 "(0 to 1)"), "rad/s, –"),
    "mass": ("m, J", marked("mass of a ball and its moment of inertia m D²/10"), "kg, kg·m²"),
    "F_c": ("F_c", marked("centrifugal force"), "N"),
    "M_g": ("M_g", marked("gyroscopic moment"), "N·m"),
    "lambda_i": ("λ_i, λ_o", marked("share of the gyroscopic moment at each race; their sum is 2"),
                 ""),
    "psi": ("ψ", marked("azimuth of a ball"), "rad"),
    "loads": ("F_x … M_z", marked("load applied by the shaft to the inner ring"), "N, N·m"),
    "R_i": ("R_i", marked("radius of the circle of the inner groove centres"), "m"),
    "u": ("u", marked("displacement of the inner ring: x, y, z, r_y, r_z"), "m, rad"),
    "C": ("C, C_0, C_u", marked("dynamic and static load rating, fatigue load limit"), "N"),
    "f_c": ("b_m, f_c, f_0", marked("factors of the standards"), ""),
    "rows": ("i", marked("number of rows"), ""),
    "P": ("P, P_0", marked("dynamic and static equivalent load"), "N"),
    "F_ra": ("F_r, F_a", marked("radial and axial load"), "N"),
    "XY": ("X, Y, X_0, Y_0", marked("load factors of the standards"), ""),
    "S_0": ("S_0", marked("static safety factor"), ""),
    "L_10": ("L_10", marked("basic rating life"), "10⁶ rev"),
    "n": ("n", marked("relative speed of the rings"), "rpm"),
    "S": ("S", marked("reliability"), ""),
    "a_1": ("a_1", marked("life modification factor for reliability"), ""),
    "a_ISO": ("a_ISO", marked("life modification factor of ISO 281"), ""),
    "e_C": ("e_C", marked("contamination factor"), ""),
    "kappa": ("κ", marked("viscosity ratio"), ""),
    "nu": ("ν, ν_1", marked("kinematic viscosity in operation, and the one required"), "mm²/s"),
    "L_10r": ("L_10r", marked("basic reference rating life"), "10⁶ rev"),
    "Q_c": ("Q_c, Q_e", marked("dynamic load rating and equivalent load of a race"), "N"),
    "tau_u": ("τ, τ_u", marked("amplitude of the shear stress, and its fatigue limit"), "Pa"),
    "UWG": ("U, W, G", marked("speed, load and material parameters"), ""),
    "H": ("H_c, H_0", marked("central and minimum film thickness over R_x"), ""),
    "R_x": ("R_x", marked("effective radius along rolling"), "m"),
    "eta": ("η, u", marked("dynamic viscosity at the inlet, and entrainment speed"), "Pa·s, m/s"),
    "alpha_p": ("α_p", marked("pressure-viscosity coefficient"), "1/Pa"),
    "L_T": ("L, φ_T", marked("thermal loading parameter, and the share of the film that remains"),
            ""),
    "lambda": ("λ", marked("film parameter"), ""),
    "R_q": ("R_q", marked("root mean square roughness of race and ball"), "m"),
    "mu": ("μ", marked("coefficient of friction"), ""),
    "alpha_h": ("α_h", marked("hysteresis loss: share of the elastic work"), ""),
    "delta_fit": ("δ, p", marked("effective interference and contact pressure of a fit"), "m, Pa"),
    "T": ("T", marked("temperature; of rings and balls, above that of assembly"), "K"),
    "order": ("f_c, f_o, f_i, f_b", marked("frequencies of cage, outer race, inner race and ball"),
              "Hz"),
    "L_we": ("L_we, x", marked("effective length of a roller, and place from its middle"), "m"),
    "D_we": ("D_we, d_pw", marked("roller diameter and pitch diameter, at the roller's middle"),
             "m"),
    "phi": ("φ, β", marked("half angle of a tapered roller, and angle of its axis"), "rad"),
    "q": ("q, n_s", marked("load per length, or of a slice; number of slices"), "N/m, –"),
    "tilt": ("θ", marked("tilt of the roller against the race"), "rad"),
    "b_line": ("b, R", marked("half-width of a line of contact, and effective radius"), "m"),
    "F_rib": ("F_rib, ε", marked("force of the rib, and its angle to the roller's axis"), "N, rad"),
    "B_image": ("g_j, s, B_j", marked("influence of a slice j slices away; the roller's share of "
                                      "the compliance, and the image at its axis"), ""),
    "f_k": ("f_k", marked("edge factor of a slice"), ""),
    "q_c": ("q_c, q_e", marked("dynamic load rating and equivalent load of a slice"), "N"),
}  # fmt: skip

_OF_ROLLERS: Final[Mapping[str, tuple[str, str, str]]] = {
    "D": ("D_we", marked("roller diameter"), "m"),
    "d_m": ("d_pw", marked("pitch diameter"), "m"),
    "Z": ("Z", marked("number of rollers in a row"), ""),
    "gamma": ("γ", marked("D_we cos α / d_pw"), ""),
    "E_nu": ("E, ν", marked("Young's modulus and Poisson's ratio of roller and ring"), "Pa, –"),
    "omega_m": ("ω_m", marked("orbital speed of a roller"), "rad/s"),
    "mass": ("m", marked("mass of a roller"), "kg"),
    "psi": ("ψ", marked("azimuth of a roller"), "rad"),
    "R_q": ("R_q", marked("root mean square roughness of race and roller"), "m"),
    "order": ("f_c, f_o, f_i, f_b", marked("frequencies of cage, outer race, inner race and "
                                           "roller"), "Hz"),
    "T": ("T", marked("temperature; of rings and rollers, above that of assembly"), "K"),
    "alpha": ("α_i, α_o", marked("contact angle of the inner and outer race"), "rad"),
}  # fmt: skip
"""Symbols that mean something else where nothing but rollers rolls."""


# --- the register ---------------------------------------------------------------------------------

EQUATIONS: Final[tuple[Law, ...]] = (
    Law(
        key="free_angle",
        rolls="ball",
        name=marked("Free contact angle and clearance"),
        latex=r"\cos\alpha_0 = 1 - \frac{P_d}{2\,(f_i + f_o - 1)\,D}",
        plain="cos α_0 = 1 − P_d / (2 (f_i + f_o − 1) D)",
        symbols=("alpha_0", "P_d", "f", "D"),
        source=marked("Harris (1991), chapter 2"),
        references=("harris_1991",),
    ),
    Law(
        key="lame",
        name=marked("Pressure of a press fit: thick-walled cylinders"),
        latex=r"p = \delta \left/ \left\{ \frac{d}{E_o}\left[\frac{1+q^2}{1-q^2}+\nu_o\right]"
        r" + \frac{d}{E_i}\left[\frac{1+k^2}{1-k^2}-\nu_i\right] \right\} \right.",
        plain="p = δ / { (d/E_o) [(1 + q²)/(1 − q²) + ν_o] + (d/E_i) [(1 + k²)/(1 − k²) − ν_i] }",
        symbols=("delta_fit", "E_nu"),
        source=marked("Lamé (1852); Harris (1991), chapter 3"),
        references=("lame_1852", "timoshenko_1970", "harris_1991"),
        used=_fits,
        valid=marked("plane stress, no friction; rings as plain cylinders up to the groove"),
    ),
    Law(
        key="expansion",
        name=marked("Change of clearance by temperature"),
        latex=r"\Delta P_d = \alpha_r T_o d_o - \alpha_r T_i d_i - 2\,\alpha_b T_b D",
        plain="ΔP_d = α_r T_o d_o − α_r T_i d_i − 2 α_b T_b D",
        symbols=("T", "P_d", "D"),
        source=marked("NSK (E1102), chapter 9.2; Harris (1991), chapter 3"),
        references=("nsk_e1102", "harris_1991"),
        used=_step("temperature"),
        valid=marked("uniform temperature of each part, free expansion"),
    ),
    Law(
        key="ring_growth",
        name=marked("Centrifugal expansion of a rotating ring"),
        latex=r"u = \frac{\rho\,\omega^2 r}{8E} \left[(1-\nu)(3+\nu)(a^2+b^2)"
        r" + (1+\nu)(3+\nu)\frac{a^2 b^2}{r^2} - (1-\nu^2)\,r^2\right]",
        plain="u = ρ ω² r/(8E) [(1 − ν)(3 + ν)(a² + b²) + (1 + ν)(3 + ν) a² b²/r² − (1 − ν²) r²]",
        source=marked("Timoshenko and Goodier (1970), section 32"),
        references=("timoshenko_1970",),
        used=_step("speed"),
        valid=marked("rotating annulus of radii a and b, plane stress"),
    ),
    Law(
        key="modulus",
        name=marked("Effective modulus"),
        latex=r"\frac{2}{E'} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
        plain="2/E' = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2",
        symbols=("E_prime", "E_nu"),
        source=marked("Johnson (1985), section 4.2"),
        references=("johnson_1985",),
    ),
    Law(
        key="curvature",
        rolls="ball",
        name=marked("Curvatures of ball and race"),
        latex=r"\rho_{x,i} = \frac{2}{D}\,\frac{1}{1 - \gamma},\quad"
        r" \rho_{x,o} = \frac{2}{D}\,\frac{1}{1 + \gamma},\quad"
        r" \rho_y = \frac{2}{D} - \frac{1}{f D},\quad \gamma = \frac{D \cos\alpha}{d_m}",
        plain="ρ_x,i = (2/D)/(1 − γ),  ρ_x,o = (2/D)/(1 + γ),  ρ_y = 2/D − 1/(f D),  γ = D"
        " cos α/d_m",
        symbols=("rho", "gamma", "alpha", "d_m", "D", "f"),
        source=marked("Harris (1991), chapter 2"),
        references=("harris_1991",),
    ),
    Law(
        key="ellipticity",
        rolls="ball",
        name=marked("Hertz point contact: shape of the ellipse"),
        latex=r"\frac{|\rho_x - \rho_y|}{\rho_x + \rho_y} ="
        r" \frac{(k^2+1)\,E(m) - 2\,K(m)}{(k^2-1)\,E(m)},\quad m = 1 - \frac{1}{k^2}",
        plain="|ρ_x − ρ_y|/(ρ_x + ρ_y) = ((k² + 1) E − 2 K) / ((k² − 1) E),  m = 1 − 1/k²",
        symbols=("k", "KE", "rho"),
        source=marked("Hertz (1881); Harris (1991), chapter 5"),
        references=("hertz_1881", "harris_1991"),
        valid=marked("elastic half-spaces, contact small compared with the bodies; exact solution"),
    ),
    Law(
        key="hertz_stiffness",
        rolls="ball",
        name=marked("Hertz point contact: load and approach"),
        latex=r"Q = K_n\,\delta^{3/2},\quad K_n = \frac{\sqrt{8}}{3}\,E'\,"
        r"(\rho_x+\rho_y)^{-1/2}\,(\delta^*)^{-3/2}",
        plain="Q = K_n δ^(3/2),  K_n = (√8/3) E' (ρ_x + ρ_y)^(−1/2) (δ*)^(−3/2)",
        symbols=("Q", "delta", "delta_star", "E_prime"),
        source=marked("Radaelli (2013), equation 11; Johnson (1985), section 4.2"),
        references=("radaelli_2013", "johnson_1985"),
    ),
    Law(
        key="hertz_pressure",
        rolls="ball",
        name=marked("Maximum Hertz pressure"),
        latex=r"p_0 = \frac{3\,Q}{2\,\pi\,a\,b}",
        plain="p_0 = 3 Q / (2 π a b)",
        symbols=("p_0", "Q", "ab"),
        source=marked("Johnson (1985), section 4.2"),
        references=("johnson_1985",),
    ),
    Law(
        key="maximum_shear",
        rolls="ball",
        name=marked("Maximum shear stress below the surface"),
        latex=r"\tau_{max} = \max_{z}\; \frac{\sigma_{max}(z) - \sigma_{min}(z)}{2}",
        plain="τ_max = max_z (σ_max(z) − σ_min(z))/2",
        symbols=("tau_max",),
        source=marked("Thomas and Hoersch (1930); Johnson (1985), section 4.2(c)"),
        references=("thomas_hoersch_1930", "johnson_1985"),
    ),
    Law(
        key="orthogonal_shear",
        rolls="ball",
        name=marked("Orthogonal shear"),
        latex=r"\frac{\tau_0}{p_0} = \frac{\sqrt{2t-1}}{2t\,(t+1)},\quad"
        r" \frac{z_0}{b} = \frac{1}{(t+1)\sqrt{2t-1}},\quad \frac{b}{a} = \sqrt{(t^2-1)(2t-1)}",
        plain="τ_0/p_0 = √(2t − 1)/(2t (t + 1)),  z_0/b = 1/((t + 1) √(2t − 1)),  b/a = √((t²"
        " − 1)(2t − 1))",
        symbols=("tau_0", "p_0", "ab"),
        source=marked("Lundberg and Palmgren (1947)"),
        references=("lundberg_palmgren_1947",),
    ),
    Law(
        key="slice_overlap",
        rolls="roller",
        name=marked("Overlap of a slice with a race"),
        latex=r"\delta_k = \delta - x_k \tan\theta - P(x_k)",
        plain="δ_k = δ − x_k tan θ − P(x_k)",
        symbols=("delta", "L_we", "tilt"),
        source=marked("ISO/TS 16281:2008"),
        references=("iso_ts_16281",),
        valid=marked(
            "P drop of the profiles of roller and race; skew of the roller is not modelled"
        ),
    ),
    Law(
        key="iso_profile",
        rolls="roller",
        name=marked("Logarithmic profile of a roller"),
        latex=r"P(x) = k\, D_{we} \ln\frac{1}{1 - (2x/L_{we})^2}",
        plain="P(x) = k D_we ln(1/(1 − (2x/L_we)²))",
        symbols=("D_we", "L_we"),
        source=marked("ISO/TS 16281:2008"),
        references=("iso_ts_16281",),
        used=_iso_profile,
        valid=marked(
            "k 0.00035, of tapered rollers 0.00045; cylindrical rollers longer than"
            " 2.5 D_we are straight in the middle, with k 0.0005 at their ends"
        ),
    ),
    Law(
        key="independent_slices",
        rolls="roller",
        name=marked("Load of an independent slice"),
        latex=r"q_k = \frac{c_L}{n_s}\,\delta_k^{10/9},\quad c_L = 35948\, L_{we}^{8/9}",
        plain="q_k = (c_L/n_s) δ_k^(10/9),  c_L = 35948 L_we^(8/9)  (N, mm)",
        symbols=("q", "delta", "L_we"),
        source=marked("ISO/TS 16281:2008; Palmgren (1959)"),
        references=("iso_ts_16281", "palmgren_1959"),
        used=_line_contact("slices"),
        valid=marked(
            "both contacts of a steel roller together; other materials in proportion to"
            " E'. A slice knows nothing of its neighbours: no peak at an edge"
        ),
    ),
    Law(
        key="coupled_slices",
        rolls="roller",
        name=marked("Slices coupled by the elastic half-space"),
        latex=r"\delta_l = \sum_k \frac{2\, q_k}{\pi E'}\,\left[g_{|l-k|} - s\,B_{|l-k|}\right]"
        r"\ \mathrm{if}\ q_l > 0",
        plain="δ_l = Σ_k (2 q_k/(π E')) [g_|l−k| − s B_|l−k|] where q_l > 0",
        symbols=("q", "delta", "E_prime", "B_image"),
        source=marked("Johnson (1985), sections 3.2 and 5.6; de Mul et al. (1986)"),
        references=("johnson_1985", "de_mul_1986"),
        used=_line_contact("coupled"),
        valid=marked("elastic half-spaces; each slice a half ellipse of pressure across its width"),
    ),
    Law(
        key="line_pressure",
        rolls="roller",
        name=marked("Hertz line contact: half-width and maximum pressure"),
        latex=r"b = \sqrt{\frac{8\, q\, R}{\pi E'}},\quad p_0 = \frac{2\, q}{\pi b},"
        r"\quad R = \frac{D_{we}}{2}\,(1 \mp \gamma)",
        plain="b = √(8 q R/(π E')),  p_0 = 2 q/(π b),  R = (D_we/2)(1 ∓ γ)",
        symbols=("b_line", "p_0", "q", "E_prime", "gamma"),
        source=marked("Johnson (1985), section 4.2(c)"),
        references=("johnson_1985",),
        valid=marked("− inner race, + outer race; q load per length"),
    ),
    Law(
        key="line_shear",
        rolls="roller",
        name=marked("Shear stresses below a line of contact"),
        latex=r"\tau_{max} = 0.300\, p_0\ (z = 0.786\, b),\quad"
        r" \tau_0 = 0.25\, p_0\ (z_0 = 0.5\, b)",
        plain="τ_max = 0.300 p_0 at z = 0.786 b,  τ_0 = 0.25 p_0 at z_0 = 0.5 b",
        symbols=("tau_max", "tau_0", "p_0", "b_line"),
        source=marked("Johnson (1985), section 4.2(c); Lundberg and Palmgren (1947)"),
        references=("johnson_1985", "lundberg_palmgren_1947"),
    ),
    Law(
        key="orbit",
        rolls="ball",
        name=marked("Orbital speed of a ball under raceway control"),
        latex=r"\omega_m = \omega_c + (\omega_s - \omega_c)\,"
        r"\frac{1 - \sigma\,(D/d_m)\cos\alpha_s}{1 + \cos(\alpha_i - \alpha_o)}",
        plain="ω_m = ω_c + (ω_s − ω_c) (1 − σ (D/d_m) cos α_s)/(1 + cos(α_i − α_o))",
        symbols=("omega_m", "omega", "slave", "alpha", "D", "d_m"),
        source=marked("Jones (1959, 1960); Radaelli (2013), equations 43 to 46"),
        references=("jones_1959", "jones_1960", "radaelli_2013"),
        used=_controlled,
        valid=marked("no spin at the controlling race"),
    ),
    Law(
        key="jones_criterion",
        rolls="ball",
        name=marked("Jones's criterion: the outer race controls"),
        latex=r"Q_o\,a_o\,E(m_o)\,\cos(\alpha_i-\alpha_o) > Q_i\,a_i\,E(m_i)",
        plain="Q_o a_o E(m_o) cos(α_i − α_o) > Q_i a_i E(m_i)",
        symbols=("Q", "ab", "KE", "alpha"),
        source=marked("Jones (1959); Harris (1991)"),
        references=("jones_1959", "harris_1991"),
        used=lambda case: _controlled(case) and case.case.model.raceway_control == "jones",
    ),
    Law(
        key="cage_speed",
        rolls="ball",
        name=marked("Cage speed"),
        latex=r"\omega_{cage} = \frac{\sum h\,Q_i\,\omega_m}{\sum h\,Q_i}",
        plain="ω_cage = Σ h Q_i ω_m / Σ h Q_i",
        symbols=("cage", "Q", "omega_m"),
        source=marked("mean of the orbital speeds, weighted by the inner loads"),
        used=_cage,
    ),
    Law(
        key="centrifugal",
        rolls="ball",
        name=marked("Centrifugal force on a ball"),
        latex=r"F_c = \frac{1}{2}\,m\,d_m\,\omega_m^2",
        plain="F_c = ½ m d_m ω_m²",
        symbols=("F_c", "mass", "d_m", "omega_m"),
        source=marked("Radaelli (2013), equation 47"),
        references=("radaelli_2013",),
        used=_centrifugal,
    ),
    Law(
        key="gyroscopic",
        rolls="ball",
        name=marked("Gyroscopic moment on a ball"),
        latex=r"M_g = J\,\omega_R\,\omega_m \sin\beta,\quad J = \frac{m D^2}{10}",
        plain="M_g = J ω_R ω_m sin β,  J = m D²/10",
        symbols=("M_g", "mass", "omega_R", "omega_m"),
        source=marked("Jones (1960); Harris (1991)"),
        references=("jones_1960", "harris_1991"),
        used=_gyroscopic,
    ),
    Law(
        key="roller_orbit",
        rolls="roller",
        name=marked("Orbital speed of a roller"),
        latex=r"\omega_m = \frac{\omega_i}{2}(1-\gamma) + \frac{\omega_o}{2}(1+\gamma)",
        plain="ω_m = ½ ω_i (1 − γ) + ½ ω_o (1 + γ)",
        symbols=("omega_m", "omega", "gamma"),
        source=marked("pure rolling in the middle of both lines; Harris (1991)"),
        references=("harris_1991",),
        used=_turns,
    ),
    Law(
        key="roller_centrifugal",
        rolls="roller",
        name=marked("Centrifugal force on a roller"),
        latex=r"F_c = \frac{1}{2}\,m\,d_{pw}\,\omega_m^2",
        plain="F_c = ½ m d_pw ω_m²",
        symbols=("F_c", "mass", "d_m", "omega_m"),
        source=marked("Harris (1991)"),
        references=("harris_1991",),
        used=_centrifugal,
    ),
    Law(
        key="ball_equilibrium_axial",
        rolls="ball",
        name=marked("Axial equilibrium of a ball (Jones–Harris)"),
        latex=r"Q_i \sin\alpha_i - Q_o \sin\alpha_o"
        r" - \frac{M_g}{D}(\lambda_i\cos\alpha_i - \lambda_o\cos\alpha_o) = 0",
        plain="Q_i sin α_i − Q_o sin α_o − (M_g/D)(λ_i cos α_i − λ_o cos α_o) = 0",
        symbols=("Q", "alpha", "lambda_i", "M_g", "D"),
        source=marked("Jones (1960); Harris (1991), chapter 8; Radaelli (2013), equation 76"),
        references=("jones_1960", "harris_1991", "radaelli_2013"),
        used=lambda case: not _by_friction(case),
        valid=marked("rigid rings; elastic contacts; contact angles between −90° and 90°"),
    ),
    Law(
        key="ball_equilibrium_radial",
        rolls="ball",
        name=marked("Radial equilibrium of a ball (Jones–Harris)"),
        latex=r"Q_i \cos\alpha_i - Q_o \cos\alpha_o"
        r" + \frac{M_g}{D}(\lambda_i\sin\alpha_i - \lambda_o\sin\alpha_o) + F_c = 0",
        plain="Q_i cos α_i − Q_o cos α_o + (M_g/D)(λ_i sin α_i − λ_o sin α_o) + F_c = 0",
        symbols=("Q", "alpha", "lambda_i", "M_g", "F_c", "D"),
        source=marked("Jones (1960); Harris (1991), chapter 8; Radaelli (2013), equation 77"),
        references=("jones_1960", "harris_1991", "radaelli_2013"),
        used=lambda case: not _by_friction(case),
    ),
    Law(
        key="ring_equilibrium",
        rolls="ball",
        name=marked("Equilibrium of the inner ring"),
        latex=r"F_x = \sum f_x,\quad F_y = \sum f_r\sin\psi,\quad F_z = \sum f_r\cos\psi,\quad"
        r" M_y = R_i\sum h\cos\psi,\quad M_z = -R_i\sum h\sin\psi",
        plain="F_x = Σ f_x,  F_y = Σ f_r sin ψ,  F_z = Σ f_r cos ψ,  M_y = R_i Σ h cos ψ, "
        " M_z = −R_i Σ h sin ψ",
        symbols=("loads", "psi", "R_i"),
        source=marked("Jones (1960); Radaelli (2013), equations 90 to 92, 99 to 106"),
        references=("jones_1960", "radaelli_2013"),
        valid=marked("small tilts, up to about 1°"),
    ),
    Law(
        key="friction_control",
        rolls="ball",
        name=marked("Ball motion under friction control"),
        latex=r"\sum \mathbf{M} = J\,\omega_m\,\hat{x} \times \mathbf{\omega},\quad"
        r" \mathbf{f} = -\mu\,p\,\frac{\mathbf{v}}{\sqrt{v^2 + v_0^2}}",
        plain="Σ M = J ω_m x × ω,  f = −μ p v/√(v² + v_0²)",
        symbols=("mu", "mass", "omega_m"),
        source=marked("Jones (1959); Harris (1991), chapter 8"),
        references=("jones_1959", "harris_1991"),
        used=_by_friction,
        valid=marked("Coulomb friction under Hertz pressure, or the shear of the film"),
    ),
    Law(
        key="stiffness",
        rolls="ball",
        name=marked("Stiffness of the bearing"),
        latex=r"K_{ij} = \frac{\partial F_i}{\partial u_j}",
        plain="K_ij = ∂F_i/∂u_j",
        valid=marked("tangent stiffness, all balls in equilibrium"),
        symbols=("loads", "u"),
        source=marked("derivative of the equilibrium; Jones (1960)"),
        references=("jones_1960",),
    ),
    Law(
        key="roller_equilibrium",
        rolls="roller",
        name=marked("Equilibrium of a roller"),
        latex=r"\sum_k q_{i,k}\,\mathbf{n}_i + \sum_k q_{o,k}\,\mathbf{n}_o +"
        r" \mathbf{F}_c + \mathbf{F}_{rib} = 0,\quad"
        r" \sum_k (q_{o,k} - q_{i,k})\, x_k + M_{rib} + M_g = 0",
        plain="Σ q_i,k n_i + Σ q_o,k n_o + F_c + F_rib = 0,  Σ (q_o,k − q_i,k) x_k + M_rib + M_g"
        " = 0",
        symbols=("q", "L_we", "F_c", "F_rib", "M_g"),
        source=marked("forces in the roller's axial plane, and moments about its middle"),
        valid=marked(
            "rigid rings; rib, friction and cage transmit no moment about the radius (no skew)"
        ),
    ),
    Law(
        key="rib_force",
        rolls="roller",
        name=marked("Force of the rib on a tapered roller"),
        latex=r"F_{rib} = Q_o \sin(\varphi+\varepsilon) + Q_i \sin(\varphi-\varepsilon)"
        r" + F_c \sin(\beta-\varepsilon)",
        plain="F_rib = Q_o sin(φ + ε) + Q_i sin(φ − ε) + F_c sin(β − ε)",
        symbols=("F_rib", "Q", "phi", "F_c"),
        source=marked("equilibrium of the roller across the force of the rib"),
        used=_element("tapered"),
    ),
    Law(
        key="roller_ring_equilibrium",
        rolls="roller",
        name=marked("Equilibrium of the inner ring"),
        latex=r"F_x = \sum f_x,\quad F_y = \sum f_r \sin\psi,\quad F_z = \sum f_r \cos\psi,\quad"
        r" M_y = \sum m \cos\psi,\quad M_z = -\sum m \sin\psi",
        plain="F_x = Σ f_x,  F_y = Σ f_r sin ψ,  F_z = Σ f_r cos ψ,  M_y = Σ m cos ψ,  M_z = "
        "−Σ m sin ψ",
        symbols=("loads", "psi"),
        source=marked("Jones (1960)"),
        references=("jones_1960",),
        valid=marked("small tilts, up to about 1°"),
    ),
    Law(
        key="roller_stiffness",
        rolls="roller",
        name=marked("Stiffness of the bearing"),
        latex=r"K_{ij} = \frac{\partial F_i}{\partial u_j}",
        plain="K_ij = ∂F_i/∂u_j",
        symbols=("loads", "u"),
        source=marked("derivative of the equilibrium; Jones (1960)"),
        references=("jones_1960",),
        valid=marked("tangent stiffness, all rollers in equilibrium"),
    ),
    Law(
        key="dynamic_rating",
        rolls="ball",
        name=marked("Basic dynamic load rating"),
        latex=r"C = b_m\,f_c\,(i\cos\alpha_0)^{0.7}\,Z^{2/3}\,D^{1.8}",
        plain="C = b_m f_c (i cos α_0)^0.7 Z^(2/3) D^1.8  (N, mm)",
        symbols=("C", "f_c", "rows", "Z", "D", "alpha_0"),
        source=marked("ISO 281:2007, equations 1 and 2"),
        references=("iso_281_2007",),
        used=_radial(_rating("dynamic", "geometry")),
        valid=marked("D up to 25.4 mm; D cos α/d_m from 0.01 to 0.40"),
    ),
    Law(
        key="dynamic_rating_thrust",
        rolls="ball",
        name=marked("Basic dynamic axial load rating"),
        latex=r"C_a = b_m\,f_c\,(\cos\alpha_0)^{0.7}\tan\alpha_0\,Z^{2/3}\,D^{1.8},"
        r"\quad 90^{\circ}:\; b_m\,f_c\,Z^{2/3}\,D^{1.8}",
        plain="C_a = b_m f_c (cos α_0)^0.7 tan α_0 Z^(2/3) D^1.8;  90°: b_m f_c Z^(2/3) D^1.8"
        "  (N, mm)",
        symbols=("C", "f_c", "Z", "D", "alpha_0"),
        source=marked("ISO 281:2007, equations 5 to 8"),
        references=("iso_281_2007",),
        used=_axial(_rating("dynamic", "geometry")),
        valid=marked("D up to 25.4 mm; D/d_m from 0.01 to 0.40"),
    ),
    Law(
        key="static_rating",
        rolls="ball",
        name=marked("Basic static load rating"),
        latex=r"C_0 = f_0\,i\,Z\,D^2\cos\alpha_0",
        plain="C_0 = f_0 i Z D² cos α_0",
        symbols=("C", "f_c", "rows", "Z", "D", "alpha_0"),
        source=marked("ISO 76:2006, equation 1"),
        references=("iso_76_2006",),
        used=_radial(_rating("static", "geometry")),
        valid=marked("steel balls"),
    ),
    Law(
        key="static_rating_thrust",
        rolls="ball",
        name=marked("Basic static axial load rating"),
        latex=r"C_{0a} = f_0\,Z\,D^2\sin\alpha_0",
        plain="C_0a = f_0 Z D² sin α_0",
        symbols=("C", "f_c", "Z", "D", "alpha_0"),
        source=marked("ISO 76:2006, 5.2"),
        references=("iso_76_2006",),
        used=_axial(_rating("static", "geometry")),
        valid=marked("steel balls"),
    ),
    Law(
        key="roller_dynamic_rating",
        rolls="roller",
        name=marked("Basic dynamic load rating"),
        latex=r"C = b_m f_c\,(i\,L_{we}\cos\alpha)^{7/9}\,Z^{3/4}\,D_{we}^{29/27}",
        plain="C = b_m f_c (i L_we cos α)^(7/9) Z^(3/4) D_we^(29/27)  (N, mm)",
        symbols=("C", "f_c", "rows", "L_we", "Z", "D"),
        source=marked("ISO 281:2007, clause 7"),
        references=("iso_281_2007",),
        used=_rating("dynamic", "geometry"),
        valid=marked("D_we cos α/d_pw from 0.01 to 0.30"),
    ),
    Law(
        key="roller_static_rating",
        rolls="roller",
        name=marked("Basic static load rating"),
        latex=r"C_0 = 44\,(1-\gamma)\,i\,Z\,L_{we}\,D_{we}\cos\alpha",
        plain="C_0 = 44 (1 − γ) i Z L_we D_we cos α  (N, mm)",
        symbols=("C", "gamma", "rows", "Z", "L_we", "D"),
        source=marked("ISO 76:2006, clause 7"),
        references=("iso_76_2006",),
        used=_rating("static", "geometry"),
        valid=marked("steel rollers"),
    ),
    Law(
        key="fatigue_load_limit",
        rolls="ball",
        name=marked("Fatigue load limit"),
        latex=r"C_u = 0.2288\,Z\,Q_u\,i\cos\alpha_0",
        plain="C_u = 0.2288 Z Q_u i cos α_0",
        symbols=("C", "Z", "rows", "alpha_0"),
        source=marked("ISO 281:2007, annex B.3.2"),
        references=("iso_281_2007",),
        used=_radial(_rating("fatigue", "contacts")),
        valid=marked("Q_u load of a contact at 1500 MPa; times (100 mm/d_m)^0.5 above 100 mm"),
    ),
    Law(
        key="fatigue_load_limit_thrust",
        rolls="ball",
        name=marked("Fatigue load limit"),
        latex=r"C_u = Z\,Q_u\sin\alpha_0",
        plain="C_u = Z Q_u sin α_0",
        symbols=("C", "Z", "alpha_0"),
        source=marked("ISO 281:2007, annex B.3.2"),
        references=("iso_281_2007",),
        used=_axial(_rating("fatigue", "contacts")),
        valid=marked("Q_u load of a contact at 1500 MPa; times (100 mm/d_m)^0.5 above 100 mm"),
    ),
    Law(
        key="fatigue_load_estimate",
        rolls="ball",
        name=marked("Fatigue load limit, estimated"),
        latex=r"C_u = \frac{C_0}{22}",
        plain="C_u = C_0/22",
        symbols=("C",),
        source=marked("ISO 281:2007, annex B.3.3"),
        references=("iso_281_2007",),
        used=_rating("fatigue", "estimate"),
        valid=marked("steel balls; times (100 mm/d_m)^0.5 above 100 mm"),
    ),
    Law(
        key="roller_fatigue_load_limit",
        rolls="roller",
        name=marked("Fatigue load limit"),
        latex=r"C_u = 0.2453\,Z\,Q_u\,i\cos\alpha",
        plain="C_u = 0.2453 Z Q_u i cos α",
        symbols=("C", "Z", "rows"),
        source=marked("ISO 281:2007, annex B.3.2"),
        references=("iso_281_2007",),
        used=_rating("fatigue", "contacts"),
        valid=marked(
            "Q_u load of a contact whose maximum pressure along the roller is 1500 MPa;"
            " times (100 mm/d_pw)^0.3 above 100 mm"
        ),
    ),
    Law(
        key="roller_fatigue_load_estimate",
        rolls="roller",
        name=marked("Fatigue load limit, estimated"),
        latex=r"C_u = C_0/8.2",
        plain="C_u = C_0/8.2",
        symbols=("C",),
        source=marked("ISO 281:2007, annex B.3.3"),
        references=("iso_281_2007",),
        used=_rating("fatigue", "estimate"),
        valid=marked("steel rollers; times (100 mm/d_pw)^0.3 above 100 mm"),
    ),
    Law(
        key="equivalent_load",
        rolls="ball",
        name=marked("Dynamic equivalent load"),
        latex=r"P = X F_r + Y F_a",
        plain="P = X F_r + Y F_a",
        symbols=("P", "XY", "F_ra"),
        source=marked("ISO 281:2007, 5.1.2 and table 3"),
        references=("iso_281_2007",),
        used=_radial(_theory("iso281")),
        valid=marked("one row, rows in tandem, or a facing pair; P up to C/2 and C_0"),
    ),
    Law(
        key="equivalent_load_thrust",
        rolls="ball",
        name=marked("Dynamic equivalent axial load"),
        latex=r"P_a = X F_r + F_a,\quad X = 1.25\tan\alpha_0\left(1 - \frac{2}{3}\sin\alpha_0"
        r"\right),\quad 90^{\circ}:\; P_a = F_a",
        plain="P_a = X F_r + F_a,  X = 1.25 tan α_0 (1 − 2/3 sin α_0);  90°: P_a = F_a",
        symbols=("P", "XY", "F_ra", "alpha_0"),
        source=marked("ISO 281:2007, 5.2.2 and table 5"),
        references=("iso_281_2007",),
        used=_axial(_theory("iso281")),
        valid=marked("F_a/F_r above 1.25 tan α_0; P_a up to C_a/2 and C_0a"),
    ),
    Law(
        key="static_equivalent_load",
        rolls="ball",
        name=marked("Static equivalent load and static safety"),
        latex=r"P_0 = \max(F_r,\; X_0 F_r + Y_0 F_a),\quad S_0 = \frac{C_0}{P_0}",
        plain="P_0 = max(F_r, X_0 F_r + Y_0 F_a),  S_0 = C_0/P_0",
        symbols=("P", "XY", "F_ra", "S_0", "C"),
        source=marked("ISO 76:2006, table 2"),
        references=("iso_76_2006",),
        used=_radial(_life),
    ),
    Law(
        key="static_equivalent_load_thrust",
        rolls="ball",
        name=marked("Static equivalent axial load and static safety"),
        latex=r"P_{0a} = 2.3\,F_r\tan\alpha_0 + F_a,\quad S_0 = \frac{C_{0a}}{P_{0a}},"
        r"\quad 90^{\circ}:\; P_{0a} = F_a",
        plain="P_0a = 2.3 F_r tan α_0 + F_a,  S_0 = C_0a/P_0a;  90°: P_0a = F_a",
        symbols=("P", "F_ra", "S_0", "C", "alpha_0"),
        source=marked("ISO 76:2006, 5.2.2"),
        references=("iso_76_2006",),
        used=_axial(_life),
    ),
    Law(
        key="roller_equivalent_load",
        rolls="roller",
        name=marked("Dynamic equivalent load"),
        latex=r"P = X F_r + Y F_a,\quad e = 1.5\tan\alpha",
        plain="P = X F_r + Y F_a,  e = 1.5 tan α",
        symbols=("P", "XY", "F_ra"),
        source=marked("ISO 281:2007, table 8"),
        references=("iso_281_2007",),
        used=_theory("iso281"),
        valid=marked("one row, rows in tandem, or a facing pair; P up to C/2 and C_0"),
    ),
    Law(
        key="roller_static_equivalent_load",
        rolls="roller",
        name=marked("Static equivalent load and static safety"),
        latex=r"P_0 = \max(F_r,\; X_0 F_r + Y_0 F_a),\quad S_0 = C_0/P_0",
        plain="P_0 = max(F_r, X_0 F_r + Y_0 F_a),  S_0 = C_0/P_0",
        symbols=("P", "XY", "F_ra", "S_0", "C"),
        source=marked("ISO 76:2006, table 4"),
        references=("iso_76_2006",),
        used=_life,
    ),
    Law(
        key="basic_life",
        rolls="ball",
        name=marked("Basic rating life"),
        latex=r"L_{10} = \left(\frac{C}{P}\right)^{3},\quad L_{10h} = \frac{10^6\,L_{10}}{60\,n}",
        plain="L_10 = (C/P)³,  L_10h = 10⁶ L_10/(60 n)",
        symbols=("L_10", "C", "P", "n"),
        source=marked("ISO 281:2007, 5.1.3"),
        references=("iso_281_2007",),
        used=_theory("iso281"),
    ),
    Law(
        key="roller_basic_life",
        rolls="roller",
        name=marked("Basic rating life"),
        latex=r"L_{10} = \left(\frac{C}{P}\right)^{10/3},\quad L_{10h} ="
        r" \frac{10^6\,L_{10}}{60\,n}",
        plain="L_10 = (C/P)^(10/3),  L_10h = 10⁶ L_10/(60 n)",
        symbols=("L_10", "C", "P", "n"),
        source=marked("ISO 281:2007, clause 7"),
        references=("iso_281_2007",),
        used=_theory("iso281"),
    ),
    Law(
        key="reliability_2007",
        name=marked("Factor of reliability"),
        latex=r"a_1 = 0.95\left[\frac{\ln(1/S)}{\ln(1/0.9)}\right]^{2/3} + 0.05",
        plain="a_1 = 0.95 [ln(1/S)/ln(1/0.9)]^(2/3) + 0.05",
        symbols=("a_1", "S"),
        source=marked("ISO 281:2007, table 12"),
        references=("iso_281_2007",),
        used=_edition("2007"),
        valid=marked("tabulated from 90 % to 99.95 %"),
    ),
    Law(
        key="reliability_1990",
        name=marked("Factor of reliability"),
        latex=r"a_1 = \left[\frac{\ln(1/S)}{\ln(1/0.9)}\right]^{2/3}",
        plain="a_1 = [ln(1/S)/ln(1/0.9)]^(2/3)",
        symbols=("a_1", "S"),
        source=marked("ISO 281:1990"),
        references=("iso_281_1990",),
        used=_edition("1990"),
        valid=marked("tabulated from 90 % to 99 %"),
    ),
    Law(
        key="viscosity_line",
        name=marked("Viscosity-temperature relation"),
        latex=r"\log_{10}\log_{10}(\nu + 0.7) = A - B\log_{10} T",
        plain="log log(ν + 0.7) = A − B log T  (mm²/s, K)",
        symbols=("nu", "T"),
        source=marked("ASTM D341"),
        references=("astm_d341",),
        used=_ratio_of_oil,
        valid=marked("petroleum oils and hydrocarbons, above 2 mm²/s"),
    ),
    Law(
        key="reference_viscosity",
        name=marked("Viscosity ratio and required viscosity"),
        latex=r"\kappa = \frac{\nu}{\nu_1},\quad \nu_1 = \frac{45000}{n^{0.83}\sqrt{d_m}}"
        r"\;(n < 1000),\quad \nu_1 = \frac{4500}{\sqrt{n\,d_m}}\;(n \geq 1000)",
        plain="κ = ν/ν_1;  ν_1 = 45000 n^−0.83 d_m^−0.5 (n < 1000),  ν_1 = 4500 n^−0.5"
        " d_m^−0.5 (n ≥ 1000)  (mm²/s, rpm, mm)",
        symbols=("kappa", "nu", "n", "d_m"),
        source=marked("ISO 281:2007, 9.3.3"),
        references=("iso_281_2007",),
        used=_ratio_of_oil,
    ),
    Law(
        key="contamination",
        name=marked("Contamination factor"),
        latex=r"e_C = \min(1,\; c_1\,\kappa^{0.68}\,d_m^{0.55})"
        r"\left(1 - \frac{c_2}{d_m^{1/3}}\right)",
        plain="e_C = min(1, c_1 κ^0.68 d_m^0.55) (1 − c_2/d_m^(1/3))  (mm)",
        symbols=("e_C", "kappa", "d_m"),
        source=marked("ISO 281:2007, annex A"),
        references=("iso_281_2007", "iso_4406"),
        used=_classes,
    ),
    Law(
        key="a_iso",
        rolls="ball",
        name=marked("Modified rating life"),
        latex=r"L_{nm} = a_1\,a_{ISO}\,L_{10},\quad a_{ISO} = 0.1\left[1 - \left(2.5671"
        r" - \frac{c}{\kappa^{p}}\right)^{0.83}\left(\frac{e_C C_u}{P}\right)^{1/3}\right]^{-9.3}",
        plain="L_nm = a_1 a_ISO L_10;  a_ISO = 0.1 [1 − (2.5671 − c/κ^p)^0.83 (e_C"
        " C_u/P)^(1/3)]^−9.3 ≤ 50",
        symbols=("a_ISO", "a_1", "kappa", "e_C", "C", "P"),
        source=marked("ISO 281:2007, 9.3.3"),
        references=("iso_281_2007",),
        used=_radial(_theory("iso281_modified", "iso16281_modified")),
        valid=marked("κ from 0.1, counted as 4 above 4; e_C above 0; P up to C/2 and C_0"),
    ),
    Law(
        key="a_iso_thrust",
        rolls="ball",
        name=marked("Modified rating life"),
        latex=r"L_{nm} = a_1\,a_{ISO}\,L_{10},\quad a_{ISO} = 0.1\left[1 - \left(2.5671"
        r" - \frac{c}{\kappa^{p}}\right)^{0.83}\left(\frac{e_C C_u}{3 P_a}\right)^{1/3}"
        r"\right]^{-9.3}",
        plain="L_nm = a_1 a_ISO L_10;  a_ISO = 0.1 [1 − (2.5671 − c/κ^p)^0.83 (e_C"
        " C_u/(3 P_a))^(1/3)]^−9.3 ≤ 50",
        symbols=("a_ISO", "a_1", "kappa", "e_C", "C", "P"),
        source=marked("ISO 281:2007, 9.3.3"),
        references=("iso_281_2007",),
        used=_axial(_theory("iso281_modified", "iso16281_modified")),
        valid=marked("κ from 0.1, counted as 4 above 4; e_C above 0; P up to C/2 and C_0"),
    ),
    Law(
        key="roller_a_iso",
        rolls="roller",
        name=marked("Modified rating life"),
        latex=r"L_{nm} = a_1\,a_{ISO}\,L_{10},\quad a_{ISO} = 0.1\left[1 - \left(1.5859 -"
        r" \frac{c}{\kappa^p}\right)\left(\frac{e_C C_u}{P}\right)^{0.4}\right]^{-9.185}\leq 50",
        plain="L_nm = a_1 a_ISO L_10;  a_ISO = 0.1 [1 − (1.5859 − c/κ^p) (e_C C_u/P)^0.4]^−9.185 ≤"
        " 50",
        symbols=("a_ISO", "a_1", "kappa", "e_C", "C", "P"),
        source=marked("ISO 281:2007, 9.3.3"),
        references=("iso_281_2007",),
        used=_theory("iso281_modified", "iso16281_modified"),
        valid=marked("κ from 0.1, counted as 4 above 4; e_C above 0; P up to C/2 and C_0"),
    ),
    Law(
        key="adjusted_life",
        name=marked("Adjusted rating life"),
        latex=r"L_{na} = a_1\,a_2\,a_3\,L_{10}",
        plain="L_na = a_1 a_2 a_3 L_10",
        symbols=("a_1", "L_10"),
        source=marked("ISO 281:1990, clause 8"),
        references=("iso_281_1990",),
        used=_theory("iso281_1990"),
    ),
    Law(
        key="race_rating",
        rolls="ball",
        name=marked("Dynamic load rating of a race"),
        latex=r"Q_{ci} = \frac{C}{0.407\,Z\cos\alpha_0\,i^{0.7}}\left(1+T^{10/3}\right)^{3/10},"
        r"\quad Q_{co} = \frac{C}{0.389\,Z\cos\alpha_0\,i^{0.7}}\left(1+T^{-10/3}\right)^{3/10}",
        plain="Q_ci = C/(0.407 Z cos α_0 i^0.7) (1 + T^(10/3))^(3/10);  Q_co = C/(0.389 Z cos"
        " α_0 i^0.7) (1 + T^(−10/3))^(3/10)",
        symbols=("Q_c", "C", "Z", "alpha_0", "rows"),
        source=marked("ISO/TS 16281:2008, 4.3"),
        references=("iso_ts_16281", "lundberg_palmgren_1947"),
        used=_radial(_theory("iso16281")),
    ),
    Law(
        key="race_rating_thrust",
        rolls="ball",
        name=marked("Dynamic load rating of a race"),
        latex=r"Q_{ci} = \frac{C_a}{Z\sin\alpha_0}\left(1+T^{10/3}\right)^{3/10},"
        r"\quad Q_{co} = \frac{C_a}{Z\sin\alpha_0}\left(1+T^{-10/3}\right)^{3/10}",
        plain="Q_ci = C_a/(Z sin α_0) (1 + T^(10/3))^(3/10);  Q_co = C_a/(Z sin α_0) (1 +"
        " T^(−10/3))^(3/10)",
        symbols=("Q_c", "C", "Z", "alpha_0"),
        source=marked("ISO/TS 16281:2008, 4.3"),
        references=("iso_ts_16281", "lundberg_palmgren_1947"),
        used=_axial(_theory("iso16281")),
    ),
    Law(
        key="reference_life",
        rolls="ball",
        name=marked("Basic reference rating life, ball by ball"),
        latex=r"L_{10r} = \left[\sum \left(\frac{Q_c}{Q_e}\right)^{-10/3}\right]^{-9/10}",
        plain="L_10r = [Σ (Q_c/Q_e)^(−10/3)]^(−9/10)",
        symbols=("L_10r", "Q_c"),
        source=marked("ISO/TS 16281:2008, 4.4 and 4.5"),
        references=("iso_ts_16281", "lundberg_palmgren_1947"),
        used=_theory("iso16281"),
        valid=marked(
            "sum over races and rows; Q_e mean of power 3 on a race rotating relative to the load, "
            "else of power 10/3; any load, tilt, clearance and speed; P_ref up to C/2 and C_0"
        ),
    ),
    Law(
        key="slice_rating",
        rolls="roller",
        name=marked("Dynamic load rating of a slice"),
        latex=r"q_c = Q_c\,n_s^{-7/9},\quad Q_{ci} = \frac{C\,(1 + T^{9/2})^{2/9}}"
        r"{0.378\cdot 0.83\,Z\cos\alpha\,i^{7/9}},\quad Q_{co} = \frac{C\,(1 + T^{-9/2})^{2/9}}"
        r"{0.364\cdot 0.83\,Z\cos\alpha\,i^{7/9}}",
        plain="q_c = Q_c n_s^(−7/9);  Q_ci = C/(0.378·0.83 Z cos α i^(7/9)) (1 + T^(9/2))^(2/9);"
        "  Q_co = C/(0.364·0.83 Z cos α i^(7/9)) (1 + T^(−9/2))^(2/9);  T = 1.038 ((1 − γ)/"
        "(1 + γ))^(143/108)",
        symbols=("q_c", "Q_c", "C", "Z", "rows", "gamma"),
        source=marked("ISO/TS 16281:2008, 5.3"),
        references=("iso_ts_16281",),
        used=_theory("iso16281"),
    ),
    Law(
        key="slice_life",
        rolls="roller",
        name=marked("Basic reference rating life, slice by slice"),
        latex=r"L_{10r} = \left\{\sum_k \left[\left(\frac{f_k q_{e,i}}{q_{c,i}}\right)^{9/2} +"
        r" \left(\frac{f_k q_{e,o}}{q_{c,o}}\right)^{9/2}\right]\right\}^{-8/9}",
        plain="L_10r = {Σ_k [(f_k q_ei/q_ci)^(9/2) + (f_k q_eo/q_co)^(9/2)]}^(−8/9)",
        symbols=("L_10r", "f_k", "q_c"),
        source=marked("ISO/TS 16281:2008, 5.4"),
        references=("iso_ts_16281",),
        used=_theory("iso16281"),
        valid=marked(
            "q_e mean of power 4 on a race rotating relative to the load, else of power"
            " 9/2; f_k = 1 with coupled slices; the number of slices is part of the"
            " method"
        ),
    ),
    Law(
        key="ioannides_harris",
        name=marked("Stress-volume life (Ioannides and Harris)"),
        latex=r"\ln\frac{1}{S} \propto N^{e}\int \frac{\langle\tau-\tau_u\rangle^{c}}{z'^{h}}"
        r"\,dV,\quad e = \frac{10}{9},\; c = \frac{31}{3},\; h = \frac{7}{3}",
        plain="ln(1/S) ∝ N^e ∫ ⟨τ − τ_u⟩^c/z'^h dV,  e = 10/9, c = 31/3, h = 7/3",
        symbols=("S", "tau_u"),
        source=marked("Ioannides and Harris (1985); Campanha (2008), equation 2.6.5"),
        references=("ioannides_harris_1985", "campanha_2008"),
        used=_theory("ioannides_harris"),
        valid=marked("subsurface fatigue only: an upper bound"),
    ),
    Law(
        key="l_able",
        name=marked("NSK's life L_able"),
        latex=r"L_{able} = a_1\,a_{NSK}\,L_{10}",
        plain="L_able = a_1 a_NSK L_10",
        symbols=("a_1", "L_10"),
        source=marked("Takemura et al. (2000); Campanha (2008), equation 2.6.8"),
        references=("takemura_2000", "campanha_2008"),
        used=_theory("l_able"),
        valid=marked("P up to C/2 and C_0, at least 20 rpm, at most 130 °C"),
    ),
    Law(
        key="tallian",
        name=marked("Tallian's form of the life equation"),
        latex=r"-\ln S = \phi_0\,\phi_1\,\phi_2\,\phi_3\,\phi_4\,N^{s}",
        plain="−ln S = φ_0 φ_1 φ_2 φ_3 φ_4 N^s",
        symbols=("S",),
        source=marked("Chiu, Tallian and McCool (1971); Campanha (2008), equation 2.6.3"),
        references=("tallian_1971", "campanha_2008"),
        used=_theory("tallian"),
    ),
    Law(
        key="film_groups",
        rolls="ball",
        name=marked("Dimensionless groups of the film"),
        latex=r"U = \frac{\eta\,u}{E' R_x},\quad W = \frac{Q}{E' R_x^2},\quad G = \alpha_p E'",
        plain="U = η u/(E' R_x),  W = Q/(E' R_x²),  G = α_p E'",
        symbols=("UWG", "eta", "R_x", "E_prime", "Q", "alpha_p"),
        source=marked("Hamrock and Dowson (1977)"),
        references=("hamrock_dowson_1977",),
        used=_film,
    ),
    Law(
        key="central_film",
        rolls="ball",
        name=marked("Central film thickness (Hamrock–Dowson)"),
        latex=r"H_c = 2.69\,U^{0.67} G^{0.53} W^{-0.067}\left(1 - 0.61\,e^{-0.73 k}\right)",
        plain="H_c = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^(−0.73 k))",
        symbols=("H", "UWG", "k"),
        source=marked("Hamrock and Dowson (1977), part III"),
        references=("hamrock_dowson_1977",),
        used=_film,
        valid=marked("isothermal and fully flooded; fitted to the ranges of U, W, G and k below"),
    ),
    Law(
        key="minimum_film",
        rolls="ball",
        name=marked("Minimum film thickness (Hamrock–Dowson)"),
        latex=r"H_0 = 3.63\,U^{0.68} G^{0.49} W^{-0.073}\left(1 - e^{-0.68 k}\right)",
        plain="H_0 = 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^(−0.68 k))",
        symbols=("H", "UWG", "k"),
        source=marked("Hamrock and Dowson (1977), part III"),
        references=("hamrock_dowson_1977",),
        used=_film,
    ),
    Law(
        key="line_film_groups",
        rolls="roller",
        name=marked("Dimensionless groups of the film"),
        latex=r"U = \frac{\eta u}{E' R_x},\quad W' = \frac{q}{E' R_x},\quad G = \alpha_p E'",
        plain="U = η u/(E' R_x),  W' = q/(E' R_x),  G = α_p E'",
        symbols=("UWG", "eta", "R_x", "E_prime", "q", "alpha_p"),
        source=marked("Pan and Hamrock (1989)"),
        references=("pan_hamrock_1989",),
        used=_film,
        valid=marked("q load per length of the most loaded slice"),
    ),
    Law(
        key="pan_hamrock",
        rolls="roller",
        name=marked("Film thickness of a line contact (Pan–Hamrock)"),
        latex=r"H_c = 2.922\,W'^{-0.166}U^{0.692}G^{0.470},\quad"
        r" H_0 = 1.714\,W'^{-0.128}U^{0.694}G^{0.568}",
        plain="H_c = 2.922 W'^−0.166 U^0.692 G^0.470,  H_0 = 1.714 W'^−0.128 U^0.694 G^0.568",
        symbols=("H", "UWG"),
        source=marked("Pan and Hamrock (1989)"),
        references=("pan_hamrock_1989",),
        used=_line_film("pan_hamrock"),
        valid=marked("isothermal and fully flooded; the ends of the roller are not considered"),
    ),
    Law(
        key="dowson_line",
        rolls="roller",
        name=marked("Film thickness of a line contact (Dowson)"),
        latex=r"H_c = 3.06\,W'^{-0.10}U^{0.69}G^{0.56},\quad"
        r" H_0 = 2.65\,W'^{-0.13}U^{0.70}G^{0.54}",
        plain="H_c = 3.06 W'^−0.10 U^0.69 G^0.56,  H_0 = 2.65 W'^−0.13 U^0.70 G^0.54",
        symbols=("H", "UWG"),
        source=marked("Dowson and Toyoda (1979); Dowson (1968)"),
        references=("dowson_toyoda_1979", "dowson_1968"),
        used=_line_film("dowson_toyoda"),
        valid=marked("isothermal and fully flooded; the ends of the roller are not considered"),
    ),
    Law(
        key="wooster",
        name=marked("Pressure-viscosity coefficient, estimated"),
        latex=r"\alpha_p = (0.6 + 0.965\,\log_{10}\eta)\cdot 10^{-8}",
        plain="α_p = (0.6 + 0.965 log η) · 10⁻⁸  (1/Pa, mPa·s)",
        symbols=("alpha_p", "eta"),
        source=marked("Wooster, in Hutchings (1992); Campanha (2008), equation 4.4.1"),
        references=("hutchings_1992", "campanha_2008"),
        used=_alpha("wooster"),
        valid=marked("mineral oils"),
    ),
    Law(
        key="so_klaus",
        name=marked("Pressure-viscosity coefficient, estimated"),
        latex=r"\alpha_p = 1.216 + 4.143\,s^{3.0627} + 2.848\cdot 10^{-4} B^{5.1903} s^{1.5976}"
        r" - 3.999\,s^{3.0975} \rho^{0.1162}",
        plain="α_p = 1.216 + 4.143 s^3.0627 + 2.848e-4 B^5.1903 s^1.5976 − 3.999 s^3.0975"
        " ρ^0.1162,  s = log ν  (10⁻⁸/Pa, mm²/s, g/cm³)",
        symbols=("alpha_p", "nu"),
        source=marked("So and Klaus (1980)"),
        references=("so_klaus_1980",),
        used=_alpha("so_klaus"),
        valid=marked("mineral oils"),
    ),
    Law(
        key="murch_wilson",
        name=marked("Reduction of the film by inlet heating"),
        latex=r"\varphi_T = \frac{3.94}{3.94 + L^{0.62}}",
        plain="φ_T = 3.94/(3.94 + L^0.62)",
        symbols=("L_T",),
        source=marked("Murch and Wilson (1975)"),
        references=("murch_wilson_1975",),
        used=_thermal("murch_wilson"),
        valid=marked("rolling"),
    ),
    Law(
        key="gupta_cheng",
        name=marked("Reduction of the film by inlet heating"),
        latex=r"\varphi_T = \frac{1 - 13.2\,(p_0/E')\,L^{0.42}}"
        r"{1 + 0.213\,(1 + 2.23\,S^{0.83})\,L^{0.64}}",
        plain="φ_T = (1 − 13.2 (p_0/E') L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64)",
        symbols=("L_T", "p_0", "E_prime"),
        source=marked("Gupta et al. (1992)"),
        references=("gupta_1992",),
        used=_thermal("gupta_cheng"),
    ),
    Law(
        key="inlet_distance",
        rolls="ball",
        name=marked("Reduction of the film by starvation"),
        latex=r"\varphi_s = \left(\frac{m-1}{m^*-1}\right)^{0.29},\quad"
        r" m^* = 1 + 3.06\left[\left(\frac{R_x}{b}\right)^2 H_c\right]^{0.58}",
        plain="φ_s = ((m − 1)/(m* − 1))^0.29,  m* = 1 + 3.06 ((R_x/b)² H_c)^0.58",
        symbols=("R_x", "H", "ab"),
        source=marked("Hamrock and Dowson (1977), part IV"),
        references=("hamrock_dowson_1977",),
        used=_starved("inlet_distance"),
    ),
    Law(
        key="replenishment",
        name=marked("Reduction of the film by starvation"),
        latex=r"\varphi_{rs} = \exp\left[-K_{rs}\,\nu\,n\,(d + D)"
        r"\sqrt{\frac{K_z}{2\,(D-d)}}\right]",
        plain="φ_rs = exp(−K_rs ν n (d + D) √(K_z/(2 (D − d))))",
        symbols=("nu", "n"),
        source=marked("SKF, General catalogue (2018)"),
        references=("skf_2018",),
        used=_starved("replenishment"),
    ),
    Law(
        key="film_parameter",
        rolls="ball",
        name=marked("Film parameter"),
        latex=r"\lambda = \frac{h_c}{\sqrt{R_{q,race}^2 + R_{q,ball}^2}}",
        plain="λ = h_c/√(R_q,race² + R_q,ball²)",
        symbols=("lambda", "R_q"),
        source=marked("Hamrock and Dowson (1977)"),
        references=("hamrock_dowson_1977",),
        used=_roughness,
    ),
    Law(
        key="roller_film_parameter",
        rolls="roller",
        name=marked("Film parameter"),
        latex=r"\lambda = \frac{h_c}{\sqrt{R_{q,race}^2 + R_{q,roller}^2}}",
        plain="λ = h_c/√(R_q,race² + R_q,roller²)",
        symbols=("lambda", "R_q"),
        source=marked("Hamrock and Dowson (1977)"),
        references=("hamrock_dowson_1977",),
        used=_roughness,
    ),
    Law(
        key="minimum_power",
        rolls="ball",
        name=marked("Ball motion of minimum friction power"),
        latex=r"\min_{\omega_b,\,\omega_m} \int\!\!\int \mu\,p\,|\mathbf{v}|\,dA",
        plain="min ∫∫ μ p |v| dA",
        symbols=("mu",),
        source=marked("Jones (1959), without forces of inertia"),
        references=("jones_1959",),
        used=_torque_model("jones_full", "jones_control"),
        valid=marked("dry or boundary friction, low speed"),
    ),
    Law(
        key="spin_moment",
        rolls="ball",
        name=marked("Spin moment of a contact"),
        latex=r"M_s = \frac{3}{8}\,\mu\,Q\,a\,E(m)",
        plain="M_s = (3/8) μ Q a E(m)",
        symbols=("mu", "Q", "ab", "KE"),
        source=marked("Poritsky, Hewlett and Coleman (1947); Jones (1959)"),
        references=("poritsky_1947", "jones_1959"),
        used=_torque_model("jones_simplified", "todd"),
    ),
    Law(
        key="heathcote",
        rolls="ball",
        name=marked("Rolling slip of a conforming contact (Heathcote)"),
        latex=r"M_H = \frac{3}{8}\,\mu\,Q\,\frac{a^2}{R}\int_{-1}^{1}(1-s^2)\,|s^2-k^2|\,ds,"
        r"\quad k = 2\sin 10°",
        plain="M_H = (3/8) μ Q (a²/R) ∫ (1 − s²) |s² − k²| ds,  −1 < s < 1,  k = 2 sin 10°",
        symbols=("mu", "Q", "ab"),
        source=marked("Heathcote (1921); Johnson (1985), section 8.5"),
        references=("heathcote_1921", "johnson_1985"),
        used=_torque_model("jones_simplified", "todd"),
    ),
    Law(
        key="harris_1971",
        rolls="ball",
        name=marked("Friction along the rolling direction only (Harris)"),
        latex=r"q(s) = \frac{3Q}{4a}(1-s^2)",
        plain="q(s) = 3Q/(4a) (1 − s²)",
        symbols=("Q", "ab"),
        source=marked("Harris (1971); Ricci and Fleury, equations 15 to 19, corrected"),
        references=("harris_1971", "ricci_fleury"),
        used=_torque_model("harris_1971"),
        valid=marked("dry friction, low speed"),
    ),
    Law(
        key="rib_friction",
        rolls="roller",
        name=marked("Sliding on the rib"),
        latex=r"P = \mu\,F_{rib}\,v",
        plain="P = μ F_rib v",
        symbols=("mu", "F_rib"),
        source=marked("Aihara (1987)"),
        references=("aihara_1987",),
        used=_loss("rib"),
        valid=marked(
            "v sliding speed at the height of the contact on the rib; the coefficient falls"
            " with the film at the rib where the radius of the roller's end is known"
        ),
    ),
    Law(
        key="rib_coefficient",
        rolls="roller",
        name=marked("Coefficient of friction at a rib under a film"),
        latex=r"\mu = \mu_0\,e^{-1.8\,\Lambda^{1.2}}",
        plain="μ = μ_0 e^(−1.8 Λ^1.2)",
        symbols=("mu",),
        source=marked("Aihara (1987)"),
        references=("aihara_1987",),
        used=_loss("rib"),
        valid=marked("Λ film parameter at the rib, zero where that film is not known"),
    ),
    Law(
        key="hysteresis",
        rolls="ball",
        name=marked("Elastic hysteresis"),
        latex=r"M_h = \frac{3}{16}\,\alpha_h\,Q\,b",
        plain="M_h = (3/16) α_h Q b",
        symbols=("alpha_h", "Q", "ab"),
        source=marked("Greenwood, Minshall and Tabor (1961)"),
        references=("greenwood_1961",),
        used=_loss("hysteresis"),
    ),
    Law(
        key="rolling_resistance",
        rolls="ball",
        name=marked("Rolling resistance of the lubricant"),
        latex=r"P = \frac{\varphi_s}{1 + 0.29\,L^{0.78}}\,2\,F_R\,u",
        plain="P = φ_s/(1 + 0.29 L^0.78) 2 F_R u",
        symbols=("eta", "L_T"),
        source=marked("Biboulet and Houpert (2010), part 2; Aihara (1987)"),
        references=("biboulet_houpert_2010", "aihara_1987"),
        used=_loss("rolling_resistance"),
        valid=marked(
            "F_R hydrodynamic force at the inlet, isothermal and fully flooded; φ_s what starvation"
            " leaves of it, 1 where the inlets are full"
        ),
    ),
    Law(
        key="line_hysteresis",
        rolls="roller",
        name=marked("Elastic hysteresis"),
        latex=r"M_h = \frac{2}{3\pi}\,\alpha_h \int q\,b\,dx",
        plain="M_h = (2/3π) α_h ∫ q b dx",
        symbols=("alpha_h", "q", "b_line"),
        source=marked("Johnson (1985), section 9.1"),
        references=("johnson_1985",),
        used=_loss("hysteresis"),
    ),
    Law(
        key="line_resistance",
        rolls="roller",
        name=marked("Rolling resistance of the lubricant"),
        latex=r"P = 2\,\varphi_s\,u\int t\,dx,\quad t = \frac{88\,R_x}{\alpha_p}\,"
        r"\frac{(G U)^{0.658}\,W'^{0.31}}{1 + 0.29\,L^{0.78}}",
        plain="P = 2 φ_s u ∫ t dx,  t = 88 (R_x/α_p) (G U)^0.658 W'^0.31/(1 + 0.29 L^0.78)",
        symbols=("UWG", "R_x", "alpha_p", "L_T", "eta"),
        source=marked("Aihara (1987)"),
        references=("aihara_1987",),
        used=_loss("rolling_resistance"),
        valid=marked(
            "t force of the oil on each surface per length, fully flooded; φ_s what starvation"
            " leaves of it, 1 where the inlets are full"
        ),
    ),
    Law(
        key="friction_coefficient",
        name=marked("Coefficient of friction by the regime of lubrication"),
        latex=r"\mu = \varphi_{bl}\,\mu_{bl} + (1-\varphi_{bl})\,\mu_{EHL},\quad"
        r" \varphi_{bl} = \exp\left[-2.6\cdot 10^{-8}\,(\nu\,n)^{1.4}\,d_m\right]",
        plain="μ = φ_bl μ_bl + (1 − φ_bl) μ_EHL,  φ_bl = exp(−2.6·10⁻⁸ (ν n)^1.4 d_m)",
        symbols=("mu", "nu", "n", "d_m"),
        source=marked("SKF, Rolling bearings (2013), table 2"),
        references=("skf_2013",),
        used=_by_regime,
        valid=marked("no coefficient given; mm²/s, rpm, mm"),
    ),
    Law(
        key="palmgren",
        name=marked("Friction torque by Palmgren"),
        latex=r"M_0 = 10^{-7} f_0\,(\nu n)^{2/3}\,d_m^3,\quad M_1 = f_1\,P_1\,d_m",
        plain="M_0 = 10⁻⁷ f_0 (ν n)^(2/3) d_m³,  M_1 = f_1 P_1 d_m  (N·mm, mm²/s, rpm, mm)",
        symbols=("nu", "n", "d_m"),
        source=marked("Palmgren (1959); Harris (1991), chapter 14"),
        references=("palmgren_1959", "harris_1991"),
        used=_torque_model("palmgren"),
        valid=marked("lubricated bearings, moderate speed and load"),
    ),
    Law(
        key="palmgren_ribs",
        rolls="roller",
        name=marked("Friction torque of the ribs by Palmgren"),
        latex=r"M_2 = f_2\,F_a\,d_m",
        plain="M_2 = f_2 F_a d_m",
        symbols=("F_ra", "d_m"),
        source=marked("Palmgren (1959); Harris (1991), chapter 14"),
        references=("palmgren_1959", "harris_1991"),
        used=_both(_torque_model("palmgren"), _element("cylindrical")),
        valid=marked("F_a up to 0.4 F_r"),
    ),
    Law(
        key="skf_friction",
        name=marked("Friction torque by SKF"),
        latex=r"M = \varphi_{ish}\,\varphi_{rs}\,G_{rr}\,(\nu n)^{0.6} + G_{sl}\,\mu_{sl}",
        plain="M = φ_ish φ_rs G_rr (ν n)^0.6 + G_sl μ_sl  (N·mm, mm²/s, rpm)",
        symbols=("nu", "n"),
        source=marked("SKF, Rolling bearings (2013), table 2"),
        references=("skf_2013",),
        used=_torque_model("skf"),
        valid=marked("without seals and oil drag"),
    ),
    Law(
        key="frequencies",
        rolls="ball",
        name=marked("Fault frequencies"),
        latex=r"f_o = \frac{Z}{2\pi}\,|\omega_m - \omega_o|,\quad"
        r" f_i = \frac{Z}{2\pi}\,|\omega_i - \omega_m|,\quad f_b = \frac{|\omega_R|}{2\pi}",
        plain="f_o = Z |ω_m − ω_o|/2π,  f_i = Z |ω_i − ω_m|/2π,  f_b = |ω_R|/2π",
        symbols=("order", "Z", "omega_m", "omega", "omega_R"),
        source=marked("Harris (1991); Braga and Almeida, equations 19 and 22"),
        references=("harris_1991", "braga_almeida"),
        used=_frequencies,
    ),
    Law(
        key="roller_frequencies",
        rolls="roller",
        name=marked("Fault frequencies"),
        latex=r"f_o = \frac{Z\,|\omega_m-\omega_o|}{2\pi},\quad f_i ="
        r" \frac{Z\,|\omega_i-\omega_m|}{2\pi},\quad f_b = \frac{|\omega_R|}{2\pi}",
        plain="f_o = Z |ω_m − ω_o|/2π,  f_i = Z |ω_i − ω_m|/2π,  f_b = |ω_R|/2π",
        symbols=("order", "Z", "omega_m", "omega"),
        source=marked("Harris (1991)"),
        references=("harris_1991",),
        used=_frequencies,
    ),
)
"""In the order in which an engineer calculates."""

REFERENCES: Final[Mapping[str, str]] = {
    "aihara_1987": "Aihara, S., A new running torque formula for tapered roller bearings under "
    "axial load, Journal of Tribology 109 (1987).",
    "astm_d341": "ASTM D341, Standard practice for viscosity-temperature equations and charts for "
    "liquid petroleum or hydrocarbon products.",
    "biboulet_houpert_2010": "Biboulet, N.; Houpert, L., Hydrodynamic force and moment in pure "
    "rolling lubricated contacts, part 2: point contacts, Proc. IMechE, Part J 224 (2010).",
    "braga_almeida": "Braga; Almeida, Movimentos relativos, internos ao rolamento de esferas.",
    "campanha_2008": "Campanha, M. V., Estudo sobre a vida útil de rolamentos fixos de uma "
    "carreira de esferas, master's dissertation, Universidade de São Paulo, 2008.",
    "de_mul_1986": "de Mul, J. M.; Kalker, J. J.; Fredriksson, B., The contact between arbitrarily "
    "curved bodies of finite dimensions, Journal of Tribology 108 (1986).",
    "dowson_1968": "Dowson, D., Elastohydrodynamics, Proc. IMechE 182 (1968).",
    "dowson_toyoda_1979": "Dowson, D.; Toyoda, S., A central film thickness formula for "
    "elastohydrodynamic line contacts, 5th Leeds-Lyon Symposium on Tribology, 1979.",
    "greenwood_1961": "Greenwood, J. A.; Minshall, H.; Tabor, D., Hysteresis losses in rolling and "
    "sliding friction, Proc. Royal Society A 259 (1961).",
    "gupta_1992": "Gupta, P. K.; Cheng, H. S.; Zhu, D.; Forster, N. H.; Schrand, J. B., "
    "Viscoelastic effects in MIL-L-7808-type lubricant, part I, Tribology Transactions 35 (1992).",
    "hamrock_dowson_1977": "Hamrock, B. J.; Dowson, D., Isothermal elastohydrodynamic lubrication "
    "of point contacts, parts III and IV, Journal of Lubrication Technology 99 (1977).",
    "harris_1971": "Harris, T. A., An analytical method to predict skidding in thrust-loaded, "
    "angular-contact ball bearings, Journal of Lubrication Technology 93 (1971).",
    "harris_1991": "Harris, T. A., Rolling Bearing Analysis, 3rd ed., Wiley, 1991.",
    "heathcote_1921": "Heathcote, H. L., The ball bearing: in the making, under test and in "
    "service, Proc. Institution of Automobile Engineers 15 (1921).",
    "hertz_1881": "Hertz, H., Über die Berührung fester elastischer Körper, Journal für die reine "
    "und angewandte Mathematik 92 (1881).",
    "hutchings_1992": "Hutchings, I. M., Tribology: Friction and Wear of Engineering Materials, "
    "1992.",
    "ioannides_harris_1985": "Ioannides, E.; Harris, T. A., A new fatigue life model for rolling "
    "bearings, Journal of Tribology 107 (1985).",
    "iso_281_1990": "ISO 281:1990, Rolling bearings: dynamic load ratings and rating life.",
    "iso_281_2007": "ISO 281:2007, Rolling bearings: dynamic load ratings and rating life.",
    "iso_4406": "ISO 4406, Hydraulic fluid power: method for coding the level of contamination by "
    "solid particles.",
    "iso_76_2006": "ISO 76:2006, Rolling bearings: static load ratings.",
    "iso_ts_16281": "ISO/TS 16281:2008, Rolling bearings: methods for calculating the modified "
    "reference rating life for universally loaded bearings.",
    "johnson_1985": "Johnson, K. L., Contact Mechanics, Cambridge University Press, 1985.",
    "jones_1959": "Jones, A. B., Ball motion and sliding friction in ball bearings, Journal of "
    "Basic Engineering 81 (1959).",
    "jones_1960": "Jones, A. B., A general theory for elastically constrained ball and radial "
    "roller bearings under arbitrary load and speed conditions, Journal of Basic Engineering 82 "
    "(1960).",
    "lame_1852": "Lamé, G., Leçons sur la théorie mathématique de l'élasticité des corps solides, "
    "Paris, 1852.",
    "lundberg_palmgren_1947": "Lundberg, G.; Palmgren, A., Dynamic capacity of rolling bearings, "
    "Acta Polytechnica, Mechanical Engineering Series 1 (1947).",
    "murch_wilson_1975": "Murch, L. E.; Wilson, W. R. D., A thermal elastohydrodynamic inlet zone "
    "analysis, Journal of Lubrication Technology 97 (1975).",
    "nsk_e1102": "NSK, Rolling Bearings, catalogue E1102.",
    "palmgren_1959": "Palmgren, A., Ball and Roller Bearing Engineering, 3rd ed., 1959.",
    "pan_hamrock_1989": "Pan, P.; Hamrock, B. J., Simple formulas for performance parameters used "
    "in elastohydrodynamically lubricated line contacts, Journal of Tribology 111 (1989).",
    "poritsky_1947": "Poritsky, H.; Hewlett, C. W.; Coleman, R. E., Sliding friction of ball "
    "bearings of the pivot type, Journal of Applied Mechanics 14 (1947).",
    "radaelli_2013": "Radaelli, G. Z., Determinação do carregamento dinâmico em mancais de esfera "
    "de contato angular, master's dissertation, Universidade Estadual de Campinas, 2013.",
    "ricci_fleury": "Ricci; Fleury, friction torque of ball bearings of space mechanisms.",
    "skf_2013": "SKF, Rolling bearings, catalogue 10000 EN, 2013.",
    "skf_2018": "SKF, General catalogue, 2018.",
    "so_klaus_1980": "So, B. Y. C.; Klaus, E. E., Viscosity-pressure correlation of liquids, ASLE "
    "Transactions 23 (1980).",
    "takemura_2000": "Takemura, H.; Matsumoto, Y.; Murakami, Y., 2000, as in Campanha (2008).",
    "tallian_1971": "Chiu, Y. P.; Tallian, T. E.; McCool, J. I., An engineering model of spalling "
    "fatigue in rolling contact, Wear 17 (1971).",
    "thomas_hoersch_1930": "Thomas, H. R.; Hoersch, V. A., Stresses due to the pressure of one "
    "elastic solid upon another, University of Illinois Bulletin 212 (1930).",
    "timoshenko_1970": "Timoshenko, S. P.; Goodier, J. N., Theory of Elasticity, 3rd ed., "
    "McGraw-Hill, 1970.",
}
"""As they are written in any language."""


def equations_of(cases: Iterable[CaseReport]) -> tuple[Equation, ...]:
    """Return the equations that cases with a result rest on, numbered; a symbol stands once."""
    solved = [case for case in cases if case.converged]
    found: list[Equation] = []
    known: set[str] = set()
    rollers = not any("ball" in _rolls(case) for case in solved)
    for law in EQUATIONS:
        if not any(law.of(case) for case in solved):
            continue
        new = [key for key in law.symbols if key not in known]
        known.update(new)
        found.append(
            Equation(
                name=said(law.name),
                latex=law.latex,
                plain=law.plain,
                symbols=tuple(_symbol(key, rollers=rollers) for key in new),
                source=said(law.source),
                valid=said(law.valid) if law.valid else "",
                number=len(found) + 1,
            )
        )
    return tuple(found)


def references_of(cases: Iterable[CaseReport]) -> tuple[str, ...]:
    """Return the works that the equations of cases come from, in the order of the alphabet."""
    solved = [case for case in cases if case.converged]
    keys = {
        key for law in EQUATIONS if any(law.of(case) for case in solved) for key in law.references
    }
    return tuple(REFERENCES[key] for key in sorted(keys))


def _symbol(key: str, *, rollers: bool) -> Symbol:
    """What a symbol means; rollers: where nothing else rolls."""
    symbol, meaning, unit = {**SYMBOLS, **_OF_ROLLERS}[key] if rollers else SYMBOLS[key]
    return Symbol(symbol, said(meaning), unit)
