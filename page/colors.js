// The ways to colour triangles. A colouring has a name, colours as bytes of red, green and blue for all triangles, and a legend.

const PLAIN = [190, 204, 217], MET = [196, 204, 212];

function fromHsl(h, s, l) {
  const channel = n => {
    const k = (n + h / 30) % 12;
    return Math.round(255 * (l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

// Neighbours in a list get hues that are far apart; the golden angle never repeats one.
function categoryColor(i) { return fromHsl((205 + 137.508 * i) % 360, 0.36 + 0.08 * (i % 3), 0.66 - 0.05 * (i % 2)); }

// From bad to good: red, orange, yellow, green, blue.
const QUALITY = [[196, 40, 48], [240, 136, 60], [250, 220, 120], [126, 200, 164], [70, 138, 196]];
// From small to large: pale where nothing is to be seen, warm where it is most.
const AMOUNT = [[226, 233, 238], [150, 205, 200], [120, 190, 130], [245, 205, 85], [235, 130, 55], [190, 40, 60]];
const UNMET = [[204, 62, 48], [232, 150, 40], [130, 90, 190], [30, 140, 120], [210, 90, 150], [80, 120, 220], [150, 120, 60], [90, 90, 90]];

function onScale(colors, share) {
  const place = Math.min(Math.max(share, 0), 1) * (colors.length - 1), i = Math.min(Math.floor(place), colors.length - 2), rest = place - i;
  return colors[i].map((c, k) => Math.round(c + rest * (colors[i + 1][k] - c)));
}

function css(color) { return "rgb(" + color.join(",") + ")"; }

// Files have the purest red and green, at which shading and lines are hard to see.
function bytesFrom(color) { return color.map(c => Math.round(255 * (0.2 + 0.7 * c))); }

// What a scale covers: given ends, or what is there; in equal steps of the logarithm if it is over a wide range.
function scaleOf(scalar) {
  let low = Infinity, high = -Infinity, lowest = Infinity;
  for (const x of scalar.data) {
    if (x < low) low = x;
    if (x > high) high = x;
    if (x > 0 && x < lowest) lowest = x;
  }
  if (!(low <= high)) low = high = 0;
  const scale = { least: low, most: high, isLogarithmic: false };
  scale.low = scalar.low === null ? low : scalar.low;
  scale.high = scalar.high === null ? high : scalar.high;
  if (scalar.low === null && low >= 0 && high > 20 * lowest) {
    scale.isLogarithmic = true;
    scale.low = Math.max(lowest, 1e-3 * high);
  }
  const steps = x => (scale.isLogarithmic ? Math.log(Math.max(x, scale.low)) : x), from = steps(scale.low), to = steps(scale.high);
  scale.share = x => (to > from ? Math.min(Math.max((steps(x) - from) / (to - from), 0), 1) : 0);
  scale.value = share => (scale.isLogarithmic ? Math.exp(from + share * (to - from)) : from + share * (to - from));
  scale.colors = scalar.isWorstLow ? QUALITY : AMOUNT;
  return scale;
}

function byFace(mesh, colorOfFace) {
  const colors = new Uint8Array(3 * mesh.size);
  for (let f = 0; f < mesh.faces.length; ++f) {
    const color = colorOfFace(mesh.faces[f], f);
    for (let t = mesh.begins[f]; t < mesh.begins[f + 1]; ++t) colors.set(color, 3 * t);
  }
  return colors;
}

function byScalar(mesh, scalar) {
  const scale = scalar.scale, colors = new Uint8Array(3 * mesh.size), table = [];
  for (let i = 0; i < 256; ++i) table.push(onScale(scale.colors, i / 255));
  for (let t = 0; t < mesh.size; ++t) {
    const x = scalar.data[t];
    colors.set(x === x ? table[Math.round(255 * scale.share(x))] : MET, 3 * t);
  }
  return colors;
}

function unmetFindings(mesh) { return mesh.findings.filter(f => f.kind === "not met"); }

function byUnmet(mesh) {
  const colors = byFace(mesh, () => MET);
  unmetFindings(mesh).forEach((f, i) => f.triangles.forEach(t => colors.set(UNMET[i % UNMET.length], 3 * t)));
  return colors;
}

function faceName(mesh, f) {
  const face = mesh.faces[f];
  return "face " + face.number + (face.name ? " \u201c" + face.name + "\u201d" : "");
}

// All colourings that make sense for a mesh, the default one first.
function coloringsOf(mesh) {
  const result = [];
  const add = (name, colors, legend) => result.push({ name, colors, legend });
  const own = (face) => (face.color || (face.part !== undefined && mesh.parts[face.part].color));
  if (mesh.faces.some(own)) add("as in the file", () => byFace(mesh, face => (own(face) ? bytesFrom(own(face)) : PLAIN)), { swatches: [] });
  if (mesh.parts.length > 1) {
    const facesOf = p => mesh.faces.map((face, f) => f).filter(f => mesh.faces[f].part === p);
    add("part", () => byFace(mesh, face => (face.part === undefined ? MET : categoryColor(face.part))),
        { swatches: mesh.parts.map((part, p) => ({ color: categoryColor(p), text: part.name, faces: facesOf(p) })) });
  }
  add("one colour", () => byFace(mesh, () => PLAIN), { swatches: [] });
  if (mesh.faces.length > 1) {
    const shown = mesh.faces.map((face, f) => f).filter(f => mesh.begins[f] < mesh.begins[f + 1]);
    add("face", () => byFace(mesh, (face, f) => categoryColor(f)),
        { swatches: shown.length > 400 ? [] : shown.map(f => ({ color: categoryColor(f), text: faceName(mesh, f), faces: [f] })) });
  }
  for (const scalar of mesh.scalars) {
    scalar.scale = scaleOf(scalar);
    add(scalar.name, () => byScalar(mesh, scalar), { scalar });
  }
  const unmet = unmetFindings(mesh);
  const met = { color: MET, text: unmet.length ? "met" : "all criteria are met" };
  const swatchOf = (f, i) => ({
    color: UNMET[i % UNMET.length], text: f.text + " (" + f.detail.replace("because of the ", "") + ")", finding: f
  });
  add("what was not met", () => byUnmet(mesh), { swatches: [met].concat(unmet.map(swatchOf)) });
  return result;
}
