// A plane that cuts the mesh. Where the mesh is closed, the cut is shown as solid: back faces are counted against front faces in the
// stencil buffer, and the plane is drawn where their numbers differ.

class Section {
  constructor(view) {
    this.view = view;
    this.plane = new THREE.Vector4(0, 0, 0, 1); // keeps points with x . xyz <= w
    this.clipping = new THREE.Plane();
    this.axis = "";
    this.isFlipped = this.isSeenFromBehind = false;
    this.share = 0.5;
    view.material.uniforms.plane.value = this.plane;
    this.caps = view.mesh.isClosed ? this.makeCaps() : [];
  }

  makeCaps() {
    const count = (side, operation) => {
      const material = new THREE.ShaderMaterial({
        uniforms: { plane: { value: this.plane } }, vertexShader: VERTEX_SHADER, fragmentShader: PICKING_FRAGMENT_SHADER, side,
        depthWrite: false, depthTest: false, colorWrite: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc,
        stencilFail: operation, stencilZFail: operation, stencilZPass: operation
      });
      const mesh = new THREE.Mesh(this.view.geometry, material);
      mesh.renderOrder = -2;
      return mesh;
    };
    this.capMaterial = new THREE.ShaderMaterial({
      uniforms: { color: { value: new THREE.Color(0x9fb0c0) }, line: { value: new THREE.Color(0x7f93a6) } },
      vertexShader: "void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
      fragmentShader: `
uniform vec3 color, line;
void main() {
  float x = mod(gl_FragCoord.x + gl_FragCoord.y, 11.0);
  gl_FragColor = vec4(mix(line, color, smoothstep(0.6, 1.4, abs(x - 5.5))), 1.0);
}`,
      side: THREE.DoubleSide, stencilWrite: true, stencilRef: 0, stencilFunc: THREE.NotEqualStencilFunc,
      stencilFail: THREE.KeepStencilOp, stencilZFail: THREE.KeepStencilOp, stencilZPass: THREE.KeepStencilOp
    });
    this.cap = new THREE.Mesh(new THREE.PlaneBufferGeometry(1, 1), this.capMaterial);
    this.cap.renderOrder = -1;
    const caps = [count(THREE.BackSide, THREE.IncrementWrapStencilOp), count(THREE.FrontSide, THREE.DecrementWrapStencilOp), this.cap];
    for (const cap of caps) {
      cap.frustumCulled = false;
      cap.visible = false;
      this.view.scene.add(cap);
    }
    return caps;
  }

  setTheme(color, line) {
    if (!this.capMaterial) return;
    this.capMaterial.uniforms.color.value = new THREE.Color(color);
    this.capMaterial.uniforms.line.value = new THREE.Color(line);
  }

  // `axis`: "x", "y", "z", "view" for the direction of the view, or "" for none.
  set(axis, share, isFlipped) {
    if (axis !== this.axis) {
      this.viewNormal = this.view.direction();
      this.axis = axis;
      this.isSeenFromBehind = axis !== "" && this.normal().dot(this.viewNormal) < 0; // at first the cut faces the viewer
    }
    this.share = share;
    this.isFlipped = isFlipped;
    this.view.isStale = true;
  }

  normal() {
    if (this.axis === "view") return this.viewNormal.clone();
    return new THREE.Vector3(this.axis === "x" ? 1 : 0, this.axis === "y" ? 1 : 0, this.axis === "z" ? 1 : 0);
  }

  // The range of the mesh along the normal of the plane, from its box.
  range(normal) {
    const e = this.view.mesh.extent, reach = 0.5 * (Math.abs(normal.x) * e[0] + Math.abs(normal.y) * e[1] + Math.abs(normal.z) * e[2]);
    return [-reach, reach];
  }

  update() {
    const isOn = this.axis !== "", clipping = isOn ? [this.clipping] : null;
    for (const cap of this.caps) cap.visible = isOn;
    for (const object of [this.view.selection, this.view.hovered, this.view.lines, this.view.outline])
      object.material.clippingPlanes = clipping;
    if (!isOn) { this.plane.set(0, 0, 0, 1); return; }
    const normal = this.normal(), [low, high] = this.range(normal);
    const place = low + this.share * (high - low), sign = this.isFlipped === this.isSeenFromBehind ? 1 : -1;
    this.plane.set(sign * normal.x, sign * normal.y, sign * normal.z, sign * place);
    this.clipping.set(normal.clone().multiplyScalar(-sign), sign * place);
    if (!this.cap) return;
    this.cap.scale.setScalar(2 * this.view.mesh.diagonal);
    this.cap.position.copy(normal).multiplyScalar(place);
    this.cap.lookAt(normal.clone().multiplyScalar(place + 1));
  }
}
