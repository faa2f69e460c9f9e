#include <doctest/doctest.h>

#include <string>

#include "game/pool/pool.h"
#include "game/session/session.h"
#include "game/support/shipped.h"

using namespace carom;

namespace {

// Steps until the balls rest, at most for so many seconds. Whether they do.
bool comes_to_rest(Session& session, double seconds) {
    const auto end =
        session.world().tick() + static_cast<std::uint64_t>(seconds * session.world().rate());
    do {
        session.step_forward();
    } while (session.world().tick() < end && !is_at_rest(session.world()));
    return is_at_rest(session.world());
}

}  // namespace

// Until then nobody can shoot.
TEST_CASE("in levels with a cue the balls come to rest, at the start and after a stroke") {
    for (const char* const level : {"catapult", "windmill", "mini-golf", "skittles", "bumper-pool",
                                    "three-cushion", "puzzle-11", "pool-table"}) {
        CAPTURE(std::string(level));
        for (const double share : {0.2, 0.5, 0.9}) {
            CAPTURE(share);
            Scene scene = test::shipped_level(level);
            const SolverSettings solver = pick_solver(scene.world).settings;
            Session session(std::move(scene), solver);
            CHECK(comes_to_rest(session, 5.0));
            const Cue& cue = *session.scene().pool.cue;
            const Vec2 way{0.96, 0.28};
            session.apply(command::Strike{cue.ball, way * (share * cue.most_power)});
            CHECK(comes_to_rest(session, 60.0));
        }
    }
}
