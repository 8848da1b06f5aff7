"""What the report of the verification says, in two languages.

The checks explain themselves in English; the Portuguese of their sentences is here. One that nobody
has translated stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from rolamento.verification import CheckVerdict

__all__ = ["VERIFICATION_WORDS", "VerificationWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class VerificationWords:
    """All that is said about a verification in one language."""

    decimal_mark: str
    quantity: str
    printed: str
    computed: str
    difference: str
    tolerance: str
    proof: str
    verdict: str
    verdicts: Mapping[CheckVerdict, str]
    summary: str
    proof_note: str
    progress: str
    sentences: Mapping[str, str] = field(default_factory=dict)
    terms: Mapping[str, str] = field(default_factory=dict)

    def sentence(self, english: str) -> str:
        """Say an explanation in this language."""
        return self.sentences.get(english, english)

    def term(self, english: str) -> str:
        """Say a citation or the name of a quantity in this language, word by word."""
        if not self.terms:
            return english
        return re.sub("|".join(self.terms), lambda found: self.terms[found[0]], english)


ENGLISH: Final = VerificationWords(
    decimal_mark=".",
    quantity="quantity",
    printed="printed",
    computed="computed",
    difference="difference",
    tolerance="tolerance",
    proof="proof",
    verdict="verdict",
    verdicts={"agrees": "agrees", "explained": "explained", "fails": "fails"},
    summary="{count} numbers: {agrees} agree, {explained} explained, {fails} fail",
    proof_note=(
        "Proof of an explanation: what the program gives with the author's choice, which must be"
        " the printed number; where the print is wrong, the number that should have been printed,"
        " which must be the computed one."
    ),
    progress="Verifying {number} of {count}: {name} …",
)

PORTUGUESE: Final = VerificationWords(
    decimal_mark=",",
    quantity="grandeza",
    printed="impresso",
    computed="calculado",
    difference="diferença",
    tolerance="margem",
    proof="prova",
    verdict="veredito",
    verdicts={"agrees": "confere", "explained": "explicado", "fails": "falha"},
    summary="{count} números: {agrees} conferem, {explained} explicados, {fails} falham",
    proof_note=(
        "Prova de uma explicação: o que o programa dá com a escolha do autor, que tem de ser o"
        " número impresso; onde o impresso está errado, o número que deveria estar lá, que tem de"
        " ser o calculado."
    ),
    progress="Verificando {number} de {count}: {name} …",
    terms={
        "over the pair's preload or rigidity": "sobre a pré-carga ou a rigidez do par",
        "unloading load": "carga-limite",
        "axial rigidity": "rigidez axial",
        "preload": "pré-carga",
        "General Catalogue, page": "Catálogo geral, página",
        "catalogue 4000 0813 EN, page": "catálogo 4000 0813 EN, página",
        "catalogue 4000 0813 EN, table of bearing data": (
            "catálogo 4000 0813 EN, tabela de dados dos rolamentos"
        ),
        "Reference program for": "Programa de referência para a",
        "as in": "como em",
        "chapter": "capítulo",
        "dimensionless contact parameters": "parâmetros adimensionais de contato",
        "example": "exemplo",
        "text before figure": "texto antes da figura",
        "text after figure": "texto depois da figura",
        "text to figure": "texto da figura",
        "table of": "tabela de",
        "table": "tabela",
        "radial load": "carga radial",
        "axial load": "carga axial",
        "drive-end bearing": "rolamento do lado do acionamento",
        "at rest": "em repouso",
        "fall of": "queda de",
        " of Harris": " de Harris",
        "cage": "gaiola",
        "outer race": "pista externa",
        "inner race": "pista interna",
        "ball, twice": "esfera, duas vezes",
        "turn": "volta",
        "viscosity index": "índice de viscosidade",
        ", bearing new": ", rolamento novo",
        ", bearing": ", rolamento",
        ", condition": ", condição",
        ", convex": ", convexa",
        "without test": "sem o ensaio",
        "L_10h, all": "L_10h, todos",
    },
    sentences={
        "The tolerance includes what the rounding of the printed F(ρ) leaves open.": (
            "A margem inclui o que o arredondamento do F(ρ) impresso deixa em aberto."
        ),
        "A misprint, three units of the last digit off: the printed a* and b* of the same row"
        " give 0.9432, as the exact solution does.": (
            "Erro de impressão, de três unidades do último algarismo: o a* e o b* impressos na"
            " mesma linha dão 0,9432, como a solução exata."
        ),
        "(1 - X)/Y with the printed factors, whose own rounding leaves the last digit open.": (
            "(1 - X)/Y com os fatores impressos, cujo arredondamento deixa em aberto o último"
            " algarismo."
        ),
        "(1 - X_2)/(Y_2 - Y_1) with the printed factors; the tolerance includes what their own"
        " rounding leaves open.": (
            "(1 - X_2)/(Y_2 - Y_1) com os fatores impressos; a margem inclui o que o arredondamento"
            " deles deixa em aberto."
        ),
        "The load that makes 4200 MPa, by exact Hertz with 207 GPa and 0.3, grooves of 0.52 and"
        " 0.53.": (
            "A carga que faz 4200 MPa, por Hertz exato com 207 GPa e 0,3, pistas de 0,52 e 0,53."
        ),
        "By exact Hertz 15.653 with 207 GPa and 0.3: the table's one number that is not the"
        " rounded one. Tolerance: 0.003 more than half a digit.": (
            "Por Hertz exato 15,653 com 207 GPa e 0,3: o único número da tabela que não é o"
            " arredondado. Margem: 0,003 além de meio algarismo."
        ),
        "SKF rounds 2^0.7 to 1.62 for the rating of a pair. Tolerance: half of the last digit"
        " that is not zero.": (
            "A SKF arredonda 2^0,7 para 1,62 na capacidade de um par. Margem: meio do último"
            " algarismo que não é zero."
        ),
        "The author rounds the inner groove's radius to 5.21 mm; the outer conformity is 0.53. The"
        " standard raises no rating for closer grooves: this factor is theory.": (
            "O autor arredonda o raio da pista interna para 5,21 mm; a conformidade externa é 0,53."
            " A norma não aumenta a capacidade por pistas mais justas: este fator é teoria."
        ),
        "The program balances its ball loads to some 1e-5, of which the life takes the cube:"
        " tolerance 1e-4.": (
            "O programa equilibra as cargas das esferas a cerca de 1e-5, e a vida leva o seu cubo:"
            " margem 1e-4."
        ),
        "With the contact stiffness of the free contact angle, as the standard keeps it, the balls"
        " stand 0.0006° steeper and carry less. Tolerance 3e-5: the cube of 1e-5 in the loads.": (
            "Com a rigidez de contato do ângulo livre, como a norma a mantém, as esferas ficam"
            " 0,0006° mais inclinadas e levam menos. Margem 3e-5: o cubo de 1e-5 nas cargas."
        ),
        "The digits beyond the printed ones are cut off, not rounded.": (
            "Os algarismos além dos impressos foram cortados, não arredondados."
        ),
        "By hand: δ* comes out 0.2 to 0.3 % too low, the stiffness 0.4 to 0.8 % too high."
        " Radaelli's table gives the number by computer beside it.": (
            "À mão: δ* sai de 0,2 a 0,3 % baixo demais, e a rigidez de 0,4 a 0,8 % alta demais. A"
            " tabela de Radaelli traz ao lado o número por computador."
        ),
        "By hand: the continuous load integral, J_r cut to 0.218. The equilibrium counts the"
        " balls where they stand.": (
            "À mão: a integral contínua de carga, com J_r cortado em 0,218. O equilíbrio conta as"
            " esferas onde estão."
        ),
        "The continuous load integral, and the digits beyond the printed ones cut off. The"
        " equilibrium counts the balls where they stand.": (
            "A integral contínua de carga, com os algarismos além dos impressos cortados. O"
            " equilíbrio conta as esferas onde estão."
        ),
        "By hand, ended after three iterations (Radaelli's appendix C), whose table gives the"
        " number by computer beside it.": (
            "À mão, parando após três iterações (apêndice C de Radaelli, cuja tabela traz ao lado"
            " o número por computador)."
        ),
        "Follows from the contact angle of the hand calculation: Q = F_a/(Z sin α).": (
            "Segue do ângulo de contato do cálculo à mão: Q = F_a/(Z sen α)."
        ),
        "The tolerance is 1e-5 of the number where that is more than half a digit: the reference"
        " program approximates the elliptic integrals.": (
            "A margem é de 1e-5 do número onde isso passa de meio algarismo: o programa de"
            " referência aproxima as integrais elípticas."
        ),
        "The standard keeps the contact stiffness of the free contact angle, 0°, while the angle"
        " rises to 13.1°, which makes less than 1e-4 of the number. Tolerance as for radial"
        " load.": (
            "A norma mantém a rigidez de contato do ângulo livre, 0°, enquanto o ângulo sobe a"
            " 13,1°, o que faz menos de 1e-4 do número. Margem como na carga radial."
        ),
        "The author puts the whole load on one ball, and the maximum shear at half the minor"
        " semi-axis. The heaviest of 8 balls carries 5/8 of the load, and the exact depth for this"
        " ellipse is nearly a third greater. Both with the conformity 0.52 of the catalogue, at the"
        " inner race.": (
            "O autor põe toda a carga em uma só esfera, e o maior cisalhamento a meio semieixo"
            " menor. A mais carregada de 8 esferas leva 5/8 da carga, e a profundidade exata para"
            " esta elipse é quase um terço maior. Ambas com a conformidade 0,52 do catálogo, na"
            " pista interna."
        ),
        "The line of ASTM D341 through the oil's two printed viscosities gives 12.89 mm²/s at"
        " 84.8 °C; at the 83.4 °C of the text it is 4 % more.": (
            "A reta da ASTM D341 pelas duas viscosidades impressas do óleo dá 12,89 mm²/s a"
            " 84,8 °C; aos 83,4 °C do texto são 4 % a mais."
        ),
        "The printed formula gives the sum of the two surface speeds; the film rests on their mean,"
        " half of it.": (
            "A fórmula impressa dá a soma das velocidades das duas superfícies; o filme depende da"
            " média, a metade."
        ),
        "As the author has it, the hollow groove taken for a convex one. The film wants the radius"
        " of the rolling direction, 3.963 mm.": (
            "Como no texto do autor, a pista côncava tomada por convexa. O filme pede o raio da"
            " direção de rolagem, 3,963 mm."
        ),
        "As the author has it: a convex groove, x and y exchanged, an approximate formula. The"
        " ratio of the true ellipse's axes is 21.6.": (
            "Como no texto do autor: pista convexa, x e y trocados, fórmula aproximada. A razão dos"
            " eixos da elipse verdadeira é 21,6."
        ),
        "With the sum of the speeds, the convex groove and the exchanged x and y the printed film"
        " comes out; the errors nearly cancel. Right is a film a quarter thicker.": (
            "Com a soma das velocidades, a pista convexa e x e y trocados sai o filme impresso; os"
            " erros quase se anulam. O certo é um filme um quarto mais espesso."
        ),
        "The film parameter follows the film: with the author's choices the printed one comes out."
        " Right is a quarter more.": (
            "O parâmetro do filme acompanha o filme: com as escolhas do autor sai o impresso. O"
            " certo é um quarto a mais."
        ),
        "The table does not name its bearings: for each range of bores a usual one that fits is"
        " taken, with a ball under the load; C2 at both ends of its range, the other classes in the"
        " middle of theirs. Other bearings of the same range come out up to 2 µm away.": (
            "A tabela não nomeia os rolamentos: para cada faixa de furos toma-se um usual que"
            " confere, com uma esfera sob a carga; C2 nos dois extremos da sua faixa, as outras"
            " classes no meio das suas. Outros rolamentos da mesma faixa ficam a até 2 µm."
        ),
        "The text does not say it: exact median ranks, ln ln 1/(1 - F) regressed on ln t, of the"
        " four failures of procedure II alone.": (
            "O texto não o diz: postos medianos exatos, ln ln 1/(1 - F) em regressão sobre ln t,"
            " das quatro falhas só do procedimento II."
        ),
        "Printed as the life without test 5, and yet test 5 is in it: the same regression of"
        " procedure II and test 5 as failures, with tests 2 to 4 as suspensions, once each.": (
            "Impressa como a vida sem o ensaio 5, e no entanto o ensaio 5 está nela: a mesma"
            " regressão do procedimento II e do ensaio 5 como falhas, com os ensaios 2 a 4 como"
            " suspensões, uma vez cada."
        ),
        "The same regression, had each of the five tests of condition II ended with a failure."
        " Nothing failed in them.": (
            "A mesma regressão, como se cada um dos cinco ensaios da condição II tivesse terminado"
            " com falha. Neles nada falhou."
        ),
        "Maximum likelihood of all the bearings that the text names, those that did not fail with"
        " the time that they ran. The proof: the text's likelihood equations, put right and written"
        " for tests that did not all fail. Up to 40 % of the printed life is too much.": (
            "Máxima verossimilhança de todos os rolamentos que o texto cita, os que não falharam"
            " com o tempo que giraram. A prova: as equações de verossimilhança do texto, corrigidas"
            " e escritas para ensaios em que nem todos falharam. Até 40 % da vida impressa é"
            " demais."
        ),
        "Nothing failed: the ten bearings say no more than that L_10 is not below 78 h, at a"
        " confidence of 95 % and with the shape 1.5. The proof:"
        " (Σt^1.5 ln 0.9/ln 0.05)^(1/1.5).": (
            "Nada falhou: os dez rolamentos só dizem que L_10 não é menor que 78 h, com confiança"
            " de 95 % e forma 1,5. A prova: (Σt^1,5 ln 0,9/ln 0,05)^(1/1,5)."
        ),
        "The table takes the continuous load integral J_r. The equilibrium counts the balls where"
        " they stand.": (
            "A tabela usa a integral contínua de carga J_r. O equilíbrio conta as esferas onde"
            " estão."
        ),
        "The table keeps the contact stiffness of the free contact angle. That of the loaded"
        " angle prints alike.": (
            "A tabela mantém a rigidez de contato do ângulo livre. Com a do ângulo sob carga"
            " imprime-se o mesmo."
        ),
        "The digits beyond the printed ones are cut off, not rounded: 41.4949°.": (
            "Os algarismos além dos impressos foram cortados, não arredondados: 41,4949°."
        ),
        "The ring is held axially, x = 0, which the table does not say; the axial load is then a"
        " reaction of 31.1 kN.": (
            "O anel é fixo axialmente, x = 0, o que a tabela não diz; a carga axial é então uma"
            " reação de 31,1 kN."
        ),
        "A tie: 48.76497° is 48.77° when rounded twice, first to three decimals. The ring is held"
        " axially, as for the other rows.": (
            "Um empate: 48,76497° vira 48,77° se arredondado duas vezes, primeiro a três casas. O"
            " anel é fixo axialmente, como nas outras linhas."
        ),
        "The tilt is held; the moment is the reaction, with the circle of the inner groove's"
        " centres as arm. The gyroscopic moment is signed.": (
            "A inclinação é imposta; o momento é a reação, com braço até o círculo dos centros da"
            " pista interna. O momento giroscópico tem sinal."
        ),
        "The static analysis takes contact angle 0 and no clearance. With its own 40°, held"
        " axially, the bearing moves nearly half as far again, almost as far as at speed: what the"
        " text puts down to centrifugal force comes almost wholly from the contact angle.": (
            "A análise estática supõe ângulo de contato 0 e nenhuma folga. Com os seus 40°, fixo"
            " axialmente, o rolamento se desloca quase metade a mais, quase tanto como em rotação:"
            " o que o texto atribui à força centrífuga vem quase todo do ângulo de contato."
        ),
        "The conformity and the elastic constants are not published: 0.52 and 208 GPa, for all"
        " alike, give these bearings within 1 %, which is the tolerance where it is more than half"
        " a digit.": (
            "A conformidade e as constantes elásticas não são publicadas: 0,52 e 208 GPa, para"
            " todos, dão estes rolamentos dentro de 1 %, que é a margem onde passa de meio"
            " algarismo."
        ),
        "One number for all bearings, in steps of 0.05: half a step is the tolerance, or half a"
        " digit where that is more. It follows from a contact angle that does not change, as under"
        " vanishing preload. Computed for S 6012 E at light preload, whose contact angle grows"
        " under the load.": (
            "Um só número para todos os rolamentos, em passos de 0,05: a margem é meio passo, ou"
            " meio algarismo onde isso é mais. Segue de um ângulo de contato que não muda, como"
            " sob pré-carga que tende a nada. Calculado para o S 6012 E com pré-carga leve, cujo"
            " ângulo de contato cresce sob a carga."
        ),
        "2^(3/2), from a contact angle that does not change, as under vanishing preload. Computed"
        " for S 6012 E at light preload, whose contact angle grows under the load.": (
            "2^(3/2), de um ângulo de contato que não muda, como sob pré-carga que tende a nada."
            " Calculado para o S 6012 E com pré-carga leve, cujo ângulo de contato cresce sob a"
            " carga."
        ),
        "The 209 bearing without clearance.": "O rolamento 209 sem folga.",
        "The 209 bearing; both grow with the square of the speed, exactly, at any contact angle.": (
            "O rolamento 209; ambos crescem com o quadrado da rotação, exatamente, a qualquer"
            " ângulo de contato."
        ),
        "F_a from 20 to 80 kN, radial load given, tilt zero. The text says approximately.": (
            "F_a de 20 a 80 kN, carga radial dada, inclinação nula. O texto diz aproximadamente."
        ),
        "The tolerance includes what the rounding of the printed diameters leaves open; the"
        " contact angle is zero.": (
            "A margem inclui o que o arredondamento dos diâmetros impressos deixa em aberto; o"
            " ângulo de contato é zero."
        ),
    },
)

VERIFICATION_WORDS: Final[Mapping[str, VerificationWords]] = {"en": ENGLISH, "pt": PORTUGUESE}
"""By the code of the language."""
