#include "physics/solver_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "physics/contact/solver.h"
#include "physics/contact/swept_fallback.h"
#include "physics/discrete/solver.h"
#include "physics/event/engine.h"
#include "physics/event/hybrid_step.h"
#include "physics/event/motion/event_memory.h"
#include "physics/swept/solver.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// `discrete`, `substep` and `swept` use no solver memory, and void that of other solvers.
void forget_all(World& world) {
    SolverAccess(world).stamp_motion();
    SolverAccess(world).memory().clear();
    SolverAccess(world).stamp_memory();
}

// `contact` continues from the contacts in the memory of `event`, and drops the rest of it.
void keep_contacts(World& world) {
    if (!world.memory().find<EventMemory>()) return;
    SolverMemory& memory = SolverAccess(world).memory();
    ContactMemory contacts = memory.use<ContactMemory>();
    memory.replace(std::move(contacts));
}

// A tick of a solver that can be cancelled and keeps no memory: `tick` gets the token.
template <typename Tick>
TickOutcome tick_without_memory(World& world, const TickWork& work, Tick tick) {
    CancellationToken token(work.keep_going);
    tick(token);
    if (token.is_cancelled()) return TickOutcome::cancelled;
    forget_all(world);
    return TickOutcome::done;
}

class OverlapMethod final : public SolverMethod {
  public:
    OverlapMethod(int updates, int steps) : updates_(updates), steps_(steps) {}

    TickOutcome advance(World& world, TickWork work) override {
        return tick_without_memory(world, work, [&](CancellationToken& token) {
            solver_.tick(world, updates_, steps_, work.contacts, work.touched, token);
        });
    }
    const CellFrame& cells() const override { return solver_.cells(); }

  private:
    int updates_;
    int steps_;
    OverlapSolver solver_;
};

class SweptMethod final : public SolverMethod {
  public:
    explicit SweptMethod(int substeps) : substeps_(substeps) {}

    TickOutcome advance(World& world, TickWork work) override {
        return tick_without_memory(world, work, [&](CancellationToken& token) {
            solver_.tick(world, substeps_, work.contacts, work.touched, token, work.is_repeated);
        });
    }
    std::span<const std::uint32_t> standing() const override { return solver_.standing(); }
    const CellFrame& cells() const override { return solver_.cells(); }

  private:
    int substeps_;
    SweptSolver solver_;
};

// Where nothing can press, `swept` stands in for `contact`.
class ContactMethod final : public SolverMethod {
  public:
    explicit ContactMethod(int substeps) : substeps_(substeps) {}

    TickOutcome advance(World& world, TickWork work) override {
        was_swept_ = is_flight_only(world);
        if (!was_swept_) {
            keep_contacts(world);
            contact_.tick(world, substeps_, work.contacts, work.touched, work.is_strict);
            return TickOutcome::done;
        }
        return tick_without_memory(world, work, [&](CancellationToken& token) {
            swept_.tick(world, flight_substeps(world, substeps_), work.contacts, work.touched,
                        token, work.is_repeated);
        });
    }
    bool can_be_strict() const override { return true; }
    std::span<const std::uint32_t> standing() const override {
        return was_swept_ ? swept_.standing() : contact_.standing();
    }
    std::span<const Contact> pressing() const override {
        return was_swept_ ? std::span<const Contact>() : contact_.pressing();
    }
    const CellFrame& cells() const override {
        return was_swept_ ? swept_.cells() : contact_.cells();
    }

  private:
    int substeps_;
    bool was_swept_ = false;
    ContactSolver contact_;
    SweptSolver swept_;
};

// Hybrid stepping: `contact` moves clusters that are too dense for events.
class EventMethod final : public SolverMethod {
  public:
    TickOutcome advance(World& world, TickWork work) override {
        // `clustered` does not change until the tick is done, so a cancelled tick leaves no trace.
        const bool has_clusters = uses_hybrid_step(world.model(), {.kind = SolverKind::event}) &&
                                  HybridCluster::is_needed(world);
        was_hybrid_ = has_clusters;
        // A trial that is left to `contact` does not begin a budget of the engine.
        if (!work.is_repeated) event_.forget_trials();
        // While hands prevent hybrid steps, balls that `contact` left overlapping stay clustered.
        overlapping_.clear();
        if (!has_clusters) overlapping_ = event_memory(world).clustered;
        const EventOutcome outcome =
            has_clusters ? hybrid_.tick(world, event_, contact_, work.contacts, work.touched,
                                        work.keep_going, work.is_repeated)
                         : event_.tick(world, work.contacts, work.touched, work.keep_going,
                                       work.is_repeated);
        if (outcome == EventOutcome::cancelled) return TickOutcome::cancelled;
        EventMemory& memory = SolverAccess(world).memory().use<EventMemory>();
        if (!has_clusters) memory.contacts.clear();
        memory.reference.clear();
        if (!overlapping_.empty()) keep_overlapping(world, memory.clustered);
        return TickOutcome::done;
    }
    std::span<const std::uint32_t> standing() const override {
        return was_hybrid_ ? hybrid_.standing() : event_.standing();
    }
    std::span<const std::uint32_t> standing_before() const override {
        return was_hybrid_ ? hybrid_.standing_before() : std::span<const std::uint32_t>();
    }
    std::span<const Contact> pressing() const override {
        return was_hybrid_ ? hybrid_.pressing() : std::span<const Contact>();
    }
    const CellFrame& cells() const override { return event_.cells(); }

  private:
    void keep_overlapping(const World& world, std::vector<BallId>& clustered) {
        cluster_.find_staying(world, staying_);
        for (const BallId ball : overlapping_)
            if (std::ranges::binary_search(staying_, ball)) clustered.push_back(ball);
        std::ranges::sort(clustered);
        clustered.erase(std::unique(clustered.begin(), clustered.end()), clustered.end());
    }

    std::vector<BallId> overlapping_;
    std::vector<BallId> staying_;
    HybridCluster cluster_;
    bool was_hybrid_ = false;
    EventEngine<double> event_;
    ContactSolver contact_;
    HybridStep hybrid_;
};

class ExtendedEventMethod final : public SolverMethod {
  public:
    TickOutcome advance(World& world, TickWork work) override {
        const EventOutcome outcome =
            event_.tick(world, work.contacts, work.touched, work.keep_going, work.is_repeated);
        if (outcome == EventOutcome::cancelled) return TickOutcome::cancelled;
        EventMemory& memory = SolverAccess(world).memory().use<EventMemory>();
        memory.clustered.clear();
        memory.contacts.clear();
        memory.reference.clear();
        return TickOutcome::done;
    }
    std::span<const std::uint32_t> standing() const override { return event_.standing(); }
    const CellFrame& cells() const override { return event_.cells(); }

  private:
    EventEngine<DoubleDouble> event_;
};

using Made = std::unique_ptr<SolverMethod>;

bool always(const World&) {
    return true;
}
// `discrete` moves each ball only once a tick.
bool never(const World&) {
    return false;
}

constexpr std::array<SolverRow, 5> rows{{
    {.kind = SolverKind::discrete,
     .supports_cloth = true,
     .supports_hinges = false,
     .overlaps_at_impacts = true,
     .can_cancel = never,
     .make = [](const SolverSettings&) -> Made { return std::make_unique<OverlapMethod>(1, 1); }},
    {.kind = SolverKind::substep,
     .supports_cloth = true,
     .supports_hinges = false,
     .overlaps_at_impacts = true,
     .can_cancel = always,
     .make = [](const SolverSettings& settings) -> Made {
         return std::make_unique<OverlapMethod>(settings.updates, settings.steps);
     }},
    {.kind = SolverKind::swept,
     .supports_cloth = true,
     .supports_hinges = true,
     .overlaps_at_impacts = false,
     .can_cancel = always,
     .make = [](const SolverSettings& settings) -> Made {
         return std::make_unique<SweptMethod>(settings.substeps);
     }},
    // The constraint solver does a fixed amount of work; its stand-in does not.
    {.kind = SolverKind::contact,
     .supports_cloth = false,
     .supports_hinges = true,
     .overlaps_at_impacts = false,
     .can_cancel = is_flight_only,
     .make = [](const SolverSettings& settings) -> Made {
         return std::make_unique<ContactMethod>(settings.contact_substeps);
     }},
    {.kind = SolverKind::event,
     .supports_cloth = true,
     .supports_hinges = true,
     .overlaps_at_impacts = false,
     .can_cancel = always,
     .make = [](const SolverSettings& settings) -> Made {
         if (settings.extended) return std::make_unique<ExtendedEventMethod>();
         return std::make_unique<EventMethod>();
     }},
}};

constexpr bool rows_are_in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].kind != static_cast<SolverKind>(i)) return false;
    return true;
}
static_assert(rows_are_in_order());

}  // namespace

std::span<const SolverRow> solver_table() {
    return rows;
}

}  // namespace carom
