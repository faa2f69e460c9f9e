import rapier from "@dimforge/rapier2d-compat";
import { run } from "./rapier.mjs";

await run(rapier, "Rapier 0.21.0 (WASM)");
