#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "physics/world/world.h"

/// What happens at the start and the end of every tick, whatever the solver: emitters, the stop
/// speed, and sinks.
namespace carom {

/// Adds the balls that emitters create in the tick that begins.
void emit(World& world);

/// Stops balls slower than the stop speed; a spinning ball only when its surface is slower too.
/// `touched`: by index, whether the ball had a contact in this tick, as the solver counts it
/// (TickWork::touched). Under gravity only balls with contacts stop.
void stop_slow_balls(World& world, const std::vector<std::uint8_t>& touched);

/// Counts and removes the balls in sinks. It keeps what it knows of the zones for worlds with the
/// same definition: where no sink is, so that most balls need not be compared with each pocket of a
/// pool table. A new object drains the same balls.
class SinkDrain {
  public:
    /// `world.tick` is the tick that ends.
    void drain(World& world);

  private:
    // The space along one axis between the sinks on either side of a middle: in it no sink lies.
    // Empty if a sink lies across the middle.
    struct Gap {
        double after = -std::numeric_limits<double>::infinity();
        double before = std::numeric_limits<double>::infinity();

        void leave_out(double low, double high, double middle);
        bool contains(double place) const { return after < place && place < before; }
    };

    void take_sinks(const World& world);

    Stamp definition_{};  ///< what the rest was made from
    bool has_sinks_ = false;
    Gap across_;
    Gap along_;
};

/// How many substeps a tick needs: `wanted` or more, at most 10,000. On a torus no ball may travel
/// more than an eighth of it in a substep, so that it cannot meet two images of another ball.
int substeps_needed(const World& world, int wanted);

}  // namespace carom
