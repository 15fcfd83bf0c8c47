// SPDX-License-Identifier: BSD-3-Clause
// The shaders of the scene. Colors are those of the style sheet, so nothing converts color spaces. In 3-D, what is farther
// away fades into the background.
import { Color, DoubleSide, GLSL3, ShaderMaterial } from "three";

/** Uniforms that all materials share. The view sets them before each picture. */
export const shared = {
  background: { value: new Color() },
  /** Depths at which fading begins and ends, and its strength. */
  fade_near: { value: 0 },
  fade_far: { value: 1 },
  fade: { value: 0 },
  pixel_ratio: { value: 1 },
};

const FADE = `
  uniform vec3 background;
  uniform float fade_near, fade_far, fade;
  vec3 faded(vec3 color, float depth) {
    return mix(color, background, fade * clamp((depth - fade_near) / (fade_far - fade_near), 0.0, 1.0));
  }`;

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
    uniforms: { ...shared, color: { value: new Color() }, size: { value: 2 } },
    vertexShader: `
      uniform float size, pixel_ratio;
      out float depth;
      void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        depth = -place.z;
        gl_Position = projectionMatrix * place;
        gl_PointSize = size * pixel_ratio;
      }`,
    fragmentShader: `
      ${OUTPUT}
      ${FADE}
      uniform vec3 color;
      uniform float size;
      in float depth;
      void main() {
        float radius = 2.0 * length(gl_PointCoord - 0.5);
        if (size > 2.0 && radius > 1.0) discard;
        ${is_ring ? "if (radius < 0.6) discard;" : ""}
        pixel = vec4(faded(color, depth), 1.0);
      }`,
  });
}

/** One shape per vertex, placed by `instance_position` and `instance_orientation`. */
export function instanceMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    uniforms: { ...shared, color: { value: new Color() }, fixed_color: { value: new Color() }, size: { value: 1 } },
    vertexShader: `
      uniform float size;
      uniform vec3 color, fixed_color;
      in vec3 tint, instance_position;
      in vec4 instance_orientation;
      in float instance_visible, instance_fixed;
      out vec3 tinted;
      out float depth;
      vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
      void main() {
        vec3 offset = instance_visible * size * rotated(instance_orientation, position);
        vec4 place = modelViewMatrix * vec4(instance_position + offset, 1.0);
        depth = -place.z;
        tinted = tint * mix(color, fixed_color, instance_fixed);
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
