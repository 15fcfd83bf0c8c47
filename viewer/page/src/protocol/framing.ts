// SPDX-License-Identifier: BSD-3-Clause
// Cuts the bytes of a stream into messages: length of the payload (u32), kind (u32), payload.

const HEADER_BYTES = 8;
/** A longer payload means that the bytes are not a stream of messages. */
const MOST_PAYLOAD_BYTES = 2 ** 30;

export interface RawMessage {
  kind: number;
  payload: Uint8Array<ArrayBuffer>;
}

export class MessageReader {
  private readonly header = new Uint8Array(HEADER_BYTES);
  private header_size = 0;
  private payload: Uint8Array<ArrayBuffer> | null = null;
  private payload_size = 0;

  /** Returns the messages that `chunk` completes. Each payload has a buffer of its own. */
  push(chunk: Uint8Array): RawMessage[] {
    const messages: RawMessage[] = [];
    let begin = 0;
    // Also runs at the end of the chunk, because a payload may be empty.
    for (;;) {
      if (!this.payload) {
        begin += this.readHeader(chunk, begin);
        if (!this.payload) return messages;
      }
      begin += this.readPayload(chunk, begin);
      if (this.payload_size < this.payload!.length) return messages;
      messages.push({ kind: new DataView(this.header.buffer).getUint32(4, true), payload: this.payload! });
      this.payload = null;
      this.header_size = 0;
    }
  }

  /** Returns the number of bytes that it used. */
  private readHeader(chunk: Uint8Array, begin: number): number {
    const part = chunk.subarray(begin, begin + HEADER_BYTES - this.header_size);
    this.header.set(part, this.header_size);
    this.header_size += part.length;
    if (this.header_size === HEADER_BYTES) {
      const length = new DataView(this.header.buffer).getUint32(0, true);
      if (length > MOST_PAYLOAD_BYTES) throw new Error(`the stream has a message of ${length} bytes`);
      this.payload = new Uint8Array(length);
      this.payload_size = 0;
    }
    return part.length;
  }

  private readPayload(chunk: Uint8Array, begin: number): number {
    const part = chunk.subarray(begin, begin + this.payload!.length - this.payload_size);
    this.payload!.set(part, this.payload_size);
    this.payload_size += part.length;
    return part.length;
  }
}
