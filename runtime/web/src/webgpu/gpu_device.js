// What WebGPU gives in one place: a device, buffers that are checked, modules, dispatches.
import { NotSupported } from "../package/errors.js";
import { readableBytes } from "../ui/elements.js";

const WANTED = ["maxStorageBufferBindingSize", "maxBufferSize"];

/** A device with the largest buffers that the adapter allows. */
export async function openDevice() {
  const adapter = await navigator.gpu?.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) {
    const why = navigator.gpu ? "WebGPU has no adapter here"
      : isSecureContext ? "this browser has no WebGPU" : "WebGPU needs HTTPS, or a page from this machine";
    throw new NotSupported(`${why}: no more than a stand-in or a poster is shown`);
  }
  const requiredLimits = Object.fromEntries(WANTED.map((name) => [name, adapter.limits[name]]));
  return adapter.requestDevice({ requiredLimits });
}

/** A storage or uniform buffer with this content, or of so many bytes. */
export function buffer(device, content, usage = GPUBufferUsage.STORAGE, what = "a buffer") {
  const bytes = typeof content === "number" ? content : content.byteLength;
  const size = Math.max(16, Math.ceil(bytes / 16) * 16), most = device.limits.maxStorageBufferBindingSize;
  if (size > most) throw new NotSupported(`${what} takes ${readableBytes(size)}; this GPU allows ${readableBytes(most)}`);
  const result = device.createBuffer({
    size, usage: usage | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC, mappedAtCreation: typeof content !== "number",
  });
  if (typeof content !== "number") {
    const bytesOf = new Uint8Array(content.buffer, content.byteOffset, content.byteLength);
    new Uint8Array(result.getMappedRange()).set(bytesOf);
    result.unmap();
  }
  return result;
}

/** A module; what it does not compile for is an error. */
export async function compiled(device, code) {
  const shader = device.createShaderModule({ code });
  const { messages } = await shader.getCompilationInfo();
  const wrong = messages.find(({ type }) => type === "error");
  if (wrong) throw new Error(`a shader does not compile, line ${wrong.lineNum}: ${wrong.message}`);
  return shader;
}

/** Buffers bound from 0 on to a group of a pipeline with automatic layout. */
export const bind = (device, pipeline, group, buffers) => bindGroup(device, pipeline.getBindGroupLayout(group), buffers);

/** A layout of compute bindings by their numbers: the types of buffers. */
export function groupLayout(device, types) {
  const entries = Object.entries(types).map(([binding, type]) =>
    ({ binding: Number(binding), visibility: GPUShaderStage.COMPUTE, buffer: { type } }));
  return device.createBindGroupLayout({ entries });
}

export function bindGroup(device, layout, buffers) {
  const entries = Object.entries(buffers).map(([binding, content]) => ({ binding: Number(binding), resource: { buffer: content } }));
  return device.createBindGroup({ layout, entries });
}

/** One dispatch of `count` invocations in groups of 64. */
export function dispatch(pass, pipeline, groups, count) {
  const all = Math.max(1, Math.ceil(count / 64)), wide = Math.min(all, 32768);
  pass.setPipeline(pipeline);
  groups.forEach((group, k) => pass.setBindGroup(k, group));
  pass.dispatchWorkgroups(wide, Math.ceil(all / wide));
}

/** The bytes of a buffer. */
export async function read(device, from, bytes) {
  const to = device.createBuffer({ size: Math.ceil(bytes / 4) * 4, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
  const encoder = device.createCommandEncoder();
  encoder.copyBufferToBuffer(from, 0, to, 0, to.size);
  device.queue.submit([encoder.finish()]);
  await to.mapAsync(GPUMapMode.READ);
  const result = to.getMappedRange().slice(0);
  to.destroy();
  return result;
}
