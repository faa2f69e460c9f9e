// Box2D 3 with its defaults (4 substeps), without sleeping, in one thread. Compiled to WASM with
// SIMD it is slower than natively: see docs/performance.md.
import Box2D from "box2d3-wasm";
import { drive } from "./drive.mjs";

const b2 = await Box2D();

function vector(x, y) {
    return new b2.b2Vec2(x, y);
}

class Box2d3Engine {
    constructor(scene) {
        this.scene = scene;
        const world = b2.b2DefaultWorldDef();
        world.gravity = vector(scene.gravity.x, scene.gravity.y);
        world.enableSleep = false;
        this.world = b2.b2CreateWorld(world);
        this.balls = [];
        const ground = b2.b2CreateBody(this.world, b2.b2DefaultBodyDef());
        for (const { x0, y0, x1, y1, radius } of scene.capsules) {
            if (x0 === x1 && y0 === y1) {
                const disc = new b2.b2Circle();
                disc.center = vector(x0, y0);
                disc.radius = radius;
                b2.b2CreateCircleShape(ground, this.material(0), disc);
            } else {
                const capsule = new b2.b2Capsule();
                capsule.center1 = vector(x0, y0);
                capsule.center2 = vector(x1, y1);
                capsule.radius = radius;
                b2.b2CreateCapsuleShape(ground, this.material(0), capsule);
            }
        }
    }

    // A pair takes the larger restitution and the geometric mean of the frictions.
    material(density) {
        const shape = b2.b2DefaultShapeDef();
        const surface = shape.material;
        surface.restitution = this.scene.restitution;
        surface.friction = this.scene.friction;
        shape.material = surface;
        shape.density = density;
        return shape;
    }

    add(ball) {
        const definition = b2.b2DefaultBodyDef();
        definition.type = b2.b2BodyType.b2_dynamicBody;
        definition.position = vector(ball.x, ball.y);
        definition.linearVelocity = vector(ball.vx, ball.vy);
        if (this.scene.friction === 0) {
            const locks = definition.motionLocks;
            locks.angularZ = true;
            definition.motionLocks = locks;
        }
        const body = b2.b2CreateBody(this.world, definition);
        const disc = new b2.b2Circle();
        disc.radius = ball.radius;
        const density = ball.mass / (Math.PI * ball.radius * ball.radius);
        b2.b2CreateCircleShape(body, this.material(density), disc);
        this.balls.push(body);
        for (const handle of [definition, disc]) handle.delete();
    }

    step() {
        b2.b2World_Step(this.world, 1 / this.scene.rate, 4);
    }

    states() {
        const states = new Float64Array(4 * this.balls.length);
        this.balls.forEach((body, i) => {
            const position = b2.b2Body_GetPosition(body);
            const velocity = b2.b2Body_GetLinearVelocity(body);
            states.set([position.x, position.y, velocity.x, velocity.y], 4 * i);
            position.delete();
            velocity.delete();
        });
        return states;
    }
}

drive("Box2D 3 (box2d3-wasm 5.2.0, SIMD)", (scene) => new Box2d3Engine(scene));
// Its unused threads would keep the process alive.
process.exit(0);
