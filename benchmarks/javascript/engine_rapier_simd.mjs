import rapier from "@dimforge/rapier2d-simd-compat";
import { run } from "./rapier.mjs";

await run(rapier, "Rapier 0.19.3 (WASM, SIMD)");
