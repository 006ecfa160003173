// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { shown, unitText, withError } from './numbers.js';

function cell(kind, text, parts = {}) {
  return Object.assign(document.createElement(kind), { textContent: text }, parts);
}

function rowOf(quantity) {
  const row = document.createElement('tr');
  const { name, unit, value, error, theory, reason } = quantity;
  row.append(
    cell('th', name.replaceAll('_', ' '), { scope: 'row' }),
    cell('td', value === null && reason ? reason : withError(value, error), { className: value === null ? 'reason' : '' }),
    cell('td', theory === null ? '' : shown(theory)),
    cell('td', unitText(unit)),
  );
  if (reason) row.title = reason;
  return row;
}

/** Shows what has been measured: a group of rows for each measure that has numbers. */
export function showMeasures(table, measurements) {
  const groups = measurements
    .filter(({ quantities }) => quantities.length > 0)
    .map(({ title, quantities, unsettled, transient_over: isOver }) => {
      const body = document.createElement('tbody');
      const head = document.createElement('tr');
      head.append(cell('th', title, { scope: 'rowgroup', colSpan: 4, title: isOver ? '' : unsettled }));
      body.append(head, ...quantities.map(rowOf));
      return body;
    });
  for (const body of [...table.tBodies]) body.remove();
  table.append(...groups);
  table.hidden = groups.length === 0;
}
