// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Sets formulas with the KaTeX whose file is named: for each line, [formula, whether it is displayed] in JSON,
// writes one with its markup, {html}, or {error}.
const katex = require(process.argv[2]);
const lines = require('node:readline').createInterface({ input: process.stdin });

lines.on('line', (line) => {
  const [formula, displayMode] = JSON.parse(line);
  let answer;
  try {
    answer = { html: katex.renderToString(formula, { displayMode }) };
  } catch (error) {
    answer = { error: error.message };
  }
  console.log(JSON.stringify(answer));
});
