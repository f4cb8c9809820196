// The mesh in space.

const FIELD_OF_VIEW = 28; // degrees: little perspective, as drawings of machine parts have

function middleOf(mesh, t) {
  const result = new THREE.Vector3(), p = mesh.positions;
  for (let i = 0; i < 3; ++i) { const v = 3 * mesh.triangles[3 * t + i]; result.add(new THREE.Vector3(p[v], p[v + 1], p[v + 2])); }
  return result.divideScalar(3);
}

function cornersOf(mesh, t) {
  const p = mesh.positions;
  return [0, 1, 2].map(i => { const v = 3 * mesh.triangles[3 * t + i]; return new THREE.Vector3(p[v], p[v + 1], p[v + 2]); });
}

// Three vertices for each triangle, with what the vertices of the page have.
function cornerValues(values, size, triangles, Type, factor) {
  const step = size === 3 && Type === Int8Array ? 4 : size; // bytes in groups of four
  const result = new Type(step * triangles.length);
  for (let i = 0; i < triangles.length; ++i)
    for (let k = 0; k < size; ++k) result[step * i + k] = factor * values[size * triangles[i] + k];
  return result;
}

// Looks at the front side from 30 degrees beside the mean normal, and never level or straight down.
function chosenDirection(mesh) {
  const sum = new THREE.Vector3();
  let twiceArea = 0;
  const n = new THREE.Vector3();
  for (let t = 0; t < mesh.size; ++t) {
    const [a, b, c] = cornersOf(mesh, t);
    n.copy(b).sub(a).cross(c.sub(a));
    twiceArea += n.length();
    sum.add(n);
  }
  const horizontal = Math.hypot(sum.x, sum.y);
  const isSided = horizontal > 0.1 * twiceArea, isFromBelow = -sum.z > Math.max(horizontal, 0.1 * twiceArea);
  const azimuth = isSided ? Math.atan2(sum.y, sum.x) - Math.PI / 6 : -Math.PI / 3;
  const steepness = Math.atan2(Math.abs(sum.z), horizontal) * 180 / Math.PI;
  const elevation = (isFromBelow ? -1 : 1) * Math.min(Math.max(steepness - 30, 25), 40) * Math.PI / 180;
  return new THREE.Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
}

class SurfaceView {
  constructor(mesh, canvas, colors) {
    this.mesh = mesh;
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
    this.renderer.setClearColor(0, 0);
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = true;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 10);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.rotateSpeed = 0.9;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", () => { this.isStale = true; });
    this.controls.addEventListener("start", () => { this.flight = null; });
    this.addTriangles(colors);
    this.addLines();
    this.section = new Section(this);
    this.picker = new Picker(this.renderer, this.geometry, this.section.plane);
    this.isStale = true;
  }

  addTriangles(colors) {
    const mesh = this.mesh, geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(cornerValues(mesh.positions, 3, mesh.triangles, Float32Array, 1), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(cornerValues(mesh.normals, 3, mesh.triangles, Int8Array, 127), 4, true));
    this.paint = paintOf(colors);
    geometry.setAttribute("paint", new THREE.BufferAttribute(this.paint, 4, true));
    geometry.setAttribute("code", new THREE.BufferAttribute(codesOf(0, mesh.size), 4, true));
    geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(), 0.5 * mesh.diagonal);
    this.geometry = geometry;
    this.material = shadedMaterial(NO_PLANE);
    this.triangles = new THREE.Mesh(geometry, this.material);
    this.scene.add(this.triangles);
    this.selection = this.addOverlay(geometry, 0x2f8fe8, 0.16);
    this.hovered = this.addOverlay(geometry, MARK, 0.45);
    this.outlineMaterial = new THREE.LineMaterial({ color: MARK, linewidth: 2.5 });
    this.outline = new THREE.LineSegments2(new THREE.LineSegmentsGeometry(), this.outlineMaterial);
    this.outline.frustumCulled = this.outline.visible = false;
    this.outline.renderOrder = 3;
    this.scene.add(this.outline);
  }

  // The same triangles once more, as far as they are in a range.
  addOverlay(geometry, color, opacity) {
    const part = new THREE.BufferGeometry();
    part.setAttribute("position", geometry.attributes.position);
    part.setDrawRange(0, 0);
    part.boundingSphere = geometry.boundingSphere;
    const material = new THREE.MeshBasicMaterial({ color, transparent: true, opacity, side: THREE.DoubleSide, depthWrite: false });
    const overlay = new THREE.Mesh(part, material);
    overlay.renderOrder = 2;
    this.scene.add(overlay);
    return overlay;
  }

  addLines() {
    this.lineMaterial = new THREE.LineMaterial({ color: 0x1c2733, linewidth: 1.6 });
    this.lines = new THREE.LineSegments2(new THREE.LineSegmentsGeometry(), this.lineMaterial);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 1;
    this.areLinesWanted = true;
    this.scene.add(this.lines);
    this.showLines(() => true);
  }

  // Those at vertices for which it is true.
  showLines(isShown) {
    const mesh = this.mesh, ends = [];
    for (let i = 0; i < mesh.lines.length; i += 2)
      if (isShown(mesh.lines[i]) && isShown(mesh.lines[i + 1]))
        for (const v of [mesh.lines[i], mesh.lines[i + 1]])
          ends.push(mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]);
    this.lines.geometry.dispose();
    this.lines.geometry = new THREE.LineSegmentsGeometry();
    this.hasLines = ends.length > 0;
    if (this.hasLines) this.lines.geometry.setPositions(ends);
    this.setModelEdges(this.areLinesWanted);
  }

  // Hides faces, a set of their indices, and shows all others.
  hide(faces) {
    const mesh = this.mesh, isHidden = new Uint8Array(mesh.positions.length / 3);
    for (let f = 0; f < mesh.faces.length; ++f)
      for (let t = mesh.begins[f]; t < mesh.begins[f + 1]; ++t)
        for (let k = 0; k < 3; ++k) {
          this.paint[12 * t + 4 * k + 3] = k + (faces.has(f) ? 128 : 0);
          if (faces.has(f)) isHidden[mesh.triangles[3 * t + k]] = 1;
        }
    this.geometry.attributes.paint.needsUpdate = true;
    this.showLines(v => isHidden[v] === 0);
  }

  // Shows a place where there may be no triangle, or none if it is null.
  mark(place) {
    if (!this.marker) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3), 3));
      const material = new THREE.PointsMaterial({ color: MARK, size: 11, sizeAttenuation: false, depthTest: false, transparent: true });
      this.marker = new THREE.Points(geometry, material);
      this.marker.renderOrder = 4;
      this.scene.add(this.marker);
    }
    this.marker.visible = place !== null;
    if (place) this.marker.position.copy(place);
    this.isStale = true;
  }

  // `contrast`: of light and shadow, from 0 to 1
  setColors(colors, contrast) {
    this.material.uniforms.contrast.value = contrast;
    setColors(this.paint, colors);
    this.geometry.attributes.paint.needsUpdate = true;
    this.isStale = true;
  }

  // `color` of the lines, as CSS has it
  setTheme(color) {
    this.lineMaterial.color = new THREE.Color(color);
    this.material.uniforms.edgeColor.value = new THREE.Color(color);
    this.isStale = true;
  }

  setTriangleEdges(isShown) { this.material.uniforms.edgeWidth.value = isShown ? 1.25 : 0; this.isStale = true; }
  setModelEdges(isShown) { this.areLinesWanted = isShown; this.lines.visible = isShown && this.hasLines; this.isStale = true; }

  // Marks a face, unless it is all there is.
  select(face) {
    const begin = face < 0 ? 0 : this.mesh.begins[face], end = face < 0 ? 0 : this.mesh.begins[face + 1];
    this.selection.geometry.setDrawRange(3 * begin, end - begin === this.mesh.size ? 0 : 3 * (end - begin));
    this.isStale = true;
  }

  hover(triangle) {
    this.hovered.geometry.setDrawRange(triangle < 0 ? 0 : 3 * triangle, triangle < 0 ? 0 : 3);
    this.outline.visible = triangle >= 0;
    if (triangle >= 0) {
      const [a, b, c] = cornersOf(this.mesh, triangle);
      this.outline.geometry.dispose();
      this.outline.geometry = new THREE.LineSegmentsGeometry();
      this.outline.geometry.setPositions([a, b, b, c, c, a].reduce((ends, p) => ends.concat(p.toArray()), []));
    }
    this.isStale = true;
  }

  pick(x, y) { return this.picker.pick(this.camera, x, y); }

  // The point of a triangle at a place of the canvas.
  pointAt(triangle, x, y) {
    const ray = new THREE.Raycaster(), size = this.renderer.getSize(new THREE.Vector2());
    ray.setFromCamera(new THREE.Vector2(2 * x / size.x - 1, 1 - 2 * y / size.y), this.camera);
    const corners = cornersOf(this.mesh, triangle);
    const plane = new THREE.Plane().setFromCoplanarPoints(...corners);
    return ray.ray.intersectPlane(plane, new THREE.Vector3()) || middleOf(this.mesh, triangle);
  }

  // Where a point of space is on the canvas.
  placeOf(point) {
    const p = point.clone().project(this.camera), size = this.renderer.getSize(new THREE.Vector2());
    return { x: 0.5 * (p.x + 1) * size.x, y: 0.5 * (1 - p.y) * size.y };
  }

  // What shows all of the mesh from a direction.
  fitting(direction) {
    const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, this.camera.aspect, 1, 2);
    camera.up.set(0, 0, 1);
    camera.position.copy(direction);
    camera.lookAt(0, 0, 0);
    camera.updateMatrix();
    const axes = [0, 1, 2].map(i => new THREE.Vector3().setFromMatrixColumn(camera.matrix, i)), p = this.mesh.positions;
    // A point (x, y, z) is seen from (a, b, d) if |x - a| and |y - b| are at most (d - z) times the slopes of the sides of the view.
    // There is room for the title and the tools.
    const tangent = Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180), slopes = [0.90 * tangent * this.camera.aspect, 0.78 * tangent];
    const low = [-Infinity, -Infinity], high = [-Infinity, -Infinity], point = new THREE.Vector3();
    let depth = 0;
    for (let i = 0; i < p.length; i += 3) {
      point.set(p[i], p[i + 1], p[i + 2]);
      const z = axes[2].dot(point);
      for (let k = 0; k < 2; ++k) {
        const x = axes[k].dot(point);
        low[k] = Math.max(low[k], slopes[k] * z - x);
        high[k] = Math.max(high[k], slopes[k] * z + x);
      }
      depth += 3 * z / p.length;
    }
    const place = [0, 1].map(k => 0.5 * (high[k] - low[k])), distance = Math.max(...[0, 1].map(k => 0.5 * (high[k] + low[k]) / slopes[k]));
    const target = axes[0].clone().multiplyScalar(place[0]).addScaledVector(axes[1], place[1]).addScaledVector(axes[2], depth);
    return { target, position: target.clone().addScaledVector(axes[2], Math.max(distance - depth, 1e-3 * this.mesh.diagonal)) };
  }

  setView(view) {
    this.controls.target.copy(view.target);
    this.camera.position.copy(view.position);
    this.controls.update();
    this.isStale = true;
  }

  direction() { return this.camera.position.clone().sub(this.controls.target).normalize(); }

  // Moves there within a third of a second.
  fly(view) {
    const from = { target: this.controls.target.clone(), position: this.camera.position.clone() };
    this.flight = { from, to: view, begin: performance.now() };
    this.isStale = true;
  }

  // Looks at a place from the side where its triangle faces to, from so far that `size` is about a sixth of the view.
  flyTo(place, normal, size) {
    const direction = this.direction();
    if (normal && direction.dot(normal) < 0.35) direction.addScaledVector(normal, 1.2 - direction.dot(normal)).normalize();
    if (Math.abs(direction.z) > 0.999) direction.set(0.04, 0, Math.sign(direction.z)).normalize();
    const distance = 6 * size / (2 * Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180));
    this.fly({ target: place.clone(), position: place.clone().addScaledVector(direction, distance) });
  }

  continueFlight() {
    if (!this.flight) return;
    const { from, to, begin } = this.flight, share = Math.min((performance.now() - begin) / 350, 1), s = share * share * (3 - 2 * share);
    this.setView({ target: from.target.clone().lerp(to.target, s), position: from.position.clone().lerp(to.position, s) });
    if (share === 1) this.flight = null;
  }

  resize(width, height) {
    if (width < 1 || height < 1) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const material of [this.lineMaterial, this.outlineMaterial]) material.resolution.set(width, height);
    this.isStale = true;
  }

  // Draws if something has changed.
  update() {
    this.continueFlight();
    this.controls.update();
    if (!this.isStale) return;
    this.isStale = false;
    const distance = this.camera.position.length(), radius = 0.51 * this.mesh.diagonal;
    this.camera.near = Math.max(distance - radius, 1e-3 * this.camera.position.distanceTo(this.controls.target), 1e-6 * radius);
    this.camera.far = Math.max(distance + radius, 2 * this.camera.near);
    this.camera.updateProjectionMatrix();
    this.section.update();
    this.renderer.render(this.scene, this.camera);
  }
}
