// What counts in a search: a heading, what a page is about, and that it explains and does not list.
const LISTING = /^(changelog|index|glossary|verification|adr\/|gallery\/|reference\/)/;
let asked; // words, as the index has them

/** How much a page is about what is asked: for each word the digit that `weigh` gave the page. */
const about = (docname) => {
  const { docnames, terms, titleterms, weights } = Search._index;
  asked ??= splitQuery(new URLSearchParams(location.search).get("q")?.toLowerCase() ?? "")
    .map((word) => new Stemmer().stemWord(word));
  const place = docnames.indexOf(docname);
  return asked.reduce((sum, word) => sum + Number(weights[word]?.[[terms[word] ?? [], titleterms[word] ?? []].flat().indexOf(place)] ?? 0), 0);
};

var Scorer = {
  score: ([docname, title, anchor, description, score]) => score + about(docname) - (LISTING.test(docname) ? 5 : 0),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
