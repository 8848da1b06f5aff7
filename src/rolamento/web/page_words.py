"""What the page says, by the keys that its scripts and its HTML use."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.words import manner, marked, said

__all__ = ["WORDS", "page_words"]

WORDS: Final[Mapping[str, str]] = {
    "close": marked("Close"),
    "compare": marked("Compare"),
    "compare.add": marked("Add a case"),
    "compare.alike": marked("The cases have the same inputs: change one of them."),
    "compare.differs": marked("What differs"),
    "compare.drop": marked("Take out: {name}"),
    "compare.edit": marked("Edited case"),
    "compare.edit.one": marked("Edit {name}"),
    "compare.name": marked("Name of {name}"),
    "compare.same": marked("The same in all"),
    "compare.end": marked("Continue with this one alone"),
    "curve": marked("Curve over a field"),
    "curve.field": marked("Over"),
    "curve.high": marked("To"),
    "curve.low": marked("From"),
    "curve.output": marked("Output"),
    "curve.scale": marked("logarithmic field"),
    "curve.upright": marked("logarithmic output"),
    "first.go": marked("Calculate"),
    "first.head": marked("What does it carry?"),
    "first.status": marked("Waiting for a load and a speed."),
    "first.text": marked("Give at least one load; units may be typed, such as 5 kN or 1480 rpm."),
    "form.about": marked("About: {label}"),
    "form.add": marked("Add: {label}"),
    "form.clear": marked("Clear: {label}"),
    "form.example": marked("Example: {example}."),
    "form.filter": marked("Find a field"),
    "form.gave": marked("gave way to: {label}"),
    "form.instead": marked("Give instead: {label}"),
    "form.limits": marked("Allowed: {limits}."),
    "form.more": marked("More fields"),
    "form.remove": marked("Remove: {label}"),
    "form.slider": marked("{label}, slider"),
    "form.unit": marked("{label}, unit"),
    "form.unsaid": marked("{value} (not given)"),
    "form.use": marked("Use {example}"),
    "helps": marked("What would help most"),
    "helps.try": marked("Try it"),
    "language": marked("Language"),
    "link.broken": marked("The link holds no case: it is damaged, incomplete or too long."),
    "machine.bent": marked(
        "Lines of deflection, {times} times as large: z continuous, y (into the paper) dashed."
    ),
    "machine.drawing": marked("The machine in section, to scale, with its bearings and loads"),
    "machine.file": marked("Machine file"),
    "machine.file.help": marked(
        "TOML or JSON, chosen here or dropped on the page; tables and matrices stand in it."
    ),
    "machine.large": marked("The file is too large for a machine: at most 500 kB are read."),
    "machine.open.head": marked("Which machine?"),
    "machine.part": marked("Part"),
    "machine.parts": marked("Parts on the shafts, to be moved with the pointer or the arrow keys"),
    "machine.position": marked("{part}, position on {shaft}"),
    "machine.save.json": marked("Save as JSON"),
    "machine.step": marked("Step shown"),
    "machine.tools": marked("The machine"),
    "machine.untitled": marked("Machine"),
    "notes": marked("Remarks"),
    "notes.none": marked("No remarks."),
    "number.doubt": marked(
        "may be {decimal} or, with a point between thousands, {whole}; write it without that point"
    ),
    "open": marked("Open"),
    "open.examples": marked("Examples"),
    "open.file": marked("Case file"),
    "open.file.help": marked("TOML or JSON, chosen here or dropped on the page."),
    "open.as": marked("Open as typed"),
    "open.choose": marked("Choose one of the bearings below."),
    "open.found": marked("In the catalogue: {n}"),
    "open.go": marked("Open bearing"),
    "open.large": marked("The file is too large for a case: at most 500 kB are read."),
    "open.near": marked("Did you mean:"),
    "open.many": marked("In the catalogue: more than {n}; type more of the designation"),
    "open.more": marked("Beyond one bearing"),
    "open.search": marked("Designation or dimensions"),
    "open.search.help": marked(
        "For instance 6310/C3, NU 205, 7014 C/HCP4A DBA, or 25x52 (bore and outside diameter, mm)."
    ),
    "start.lead": marked(
        "Name a bearing and its load, and see what happens inside: contact loads and pressures, "
        "oil film, friction, heat and life, each with its limit and its source."
    ),
    "start.machine": marked("A machine: shafts, gears and bearings together"),
    "start.private": marked("Everything is computed on this machine; nothing is sent elsewhere."),
    "start.record": marked("A vibration record: which part of the bearing is damaged?"),
    "start.test": marked("A life test: Weibull, confidence, and the next test"),
    "start.title": marked("Rolling bearings, from the inside"),
    "page.failed": marked("Something went wrong in this page. Reload it: the case is kept."),
    "pages": marked("Pages"),
    "pane.form": marked("Inputs"),
    "pane.results": marked("Results"),
    "panes": marked("What is shown"),
    "pictures.azimuth": marked("Azimuth (°)"),
    "pictures.line": marked("line"),
    "pictures.save": marked("Save picture"),
    "pictures.table": marked("Numbers"),
    "redo": marked("Redo"),
    "report.html": marked("Report (HTML)"),
    "report.pdf": marked("Report (PDF)"),
    "reset": marked("Reset to opened"),
    "save": marked("Save"),
    "seek": marked("Which input gives a wanted result?"),
    "seek.go": marked("Look for it"),
    "seek.help": marked(
        "A preload for a stiffness, a clearance for a pressure, a load for a life: any input for "
        "any result."
    ),
    "seek.looking": marked("Looking …"),
    "seek.others": marked("All others"),
    "seek.output": marked("Result"),
    "seek.use": marked("Use {value}"),
    "seek.usual": marked("Asked for most"),
    "seek.vary": marked("Input to vary"),
    "seek.wanted": marked("Value that it should have"),
    "section.none": marked("There is nothing of this for the present case."),
    "server.failed": marked("The server answered in a form that this page does not understand."),
    "server.silent": marked(
        "The server of Rolamento does not answer. If it was closed, start it again with "
        '"rolamento app"; this page tries again by itself.'
    ),
    "share": marked("Share"),
    "share.copied": marked("Copied."),
    "share.copy": marked("Copy the link"),
    "share.head": marked("Share this case"),
    "share.help": marked(
        "The whole case is in the link itself; nothing is stored on a server. "
        "Whoever opens it needs Rolamento running at the same address."
    ),
    "share.link": marked("Link"),
    "share.select": marked("Copying is not allowed here; the link is selected: press Ctrl+C."),
    "skip": marked("Skip to the content"),
    "stale.part": marked("Being completed"),
    "stale.silent": marked("Not current: the server does not answer"),
    "stale.waiting": marked("Not current: being calculated"),
    "stale.wrong": marked("Not current: from the last valid input"),
    "status.converged": marked("Converged"),
    "summary": marked("Main results"),
    "theme": marked("Colours"),
    "theme.auto": marked("As the system"),
    "theme.dark": marked("Dark"),
    "theme.light": marked("Light"),
    "tools": marked("The case"),
    "tolerance": marked("How far do the results scatter?"),
    "tolerance.add": marked("Scatter it"),
    "tolerance.help": marked(
        "Manufacture, fits and loads are never exact. Each input scatters normally around its "
        "value, its tolerance being three standard deviations."
    ),
    "tolerance.more": marked("Another input"),
    "tolerance.most": marked("Must be from 0 to {most}."),
    "tolerance.none": marked("This case has no input that could scatter."),
    "tolerance.output": marked("Result drawn"),
    "undo": marked("Undo"),
    "untitled": marked("Bearing"),
    "view.api": marked("API"),
    "view.case": marked("Case"),
    "view.machine": marked("Machine"),
    "view.signal": marked("Vibration"),
    "view.weibull": marked("Life tests"),
    "warming": marked(
        "Getting ready in the background, {part} % done: the first answers take longer."
    ),
    "warnings": marked("Warnings"),
}
"""By key, in English; a name in braces is filled in by the page."""


def page_words() -> dict[str, str]:
    """Return the words of the page in the language that is spoken, and its decimal mark."""
    return {key: said(text) for key, text in WORDS.items()} | {"decimal.mark": manner().mark}
