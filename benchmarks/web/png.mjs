// RGBA of 8 bits as a PNG (ISO/IEC 15948), its alpha left out.
import { writeFileSync } from "node:fs";
import { crc32, deflateSync } from "node:zlib";

function chunk(name, data) {
  const size = Buffer.alloc(4), check = Buffer.alloc(4), body = Buffer.concat([Buffer.from(name), data]);
  size.writeUInt32BE(data.length);
  check.writeUInt32BE(crc32(body));
  return Buffer.concat([size, body, check]);
}

/** rgba: rows from the top. */
export function writePng(path, rgba, width) {
  const height = rgba.length / (4 * width), head = Buffer.alloc(13), rows = Buffer.alloc(height * (1 + 3 * width));
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 2], 8);  // bits, RGB
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) rgba.copy(rows, y * (1 + 3 * width) + 1 + 3 * x, 4 * (y * width + x), 4 * (y * width + x) + 3);
  }
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  writeFileSync(path, Buffer.concat([signature, chunk("IHDR", head), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))]));
}
