#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vector.h"
#include "physics/world/contact.h"
#include "physics/world/ids.h"
#include "physics/world/solver_memory.h"
#include "physics/world/world.h"

/// What the solver `contact` leaves in the world for its next tick.
namespace carom {

/// A contact that presses at the end of a tick, with its impulses of the last substep: the next
/// tick starts its constraint from them (warm starting).
struct PersistentContact {
    BallId ball{};            ///< of two balls the lower
    std::uint32_t other = 0;  ///< number of the other ball, or of the edge
    ContactKind kind = ContactKind::ball_ball;
    std::int8_t across = 0;  ///< periodic image of the edge on a torus
    std::int8_t along = 0;
    double impulse = 0.0;             ///< along the normal, mass * length/s
    double tangential_impulse = 0.0;  ///< mass * length/s

    friend bool operator==(const PersistentContact&, const PersistentContact&) = default;
};

/// Verlet reference positions: where the balls were when their pairs were found. While each ball
/// stays within its skin of there, the solver keeps the same pairs in the same order. They belong
/// to the state, since the result depends on the order of pairs. They are valid only for a world of
/// just these balls.
struct ReferencePositions {
    std::vector<BallId> ball;
    std::vector<Vec2> position;        ///< by index: of the ball's centre
    std::vector<double> skin;          ///< by index, length
    std::vector<std::uint32_t> order;  ///< indices, in the order in which the solver keeps balls

    void clear() {
        order.clear();
        ball.clear();
        position.clear();
        skin.clear();
    }
    friend bool operator==(const ReferencePositions&, const ReferencePositions&) = default;
};

class ContactMemory : public MemoryOf<ContactMemory> {
  public:
    /// Ascending by ball.
    std::vector<PersistentContact> contacts;
    /// Empty if nothing could press in the last tick.
    ReferencePositions reference;
    /// What the springs of the constraints hold; below 0: what they owe (energy.h).
    double stored_energy = 0.0;

    void add_to(Hash& hash, const Model& model, int version) const override;
    std::size_t bytes() const override;

  protected:
    void add_contacts_to(Hash& hash, int version) const;
};

/// What `contact` has left in the world; an empty one if it left nothing.
const ContactMemory& contact_memory(const World& world);
/// To be changed from outside of a tick.
ContactMemory& edit_contact_memory(World& world);

}  // namespace carom
