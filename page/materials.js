// Materials of triangles: shaded ones with their edges, and numbers to be picked. Each corner has four bytes of paint, red, green, blue and
// which corner of its triangle it is (128 more if it is hidden), and four of the number of the triangle.

const VERTEX_SHADER = `
attribute vec4 paint;
attribute vec4 code;
varying vec3 vColor, vCorner, vNormal, vView, vPlace;
varying vec4 vCode;
void main() {
  float corner = paint.a * 255.0;
  if(corner > 100.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // out of sight
    return;
  }
  vCorner = vec3(corner < 0.5 ? 1.0 : 0.0, corner > 0.5 && corner < 1.5 ? 1.0 : 0.0, corner > 1.5 ? 1.0 : 0.0);
  vColor = paint.rgb;
  vCode = code;
  vNormal = normalMatrix * normal;
  vPlace = position;
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = view.xyz;
  gl_Position = projectionMatrix * view;
}`;

const CUT = `
uniform vec4 plane;
varying vec3 vPlace;
bool isCut() { return dot(plane.xyz, vPlace) > plane.w; }`;

// Two lights beside the viewer, and light from all sides that is a little blue from below.
const SHADED_FRAGMENT_SHADER = CUT + `
uniform float edgeWidth;
uniform float isFlat, contrast;
uniform vec2 fadingSteps; // shares of a triangle's height that a pixel is, from which its lines begin to fade, and are gone
uniform vec3 edgeColor;
varying vec3 vColor, vCorner, vNormal, vView;
void main() {
  if(isCut()) discard;
  vec3 color = vColor;
  if(isFlat < 0.5) {
    vec3 n = normalize(vNormal);
    bool isBack = !gl_FrontFacing;
    if(isBack) n = -n;
    float key = max(dot(n, normalize(vec3(0.35, 0.55, 0.75))), 0.0), fill = max(dot(n, normalize(vec3(-0.7, 0.1, 0.5))), 0.0);
    vec3 around = mix(vec3(0.40, 0.43, 0.49), vec3(0.55, 0.55, 0.55), 0.5 + 0.5 * n.y);
    float shine = pow(max(dot(reflect(normalize(vView), n), normalize(vec3(0.35, 0.55, 0.75))), 0.0), 28.0);
    color = color * mix(vec3(1.0), around + 0.50 * key + 0.14 * fill, contrast) + 0.07 * contrast * shine;
    if(isBack) color = mix(color, vec3(dot(color, vec3(0.33))), 0.35) * 0.86;
  }
  vec3 step = fwidth(vCorner);
  vec3 near = smoothstep(vec3(0.0), step * edgeWidth, vCorner);
  float line = 1.0 - min(min(near.x, near.y), near.z);
  // Where triangles are hardly larger than pixels, lines would be all that is seen.
  float fading = 1.0 - smoothstep(fadingSteps.x, fadingSteps.y, max(max(step.x, step.y), step.z));
  vec3 pen = dot(vColor, vec3(0.333)) < 0.4 ? color + 0.3 : edgeColor; // light on what is nearly black
  color = mix(color, pen, line * fading * (edgeWidth > 0.0 ? 0.55 : 0.0));
  gl_FragColor = vec4(color, 1.0);
}`;

const PICKING_FRAGMENT_SHADER = CUT + `
varying vec4 vCode;
void main() {
  if(isCut()) discard;
  gl_FragColor = vec4(vCode.rgb, 1.0);
}`;

// What is marked has a colour that no scale has.
const MARK = 0xd81b7a;

const NO_PLANE = new THREE.Vector4(0, 0, 0, 1);

function shadedMaterial(plane) {
  return new THREE.ShaderMaterial({
    uniforms: {
      plane: { value: plane }, edgeWidth: { value: 1.25 }, edgeColor: { value: new THREE.Color(0x1c2733) }, isFlat: { value: 0 },
      contrast: { value: 1 }, fadingSteps: { value: new THREE.Vector2(0.14, 0.42) }
    },
    vertexShader: VERTEX_SHADER, fragmentShader: SHADED_FRAGMENT_SHADER, side: THREE.DoubleSide,
    extensions: { derivatives: true }, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1
  });
}

function pickingMaterial(plane) {
  return new THREE.ShaderMaterial({
    uniforms: { plane: { value: plane } }, vertexShader: VERTEX_SHADER, fragmentShader: PICKING_FRAGMENT_SHADER, side: THREE.DoubleSide
  });
}

// The number of a triangle from 1 in three bytes; 0 is the background.
function codesOf(begin, end) {
  const codes = new Uint8Array(12 * (end - begin));
  for (let t = begin, i = 0; t < end; ++t)
    for (let k = 0; k < 3; ++k, i += 4) {
      codes[i] = (t + 1) & 255;
      codes[i + 1] = (t + 1) >> 8 & 255;
      codes[i + 2] = (t + 1) >> 16 & 255;
    }
  return codes;
}

function paintOf(colors) {
  const paint = new Uint8Array(4 * colors.length);
  setColors(paint, colors);
  for (let i = 0; i < paint.length; i += 12) { paint[i + 7] = 1; paint[i + 11] = 2; }
  return paint;
}

function setColors(paint, colors) {
  for (let t = 0; t < colors.length; t += 3)
    for (let k = 0; k < 3; ++k)
      for (let i = 0; i < 3; ++i) paint[4 * (t + k) + i] = colors[t + i];
}

// Finds the triangle at a place of a view by drawing that one pixel with numbers as colours.
class Picker {
  constructor(renderer, geometry, plane) {
    this.renderer = renderer;
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.scene = new THREE.Scene();
    this.mesh = new THREE.Mesh(geometry, pickingMaterial(plane));
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  // The number of the triangle at a point, in pixels of the page from the corner of the canvas, or -1.
  pick(camera, x, y) {
    const size = this.renderer.getSize(new THREE.Vector2()), bytes = new Uint8Array(4);
    const color = this.renderer.getClearColor().clone(), alpha = this.renderer.getClearAlpha();
    camera.setViewOffset(size.x, size.y, Math.floor(x), Math.floor(y), 1, 1);
    this.renderer.setRenderTarget(this.target);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.scene, camera);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, bytes);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(color, alpha);
    camera.clearViewOffset();
    return bytes[0] + 256 * bytes[1] + 65536 * bytes[2] - 1;
  }
}
