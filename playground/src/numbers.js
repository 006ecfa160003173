// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** A number in a few digits; an en dash if there is none. */
export function shown(number, digits = 6) {
  if (number === null || number === undefined) return '–';
  const size = Math.abs(number);
  if (size !== 0 && (size >= 1e7 || size < 1e-4)) return number.toExponential(Math.max(0, digits - 3)).replaceAll('-', '−');
  return String(Number(number.toPrecision(digits))).replaceAll('-', '−');
}

/** A value with its standard error, of which two digits are shown: "1.613 ± 0.012". */
export function withError(value, error) {
  if (value === null) return '–';
  if (!(error > 0)) return shown(value);
  const size = Math.max(Math.abs(value), error);
  if (size >= 1e7 || size < 1e-4) return `${shown(value, 5)} ± ${error.toExponential(1).replaceAll('-', '−')}`;
  const digits = Math.min(15, Math.max(0, 1 - Math.floor(Math.log10(error))));
  return `${value.toFixed(digits).replaceAll('-', '−')} ± ${error.toFixed(digits)}`;
}

const kSuperscripts = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };

/** A unit such as "L^2 T^-1" with raised powers; nothing for a pure number. */
export function unitText(unit) {
  if (unit === '1') return '';
  return unit.replace(/\^(-?\d+)/g, (_, power) => [...power].map((letter) => kSuperscripts[letter]).join(''));
}

/** A count with separators between thousands. */
export function countText(count) {
  return count.toLocaleString('en-US');
}
