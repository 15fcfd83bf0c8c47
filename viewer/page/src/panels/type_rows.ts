// SPDX-License-Identifier: BSD-3-Clause
// The lines of the types of vertices and edges: shown or not, their color, and their size or opacity.
import { general } from "../format";
import type { EdgeGroup, EdgeRole, Structure, VertexGroup } from "../protocol/messages";
import { defaultShown, defaultSize, type TypeStyle } from "../scene/display_options";
import { isPoint } from "../scene/statistics";
import { type Theme, typeColor } from "../theme";
import { checkBox, colorField, lineNumber, type Range, slider, swatch } from "./controls";
import { create } from "./dom";

/** The sliders of factors are logarithmic: powers of 2. */
const MOST_SCALE_EXPONENT = 4;

const ROLE_NAMES: Record<EdgeRole, string> = {
  odometry: "Odometry",
  "loop closure": "Loop closures",
  observation: "Observations",
  other: "Others",
};

/** `id` is that of the check box. */
export function typeRow(
  id: string, structure: Structure, group: VertexGroup | EdgeGroup, style: TypeStyle, theme: Theme,
): HTMLElement {
  const { name, kind } = signOf(structure, group);
  const type = sizeName(structure, group);
  const sign = swatch(kind);
  const own_color = style.color ?? group.color;
  if (own_color) sign.style.background = own_color;
  const box = checkBox(id, style.shown ?? defaultShown(structure, group), [sign, name], type === name ? "" : type,
    (checked) => (style.shown = checked));
  const default_color = `#${typeColor(theme, group).getHexString()}`;
  const color = colorField(`color-${id}`, name, style.color ?? null, default_color, (chosen) => {
    if (chosen === null) delete style.color;
    else style.color = chosen;
    sign.style.background = chosen ?? group.color ?? "";
  });
  box.title = group.name;
  return create("div", { className: "type-row" }, box, lineNumber(group.count), color);
}

/** The slider of the size of vertices, or of the opacity of edges. */
export function sizeSlider(id: string, structure: Structure, group: VertexGroup | EdgeGroup, style: TypeStyle): HTMLElement {
  const name = sizeName(structure, group);
  const value = style.size ?? defaultSize(structure, group);
  const take = (size: number) => {
    // The slider tells its value when it is made, and that is no choice.
    if (Math.abs(size - value) > 1e-9 || style.size !== undefined) style.size = size;
    return size;
  };
  if ("role" in group) {
    const range = { min: 0, max: 1, step: 0.05, value };
    return slider(`opacity-${id}`, name, range, (opacity) => `${Math.round(100 * take(opacity))} %`);
  }
  if (isPoint(group)) {
    const range = { min: 1, max: 12, step: 0.5, value };
    return slider(`size-${id}`, name, range, (size) => `${general(take(size), 2)} px`);
  }
  const range: Range = { min: -MOST_SCALE_EXPONENT, max: MOST_SCALE_EXPONENT, step: 0.25, value: Math.log2(value) };
  return slider(`size-${id}`, name, range, (exponent) => `× ${general(take(2 ** exponent), 2)}`);
}

/** The name of the type if another type has the same sign. */
function sizeName(structure: Structure, group: VertexGroup | EdgeGroup): string {
  const { name } = signOf(structure, group);
  const groups = "role" in group ? structure.edges : structure.vertices;
  return groups.filter((other) => signOf(structure, other).name === name).length > 1 ? group.name : name;
}

function signOf(structure: Structure, group: VertexGroup | EdgeGroup): { name: string; kind: string } {
  if ("role" in group) return { name: ROLE_NAMES[group.role], kind: group.role.replace(" ", "-") };
  if (isPoint(group)) return { name: structure.is_bundle ? "Points" : "Landmarks", kind: "dot landmark" };
  return group.shape === "pose" ? { name: "Poses", kind: "triangle pose" } : { name: "Cameras", kind: "triangle camera" };
}
