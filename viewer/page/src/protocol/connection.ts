// SPDX-License-Identifier: BSD-3-Clause
// The connection to the server: reads the stream, tries again once per second after it broke, and sends commands. A page that
// is hidden for long gives its stream back, because browsers open only six connections to a server.
import { decode } from "./decode";
import { MessageReader } from "./framing";
import type { ElementFacts, ElementName } from "./element";
import type { Command, Message, Pattern } from "./messages";

const RETRY_MS = 1000;
/** The server sends a heartbeat at least once per second, so after this time the connection is lost. */
const SILENCE_MS = 6000;
const ANSWER_MS = 10_000;
const HIDDEN_MS = 30_000;

export type ConnectionState = { connected: boolean; problem: string };

export interface Listener {
  onMessage(message: Message): void;
  onConnection(state: ConnectionState): void;
}

export class Connection {
  private token = new URLSearchParams(location.search).get("token") ?? "";
  private readonly has_url_token = this.token !== "";
  private abort = new AbortController();

  constructor(private readonly listener: Listener) {
    let timer = 0;
    document.addEventListener("visibilitychange", () => {
      clearTimeout(timer);
      if (document.hidden) timer = window.setTimeout(() => this.abort.abort(), HIDDEN_MS);
    });
  }

  /** Reads streams as long as the page lives. */
  async run(): Promise<never> {
    for (;;) {
      let problem = "The connection to boxplus is lost. Trying again each second…";
      try {
        await this.readStream();
      } catch (error) {
        if (error instanceof Refusal) problem = error.message;
        else if (!isNetworkError(error)) console.warn(error);
      }
      if (document.hidden) {
        await untilVisible();
        continue;
      }
      this.listener.onConnection({ connected: false, problem });
      await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
    }
  }

  /** Throws an Error with the server's words if the server refuses the command. */
  async send(command: Command): Promise<void> {
    await answerTo("/command", {
      method: "POST",
      headers: { "Content-Type": "application/json", "X-Boxplus-Token": this.token },
      body: JSON.stringify(command),
      signal: AbortSignal.timeout(ANSWER_MS),
    });
  }

  /** Sends the file; the server reads it after the answer. Throws like send(). */
  async openFile(file: File, as: "graph" | "truth"): Promise<void> {
    await answerTo(`/open?as=${as}&name=${encodeURIComponent(file.name)}`, {
      method: "POST",
      headers: { "Content-Type": "application/octet-stream", "X-Boxplus-Token": this.token },
      body: file,
    });
  }

  /** Returns the graph as a file. Throws like send(). */
  async graphFile(format: string): Promise<Blob> {
    const url = `/graph?format=${encodeURIComponent(format)}`;
    const response = await answerTo(url, { headers: { "X-Boxplus-Token": this.token }, cache: "no-store" });
    return response.blob();
  }

  /** Returns what the server knows of an element of this structure. Throws like send(). */
  async element(structure: number, { key, number }: ElementName): Promise<ElementFacts> {
    const response = await answerTo(`/element?structure=${structure}&${key}=${encodeURIComponent(number)}`, {
      headers: { "X-Boxplus-Token": this.token },
      cache: "no-store",
      signal: AbortSignal.timeout(ANSWER_MS),
    });
    return (await response.json()) as ElementFacts;
  }

  /** Asks what is wrong with the graph. The stream brings the answer to all pages. Throws like send(). */
  async diagnose(): Promise<void> {
    const response = await answerTo("/diagnosis", { headers: { "X-Boxplus-Token": this.token }, cache: "no-store" });
    await response.text();
  }

  /** Returns where H and L have blocks. Throws like send(). */
  async pattern(): Promise<Pattern> {
    const response = await answerTo("/pattern", { headers: { "X-Boxplus-Token": this.token }, cache: "no-store" });
    const [raw] = new MessageReader().push(new Uint8Array(await response.arrayBuffer()));
    const message = raw && decode(raw);
    if (message?.kind !== "pattern") throw new Error("the answer is no pattern");
    return message.pattern;
  }

  private async readStream(): Promise<void> {
    const abort = (this.abort = new AbortController());
    let alarm = setTimeout(() => abort.abort(), SILENCE_MS);
    try {
      const response = await fetch(this.has_url_token ? `/stream?token=${encodeURIComponent(this.token)}` : "/stream", {
        cache: "no-store",
        signal: abort.signal,
      });
      if (!response.ok || !response.body) throw new Refusal(response.status);
      const bytes = response.body.getReader();
      const reader = new MessageReader();
      for (;;) {
        const { done, value } = await bytes.read();
        if (done) return;
        clearTimeout(alarm);
        alarm = setTimeout(() => abort.abort(), SILENCE_MS);
        for (const raw of reader.push(value)) this.receive(decode(raw));
      }
    } finally {
      clearTimeout(alarm);
      abort.abort();
    }
  }

  private receive(message: Message | null): void {
    if (!message) return;
    if (message.kind === "state" && message.state.token !== undefined) {
      this.token = message.state.token;
      this.listener.onConnection({ connected: true, problem: "" });
    }
    this.listener.onMessage(message);
  }
}

/** Throws an Error with the server's words if the status is not that of success. */
async function answerTo(url: string, request: RequestInit): Promise<Response> {
  const response = await fetch(url, request);
  if (response.ok) return response;
  const answer: unknown = await response.json().catch(() => null);
  const text = (answer as { error?: unknown } | null)?.error;
  throw new Error(typeof text === "string" ? text : `the server refused the request (status ${response.status})`);
}

function untilVisible(): Promise<void> {
  return new Promise((resolve) => {
    document.addEventListener("visibilitychange", function listener() {
      if (document.hidden) return;
      document.removeEventListener("visibilitychange", listener);
      resolve();
    });
  });
}

class Refusal extends Error {
  constructor(status: number) {
    super(
      status === 503
        ? "boxplus serves too many pages already. Close one; this page tries again each second."
        : status === 403
          ? "boxplus refuses this page. Open the address that boxplus printed."
          : `boxplus refuses the stream (status ${status}). Trying again each second…`,
    );
  }
}

function isNetworkError(error: unknown): boolean {
  return error instanceof TypeError || (error instanceof DOMException && error.name === "AbortError");
}
