// One hierarchy of boxes over the triangles and round segments of all parts, by three-mesh-bvh.
import { BufferGeometry } from "three";
import { GeometryBVH, SAH, CENTER } from "three-mesh-bvh";

const SAH_LIMIT = 100_000;  // primitives; beyond that the quality is not worth the time
export const STACK = 48;

/** three-mesh-bvh over boxes of our own: six numbers, min and max, a primitive. */
class BoxHierarchy extends GeometryBVH {
  constructor(boxes) {
    const geometry = new BufferGeometry();
    geometry.setIndex({ count: boxes.length / 6, array: null });
    BoxHierarchy.boxes = boxes;  // the constructor builds before this object has members
    const count = boxes.length / 6;
    super(geometry, {
      indirect: true, strategy: count > SAH_LIMIT ? CENTER : SAH, maxDepth: STACK - 2, targetLeafSize: 4,
      setBoundingBox: false, verbose: false, range: { start: 0, count },
    });
    BoxHierarchy.boxes = null;
  }

  get primitiveStride() {
    return 1;
  }

  writePrimitiveBounds(k, target, at) {
    const boxes = BoxHierarchy.boxes, from = 6 * this._indirectBuffer[k];
    for (let j = 0; j < 6; j++) target[at + j] = boxes[from + j];
    return target;
  }
}

/**
 * { nodes, order }: nodes of 8 words, as three-mesh-bvh has them (box, child or first primitive, axis or
 * count; the left child is next), and the numbers of the primitives in the order of the leaves.
 */
export function buildHierarchy(boxes) {
  const hierarchy = new BoxHierarchy(boxes);
  return { nodes: new Uint32Array(hierarchy._roots[0]), order: Uint32Array.from(hierarchy._indirectBuffer) };
}
