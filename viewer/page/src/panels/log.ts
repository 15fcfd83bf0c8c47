// SPDX-License-Identifier: BSD-3-Clause
// The messages of the server.
import type { Model } from "../model";
import type { LogLine } from "../protocol/messages";
import { byId, create, keepAtEnd } from "./dom";

export class Log {
  private readonly list = byId("log-lines");
  private readonly shown: LogLine[] = [];

  constructor(private readonly model: Model) {
    model.observe(() => keepAtEnd(byId("log"), () => this.update()));
  }

  private update(): void {
    const lines = this.model.log;
    // Old lines leave at the front; lines that the server replaced leave at the end.
    while (this.shown.length > 0 && this.shown[0] !== lines[0]) {
      this.shown.shift();
      this.list.firstChild!.remove();
    }
    let same = this.shown.length;
    while (same > 0 && this.shown[same - 1] !== lines[same - 1]) --same;
    while (this.shown.length > same) {
      this.shown.pop();
      this.list.lastChild!.remove();
    }
    for (const line of lines.slice(same)) {
      const item = create("li", {}, line.text);
      item.dataset["level"] = line.level;
      this.list.append(item);
      this.shown.push(line);
    }
  }
}
