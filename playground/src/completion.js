// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { descriptionOf, keysOf, nodeAt, valuesOf } from './schema.js';

const kHeader = /^[ \t]*\[\[?([\w.\-]+)\]\]?/gm;
const kOpenHeader = /^\s*\[{1,2}([\w.\-]*)$/;
const kOpenValue = /^\s*([\w\-]+)\s*=\s*(.*)$/;
const kWord = /"?[\w\-]*$/;

function isList(node) {
  return node?.type === 'array';
}

function isTable(node) {
  return keysOf(node).size > 0;
}

// All tables that headers may name, with the path of each.
function tablesOf(node, path = []) {
  return [...keysOf(node)].flatMap(([name, inner]) => {
    if (!isTable(inner)) return [];
    const here = [...path, name];
    return [{ path: here, node: inner }, ...tablesOf(inner, here)];
  });
}

function optionsOfTables(schema) {
  return tablesOf(schema)
    .filter(({ node, path }) => path.length === 1 || node.type === 'object' || isList(node))
    .map(({ path, node }) => {
      const name = path.join('.');
      const label = isList(node) && node.items?.type !== 'array' ? `[[${name}]]` : `[${name}]`;
      return { label, type: 'namespace', info: descriptionOf(node), boost: -path.length };
    });
}

function optionsOfKeys(table) {
  return [...keysOf(table)].map(([name, node]) => ({
    label: name,
    apply: `${name} = `,
    type: 'property',
    info: descriptionOf(node),
  }));
}

/**
 * What may follow at `position` of a scenario: headers of tables, keys of the table there, or values of the key on the line.
 * {from, options, closed}, or null: the first two as CodeMirror wants them; `closed` matches what an editor has closed by itself after
 * `position`, and which is replaced, too.
 */
export function completionsAt(schema, text, position) {
  const before = text.slice(0, position);
  const line = before.slice(before.lastIndexOf('\n') + 1);
  if (/^[^"']*#/.test(line)) return null;
  const openHeader = kOpenHeader.exec(line);
  if (openHeader) return { from: position - line.trimStart().length, options: optionsOfTables(schema), closed: /^\]*/ };
  const header = [...before.matchAll(kHeader)].at(-1);
  const table = nodeAt(schema, header ? header[1].split('.') : []);
  const word = kWord.exec(line)[0];
  const value = kOpenValue.exec(line);
  if (value) {
    // Within { }, the last key that was begun.
    const inner = [...value[2].matchAll(/([\w\-]+)\s*=/g)].at(-1);
    const outer = keysOf(table).get(value[1]);
    if (/\{[^}]*$/.test(value[2]) && /[{,]\s*[\w\-]*$/.test(value[2])) return { from: position - word.length, options: optionsOfKeys(outer), closed: /^/ };
    const node = inner ? keysOf(outer).get(inner[1]) : outer;
    const options = valuesOf(node).map((each) => ({ label: JSON.stringify(each), type: 'enum' }));
    return options.length > 0 ? { from: position - word.length, options, closed: word.startsWith('"') ? /^"?/ : /^/ } : null;
  }
  if (!/^\s*[\w\-]*$/.test(line)) return null;
  const ofTables = line.trim() === '' ? optionsOfTables(schema) : [];
  return { from: position - word.length, options: [...(header ? optionsOfKeys(table) : []), ...ofTables], closed: /^/ };
}
