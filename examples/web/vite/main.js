// A glTF robot beside a neural toy, with shadows from each onto the other and onto the floor.
import * as THREE from "three/webgpu";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { RnaLoader } from "rna-three";

const renderer = new THREE.WebGPURenderer({ antialias: true });
renderer.shadowMap.enabled = true;
renderer.toneMapping = THREE.ACESFilmicToneMapping;
document.body.append(renderer.domElement);

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x20242a);
const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 20);
camera.position.set(1.7, 0.9, 1.5);

const sun = new THREE.DirectionalLight(0xfff2e0, 3);
sun.position.set(1, 1.6, 0.9);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.normalBias = 0.004;
Object.assign(sun.shadow.camera, { left: -1, right: 1, top: 1, bottom: -1, near: 0.1, far: 5 });
const sky = new THREE.DirectionalLight(0xbcd0ff, 0.8);
sky.position.set(-1, 0.7, 0.4);
scene.add(sun, sky);

const [toy, { scene: robot }] = await Promise.all([
  new RnaLoader().loadAsync("toy.rna"), new GLTFLoader().loadAsync("robot.glb"),
]);
robot.position.set(0.5, 0, 0.42);
robot.rotation.y = 0.9;
robot.traverse((part) => { part.castShadow = part.receiveShadow = true; });

const floor = new THREE.Mesh(new THREE.CircleGeometry(1.4, 64), new THREE.MeshStandardMaterial({ color: 0x8d8f94 }));
floor.rotation.x = -Math.PI / 2;
floor.receiveShadow = true;
scene.add(toy, robot, floor);

// Draws when something changes: a decoder is more work than a usual material.
await renderer.init();
const draw = () => renderer.render(scene, camera);
const controls = new OrbitControls(camera, renderer.domElement);
controls.target.set(0.1, 0.15, 0.1);
controls.update();
controls.addEventListener("change", draw);
const resize = () => {
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  draw();
};
addEventListener("resize", resize);
resize();
