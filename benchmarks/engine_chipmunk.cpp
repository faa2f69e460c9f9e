#include <chipmunk/chipmunk.h>

#include <cmath>
#include <limits>
#include <vector>

#include "drive.h"

// Chipmunk with its defaults: 10 iterations; no sleeping.
namespace {

using namespace carom::bench;

class Chipmunk {
  public:
    explicit Chipmunk(const SceneList& scene) : space_(cpSpaceNew()), scene_(scene) {
        cpSpaceSetGravity(space_, cpv(scene.gravity_x, scene.gravity_y));
        for (const ListedCapsule& capsule : scene.capsules) {
            attach(cpSegmentShapeNew(cpSpaceGetStaticBody(space_),
                                     cpv(capsule.start_x, capsule.start_y),
                                     cpv(capsule.end_x, capsule.end_y), capsule.radius));
        }
    }
    // The contents of the space are freed with the process.
    ~Chipmunk() = default;
    Chipmunk(const Chipmunk&) = delete;
    Chipmunk& operator=(const Chipmunk&) = delete;

    void add(const ListedBall& ball) {
        const double moment = scene_.friction == 0.0
                                  ? std::numeric_limits<double>::infinity()
                                  : cpMomentForCircle(ball.mass, 0.0, ball.radius, cpvzero);
        cpBody* body = cpSpaceAddBody(space_, cpBodyNew(ball.mass, moment));
        cpBodySetPosition(body, cpv(ball.x, ball.y));
        cpBodySetVelocity(body, cpv(ball.vx, ball.vy));
        attach(cpCircleShapeNew(body, ball.radius, cpvzero));
        balls_.push_back(body);
    }

    void step() { cpSpaceStep(space_, 1.0 / scene_.rate); }

    std::size_t size() const { return balls_.size(); }
    BallState state(std::size_t index) const {
        const cpVect position = cpBodyGetPosition(balls_[index]);
        const cpVect velocity = cpBodyGetVelocity(balls_[index]);
        return {position.x, position.y, velocity.x, velocity.y};
    }

  private:
    // A pair takes the product of both.
    void attach(cpShape* shape) {
        cpShapeSetElasticity(shape, std::sqrt(scene_.restitution));
        cpShapeSetFriction(shape, std::sqrt(scene_.friction));
        cpSpaceAddShape(space_, shape);
    }

    cpSpace* space_;
    const SceneList& scene_;
    std::vector<cpBody*> balls_;
};

}  // namespace

// bench_chipmunk LIST FRAMES
int main(int count, char** arguments) {
    if (count != 3) return 2;
    const SceneList scene = read_scene_list(arguments[1]);
    Chipmunk engine(scene);
    const Driven driven = drive(engine, scene, arguments[2]);
    report(fmt::format("Chipmunk {} (" CAROM_BENCH_ORIGIN ")", cpVersionString), driven);
}
