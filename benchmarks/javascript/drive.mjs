// The run that every engine performs, as in drive.h. `make(scene)` returns an engine with the
// methods add(ball), step() and states(), a Float64Array of x, y, vx, vy of each ball.
import fs from "node:fs";
import process from "node:process";

function parse(text) {
    const scene = { capsules: [], balls: [], landed: -Infinity };
    for (const line of text.split("\n")) {
        const [word, ...rest] = line.split(" ");
        const numbers = rest.map(Number);
        if (word === "rate") scene.rate = numbers[0];
        else if (word === "gravity") scene.gravity = { x: numbers[0], y: numbers[1] };
        else if (word === "restitution") scene.restitution = numbers[0];
        else if (word === "friction") scene.friction = numbers[0];
        else if (word === "run") [scene.ticks, scene.measuredFrom, scene.sampleEvery] = numbers;
        else if (word === "landed") scene.landed = numbers[0];
        else if (word === "capsule") {
            const [x0, y0, x1, y1, radius] = numbers;
            scene.capsules.push({ x0, y0, x1, y1, radius });
        } else if (word === "ball") {
            const [tick, x, y, vx, vy, radius, mass] = numbers;
            scene.balls.push({ tick, x, y, vx, vy, radius, mass });
        }
    }
    return scene;
}

// Processor time, as in drive.h. It includes V8's own threads.
function seconds() {
    const used = process.cpuUsage();
    return (used.user + used.system) / 1e6;
}

function writeFrame(file, tick, states) {
    const head = new BigInt64Array([BigInt(tick), BigInt(states.length / 4)]);
    fs.writeSync(file, new Uint8Array(head.buffer));
    const bytes = new Uint8Array(states.buffer, states.byteOffset, states.byteLength);
    for (let at = 0; at < bytes.length; ) at += fs.writeSync(file, bytes, at);
}

function hasLanded(scene, states) {
    if (states.length < 4 * scene.balls.length) return false;
    for (let i = 1; i < states.length; i += 4) if (!(states[i] < scene.landed)) return false;
    return true;
}

// Warm-up: the same scene, off the clock and discarded, until the just-in-time compiler is done.
function warmUp(scene, make) {
    const engine = make(scene);
    let born = 0;
    const end = seconds() + 2;
    for (let tick = 0; tick < scene.ticks && seconds() < end; ++tick) {
        while (born < scene.balls.length && scene.balls[born].tick <= tick)
            engine.add(scene.balls[born++]);
        engine.step();
    }
}

export function drive(name, make) {
    const scene = parse(fs.readFileSync(process.argv[2], "utf8"));
    warmUp(scene, make);
    const file = process.argv[3] === "-" ? null : fs.openSync(process.argv[3], "w");
    const engine = make(scene);
    let born = 0;
    let tick = 0;
    let measured = 0;
    let total = 0;
    while (tick < scene.ticks) {
        let stop = (Math.floor(tick / scene.sampleEvery) + 1) * scene.sampleEvery;
        stop = Math.min(stop, scene.ticks);
        if (tick < scene.measuredFrom) stop = Math.min(stop, scene.measuredFrom);
        const count = stop - tick;
        const onTheClock = tick >= scene.measuredFrom;
        const start = seconds();
        for (; tick < stop; ++tick) {
            while (born < scene.balls.length && scene.balls[born].tick <= tick)
                engine.add(scene.balls[born++]);
            engine.step();
        }
        if (onTheClock) {
            total += seconds() - start;
            measured += count;
        }
        const states = engine.states();
        if (file !== null) writeFrame(file, tick, states);
        if (hasLanded(scene, states)) break;
    }
    console.log(`engine ${name}\nticks ${tick}\nmeasured ${measured}\nseconds ${total}`);
}
