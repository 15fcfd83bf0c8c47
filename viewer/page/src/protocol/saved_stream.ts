// SPDX-License-Identifier: BSD-3-Clause
// The messages in a page that was saved with its graph, and has no server.
import { decode } from "./decode";
import { MessageReader } from "./framing";
import type { Message } from "./messages";

/** `text` is the stream in base64. */
export function savedMessages(text: string): Message[] {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new MessageReader().push(bytes).map(decode).filter((message) => message !== null);
}
