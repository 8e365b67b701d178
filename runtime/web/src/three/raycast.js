// Rays of a THREE.Raycaster against an asset's own hierarchy: of a strand its segments, not the boxes that are drawn.
import { Box3, Matrix4, Ray, Triangle, Vector2, Vector3 } from "three/webgpu";

const NODE = 8, PRIMITIVE = 4;  // words: low, child, high, count; a, b, c, tag
const ROOT = 1;                 // behind the node of the only instance
const CORNERS = { surface: 3, fiber: 8 };  // of what is drawn of a primitive
const inverse = /*@__PURE__*/ new Matrix4(), box = /*@__PURE__*/ new Box3(), ray = /*@__PURE__*/ new Ray(), triangle = /*@__PURE__*/ new Triangle();
const weights = /*@__PURE__*/ new Vector3();
const [start, end, point, beside] = /*@__PURE__*/ [0, 1, 2, 3].map(() => new Vector3());

/** A part's data for its rays. geometry: of the whole asset; drawn: the part's own. */
export class PartRays {
  constructor({ nodes, primitives, points, normalsAt }, { kind, primitive, hasUVs }) {
    Object.assign(this, { nodes, primitives, points, normalsAt, hasUVs, isFiber: kind === "fiber" });
    this.floats = new Float32Array(nodes.buffer, nodes.byteOffset, nodes.length);
    this.faces = new Int32Array(primitives.length / PRIMITIVE).fill(-1);  // of other parts
    for (let k = 0; k * CORNERS[kind] < primitive.length; k++) this.faces[primitive[k * CORNERS[kind]]] = k;
  }

  /** Adds the hits of a mesh in this place of the world to `hits`, as three.js' own meshes do. */
  raycast(mesh, matrix, raycaster, hits, more = {}) {
    ray.copy(raycaster.ray).applyMatrix4(inverse.copy(matrix).invert());
    for (const number of this._leaves()) {
      const normal = this.faces[number] < 0 ? null : this.isFiber ? this._segment(number) : this._triangle(number);
      if (!normal) continue;
      const world = point.clone().applyMatrix4(matrix), distance = raycaster.ray.origin.distanceTo(world);
      if (distance < raycaster.near || distance > raycaster.far) continue;
      const uv = this.hasUVs ? { uv: this._uv(number) } : {};
      hits.push({ distance, point: world, object: mesh, faceIndex: this.faces[number], face: { normal, materialIndex: 0 }, ...uv, ...more });
    }
  }

  /** Primitives whose leaves the ray meets. */
  *_leaves() {
    const { nodes, floats } = this, stack = [ROOT];
    while (stack.length) {
      const node = stack.pop(), at = NODE * node, child = nodes[at + 3], count = nodes[at + 7];
      box.min.fromArray(floats, at);
      box.max.fromArray(floats, at + 4);
      if (!ray.intersectsBox(box)) continue;
      if (!count) stack.push(child, node + 1);
      for (let k = 0; k < count; k++) yield child + k;
    }
  }

  /** The normal where the ray meets it, `point`; null where it does not. */
  _triangle(number) {
    const [a, b, c] = this.primitives.subarray(PRIMITIVE * number);
    triangle.a.fromArray(this.points, 4 * a);
    triangle.b.fromArray(this.points, 4 * b);
    triangle.c.fromArray(this.points, 4 * c);
    return ray.intersectTriangle(triangle.a, triangle.b, triangle.c, false, point) && triangle.getNormal(new Vector3());
  }

  /** Of the triangle that `_triangle` found: u is behind its points, v behind their normals. */
  _uv(number) {
    const corners = [...this.primitives.subarray(PRIMITIVE * number, PRIMITIVE * number + 3)];
    const mixed = (first) => corners.reduce((sum, corner, k) => sum + weights.getComponent(k) * this.points[4 * (first + corner) + 3], 0);
    triangle.getBarycoord(point, weights);
    return new Vector2(mixed(0), mixed(this.normalsAt));
  }

  /** At the ray's nearest place to the strand's middle. */
  _segment(number) {
    const at = 4 * this.primitives[PRIMITIVE * number];
    start.fromArray(this.points, at);
    end.fromArray(this.points, at + 4);
    const away = ray.distanceSqToSegment(start, end, point, beside), along = start.distanceTo(beside) / (start.distanceTo(end) || 1);
    const radius = this.points[at + 3] + along * (this.points[at + 7] - this.points[at + 3]);
    return away <= radius * radius ? point.clone().sub(beside).normalize() : null;
  }
}
