// Browsers leave canvases of WebGPU out of what they print: a copy takes the picture's place on paper.

/** Covers the canvas with a copy while the page is printed, until the signal. show: draws the picture on the canvas once more. */
export function copyForPaper(canvas, show, signal) {
  const copy = document.createElement("canvas");
  addEventListener("beforeprint", () => {
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    show();  // the canvas can be read in the same task alone
    copy.getContext("2d").drawImage(canvas, 0, 0);
    canvas.after(copy);
  }, { signal });
  addEventListener("afterprint", () => copy.remove(), { signal });
}
