// matter.js with its defaults. It computes in pixels and in steps of 1/60 s. Nothing bounces that
// moves less than a few pixels a step, so a unit of the scene is 20 pixels here.
import Matter from "matter-js";
import { drive } from "./drive.mjs";

const pixels = 20;

class MatterEngine {
    constructor(scene) {
        this.scene = scene;
        this.step_length = 1000 / scene.rate; // ms
        this.engine = Matter.Engine.create({
            gravity: { x: scene.gravity.x, y: scene.gravity.y, scale: pixels * 1e-6 },
        });
        this.balls = [];
        for (const capsule of scene.capsules) this.addCapsule(capsule);
    }

    material() {
        // A pair takes the larger restitution and the smaller friction.
        const { restitution, friction } = this.scene;
        return { restitution, friction, frictionStatic: 0, frictionAir: 0 };
    }

    addCapsule({ x0, y0, x1, y1, radius }) {
        const rest = { isStatic: true, ...this.material() };
        const length = Math.hypot(x1 - x0, y1 - y0);
        const parts = [Matter.Bodies.circle(pixels * x0, pixels * y0, pixels * radius, rest)];
        if (length > 0) {
            parts.push(Matter.Bodies.circle(pixels * x1, pixels * y1, pixels * radius, rest));
            parts.push(
                Matter.Bodies.rectangle(
                    (pixels * (x0 + x1)) / 2, (pixels * (y0 + y1)) / 2, pixels * length,
                    2 * pixels * radius, { ...rest, angle: Math.atan2(y1 - y0, x1 - x0) }));
        }
        Matter.Composite.add(this.engine.world, parts);
    }

    add(ball) {
        const body = Matter.Bodies.circle(
            pixels * ball.x, pixels * ball.y, pixels * ball.radius, this.material());
        Matter.Body.setMass(body, ball.mass);
        if (this.scene.friction === 0) Matter.Body.setInertia(body, Infinity);
        Matter.Body.setVelocity(body, { x: (pixels * ball.vx) / 60, y: (pixels * ball.vy) / 60 });
        Matter.Composite.add(this.engine.world, body);
        this.balls.push(body);
    }

    step() {
        Matter.Engine.update(this.engine, this.step_length);
    }

    states() {
        const states = new Float64Array(4 * this.balls.length);
        this.balls.forEach((body, i) => {
            const velocity = Matter.Body.getVelocity(body);
            states[4 * i] = body.position.x / pixels;
            states[4 * i + 1] = body.position.y / pixels;
            states[4 * i + 2] = (velocity.x * 60) / pixels;
            states[4 * i + 3] = (velocity.y * 60) / pixels;
        });
        return states;
    }
}

drive("matter.js 0.20.0", (scene) => new MatterEngine(scene));
