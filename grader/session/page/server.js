// Requests to the session, repeated until it answers, and the browser's storage.
import { wait } from "./dom.js";

export const token = location.pathname.split("/")[1];
const retryMs = 700;
const mostBusy = 15; // requests, in ten seconds: a result that is replaced is back long before

/// Values in the browser's storage, for this class only.
export const memory = {
  get: (key, otherwise) => {
    try {
      return JSON.parse(localStorage.getItem(`ticker.${token}.${key}`)) ?? otherwise;
    } catch {
      return otherwise;
    }
  },
  set: (key, value) => localStorage.setItem(`ticker.${token}.${key}`, JSON.stringify(value)),
  remove: (key) => localStorage.removeItem(`ticker.${token}.${key}`),
};

export const connection = { isOnline: true, whenChanged: () => {} };

function setOnline(now) {
  if (connection.isOnline === now) return;
  connection.isOnline = now;
  connection.whenChanged();
}

/// Returns {status, answer} of a complete answer: a session that is killed may send half of one. A submission that is
/// being graded (503) is asked for again, but not for ever: its grading may have been interrupted.
async function request(path, options) {
  let busy = 1;
  for (;;) {
    try {
      const response = await fetch(path, options);
      const answer = await response.json();
      setOnline(true);
      if (response.status !== 503 || busy === mostBusy) return { status: response.status, answer };
      ++busy;
    } catch {
      setOnline(false);
    }
    await wait(retryMs);
  }
}

/// Returns an answer; {error} says why it is not what was asked for.
export const ask = async (path) => (await request(path)).answer;

/// Sends a request that changes the class or is too long for an address. Returns {status, answer}.
export const post = (path, body) => request(path, {
  method: "POST", headers: { "Content-Type": "application/json", "X-Ticker": token }, body: JSON.stringify(body),
});
