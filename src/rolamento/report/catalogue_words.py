"""What the pages of the catalogue say, by language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from rolamento.catalogue import Origin

__all__ = ["CATALOGUE_WORDS", "CatalogueWords"]


@dataclass(frozen=True, slots=True)
class CatalogueWords:
    """The words of one language; `{…}` are filled in by the one who says it."""

    nothing: str
    more: str
    balls: str
    kinds: Mapping[str, str]
    figures: str
    names: Mapping[str, str]
    inside: str
    origins: Mapping[Origin, str]
    clearance_class: str
    meanings: str
    translated: Mapping[str, str]
    unknown: str
    candidates: str
    heads: tuple[str, ...]
    legend: str
    warning: str
    unfit: str
    no_inside: str


_PORTUGUESE: Final = {
    "stainless steel": "aço inoxidável",
    "flanged outer ring": "anel externo com flange",
    "low friction design": "projeto de baixo atrito",
    "ceramic balls": "esferas de cerâmica",
    "spindle bearing": "rolamento para fusos",
    "spindle bearing, ceramic balls": "rolamento para fusos, esferas de cerâmica",
    "spindle bearing, ceramic balls, nitrogen steel rings": (
        "rolamento para fusos, esferas de cerâmica, anéis de aço nitrogenado"
    ),
    "ceramic balls, nitrogen steel rings": "esferas de cerâmica, anéis de aço nitrogenado",
    "contact seals on both sides": "vedações de contato dos dois lados",
    "low-friction seals on both sides": "vedações de baixo atrito dos dois lados",
    "non-contact seals on both sides": "vedações sem contato dos dois lados",
    "shields on both sides": "placas de proteção dos dois lados",
    "contact seal on one side": "vedação de contato de um lado",
    "non-contact seal on one side": "vedação sem contato de um lado",
    "shield on one side": "placa de proteção de um lado",
    "non-contact seal on one side, or no cage, by maker": (
        "vedação sem contato de um lado, ou sem gaiola, conforme o fabricante"
    ),
    "snap ring in the outer ring": "anel de retenção no anel externo",
    "snap ring groove in the outer ring": "ranhura para anel de retenção no anel externo",
    "tapered bore": "furo cônico",
    "machined brass cage, guided by the outer ring": (
        "gaiola usinada de latão, guiada pelo anel externo"
    ),
    "machined brass cage, guided by the inner ring": (
        "gaiola usinada de latão, guiada pelo anel interno"
    ),
    "machined brass cage": "gaiola usinada de latão",
    "polyamide cage": "gaiola de poliamida",
    "textile-laminate cage": "gaiola de laminado têxtil",
    "textile-laminate or plastic cage, by maker": (
        "gaiola de laminado têxtil ou plástico, conforme o fabricante"
    ),
    "steel cage": "gaiola de aço",
    "tolerance class 6": "classe de tolerância 6",
    "tolerance class 5": "classe de tolerância 5",
    "tolerance class 4, running accuracy of class 2": (
        "classe de tolerância 4, exatidão de giro da classe 2"
    ),
    "tolerance class 4A of the maker": "classe de tolerância 4A do fabricante",
    "tolerance class 4": "classe de tolerância 4",
    "tolerance class 2": "classe de tolerância 2",
    "clearance for electric motors": "folga para motores elétricos",
    "for high temperature": "para alta temperatura",
    "stabilised up to 150 °C": "estabilizado até 150 °C",
    "stabilised up to 200 °C": "estabilizado até 200 °C",
    "pair back to back": "par em O (costas com costas)",
    "pair face to face": "par em X (face a face)",
    "pair in tandem": "par em tandem",
    "for universal pairing, small preload or clearance": (
        "para pareamento universal, pequena pré-carga ou folga"
    ),
    "for universal pairing, light preload": "para pareamento universal, pré-carga leve",
    "for universal pairing, no clearance": "para pareamento universal, sem folga",
    "for universal pairing, or by maker": "para pareamento universal, ou conforme o fabricante",
    "for universal pairing": "para pareamento universal",
    "for universal pairing, small clearance": "para pareamento universal, folga pequena",
    "for universal pairing, normal clearance": "para pareamento universal, folga normal",
    "for universal pairing, large clearance": "para pareamento universal, folga grande",
    "reinforced interior": "interior reforçado",
    "changed dimensions, by maker": "dimensões alteradas, conforme o fabricante",
    "grease of the maker": "graxa do fabricante",
    "quiet, for electric motors": "silencioso, para motores elétricos",
    "for universal pairing, medium preload": "para pareamento universal, pré-carga média",
    "for universal pairing, heavy preload": "para pareamento universal, pré-carga pesada",
    "flingers on both sides": "defletores dos dois lados",
    "insert bearing, set screws": "rolamento de inserção, parafusos de fixação",
    "insert bearing of stainless steel, set screws": (
        "rolamento de inserção de aço inoxidável, parafusos de fixação"
    ),
    "insert bearing, tapered bore on an adapter sleeve": (
        "rolamento de inserção, furo cônico sobre bucha de fixação"
    ),
    "insert bearing, eccentric collar": "rolamento de inserção, anel excêntrico",
    "insert bearing, cylindrical outside": "rolamento de inserção, exterior cilíndrico",
    "insert bearing without lock": "rolamento de inserção sem fixação",
    "pillow block": "mancal de pedestal",
    "pressed-steel pillow block": "mancal de pedestal de chapa estampada",
    "square flange": "flange quadrado",
    "oval flange": "flange oval",
    "round flange": "flange redondo",
    "flange": "flange",
    "pressed-steel flange": "flange de chapa estampada",
    "take-up housing": "mancal esticador",
    "cartridge housing": "mancal cartucho",
    "hanger housing": "mancal suspenso",
    "maker, whose own figures may differ": "fabricante, cujos dados podem ser outros",
    "insert bearing or unit, bore in mm": "rolamento de inserção ou mancal, furo em mm",
    "bore in sixteenths of an inch": "furo em dezesseis avos de polegada",
}

CATALOGUE_WORDS: Final[Mapping[str, CatalogueWords]] = {
    "en": CatalogueWords(
        nothing="no bearing of the catalogue is like that",
        more="… and more: type more of the designation, or --most",
        balls="balls",
        kinds={"deep_groove": "deep groove", "angular_contact": "angular contact"},
        figures="Published figures",
        names={
            "bore": "bore d",
            "outside_diameter": "outside diameter D",
            "width": "width B",
            "contact_angle": "contact angle α",
            "dynamic_rating": "dynamic rating C",
            "static_rating": "static rating C0",
            "f0": "factor f0",
            "ball_count": "balls Z",
            "ball_diameter": "ball diameter D",
            "pitch_diameter": "pitch diameter d_m",
            "inner_conformity": "inner conformity",
            "outer_conformity": "outer conformity",
            "diametral_clearance": "diametral clearance",
        },
        inside="Inside",
        origins={"published": "published", "inferred": "inferred", "assumed": "assumed"},
        clearance_class="clearance class",
        meanings="designation",
        translated={},
        unknown="not understood: {parts}",
        candidates="What the ratings allow",
        heads=("", "Z", "D mm", "", "d_m mm", "from", "to", "f_i", "f_o",
               "C %", "C0 %", "f0", "misfit", "share %"),
        legend="C, C0, f0: computed less printed; misfit 1 is as good as the printed digits,"
        " × marks a candidate that misses one by more than three tolerances; share: of the"
        " likelihood; f_i, f_o: the most open grooves that the ratings allow.",
        warning="The inside is inferred from {figures}, not published: carry the alternatives"
        " through whatever rests on it.",
        unfit="No standard balls reproduce these ratings well: the best candidates are doubtful.",
        no_inside="Neither balls nor ratings are published: give ball_count, ball_diameter and"
        " pitch_diameter, or the ratings with --dynamic and --static.",
    ),
    "pt": CatalogueWords(
        nothing="nenhum rolamento do catálogo é assim",
        more="… e mais: digite mais da designação, ou --most",
        balls="esferas",
        kinds={"deep_groove": "rígido de esferas", "angular_contact": "contato angular"},
        figures="Dados publicados",
        names={
            "bore": "furo d",
            "outside_diameter": "diâmetro externo D",
            "width": "largura B",
            "contact_angle": "ângulo de contato α",
            "dynamic_rating": "capacidade dinâmica C",
            "static_rating": "capacidade estática C0",
            "f0": "fator f0",
            "ball_count": "esferas Z",
            "ball_diameter": "diâmetro da esfera D",
            "pitch_diameter": "diâmetro primitivo d_m",
            "inner_conformity": "conformidade interna",
            "outer_conformity": "conformidade externa",
            "diametral_clearance": "folga diametral",
        },
        inside="Interior",
        origins={"published": "publicado", "inferred": "inferido", "assumed": "suposto"},
        clearance_class="classe de folga",
        meanings="designação",
        translated=_PORTUGUESE,
        unknown="não entendido: {parts}",
        candidates="O que as capacidades permitem",
        heads=("", "Z", "D mm", "", "d_m mm", "de", "a", "f_i", "f_o",
               "C %", "C0 %", "f0", "desvio", "parte %"),
        legend="C, C0, f0: calculado menos impresso; desvio 1 é tão bom quanto os dígitos"
        " impressos, × marca um candidato que erra um deles por mais de três tolerâncias; parte:"
        " da verossimilhança; f_i, f_o: os sulcos mais abertos que as capacidades permitem.",
        warning="O interior é inferido de {figures}, não publicado: leve as alternativas a tudo"
        " que se apoia nele.",
        unfit="Nenhuma esfera padrão reproduz bem estas capacidades: os melhores candidatos são"
        " duvidosos.",
        no_inside="Nem esferas nem capacidades são publicadas: dê ball_count, ball_diameter e"
        " pitch_diameter, ou as capacidades com --dynamic e --static.",
    ),
}  # fmt: skip
