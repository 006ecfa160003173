// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

/** The keys of a table: a map of all that any of its alternatives has, by name. */
export function keysOf(node) {
  const keys = new Map(Object.entries(node?.properties ?? {}));
  const alternatives = [...(node?.oneOf ?? []), ...(node?.anyOf ?? []), ...(node?.allOf ?? []), node?.items].filter(Boolean);
  for (const alternative of alternatives) {
    for (const [name, other] of keysOf(alternative)) {
      const known = keys.get(name);
      // A key such as `shape` has another constant in each alternative.
      if (known?.const !== undefined && other.const !== known.const) {
        keys.set(name, { ...known, const: undefined, enum: [...valuesOf(known), ...valuesOf(other)] });
      } else if (known?.enum && other.const !== undefined) {
        keys.set(name, { ...known, enum: [...new Set([...known.enum, other.const])] });
      } else if (!known) {
        keys.set(name, other);
      }
    }
  }
  return keys;
}

/** The node of a place such as ['box', 'faces', 'x_min'], or undefined. */
export function nodeAt(schema, path) {
  return path.reduce((node, name) => node && keysOf(node).get(name), schema);
}

/** All values that are given by name: those of a list, of its elements, of its alternatives. */
export function valuesOf(node) {
  if (!node) return [];
  if (node.const !== undefined) return [node.const];
  if (node.enum) return node.enum;
  if (node.type === 'boolean') return [true, false];
  const alternatives = [...(node.oneOf ?? []), ...(node.anyOf ?? []), node.items].filter(Boolean);
  return [...new Set(alternatives.flatMap(valuesOf))];
}

/** The node of a number: the alternative that is one, or that of the elements of a list. */
export function numberNodeOf(node) {
  if (!node || node.type === 'number') return node;
  const alternatives = [...(node.oneOf ?? []), ...(node.anyOf ?? []), node.items].filter(Boolean);
  return alternatives.map(numberNodeOf).find(Boolean);
}

/** The description without Markdown. */
export function descriptionOf(node) {
  return (node?.description ?? '').replaceAll('`', '');
}
