#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "physics/broad_phase/fat_pairs.h"
#include "physics/contact/solver.h"
#include "physics/event/engine.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

namespace carom {

/// Where the solver `event` meets a heap that is too dense for events, the heap goes over to
/// `contact`, and its balls come back one by one. The rule depends on the world alone, and not on
/// the order of the balls in it:
///
/// *Crowded* is a ball that has had more than `EventEngine::crowding` impacts in quick succession,
/// the last of them with another ball, where gravity acts and impacts lose energy. It is in
/// World::heaped from the end of that tick on.
///
/// *The heap* of a tick: those of World::heaped, all that could meet one of them within the tick,
/// all that could meet those, and so on: what touches the heap, and who comes near. A ball is taken
/// to get as far as its speed and a fall from rest take it, its *reach*. What is in a hand belongs
/// to the heap if it could meet a ball of the heap; then so do all other balls that it could meet.
///
/// *The tick.* The heap goes by `contact`, in a world that holds only it and the edges; the others
/// go on by `event` on their exact paths, in a world without it. An impact can make a ball faster
/// than it was: one that has been further away than its reach, at an impact or at the end, gets
/// twice that way as its reach. If somebody else belongs to the heap then, the tick is done again;
/// after `most_attempts` all balls go by `contact`.
///
/// *Coming back.* After the tick a ball of the heap stays in World::heaped while something presses
/// it on another ball, and while it overlaps a ball or an edge by more than `sunk` of its radius.
/// All others begin a new exact path; those of them that touch the heap still belong to it in the
/// next tick.
///
/// The heap is under contact's promise: nothing passes through anything, an elastic bounce keeps
/// its energy, what is pressed overlaps a little (the less, the more substeps), and the tick rate
/// shows. What belongs to the ends of a tick (births, sinks, flippers) is not of this: it happens
/// once, to the whole world.
class Handover {
  public:
    /// The heap of the next tick, as far as one knows before its impacts. Ascending.
    const std::vector<BallId>& heap_of(const World& world);

    /// Of `contact`, in a tick: so many that a ball of the heap's smallest radius falls by less
    /// than `still_fall` of it in one, from rest.
    static constexpr int least_substeps = 4;
    static constexpr int most_substeps = 16;
    static constexpr double still_fall = 1.0 / 2048.0;
    static constexpr int most_attempts = 4;
    static constexpr double sunk = 1e-5;

    /// A tick of a world in which World::heaped has somebody. As EventEngine::tick; where it is
    /// given up, the world is as it was before.
    EventOutcome tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                      std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                      const std::function<bool()>& keep_going);

  private:
    /// Some of the balls of a world, as a world.
    struct Part {
        World world;
        std::vector<std::uint32_t> ball;  ///< by index there: index in the whole
        std::vector<Contact> contacts;
        std::vector<std::uint8_t> touched;
    };

    void find_reach(const World& world);
    void find_heap(const World& world);
    void join_what_hands_meet(const World& world);
    std::uint32_t root_of(std::uint32_t node);
    void unite(std::uint32_t a, std::uint32_t b);
    void take_part(const World& world, bool of_heap, Part& part) const;
    bool note_ways(const World& world, const Part& part);
    bool widen(const World& world, const Contact& contact, const Part& part);
    bool widen_to(const World& world, std::uint32_t ball, Vec2 place);
    void put_back(World& world, const Part& part, std::vector<std::uint8_t>& touched) const;
    void merge_contacts(std::vector<Contact>& contacts);
    static int substeps_for(const World& heap);
    void find_who_stays(const World& heap, std::vector<BallId>& heaped);

    NearPairs near_;
    std::vector<std::uint32_t> order_;   // of the balls in near_
    std::vector<double> reach_;          // by ball: how far it may get in the tick
    std::vector<std::uint32_t> parent_;  // a forest: balls, then what is held of the capsules
    std::vector<std::uint8_t> is_heap_;  // by ball, then by World::held_capsules
    std::vector<std::uint8_t> was_heap_;
    std::vector<std::uint8_t> stays_;
    std::vector<double> margin_;
    std::vector<BallId> ids_;  // heap_of's answer
    Part free_;
    Part heap_;
};

}  // namespace carom
