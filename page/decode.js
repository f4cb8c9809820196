// The data of the page as arrays. Triangles are sorted by face, so that those of a face are a range.

function bytesOf(text) {
  const characters = atob(text), result = new Uint8Array(characters.length);
  for (let i = 0; i < result.length; ++i) result[i] = characters.charCodeAt(i);
  return result;
}

// Numbers of which the differences to the ones before were written, seven bits a byte, the sign in the lowest bit.
function numbersOf(text) {
  const bytes = bytesOf(text);
  let count = 0;
  for (let i = 0; i < bytes.length; ++i) if (bytes[i] < 128) ++count;
  const result = new Uint32Array(count);
  for (let i = 0, k = 0, last = 0; k < count; ++k) {
    let factor = 1, number = 0;
    for (; bytes[i] >= 128; ++i, factor *= 128) number += (bytes[i] & 127) * factor;
    number += bytes[i++] * factor;
    last += number % 2 === 1 ? -(number + 1) / 2 : number / 2;
    result[k] = last;
  }
  return result;
}

// Shares of a range from 0 to 1, in 24 bits.
function sharesOf(text) {
  const bytes = bytesOf(text), result = new Float64Array(bytes.length / 3);
  for (let i = 0; i < result.length; ++i) result[i] = (bytes[3 * i] + 256 * bytes[3 * i + 1] + 65536 * bytes[3 * i + 2]) / 16777215;
  return result;
}

function valuesOf(range) {
  const bytes = bytesOf(range.data), result = new Float32Array(bytes.length / 2);
  for (let i = 0; i < result.length; ++i) {
    const code = bytes[2 * i] + 256 * bytes[2 * i + 1];
    const value = range.low + (range.high - range.low) * (code - 2) / 65533;
    result[i] = code === 0 ? 0 : code === 1 ? NaN : range.logarithmic ? Math.exp(value) : value;
  }
  return result;
}

// The order of the triangles by face; those of a face stay in their order.
function orderByFace(faces, numberOfFaces) {
  const begins = new Uint32Array(numberOfFaces + 1);
  for (const face of faces) ++begins[face + 1];
  for (let f = 0; f < numberOfFaces; ++f) begins[f + 1] += begins[f];
  const next = begins.slice(), order = new Uint32Array(faces.length);
  for (let t = 0; t < faces.length; ++t) order[next[faces[t]]++] = t;
  return { order, begins };
}

function reordered(values, order) {
  const result = new values.constructor(values.length);
  for (let t = 0; t < order.length; ++t) result[t] = values[order[t]];
  return result;
}

// One for each vertex of the page, which belongs to one face: edges of the model stay sharp.
function normalsOf(positions, triangles) {
  const result = new Float32Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2], p = positions;
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const i of [a, b, c]) { result[i] += x; result[i + 1] += y; result[i + 2] += z; }
  }
  for (let i = 0; i < result.length; i += 3) {
    const length = Math.hypot(result[i], result[i + 1], result[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) result[i + k] /= length;
  }
  return result;
}

function decode(data) {
  const mesh = {
    title: data.title, unit: data.unit, isClosed: data.closed, numberOfPoints: data.numberOfPoints, summary: data.summary,
    faces: data.faces, parts: data.parts
  };
  const sorted = orderByFace(numbersOf(data.triangleFaces), data.faces.length), order = sorted.order;
  const corners = numbersOf(data.triangles), placeOf = new Uint32Array(order.length);
  mesh.size = order.length;
  mesh.numbers = order; // of the triangles in the mesh, from 0
  mesh.begins = sorted.begins;
  mesh.triangles = new Uint32Array(corners.length);
  mesh.triangleFaces = new Uint32Array(order.length);
  for (let t = 0; t < order.length; ++t) {
    placeOf[order[t]] = t;
    for (let i = 0; i < 3; ++i) mesh.triangles[3 * t + i] = corners[3 * order[t] + i];
  }
  for (let f = 0; f < data.faces.length; ++f) mesh.triangleFaces.fill(f, sorted.begins[f], sorted.begins[f + 1]);

  // Around the middle of the box, where numbers of 32 bits are most exact.
  mesh.center = data.low.map((x, i) => 0.5 * (x + data.high[i]));
  mesh.extent = data.low.map((x, i) => data.high[i] - x);
  mesh.diagonal = Math.hypot(...mesh.extent) || 1;
  mesh.positions = Float32Array.from(sharesOf(data.positions), (share, i) => (share - 0.5) * mesh.extent[i % 3]);
  mesh.normals = normalsOf(mesh.positions, mesh.triangles);
  mesh.hasDomains = !!data.parameters;
  if (mesh.hasDomains) { mesh.domains = data.domains; mesh.parameters = Float32Array.from(sharesOf(data.parameters)); }

  const values = range => reordered(valuesOf(range), order);
  mesh.scalars = [
    { name: "smallest angle", unit: "\u00b0", low: 0, high: 60, isWorstLow: true, data: values(data.angles) },
    { name: "2r/R", unit: "", low: 0, high: 1, isWorstLow: true, data: values(data.ratios) }];
  for (const v of data.values) {
    const isLength = v.dimension === "length";
    const unit = v.dimension === "number" || !data.unit ? "" : (isLength ? "\u00a0" : "\u00a0/\u00a0") + data.unit;
    // Distances are compared with the largest one; curvatures, which differ by orders of magnitude, on a logarithmic scale.
    mesh.scalars.push({ name: v.name, unit, low: isLength ? 0 : null, high: null, isWorstLow: false, data: values(v.range) });
  }
  if (data.tensorStretches) { mesh.stretches = values(data.tensorStretches); mesh.skews = values(data.tensorSkews); }
  mesh.lines = numbersOf(data.lines);
  mesh.lineNumbers = numbersOf(data.lineNumbers);
  mesh.findings = data.findings.map(f => ({
    ...f, triangles: Array.from(numbersOf(f.triangles), t => placeOf[t]), places: f.places.map(p => p.map((x, i) => x - mesh.center[i]))
  }));
  return mesh;
}
