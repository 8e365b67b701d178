"""Bytes that the viewer fetches: never more than it asked for, nor more than fit."""

import json
from typing import Any

import pytest

from tests.web.in_node import SOURCES, in_node

SOURCE = SOURCES / "package" / "source.js"
PROGRAM = """
import { UrlSource } from "%s";
globalThis.location = { href: "http://here/" };
const asked = %s;
const piece = new Uint8Array(2 ** 20);
let sent = 0, cancelled = false;
const ranges = [];
UrlSource.pauses = [0, 0, 0];
function answer({ status, headers, bytes, cut, refused }) {
  if (refused) throw new TypeError("Failed to fetch");
  let left = bytes;
  const body = new ReadableStream({
    pull(controller) {
      if (!left) return cut ? controller.error(new TypeError("network error")) : controller.close();
      const part = piece.subarray(0, Math.min(left, piece.length));
      left -= part.length;
      sent += part.length;
      controller.enqueue(part);
    },
    cancel() { cancelled = true; },
  });
  return new Response(body, { status, headers });
}
globalThis.fetch = async (url, { headers }) => {
  ranges.push(headers.Range?.slice(6) ?? null);
  return answer(asked.shift() ?? { refused: true });
};
let result;
try {
  const source = await UrlSource.open("%s");
  result = `${source.size} bytes`;
  if (asked.length) result = `${(await source.read(70000, 80000)).length} bytes read`;
} catch (error) {
  result = `${error.constructor.name}: ${error.message}`;
}
console.log(JSON.stringify({ result, sent, cancelled, ranges }));
"""
HEAD = {"status": 206, "headers": {"Content-Range": "bytes 0-65535/1000000"}, "bytes": 65536}


REFUSED = {"refused": True}


def fetched(*answers: dict[str, Any], address: str = "http://there/a.rna") -> dict[str, Any]:
    """What becomes of answers of a server."""
    program = PROGRAM % (SOURCE.as_uri(), json.dumps(answers), address)
    return in_node(program)


def test_a_file_comes_whole_or_in_ranges():
    assert fetched({"status": 200, "headers": {}, "bytes": 5000})["result"] == "5000 bytes"
    part = {"status": 206, "headers": {}, "bytes": 10000}
    assert fetched(HEAD, part)["result"] == "10000 bytes read"


def test_a_file_too_large_for_the_memory_is_not_fetched():
    headers = {"Content-Length": str(2**31)}
    actual = fetched({"status": 200, "headers": headers, "bytes": 2**31})
    assert "from a server without range requests" in actual["result"]
    assert actual["sent"] < 2**22 and actual["cancelled"]


@pytest.mark.parametrize(
    "answers",
    [
        [{**HEAD, "bytes": 2**30}],
        [HEAD, {"status": 206, "headers": {}, "bytes": 2**30}],
    ],
)
def test_a_server_that_sends_more_than_asked_is_stopped(answers):
    actual = fetched(*answers)
    assert "sent more than the" in actual["result"]
    assert actual["sent"] < 2**22 and actual["cancelled"]


def test_a_range_that_is_cut_short_is_told():
    actual = fetched(HEAD, *[{"status": 206, "headers": {}, "bytes": 3}] * 4)
    assert "sent 12 bytes of 10000" in actual["result"]
    assert actual["ranges"][1:3] == ["70000-79999", "70003-79999"]


def test_what_is_cut_goes_on_where_it_stopped():
    cut = {"status": 206, "headers": {}, "bytes": 4000, "cut": True}
    actual = fetched(HEAD, cut, REFUSED, {"status": 206, "headers": {}, "bytes": 6000})
    assert actual["result"] == "10000 bytes read"
    assert actual["ranges"] == ["0-65535", "70000-79999", "74000-79999", "74000-79999"]
    actual = fetched(HEAD, cut, REFUSED, REFUSED, REFUSED)
    assert "the connection was cut after 4000 bytes, 4 times" in actual["result"]


def test_a_whole_file_that_is_cut():
    """From where it stopped, of a server that hides its ranges; else again from the start."""
    cut = {"status": 200, "headers": {}, "bytes": 4000, "cut": True}
    actual = fetched(cut, {"status": 206, "headers": {}, "bytes": 1000})
    assert (actual["result"], actual["ranges"]) == ("5000 bytes", ["0-65535", "4000-"])
    assert fetched(cut, {"status": 200, "headers": {}, "bytes": 5000})["result"] == "5000 bytes"


def test_a_server_that_codes_ranges_is_asked_without_one():
    """Chromium refuses an answer to a range that is compressed, as if there were none."""
    actual = fetched(REFUSED, {"status": 200, "headers": {}, "bytes": 5000})
    assert (actual["result"], actual["ranges"]) == ("5000 bytes", ["0-65535", None])


def test_cors_is_named_for_other_sites_alone():
    theirs, ours = fetched(REFUSED), fetched(REFUSED, address="http://here/a.rna")
    assert theirs["result"].endswith("no answer, or its server does not allow http://here (CORS)")
    assert ours["result"] == "NoAnswer: cannot load http://here/a.rna: no answer"
