// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kHeader = /\[\[?\s*([\w.\-]+)\s*\]\]?/y;
const kKey = /([\w.\-]+)\s*=/y;
const kNumber = /[+-]?\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d+)?(?![\w.:\-])/y;
const kWord = /[\w.\-+]+/y;

function match(pattern, text, at) {
  pattern.lastIndex = at;
  return pattern.exec(text);
}

// The end of the string that begins at `at`.
function endOfString(text, at) {
  const quote = text[at];
  const mark = text.startsWith(quote.repeat(3), at) ? quote.repeat(3) : quote;
  let end = at + mark.length;
  while (end < text.length && !text.startsWith(mark, end)) {
    if (mark.length === 1 && text[end] === '\n') return end;
    end += quote === '"' && text[end] === '\\' ? 2 : 1;
  }
  return end + mark.length;
}

/**
 * The numbers in a text in TOML, in order: {path, keys, from, to, value, isWhole}.
 *
 * `path` names the number as in "spheres.0.radius" or "box.size.2"; `keys` are its parts without the indices of arrays.
 * text.slice(from, to) is the number. A text that is not TOML has those up to where it is not.
 */
export function numbersOf(text) {
  const numbers = [];
  const counts = new Map(); // of arrays of tables
  let table = [];
  let key = null; // of the value that is read, or null
  let inside = []; // arrays {index} and tables {key} within the value, outermost first
  let at = 0;
  while (at < text.length) {
    const letter = text[at];
    if (letter === '#') {
      const end = text.indexOf('\n', at);
      at = end < 0 ? text.length : end;
    } else if (letter === '\n' && inside.length === 0) {
      key = null;
      ++at;
    } else if (/\s/.test(letter)) {
      ++at;
    } else if (key === null) {
      const header = match(kHeader, text, at);
      const begun = header ?? match(kKey, text, at);
      if (!begun) {
        const end = text.indexOf('\n', at);
        at = end < 0 ? text.length : end;
        continue;
      }
      at += begun[0].length;
      if (!header) {
        key = begun[1].split('.');
        continue;
      }
      const name = header[1];
      table = name.split('.').flatMap((part, level, all) => {
        const upTo = all.slice(0, level + 1).join('.');
        if (upTo === name && header[0].startsWith('[[')) counts.set(upTo, (counts.get(upTo) ?? -1) + 1);
        return counts.has(upTo) ? [part, counts.get(upTo)] : [part];
      });
    } else if (letter === '"' || letter === "'") {
      at = endOfString(text, at);
    } else if (letter === '[' || letter === '{') {
      inside.push(letter === '[' ? { index: 0 } : { key: null });
      ++at;
    } else if (letter === ']' || letter === '}') {
      inside.pop();
      ++at;
    } else if (letter === ',') {
      const innermost = inside.at(-1);
      if (innermost && 'index' in innermost) ++innermost.index;
      ++at;
    } else {
      const innermost = inside.at(-1);
      const inner = innermost && 'key' in innermost ? match(kKey, text, at) : null;
      if (inner) {
        innermost.key = inner[1];
        at += inner[0].length;
        continue;
      }
      const number = match(kNumber, text, at);
      if (number) {
        const parts = [...table, ...key, ...inside.map((part) => part.key ?? part.index)];
        numbers.push({
          path: parts.join('.'),
          keys: parts.filter((part) => typeof part === 'string'),
          from: at,
          to: at + number[0].length,
          value: Number(number[0].replaceAll('_', '')),
          isWhole: /^[+-]?[\d_]+$/.test(number[0]),
        });
      }
      at += (number ?? match(kWord, text, at) ?? [' '])[0].length;
    }
  }
  return numbers;
}
