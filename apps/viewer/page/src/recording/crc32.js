// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

const kBytesAtOnce = 4;

// Table k: what a byte adds to the remainder if k more bytes follow.
const kTables = makeTables();

function makeTables() {
  const tables = Array.from({ length: kBytesAtOnce }, () => new Uint32Array(256));
  for (let byte = 0; byte < 256; ++byte) {
    let remainder = byte;
    for (let bit = 0; bit < 8; ++bit) remainder = (remainder >>> 1) ^ (remainder & 1 ? 0xedb88320 : 0);
    tables[0][byte] = remainder;
  }
  for (let k = 1; k < kBytesAtOnce; ++k) {
    for (let byte = 0; byte < 256; ++byte) {
      const before = tables[k - 1][byte];
      tables[k][byte] = (before >>> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

/** The CRC-32 of the bytes from `begin` to before `end` of a buffer, as of zip and zlib. Cost: O(bytes). */
export function crc32(buffer, begin, end) {
  const bytes = new Uint8Array(buffer, begin, end - begin);
  const [last, third, second, first] = kTables;
  let state = -1;
  let at = 0;
  for (; at + kBytesAtOnce <= bytes.length; at += kBytesAtOnce) {
    state ^= bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
    state =
      first[state & 0xff] ^ second[(state >>> 8) & 0xff] ^ third[(state >>> 16) & 0xff] ^ last[state >>> 24];
  }
  for (; at < bytes.length; ++at) state = (state >>> 8) ^ last[(state ^ bytes[at]) & 0xff];
  return ~state >>> 0;
}

/** Whether the bytes from `begin` to before `end` have the checksum, an unsigned 64-bit integer, that follows them. */
export function hasItsChecksum(buffer, begin, end) {
  const view = new DataView(buffer, end, 8);
  return view.getUint32(0, true) === crc32(buffer, begin, end) && view.getUint32(4, true) === 0;
}
