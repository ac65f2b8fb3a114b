// Writes teapot.obj from the tessellator in the npm package `three`. See README.md beside it.
// Run: npm install --no-save three@0.187.0 && node make-teapot.mjs > teapot.obj

import { TeapotGeometry } from "three/examples/jsm/geometries/TeapotGeometry.js";

const SEGMENTS = 16;
// Positions closer than this are one vertex: the lid's rim and the body's differ by rounding.
const WELD = 2e-4;

const geometry = new TeapotGeometry(1, SEGMENTS, true, true, true, true, true);
const { position, normal } = geometry.attributes;
const digits = (x) => String(Number(x.toFixed(5)) + 0);

const vertices = [];
const normals = [];
const cells = new Map();
const normalOf = new Map();

function vertex(p) {
  const cell = p.map((x) => Math.round(x / WELD));
  for (let dx = -1; dx <= 1; dx++) for (let dy = -1; dy <= 1; dy++) for (let dz = -1; dz <= 1; dz++) {
    const found = cells.get([cell[0] + dx, cell[1] + dy, cell[2] + dz].join());
    if (found !== undefined && Math.hypot(...p.map((x, k) => x - vertices[found][k])) < WELD) return found;
  }
  cells.set(cell.join(), vertices.length);
  return vertices.push(p) - 1;
}

function direction(n) {
  const length = Math.hypot(...n);
  const key = n.map((x) => digits(x / length)).join(" ");
  if (!normalOf.has(key)) {
    normalOf.set(key, normals.length);
    normals.push(key);
  }
  return normalOf.get(key);
}

const at = (attribute, k) => [attribute.getX(k), attribute.getY(k), attribute.getZ(k)];
const faces = [];
for (let f = 0; f < geometry.index.count; f += 3) {
  const corners = [0, 1, 2].map((k) => geometry.index.getX(f + k));
  const face = corners.map((k) => [vertex(at(position, k)), direction(at(normal, k))]);
  if (new Set(face.map(([v]) => v)).size === 3) faces.push(face);
}

// What is left open are the two ends of the handle and of the spout. A fan closes each.
function openEdges() {
  const edges = new Map();
  for (const face of faces) face.forEach(([a], k) => {
    const b = face[(k + 1) % 3][0];
    if (!edges.delete(`${b} ${a}`)) edges.set(`${a} ${b}`, [a, b]);
  });
  return [...edges.values()];
}
const subtract = (a, b) => a.map((x, k) => x - b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const next = new Map(openEdges().map(([a, b]) => [b, a]));
let caps = 0;
while (next.size > 0) {
  const loop = [];
  for (let v = next.keys().next().value; next.has(v); ) {
    loop.push(v);
    const then = next.get(v);
    next.delete(v);
    v = then;
  }
  const sum = loop.reduce((s, v) => s.map((x, k) => x + vertices[v][k]), [0, 0, 0]);
  const centre = vertices.push(sum.map((x) => x / loop.length)) - 1;
  let area = [0, 0, 0];
  const edges = loop.map((v, k) => [v, loop[(k + 1) % loop.length]]);
  for (const [a, b] of edges) {
    const part = cross(subtract(vertices[a], vertices[centre]), subtract(vertices[b], vertices[centre]));
    area = area.map((x, k) => x + part[k]);
  }
  const n = direction(area);
  for (const [a, b] of edges) faces.push([[centre, n], [a, n], [b, n]]);
  caps++;
}
if (openEdges().length > 0) throw new Error(`${openEdges().length} edges are open`);

const floor = Math.min(...vertices.map((p) => p[1]));
console.log("# The Utah teapot. Origin and licence: README.md in this folder.");
for (const [x, y, z] of vertices) console.log(`v ${digits(x)} ${digits(y - floor)} ${digits(z)}`);
for (const n of normals) console.log(`vn ${n}`);
for (const face of faces) console.log(`f ${face.map(([v, n]) => `${v + 1}//${n + 1}`).join(" ")}`);
console.error(`${vertices.length} vertices, ${faces.length} triangles, ${caps} caps, no open edge`);
