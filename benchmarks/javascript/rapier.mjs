// Rapier with its defaults (4 solver iterations); no sleeping. The caller chooses the package:
// plain or with SIMD.
import { drive } from "./drive.mjs";

class RapierEngine {
    constructor(rapier, scene) {
        this.rapier = rapier;
        this.scene = scene;
        this.world = new rapier.World(scene.gravity);
        this.world.timestep = 1 / scene.rate;
        this.balls = [];
        for (const { x0, y0, x1, y1, radius } of scene.capsules) {
            const length = Math.hypot(x1 - x0, y1 - y0);
            const shape =
                length === 0
                    ? rapier.ColliderDesc.ball(radius)
                    : rapier.ColliderDesc.capsule(length / 2, radius);
            // Rapier's capsules are upright.
            shape.setTranslation((x0 + x1) / 2, (y0 + y1) / 2);
            if (length > 0) shape.setRotation(Math.atan2(y1 - y0, x1 - x0) - Math.PI / 2);
            this.world.createCollider(this.material(shape));
        }
    }

    // A pair takes the mean.
    material(shape) {
        return shape.setRestitution(this.scene.restitution).setFriction(this.scene.friction);
    }

    add(ball) {
        const definition = this.rapier.RigidBodyDesc.dynamic()
            .setTranslation(ball.x, ball.y)
            .setLinvel(ball.vx, ball.vy)
            .setCanSleep(false);
        if (this.scene.friction === 0) definition.lockRotations();
        const body = this.world.createRigidBody(definition);
        const disc = this.rapier.ColliderDesc.ball(ball.radius);
        this.world.createCollider(this.material(disc).setMass(ball.mass), body);
        this.balls.push(body);
    }

    step() {
        this.world.step();
    }

    states() {
        const states = new Float64Array(4 * this.balls.length);
        this.balls.forEach((body, i) => {
            const position = body.translation();
            const velocity = body.linvel();
            states.set([position.x, position.y, velocity.x, velocity.y], 4 * i);
        });
        return states;
    }
}

export async function run(rapier, name) {
    await rapier.init();
    drive(name, (scene) => new RapierEngine(rapier, scene));
}
