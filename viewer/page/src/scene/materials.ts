// SPDX-License-Identifier: BSD-3-Clause
// The shaders of the scene. Colors are those of the style sheet, so nothing converts color spaces. In 3-D, what is farther
// away fades into the background.
import { Color, DoubleSide, GLSL3, ShaderMaterial } from "three";
import { MOST_CLASSES } from "./coloring";

/** Uniforms that all materials share. The view sets them before each picture. */
export const shared = {
  background: { value: new Color() },
  /** Depths at which fading begins and ends, and its strength. */
  fade_near: { value: 0 },
  fade_far: { value: 1 },
  fade: { value: 0 },
  pixel_ratio: { value: 1 },
  class_colors: { value: Array.from({ length: MOST_CLASSES }, () => new Color()) },
};

const FADE = `
  uniform vec3 background;
  uniform float fade_near, fade_far, fade;
  vec3 faded(vec3 color, float depth) {
    return mix(color, background, fade * clamp((depth - fade_near) / (fade_far - fade_near), 0.0, 1.0));
  }`;

/** The color of a vertex: that of its class if `uses_classes` is 1. */
const CLASS = `
  uniform vec3 class_colors[${MOST_CLASSES}];
  uniform float uses_classes;
  vec3 classed(vec3 color, float vertex_class) { return mix(color, class_colors[int(vertex_class)], uses_classes); }`;

const OUTPUT = "layout(location = 0) out highp vec4 pixel;";

export function lineMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    transparent: true,
    depthWrite: false,
    uniforms: { ...shared, color: { value: new Color() }, opacity: { value: 1 } },
    vertexShader: `
      out float depth;
      void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        depth = -place.z;
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: `
      ${OUTPUT}
      ${FADE}
      uniform vec3 color;
      uniform float opacity;
      in float depth;
      void main() { pixel = vec4(faded(color, depth), opacity); }`,
  });
}

/** Points of constant size on the screen: discs, or rings if `is_ring`. */
export function pointMaterial(is_ring: boolean): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    uniforms: { ...shared, color: { value: new Color() }, size: { value: 2 }, uses_classes: { value: 0 } },
    vertexShader: `
      ${CLASS}
      uniform vec3 color;
      uniform float size, pixel_ratio;
      in float vertex_class;
      out vec3 tinted;
      out float depth;
      void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        depth = -place.z;
        gl_Position = projectionMatrix * place;
        gl_PointSize = size * pixel_ratio;
        tinted = classed(color, vertex_class);
      }`,
    fragmentShader: `
      ${OUTPUT}
      ${FADE}
      uniform float size;
      in vec3 tinted;
      in float depth;
      void main() {
        float radius = 2.0 * length(gl_PointCoord - 0.5);
        if (size > 2.0 && radius > 1.0) discard;
        ${is_ring ? "if (radius < 0.6) discard;" : ""}
        pixel = vec4(faded(tinted, depth), 1.0);
      }`,
  });
}

/**
 * The outline of an ellipsoid per vertex, as the camera sees it: the image of a circle of the unit ball. `instance_position` is the
 * center, and `instance_x`, `instance_y` and `instance_z` are the columns of the matrix M that maps the ball to the ellipsoid. Rays
 * d of the camera touch the ellipsoid at M p with p ⟂ M⁻¹d, which is parallel to adj(M) d, also if M is flat.
 */
export function ellipseMaterial(opacity: number): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    uniforms: { ...shared, color: { value: new Color() }, opacity: { value: opacity } },
    vertexShader: `
      in vec3 instance_position, instance_x, instance_y, instance_z;
      in float instance_visible;
      out float depth;
      void main() {
        vec4 center = modelViewMatrix * vec4(instance_position, 1.0);
        mat3 M = mat3(modelViewMatrix) * mat3(instance_x, instance_y, instance_z);
        vec3 d = normalize(center.xyz);
        vec3 w = vec3(dot(cross(M[1], M[2]), d), dot(cross(M[2], M[0]), d), dot(cross(M[0], M[1]), d));
        w = dot(w, w) > 0.0 ? normalize(w) : vec3(0.0, 0.0, 1.0);
        vec3 u = normalize(cross(w, abs(w.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
        vec3 offset = M * (position.x * u + position.y * cross(w, u));
        vec4 place = center + vec4(instance_visible * offset, 0.0);
        depth = -place.z;
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: `
      ${OUTPUT}
      ${FADE}
      uniform vec3 color;
      uniform float opacity;
      in float depth;
      void main() { pixel = vec4(faded(color, depth), opacity); }`,
  });
}

/** One shape per vertex, placed by `instance_position` and `instance_orientation`. */
export function instanceMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    uniforms: {
      ...shared, color: { value: new Color() }, fixed_color: { value: new Color() }, size: { value: 1 },
      uses_classes: { value: 0 },
    },
    vertexShader: `
      ${CLASS}
      uniform float size;
      uniform vec3 color, fixed_color;
      in vec3 tint, instance_position;
      in vec4 instance_orientation;
      in float instance_visible, instance_fixed, instance_class;
      out vec3 tinted;
      out float depth;
      vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
      void main() {
        vec3 offset = instance_visible * size * rotated(instance_orientation, position);
        vec4 place = modelViewMatrix * vec4(instance_position + offset, 1.0);
        depth = -place.z;
        tinted = tint * classed(mix(color, fixed_color, instance_fixed), instance_class);
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: `
      ${OUTPUT}
      ${FADE}
      in vec3 tinted;
      in float depth;
      void main() { pixel = vec4(faded(tinted, depth), 1.0); }`,
  });
}
