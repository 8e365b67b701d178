// Where the bytes of a package come from: a dropped file, or an address, by range requests where the
// server allows them (RFC 9110, section 14).
import { NotSupported } from "./errors.js";

const HEAD = 65536, TAIL = 16384;  // bytes: most often of the manifest, and of the directory
// Bytes; of a file that comes whole, since its server knows no ranges: it is held in memory.
const LARGEST_WHOLE = 2 ** 30;

/** Nothing came back: what is asked in another way may be answered. */
class NoAnswer extends NotSupported {}

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

  /** Bytes `start` to `end` of it, as a source. */
  async part(start, end) {
    return new BlobSource(this.blob.slice(start, end), this.name);
  }
}

/** Bytes at an address; `progress(got, all)` hears how many of those that are expected have arrived. name: for messages. */
export class UrlSource {
  static pauses = [300, 1000, 3000];  // ms before each new try of a transfer that was cut

  static async open(url, progress = () => {}, signal, name = nameOf(url)) {
    const source = new UrlSource();
    Object.assign(source, { url, progress, signal, name, fetched: 0, begun: 0, expected: null, from: 0 });
    let answer = await source._askHead();
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
    source.head = await source._transfer(answer, 0, most);
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

  /** Bytes `start` to `end` of it, as a source; the whole is read no more. */
  async part(start, end) {
    const size = end - start, part = Object.assign(new UrlSource(), this, { from: this.from + start, size, tail: undefined });
    const head = this.head.subarray(start, end);
    part.head = head.length ? head : await part._range(0, Math.min(HEAD, size));
    return part;
  }

  /** The ranges of the next reads: progress counts these alone. */
  expect(ranges) {
    if (!this.ranged) return;
    const isThere = ([start, end]) => end <= this.head.length || start >= this.size - TAIL;
    const expected = ranges.filter((range) => !isThere(range)).reduce((sum, [start, end]) => sum + end - start, 0);
    Object.assign(this, { begun: this.fetched, expected });
  }

  async _range(start, end) {
    const bytes = await this._transfer(null, this.from + start, end - start);
    if (bytes.length < end - start) {
      throw new NotSupported(`${this.name}: the server sent ${bytes.length} bytes of ${end - start}`);
    }
    return bytes;
  }

  /** The first bytes; or all, where the server does not answer to a range: browsers refuse a range that is compressed. */
  async _askHead() {
    try {
      return await this._ask({ Range: `bytes=0-${HEAD - 1}` });
    } catch (error) {
      if (!(error instanceof NoAnswer)) throw error;
      return this._ask({});
    }
  }

  async _ask(headers) {
    let answer;
    try {
      answer = await fetch(this.url, { headers, signal: this.signal });
    } catch (error) {
      if (error.name === "AbortError") throw error;
      const { protocol, origin } = new URL(this.url, location.href), here = new URL(location.href).origin;
      if (protocol === "file:") {
        throw new NotSupported("a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the file here");
      }
      const orCors = origin === here ? "" : `, or its server does not allow ${here} (CORS)`;
      throw new NoAnswer(`cannot load ${this.url}: no answer${orCors}`);
    }
    // 416: an empty file has no first byte.
    if (!answer.ok && answer.status !== 416) {
      throw new NotSupported(`cannot load ${this.url}: HTTP ${answer.status}`);
    }
    return answer;
  }

  /**
   * Bytes from `start` on, `most` at most: no server fills the memory. answer: the first one, or null to ask for the range. What
   * is cut goes on where it stopped; where the server knows no ranges, from the start.
   */
  async _transfer(answer, start, most) {
    const pieces = [];
    let got = 0;
    for (let tries = 0; ; tries++) {
      let failure = null;
      try {
        answer ??= await this._ask({ Range: `bytes=${start + got}-${this.ranged ? start + most - 1 : ""}` });
        if (this.ranged && answer.status !== 206) throw new NotSupported(`${this.name}: the server forgot about ranges`);
        if (answer.status === 200) {
          this.fetched -= got;
          got = pieces.length = 0;
        }
        for await (const piece of piecesOf(answer)) {
          got += piece.length;
          if (got > most) await this._tooLong(answer, most);
          pieces.push(piece);
          this.fetched += piece.length;
          this.progress(this.fetched - this.begun, this.expected);
        }
      } catch (error) {
        if (error instanceof NotSupported && !(error instanceof NoAnswer)) throw error;
        this.signal?.throwIfAborted();
        failure = error;
      }
      const isWhole = !failure && (got === most || start === 0);
      if (isWhole || tries === UrlSource.pauses.length) {
        if (failure) throw new NotSupported(`${this.name}: the connection was cut after ${got} bytes, ${tries + 1} times`);
        return joined(pieces, got);
      }
      await new Promise((resolve) => setTimeout(resolve, UrlSource.pauses[tries]));
      answer = null;
    }
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

async function* piecesOf(answer) {
  if (answer.status === 416 || !answer.body) return;
  const reader = answer.body.getReader();
  try {
    for (let part = await reader.read(); !part.done; part = await reader.read()) yield part.value;
  } finally {
    await reader.cancel().catch(() => {});
  }
}

function joined(pieces, length) {
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    bytes.set(piece, at);
    at += piece.length;
  }
  return bytes;
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
