// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** `value` with `digits` significant digits, for people. */
export function show(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 10 ** (digits + 2) || size < 1e-4 ? scientific(value, digits) : plain(value, digits);
  return text.replace('-', '−');
}

/** A whole number in groups of three digits. */
export function showCount(value) {
  return Math.round(value).toLocaleString('en-US');
}

/** A time with enough decimals to distinguish times `step` apart. */
export function showTime(time, step) {
  const decimals = Math.min(12, Math.max(0, Math.ceil(-Math.log10(step))));
  return time.toFixed(decimals).replace('-', '−');
}

function plain(value, digits) {
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(value))));
  return value.toFixed(Math.min(decimals, 12));
}

function scientific(value, digits) {
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  return `${mantissa}·10${[...String(Number(exponent))].map((sign) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[sign] ?? '⁻').join('')}`;
}
