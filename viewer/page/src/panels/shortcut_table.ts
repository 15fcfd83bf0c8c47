// SPDX-License-Identifier: BSD-3-Clause
// Which key does what.
import type { PictureTools } from "./picture_tools";
import type { Line, Shortcut, ShortcutGroups } from "./shortcuts";
import type { TimeLinePanel } from "./time_line_panel";

/** Without WebGL 2, there are neither tools nor a time line. */
export function shortcutGroups(tools: PictureTools | null, time_line: TimeLinePanel | null): ShortcutGroups {
  const groups: ShortcutGroups = {
    "Run": [
      { keys: ["o"], text: "Optimize", control: "optimize" },
      { keys: ["s"], text: "One step", control: "step" },
      { keys: ["x"], text: "Stop", control: "stop" },
      { keys: ["Shift+R"], text: "Reset to the estimates of the file", control: "reset" },
    ],
  };
  if (tools) {
    groups["Picture"] = [
      { keys: ["f"], text: "Show the whole graph", control: "fit" },
      { keys: ["t"], text: "Look from above", control: "from-above" },
      { keys: ["+", "="], text: "Zoom in", control: "zoom-in", repeats: true },
      { keys: ["-"], text: "Zoom out", control: "zoom-out", repeats: true },
      { keys: ["b"], text: "Estimates of the file below", control: "show-initial" },
      { keys: ["i"], text: "Save the picture", action: () => tools.savePicture() },
    ];
  }
  if (time_line) {
    groups["Time line"] = [
      { keys: ["p"], text: "Play or pause", control: "play" },
      { keys: [","], text: "Iteration before", action: () => time_line.move(-1), repeats: true },
      { keys: ["."], text: "Next iteration", action: () => time_line.move(1), repeats: true },
      { keys: ["<"], text: "Before the run", action: () => time_line.move(-Infinity) },
      { keys: [">"], text: "Newest estimates", action: () => time_line.move(Infinity) },
    ];
  }
  groups["Page"] = [
    { keys: ["Escape"], text: "Unmark", control: "unmark" },
    ...["display", "settings", "iterations", "log", "element"].map((tab, i) => (
      { keys: [String(i + 1)], text: `Tab ${tab.charAt(0).toUpperCase()}${tab.slice(1)}`, control: `tab-${tab}` })),
    { keys: ["h"], text: "Hide or show the panel", control: "toggle-panel" },
    { keys: ["d"], text: "Dark or light theme", control: "toggle-theme" },
    { keys: ["?"], text: "These keys", control: "show-help" },
  ];
  return groups;
}

/** The keys of a page without a server: no key of a control that needs one, and none for a time line of one frame. */
export function withoutServer(groups: ShortcutGroups): ShortcutGroups {
  const needsServer = ({ control }: Shortcut) => document.getElementById(control ?? "")?.closest(".needs-server");
  return Object.fromEntries(Object.entries(groups)
    .map(([title, shortcuts]): [string, Shortcut[]] => [title, shortcuts.filter((each) => !needsServer(each))])
    .filter(([title, shortcuts]) => shortcuts.length > 0 && title !== "Time line"));
}

/** What keys do where they have the focus, by the groups above. */
export const KEYS_WITH_FOCUS: Record<string, Line[]> = {
  "Picture": [["Arrows", "Move, with the focus on the picture"], ["Shift+Arrows", "Turn, with the focus on the picture"]],
  "Page": [["Tab", "Next control"]],
};
