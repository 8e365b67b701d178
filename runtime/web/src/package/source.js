// Where the bytes of a package come from: a dropped file, or an address, by range requests where the
// server allows them (RFC 9110, section 14).
import { NotSupported } from "./errors.js";

const HEAD = 65536, TAIL = 16384;  // bytes: most often of the manifest, and of the directory
// Bytes; of a file that comes whole, since its server knows no ranges: it is held in memory.
const LARGEST_WHOLE = 2 ** 30;

/** A File or Blob. */
export class BlobSource {
  constructor(blob, name) {
    this.blob = blob;
    this.name = name;
    this.size = blob.size;
  }

  expect() {}

  async read(start, end) {
    return new Uint8Array(await this.blob.slice(start, end).arrayBuffer());
  }
}

/** Bytes at an address; `progress(got, all)` hears how many of those that are expected have arrived. name: for messages. */
export class UrlSource {
  static async open(url, progress = () => {}, signal, name = nameOf(url)) {
    const source = new UrlSource();
    Object.assign(source, { url, progress, signal, name, fetched: 0, begun: 0, expected: null });
    let answer = await source._ask({ Range: `bytes=0-${HEAD - 1}` });
    const total = /\/(\d+)$/.exec(answer.headers.get("Content-Range") ?? "");
    source.ranged = answer.status === 206 && total !== null;
    if (answer.status === 206 && !source.ranged) {
      // Of another site, whose server does not expose Content-Range to scripts: the size is not known.
      await answer.body?.cancel();
      answer = await source._ask({});
    }
    const length = Number(answer.headers.get("Content-Length")) || 0;
    if (!source.ranged) source.expected = length;
    const most = source.ranged ? HEAD : LARGEST_WHOLE;
    if (length > most) await source._tooLong(answer, most);
    source.head = await source._collect(answer, most);
    source.size = source.ranged ? Number(total[1]) : source.head.length;
    return source;
  }

  async read(start, end) {
    if (!this.ranged || end <= this.head.length) return this.head.subarray(start, Math.min(end, this.size));
    const last = Math.max(0, this.size - TAIL);
    if (start < last) return this._range(start, end);
    this.tail ??= this._range(last, this.size);
    return (await this.tail).subarray(start - last, end - last);
  }

  /** What is read next: progress counts these ranges alone. */
  expect(ranges) {
    if (!this.ranged) return;
    const isThere = ([start, end]) => end <= this.head.length || start >= this.size - TAIL;
    const expected = ranges.filter((range) => !isThere(range)).reduce((sum, [start, end]) => sum + end - start, 0);
    Object.assign(this, { begun: this.fetched, expected });
  }

  async _range(start, end) {
    const answer = await this._ask({ Range: `bytes=${start}-${end - 1}` });
    if (answer.status !== 206) throw new NotSupported(`${this.name}: the server forgot about ranges`);
    const bytes = await this._collect(answer, end - start);
    if (bytes.length < end - start) {
      throw new NotSupported(`${this.name}: the server sent ${bytes.length} bytes of ${end - start}`);
    }
    return bytes;
  }

  async _ask(headers) {
    let answer;
    try {
      answer = await fetch(this.url, { headers, signal: this.signal });
    } catch (error) {
      if (error.name === "AbortError") throw error;
      const file = new URL(this.url, location.href).protocol === "file:";
      throw new NotSupported(
        file
          ? "a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here"
          : `cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`,
      );
    }
    // 416: an empty file has no first byte.
    if (!answer.ok && answer.status !== 416) {
      throw new NotSupported(`cannot load ${this.url}: HTTP ${answer.status}`);
    }
    return answer;
  }

  /** The bytes of an answer, of `most` at most: no server fills the memory. */
  async _collect(answer, most) {
    if (answer.status === 416 || !answer.body) return new Uint8Array();
    const pieces = [];
    let length = 0;
    const reader = answer.body.getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      length += value.length;
      if (length > most) await this._tooLong(reader, most);
      pieces.push(value);
      this.fetched += value.length;
      this.progress(this.fetched - this.begun, this.expected);
    }
    const bytes = new Uint8Array(length);
    let at = 0;
    for (const piece of pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    return bytes;
  }

  /** Stops a transfer; `stream` is an answer, or its reader. */
  async _tooLong(stream, most) {
    await (stream.body ?? stream).cancel().catch(() => {});
    throw new NotSupported(
      this.ranged
        ? `${this.name}: the server sent more than the ${most} bytes that were asked for`
        : `${this.name}: more than ${most} bytes from a server without range requests: use rna-view, or a server that has them`,
    );
  }
}

/** The last part of an address's path, as people read it. */
export function nameOf(url) {
  const last = new URL(url, location.href).pathname.split("/").pop();
  try {
    return decodeURIComponent(last) || url;
  } catch {
    return last;  // with a "%" that encodes nothing
  }
}
