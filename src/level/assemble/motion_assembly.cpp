#include "level/assemble/motion_assembly.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/elementary.h"
#include "level/text/spelling.h"
#include "physics/solver.h"

namespace carom {
namespace {

// Within a tick an edge goes straight, so a round must take many of them.
constexpr double least_ticks = 12.0;

// How a statement that moves edges speaks of them.
struct MovingWords {
    FaultCode of_part;
    FaultCode of_one_way;
    FaultCode twice;
    std::string_view verb;
    std::string_view instead_of_part;
    std::string_view once;
};

// Whether the edge may be moved; if not, reports why.
bool is_free(const CapsuleIr& edge, const Word& name, Reporter& reporter,
             const MovingWords& words) {
    const auto refuse = [&](FaultCode code, const std::string& why, std::string_view remedy) {
        reporter.error(code, name.span(), fmt::format("'{}' {}", name.text, why),
                       std::string(remedy));
    };
    if (edge.device >= 0)
        refuse(words.of_part, "is a part of a pinball table", words.instead_of_part);
    else if (edge.side != Side::both)
        refuse(words.of_one_way, fmt::format("has a side, and so cannot {}", words.verb),
               "leave side= out");
    else if (edge.is_moved)
        refuse(words.twice, "is moved already", words.once);
    else
        return true;
    return false;
}

}  // namespace

void MotionAssembly::check_names() {
    for (const MotionIr& motion : ir_.motions)
        for (const Word& name : motion.names)
            check_name(name);
}

void MotionAssembly::check_name(const Word& name) {
    std::vector<std::string_view> known;
    for (const CapsuleIr& edge : ir_.capsules) {
        const std::string& called = names_.edges[static_cast<std::size_t>(edge.binding)].name;
        if (called == name.text) return;
        if (!called.empty() && (known.empty() || known.back() != called)) known.push_back(called);
    }
    if (std::ranges::count(ir_.error_names, name.text) > 0) return;
    context_.reporter.error(
        "motion-of-nothing", name.span(), fmt::format("there is no edge '{}'", name.text),
        did_you_mean(name.text, known, "give an edge this name: edge name=... X,Y X,Y"));
}

void MotionAssembly::place_edges(double rate) {
    if (ir_.motions.empty() && ir_.amendments.empty()) return;
    amend_clocks();
    if (!ir_.motions.empty() && ir_.settings.wrap)
        context_.reporter.error("motion-on-torus", ir_.motions.front().at,
                                "on a torus no edges move by themselves", "leave use wrap out");
    for (std::uint32_t i = 0; i < ir_.motions.size(); ++i) {
        check_times(ir_.motions[i], rate);
        for (const Word& name : ir_.motions[i].names)
            place(i, name);
    }
    std::ranges::sort(moved_, {}, &Moved::edge);
}

// `move NAME time=` says how long a motion has run.
void MotionAssembly::amend_clocks() {
    for (const AmendmentIr& amendment : ir_.amendments) {
        if (!amendment.is_of_motion()) continue;
        const Span at = amendment.name ? amendment.name->span() : amendment.span;
        const auto found = std::ranges::find_if(ir_.motions, [&](const MotionIr& motion) {
            return amendment.name && motion.names.front().text == amendment.name->text;
        });
        if (found == ir_.motions.end()) {
            context_.reporter.error("amends-nothing", at, "there is no such motion",
                                    "write the first name of the motion");
            continue;
        }
        if (amendment.clock) {
            found->mover.clock = *amendment.clock;
            found->time_at = at;
        }
        if (amendment.runs) found->mover.runs = *amendment.runs;
    }
}

void MotionAssembly::check_times(const MotionIr& motion, double rate) {
    const Mover& mover = motion.mover;
    if (mover.period * rate < least_ticks)
        context_.reporter.error(
            "motion-too-fast", motion.every_at,
            fmt::format("a round must take {:.6g} ticks or more, but takes {:.3g}", least_ticks,
                        mover.period * rate),
            fmt::format("write every={:.3g} or more, or a higher rate", least_ticks / rate));
    if (mover.clock >= mover.period)
        context_.reporter.error("motion-time-too-late", motion.time_at,
                                fmt::format("time must be less than every, but is {:.6g} of {:.6g}",
                                            mover.clock, mover.period),
                                "write the time since the round began");
}

void MotionAssembly::place(std::uint32_t number, const Word& name) {
    const Mover& mover = ir_.motions[number].mover;
    for (std::uint32_t i = 0; i < ir_.capsules.size(); ++i) {
        CapsuleIr& edge = ir_.capsules[i];
        if (names_.edges[static_cast<std::size_t>(edge.binding)].name != name.text) continue;
        if (!is_free(edge, name, context_.reporter,
                     {.of_part = "motion-of-part",
                      .of_one_way = "motion-of-one-way",
                      .twice = "motion-twice",
                      .verb = "move",
                      .instead_of_part = "move edges, arcs, pegs and boxes",
                      .once = "name each edge in one motion"}))
            return;
        edge.is_moved = true;
        moved_.push_back({number, i, edge.shape});
        if (mover.clock < mover.period)
            edge.shape = mover_shape(mover, {{}, edge.shape}, mover.clock);
    }
}

void MotionAssembly::fill_in(Scene& scene) const {
    for (const MotionIr& motion : ir_.motions) {
        scene.world.edit_movers().push_back(motion.mover);
        scene.mover_names.emplace_back(motion.names.front().text);
    }
    for (const Moved& moved : moved_)
        scene.world.edit_movers()[moved.motion].edges.push_back(
            {scene.world.capsules().id[moved.edge], moved.home});
}

void SeesawAssembly::check_names() {
    for (const SeesawIr& seesaw : ir_.seesaws)
        check_name(seesaw.name);
}

void SeesawAssembly::check_name(const Word& name) {
    std::vector<std::string_view> known;
    for (const CapsuleIr& edge : ir_.capsules) {
        const std::string& called = names_.edges[static_cast<std::size_t>(edge.binding)].name;
        if (called == name.text) return;
        if (!called.empty() && (known.empty() || known.back() != called)) known.push_back(called);
    }
    if (std::ranges::count(ir_.error_names, name.text) > 0) return;
    context_.reporter.error(
        "seesaw-of-nothing", name.span(), fmt::format("there is no edge '{}'", name.text),
        did_you_mean(name.text, known, "give an edge this name: edge name=... X,Y X,Y"));
}

void SeesawAssembly::place_edges() {
    if (!ir_.seesaws.empty()) check_terms();
    amend_tilts();
    for (SeesawIr& seesaw : ir_.seesaws) {
        check_angles(seesaw);
        place(seesaw);
    }
}

// What no solver turns seesaws under.
void SeesawAssembly::check_terms() {
    const Span at = ir_.seesaws.front().name.span();
    if (ir_.settings.wrap)
        context_.reporter.error("seesaw-on-torus", at, "on a torus nothing turns on a hinge",
                                "leave use wrap out");
    if (ir_.settings.cloth)
        context_.reporter.error("seesaw-on-cloth", at, "on cloth nothing turns on a hinge",
                                "leave use cloth out, or move the edge: motion swing ...");
    if (ir_.settings.modulus)
        context_.reporter.error("seesaw-with-modulus", at,
                                "where impacts last nothing turns on a hinge",
                                "leave use modulus out");
    const auto& solver = options_.solver ? options_.solver : ir_.settings.solver;
    if (solver && !supports(solver->kind, Model{.hinged = true}))
        context_.reporter.error("solver-without-seesaws", at,
                                fmt::format("solver {} does not know seesaws", name(solver->kind)),
                                "take another solver, or leave the line solver out");
}

// `move NAME tilt= turning=` says how a seesaw stands, and how fast it turns.
void SeesawAssembly::amend_tilts() {
    for (const AmendmentIr& amendment : ir_.amendments) {
        if (!amendment.is_of_seesaw()) continue;
        const Span at = amendment.name ? amendment.name->span() : amendment.span;
        const auto found = std::ranges::find_if(ir_.seesaws, [&](const SeesawIr& seesaw) {
            return amendment.name && seesaw.name.text == amendment.name->text;
        });
        if (found == ir_.seesaws.end()) {
            context_.reporter.error("amends-nothing", at, "there is no such seesaw",
                                    "write the name of its edge");
            continue;
        }
        if (amendment.tilt) {
            found->seesaw.angle = *amendment.tilt * pi / 180.0;
            found->tilt_at = at;
        }
        if (amendment.turning) found->seesaw.rate = *amendment.turning;
    }
}

void SeesawAssembly::check_angles(const SeesawIr& made) {
    const Seesaw& seesaw = made.seesaw;
    const auto degrees = [](double radians) { return radians * 180.0 / pi; };
    if (!(seesaw.least < seesaw.most))
        context_.reporter.error("seesaw-without-way", made.stops_at,
                                fmt::format("it must be free to turn, but its stops are {:.6g} and "
                                            "{:.6g}",
                                            degrees(seesaw.least), degrees(seesaw.most)),
                                "write such as: from=-20deg to=20deg");
    else if (seesaw.angle < seesaw.least || seesaw.angle > seesaw.most)
        context_.reporter.error(
            "seesaw-beyond-stop", made.tilt_at,
            fmt::format("it stands at {:.6g} degrees, beyond its stops at {:.6g} and {:.6g}",
                        degrees(seesaw.angle), degrees(seesaw.least), degrees(seesaw.most)),
            "write tilt= between from= and to=");
}

bool SeesawAssembly::can_turn(const CapsuleIr& edge, std::size_t pieces, const Word& name) {
    if (edge.device < 0 && pieces > 1) {
        context_.reporter.error(
            "seesaw-of-pieces", name.span(),
            fmt::format("a seesaw is one straight edge, but '{}' has {} pieces", name.text, pieces),
            "name an edge with two ends");
        return false;
    }
    return is_free(edge, name, context_.reporter,
                   {.of_part = "seesaw-of-part",
                    .of_one_way = "seesaw-of-one-way",
                    .twice = "seesaw-twice",
                    .verb = "turn",
                    .instead_of_part = "name an edge",
                    .once = "name each edge in one motion or seesaw"});
}

void SeesawAssembly::place(SeesawIr& made) {
    const auto is_of_name = [&](const CapsuleIr& edge) {
        return names_.edges[static_cast<std::size_t>(edge.binding)].name == made.name.text;
    };
    const auto found = std::ranges::find_if(ir_.capsules, is_of_name);
    if (found == ir_.capsules.end()) return;
    const auto pieces = static_cast<std::size_t>(std::ranges::count_if(ir_.capsules, is_of_name));
    if (!can_turn(*found, pieces, made.name)) return;
    Seesaw seesaw = made.seesaw;
    seesaw.home = found->shape;
    seesaw.inertia = made.mass * bar_inertia(seesaw.home, seesaw.pivot);
    if (!(seesaw.inertia > 0.0)) {
        context_.reporter.error("seesaw-without-arm", made.name.span(),
                                fmt::format("'{}' is a point at its hinge", made.name.text),
                                "name an edge with two ends");
        return;
    }
    found->is_moved = true;
    found->shape = seesaw_shape(seesaw, seesaw.angle);
    placed_.push_back({static_cast<std::uint32_t>(found - ir_.capsules.begin()), seesaw});
}

void SeesawAssembly::fill_in(World& world) const {
    for (const Placed& placed : placed_) {
        Seesaw seesaw = placed.seesaw;
        seesaw.capsule = world.capsules().id[placed.edge];
        add_seesaw(world, seesaw);
    }
}

}  // namespace carom
