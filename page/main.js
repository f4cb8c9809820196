// Puts the page together.

function fail(text) {
  const failure = document.getElementById("failure");
  failure.textContent = text;
  failure.hidden = false;
}

class Page {
  constructor(mesh) {
    this.mesh = mesh;
    this.selected = -1;
    this.hovered = -1;
    this.rest = 0;
    this.hidden = new Set(); // faces
    this.colorings = coloringsOf(mesh);
    this.coloring = this.colorings[0];
    this.colors = this.coloring.colors();
    this.view = new SurfaceView(mesh, this.byId("surface"), this.colors);
    this.panel = new Panel(mesh, this.colorings, {
      coloring: name => this.setColoring(name), finding: (f, i) => this.goToFinding(f, i),
      faces: faces => this.goToFaces(faces), hide: faces => this.hide(faces)
    });
    this.showTitle();
    this.setTheme(window.matchMedia && matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.panel.showColoring(this.coloring);
    this.connectTools();
    this.connectPointer(this.byId("surface"), this.view);
    this.byId("surface").addEventListener("dblclick", event => this.turnAround(event));
    document.addEventListener("keydown", event => this.onKey(event));
    new ResizeObserver(() => this.resize()).observe(this.byId("stage"));
    this.resize();
    this.view.setView(this.view.fitting(chosenDirection(mesh)));
    this.draw();
  }

  byId(id) { return document.getElementById(id); }

  showTitle() {
    const mesh = this.mesh, counts = [];
    // A face that is divided, or that two parts share, counts once.
    const shown = new Set(mesh.faces.filter((face, f) => mesh.begins[f] < mesh.begins[f + 1]).map(face => face.number)).size;
    const plural = (n, what) => groupedNumber(n) + " " + what + (n === 1 ? "" : "s");
    if (mesh.parts.length > 1) counts.push(plural(mesh.parts.length, "part"));
    counts.push(plural(shown, "face"), plural(mesh.size, "triangle"), mesh.isClosed ? "closed" : "open");
    counts.push(mesh.extent.map(longNumber).join(" \u00d7 ") + (mesh.unit ? " " + mesh.unit : ""));
    document.title = mesh.title || "Mesh";
    this.byId("title").textContent = mesh.title;
    this.byId("counts").textContent = counts.join("  \u00b7  ");
  }

  setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    const style = getComputedStyle(document.documentElement), line = style.getPropertyValue("--line").trim();
    this.byId("theme").textContent = theme === "dark" ? "Light" : "Dark";
    this.view.setTheme(line);
    this.view.section.setTheme(theme === "dark" ? "#55636f" : "#b9c5d0", theme === "dark" ? "#46525d" : "#98a8b7");
    if (this.domain) this.domain.setTheme(line);
    this.panel.redrawHistograms();
  }

  setColoring(name) {
    this.coloring = this.colorings.find(c => c.name === name) || this.colorings[0];
    this.colors = this.coloring.colors();
    this.view.setColors(this.colors, this.coloring.legend.scalar ? 0.45 : 1); // shadows leave the colours of values readable
    if (this.domain) this.domain.setColors(this.colors);
    this.panel.showColoring(this.coloring);
  }

  connectTools() {
    const toggle = (id, change) => {
      const button = this.byId(id);
      button.addEventListener("click", () => {
        const isOn = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", isOn);
        change(isOn);
      });
    };
    toggle("triangle-edges", isOn => this.view.setTriangleEdges(isOn));
    toggle("model-edges", isOn => this.view.setModelEdges(isOn));
    this.byId("fit").addEventListener("click", () => this.view.fly(this.view.fitting(this.view.direction())));
    for (const button of document.querySelectorAll("[data-view]"))
      button.addEventListener("click", () => this.lookAlong(button.dataset.view));
    this.byId("theme").addEventListener("click", () => this.setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
    this.byId("panel-toggle").addEventListener("click", () => { this.byId("panel").hidden = !this.byId("panel").hidden; });
    this.byId("show-all").addEventListener("click", () => this.hide(null));
    this.byId("domain-close").addEventListener("click", () => this.clearSelection());
    this.byId("all-ellipses").addEventListener("change", event => { if (this.domain) this.domain.showEllipses(event.target.checked); });
    const axis = this.byId("section-axis"), place = this.byId("section-place"), flip = this.byId("section-flip");
    const cut = () => {
      place.disabled = flip.disabled = axis.value === "";
      this.view.section.set(axis.value, place.value / 1000, flip.getAttribute("aria-pressed") === "true");
    };
    axis.addEventListener("change", cut);
    place.addEventListener("input", cut);
    flip.addEventListener("click", () => { flip.setAttribute("aria-pressed", flip.getAttribute("aria-pressed") !== "true"); cut(); });
  }

  lookAlong(axis) {
    // Not quite along z, where it would not be known what is up.
    const direction = new THREE.Vector3(...{ x: [1, 0, 0], y: [0, -1, 0], z: [0, -1e-3, 1] }[axis]).normalize();
    if (this.view.direction().dot(direction) > 0.99) direction.negate();
    this.view.fly(this.view.fitting(direction));
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || /INPUT|SELECT/.test(event.target.tagName)) return;
    const button = { f: "fit", t: "triangle-edges", e: "model-edges" }[event.key.toLowerCase()];
    if (button) this.byId(button).click();
    else if (event.key === "Escape") this.clearSelection();
  }

  // Hovering, and clicks that are no drags.
  connectPointer(canvas, view) {
    let pressed = null;
    const place = event => {
      const box = canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    canvas.addEventListener("pointerdown", event => { pressed = place(event); this.hover(-1, null); }, true);
    canvas.addEventListener("pointermove", event => {
      if (event.buttons === 0) this.waiting = { view, place: place(event), time: performance.now() };
    });
    canvas.addEventListener("pointerleave", () => { this.waiting = null; this.hover(-1, null); });
    // At the document: the controls keep events of the canvas to themselves while a button is pressed.
    document.addEventListener("pointerup", event => {
      const here = place(event);
      if (pressed && event.button === 0 && Math.hypot(here.x - pressed.x, here.y - pressed.y) < 4) this.click(view, here);
      pressed = null;
    });
  }

  click(view, place) {
    const triangle = view.pick(place.x, place.y);
    if (triangle < 0) { if (view === this.view) this.clearSelection(); return; }
    this.select(triangle, view === this.view ? this.view.pointAt(triangle, place.x, place.y) : null);
  }

  select(triangle, point) {
    const face = this.mesh.triangleFaces[triangle];
    this.selected = triangle;
    this.view.select(face);
    this.view.mark(null);
    this.panel.showSelection(triangle, point);
    this.showDomain(face);
    this.hover(triangle, null);
    if (this.domain) this.domain.goTo(triangle);
  }

  clearSelection() {
    this.selected = -1;
    this.view.select(-1);
    this.view.mark(null);
    this.byId("domain-card").hidden = true;
    this.hover(-1, null);
  }

  // Hides more faces; shows all if there is no list.
  hide(faces) {
    if (faces) faces.forEach(f => this.hidden.add(f));
    else this.hidden.clear();
    if (this.selected >= 0 && this.hidden.has(this.mesh.triangleFaces[this.selected])) this.clearSelection();
    this.view.hide(this.hidden);
    this.panel.showNumberHidden(this.hidden.size);
  }

  showDomain(face) {
    if (!this.mesh.hasDomains) return;
    this.byId("domain-card").hidden = false;
    if (!this.domain) {
      this.domain = new DomainView(this.mesh, this.byId("domain"));
      this.domain.resize(this.byId("domain-stage").clientWidth, this.byId("domain-stage").clientHeight);
      new ResizeObserver(() => this.resize()).observe(this.byId("domain-stage"));
      this.domain.setTheme(getComputedStyle(document.documentElement).getPropertyValue("--line").trim());
      this.connectPointer(this.byId("domain"), this.domain);
    }
    if (this.domain.face !== face) this.domain.show(face, this.colors);
    this.panel.showDomain(face, this.domain);
  }

  // Where it takes long to find the triangle under the mouse, it is looked for only when the mouse rests.
  hoverWaiting() {
    const { view, place } = this.waiting, begin = performance.now();
    this.waiting = null;
    this.hover(view.pick(place.x, place.y), view === this.view ? place : null);
    this.rest = performance.now() - begin > 40 ? 150 : 0; // milliseconds
  }

  // Without a triangle, the selected one stays marked.
  hover(triangle, place) {
    const marked = triangle < 0 ? this.selected : triangle, tip = this.byId("tip");
    tip.hidden = triangle < 0 || !place;
    if (place && triangle >= 0) this.showTip(tip, triangle, place);
    if (marked === this.hovered) return;
    this.hovered = marked;
    this.view.hover(marked);
    if (this.domain) this.domain.hover(marked);
  }

  showTip(tip, triangle, place) {
    const mesh = this.mesh, f = mesh.triangleFaces[triangle], face = mesh.faces[f], scalar = this.coloring.legend.scalar || mesh.scalars[0];
    const part = face.part === undefined ? "" : mesh.parts[face.part].name + ", ";
    tip.textContent = part + faceName(mesh, f) + ", " + scalar.name + " " + longNumber(scalar.data[triangle]) + scalar.unit;
    const stage = this.byId("stage");
    tip.style.left = Math.min(place.x + 14, stage.clientWidth - tip.offsetWidth - 8) + "px";
    tip.style.top = Math.min(place.y + 16, stage.clientHeight - tip.offsetHeight - 8) + "px";
  }

  turnAround(event) {
    const box = this.byId("surface").getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const triangle = this.view.pick(x, y);
    if (triangle < 0) return;
    const target = this.view.pointAt(triangle, x, y), shift = target.clone().sub(this.view.controls.target);
    this.view.fly({ target, position: this.view.camera.position.clone().add(shift) });
  }

  goToFinding(finding, index) {
    if (index < finding.triangles.length) {
      const triangle = finding.triangles[index], face = this.mesh.triangleFaces[triangle];
      if (this.hidden.delete(face)) this.hide([]);
      const [a, b, c] = cornersOf(this.mesh, triangle), normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
      const size = Math.max(a.distanceTo(b), b.distanceTo(c), c.distanceTo(a));
      this.select(triangle, null);
      this.view.flyTo(middleOf(this.mesh, triangle), normal, Math.max(1.5 * size, 1e-4 * this.mesh.diagonal));
    } else if (index < finding.places.length) {
      const place = new THREE.Vector3(...finding.places[index]);
      this.clearSelection();
      this.view.mark(place);
      this.view.flyTo(place, null, 0.02 * this.mesh.diagonal);
    }
  }

  goToFaces(faces) {
    const box = new THREE.Box3();
    for (const f of faces)
      for (let t = this.mesh.begins[f]; t < this.mesh.begins[f + 1]; ++t) cornersOf(this.mesh, t).forEach(p => box.expandByPoint(p));
    if (box.isEmpty()) return;
    if (faces.length === 1) this.select(this.mesh.begins[faces[0]], null);
    this.view.flyTo(box.getCenter(new THREE.Vector3()), null, 0.35 * box.getSize(new THREE.Vector3()).length());
  }

  resize() {
    const stage = this.byId("stage");
    this.view.resize(stage.clientWidth, stage.clientHeight);
    if (this.domain) this.domain.resize(this.byId("domain-stage").clientWidth, this.byId("domain-stage").clientHeight);
  }

  draw() {
    if (this.waiting && performance.now() - this.waiting.time >= this.rest) this.hoverWaiting();
    this.view.update();
    if (this.domain) this.domain.update();
    requestAnimationFrame(() => this.draw());
  }
}

try {
  window.meshPage = new Page(decode(JSON.parse(document.getElementById("mesh").textContent)));
} catch (error) {
  fail("This mesh cannot be shown: " + error.message + ". The page needs a browser with WebGL.");
  throw error;
}
