// SPDX-License-Identifier: BSD-3-Clause
// Draws a scene with smooth edges (four samples per pixel), which takes about three times as long without a graphics card. So
// the view decides for each picture, which the canvas itself cannot.
import {
  BufferAttribute, BufferGeometry, type Camera, GLSL3, Mesh, type Scene, ShaderMaterial, type WebGLRenderer, WebGLRenderTarget,
} from "three";

const SAMPLES = 4;

export class Smoothing {
  private readonly target = new WebGLRenderTarget(1, 1, { samples: SAMPLES });
  private readonly copy = new Mesh(triangle(), copyMaterial());

  constructor(private readonly renderer: WebGLRenderer) {
    this.copy.material.uniforms["picture"]!.value = this.target.texture;
    this.copy.frustumCulled = false;
  }

  /** Draws the scene on the canvas. */
  render(scene: Scene, camera: Camera): void {
    const { drawingBufferWidth, drawingBufferHeight } = this.renderer.getContext();
    this.target.setSize(drawingBufferWidth, drawingBufferHeight);
    this.renderer.setRenderTarget(this.target);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
    this.renderer.render(this.copy, camera);
  }
}

/** Covers the canvas. */
function triangle(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3));
  return geometry;
}

function copyMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    uniforms: { picture: { value: null } },
    vertexShader: "void main() { gl_Position = vec4(position, 1.0); }",
    fragmentShader: `
      layout(location = 0) out highp vec4 pixel;
      uniform sampler2D picture;
      void main() { pixel = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }`,
  });
}
