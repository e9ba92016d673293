// Questions to the session, asked as often as it takes, and what this browser remembers.
import { wait } from "./dom.js";

export const token = location.pathname.split("/")[1];
const retryMs = 700;

/// Something that this browser remembers for this class.
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

/// Gives {status, answer}, once the session has answered whole: a killed one may do so by half.
async function request(path, options) {
  for (;;) {
    try {
      const response = await fetch(path, options);
      if (response.status !== 503) {
        const answer = await response.json();
        setOnline(true);
        return { status: response.status, answer };
      }
    } catch {
      setOnline(false);
    }
    await wait(retryMs);
  }
}

export const ask = async (path) => (await request(path)).answer;

/// Sends something that changes the class, or is too long for an address. Gives {status, answer}.
export const post = (path, body) => request(path, {
  method: "POST", headers: { "Content-Type": "application/json", "X-Ticker": token }, body: JSON.stringify(body),
});
