// The domain of one face, with circumellipses.

const MOST_ELLIPSES = 1500, SEGMENTS_OF_ELLIPSE = 72;

class DomainView {
  constructor(mesh, canvas) {
    this.mesh = mesh;
    this.canvas = canvas;
    this.face = -1;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setClearColor(0, 0);
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
    this.camera.position.z = 1;
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableRotate = false;
    this.controls.screenSpacePanning = true;
    this.controls.mouseButtons = { LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.PAN };
    this.controls.touches = { ONE: THREE.TOUCH.PAN, TWO: THREE.TOUCH.DOLLY_PAN };
    this.controls.addEventListener("change", () => { this.isStale = true; });
    this.material = shadedMaterial(NO_PLANE);
    this.material.uniforms.isFlat.value = 1;
    this.material.uniforms.fadingSteps.value.set(0.25, 0.8);
    this.borderMaterial = new THREE.LineMaterial({ color: 0x1c2733, linewidth: 1.8 });
    this.ellipseMaterial = new THREE.LineMaterial({ color: MARK, linewidth: 1 });
    this.hoveredMaterial = new THREE.LineMaterial({ color: MARK, linewidth: 2 });
    this.overlayMaterial = new THREE.MeshBasicMaterial({ color: MARK, transparent: true, opacity: 0.6, depthTest: false });
    this.areAllShown = false;
  }

  // Places in the picture: the domain's larger side is 2. One that is more than four times as long as wide is drawn two to one.
  placing(face) {
    const [u0, v0, u1, v1] = this.mesh.domains[face], width = u1 - u0, height = v1 - v0;
    const ratio = width > 0 && height > 0 ? height / width : 1;
    this.stretch = ratio > 4 || ratio < 0.25 ? (ratio > 1 ? 2 : 0.5) / ratio : 1; // of v against u
    const shownRatio = ratio * this.stretch, x = shownRatio > 1 ? 2 / shownRatio : 2;
    return { x, y: x * shownRatio };
  }

  show(face, colors) {
    this.clear();
    this.face = face;
    const mesh = this.mesh, begin = mesh.begins[face], end = mesh.begins[face + 1], corners = mesh.triangles.subarray(3 * begin, 3 * end);
    this.size = this.placing(face);
    const uv = mesh.parameters, positions = new Float32Array(3 * corners.length);
    for (let i = 0; i < corners.length; ++i) {
      positions[3 * i] = (uv[2 * corners[i]] - 0.5) * this.size.x;
      positions[3 * i + 1] = (uv[2 * corners[i] + 1] - 0.5) * this.size.y;
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(new Int8Array(4 * corners.length), 4, true));
    this.paint = paintOf(colors.subarray(3 * begin, 3 * end));
    geometry.setAttribute("paint", new THREE.BufferAttribute(this.paint, 4, true));
    geometry.setAttribute("code", new THREE.BufferAttribute(codesOf(begin, end), 4, true));
    this.positions = positions;
    this.geometry = geometry;
    this.triangles = new THREE.Mesh(geometry, this.material);
    this.picker = this.picker || new Picker(this.renderer, geometry, NO_PLANE);
    this.picker.mesh.geometry = geometry;
    const part = new THREE.BufferGeometry();
    part.setAttribute("position", geometry.attributes.position);
    part.setDrawRange(0, 0);
    this.overlay = new THREE.Mesh(part, this.overlayMaterial);
    this.border = this.lines(this.borderEnds(corners), this.borderMaterial);
    this.ellipses = this.lines([], this.ellipseMaterial);
    this.ellipse = this.lines([], this.hoveredMaterial);
    [this.triangles, this.overlay, this.border, this.ellipses, this.ellipse].forEach((object, i) => {
      object.frustumCulled = false;
      object.renderOrder = i;
      this.scene.add(object);
    });
    this.showEllipses(this.areAllShown);
    this.fit();
  }

  clear() {
    for (const object of this.scene.children.slice()) {
      this.scene.remove(object);
      object.geometry.dispose();
    }
  }

  lines(ends, material) {
    const geometry = new THREE.LineSegmentsGeometry();
    if (ends.length > 0) geometry.setPositions(ends);
    const result = new THREE.LineSegments2(geometry, material);
    result.visible = ends.length > 0;
    return result;
  }

  replaceLines(object, ends) {
    object.geometry.dispose();
    object.geometry = new THREE.LineSegmentsGeometry();
    object.visible = ends.length > 0;
    if (ends.length > 0) object.geometry.setPositions(ends);
    this.isStale = true;
  }

  // Sides that only one triangle has.
  borderEnds(corners) {
    const factor = 2 ** 26, sides = new Float64Array(corners.length); // both ends of a side in one number, which 53 bits hold
    for (let i = 0; i < corners.length; ++i) {
      const a = corners[i], b = corners[i % 3 === 2 ? i - 2 : i + 1];
      sides[i] = Math.min(a, b) * factor + Math.max(a, b);
    }
    sides.sort();
    const ends = [], uv = this.mesh.parameters;
    const add = v => ends.push((uv[2 * v] - 0.5) * this.size.x, (uv[2 * v + 1] - 0.5) * this.size.y, 0);
    for (let i = 0; i < sides.length; ++i) {
      if (sides[i] === sides[i + 1]) { ++i; continue; }
      add(Math.floor(sides[i] / factor));
      add(sides[i] % factor);
    }
    return ends;
  }

  place(corner) { return [this.positions[3 * corner], this.positions[3 * corner + 1]]; }

  // The ends of segments of the ellipse through the corners of a triangle that its tensor sees as a circle; none where there is no tensor.
  ellipseEnds(triangle) {
    const mesh = this.mesh, t = triangle - mesh.begins[this.face], [u0, v0, u1, v1] = mesh.domains[this.face];
    if (!mesh.stretches || Number.isNaN(mesh.stretches[triangle]) || Number.isNaN(mesh.skews[triangle])) return [];
    // In the coordinates of the picture, where u is x times scaleU.
    const scaleU = this.size.x / ((u1 - u0) || 1), scaleV = this.size.y / ((v1 - v0) || 1);
    const ratio = Math.exp(mesh.stretches[triangle]) * (scaleV / scaleU) ** 2;
    const e = Math.sqrt(ratio), g = 1 / e, f = Math.tanh(mesh.skews[triangle]);
    const [p, q, r] = [0, 1, 2].map(i => this.place(3 * t + i)), a = [q[0] - p[0], q[1] - p[1]], b = [r[0] - p[0], r[1] - p[1]];
    const product = (x, y) => e * x[0] * y[0] + f * (x[0] * y[1] + x[1] * y[0]) + g * x[1] * y[1];
    const rows = [[e * a[0] + f * a[1], f * a[0] + g * a[1]], [e * b[0] + f * b[1], f * b[0] + g * b[1]]];
    const right = [0.5 * product(a, a), 0.5 * product(b, b)];
    const determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    const c = [(right[0] * rows[1][1] - rows[0][1] * right[1]) / determinant,
               (rows[0][0] * right[1] - rows[1][0] * right[0]) / determinant];
    const d = product(c, c), skew = Math.sqrt(Math.max(g - f * f / e, 0));
    if (!isFinite(d) || !(skew > 0)) return [];
    // The tensor is the square of the matrix with the rows (sqrt(e), f / sqrt(e)) and (0, skew).
    const ends = [], point = i => {
      const angle = 2 * Math.PI * i / SEGMENTS_OF_ELLIPSE, y = Math.sqrt(d) * Math.sin(angle) / skew;
      return [p[0] + c[0] + (Math.sqrt(d) * Math.cos(angle) - f / Math.sqrt(e) * y) / Math.sqrt(e), p[1] + c[1] + y, 0];
    };
    for (let i = 0; i < SEGMENTS_OF_ELLIPSE; ++i) ends.push(...point(i), ...point(i + 1));
    return ends;
  }

  showEllipses(areAllShown) {
    this.areAllShown = areAllShown;
    if (this.face < 0) return;
    const begin = this.mesh.begins[this.face], number = this.mesh.begins[this.face + 1] - begin;
    const step = Math.max(1, number / MOST_ELLIPSES), ends = [];
    if (areAllShown) for (let i = 0; i < number; i += step) ends.push(...this.ellipseEnds(begin + Math.floor(i)));
    this.replaceLines(this.ellipses, ends);
  }

  hover(triangle) {
    if (this.face < 0) return;
    const isHere = triangle >= this.mesh.begins[this.face] && triangle < this.mesh.begins[this.face + 1];
    this.overlay.geometry.setDrawRange(isHere ? 3 * (triangle - this.mesh.begins[this.face]) : 0, isHere ? 3 : 0);
    this.replaceLines(this.ellipse, isHere ? this.ellipseEnds(triangle) : []);
  }

  pick(x, y) { return this.face < 0 ? -1 : this.picker.pick(this.camera, x, y); }

  setColors(colors) {
    if (this.face < 0) return;
    setColors(this.paint, colors.subarray(3 * this.mesh.begins[this.face], 3 * this.mesh.begins[this.face + 1]));
    this.geometry.attributes.paint.needsUpdate = true;
    this.isStale = true;
  }

  setTheme(color) {
    this.borderMaterial.color = new THREE.Color(color);
    this.material.uniforms.edgeColor.value = new THREE.Color(color);
    this.isStale = true;
  }

  // Room around the domain for ellipses that reach out of it.
  fit() {
    const room = 1.12, half = Math.max(0.5 * this.size.y, 0.5 * this.size.x / this.aspect) * room;
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(0, 0, 1);
    this.camera.zoom = 1;
    Object.assign(this.camera, { left: -half * this.aspect, right: half * this.aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.isStale = true;
  }

  // Puts a triangle in the middle if it is not in sight.
  goTo(triangle) {
    const t = triangle - this.mesh.begins[this.face], middle = new THREE.Vector3();
    for (let i = 0; i < 3; ++i) middle.add(new THREE.Vector3(...this.place(3 * t + i), 0));
    middle.divideScalar(3);
    const seen = middle.clone().project(this.camera);
    if (Math.abs(seen.x) < 0.9 && Math.abs(seen.y) < 0.9) return;
    this.controls.target.copy(middle);
    this.camera.position.set(middle.x, middle.y, 1);
    this.controls.update();
    this.isStale = true;
  }

  resize(width, height) {
    if (width < 1 || height < 1) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.aspect = width / height;
    for (const material of [this.borderMaterial, this.ellipseMaterial, this.hoveredMaterial]) material.resolution.set(width, height);
    if (this.face >= 0) this.fit();
  }

  update() {
    if (!this.isStale || this.face < 0) return;
    this.isStale = false;
    this.renderer.render(this.scene, this.camera);
  }
}
