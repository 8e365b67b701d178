// A neural toy in React Three Fiber.
import { Canvas, extend, useLoader } from "@react-three/fiber";
import { Suspense } from "react";
import { createRoot } from "react-dom/client";
import { RnaLoader } from "rna-three";
import * as THREE from "three/webgpu";

extend(THREE);

async function webgpu(props) {
  const renderer = new THREE.WebGPURenderer(props);
  await renderer.init();
  return renderer;
}

function Toy(props) {
  return <primitive object={useLoader(RnaLoader, "toy.rna")} {...props} />;
}

createRoot(document.getElementById("root")).render(
  <Canvas gl={webgpu} frameloop="demand" camera={{ position: [1.6, 0.9, 0.9], fov: 30 }}>
    <directionalLight position={[1, 1.6, 0.9]} intensity={3} />
    <Suspense fallback={null}>
      <Toy rotation-y={0.4} />
    </Suspense>
  </Canvas>,
);
