// SPDX-License-Identifier: BSD-3-Clause
// The camera and how the mouse and the keys move it. Graphs with 2 dimensions are seen from above with y up; the others turn
// about a point, with z up.
import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Extent } from "./statistics";

const FIELD_OF_VIEW = 40;
/** In pixels of the picture at each press of a key. */
const KEY_PAN_SPEED = 30, KEY_ROTATE_SPEED = 10;
/** Looking straight down, a small slope determines which way is up in the picture. */
const FROM_ABOVE = new Vector3(0, -1e-4, 1).normalize();
/** The graph takes this part of the window. */
const FILLED = 0.9;

/** A camera that turns about the target, or one that looks down on a plane and shows `height` of it. */
export type CameraState =
  | { kind: "perspective"; position: Triple; target: Triple }
  | { kind: "orthographic"; target: Triple; height: number };

export type Triple = [number, number, number];

export class CameraRig {
  camera: OrthographicCamera | PerspectiveCamera = new PerspectiveCamera();
  private controls: OrbitControls | null = null;
  private aspect = 1;
  private is_flat = false;
  private is_fitting = false;
  /** True while a button or a finger that moves the camera is down. */
  isHeld = false;

  /** `on_move` is called whenever the user moved the camera, `on_release` when a button or finger is up again. */
  constructor(
    private readonly canvas: HTMLCanvasElement, private readonly on_move: () => void, private readonly on_release: () => void,
  ) {}

  /** Begins anew, with a camera that looks along `direction`. */
  reset(is_flat: boolean, direction: Vector3): void {
    this.controls?.dispose();
    this.is_flat = is_flat;
    this.camera = is_flat ? new OrthographicCamera() : new PerspectiveCamera(FIELD_OF_VIEW, this.aspect);
    this.camera.up.set(0, is_flat ? 1 : 0, is_flat ? 0 : 1);
    this.camera.position.copy(direction).negate();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.zoomSpeed = 1.5;
    this.controls.enableRotate = !is_flat;
    if (is_flat) {
      this.controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
      this.controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    } else {
      this.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
    }
    this.controls.keyPanSpeed = KEY_PAN_SPEED;
    this.controls.keyRotateSpeed = KEY_ROTATE_SPEED;
    this.controls.listenToKeyEvents(this.canvas);
    this.controls.addEventListener("start", () => (this.isHeld = true));
    this.controls.addEventListener("end", () => {
      this.isHeld = false;
      this.on_release();
    });
    this.controls.addEventListener("change", () => {
      if (!this.is_fitting) this.on_move();
    });
  }

  /** The distance from the camera to the point about which it turns. */
  get distance(): number {
    return this.controls ? this.camera.position.distanceTo(this.controls.target) : 1;
  }

  resize(width: number, height: number): void {
    this.aspect = width / Math.max(1, height);
    if (this.camera instanceof PerspectiveCamera) this.camera.aspect = this.aspect;
    else this.setHeight(this.camera.top - this.camera.bottom);
    this.camera.updateProjectionMatrix();
  }

  /** Shows the whole extent, without a change of direction. */
  fit({ box, sample }: Extent): void {
    if (!this.controls) return;
    const center = box.getCenter(new Vector3());
    const radius = Math.max(0.5 * box.getSize(new Vector3()).length(), 1e-6);
    const backward = this.camera.position.clone().sub(this.controls.target).normalize();
    if (this.camera instanceof OrthographicCamera) {
      const size = box.getSize(new Vector3());
      this.setHeight(Math.max(size.y, size.x / this.aspect, 1e-6) / FILLED);
      this.camera.zoom = 1;
      this.place(center, backward, 2 * radius);
    } else {
      this.place(...fitPerspective(sample, center, backward, this.camera.up, this.aspect));
    }
    this.setDepthRange(radius);
  }

  zoom(factor: number): void {
    if (!this.controls) return;
    if (this.camera instanceof OrthographicCamera) {
      this.camera.zoom *= factor;
      this.camera.updateProjectionMatrix();
    } else {
      this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    }
    this.controls.update();
    // The controls do not notice another zoom of a flat camera.
    this.on_move();
  }

  /** Looks down with y up, at the same point. */
  lookFromAbove(): void {
    if (this.controls && !this.is_flat) this.place(this.controls.target.clone(), FROM_ABOVE, this.distance);
  }

  /** `origin` is where the scene's origin is in the coordinates of the state. */
  state(origin: Vector3): CameraState {
    const from_world = (place: Vector3): Triple => place.clone().add(origin).toArray();
    const target = from_world(this.controls?.target ?? new Vector3());
    if (this.camera instanceof OrthographicCamera)
      return { kind: "orthographic", target, height: (this.camera.top - this.camera.bottom) / this.camera.zoom };
    return { kind: "perspective", position: from_world(this.camera.position), target };
  }

  setState(state: CameraState, origin: Vector3): void {
    if ((state.kind === "orthographic") !== this.is_flat)
      throw new Error(`it is a camera for graphs with ${state.kind === "orthographic" ? 2 : 3} dimensions`);
    const target = new Vector3(...state.target).sub(origin);
    if (state.kind === "orthographic") {
      this.setHeight(state.height);
      this.camera.zoom = 1;
      this.place(target, new Vector3(0, 0, 1), this.distance);
    } else {
      const backward = new Vector3(...state.position).sub(origin).sub(target);
      this.place(target, backward.clone().normalize(), backward.length());
    }
  }

  /** Moves the camera, without a change of its direction and distance. */
  lookAt(target: Vector3): void {
    if (!this.controls) return;
    const backward = this.camera.position.clone().sub(this.controls.target);
    this.place(target, backward.clone().normalize(), backward.length());
  }

  /** Adapts the depth range to what is visible; `radius` is that of the graph. */
  setDepthRange(radius: number): void {
    const far = this.distance + 50 * radius;
    this.camera.near = this.is_flat ? 0 : Math.max(0.01 * this.distance, 1e-5 * far);
    this.camera.far = far;
    this.camera.updateProjectionMatrix();
  }

  private place(target: Vector3, backward: Vector3, distance: number): void {
    this.is_fitting = true;
    this.controls!.target.copy(target);
    this.camera.position.copy(target).addScaledVector(backward, distance);
    this.camera.updateProjectionMatrix();
    this.controls!.update();
    this.is_fitting = false;
  }

  private setHeight(height: number): void {
    const camera = this.camera as OrthographicCamera;
    camera.top = 0.5 * height;
    camera.bottom = -0.5 * height;
    camera.right = 0.5 * height * this.aspect;
    camera.left = -camera.right;
  }
}

/** Returns the target, the direction back, and the least distance from which all points of the sample are in the picture. */
function fitPerspective(
  sample: Vector3[], center: Vector3, backward: Vector3, up: Vector3, aspect: number,
): [Vector3, Vector3, number] {
  const right = new Vector3().crossVectors(up, backward).normalize();
  const upward = new Vector3().crossVectors(backward, right);
  const slope_y = FILLED * Math.tan((0.5 * FIELD_OF_VIEW * Math.PI) / 180);
  const slope_x = slope_y * aspect;
  // Along each axis of the picture, the two outermost lines of sight determine a distance and a shift.
  const most = { left: -Infinity, right: -Infinity, down: -Infinity, up: -Infinity, near: -Infinity };
  for (const point of sample) {
    const offset = point.clone().sub(center);
    const x = offset.dot(right), y = offset.dot(upward), z = offset.dot(backward);
    most.right = Math.max(most.right, x + slope_x * z);
    most.left = Math.max(most.left, -x + slope_x * z);
    most.up = Math.max(most.up, y + slope_y * z);
    most.down = Math.max(most.down, -y + slope_y * z);
    most.near = Math.max(most.near, z);
  }
  const distance = Math.max(
    (0.5 * (most.right + most.left)) / slope_x,
    (0.5 * (most.up + most.down)) / slope_y,
    1.02 * most.near,
    1e-6,
  );
  const target = center
    .clone()
    .addScaledVector(right, 0.5 * (most.right - most.left))
    .addScaledVector(upward, 0.5 * (most.up - most.down));
  return [target, backward, distance];
}
