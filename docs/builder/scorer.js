// What counts in a search: pages that explain stand before those that list.
var Scorer = {
  score: ([docname, title, anchor, description, score]) =>
    score - (/^(changelog|index|glossary|verification|adr\/|gallery\/|reference\/)/.test(docname) ? 3 : 0),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
