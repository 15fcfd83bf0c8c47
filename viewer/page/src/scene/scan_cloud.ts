// SPDX-License-Identifier: BSD-3-Clause
// The points that lasers have hit, as one cloud. Each scan moves with its pose.
import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, Points } from "three";
import type { Frame, Scans } from "../protocol/messages";
import { pointMaterial } from "./materials";
import { spreadOrder } from "./spread";
import type { Vertices } from "./vertices";

const PIXELS = 1.5;

export class ScanCloud {
  readonly object: Points<BufferGeometry, ReturnType<typeof pointMaterial>>;
  private readonly positions: BufferAttribute;
  private readonly index: BufferAttribute;
  /** The number of the scan of each point. */
  private readonly scan_of_point: Uint32Array;
  private readonly order: Uint32Array;
  private drawable = 0;

  constructor(private readonly scans: Scans) {
    const count = scans.points.length / 3;
    this.positions = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.index = new BufferAttribute(new Uint32Array(count), 1).setUsage(DynamicDrawUsage);
    this.scan_of_point = new Uint32Array(count);
    let first = 0;
    scans.counts.forEach((points, scan) => {
      this.scan_of_point.fill(scan, first, first + points);
      first += points;
    });
    this.order = spreadOrder(count);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.positions);
    geometry.setAttribute("vertex_class", new BufferAttribute(new Float32Array(count), 1));
    geometry.setIndex(this.index);
    this.object = new Points(geometry, pointMaterial(false));
    this.object.material.uniforms["size"]!.value = PIXELS;
    this.object.frustumCulled = false;
    this.object.renderOrder = -1;
  }

  update(frame: Pick<Frame, "positions" | "orientations">): void {
    placeScans(this.scans, frame, this.positions.array as Float32Array);
    this.positions.needsUpdate = true;
  }

  /** Hides the scans of poses that are not drawn. */
  updateVisible({ visible }: Vertices): void {
    const index = this.index.array as Uint32Array;
    this.drawable = 0;
    for (const point of this.order) {
      if (visible[this.scans.vertices[this.scan_of_point[point]!]!]) index[this.drawable++] = point;
    }
    this.index.needsUpdate = true;
  }

  /** The number of points that are drawn if the budget allows it. */
  get drawableCount(): number {
    return this.object.visible ? this.drawable : 0;
  }

  /** Draws only a part (0 to 1) of the points. */
  drawPart(part: number): void {
    this.object.geometry.setDrawRange(0, Math.ceil(this.drawable * part));
  }

  setColor(color: Color): void {
    this.object.material.uniforms["color"]!.value.copy(color);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

/** Writes where the points are: p + R v for the pose (p, R) of the scan. Points of a pose without a position are at 0. */
export function placeScans(scans: Scans, { positions, orientations }: Pick<Frame, "positions" | "orientations">,
  to: Float32Array): void {
  let at = 0;
  scans.vertices.forEach((vertex, scan) => {
    const [px, py, pz] = positions.subarray(3 * vertex, 3 * vertex + 3) as unknown as [number, number, number];
    const [x, y, z, w] = orientations.subarray(4 * vertex, 4 * vertex + 4) as unknown as [number, number, number, number];
    const end = at + 3 * scans.counts[scan]!;
    if (Number.isNaN(px)) to.fill(0, at, end);
    for (; at < end; at += 3) {
      if (Number.isNaN(px)) continue;
      const vx = scans.points[at]!, vy = scans.points[at + 1]!, vz = scans.points[at + 2]!;
      // v + 2 q × (q × v + w v) for the vector part q of the quaternion.
      const cx = y * vz - z * vy + w * vx, cy = z * vx - x * vz + w * vy, cz = x * vy - y * vx + w * vz;
      to[at] = px + vx + 2 * (y * cz - z * cy);
      to[at + 1] = py + vy + 2 * (z * cx - x * cz);
      to[at + 2] = pz + vz + 2 * (x * cy - y * cx);
    }
  });
}
