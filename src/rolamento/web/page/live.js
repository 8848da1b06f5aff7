// The live loop: one request in flight, the latest wins, quick ones while something moves.

import { Silent, ask, say } from "./ask.js";

const PAUSE = 150; // ms without a move, after which everything is asked for
const PATIENCE = 300; // ms until it is shown that an answer is awaited

/**
 * Keep what is shown in step with the cases.
 * @param {import("./store.js").Store} store
 * @param {object} hooks  `root`: what shows that an answer is awaited; `wishes(quick)`: keys of
 *   pictures and sections; `waiting()`; `show(answer, quick, asked)`; `stale(word)`: says why what
 *   is shown is not current; `recover(error)`: waits for a server that is away; `complain(error)`;
 *   `path`, `request(cases)` and `taken(answer)`: where it asks, how, and the answers to the
 *   cases, for what is no bearing's case
 * @returns {{follow: (quick?: boolean) => void, restart: () => void}}
 */
export function liveLoop(store, {
  root, wishes, waiting = () => {}, show, stale, recover, complain, path = "live", request = (cases) => ({ cases }), taken = (answer) => answer.cases,
}) {
  let flying = null; // the request that is under way
  let again = null; // "quick" or "full": what goes when it lands
  let timer = 0;
  let asking = 0; // timer of the sign that an answer is awaited

  function answered() {
    clearTimeout(asking);
    asking = 0;
    root.classList.remove("asking");
  }

  async function failed(error) {
    if (error instanceof Silent || [429, 503].includes(error.status)) {
      for (const slot of store.slots) slot.status = null;
      stale(say("stale.silent"));
      await recover(error);
      follow();
      return;
    }
    answered();
    stale(say("stale.wrong"));
    complain(error);
  }

  async function fly(quick) {
    const mine = { quick, stop: new AbortController() };
    flying = mine;
    const cases = store.asked;
    try {
      const answer = await ask(path, { ...request(cases), quick, ...wishes(quick) }, { signal: mine.stop.signal });
      if (flying !== mine) return;
      store.take(taken(answer), cases);
      if (!quick && !store.slots.some((one) => one.error)) store.settled();
      answered();
      show(answer, quick, cases);
    } catch (error) {
      if (flying !== mine || error.name === "AbortError") return;
      again = null;
      clearTimeout(timer);
      failed(error);
    } finally {
      if (flying === mine) {
        flying = null;
        const next = again;
        again = null;
        if (next) fly(next === "quick");
      }
    }
  }

  function follow(quick = false) {
    waiting();
    asking ||= setTimeout(() => root.classList.add("asking"), PATIENCE);
    clearTimeout(timer);
    if (quick) timer = setTimeout(follow, PAUSE);
    if (flying?.quick) {
      again = quick ? (again ?? "quick") : "full"; // it lands in a moment
      return;
    }
    flying?.stop.abort();
    fly(quick);
  }

  /** After cases were put in place of others: what is under way is of no use. */
  function restart() {
    flying?.stop.abort();
    flying = again = null;
    follow();
  }

  return { follow, restart };
}
