#include <box2d/box2d.h>

#include <numbers>
#include <vector>

#include "drive.h"

// Box2D 2.4 with its defaults: 8 velocity iterations, 3 position iterations; no sleeping.
namespace {

using namespace carom::bench;

float narrow(double value) {
    return static_cast<float>(value);
}

class Box2d2 {
  public:
    explicit Box2d2(const SceneList& scene)
        : world_(b2Vec2(narrow(scene.gravity_x), narrow(scene.gravity_y))), scene_(scene) {
        world_.SetAllowSleeping(false);
        for (const ListedCapsule& capsule : scene.capsules)
            add(capsule);
    }

    void add(const ListedBall& ball) {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position.Set(narrow(ball.x), narrow(ball.y));
        definition.linearVelocity.Set(narrow(ball.vx), narrow(ball.vy));
        definition.fixedRotation = scene_.friction == 0.0;
        b2Body* body = world_.CreateBody(&definition);
        b2CircleShape disc;
        disc.m_radius = narrow(ball.radius);
        attach(body, disc, ball.mass / (std::numbers::pi * ball.radius * ball.radius));
        balls_.push_back(body);
    }

    void step() { world_.Step(narrow(1.0 / scene_.rate), 8, 3); }

    std::size_t size() const { return balls_.size(); }
    BallState state(std::size_t index) const {
        const b2Vec2 position = balls_[index]->GetPosition();
        const b2Vec2 velocity = balls_[index]->GetLinearVelocity();
        return {position.x, position.y, velocity.x, velocity.y};
    }

  private:
    // Box2D 2.4 has no capsules: a box and two discs.
    void add(const ListedCapsule& capsule) {
        const b2BodyDef definition;
        b2Body* body = world_.CreateBody(&definition);
        const b2Vec2 start(narrow(capsule.start_x), narrow(capsule.start_y));
        const b2Vec2 end(narrow(capsule.end_x), narrow(capsule.end_y));
        b2CircleShape round;
        round.m_radius = narrow(capsule.radius);
        round.m_p = start;
        attach(body, round, 0.0);
        b2Vec2 along = end - start;
        const float length = along.Normalize();
        if (length == 0.0f) return;
        round.m_p = end;
        attach(body, round, 0.0);
        const b2Vec2 across = round.m_radius * b2Cross(1.0f, along);
        const b2Vec2 corners[] = {start - across, end - across, end + across, start + across};
        b2PolygonShape side;
        side.Set(corners, 4);
        attach(body, side, 0.0);
    }

    void attach(b2Body* body, const b2Shape& shape, double density) {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = narrow(density);
        fixture.restitution = narrow(scene_.restitution);  // a pair takes the larger
        fixture.friction = narrow(scene_.friction);        // a pair takes the geometric mean
        body->CreateFixture(&fixture);
    }

    b2World world_;
    const SceneList& scene_;
    std::vector<b2Body*> balls_;
};

}  // namespace

// bench_box2d LIST FRAMES
int main(int count, char** arguments) {
    if (count != 3) return 2;
    const SceneList scene = read_scene_list(arguments[1]);
    Box2d2 engine(scene);
    const Driven driven = drive(engine, scene, arguments[2]);
    report(fmt::format("Box2D {}.{} (" CAROM_BENCH_ORIGIN ")", b2_version.major, b2_version.minor),
           driven);
}
