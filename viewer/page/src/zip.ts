// SPDX-License-Identifier: BSD-3-Clause
// Puts files into one .zip file, without compression.

export interface ZipEntry {
  /** In ASCII. */
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

const LOCAL_SIGNATURE = 0x04034b50, CENTRAL_SIGNATURE = 0x02014b50, END_SIGNATURE = 0x06054b50;
const VERSION = 20;
/** 1 January 1980, the first day that the format knows. */
const DATE = 0x21;

/** Less than 65536 files with less than 4 GiB. */
export function zip(entries: ZipEntry[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [], directory: Uint8Array<ArrayBuffer>[] = [];
  let offset = 0;
  for (const entry of entries) {
    const name = new TextEncoder().encode(entry.name);
    const facts = [
      ...u16(VERSION), ...u16(0), ...u16(0), ...u16(0), ...u16(DATE), ...u32(crc32(entry.bytes)),
      ...u32(entry.bytes.length), ...u32(entry.bytes.length), ...u16(name.length), ...u16(0),
    ];
    const local = Uint8Array.from([...u32(LOCAL_SIGNATURE), ...facts, ...name]);
    // No comment, the first disk, no attributes.
    const attributes = [...u16(0), ...u16(0), ...u16(0), ...u32(0)];
    directory.push(Uint8Array.from([
      ...u32(CENTRAL_SIGNATURE), ...u16(VERSION), ...facts, ...attributes, ...u32(offset), ...name,
    ]));
    parts.push(local, entry.bytes);
    offset += local.length + entry.bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  const end = Uint8Array.from([
    ...u32(END_SIGNATURE), ...u16(0), ...u16(0), ...u16(entries.length), ...u16(entries.length), ...u32(size),
    ...u32(offset), ...u16(0),
  ]);
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}

export function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 0xff]! ^ (crc >>> 8);
  return ~crc >>> 0;
}

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  return crc;
});

function u16(value: number): number[] {
  return [value & 0xff, (value >>> 8) & 0xff];
}

function u32(value: number): number[] {
  return [...u16(value), ...u16(value >>> 16)];
}
