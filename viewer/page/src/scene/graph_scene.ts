// SPDX-License-Identifier: BSD-3-Clause
// All objects of one structure. Frames change their positions; options and theme change their looks.
import { Color, Group, Matrix3, Matrix4, Vector3 } from "three";
import type { EdgeGroup, Frame, Structure, Truth, TruthFit, Uncertainty, VertexGroup } from "../protocol/messages";
import { classColors, type Theme, typeColor } from "../theme";
import type { Budget } from "./budget";
import { type Coloring, type ColorMode, coloringOf } from "./coloring";
import { defaultShown, defaultSize, type DisplayOptions, styleOf } from "./display_options";
import { type EdgeColoring, LEVELS, levelCounts, levelsOf, linesOfLevel, type LineValues } from "./edge_levels";
import { Edges, linesOf } from "./edges";
import { Ellipses, type Limited } from "./ellipses";
import { type Estimates, Ghost, type GhostKind } from "./ghost";
import { shared } from "./materials";
import { PointCloud } from "./points";
import { PointFilter } from "./point_filter";
import { pick, type Picked, type Place } from "./picking";
import { Poses } from "./poses";
import { ScanCloud } from "./scan_cloud";
import { Selection } from "./selection";
import type { ShapeName } from "./shapes";
import { type Extent, isPoint, robustExtent, union } from "./statistics";
import { membersOf, Vertices } from "./vertices";

const FIXED_PIXELS = 11;
/** Sizes relative to the typical distance between poses. */
const POSE_SIZE = 0.45, CAMERA_SIZE = 0.9;

export class GraphScene {
  readonly root = new Group();
  /** What is at the positions of the last frame. */
  private readonly current = new Group();
  readonly rotation: Matrix3;
  readonly filter: PointFilter;
  private readonly vertices: Vertices;
  /** The members of `structure.vertices`, in the same order. */
  private readonly groups: (Poses | PointCloud)[];
  private edges: Edges[];
  /** The last values of lines that the server sent; none are sent during a run. */
  private line_values: LineValues | null = null;
  private edge_coloring: EdgeColoring = "role";
  private has_new_values = false;
  /** The number of lines of each level; null if the edges have the colors of their roles. */
  level_counts: number[] | null = null;
  private readonly fixed: PointCloud;
  private readonly ellipses: Ellipses;
  private readonly scans: ScanCloud | null;
  private readonly ghosts: Record<GhostKind, Ghost | null> = { before: null, truth: null };
  /** Of the last frame: x, y, z of each vertex; NaN if the vertex is not drawn. */
  private positions: Float32Array = new Float32Array(0);
  /** Of the last frame. */
  private truth_fit: TruthFit | null = null;
  private readonly selection: Selection;
  /** By type, in the order of the structure. */
  private shown_vertices: boolean[] = [];
  private shown_edges: boolean[] = [];
  private center: Vector3 | null = null;
  private poses_as_axes = false;
  private color_mode: ColorMode = "type";
  /** Of the last frame. */
  private uncertainty: Uncertainty | null = null;
  private has_new_uncertainty = false;
  /** The classes of vertices that have a color each; null if vertices are colored by type. */
  coloring: Coloring | null = null;

  constructor(readonly structure: Structure) {
    this.rotation = new Matrix3().fromArray(structure.leveling).transpose();
    this.current.matrixAutoUpdate = false;
    this.root.add(this.current);
    this.vertices = new Vertices(structure);
    this.filter = new PointFilter(structure);
    this.groups = structure.vertices.map((group) => this.createGroup(group));
    this.edges = this.createEdges(null);
    this.fixed = new PointCloud(indicesOf(structure.fixed), this.vertices, true);
    this.fixed.setSize(FIXED_PIXELS);
    this.selection = new Selection(this.vertices);
    this.current.add(...this.selection.objects);
    this.ellipses = new Ellipses();
    this.current.add(...this.ellipses.parts);
    this.scans = structure.scans && new ScanCloud(structure.scans);
    for (const part of this.parts()) {
      if (structure.dimension === 2) layInPlane(part);
      this.current.add(part.object);
    }
  }

  update(frame: Frame): void {
    this.place(this.current, frame);
    this.positions = frame.positions;
    const changed = this.vertices.update(frame);
    for (const group of this.groups) {
      if (group instanceof Poses) group.update(frame, this.vertices);
    }
    if (frame.errors) this.filter.errors = frame.errors;
    if (frame.line_values) {
      this.line_values = frame.line_values;
      this.has_new_values = true;
    }
    if (frame.uncertainty !== this.uncertainty) {
      this.uncertainty = frame.uncertainty;
      this.has_new_uncertainty = true;
    }
    this.scans?.update(frame);
    if (changed) this.updateVisible();
    this.updateDensity();
    this.ellipses.update(frame, this.vertices, () => this.extent()?.box.getSize(new Vector3()).length() ?? 0);
    this.truth_fit = frame.truth;
    this.placeTruth();
  }

  /** Where the last frame is, and the truth if it is shown; null if nothing is drawn. */
  extentWithTruth(): Extent | null {
    const { truth } = this.ghosts;
    if (!truth?.root.visible) return this.extent();
    return union(this.extent(), robustExtent(this.structure, truth.estimates.positions, truth.root.matrix));
  }

  private extent(): Extent | null {
    return robustExtent(this.structure, this.positions, this.current.matrix);
  }

  applyFilter(options: DisplayOptions): void {
    this.filter.apply(options.limits);
    this.vertices.filter(this.filter.first, this.filter.mask);
    for (const ghost of this.shownGhosts()) ghost.filter(this.filter.first, this.filter.mask);
    this.updateVisible();
  }

  /** Shows the estimates of the file faintly, or nothing of them. They get their looks from applyOptions(). */
  setInitial(frame: Frame | null): void {
    const ghost = this.setGhost("before", frame);
    if (ghost) this.place(ghost.root, frame!);
  }

  /** Shows the truth, or nothing of it. It gets its looks from applyOptions(). */
  setTruth(truth: Truth | null): void {
    this.setGhost("truth", truth);
    this.placeTruth();
  }

  /** `spacing` is the typical distance between poses. */
  applyOptions(options: DisplayOptions, spacing: number, theme: Theme): void {
    if (options.poses_as_axes !== this.poses_as_axes) this.changeShapes(options.poses_as_axes);
    this.colorVertices(options.color_mode);
    const uses_classes = this.coloring !== null;
    if (this.coloring) {
      classColors(theme, this.coloring).forEach((color, i) => shared.class_colors.value[i]!.copy(color));
    }
    this.colorEdges(options.edge_coloring);
    const styleFor = (group: VertexGroup | EdgeGroup) => {
      const { shown, size, color } = styleOf(options, group);
      return {
        shown: shown ?? defaultShown(this.structure, group),
        size: size ?? defaultSize(this.structure, group),
        color: color === undefined ? typeColor(theme, group) : new Color(color),
      };
    };
    this.structure.vertices.forEach((group, i) => {
      const part = this.groups[i]!;
      const { shown, size, color } = styleFor(group);
      part.object.visible = shown;
      part.setSize(isPoint(group) ? size : (group.shape === "pose" ? POSE_SIZE : CAMERA_SIZE) * size * spacing);
      if (part instanceof Poses) part.setColors(color, theme.fixed, uses_classes);
      else part.setColor(color, uses_classes);
    });
    this.edges.forEach((edges) => {
      const { shown, size, color } = styleFor(edges.group);
      edges.object.visible = shown && size > 0;
      edges.setOpacity(size);
      edges.setColor(edges.level === null ? color : theme.levels[edges.level]!);
    });
    this.fixed.setColor(theme.fixed);
    if (this.scans) {
      this.scans.setColor(theme.scan);
      this.scans.object.visible = options.shows_scans;
    }
    this.ellipses.setColor(theme.uncertainty);
    this.ellipses.shown = options.shows_uncertainty;
    this.ellipses.hide(this.structure.vertices.filter((_, i) => !this.groups[i]!.object.visible), this.vertices);
    for (const ghost of this.shownGhosts()) ghost.applyOptions(theme, (group) => styleFor(group).shown);
    this.selection.setColor(theme.selection);
    this.shown_vertices = this.groups.map((part) => part.object.visible);
    this.shown_edges = this.structure.edges.map((group) => {
      const { shown, size } = styleFor(group);
      return shown && size > 0;
    });
  }

  /** Returns what is drawn at a place of the picture. `view_projection` turns the world into the picture. */
  pick(place: Place, view_projection: Matrix4): Picked | null {
    const { lines, vertices, edges } = this.structure;
    const { visible, positions } = this.vertices;
    return pick({
      lines,
      positions: positions.array,
      matrix: view_projection.clone().multiply(this.current.matrix),
      isVertexShown: (vertex) => visible[vertex] === 1 && isMember(vertices, this.shown_vertices, vertex),
      isLineShown: (line) => visible[lines[2 * line]!] === 1 && visible[lines[2 * line + 1]!] === 1 &&
        isMember(edges, this.shown_edges, line),
    }, place);
  }

  /** Marks vertices and lines; `pairs` are two vertices for each line. */
  select(vertices: number[], pairs: number[]): void {
    this.selection.show(vertices, pairs);
  }

  /** Where the vertex is in the scene; null if it is not drawn. */
  placeOf(vertex: number): Vector3 | null {
    if (!this.vertices.visible[vertex]) return null;
    return new Vector3().fromBufferAttribute(this.vertices.positions, vertex).applyMatrix4(this.current.matrix);
  }

  /** Where the origin of the scene is in the leveled world. */
  get origin(): Vector3 {
    return (this.center ?? new Vector3()).clone().applyMatrix3(this.rotation);
  }

  /** The uncertainties that are too large for the picture. */
  get limitedUncertainties(): Limited {
    return this.ellipses.limited;
  }

  /** How much is drawn without a limit. */
  get drawableCounts(): Budget {
    const count = (parts: { drawableCount: number }[]) => parts.reduce((sum, part) => sum + part.drawableCount, 0);
    return {
      lines: count([...this.edges, this.ellipses]),
      poses: count(this.groups.filter((group) => group instanceof Poses)),
      points: count([...this.groups.filter((group) => group instanceof PointCloud), ...(this.scans ? [this.scans] : [])]),
    };
  }

  /** Draws about as much of what is visible as the budget allows, spread over all of it. */
  limit(budget: Budget): void {
    const ghosts = this.shownGhosts();
    // The odometry is what shows the shape of the graph.
    const paths = this.edges.filter(({ group }) => group.role === "odometry");
    const others = this.edges.filter(({ group }) => group.role !== "odometry");
    limitParts(paths, budget.lines);
    const rest = Math.max(0, budget.lines - paths.reduce((sum, part) => sum + part.drawableCount, 0));
    limitParts([...others, this.ellipses, ...ghosts.flatMap(({ edges }) => edges)], rest);
    limitParts(this.groups.filter((group) => group instanceof Poses), budget.poses);
    const clouds = this.groups.filter((group) => group instanceof PointCloud);
    limitParts([...clouds, ...(this.scans ? [this.scans] : []), ...ghosts.flatMap(({ points }) => points)], budget.points);
    this.fixed.drawPart(1);
  }

  dispose(): void {
    for (const part of this.parts()) part.dispose();
    this.ellipses.dispose();
    for (const ghost of this.shownGhosts()) ghost.dispose();
    this.selection.dispose();
  }

  private updateDensity(): void {
    const diameter = this.extent()?.box.getSize(new Vector3()).length() ?? 0;
    for (const edges of this.edges) edges.updateDensity(this.positions, diameter);
  }

  private shownGhosts(): Ghost[] {
    return Object.values(this.ghosts).filter((ghost) => ghost !== null);
  }

  private setGhost(kind: GhostKind, estimates: Estimates | null): Ghost | null {
    const before = this.ghosts[kind];
    if (estimates === (before?.estimates ?? null)) return before;
    if (before) {
      this.root.remove(before.root);
      before.dispose();
    }
    const ghost = (this.ghosts[kind] = estimates && new Ghost(kind, this.structure, estimates));
    if (!ghost) return null;
    ghost.filter(this.filter.first, this.filter.mask);
    this.root.add(ghost.root);
    return ghost;
  }

  /** Moves the truth onto the estimates. */
  private placeTruth(): void {
    const { truth } = this.ghosts;
    if (!truth) return;
    truth.root.visible = this.truth_fit !== null;
    if (!this.truth_fit) return;
    const { rotation, translation } = this.truth_fit;
    const motion = new Matrix4().setFromMatrix3(new Matrix3().fromArray(rotation).transpose()).setPosition(...translation);
    truth.root.matrix.multiplyMatrices(this.current.matrix, motion);
    truth.root.matrixWorldNeedsUpdate = true;
  }

  private parts(): (Poses | PointCloud | Edges | ScanCloud)[] {
    return [...this.groups, ...this.edges, this.fixed, ...(this.scans ? [this.scans] : [])];
  }

  private createGroup(group: VertexGroup): Poses | PointCloud {
    if (!isPoint(group)) return new Poses(group, this.structure, this.shapeOf(group, false));
    return new PointCloud(membersOf(group), this.vertices);
  }

  private createEdges(levels: Uint8Array | null): Edges[] {
    const { structure, vertices } = this;
    return structure.edges.flatMap((group) => {
      if (!levels) return [new Edges(group, linesOf(group, structure), vertices)];
      return Array.from({ length: LEVELS }, (_, level) =>
        new Edges(group, linesOfLevel(structure.lines, group.first, group.count, levels, level), vertices, level));
    });
  }

  /** Divides the edges into levels, or unites them, if the coloring or the values have changed. */
  private colorEdges(coloring: EdgeColoring): void {
    const is_new = coloring !== this.edge_coloring || (coloring !== "role" && this.has_new_values);
    if (!is_new) return;
    this.edge_coloring = coloring;
    this.has_new_values = false;
    for (const edges of this.edges) {
      this.current.remove(edges.object);
      edges.dispose();
    }
    const levels = coloring === "role" || !this.line_values ? null : levelsOf(coloring, this.line_values);
    this.level_counts = levels && levelCounts(levels);
    this.edges = this.createEdges(levels);
    for (const edges of this.edges) {
      if (this.structure.dimension === 2) layInPlane(edges);
      edges.updateVisible(this.vertices);
      this.current.add(edges.object);
    }
    this.updateDensity();
  }

  private changeShapes(as_axes: boolean): void {
    this.poses_as_axes = as_axes;
    for (const group of this.groups) {
      if (!(group instanceof Poses)) continue;
      this.current.remove(group.setShape(this.shapeOf(group.group, as_axes)));
      this.current.add(group.object);
    }
  }

  private colorVertices(mode: ColorMode): void {
    const is_new = mode !== this.color_mode || (mode === "uncertainty" && this.has_new_uncertainty);
    if (!is_new) return;
    this.color_mode = mode;
    this.has_new_uncertainty = false;
    this.coloring = coloringOf(this.structure, mode, this.uncertainty);
    if (!this.coloring) return;
    this.vertices.setClasses(this.coloring.of_vertex);
    for (const group of this.groups) {
      if (group instanceof Poses) group.updateClasses(this.vertices);
    }
  }

  private shapeOf(group: VertexGroup, as_axes: boolean): ShapeName {
    if (group.shape === "camera" || group.shape === "camera back") return group.shape;
    if (as_axes) return "axes";
    return this.structure.dimension === 2 ? "triangle" : "wedge";
  }

  private updateVisible(): void {
    for (const part of this.parts()) part.updateVisible(this.vertices);
    this.selection.updateVisible();
    this.ellipses.updateVisible(this.vertices);
  }

  /** Positions are relative to the center of their frame, the scene to that of the first frame. */
  private place(group: Group, frame: Frame): void {
    const center = new Vector3(...frame.center);
    this.center ??= center;
    const offset = center.clone().sub(this.center).applyMatrix3(this.rotation);
    group.matrix.copy(new Matrix4().setFromMatrix3(this.rotation).setPosition(offset));
    group.matrixWorldNeedsUpdate = true;
  }
}

/** True if the number belongs to one of the groups that are shown. */
function isMember(groups: { first: number; count: number }[], shown: boolean[], number: number): boolean {
  return groups.some(({ first, count }, i) => shown[i]! && number >= first && number < first + count);
}

function limitParts(parts: { drawableCount: number; drawPart(part: number): void }[], most: number): void {
  const total = parts.reduce((sum, part) => sum + part.drawableCount, 0);
  for (const part of parts) part.drawPart(total > most ? most / total : 1);
}

/** All parts of a plane are equally deep, so only their order decides which one is on top. */
function layInPlane(part: Poses | PointCloud | Edges | ScanCloud): void {
  part.object.material.transparent = true;
  part.object.material.depthTest = false;
}

function indicesOf(flags: Uint8Array): Uint32Array {
  const indices: number[] = [];
  flags.forEach((flag, i) => flag && indices.push(i));
  return Uint32Array.from(indices);
}
