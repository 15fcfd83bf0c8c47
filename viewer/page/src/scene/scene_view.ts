// SPDX-License-Identifier: BSD-3-Clause
// The picture of the graph: draws when something changed, and only then.
import { Color, LinearSRGBColorSpace, Matrix4, Scene, Vector3, WebGLRenderer } from "three";
import { type Frame, isSameKind, isSameStructure, type Structure, type Truth } from "../protocol/messages";
import { currentTheme, onThemeChange } from "../theme";
import { AdaptiveBudget, UNLIMITED } from "./budget";
import { CameraRig, type CameraState } from "./camera_rig";
import { type DisplayOptions, defaultOptions } from "./display_options";
import { GraphScene } from "./graph_scene";
import { shared } from "./materials";
import type { Picked } from "./picking";
import { Smoothing } from "./smoothing";
import { type Extent, meanViewDirection, typicalSpacing } from "./statistics";

/** How much of its color the farthest part of a graph in 3-D loses. */
const FADE = 0.6;
/** The view follows the graph if it grows by more than the margin, or shrinks by more than the rest. */
const MARGIN = 0.04, SHRINKAGE = 0.3;
/** Spacings that determine sizes, relative to the size of the graph. */
const LEAST_CAMERA_SPACING = 0.015, DEFAULT_SPACING = 0.02, LARGEST_SPACING = 0.15;
const MOST_OVERLAP = 3;
/** After this time without a movement, the whole graph is drawn. */
const REST_MS = 180;

export class SceneView {
  /** Called after another graph, its first frame, or facts about a frame came. */
  on_structure: (graph: GraphScene) => void = () => {};
  /** Called after a picture of another frame was drawn. */
  on_frame: () => void = () => {};
  /** Called after the page learned or forgot the estimates of the file. */
  on_initial: () => void = () => {};
  /** Called after the page learned or forgot the truth. */
  on_truth: () => void = () => {};
  /** Called after `newer` changed. */
  on_newer: () => void = () => {};
  /** The number of pictures of graphs that were drawn. */
  pictures = 0;
  private readonly renderer: WebGLRenderer;
  private readonly smoothing: Smoothing;
  private readonly world = new Scene();
  private readonly rig: CameraRig;
  private readonly budget = new AdaptiveBudget();
  private options = defaultOptions();
  private graph: GraphScene | null = null;
  private frame: Frame | null = null;
  private pending: Frame | null = null;
  private newest: Frame | null = null;
  /** The estimates of the file; null if the page does not know them. */
  private initial: Frame | null = null;
  /** Those of the current structure; null if no truth is open. */
  private true_estimates: Truth | null = null;
  private fitted: Extent | null = null;
  private spacing = 0;
  /** True until the user moves the camera: the view then follows the graph. */
  private follows = true;
  private keeps_camera = false;
  private rest_timer = 0;
  private request = 0;

  /** Throws if the browser has no WebGL 2. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: "high-performance" });
    this.smoothing = new Smoothing(this.renderer);
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.rig = new CameraRig(canvas, () => this.moved(), () => this.requestPicture());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    // A restored context has the background of a new one.
    canvas.addEventListener("webglcontextrestored", () => this.applyTheme());
    onThemeChange(() => this.applyTheme());
    this.resize();
    this.applyTheme();
  }

  /** Keeps the camera if the graph was edited, or is like the one before, as after a lost connection. */
  setStructure(structure: Structure): void {
    if (!isSameStructure(structure, this.graph?.structure ?? null)) this.setInitial(null);
    const before = this.graph?.structure;
    this.keeps_camera = before !== undefined && this.fitted !== null && before.dimension === structure.dimension &&
      (structure.graph === before.graph || isSameKind(structure, before));
    if (this.graph) {
      this.world.remove(this.graph.root);
      this.graph.dispose();
    }
    this.graph = new GraphScene(structure);
    this.world.add(this.graph.root);
    this.frame = this.pending = this.true_estimates = null;
    this.spacing = 0;
    this.on_truth();
    if (!this.keeps_camera) {
      this.fitted = null;
      this.follows = true;
    }
    this.requestPicture();
  }

  /** Shows the frame in the next picture, instead of one that still waits. */
  setFrame(frame: Frame): void {
    if (frame.structure !== this.graph?.structure.structure) return;
    this.pending = frame;
    this.requestPicture();
  }

  /** The newest frame if the picture shows an older one; otherwise null. */
  get newer(): Frame | null {
    return this.newest;
  }

  setNewer(frame: Frame | null): void {
    if (frame === this.newest) return;
    this.newest = frame;
    this.on_newer();
  }

  /** Takes the estimates of the file, which the options may show under the current ones. */
  setInitial(frame: Frame | null): void {
    this.initial = frame;
    this.on_initial();
    if (this.options.shows_initial) this.applyTheme();
  }

  /** Takes the truth of the current structure, which the options may show under the estimates. */
  setTruth(truth: Truth | null): void {
    if (truth && truth.structure !== this.graph?.structure.structure) return;
    this.true_estimates = truth;
    this.on_truth();
    this.applyTheme();
    if (this.follows) this.followGraph();
  }

  get truth(): Truth | null {
    return this.true_estimates;
  }

  get knowsInitial(): boolean {
    return this.initial !== null;
  }

  setOptions(options: DisplayOptions): void {
    const filters = this.options.limits;
    const { least_track_length, most_error } = options.limits;
    const same_filter = filters.least_track_length === least_track_length && filters.most_error === most_error;
    this.options = { ...options, limits: { ...options.limits } };
    if (!same_filter) this.graph?.applyFilter(this.options);
    this.applyTheme();
  }

  /** The frame in the picture, or in the next one. */
  get shown(): Frame | null {
    return this.pending ?? this.frame;
  }

  /** chi2 of the frame in the picture. */
  get chi2(): number | null {
    return this.frame?.chi2 ?? null;
  }

  /** Shows the whole graph, and follows it from now on. */
  fit(): void {
    this.follows = true;
    this.fitted = null;
    this.followGraph();
    this.requestPicture();
  }

  /** Shows the whole graph from above, and follows it from now on. */
  lookFromAbove(): void {
    this.rig.lookFromAbove();
    this.fit();
  }

  zoom(factor: number): void {
    this.rig.zoom(factor);
  }

  /** Returns what is drawn at a place, in CSS pixels from the upper left corner of the canvas. */
  pick(x: number, y: number): Picked | null {
    if (!this.graph || !this.frame) return null;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const { near } = this.rig.camera;
    return this.graph.pick({ x, y, width, height, near }, this.viewProjection());
  }

  /** Marks vertices and lines; `pairs` are two vertices for each line. */
  select(vertices: number[], pairs: number[]): void {
    this.graph?.select(vertices, pairs);
    this.requestPicture();
  }

  /** Two vertices for each of the lines. */
  endsOf(lines: number[]): number[] {
    const ends = this.graph?.structure.lines;
    return ends ? lines.flatMap((line) => [ends[2 * line]!, ends[2 * line + 1]!]) : [];
  }

  /** Moves the camera if none of the vertices is in the picture. */
  goTo(vertices: number[]): void {
    const places = vertices.map((vertex) => this.graph?.placeOf(vertex)).filter((place) => place !== null && place !== undefined);
    const matrix = this.viewProjection();
    const isSeen = (place: Vector3) => {
      const { x, y, z } = place.clone().applyMatrix4(matrix);
      return Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) < 1;
    };
    if (places.length === 0 || places.some(isSeen)) return;
    this.rig.lookAt(places[0]!);
    this.moved();
  }

  private viewProjection(): Matrix4 {
    const { camera } = this.rig;
    camera.updateMatrixWorld();
    return new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  }

  /** Where the camera is in the leveled world; null if nothing is drawn. */
  get camera(): CameraState | null {
    return this.graph && this.frame ? this.rig.state(this.graph.origin) : null;
  }

  /** Throws an Error if the camera is one for other graphs. */
  setCamera(state: CameraState): void {
    if (!this.graph || !this.frame) throw new Error("there is no picture");
    this.rig.setState(state, this.graph.origin);
    this.moved();
  }

  /** Draws at once, and returns the picture as PNG. */
  png(): Promise<Blob> {
    this.draw(UNLIMITED);
    return this.drawnPng();
  }

  /** The picture that was drawn last, as PNG. The browser keeps it only until the end of the current task. */
  drawnPng(): Promise<Blob> {
    return new Promise((resolve, reject) => {
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser made no image"))), "image/png");
    });
  }

  /** Draws at once, and returns the bytes (RGBA) of the picture. */
  pixels(): Uint8Array {
    this.draw();
    const gl = this.renderer.getContext();
    const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  }

  private get isMoving(): boolean {
    return this.rest_timer !== 0 || (this.rig.isHeld && !this.follows);
  }

  private requestPicture(): void {
    if (this.request === 0) this.request = requestAnimationFrame((time) => this.animate(time));
  }

  private animate(time: number): void {
    this.request = 0;
    this.budget.tick(time, this.isMoving);
    this.draw();
  }

  private draw(budget = this.isMoving ? this.budget.current : UNLIMITED): void {
    const is_new = this.pending !== null;
    if (this.pending) this.show(this.pending);
    this.setFading();
    this.graph?.limit(budget);
    const painter = this.graph && this.budget.isSmooth(this.graph.drawableCounts, this.isMoving) ? this.smoothing : this.renderer;
    painter.render(this.world, this.rig.camera);
    if (this.frame) ++this.pictures;
    if (is_new) this.on_frame();
  }

  private show(frame: Frame): void {
    const graph = this.graph!;
    const is_first = this.frame === null;
    const brings_values = frame.line_values !== null || frame.uncertainty !== (this.frame?.uncertainty ?? null);
    const brings_errors = frame.errors !== null && this.options.limits.most_error < Infinity;
    this.frame = frame;
    this.pending = null;
    graph.update(frame);
    if (is_first || brings_errors) graph.applyFilter(this.options);
    if (is_first && !this.keeps_camera) this.rig.reset(graph.structure.dimension === 2, this.firstDirection(graph, frame));
    // At the end of a run, the picture fits exactly.
    if (this.follows && frame.line_values) this.fitted = null;
    if (this.follows) this.followGraph();
    this.updateSpacing(graph, frame);
    if (brings_values) graph.applyOptions(this.options, this.spacing, currentTheme());
    if (is_first || brings_values) this.on_structure(graph);
  }

  private followGraph(): void {
    if (!this.graph || !this.frame) return;
    const extent = this.graph.extentWithTruth();
    if (!extent || (this.fitted && isSimilar(extent, this.fitted))) return;
    this.fitted = extent;
    this.rig.fit(extent);
  }

  private updateSpacing(graph: GraphScene, frame: Frame): void {
    const size = this.fitted ? this.fitted.box.getSize(new Vector3()).length() : 1;
    const typical = typicalSpacing(graph.structure, frame) || DEFAULT_SPACING * size;
    // Cameras of a long path stay visible, even if they overlap a little.
    const least = graph.structure.is_bundle ? Math.min(LEAST_CAMERA_SPACING * size, MOST_OVERLAP * typical) : 0;
    const spacing = Math.min(Math.max(typical, least), LARGEST_SPACING * size);
    // Small changes would only make the poses flicker.
    if (this.spacing > 0 && Math.abs(Math.log(spacing / this.spacing)) < Math.log(1.3)) return;
    this.spacing = spacing;
    graph.applyOptions(this.options, spacing, currentTheme());
  }

  /** From above the horizon; behind the cameras if they look the same way. */
  private firstDirection(graph: GraphScene, frame: Frame): Vector3 {
    if (graph.structure.dimension === 2) return new Vector3(0, 0, -1);
    const look = meanViewDirection(graph.structure, frame, graph.rotation).setZ(0);
    const horizontal = look.length() > 1e-9 ? look.normalize() : new Vector3(-0.5, 0.85, 0).normalize();
    return horizontal.setZ(-0.5).normalize();
  }

  private setFading(): void {
    const radius = this.fitted ? 0.5 * this.fitted.box.getSize(new Vector3()).length() : 1;
    const distance = this.rig.distance;
    shared.fade.value = this.graph?.structure.dimension === 2 ? 0 : FADE;
    shared.fade_near.value = Math.max(0, distance - 0.6 * radius);
    shared.fade_far.value = distance + 1.2 * radius;
    shared.pixel_ratio.value = this.renderer.getPixelRatio();
  }

  private moved(): void {
    this.follows = false;
    if (this.fitted) this.rig.setDepthRange(0.5 * this.fitted.box.getSize(new Vector3()).length());
    clearTimeout(this.rest_timer);
    this.rest_timer = window.setTimeout(() => {
      this.rest_timer = 0;
      this.requestPicture();
    }, REST_MS);
    this.requestPicture();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.rig.resize(clientWidth, clientHeight);
    if (this.follows && this.fitted) this.rig.fit(this.fitted);
    this.requestPicture();
  }

  private applyTheme(): void {
    const theme = currentTheme();
    const background = this.options.background === null ? theme.background : new Color(this.options.background);
    this.renderer.setClearColor(background);
    shared.background.value.copy(background);
    // Other estimates are placed relative to the first frame.
    if (this.frame) {
      this.graph?.setInitial(this.options.shows_initial ? this.initial : null);
      this.graph?.setTruth(this.options.shows_truth ? this.true_estimates : null);
    }
    this.graph?.applyOptions(this.options, this.spacing, theme);
    this.requestPicture();
  }
}

function isSimilar(extent: Extent, fitted: Extent): boolean {
  const size = extent.box.getSize(new Vector3()).length(), fitted_size = fitted.box.getSize(new Vector3()).length();
  const tolerated = fitted.box.clone().expandByScalar(MARGIN * fitted_size);
  return tolerated.containsBox(extent.box) && size > (1 - SHRINKAGE) * fitted_size;
}
