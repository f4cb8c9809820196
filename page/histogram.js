// A histogram of the values of triangles, whose bars have the colours of the scale, so that it is a legend, too.

const NUMBER_OF_BARS = 60;

function shortNumber(x) {
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e5 || size < 1e-3) return withMinus(x.toExponential(1));
  return withMinus(size >= 100 ? x.toFixed(0) : size >= 10 ? x.toFixed(1) : x.toPrecision(2));
}

// A real minus, at which lines are not broken.
function withMinus(text) { return text.replace(/-/g, "\u2212"); }

function longNumber(x) {
  const size = Math.abs(x);
  return withMinus(x === 0 ? "0" : size >= 1e6 || size < 1e-4 ? x.toExponential(3) : String(Number(x.toPrecision(5))));
}

function groupedNumber(n) { return String(n).replace(/\B(?=(\d{3})+$)/g, "\u202f"); }

function countsOf(scalar) {
  const counts = new Array(NUMBER_OF_BARS).fill(0);
  for (const x of scalar.data) if (x === x) ++counts[Math.min(Math.floor(scalar.scale.share(x) * NUMBER_OF_BARS), NUMBER_OF_BARS - 1)];
  return counts;
}

function drawHistogram(canvas, scalar, background) {
  const ratio = window.devicePixelRatio || 1, context = canvas.getContext("2d");
  const width = canvas.clientWidth || 304, height = canvas.clientHeight || 54; // what style.css gives it, before it is shown
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  context.scale(ratio, ratio);
  const counts = scalar.counts || (scalar.counts = countsOf(scalar)), most = Math.max(...counts), step = width / NUMBER_OF_BARS;
  context.fillStyle = background;
  context.fillRect(0, height - 1, width, 1);
  counts.forEach((count, i) => {
    if (count === 0) return;
    const bar = Math.max(2, (height - 3) * count / most); // a single bad triangle is to be seen
    context.fillStyle = css(onScale(scalar.scale.colors, (i + 0.5) / NUMBER_OF_BARS));
    context.fillRect(i * step + 0.5, height - bar, step - 1, bar);
  });
}

// A button with the histogram, its name and ends.
function histogramButton(scalar, description) {
  const button = document.createElement("button");
  button.className = "histogram";
  button.title = "Colour by " + scalar.name;
  const name = document.createElement("span"), axis = document.createElement("span"), canvas = document.createElement("canvas");
  name.className = "name";
  name.append(scalar.name, Object.assign(document.createElement("span"), { textContent: description }));
  axis.className = "axis";
  for (const share of [0, 0.5, 1]) {
    const textContent = shortNumber(scalar.scale.value(share)) + scalar.unit;
    axis.append(Object.assign(document.createElement("span"), { textContent }));
  }
  button.append(name, canvas, axis);
  button.redraw = color => drawHistogram(canvas, scalar, color);
  return button;
}
