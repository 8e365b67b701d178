// What is inside the element: canvas, poster, progress, a line for what goes wrong; and how it looks.

/** An element with attributes and what is in it; made so, since a policy may refuse HTML as text (Trusted Types). */
function make(name, attributes, ...inside) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...inside);
  return made;
}

const content = () => [
  make("i", { id: "tint" }),
  make("div", { id: "view", part: "view" }),
  make("div", { id: "hotspots" }),
  make("slot", {}),
  make("div", { id: "poster" }, make("slot", { name: "poster" }, make("img", { part: "poster", alt: "", hidden: "" }))),
  make("div", { id: "over" },
    make("div", { id: "loading", hidden: "" }, make("slot", { name: "progress-bar" },
      make("progress", { id: "bar", part: "progress-bar" }), make("span", { id: "bytes" }))),
    make("p", { id: "prompt", part: "prompt", "aria-hidden": "true", hidden: "" }),
    make("p", { id: "notice", part: "notice", role: "status", hidden: "" })),
  make("p", { id: "keys", class: "spoken" }),
  make("p", { id: "status", class: "spoken", role: "status" }),
];

const STYLE = `
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#tint { position: absolute; background-color: inherit; transition: background-color 1ms; }
canvas { display: block; }
#view > :last-child { transition: opacity 0.3s; }
#view.standing > :last-child { opacity: 0; transition: none; }
#view:has(~ #poster:not([hidden]) img:not([hidden])) canvas { filter: opacity(0); }
canvas:focus-visible { outline: none; }
#view:has(> :focus-visible)::after { content: ""; position: absolute; inset: 0; outline: 2px solid #fff; outline-offset: -2px; pointer-events: none; }
:host([camera-controls]:not([camera-controls="false"])) canvas { cursor: grab; }
:host([camera-controls]:not([camera-controls="false"])) canvas.dragging { cursor: grabbing; }
#hotspots { position: absolute; inset: 0; pointer-events: none; }
#hotspots slot { display: flex; position: absolute; transform: translate(-50%, -50%); pointer-events: auto; }
#hotspots .unseen { visibility: hidden; }
#poster { pointer-events: none; }
::slotted([slot="poster"]) { pointer-events: auto; }
#poster img { object-fit: contain; }
#over {
  position: absolute; inset: 0; padding: 16px; pointer-events: none; overflow: hidden; box-sizing: border-box;
  display: flex; flex-direction: column; justify-content: flex-end; align-items: center; gap: 10px;
}
#loading { text-align: center; font-variant-numeric: tabular-nums; }
#bar {
  display: block; width: min(60vw, 320px); max-width: 100%; height: 4px; margin-bottom: 6px; border: 0; border-radius: 2px;
  appearance: none; background: #3a3a3a;
}
#bar::-webkit-progress-bar { background: #3a3a3a; border-radius: 2px; }
#bar::-webkit-progress-value { background: #cfcfcf; border-radius: 2px; }
#bar::-moz-progress-bar { background: #cfcfcf; border-radius: 2px; }
#notice {
  max-width: min(100%, 60ch); margin: 0; padding: 10px 16px; border-radius: 6px; pointer-events: auto; text-align: center;
  background: #7a2525; border: 1px solid #a34a4a; overflow-wrap: anywhere;
}
#notice.calm { background: #000c; border-color: #555; }
#notice span { display: block; }
#prompt {
  margin: 0 0 8%; padding: 6px 16px; border-radius: 999px; background: #000a; animation: prompt 4s ease-in-out infinite;
}
@keyframes prompt { 0%, 100% { transform: translateX(-24px); opacity: 0; } 20%, 80% { opacity: 1; } 50% { transform: translateX(24px); } }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`;

const sheets = new WeakMap();  // by window

/** The content in a new shadow tree. */
export function attach(host) {
  const root = host.attachShadow({ mode: "open", delegatesFocus: true });
  dress(root);
  root.append(...content());
  return root;
}

/**
 * Gives a shadow tree its style, also where it comes to another document, which takes the style away. A policy against inline
 * styles (CSP) allows it: it is a constructed sheet.
 */
export function dress(root) {
  const view = root.ownerDocument.defaultView;
  if (!view) return;  // a document that nobody sees
  if (!sheets.has(view)) {
    sheets.set(view, new view.CSSStyleSheet());
    sheets.get(view).replaceSync(STYLE);
  }
  root.adoptedStyleSheets = [sheets.get(view)];
}
