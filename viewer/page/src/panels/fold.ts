// SPDX-License-Identifier: BSD-3-Clause
// A button that folds a part of the panel. In a small window, the part is folded until the user unfolds it.
import { store, stored } from "../stored";
import { byId } from "./dom";

const SMALL_WINDOW = "(max-height: 690px), (max-width: 760px)";

/** `id` is that of the part; the button is `fold-{id}`. */
export function makeFoldable(id: string): void {
  const button = byId(`fold-${id}`), part = byId(id), small = matchMedia(SMALL_WINDOW);
  const name = `folded ${id}`;
  const update = () => {
    const chosen = stored(name);
    part.hidden = typeof chosen === "boolean" ? chosen : small.matches;
    button.setAttribute("aria-expanded", String(!part.hidden));
  };
  button.addEventListener("click", () => {
    store(name, !part.hidden);
    update();
  });
  small.addEventListener("change", update);
  update();
}
