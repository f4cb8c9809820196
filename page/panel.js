// The panel beside the view.

function element(name, className, ...content) {
  const result = document.createElement(name);
  if (className) result.className = className;
  result.append(...content);
  return result;
}

function meanOf(data) {
  let sum = 0, count = 0;
  for (const x of data) if (x === x) { sum += x; ++count; }
  return count > 0 ? sum / count : 0;
}

function describeScalar(scalar) {
  const s = scalar.scale;
  const worst = scalar.isWorstLow ? "minimum " + shortNumber(s.least) : "maximum " + shortNumber(s.most);
  return worst + scalar.unit + ", mean " + shortNumber(meanOf(scalar.data)) + scalar.unit;
}

// Triangles with the worst values, the worst one first.
function worstTriangles(scalar, number) {
  const sign = scalar.isWorstLow ? 1 : -1, worst = [];
  for (let t = 0; t < scalar.data.length; ++t) {
    const x = sign * scalar.data[t];
    if (!(x === x) || (worst.length === number && x >= worst[number - 1].x)) continue;
    let i = Math.min(worst.length, number - 1);
    for (; i > 0 && worst[i - 1].x > x; --i) worst[i] = worst[i - 1];
    worst[i] = { x, t };
  }
  return worst.map(w => w.t);
}

class Panel {
  // `on`: what is called when something is chosen
  constructor(mesh, colorings, on) {
    Object.assign(this, { mesh, colorings, on });
    this.histograms = [];
    this.fillColorings();
    this.fillHistograms();
    this.fillFindings();
    this.fillSummary();
  }

  byId(id) { return document.getElementById(id); }

  fillColorings() {
    const select = this.byId("coloring");
    for (const coloring of this.colorings)
      select.append(Object.assign(element("option"), { textContent: coloring.name, value: coloring.name }));
    select.addEventListener("change", () => this.on.coloring(select.value));
  }

  fillHistograms() {
    for (const scalar of this.mesh.scalars.slice(0, 2)) this.byId("histograms").append(this.histogram(scalar));
  }

  histogram(scalar) {
    const button = histogramButton(scalar, describeScalar(scalar));
    button.addEventListener("click", () => this.on.coloring(scalar.name));
    this.histograms.push(button);
    return button;
  }

  redrawHistograms() {
    const color = getComputedStyle(document.documentElement).getPropertyValue("--rule");
    for (const button of this.histograms) if (button.isConnected) button.redraw(color);
  }

  showColoring(coloring) {
    this.byId("coloring").value = coloring.name;
    const legend = this.byId("legend");
    legend.textContent = "";
    this.histograms.length = 2;
    const { swatches, scalar } = coloring.legend;
    if (scalar && this.mesh.scalars.indexOf(scalar) > 1) legend.append(this.histogram(scalar));
    if (swatches && swatches.length > 0) legend.append(element("div", "swatches", ...swatches.map(s => this.swatch(s))));
    legend.hidden = legend.childNodes.length === 0;
    this.redrawHistograms();
  }

  swatch(s) {
    const mark = element("i"), result = element("button", "swatch", mark, element("span", "", s.text));
    mark.style.background = css(s.color);
    result.title = s.text;
    if (s.faces) result.addEventListener("click", () => this.on.faces(s.faces));
    else if (s.finding) result.addEventListener("click", () => this.on.finding(s.finding, 0));
    else result.disabled = true;
    return result;
  }

  // What was not met or was simplified, and where triangles are worst. A click goes to the first place, another one to the next.
  fillFindings() {
    const list = this.byId("findings"), unmet = unmetFindings(this.mesh);
    const own = this.mesh.scalars.filter(s => s.scale.most > s.scale.least).map(s => ({
      kind: "worst triangles",
      text: s.name.startsWith("smallest") ? s.name : (s.isWorstLow ? "smallest " : "largest ") + s.name,
      detail: shortNumber(s.isWorstLow ? s.scale.least : s.scale.most) + s.unit,
      triangles: worstTriangles(s, Math.min(20, this.mesh.size)), places: [], isOrdered: true
    }));
    const kinds = new Map();
    for (const f of this.mesh.findings.concat(own)) kinds.set(f.kind, (kinds.get(f.kind) || []).concat([f]));
    this.byId("findings-section").hidden = kinds.size === 0;
    for (const [kind, findings] of kinds) {
      list.append(element("p", "kind", kind));
      for (const f of findings) list.append(this.finding(f, unmet.indexOf(f)));
    }
  }

  textOf(f) {
    const faces = (f.faces || []).map(face => faceName(this.mesh, face)).join(" and ");
    return faces + (faces ? ": " : "") + f.text;
  }

  finding(f, unmetIndex) {
    const number = f.triangles.length || f.places.length;
    const count = element("span", "count", f.isOrdered || number === 0 ? "" : groupedNumber(number));
    const row = element("button", "finding", element("span", "what", this.textOf(f), element("em", "", f.detail)), count);
    if (unmetIndex >= 0) row.prepend(Object.assign(element("i"), { style: "background:" + css(UNMET[unmetIndex % UNMET.length]) }));
    let next = 0;
    if (number === 0) row.disabled = true;
    row.addEventListener("click", () => {
      this.on.finding(f, next);
      count.textContent = (next + 1) + " of " + groupedNumber(number);
      next = (next + 1) % number;
    });
    return row;
  }

  fillSummary() {
    if (this.mesh.summary.length === 0) return;
    this.byId("summary-section").hidden = false;
    this.byId("summary").append(...this.mesh.summary.map(line => element("p", "", line)));
  }

  // `point`: where the click was, or null
  showSelection(triangle, point) {
    const mesh = this.mesh, f = mesh.triangleFaces[triangle], face = mesh.faces[f], rows = [];
    rows.push(["face", face.number + (face.name ? " \u201c" + face.name + "\u201d" : "")]);
    if (face.part !== undefined) rows.push(["part", mesh.parts[face.part].name]);
    rows.push(["its triangles", groupedNumber(mesh.begins[f + 1] - mesh.begins[f])]);
    rows.push(["triangle", groupedNumber(mesh.numbers[triangle] + 1)]);
    for (const scalar of mesh.scalars) {
      const value = scalar.data[triangle];
      rows.push([scalar.name, Number.isNaN(value) ? "not defined" : longNumber(value) + scalar.unit]);
    }
    const own = unmetFindings(mesh).filter(finding => finding.triangles.includes(triangle));
    const unmet = own.map(finding => finding.text + ", " + finding.detail);
    rows.push(["not met", unmet.join("; ") || "nothing", unmet.length > 0]);
    // What is left of a zero by rounding is shown as zero.
    const coordinate = x => longNumber(Math.abs(x) < 1e-6 * mesh.diagonal ? 0 : x);
    if (point) rows.push(["place", point.toArray().map((x, i) => coordinate(x + mesh.center[i])).join(", ")]);
    const rowOf = ([name, value, isUnmet]) => element("tr", "", element("td", "", name), element("td", isUnmet ? "unmet" : "", value));
    const table = element("table", "", ...rows.map(rowOf));
    this.byId("selection").replaceChildren(table, this.actions(f));
  }

  // What can be done with the face or its part.
  actions(f) {
    const mesh = this.mesh, part = mesh.faces[f].part;
    const all = mesh.faces.map((face, i) => i), same = all.filter(i => mesh.faces[i].part === part);
    const result = element("div", "actions"), add = (text, action) => {
      const button = element("button", "", text);
      button.addEventListener("click", action);
      result.append(button);
    };
    if (mesh.faces.length > 1) add("Hide face", () => this.on.hide([f]));
    if (mesh.parts.length > 1) {
      add("Hide part", () => this.on.hide(same));
      add("Only this part", () => this.on.hide(all.filter(i => mesh.faces[i].part !== part)));
    }
    return result;
  }

  showNumberHidden(number) {
    const row = this.byId("hidden");
    row.hidden = number === 0;
    this.byId("hidden-number").textContent = groupedNumber(number) + (number === 1 ? " face is hidden" : " faces are hidden");
  }

  showDomain(face, view) {
    const [u0, v0, u1, v1] = this.mesh.domains[face];
    this.byId("domain-title").textContent = "Domain of face " + this.mesh.faces[face].number;
    const range = (name, low, high, stretch) => name + " " + shortNumber(low) + " \u2026 " + shortNumber(high)
      + (stretch > 1 ? ", drawn " + shortNumber(stretch) + " times as large" : "");
    this.byId("domain-range").textContent = range("u", u0, u1, 1 / view.stretch) + ",  " + range("v", v0, v1, view.stretch);
  }
}
