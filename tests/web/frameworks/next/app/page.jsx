import { RnaViewer } from "rna-viewer/react";
import { Toy } from "./toy";

// A server component: the second element has no listeners, so that it needs no client component of the page's.
export default function Page() {
  return <main>
    <h1>Next.js</h1>
    <Toy />
    <RnaViewer id="two" src="/toy.rna" alt="A toy car" camera-controls={true} />
    <div style={{ height: 3000 }} />
  </main>;
}
